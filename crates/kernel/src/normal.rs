//! The normal form: every statement becomes finitely many conjunctions of polynomial conditions.
//!
//! An expression is split into *pieces* that cover all points and do not overlap; on each it is
//! undefined or a fraction. Denominators are cleared, never cancelled, so definedness is decided by
//! the pieces and not by what survives a simplification.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use crate::derivative::{Kind, Locals};
use crate::{
    Bound, Checked, Context, Expr, Fraction, Fuel, Poly, Rejection, Rel, Relation, Sentence, sign,
};

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

    /// Whether it is an inequality, ≥ or >.
    #[must_use]
    pub fn is_order(self) -> bool {
        matches!(self, Self::NonNegative | Self::Positive)
    }
}

/// One polynomial condition.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
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
        Some(self.sign.admits(sign(&c)))
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

/// A region and what an expression or a condition is there; `None` where it is undefined.
#[derive(Clone, Debug)]
pub struct Piece<T = Fraction> {
    /// the region
    pub atoms: Atoms,
    /// the value
    pub value: Option<T>,
}

/// What has one value at all points.
pub(crate) fn everywhere<T>(value: Option<T>) -> Vec<Piece<T>> {
    vec![Piece { atoms: Vec::new(), value }]
}

/// One value where an atom holds, another where it does not.
pub(crate) fn either<T>(atom: Atom, holds: Option<T>, fails: Option<T>) -> Vec<Piece<T>> {
    let not = vec![atom.not()];
    vec![Piece { atoms: vec![atom], value: holds }, Piece { atoms: not, value: fails }]
}

/// The regions where a condition is as wanted: true, false or undefined.
pub(crate) fn regions(truth: Vec<Piece<bool>>, wanted: impl Fn(Option<bool>) -> bool) -> Cases {
    truth.into_iter().filter(|p| wanted(p.value)).map(|p| p.atoms).collect()
}

/// A definition near a point: its index, what is varied, and what is asked.
type Near = (usize, Vec<usize>, Kind);

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
    pub mentioned: BTreeSet<usize>,
    roots: Vec<&'c Expr>,
    lets: RefCell<BTreeMap<usize, Vec<Piece>>>,
    /// the definitions near a point, by what is varied and what is asked
    pub(crate) near_lets: RefCell<BTreeMap<Near, Locals>>,
}

