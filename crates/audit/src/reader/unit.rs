//! Units: the dimensions of symbols, and what they say of statements.
//!
//! A dimension is a product of powers of base units. What has no unit declared is of no known
//! dimension, and nothing is said of what it stands in; the number 0 is of every dimension.

use std::collections::{BTreeMap, HashMap};
use std::fmt;
use std::ops::Range;

use kane_algebra::syntax::{Notation as _, Parser, Scope, SyntaxError, Token};
use kane_kernel::{Expr, Link, Relation, Target};
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, Zero as _};

use super::citation::{Draft, DraftBody, DraftContent};
use super::{Fault, Reader};

/// Units by name, in powers of base units. Only such as need no factor.
const UNITS: [(&str, &[(&str, i64)]); 17] = [
    ("kg", &[("kg", 1)]),
    ("m", &[("m", 1)]),
    ("s", &[("s", 1)]),
    ("A", &[("A", 1)]),
    ("K", &[("K", 1)]),
    ("mol", &[("mol", 1)]),
    ("cd", &[("cd", 1)]),
    ("rad", &[]),
    ("sr", &[]),
    ("Hz", &[("s", -1)]),
    ("N", &[("kg", 1), ("m", 1), ("s", -2)]),
    ("Pa", &[("kg", 1), ("m", -1), ("s", -2)]),
    ("J", &[("kg", 1), ("m", 2), ("s", -2)]),
    ("W", &[("kg", 1), ("m", 2), ("s", -3)]),
    ("C", &[("A", 1), ("s", 1)]),
    ("V", &[("kg", 1), ("m", 2), ("s", -3), ("A", -1)]),
    ("T", &[("kg", 1), ("s", -2), ("A", -1)]),
];

/// The greatest exponent in a unit.
const MAX_POWER: i64 = 100;

/// A product of powers of base units; empty for a number.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Dimension(BTreeMap<&'static str, BigRational>);

impl Dimension {
    fn times(&self, other: &Self, power: &BigRational) -> Self {
        let mut powers = self.0.clone();
        for (unit, n) in &other.0 {
            *powers.entry(unit).or_insert_with(BigRational::zero) += n * power;
        }
        powers.retain(|_, n| !n.is_zero());
        Self(powers)
    }

    fn to(&self, power: &BigRational) -> Self {
        Self::default().times(self, power)
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let power = |(unit, n): (&&str, &BigRational)| match n {
            n if n.is_one() => (*unit).to_owned(),
            n if n.is_integer() => format!("{unit}^{n}"),
            n => format!("{unit}^({n})"),
        };
        let (above, below): (Vec<_>, Vec<_>) = self.0.iter().partition(|(_, n)| n.is_positive());
        let above: Vec<String> = above.into_iter().map(power).collect();
        let over: Vec<_> = below.iter().map(|(unit, n)| (*unit, -(*n).clone())).collect();
        let below: Vec<String> = over.iter().map(|(unit, n)| power((unit, n))).collect();
        let above = if above.is_empty() { "1".to_owned() } else { above.join("*") };
        match below.as_slice() {
            [] => write!(f, "[{above}]"),
            [one] => write!(f, "[{above}/{one}]"),
            _ => write!(f, "[{above}/({})]", below.join("*")),
        }
    }
}

/// Passes `[kg*m/s^2]`.
pub(super) fn unit(p: &mut Parser<'_>) -> Result<Dimension, SyntaxError> {
    const WHAT: &str = "a unit such as `kg`, `m`, `s`, `N`, `J`, `rad` or `1`, without prefixes";
    p.expect(Token::OpenBracket, "`[` before a unit")?;
    let mut whole = Dimension::default();
    let mut sign = 1;
    loop {
        let known = UNITS.iter().find(|(name, _)| *name == p.lexeme());
        let base = match (p.token(), known) {
            (Token::Name, Some((_, powers))) => {
                let powers = powers.iter().map(|&(unit, n)| (unit, rational(n)));
                Dimension(powers.collect())
            }
            (Token::Number, _) if p.lexeme() == "1" => Dimension::default(),
            _ => return Err(p.unexpected(WHAT)),
        };
        p.advance();
        let power = exponent(p)?;
        whole = whole.times(&base, &rational(sign * power));
        sign = match p.token() {
            Token::Star => 1,
            Token::Slash => -1,
            _ => break,
        };
        p.advance();
    }
    p.expect(Token::CloseBracket, "`]` after the unit; `kg/m/s` is kg/(m·s)")?;
    Ok(whole)
}

