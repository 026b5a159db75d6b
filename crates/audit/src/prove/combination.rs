//! Weights by which summands that are not negative, and multiples of equations, cancel (Farkas 1902).

use std::collections::{BTreeMap, BTreeSet};

use kane_algebra::linear_program::{Entering, feasible, whole};
use kane_kernel::{Poly, Power, Sign, State, Term};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::elimination::Factors;
use crate::argument::{Argument, Rules};

type Q = BigRational;

/// One part in so many of what is left of the budget is for one linear program.
const SHARE: u64 = 8;

/// A term that is not negative, as a polynomial, and whether it is positive.
pub(super) type Summand = (Term, Poly, bool);

/// square² · Π atoms: positive where the square is a number and none of the atoms can vanish; `None` if it does
/// not fit the budget.
pub(super) fn summand(state: &State<'_, '_>, square: Poly, factors: Factors) -> Option<Summand> {
    let fuel = &state.scope.fuel;
    let mut poly = square.pow(2, fuel).ok()?;
    for (i, n) in &factors {
        poly = poly.mul(&state.atoms[*i].poly.pow(*n, fuel).ok()?, fuel).ok()?;
    }
    let sure =
        |(i, _): &(usize, u32)| matches!(state.atoms[*i].sign, Sign::Positive | Sign::NonZero);
    let strict = square.is_constant() && factors.iter().all(sure);
    Some((Term { weight: BigInt::one(), square, factors }, poly, strict))
}

/// An equation, what it is multiplied by, and the product. Each stands with its opposite.
pub(super) type Multiple = (usize, Poly, Poly);

/// How large a linear program may be, and how long it may take.
pub(super) struct Size {
    /// monomials
    pub(super) rows: usize,
    /// summands and multiples
    pub(super) columns: usize,
    /// steps of the simplex method
    pub(super) pivots: usize,
}

/// The monomials of summands and multiples, each with a number.
fn monomials<'a>(
    summands: &'a [Summand],
    multiples: &'a [Multiple],
) -> BTreeMap<&'a [Power], usize> {
    let mut rows: BTreeMap<&[Power], usize> = BTreeMap::new();
    for p in summands.iter().map(|s| &s.1).chain(multiples.iter().map(|m| &m.2)) {
        for (m, _) in p.terms() {
            let next = rows.len();
            rows.entry(m).or_insert(next);
        }
    }
    rows
}

/// The summands without those that cannot take part: with a monomial that has one sign wherever it is left, so
/// that nothing cancels it. `None` if that takes more than the budget.
fn cancelling(
    state: &State<'_, '_>,
    mut summands: Vec<Summand>,
    multiples: &[Multiple],
) -> Option<Vec<Summand>> {
    let both: BTreeSet<Vec<Power>> =
        multiples.iter().flat_map(|m| m.2.terms()).map(|(m, _)| m.to_vec()).collect();
    loop {
        let terms: usize = summands.iter().map(|s| s.1.len()).sum();
        state.scope.fuel.spend(u64::try_from(terms).unwrap_or(u64::MAX)).ok()?;
        let signs = |positive: bool| -> BTreeSet<Vec<Power>> {
            let terms = summands.iter().flat_map(|s| s.1.terms());
            let chosen = terms.filter(|(_, c)| c.is_positive() == positive);
            chosen.map(|(m, _)| m.to_vec()).collect()
        };
        let (up, down) = (signs(true), signs(false));
        let meets = |m: &[Power]| both.contains(m) || up.contains(m) && down.contains(m);
        let before = summands.len();
        summands.retain(|s| s.1.terms().all(|(m, _)| meets(m)));
        if summands.len() == before {
            return Some(summands);
        }
    }
}

/// A sum of the summands and the multiples, with weights that are not negative, that is 0 identically
/// although a summand in it is positive; `None` if there is none, or the program is too large even without
/// the summands that cannot take part.
pub(super) fn combined(
    state: &State<'_, '_>,
    mut summands: Vec<Summand>,
    multiples: Vec<Multiple>,
    size: &Size,
) -> Option<Argument> {
    let fits = |height: usize, summands: &[Summand]| {
        height <= size.rows && summands.len() + multiples.len() <= size.columns
    };
    if !fits(monomials(&summands, &multiples).len(), &summands) {
        summands = cancelling(state, summands, &multiples)?;
    }
    let rows = monomials(&summands, &multiples);
    let height = rows.len();
    if !fits(height, &summands) {
        return None;
    }
    let entries = |p: &Poly| -> Vec<(usize, Q)> {
        p.terms().map(|(m, c)| (rows[m], Q::from_integer(c.clone()))).collect()
    };
    let column = |(_, p, strict): &Summand| {
        let last = strict.then(|| (height, Q::one()));
        entries(p).into_iter().chain(last).collect()
    };
    let mut matrix: Vec<Vec<(usize, Q)>> = summands.iter().map(column).collect();
    matrix.extend(multiples.iter().map(|m| entries(&m.2)));
    let mut b = vec![Q::zero(); height];
    b.push(Q::one());
    let fuel = state.scope.fuel.within(state.scope.fuel.left() / SHARE);
    let weights = whole(&feasible(&matrix, &b, Entering::Greatest, size.pivots, &fuel)?);
    let (of_summands, of_multiples) = weights.split_at(summands.len());
    let used = summands.into_iter().zip(of_summands).filter(|(_, w)| w.is_positive());
    let terms = used.map(|((term, ..), w)| Term { weight: w.clone(), ..term }).collect();
    let used = multiples.into_iter().zip(of_multiples).filter(|(_, w)| w.is_positive());
    let cofactors = used.map(|((i, by, _), w)| (i, by.scale(w))).collect();
    let proof = Argument::Positive { terms, cofactors };
    state.closes(&proof).is_ok().then_some(proof)
}