impl<'c> Scope<'c> {
    /// A scope for judging `subjects`: their square roots become variables.
    ///
    /// # Errors
    /// [`Rejection::Budget`] if the definitions behind them do not fit in the budget.
    pub fn new(context: &'c Context, subjects: &[&'c Expr], fuel: Fuel) -> Checked<Self> {
        for (v, var) in context.vars.iter().enumerate() {
            let ends = var.lower.as_ref().zip(var.upper.as_ref());
            let open = |(a, b): (&Bound, &Bound)| a.value == b.value && (a.strict || b.strict);
            if ends.is_some_and(|(a, b)| a.value > b.value || open((a, b))) {
                return Err(Rejection::EmptyRange(v));
            }
        }
        let (mut roots, mut mentioned, mut needed) = (Vec::new(), BTreeSet::new(), BTreeSet::new());
        let mut todo: Vec<&Expr> = subjects.iter().rev().copied().collect();
        while let Some(e) = todo.pop() {
            fuel.spend(1)?;
            match e {
                Expr::Let(i) if needed.insert(*i) => {
                    todo.push(&context.lets.get(*i).ok_or(Rejection::UnknownSymbol)?.body);
                }
                Expr::Var(v) | Expr::Deriv(_, v) => match context.value(*v) {
                    Some(value) => todo.push(value),
                    None => _ = mentioned.insert(*v),
                },
                Expr::Sqrt(_) if !roots.contains(&e) => roots.push(e),
                _ => {}
            }
            todo.extend(e.children());
        }
        let (lets, near_lets) = (RefCell::default(), RefCell::default());
        let scope = Self { context, fuel, mentioned, roots, lets, near_lets };
        // In order of definition, so that no definition recurses into another's body.
        for i in needed {
            let pieces = scope.pieces(&context.lets[i].body)?;
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
        let bound = |b: &Bound, sense: i64| {
            let ends = [-b.value.numer(), b.value.denom().clone()];
            let sign = if b.strict { Sign::Positive } else { Sign::NonNegative };
            Atom::new(Poly::in_variable(var, &ends).scale(&sense.into()), sign)
        };
        let Some(v) = self.context.vars.get(var) else {
            return Vec::new();
        };
        let lower = v.lower.as_ref().map(|b| bound(b, 1));
        lower.into_iter().chain(v.upper.as_ref().map(|b| bound(b, -1))).collect()
    }

    /// The pieces of an expression.
    ///
    /// # Errors
    /// [`Rejection`]: budget, unknown symbols, a derivative that cannot be taken.
    pub fn pieces(&self, e: &Expr) -> Checked<Vec<Piece>> {
        let fuel = &self.fuel;
        let total = |value: Fraction| Ok(everywhere(Some(value)));
        match e {
            Expr::Num(q) => total(Fraction::rational(q)),
            Expr::Var(v) => match self.context.value(*v) {
                Some(value) => self.pieces(value),
                None if *v < self.context.vars.len() => total(Fraction::whole(Poly::var(*v))),
                None => Err(Rejection::UnknownSymbol),
            },
            Expr::Let(i) => self.lets.borrow().get(i).cloned().ok_or(Rejection::UnknownSymbol),
            Expr::Neg(a) => self.each(&self.pieces(a)?, |x| total(x.neg())),
            Expr::Add(a, b) => self.both(a, b, |x, y| total(x.add(y, fuel)?)),
            Expr::Sub(a, b) => self.both(a, b, |x, y| total(x.add(&y.neg(), fuel)?)),
            Expr::Mul(a, b) => self.both(a, b, |x, y| total(x.mul(y, fuel)?)),
            Expr::Div(a, b) => self.both(a, b, |x, y| {
                let by = Atom::new(y.num.clone(), Sign::NonZero);
                Ok(either(by, Some(x.over(y, fuel)?), None))
            }),
            Expr::Pow(a, n) if *n < 0 => {
                let power = Expr::Pow(a.clone(), n.checked_neg().ok_or(Rejection::Budget)?);
                self.pieces(&Expr::Div(Expr::int(1).into(), power.into()))
            }
            Expr::Pow(a, n) => {
                self.each(&self.pieces(a)?, |x| total(x.pow(n.unsigned_abs(), fuel)?))
            }
            // The cases of `Expr::as_cases`, with each operand normalised once.
            Expr::Abs(a) => self.each(&self.pieces(a)?, |x| {
                let atom = Atom::new(x.sign_poly(fuel)?, Sign::NonNegative);
                Ok(either(atom, Some(x.clone()), Some(x.neg())))
            }),
            Expr::Min(a, b) | Expr::Max(a, b) => self.both(a, b, |x, y| {
                let (low, high) = if matches!(e, Expr::Min(..)) { (x, y) } else { (y, x) };
                let gap = high.add(&low.neg(), fuel)?.sign_poly(fuel)?;
                let atom = Atom::new(gap, Sign::NonNegative);
                Ok(either(atom, Some(x.clone()), Some(y.clone())))
            }),
            Expr::Sqrt(a) => {
                let s = self.root_variable(e)?;
                self.each(&self.pieces(a)?, |x| self.root_pieces(s, x, Sign::NonNegative))
            }
            Expr::Deriv(f, x) => self.slopes(f, *x),
            Expr::Cases(branches, otherwise) => {
                let last = otherwise.as_ref().map(|body| self.pieces(body)).transpose()?;
                let mut rest = last.unwrap_or_else(|| everywhere(None));
                for (guards, body) in branches.iter().rev() {
                    let body = self.pieces(body)?;
                    rest = self.each(&self.all(guards)?, |taken| {
                        Ok(if *taken { body.clone() } else { rest.clone() })
                    })?;
                }
                Ok(rest)
            }
        }
    }

    /// The variable that stands for a root.
    pub(crate) fn root_variable(&self, root: &Expr) -> Checked<usize> {
        let position = self.roots.iter().position(|r| *r == root);
        Ok(self.context.vars.len() + position.ok_or(Rejection::UnknownSymbol)?)
    }

    /// The root s of a fraction, where that has the sign; elsewhere undefined.
    pub(crate) fn root_pieces(&self, s: usize, x: &Fraction, sign: Sign) -> Checked<Vec<Piece>> {
        let real = Atom::new(x.sign_poly(&self.fuel)?, sign);
        let square = Poly::power(s, 2).mul(&x.den, &self.fuel)?.sub(&x.num);
        let mut pieces = either(real, Some(Fraction::whole(Poly::var(s))), None);
        pieces[0].atoms.push(Atom::new(Poly::var(s), Sign::NonNegative));
        pieces[0].atoms.push(Atom::new(square, Sign::Zero));
        Ok(pieces)
    }

    /// Goes on where there is a value; regions that are visibly empty are left out.
    ///
    /// # Errors
    /// [`Rejection::Budget`], and what `next` cannot do.
    pub(crate) fn each<T, U>(
        &self,
        pieces: &[Piece<T>],
        next: impl Fn(&T) -> Checked<Vec<Piece<U>>>,
    ) -> Checked<Vec<Piece<U>>> {
        let mut out = Vec::new();
        for p in pieces {
            for q in p.value.as_ref().map_or_else(|| Ok(everywhere(None)), &next)? {
                let atoms = joined(&p.atoms, &q.atoms, &self.fuel)?;
                out.extend(atoms.map(|atoms| Piece { atoms, value: q.value }));
                if out.len() > MAX_PIECES {
                    return Err(Rejection::Budget);
                }
            }
        }
        Ok(out)
    }

    fn both<U>(
        &self,
        a: &Expr,
        b: &Expr,
        next: impl Fn(&Fraction, &Fraction) -> Checked<Vec<Piece<U>>>,
    ) -> Checked<Vec<Piece<U>>> {
        let right = self.pieces(b)?;
        self.each(&self.pieces(a)?, |x| self.each(&right, |y| next(x, y)))
    }

    /// Where a relation is true, false, undefined.
    ///
    /// # Errors
    /// As [`Scope::pieces`].
    pub fn relation(&self, r: &Relation) -> Checked<Vec<Piece<bool>>> {
        let (left, right) = r.greater_first();
        self.both(left, right, |x, y| {
            let gap = x.add(&y.neg(), &self.fuel)?;
            Ok(either(self.condition(r.rel, &gap)?, Some(true), Some(false)))
        })
    }

    /// When a relation holds, from the greater side less the other.
    pub(crate) fn condition(&self, rel: Rel, gap: &Fraction) -> Checked<Atom> {
        Ok(match rel {
            Rel::Eq => Atom::new(gap.num.clone(), Sign::Zero),
            Rel::Ne => Atom::new(gap.num.clone(), Sign::NonZero),
            Rel::Lt | Rel::Gt => Atom::new(gap.sign_poly(&self.fuel)?, Sign::Positive),
            Rel::Le | Rel::Ge => Atom::new(gap.sign_poly(&self.fuel)?, Sign::NonNegative),
        })
    }

    /// Where relations, read left to right, are all true; else where the first that is not true is
    /// false, or undefined.
    ///
    /// # Errors
    /// As [`Scope::pieces`].
    pub fn all<'r>(
        &self,
        relations: impl IntoIterator<Item = &'r Relation>,
    ) -> Checked<Vec<Piece<bool>>> {
        let mut truth = everywhere(Some(true));
        for r in relations {
            let next = self.relation(r)?;
            truth = self.each(&truth, |so_far| {
                Ok(if *so_far { next.clone() } else { everywhere(Some(false)) })
            })?;
        }
        Ok(truth)
    }

    /// A condition on which nothing is said where `when` is not true.
    ///
    /// # Errors
    /// As [`Scope::pieces`].
    pub(crate) fn under(
        &self,
        when: &[Relation],
        truth: &[Piece<bool>],
    ) -> Checked<Vec<Piece<bool>>> {
        let mut applies = self.all(when)?;
        applies.iter_mut().for_each(|p| p.value = Some(p.value == Some(true)));
        self.each(&applies, |applies| {
            Ok(if *applies { truth.to_vec() } else { everywhere(Some(true)) })
        })
    }

    /// Where a premise holds pointwise: off its `when`, or where its relations are true; a cited
    /// claim also where they are undefined. With `holds` false, the opposite. Limits say nothing
    /// about a single point.
    ///
    /// # Errors
    /// As [`Scope::pieces`].
    pub fn premise(&self, s: &Sentence, given: bool, holds: bool) -> Checked<Cases> {
        let truth = self.under(&s.when, &self.all(s.relations())?)?;
        Ok(regions(truth, |value| value.unwrap_or(!given) == holds))
    }
}

/// The conjunction without what is trivially true; `None` if an atom is trivially false.
fn joined(a: &[Atom], b: &[Atom], fuel: &Fuel) -> Checked<Option<Atoms>> {
    // Every new atom is compared with those before it.
    let steps = (1 + a.len() + b.len()).saturating_mul(1 + b.len());
    fuel.spend(u64::try_from(steps).unwrap_or(u64::MAX))?;
    let mut out = a.to_vec();
    for atom in b {
        match atom.decided() {
            Some(true) => {}
            Some(false) => return Ok(None),
            None if out.contains(&atom.not()) => return Ok(None),
            None if out.contains(atom) => {}
            None => out.push(atom.clone()),
        }
    }
    Ok(Some(out))
}
