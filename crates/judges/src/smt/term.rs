//! Terms of SMT-LIB: what an expression is on each of its pieces, written from the expression as it
//! stands. A quotient stays a pair, and is multiplied out only where it is compared.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt::Write as _;

use kane_kernel::{Context, Expr, Rel, Relation, Sentence};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// Most pieces that something may have before the question is not asked.
const MAX_PIECES: usize = 4096;

/// Why there is no question.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NotPut {
    /// it is about limits
    #[error("it speaks of limits")]
    Limits,
    /// there are too many pieces
    #[error("it has too many cases")]
    TooLarge,
    /// a derivative of something that is not explicit
    #[error("a derivative of something without a formula")]
    Derivative,
    /// a symbol that the document does not have
    #[error("a symbol without a declaration")]
    Symbol,
}

/// numerator and denominator
type Quotient = (String, String);

/// A region, as conditions that hold together, and what something is there; `None`: undefined.
#[derive(Clone, Debug)]
pub(super) struct Piece<T> {
    pub(super) region: Vec<String>,
    pub(super) value: Option<T>,
}

/// The pieces of something: together they are everywhere.
pub(super) type Pieces<T> = Vec<Piece<T>>;

/// A derivative: an expression, and the condition under which it is one.
pub(super) struct Slopes {
    pub(super) value: Expr,
    pub(super) exists: String,
}

/// Writes expressions over the symbols of a document.
pub(super) struct Terms<'c> {
    pub(super) context: &'c Context,
    /// the square roots that were met, each a number of its own
    pub(super) roots: RefCell<Vec<Expr>>,
    /// the definitions that were met
    lets: RefCell<BTreeMap<usize, Pieces<Quotient>>>,
    /// names for longer parts, as declarations
    pub(super) named: RefCell<Vec<String>>,
}

fn everywhere<T>(value: Option<T>) -> Pieces<T> {
    vec![Piece { region: Vec::new(), value }]
}

fn either<T>(condition: String, yes: Option<T>, no: Option<T>) -> Pieces<T> {
    let not = format!("(not {condition})");
    vec![Piece { region: vec![condition], value: yes }, Piece { region: vec![not], value: no }]
}

fn each<T, U>(
    pieces: &[Piece<T>],
    next: impl Fn(&T) -> Result<Pieces<U>, NotPut>,
) -> Result<Pieces<U>, NotPut> {
    let mut out = Vec::new();
    for p in pieces {
        for q in p.value.as_ref().map_or_else(|| Ok(everywhere(None)), &next)? {
            let mut region = p.region.clone();
            region.extend(q.region.into_iter().filter(|c| !p.region.contains(c)));
            if !region.iter().any(|c| region.contains(&format!("(not {c})"))) {
                out.push(Piece { region, value: q.value });
            }
            if out.len() > MAX_PIECES {
                return Err(NotPut::TooLarge);
            }
        }
    }
    Ok(out)
}

pub(super) fn times(a: &str, b: &str) -> String {
    match (a, b) {
        ("0", _) | (_, "0") => "0".to_owned(),
        ("1", other) | (other, "1") => other.to_owned(),
        _ => format!("(* {a} {b})"),
    }
}

fn plus(a: &str, b: &str) -> String {
    match (a, b) {
        ("0", other) | (other, "0") => other.to_owned(),
        _ => format!("(+ {a} {b})"),
    }
}

fn minus(a: &str) -> String {
    if a == "0" { a.to_owned() } else { format!("(- {a})") }
}

fn power(a: &str, n: u32) -> String {
    match (a, n) {
        ("1", _) | (_, 0) => "1".to_owned(),
        (_, 1) => a.to_owned(),
        _ => format!("(* {})", vec![a; n as usize].join(" ")),
    }
}

/// A quotient's sign as that of a product.
fn sign((n, d): &Quotient) -> String {
    times(n, d)
}

fn sum(x: &Quotient, y: &Quotient) -> Quotient {
    if x.1 == y.1 {
        return (plus(&x.0, &y.0), x.1.clone());
    }
    (plus(&times(&x.0, &y.1), &times(&y.0, &x.1)), times(&x.1, &y.1))
}

fn opposite(x: &Quotient) -> Quotient {
    (minus(&x.0), x.1.clone())
}

