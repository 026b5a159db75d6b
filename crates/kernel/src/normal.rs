//! The normal form: every statement becomes finitely many conjunctions of polynomial conditions.
//!
//! An expression is split into *pieces* that cover all points and do not overlap; on each it is
//! undefined or a fraction. Denominators are cleared, never cancelled, so definedness is decided by
//! the pieces and not by what survives a simplification.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use crate::{Bound, Context, Expr, Fraction, Fuel, Link, Poly, Rejection, Rel, Relation, Sentence};

/// What is known of the sign of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Sign {
    /// = 0
    Zero,
    /// ≠ 0
    NonZero,
    /// ≥ 0
    NonNegative,
    /// > 0
    Positive,
}

impl Sign {
    /// Whether a value of this sign (−1, 0, 1) satisfies it.
    #[must_use]
    pub fn admits(self, sign: i8) -> bool {
        match self {
            Self::Zero => sign == 0,
            Self::NonZero => sign != 0,
            Self::NonNegative => sign >= 0,
            Self::Positive => sign > 0,
        }
    }
}

/// One polynomial condition.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Atom {
    /// the polynomial, in the variables of a [`Scope`]
    pub poly: Poly,
    /// its sign
    pub sign: Sign,
}

impl Atom {
    /// poly ⋈ 0
    #[must_use]
    pub fn new(poly: Poly, sign: Sign) -> Self {
        Self { poly, sign }
    }

    /// `Some(true)` or `Some(false)` if the polynomial is a constant.
    #[must_use]
    pub fn decided(&self) -> Option<bool> {
        let c = self.poly.as_constant()?;
        Some(self.sign.admits(crate::sign(&c)))
    }

    /// The opposite condition, again one atom.
    #[must_use]
    pub fn not(&self) -> Self {
        let (poly, sign) = match self.sign {
            Sign::Zero => (self.poly.clone(), Sign::NonZero),
            Sign::NonZero => (self.poly.clone(), Sign::Zero),
            Sign::NonNegative => (self.poly.neg(), Sign::Positive),
            Sign::Positive => (self.poly.neg(), Sign::NonNegative),
        };
        Self { poly, sign }
    }
}

/// A conjunction of atoms.
pub type Atoms = Vec<Atom>;

/// A disjunction of conjunctions.
pub type Cases = Vec<Atoms>;

/// A region and the value of an expression there; `None` where it is undefined.
#[derive(Clone, Debug)]
pub struct Piece {
    /// the region
    pub atoms: Atoms,
    /// the value
    pub value: Option<Fraction>,
}

type Pieces = Rc<Vec<Piece>>;

/// The regions where something is true, false and undefined; together they cover all points.
#[derive(Clone, Debug, Default)]
pub struct Truth {
    /// true there
    pub holds: Cases,
    /// defined and false there
    pub fails: Cases,
    /// undefined there
    pub undefined: Cases,
}

impl Truth {
    /// Where it is not true.
    #[must_use]
    pub fn not(&self) -> Cases {
        self.fails.iter().chain(&self.undefined).cloned().collect()
    }
}

/// Most pieces that one expression may have.
const MAX_PIECES: usize = 4096;

/// The variables of a goal and the normal forms of its definitions. Symbols keep their index;
/// after them come the roots, then what limits need (see [`Scope::germ`]).
#[derive(Debug)]
pub struct Scope<'c> {
    /// symbols and definitions
    pub context: &'c Context,
    /// the budget
    pub fuel: Fuel,
    /// symbols that the subjects mention
    pub mentioned: std::collections::BTreeSet<usize>,
    roots: Vec<&'c Expr>,
    lets: RefCell<HashMap<usize, Pieces>>,
}

