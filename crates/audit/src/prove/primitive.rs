//! A point whose coordinates are roots of numbers, and roots of what is made of such, in the field of one algebraic
//! number: θ = Σ wᵢ·sᵢ, whose powers are written in the products of the sᵢ, and these in the powers.

use kane_algebra::linear_program::common_denominator;
use kane_algebra::point::{Partial, specialised};
use kane_algebra::sign_table::SignTable;
use kane_kernel::{Atom, Fuel, Point, Poly, State};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, Zero as _};

use super::diagonal::diagonal;
use super::elimination::{Elimination, open_vars};
use super::radicals::{Radical, Radicals, Reduced, contradiction};
use super::sample::{candidates, complete};
use super::search::{Outcome, Search};

type Q = BigRational;

/// Roots that are written by one number: of five it is of degree 32.
const ROOTS: usize = 4;
/// Variables beside them, and values for them that are tried.
const OTHERS: usize = 3;
const TRIES: usize = 40;
/// Weights of the roots in it, by the power to which they are raised: with some of them two conjugates may be equal.
const WEIGHTS: [u32; 3] = [1, 2, 5];

impl Search<'_> {
    /// How a state ends that speaks of three roots of numbers or more, where that is seen.
    pub(super) fn by_roots(&self, state: &State<'_, '_>, trail: &[Elimination]) -> Option<Outcome> {
        let radicals = Radicals::of(state)?;
        if let Some(proof) = contradiction(state, &radicals) {
            return Some(Outcome::Closed(proof));
        }
        let values = values(state, &radicals)?;
        // what has a point has no proof
        if !self.models {
            return Some(Outcome::Open);
        }
        let fuel = &state.scope.fuel;
        let mut partial = WEIGHTS.iter().find_map(|&w| written(&radicals, w, fuel))?;
        values.into_iter().for_each(|(v, q)| partial.set(v, q));
        // where the number's polynomial has factors, a 0 is not always seen to be one
        let is_shown = |a: &Atom| partial.sign(&a.poly, fuel).is_some_and(|s| a.sign.admits(s));
        if !state.atoms.iter().all(is_shown) {
            return None;
        }
        complete(state, partial, trail).map(Outcome::Model)
    }
}

/// Simple values for what is no root, where all conditions seem to hold.
fn values(state: &State<'_, '_>, radicals: &Radicals) -> Option<Vec<(usize, Q)>> {
    let others: Vec<usize> = open_vars(state).into_iter().filter(|v| !radicals.has(*v)).collect();
    if radicals.0.len() > ROOTS || others.len() > OTHERS {
        return None;
    }
    let lists: Vec<Vec<Q>> = others.iter().map(|v| candidates(state, *v)).collect();
    diagonal(&lists, TRIES).find_map(|values| {
        let values: Vec<(usize, Q)> = others.iter().copied().zip(values).collect();
        let holds = |a: &Atom| {
            let sign = radicals.seen(&specialised(&a.poly, &values), &state.scope.fuel);
            sign.is_some_and(|sign| a.sign.admits(sign))
        };
        state.atoms.iter().all(holds).then_some(values)
    })
}

/// The roots by the number with these weights.
fn written(radicals: &Radicals, weight: u32, fuel: &Fuel) -> Option<Partial> {
    let of = |(i, r): (usize, &Radical)| {
        Poly::var(r.s).scale(&BigInt::from(weight).pow(u32::try_from(i).unwrap_or_default()))
    };
    let theta = radicals.0.iter().enumerate().map(of).fold(Poly::default(), |sum, p| sum.add(&p));
    let degree = 1_usize << radicals.0.len();
    // a column for each power up to the degree, then one for each root
    let (mut power, mut over) = (Poly::one(), BigInt::one());
    let mut columns = Vec::new();
    for _ in 0..=degree {
        columns.push(column(radicals, &power, &over));
        let next = Reduced::of(&power.mul(&theta, fuel).ok()?, radicals, fuel)?;
        (power, over) = (next.left, over * next.scale);
    }
    columns.extend(radicals.0.iter().map(|r| column(radicals, &Poly::var(r.s), &BigInt::one())));
    let rows = (0..degree).map(|m| columns.iter().map(|c| c[m].clone()).collect()).collect();
    let rows = solved(rows, fuel)?;
    let of = |at: usize| rows.iter().map(|row| row[at].clone()).collect::<Vec<Q>>();
    let mut monic: Vec<Q> = of(degree).into_iter().map(|q| -q).collect();
    monic.push(Q::one());
    let common = common_denominator(&monic);
    let poly: Vec<BigInt> = monic.iter().map(|q| (q * &common).to_integer()).collect();
    // of the roots of a factor θ is the one in whose interval its value is
    let value = radicals.value(&theta)?;
    let table = SignTable::new(&[poly], fuel).ok()?;
    let root = table.roots.into_iter().find(|root| value.meets(&root.lo, &root.hi))?;
    let values = radicals.0.iter().enumerate().map(|(i, r)| (r.s, of(degree + 1 + i)));
    let whole = Partial::from(&Point { generator: Some(root), values: values.collect() });
    let reduced = radicals.0.iter().map(|r| Some((r.s, whole.eval(&Poly::var(r.s))?)));
    Some(Partial { values: reduced.collect::<Option<_>>()?, ..whole.clone() })
}

/// The coefficients of a polynomial over a number, by the products of roots.
fn column(radicals: &Radicals, p: &Poly, over: &BigInt) -> Vec<Q> {
    let mut out = vec![Q::zero(); 1 << radicals.0.len()];
    for (m, c) in p.terms() {
        let place = |v: usize| radicals.0.iter().position(|r| r.s == v).unwrap_or_default();
        let at: usize = m.iter().map(|(v, _)| 1 << place(*v)).sum();
        out[at] = Q::new(c.clone(), over.clone());
    }
    out
}

/// The rows with the unit matrix in front, by elimination (Gauß and Jordan); `None` if that is not possible.
fn solved(mut rows: Vec<Vec<Q>>, fuel: &Fuel) -> Option<Vec<Vec<Q>>> {
    let n = rows.len();
    for i in 0..n {
        let words =
            rows.iter().flatten().map(|q| 1 + (q.numer().bits() + q.denom().bits()) / 64).max()?;
        fuel.spend(u64::try_from(n * n).ok()?.saturating_mul(20 * words * words)).ok()?;
        let pivot = (i..n).find(|&r| !rows[r][i].is_zero())?;
        rows.swap(i, pivot);
        let lead = rows[i][i].recip();
        let row: Vec<Q> = rows[i].iter().map(|q| q * &lead).collect();
        for (_, other) in rows.iter_mut().enumerate().filter(|(r, _)| *r != i) {
            let factor = other[i].clone();
            if !factor.is_zero() {
                for (x, y) in other.iter_mut().zip(&row) {
                    *x -= &factor * y;
                }
            }
        }
        rows[i] = row;
    }
    Some(rows)
}
