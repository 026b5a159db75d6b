//! The sign of a rational function of one symbol, everywhere on a domain.

use std::cmp::{Ordering, Reverse};

use kane_kernel::{Bound, Fuel, Rejection, Rel, Root, Var};
use kane_number::Rational;
use num_bigint::{BigInt, BigUint};
use num_traits::Signed;
use thiserror::Error;

use crate::rational_function::RationalFunction;
use crate::ring;
use crate::sign_table::{Cell, SignTable, refine, simplest_between};

/// An interval of the line; a missing end is infinite.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Domain {
    /// lower end
    pub lower: Option<Bound>,
    /// upper end
    pub upper: Option<Bound>,
}

impl From<&Var> for Domain {
    fn from(symbol: &Var) -> Self {
        Self { lower: symbol.lower.clone(), upper: symbol.upper.clone() }
    }
}

impl Domain {
    /// Whether a rational lies in it.
    #[must_use]
    pub fn contains(&self, x: &Rational) -> bool {
        let above = |b: &Bound| if b.strict { *x > b.value } else { *x >= b.value };
        let below = |b: &Bound| if b.strict { *x < b.value } else { *x <= b.value };
        self.lower.as_ref().is_none_or(above) && self.upper.as_ref().is_none_or(below)
    }
}

/// A finite end of a piece.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edge {
    /// where, a rational or the only root of a polynomial in an interval
    pub at: Root,
    /// whether the end belongs to the piece
    pub included: bool,
}