impl<'c> Scope<'c> {
    /// A scope for judging `subjects`: their square roots become variables.
    ///
    /// # Errors
    /// [`Rejection::Budget`] if the definitions behind them do not fit in the budget.
    pub fn new(context: &'c Context, subjects: &[&'c Expr], fuel: Fuel) -> Result<Self, Rejection> {
        let mut needed = std::collections::BTreeSet::new();
        for (v, var) in context.vars.iter().enumerate() {
            if let (Some(a), Some(b)) = (&var.lower, &var.upper) {
                if a.value > b.value || (a.value == b.value && (a.strict || b.strict)) {
                    return Err(Rejection::EmptyRange(v));
                }
            }
        }
        let (mut roots, mut mentioned) = (Vec::new(), std::collections::BTreeSet::new());
        let mut todo: Vec<&Expr> = subjects.iter().rev().copied().collect();
        while let Some(e) = todo.pop() {
            fuel.spend(1)?;
            match e {
                Expr::Let(i) if needed.insert(*i) => {
                    let definition = context.lets.get(*i).ok_or(Rejection::UnknownSymbol)?;
                    todo.push(&definition.body);
                }
                Expr::Var(v) | Expr::Deriv(_, v) => {
                    mentioned.insert(*v);
                }
                Expr::Sqrt(_) if !roots.contains(&e) => roots.push(e),
                _ => {}
            }
            todo.extend(e.children());
        }
        let scope = Self { context, fuel, mentioned, roots, lets: RefCell::default() };
        // In order of definition, so that no definition recurses into another's body.
        for i in needed {
            let pieces = Rc::new(scope.pieces(&context.lets[i].body)?);
            scope.lets.borrow_mut().insert(i, pieces);
        }
        Ok(scope)
    }

    /// Index of the variable for 0 < t → 0 of a germ; the variables after it stand for the limits
    /// of the premises, in order.
    #[must_use]
    pub fn germ(&self) -> usize {
        self.context.vars.len() + self.roots.len()
    }

    /// The square root behind a variable, if it is one.
    #[must_use]
    pub fn root(&self, var: usize) -> Option<&'c Expr> {
        self.roots.get(var.checked_sub(self.context.vars.len())?).copied()
    }

    /// The ranges of all mentioned symbols.
    #[must_use]
    pub fn ranges(&self) -> Atoms {
        self.mentioned.iter().flat_map(|&v| self.range(v)).collect()
    }

    /// The declared range of a symbol as atoms.
    #[must_use]
    pub fn range(&self, var: usize) -> Atoms {
        let bound = |b: &Bound, upper: bool| {
            let at = Fraction::rational(&b.value);
            let scaled = Poly::var(var).scale(b.value.denom());
            let gap = if upper { at.num.sub(&scaled) } else { scaled.sub(&at.num) };
            let sign = if b.strict { Sign::Positive } else { Sign::NonNegative };
            Atom::new(gap, sign)
        };
        let Some(v) = self.context.vars.get(var) else {
            return Vec::new();
        };
        let lower = v.lower.as_ref().map(|b| bound(b, false));
        lower.into_iter().chain(v.upper.as_ref().map(|b| bound(b, true))).collect()
    }

    /// The pieces of an expression.
    ///
    /// # Errors
    /// [`Rejection`]: budget, unknown symbols, a derivative that cannot be taken.
    pub fn pieces(&self, e: &Expr) -> Result<Vec<Piece>, Rejection> {
        let one = |value| vec![Piece { atoms: Vec::new(), value }];
        Ok(match e {
            Expr::Num(q) => one(Some(Fraction::rational(q))),
            Expr::Var(v) if *v < self.context.vars.len() => {
                one(Some(Fraction::whole(Poly::var(*v))))
            }
            Expr::Var(_) => return Err(Rejection::UnknownSymbol),
            Expr::Let(i) => {
                let known = self.lets.borrow().get(i).cloned();
                known.ok_or(Rejection::UnknownSymbol)?.to_vec()
            }
            Expr::Neg(a) => self.map(a, |x| Ok(vec![(Vec::new(), Some(x.neg()))]))?,
            Expr::Add(a, b) => self.map2(a, b, |x, y| self.total(x.add(y, &self.fuel)))?,
            Expr::Sub(a, b) => self.map2(a, b, |x, y| self.total(x.add(&y.neg(), &self.fuel)))?,
            Expr::Mul(a, b) => self.map2(a, b, |x, y| self.total(x.mul(y, &self.fuel)))?,
            Expr::Div(a, b) => self.map2(a, b, |x, y| self.divide(x, y))?,
            Expr::Pow(a, n) => self.map(a, |x| {
                let power = Fraction {
                    num: x.num.pow(n.unsigned_abs(), &self.fuel)?,
                    den: x.den.pow(n.unsigned_abs(), &self.fuel)?,
                };
                if *n < 0 {
                    self.divide(&Fraction::whole(Poly::one()), &power)
                } else {
                    self.total(Ok(power))
                }
            })?,
            Expr::Abs(a) => self.map(a, |x| {
                let s = x.sign_poly(&self.fuel)?;
                let up = Atom::new(s, Sign::NonNegative);
                Ok(vec![(vec![up.not()], Some(x.neg())), (vec![up], Some(x.clone()))])
            })?,
            Expr::Min(a, b) => self.map2(a, b, |x, y| self.choose(x, y))?,
            Expr::Max(a, b) => {
                self.map2(a, b, |x, y| self.choose(&y.neg(), &x.neg()).map(negate))?
            }
            Expr::Sqrt(a) => {
                let position = self.roots.iter().position(|r| *r == e);
                let s = self.context.vars.len() + position.ok_or(Rejection::UnknownSymbol)?;
                self.map(a, |x| {
                    let real = Atom::new(x.sign_poly(&self.fuel)?, Sign::NonNegative);
                    let square = Poly::var(s).mul(&Poly::var(s), &self.fuel)?;
                    let defining = square.mul(&x.den, &self.fuel)?.sub(&x.num);
                    let root = vec![
                        real.clone(),
                        Atom::new(Poly::var(s), Sign::NonNegative),
                        Atom::new(defining, Sign::Zero),
                    ];
                    let value = Fraction::whole(Poly::var(s));
                    Ok(vec![(vec![real.not()], None), (root, Some(value))])
                })?
            }
            Expr::Deriv(f, x) => {
                let slope = crate::derivative(self.context, f, *x, &self.fuel)?;
                self.map(f, |_| {
                    let pieces = self.pieces(&slope)?;
                    Ok(pieces.into_iter().map(|p| (p.atoms, p.value)).collect())
                })?
            }
            Expr::Cases(branches, otherwise) => {
                let mut out = Vec::new();
                let mut open: Cases = vec![Vec::new()];
                for (guards, body) in branches {
                    let truth = self.all(guards)?;
                    let body = self.pieces(body)?;
                    for region in self.meet(&open, &truth.holds)? {
                        out.extend(body.iter().map(|p| p.within(&region)));
                    }
                    for atoms in self.meet(&open, &truth.undefined)? {
                        out.push(Piece { atoms, value: None });
                    }
                    open = self.meet(&open, &truth.fails)?;
                    self.check_size(out.len() + open.len())?;
                }
                let last = match otherwise {
                    Some(body) => self.pieces(body)?,
                    None => one(None),
                };
                for region in &open {
                    out.extend(last.iter().map(|p| p.within(region)));
                }
                self.check_size(out.len())?;
                out
            }
        })
    }

    fn map(
        &self,
        a: &Expr,
        f: impl Fn(&Fraction) -> Result<Vec<(Atoms, Option<Fraction>)>, Rejection>,
    ) -> Result<Vec<Piece>, Rejection> {
        let mut out = Vec::new();
        for p in self.pieces(a)? {
            match &p.value {
                None => out.push(p),
                Some(x) => out.extend(f(x)?.into_iter().filter_map(|(atoms, value)| {
                    Some(Piece { atoms: joined(&p.atoms, &atoms)?, value })
                })),
            }
        }
        self.check_size(out.len())?;
        Ok(out)
    }

    fn map2(
        &self,
        a: &Expr,
        b: &Expr,
        f: impl Fn(&Fraction, &Fraction) -> Result<Vec<(Atoms, Option<Fraction>)>, Rejection>,
    ) -> Result<Vec<Piece>, Rejection> {
        let right = self.pieces(b)?;
        self.map(a, |x| {
            let mut out = Vec::new();
            for p in &right {
                match &p.value {
                    None => out.push((p.atoms.clone(), None)),
                    Some(y) => out.extend(
                        f(x, y)?
                            .into_iter()
                            .filter_map(|(atoms, value)| Some((joined(&p.atoms, &atoms)?, value))),
                    ),
                }
            }
            self.check_size(out.len())?;
            Ok(out)
        })
    }

    fn total(
        &self,
        value: Result<Fraction, Rejection>,
    ) -> Result<Vec<(Atoms, Option<Fraction>)>, Rejection> {
        Ok(vec![(Vec::new(), Some(value?))])
    }

    fn divide(
        &self,
        x: &Fraction,
        y: &Fraction,
    ) -> Result<Vec<(Atoms, Option<Fraction>)>, Rejection> {
        let zero = Atom::new(y.num.clone(), Sign::Zero);
        let quotient =
            Fraction { num: x.num.mul(&y.den, &self.fuel)?, den: x.den.mul(&y.num, &self.fuel)? };
        Ok(match zero.decided() {
            Some(true) => vec![(Vec::new(), None)],
            Some(false) => vec![(Vec::new(), Some(quotient))],
            None => vec![(vec![zero.not()], Some(quotient)), (vec![zero], None)],
        })
    }

    fn choose(
        &self,
        x: &Fraction,
        y: &Fraction,
    ) -> Result<Vec<(Atoms, Option<Fraction>)>, Rejection> {
        let gap = y.add(&x.neg(), &self.fuel)?.sign_poly(&self.fuel)?;
        let first = Atom::new(gap, Sign::NonNegative);
        Ok(vec![(vec![first.not()], Some(y.clone())), (vec![first], Some(x.clone()))])
    }

    /// Where a relation is true, false, undefined.
    ///
    /// # Errors
    /// As [`Scope::pieces`].
    pub fn relation(&self, r: &Relation) -> Result<Truth, Rejection> {
        let mut truth = Truth::default();
        let swap = matches!(r.rel, Rel::Lt | Rel::Le);
        let (a, b) = if swap { (&r.rhs, &r.lhs) } else { (&r.lhs, &r.rhs) };
        let gap = self.map2(a, b, |x, y| self.total(x.add(&y.neg(), &self.fuel)))?;
        for p in gap {
            let Some(value) = p.value else {
                truth.undefined.push(p.atoms);
                continue;
            };
            let atom = match r.rel {
                Rel::Eq => Atom::new(value.num, Sign::Zero),
                Rel::Ne => Atom::new(value.num, Sign::NonZero),
                Rel::Lt | Rel::Gt => Atom::new(value.sign_poly(&self.fuel)?, Sign::Positive),
                Rel::Le | Rel::Ge => Atom::new(value.sign_poly(&self.fuel)?, Sign::NonNegative),
            };
            truth.fails.extend(joined(&p.atoms, &[atom.not()]));
            truth.holds.extend(joined(&p.atoms, &[atom]));
        }
        Ok(truth)
    }

    /// Where relations, read left to right, are all true; else where the first that is not true is
    /// false, or undefined.
    ///
    /// # Errors
    /// As [`Scope::pieces`].
    pub fn all<'r>(
        &self,
        relations: impl IntoIterator<Item = &'r Relation>,
    ) -> Result<Truth, Rejection> {
        let mut truth = Truth { holds: vec![Vec::new()], ..Truth::default() };
        for r in relations {
            let next = self.relation(r)?;
            truth.fails.extend(self.meet(&truth.holds, &next.fails)?);
            truth.undefined.extend(self.meet(&truth.holds, &next.undefined)?);
            truth.holds = self.meet(&truth.holds, &next.holds)?;
            self.check_size(truth.fails.len() + truth.undefined.len())?;
        }
        Ok(truth)
    }

    /// Where a sentence as a premise holds pointwise: off its `when`, or where its relations are
    /// true; a cited claim (`given` false) also where they are undefined. Its limits say nothing
    /// about a single point.
    ///
    /// # Errors
    /// As [`Scope::pieces`].
    pub fn premise(&self, s: &Sentence, given: bool) -> Result<Cases, Rejection> {
        let when = self.all(&s.when)?;
        let body = self.all(relations(s))?;
        let mut cases = when.not();
        cases.extend(self.meet(&when.holds, &body.holds)?);
        if !given {
            cases.extend(self.meet(&when.holds, &body.undefined)?);
        }
        Ok(cases)
    }

    /// Where a premise does not hold.
    ///
    /// # Errors
    /// As [`Scope::pieces`].
    pub fn premise_fails(&self, s: &Sentence, given: bool) -> Result<Cases, Rejection> {
        let when = self.all(&s.when)?;
        let body = self.all(relations(s))?;
        let mut cases = self.meet(&when.holds, &body.fails)?;
        if given {
            cases.extend(self.meet(&when.holds, &body.undefined)?);
        }
        Ok(cases)
    }

    /// All pairs of regions, less those that are visibly empty.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn meet(&self, a: &Cases, b: &Cases) -> Result<Cases, Rejection> {
        self.check_size(a.len().saturating_mul(b.len()))?;
        Ok(a.iter().flat_map(|x| b.iter().filter_map(|y| joined(x, y))).collect())
    }

    fn check_size(&self, n: usize) -> Result<(), Rejection> {
        self.fuel.spend(u64::try_from(n).unwrap_or(u64::MAX))?;
        if n > MAX_PIECES {
            return Err(Rejection::Budget);
        }
        Ok(())
    }
}