/// An integer.
pub(super) fn integer(c: &BigInt) -> String {
    if c.is_negative() { format!("(- {})", c.magnitude()) } else { c.to_string() }
}

/// A rational number.
pub(super) fn rational(q: &BigRational) -> String {
    match q.denom().is_one() {
        true => integer(q.numer()),
        false => format!("(/ {} {})", integer(q.numer()), q.denom()),
    }
}

/// Conditions that hold together.
pub(super) fn all(conditions: &[String]) -> String {
    match conditions {
        [] => "true".to_owned(),
        [one] => one.clone(),
        many => format!("(and {})", many.join(" ")),
    }
}

/// Where something is as wanted.
pub(super) fn any<T>(pieces: &[Piece<T>], wanted: impl Fn(&Option<T>) -> bool) -> String {
    let regions: Vec<String> =
        pieces.iter().filter(|p| wanted(&p.value)).map(|p| all(&p.region)).collect();
    match regions.as_slice() {
        [] => "false".to_owned(),
        [one] => one.clone(),
        many => format!("(or {})", many.join(" ")),
    }
}

impl<'c> Terms<'c> {
    pub(super) fn new(context: &'c Context) -> Self {
        Self {
            context,
            roots: RefCell::default(),
            lets: RefCell::default(),
            named: RefCell::default(),
        }
    }

    pub(super) fn symbol(&self, v: usize) -> String {
        format!("|{}|", self.context.vars[v].name)
    }

    /// A name for a longer term, so that it is written once.
    fn short(&self, term: String) -> String {
        if term.len() < 40 {
            return term;
        }
        let mut named = self.named.borrow_mut();
        let name = format!("|part {}|", named.len() + 1);
        named.push(format!("(define-fun {name} () Real {term})\n"));
        name
    }

    /// What an expression is, and where it is undefined.
    pub(super) fn pieces(&self, e: &Expr) -> Result<Pieces<Quotient>, NotPut> {
        let total = |value: Quotient| Ok(everywhere(Some(value)));
        match e {
            Expr::Num(q) => total((rational(q), "1".to_owned())),
            Expr::Var(v) => {
                self.context.vars.get(*v).ok_or(NotPut::Symbol)?;
                total((self.symbol(*v), "1".to_owned()))
            }
            Expr::Let(i) => {
                if let Some(known) = self.lets.borrow().get(i) {
                    return Ok(known.clone());
                }
                let body = &self.context.lets.get(*i).ok_or(NotPut::Symbol)?.body;
                let mut pieces = self.pieces(body)?;
                for (n, d) in pieces.iter_mut().filter_map(|p| p.value.as_mut()) {
                    *n = self.short(std::mem::take(n));
                    *d = self.short(std::mem::take(d));
                }
                self.lets.borrow_mut().insert(*i, pieces.clone());
                Ok(pieces)
            }
            Expr::Neg(a) => each(&self.pieces(a)?, |x| total(opposite(x))),
            Expr::Add(a, b) => self.both(a, b, |x, y| total(sum(x, y))),
            Expr::Sub(a, b) => self.both(a, b, |x, y| total(sum(x, &opposite(y)))),
            Expr::Mul(a, b) => {
                self.both(a, b, |x, y| total((times(&x.0, &y.0), times(&x.1, &y.1))))
            }
            Expr::Div(a, b) => self.both(a, b, |x, y| {
                if let (Expr::Num(q), "1") = (&**b, y.1.as_str())
                    && !q.is_zero()
                {
                    return total((times(&x.0, &rational(&q.recip())), x.1.clone()));
                }
                let zero = format!("(= {} 0)", y.0);
                Ok(either(zero, None, Some((times(&x.0, &y.1), times(&x.1, &y.0)))))
            }),
            Expr::Pow(a, n) if *n < 0 => {
                let below = Expr::Pow(a.clone(), n.checked_neg().ok_or(NotPut::TooLarge)?);
                self.pieces(&Expr::Div(Expr::int(1).into(), below.into()))
            }
            Expr::Pow(a, n) => each(&self.pieces(a)?, |x| {
                total((power(&x.0, n.unsigned_abs()), power(&x.1, n.unsigned_abs())))
            }),
            Expr::Abs(_) | Expr::Min(..) | Expr::Max(..) => self.pieces(&e.as_cases()),
            Expr::Sqrt(a) => {
                let s = self.root(e)?;
                each(&self.pieces(a)?, |x| {
                    let real = format!("(>= {} 0)", sign(x));
                    let mut pieces = either(real, Some((s.clone(), "1".to_owned())), None);
                    pieces[0].region.push(format!("(>= {s} 0)"));
                    let square = times(&times(&s, &s), &x.1);
                    pieces[0].region.push(format!("(= {square} {})", x.0));
                    Ok(pieces)
                })
            }
            Expr::Deriv(f, x) => {
                let Slopes { value, exists } = self.slopes(f, *x)?;
                each(&either(exists, Some(()), None), |()| self.pieces(&value))
            }
            Expr::Cases(branches, otherwise) => {
                let mut rest = match otherwise {
                    Some(e) => self.pieces(e)?,
                    None => everywhere(None),
                };
                for (guards, body) in branches.iter().rev() {
                    let body = self.pieces(body)?;
                    rest = each(&self.relations(guards)?, |taken| {
                        Ok(if *taken { body.clone() } else { rest.clone() })
                    })?;
                }
                Ok(rest)
            }
        }
    }

