//! Circuits: a monomial, and the fewest others of which it is a mean (Reznick, Forms derived from the
//! arithmetic-geometric inequality, 1989). Where all terms with one sign are means of those with the other, and no more
//! is taken of these than there is, a sum is shown to have one sign by an inequality of means for each circuit.

use std::collections::BTreeSet;

use kane_algebra::linear_program::{Entering, feasible};
use kane_kernel::Fuel;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

type Q = BigRational;

/// A term: its powers, and its coefficient.
pub(super) type Term = (Vec<u32>, BigInt);

/// The linear program that shares out the outer terms.
const ROWS: usize = 400;
const COLUMNS: usize = 1200;
const PIVOTS: usize = 400;
/// One part in so many of what is left of the budget is for it.
const SHARE: u64 = 8;

/// Circuits of all terms that are positive, among those that are negative; `None` where these do not suffice.
pub(super) fn circuits(terms: &[Term], fuel: &Fuel) -> Option<Vec<BTreeSet<Vec<u32>>>> {
    let (inner, outer): (Vec<&Term>, Vec<&Term>) = terms.iter().partition(|t| t.1.is_positive());
    let n = inner.first()?.0.len();
    // for each inner term the equations of its powers and of its weight, for each outer one what is left of it
    let of_outer = inner.len() * (n + 1);
    let (rows, means) = (of_outer + outer.len(), inner.len() * outer.len());
    if rows > ROWS || means + outer.len() > COLUMNS {
        return None;
    }
    let fuel = fuel.within(fuel.left() / SHARE);
    fuel.spend((rows * (means + outer.len())) as u64).ok()?;
    let mut columns = Vec::with_capacity(means + outer.len());
    for (k, (of, _)) in inner.iter().enumerate() {
        for (j, (at, _)) in outer.iter().enumerate() {
            let mut column = place(of, at, k * (n + 1));
            column.push((of_outer + j, Q::one()));
            columns.push(column);
        }
    }
    columns.extend((of_outer..rows).map(|row| vec![(row, Q::one())]));
    let weights = inner.iter().flat_map(|(_, c)| weight(n, Q::from(c.clone())));
    let b: Vec<Q> = weights.chain(outer.iter().map(|(_, c)| Q::from(-c))).collect();
    let shares = feasible(&columns, &b, Entering::Greatest, PIVOTS, &fuel)?;
    let mut found = Vec::new();
    for ((of, _), shares) in inner.iter().zip(shares.chunks(outer.len())) {
        let taken = outer.iter().zip(shares).map(|(term, share)| (&term.0, share.clone()));
        found.extend(smallest(of, taken.collect(), &fuel)?);
    }
    Some(found)
}

/// The circuits of a mean, whose terms may be many.
fn smallest(
    of: &[u32],
    mut taken: Vec<(&Vec<u32>, Q)>,
    fuel: &Fuel,
) -> Option<Vec<BTreeSet<Vec<u32>>>> {
    let mut found = Vec::new();
    loop {
        taken.retain(|(_, share)| share.is_positive());
        if taken.is_empty() {
            return Some(found);
        }
        let columns: Vec<_> = taken.iter().map(|(at, _)| place(of, at, 0)).collect();
        let b: Vec<Q> = weight(of.len(), Q::one()).collect();
        let parts = feasible(&columns, &b, Entering::First, PIVOTS, fuel)?;
        let circuit = taken.iter().zip(&parts).filter(|(_, part)| part.is_positive());
        let most = circuit.clone().map(|((_, share), part)| share / part).min()?;
        found.push(circuit.map(|((at, _), _)| (*at).clone()).chain([of.to_vec()]).collect());
        for ((_, share), part) in taken.iter_mut().zip(&parts) {
            *share -= &most * part;
        }
    }
}

/// What a term adds to the equations of a mean: the difference of its powers, and its weight.
fn place(of: &[u32], at: &[u32], first: usize) -> Vec<(usize, Q)> {
    let less = |(a, b): (&u32, &u32)| Q::from(BigInt::from(i64::from(*a) - i64::from(*b)));
    let powers = (first..).zip(at.iter().zip(of).map(less)).filter(|entry| !entry.1.is_zero());
    powers.chain([(first + of.len(), Q::one())]).collect()
}

/// The right sides of the equations of a mean in so many variables.
fn weight(n: usize, c: Q) -> impl Iterator<Item = Q> {
    std::iter::repeat_n(Q::zero(), n).chain([c])
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn terms(all: &[(&[u32], i64)]) -> Vec<Term> {
        all.iter().map(|(powers, c)| (powers.to_vec(), BigInt::from(*c))).collect()
    }

    fn found(all: &[(&[u32], i64)]) -> Option<Vec<BTreeSet<Vec<u32>>>> {
        circuits(&terms(all), &Fuel::new(1 << 30))
    }

    #[test]
    fn a_mean_of_many_is_cut_into_the_fewest() {
        // 2·xy is between x² and y², and between 1 and x²y²
        let all: [(&[u32], i64); 5] =
            [(&[1, 1], 4), (&[2, 0], -1), (&[0, 2], -1), (&[0, 0], -1), (&[2, 2], -1)];
        let circuits = found(&all).expect("each is taken as often as it is there");
        assert_eq!(circuits.iter().map(BTreeSet::len).collect::<Vec<_>>(), [3, 3]);
    }

    #[test]
    fn no_more_is_taken_than_there_is() {
        assert_eq!(found(&[(&[1], 3), (&[2], -1), (&[0], -1)]), None);
        assert_eq!(found(&[(&[3], 1), (&[2], -5), (&[0], -5)]), None);
    }

    proptest! {
        /// n·xᵝ is a mean of n terms whose powers have the sum n·β.
        #[test]
        fn a_planted_mean_is_found(
            of in prop::collection::vec(1u32..5, 3),
            shifts in prop::collection::vec(prop::collection::vec(-1i64..=1, 3), 1..4),
        ) {
            let mut all = std::collections::BTreeMap::new();
            for shift in &shifts {
                for sense in [1, -1] {
                    let at: Vec<u32> = of
                        .iter()
                        .zip(shift)
                        .map(|(p, d)| u32::try_from(i64::from(*p) + sense * d).expect("p ≥ 1"))
                        .collect();
                    *all.entry(at).or_insert(BigInt::from(0)) -= 1;
                }
            }
            *all.entry(of.clone()).or_insert(BigInt::from(0)) += 2 * shifts.len();
            all.retain(|_, c| *c != BigInt::from(0));
            let terms: Vec<Term> = all.into_iter().collect();
            prop_assume!(!terms.is_empty());
            let circuits = circuits(&terms, &Fuel::new(1 << 30)).expect("the mean was planted");
            for circuit in circuits {
                prop_assert!(circuit.contains(&of));
                prop_assert!(circuit.iter().all(|at| terms.iter().any(|term| term.0 == *at)));
            }
        }
    }
}