impl Piece {
    fn within(&self, region: &[Atom]) -> Self {
        Self { atoms: [region, &self.atoms].concat(), value: self.value.clone() }
    }
}

fn negate(pieces: Vec<(Atoms, Option<Fraction>)>) -> Vec<(Atoms, Option<Fraction>)> {
    let neg = |(atoms, value): (Atoms, Option<Fraction>)| (atoms, value.map(|v| v.neg()));
    pieces.into_iter().map(neg).collect()
}

/// The conjunction without what is trivially true; `None` if an atom is trivially false.
fn joined(a: &[Atom], b: &[Atom]) -> Option<Atoms> {
    let mut out = a.to_vec();
    for atom in b {
        match atom.decided() {
            Some(true) => {}
            Some(false) => return None,
            None if out.contains(&atom.not()) => return None,
            None if out.contains(atom) => {}
            None => out.push(atom.clone()),
        }
    }
    Some(out)
}

/// The links of a sentence that are relations.
pub(crate) fn relations(s: &Sentence) -> impl Iterator<Item = &Relation> {
    s.links.iter().filter_map(|l| match l {
        Link::Relation(r) => Some(r),
        Link::Limit(_) => None,
    })
}

impl Expr {
    /// Its direct parts, guards included.
    #[must_use]
    pub fn children(&self) -> Vec<&Self> {
        match self {
            Self::Num(_) | Self::Var(_) | Self::Let(_) => Vec::new(),
            Self::Neg(a) | Self::Pow(a, _) | Self::Abs(a) | Self::Sqrt(a) | Self::Deriv(a, _) => {
                vec![a]
            }
            Self::Add(a, b)
            | Self::Sub(a, b)
            | Self::Mul(a, b)
            | Self::Div(a, b)
            | Self::Min(a, b)
            | Self::Max(a, b) => vec![a, b],
            Self::Cases(branches, otherwise) => branches
                .iter()
                .flat_map(|(guards, body)| {
                    let sides = guards.iter().flat_map(|g| [&g.lhs, &g.rhs]);
                    sides.chain(std::iter::once(body))
                })
                .chain(otherwise.as_deref())
                .collect(),
        }
    }

    /// A number as an expression.
    #[must_use]
    pub fn int(n: i64) -> Self {
        Self::Num(num_rational::BigRational::from_integer(n.into()))
    }
}