/// Passes `^2`, `^-1` or `²`; 1 if nothing of the kind is ahead.
fn exponent(p: &mut Parser<'_>) -> Result<i64, SyntaxError> {
    let raised = p.token() == Token::Superscript;
    if !raised && !p.accept(Token::Caret) {
        return Ok(1);
    }
    let negative = !raised && p.accept(Token::Minus);
    let plain: String = p.lexeme().chars().map(plain_digit).collect();
    match plain.parse::<i64>() {
        Ok(n) if n.abs() <= MAX_POWER && (raised || p.token() == Token::Number) => {
            p.advance();
            Ok(if negative { -n } else { n })
        }
        _ => Err(p.unexpected("an integer up to 100")),
    }
}

/// A raised digit as a plain one.
fn plain_digit(c: char) -> char {
    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    let place = RAISED.chars().position(|raised| raised == c);
    let digit = place.and_then(|n| char::from_digit(u32::try_from(n).unwrap_or(0), 10));
    digit.unwrap_or(if c == '⁻' { '-' } else { c })
}

fn rational(n: i64) -> BigRational {
    BigRational::from_integer(n.into())
}

/// What is known of an expression: its dimension, or nothing.
type Known = Option<Dimension>;

/// Two sides that ought to be of one dimension.
struct Mismatch {
    left: (Expr, Dimension),
    right: (Expr, Dimension),
}

/// The dimensions of a document.
struct Units<'a> {
    scope: &'a Scope,
    symbols: HashMap<usize, Dimension>,
    /// of the definitions
    lets: Vec<Known>,
}

impl Reader {
    /// Notes all statements whose dimensions do not go together; nothing where no unit is declared.
    pub(super) fn check_units(&mut self) {
        if self.units.is_empty() {
            return;
        }
        let mut symbols = self.units.clone();
        for (theta, angle) in self.scope.angles() {
            for symbol in [theta, angle.cos, angle.sin] {
                symbols.entry(symbol).or_default();
            }
        }
        for known in self.scope.exponentials() {
            symbols.entry(known.symbol).or_default();
        }
        for (x, shift) in self.scope.shifts() {
            if let Some(unit) = symbols.get(&x).cloned() {
                symbols.insert(shift, unit);
            }
        }
        // a derivative is declared behind what it is the derivative of
        for (function, rate) in self.scope.rates() {
            let of = self.scope.context().vars.get(*function).and_then(|var| var.of);
            let by = of.and_then(|x| symbols.get(&x));
            if let (Some(f), Some(x)) = (symbols.get(function), by) {
                let slope = f.times(x, &rational(-1));
                symbols.insert(*rate, slope);
            }
        }
        let mut units = Units { scope: &self.scope, symbols, lets: Vec::new() };
        let mut found: HashMap<usize, Mismatch> = HashMap::new();
        for (index, definition) in self.scope.context().lets.iter().enumerate() {
            let known = units.of(&definition.body);
            units.lets.push(known.unwrap_or_else(|mismatch| {
                found.insert(index, *mismatch);
                None
            }));
        }
        let mut faults = Vec::new();
        for draft in &self.drafts {
            let defined = match &draft.body {
                DraftBody::Let(index) => std::slice::from_ref(index),
                DraftBody::Defined(parts) => parts.as_slice(),
                _ => &[],
            };
            let of_lets = defined.iter().filter_map(|index| found.remove(index));
            faults.extend(of_lets.map(|m| units.fault(m, draft.parts.content.clone())));
            faults.extend(units.statement(draft));
        }
        self.faults.extend(faults);
    }
}