/// A largest interval on which the sign is one and the same; a point if both edges are equal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// left end, −∞ if absent
    pub lower: Option<Edge>,
    /// right end, +∞ if absent
    pub upper: Option<Edge>,
    /// how the function compares with 0; `None` where it is undefined
    pub sign: Option<Ordering>,
}

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum NoSign {
    /// more than one symbol occurs
    #[error("more than one symbol")]
    SeveralSymbols,
    /// the budget is spent
    #[error(transparent)]
    Budget(#[from] Rejection),
}

/// The pieces of the domain from left to right: they cover it, and neighbours differ in sign.
///
/// Complete and exact: every zero, pole and cancelled point is found, irrational ones as roots of
/// their polynomials. An empty domain has no pieces.
///
/// # Errors
/// When f has more than one symbol, or the fuel runs out.
pub fn pieces(f: &RationalFunction, domain: &Domain, fuel: &Fuel) -> Result<Vec<Piece>, NoSign> {
    let x = match f.symbols()[..] {
        [] => 0,
        [x] => x,
        _ => return Err(NoSign::SeveralSymbols),
    };
    let coefficients = |p| ring::univariate(p, x).ok_or(NoSign::SeveralSymbols);
    let (num, den) = f.fraction();
    // inputs 0 and 1 make the sign, the rest cut: what must not vanish, and the ends
    let num = coefficients(&num)?;
    let vanishes = num.is_empty();
    let mut inputs = vec![if vanishes { vec![1.into()] } else { num }, coefficients(&den)?];
    for condition in &f.conditions() {
        inputs.push(coefficients(condition)?);
    }
    let conditions = 2..inputs.len();
    for end in [&domain.lower, &domain.upper].into_iter().flatten() {
        inputs.push(vec![-end.value.numer(), end.value.denom().clone()]);
    }
    let table = SignTable::new(&inputs, fuel)?;
    let sign = |cell| {
        if conditions.clone().any(|i| table.sign(i, cell) == 0) {
            None
        } else if vanishes {
            Some(Ordering::Equal)
        } else {
            Some((table.sign(0, cell) * table.sign(1, cell)).cmp(&0))
        }
    };
    let inside = |cell| match cell {
        Cell::Root(i) if !table.roots[i].is_exact() => {
            // ends of the domain are roots of their own, so an interval lies on one side of them
            domain.contains(&table.roots[i].lo) && domain.contains(&table.roots[i].hi)
        }
        Cell::Root(_) => domain.contains(&table.sample(cell)),
        Cell::Gap(_) => domain.contains(&table.sample(cell)),
    };
    let mut pieces: Vec<Piece> = Vec::new();
    for cell in table.cells().filter(|cell| inside(*cell)) {
        let edge = |i: usize, included| table.roots.get(i).cloned().map(|at| Edge { at, included });
        let (lower, upper) = match cell {
            Cell::Root(i) => (edge(i, true), edge(i, true)),
            Cell::Gap(i) => (i.checked_sub(1).and_then(|i| edge(i, false)), edge(i, false)),
        };
        let sign = sign(cell);
        match pieces.last_mut() {
            Some(last) if last.sign == sign => last.upper = upper,
            _ => pieces.push(Piece { lower, upper, sign }),
        }
    }
    Ok(pieces)
}

/// The simplest point of the domain at which f is defined and `f ⋈ 0` is false; `None` if there is
/// none. Complete and exact.
///
/// Simplest is the smallest denominator, then the smallest numerator, then the positive one. Only
/// if no rational point fails is the answer an irrational root.
///
/// # Errors
/// As [`pieces`].
pub fn witness(
    f: &RationalFunction,
    rel: Rel,
    domain: &Domain,
    fuel: &Fuel,
) -> Result<Option<Root>, NoSign> {
    let failing = pieces(f, domain, fuel)?;
    let failing = failing.iter().filter(|p| p.sign.is_some_and(|sign| !compares(rel, sign)));
    let mut irrational = None;
    let mut best: Option<Rational> = None;
    for piece in failing {
        match piece.simplest() {
            Some(q) if best.as_ref().is_none_or(|b| complexity(&q) < complexity(b)) => {
                best = Some(q);
            }
            Some(_) => {}
            None => {
                irrational = irrational.or_else(|| piece.lower.as_ref().map(|e| e.at.clone()));
            }
        }
    }
    Ok(best.map(exactly).or(irrational))
}

impl Piece {
    /// Its simplest rational, as [`witness`] counts; `None` if it is an irrational point.
    #[must_use]
    pub fn simplest(&self) -> Option<Rational> {
        let ends = [&self.lower, &self.upper].into_iter().flatten();
        let ends = ends.filter(|e| e.included && e.at.is_exact()).map(|e| e.at.lo.clone());
        let point = self.lower.is_some() && self.lower == self.upper;
        let inner = if point { None } else { Some(self.inner()) };
        ends.chain(inner).min_by_key(complexity)
    }

    /// The simplest rational strictly between the ends.
    fn inner(&self) -> Rational {
        let [mut lower, mut upper] =
            [&self.lower, &self.upper].map(|edge| edge.as_ref().map(|edge| edge.at.clone()));
        loop {
            // simplest between outer bounds: if it lies inside, it is simplest there too
            let outer_lo = lower.as_ref().map(|r| &r.lo);
            let outer_hi = upper.as_ref().map(|r| &r.hi);
            let q = simplest_between(outer_lo, outer_hi);
            let undecided = |r: &Root| !r.is_exact() && r.lo <= q && q <= r.hi;
            if let Some(root) = lower.as_mut().filter(|r| undecided(r)) {
                refine(root);
            } else if let Some(root) = upper.as_mut().filter(|r| undecided(r)) {
                refine(root);
            } else {
                return q;
            }
        }
    }
}

/// The rational q as a root.
fn exactly(q: Rational) -> Root {
    Root { poly: vec![-q.numer(), q.denom().clone()], lo: q.clone(), hi: q }
}

fn complexity(q: &Rational) -> (BigInt, BigUint, Reverse<bool>) {
    (q.denom().clone(), q.numer().magnitude().clone(), Reverse(q.is_positive()))
}

/// Whether `a ⋈ b` holds for numbers in this order.
#[must_use]
pub fn compares(rel: Rel, order: Ordering) -> bool {
    match rel {
        Rel::Eq => order.is_eq(),
        Rel::Ne => order.is_ne(),
        Rel::Lt => order.is_lt(),
        Rel::Le => order.is_le(),
        Rel::Gt => order.is_gt(),
        Rel::Ge => order.is_ge(),
    }
}