    fn both<U>(
        &self,
        a: &Expr,
        b: &Expr,
        next: impl Fn(&Quotient, &Quotient) -> Result<Pieces<U>, NotPut>,
    ) -> Result<Pieces<U>, NotPut> {
        let right = self.pieces(b)?;
        each(&self.pieces(a)?, |x| each(&right, |y| next(x, y)))
    }

    /// The number that stands for a root; roots of the same expression are the same.
    fn root(&self, e: &Expr) -> Result<String, NotPut> {
        let e = self.written_out(e, 0)?;
        let mut roots = self.roots.borrow_mut();
        let known = roots.iter().position(|r| *r == e);
        let i = known.unwrap_or_else(|| {
            roots.push(e);
            roots.len() - 1
        });
        Ok(root_name(i))
    }

    /// Where a relation is true, false, undefined.
    pub(super) fn relation(&self, r: &Relation) -> Result<Pieces<bool>, NotPut> {
        self.both(&r.lhs, &r.rhs, |x, y| {
            let operator = match r.rel {
                Rel::Eq | Rel::Ne => "=",
                Rel::Lt => "<",
                Rel::Le => "<=",
                Rel::Gt => ">",
                Rel::Ge => ">=",
            };
            let condition = if x.1 == "1" && y.1 == "1" {
                format!("({operator} {} {})", x.0, y.0)
            } else {
                let gap = sum(x, &opposite(y));
                let left = if operator == "=" { gap.0 } else { sign(&gap) };
                format!("({operator} {left} 0)")
            };
            let holds = r.rel != Rel::Ne;
            Ok(either(condition, Some(holds), Some(!holds)))
        })
    }

    /// Relations, from left to right: the first that is not true decides.
    pub(super) fn relations<'r>(
        &self,
        rs: impl IntoIterator<Item = &'r Relation>,
    ) -> Result<Pieces<bool>, NotPut> {
        let mut truth = everywhere(Some(true));
        for r in rs {
            let next = self.relation(r)?;
            truth = each(&truth, |so_far| {
                Ok(if *so_far { next.clone() } else { everywhere(Some(false)) })
            })?;
        }
        Ok(truth)
    }

    /// What a sentence says at a point: nothing where its conditions are not true.
    pub(super) fn sentence(&self, s: &Sentence) -> Result<Pieces<bool>, NotPut> {
        let mut applies = self.relations(&s.when)?;
        applies.iter_mut().for_each(|p| p.value = Some(p.value == Some(true)));
        let truth = self.relations(s.relations())?;
        each(&applies, |applies| Ok(if *applies { truth.clone() } else { everywhere(Some(true)) }))
    }

    /// The declared range of a symbol.
    pub(super) fn range(&self, v: usize) -> String {
        let mut text = String::new();
        let var = &self.context.vars[v];
        for (bound, operator) in [(&var.lower, ">"), (&var.upper, "<")] {
            if let Some(bound) = bound {
                let weak = if bound.strict { "" } else { "=" };
                let (symbol, end) = (self.symbol(v), rational(&bound.value));
                let _ = writeln!(text, "(assert ({operator}{weak} {symbol} {end}))");
            }
        }
        text
    }
}

/// The name of a root.
pub(super) fn root_name(i: usize) -> String {
    format!("|root {}|", i + 1)
}