impl Units<'_> {
    /// All faults of a `given` or a `claim`.
    fn statement(&self, draft: &Draft) -> Vec<Fault> {
        let whole = || draft.parts.content.clone();
        let (links, when): (Vec<(&Link, Range<usize>)>, &[Relation]) = match &draft.body {
            DraftBody::Given(s) => (s.links.iter().map(|link| (link, whole())).collect(), &s.when),
            DraftBody::Claim(claim) => match &claim.content {
                DraftContent::Links(links) => {
                    (links.iter().map(|(link, span)| (link, span.clone())).collect(), &claim.when)
                }
                DraftContent::Contradiction | DraftContent::NotImplied(_) => {
                    (Vec::new(), &claim.when)
                }
            },
            DraftBody::Let(_) | DraftBody::Defined(_) | DraftBody::Broken => return Vec::new(),
        };
        let of_links = links.into_iter().filter_map(|(link, span)| {
            let known = match link {
                Link::Relation(relation) => self.relation(relation),
                Link::Limit(limit) => match &limit.to {
                    Target::Finite(value) => self.same(&limit.expr, value).map(|_| ()),
                    Target::PlusInf | Target::MinusInf => self.of(&limit.expr).map(|_| ()),
                },
            };
            known.err().map(|mismatch| self.fault(*mismatch, span))
        });
        let conditions = draft.parts.when.clone().unwrap_or_else(whole);
        let of_when = when.iter().filter_map(|relation| self.relation(relation).err());
        let of_when = of_when.map(|mismatch| self.fault(*mismatch, conditions.clone()));
        let mut faults: Vec<Fault> = of_links.chain(of_when).collect();
        // components of a vector mostly fail alike
        faults.dedup_by(|a, b| a.span == b.span);
        faults
    }

    fn fault(&self, mismatch: Mismatch, span: Range<usize>) -> Fault {
        let context = self.scope.context();
        let ((left, a), (right, b)) = (mismatch.left, mismatch.right);
        let message = format!(
            "dimensions differ: `{}` is in {a}, `{}` in {b}",
            shortened(&left.plain(context)),
            shortened(&right.plain(context))
        );
        let note = "sums, comparisons and the branches of `cases` are of one dimension, an exponent or a \
                    number is in [1]";
        Fault::new(span, message).with_note(note)
    }

    fn relation(&self, relation: &Relation) -> Result<(), Box<Mismatch>> {
        self.same(&relation.lhs, &relation.rhs).map(|_| ())
    }

    /// The dimension that two expressions have in common.
    fn same(&self, a: &Expr, b: &Expr) -> Result<Known, Box<Mismatch>> {
        let (left, right) = (self.of(a)?, self.of(b)?);
        match (left, right) {
            (Some(left), Some(right)) if left != right => {
                let (left, right) = ((a.clone(), left), (b.clone(), right));
                Err(Box::new(Mismatch { left, right }))
            }
            (left, right) => Ok(left.or(right)),
        }
    }

    /// The dimension of an expression; nothing if it is not known, or if any will do.
    fn of(&self, e: &Expr) -> Result<Known, Box<Mismatch>> {
        let product = |a: &Expr, b: &Expr, power: i64| {
            let (a, b) = (self.of(a)?, self.of(b)?);
            Ok(a.zip(b).map(|(a, b)| a.times(&b, &rational(power))))
        };
        match e {
            Expr::Num(q) => Ok((!q.is_zero()).then(Dimension::default)),
            Expr::Var(v) => Ok(self.symbols.get(v).cloned()),
            Expr::Let(index) => Ok(self.lets.get(*index).cloned().flatten()),
            Expr::Neg(a) | Expr::Abs(a) => self.of(a),
            Expr::Add(a, b) | Expr::Sub(a, b) | Expr::Min(a, b) | Expr::Max(a, b) => {
                self.same(a, b)
            }
            Expr::Mul(a, b) => product(a, b, 1),
            Expr::Div(a, b) => product(a, b, -1),
            Expr::Pow(a, n) => Ok(self.of(a)?.map(|a| a.to(&rational((*n).into())))),
            Expr::Sqrt(a) => Ok(self.of(a)?.map(|a| a.to(&BigRational::new(1.into(), 2.into())))),
            Expr::Deriv(f, x) => product(f, &Expr::Var(*x), -1),
            Expr::Cases(branches, otherwise) => {
                for relation in branches.iter().flat_map(|(guards, _)| guards) {
                    self.relation(relation)?;
                }
                let bodies = branches.iter().map(|(_, body)| body).chain(otherwise.as_deref());
                let mut known: Option<(&Expr, Dimension)> = None;
                for body in bodies {
                    let (Some(next), known) = (self.of(body)?, &mut known) else { continue };
                    match known {
                        Some((_, first)) if *first == next => {}
                        Some((one, first)) => {
                            let left = ((*one).clone(), first.clone());
                            let right = (body.clone(), next);
                            return Err(Box::new(Mismatch { left, right }));
                        }
                        None => *known = Some((body, next)),
                    }
                }
                Ok(known.map(|(_, dimension)| dimension))
            }
        }
    }
}

/// The start of a text, so that no message grows with the document.
fn shortened(text: &str) -> String {
    const LONGEST: usize = 60;
    match text.char_indices().nth(LONGEST) {
        Some((cut, _)) => format!("{}…", text.get(..cut).unwrap_or_default()),
        None => text.to_owned(),
    }
}
