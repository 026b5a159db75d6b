//! Resultants of polynomials in several variables, from their values at integers.

use kane_kernel::{Fuel, Monomial, Poly};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};
use polycore::Uni;
use std::collections::BTreeMap;

use crate::point::specialised;
use crate::ring::univariate;

type Q = BigRational;

/// Values that are interpolated, beyond which a resultant is not computed.
const VALUES: u64 = 4_000;

/// The resultant of p and q in v, a polynomial in their other variables: exact, up to a factor that is
/// a positive number. `None` if it is too large, if one of them is free of v, or without budget.
#[must_use]
pub fn resultant(p: &Poly, q: &Poly, v: usize, fuel: &Fuel) -> Option<Poly> {
    let mut others: Vec<usize> = p.vars().into_iter().chain(q.vars()).filter(|w| *w != v).collect();
    others.sort_unstable();
    others.dedup();
    let (m, n) = (u64::from(p.degree(v)), u64::from(q.degree(v)));
    if m == 0 || n == 0 {
        return None;
    }
    let bound = |w: usize| m * u64::from(q.degree(w)) + n * u64::from(p.degree(w));
    let values = others.iter().try_fold(1u64, |a, w| a.checked_mul(bound(*w) + 1))?;
    let words = 1 + (m * q.bits() + n * p.bits()) / 64;
    fuel.spend(values.checked_mul((m + n).pow(3))?.checked_mul(words)?).ok()?;
    if values > VALUES {
        return None;
    }
    Some(interpolated(p, q, v, &others)?.primitive().1)
}

/// The discriminant of p in v up to its leading coefficient: the resultant with its derivative.
#[must_use]
pub fn discriminant(p: &Poly, v: usize, fuel: &Fuel) -> Option<Poly> {
    resultant(p, &p.derivative(v, fuel).ok()?, v, fuel)
}

fn interpolated(p: &Poly, q: &Poly, v: usize, others: &[usize]) -> Option<Poly> {
    let Some((&w, rest)) = others.split_first() else {
        let uni = |p: &Poly| {
            let c = univariate(p, v)?;
            Some(Uni::new(c.into_iter().map(Q::from_integer).collect()))
        };
        let value = uni(p)?.resultant(&uni(q)?);
        return value.is_integer().then(|| Poly::constant(value.to_integer()));
    };
    let (m, n) = (p.degree(v), q.degree(v));
    let bound = m * q.degree(w) + n * p.degree(w);
    let mut at: Vec<Q> = Vec::new();
    let mut values: Vec<Poly> = Vec::new();
    // Where a leading coefficient vanishes the resultant is another one.
    let mut next = 0i64;
    while at.len() <= bound as usize {
        let x = Q::from_integer(next.into());
        next = if next > 0 { -next } else { 1 - next };
        let here = [(w, x.clone())];
        let (p, q) = (specialised(p, &here), specialised(q, &here));
        if p.degree(v) < m || q.degree(v) < n {
            continue;
        }
        values.push(interpolated(&p, &q, v, rest)?);
        at.push(x);
    }
    let mut rows: BTreeMap<Monomial, Vec<Q>> = BTreeMap::new();
    for (i, value) in values.iter().enumerate() {
        for (monomial, c) in value.terms() {
            let row = rows.entry(monomial.to_vec()).or_insert_with(|| vec![Q::zero(); at.len()]);
            row[i] = Q::from_integer(c.clone());
        }
    }
    let mut sum = Poly::default();
    for (monomial, row) in rows {
        let found = Uni::interpolate(&at, &row);
        for (n, c) in found.0.iter().enumerate().filter(|(_, c)| !c.is_zero()) {
            if !c.is_integer() {
                return None;
            }
            let mut term = monomial.clone();
            if n > 0 {
                term.push((w, n.to_u32()?));
                term.sort_unstable();
            }
            sum = sum.add(&Poly::term(term, c.to_integer()));
        }
    }
    Some(sum)
}

/// Resₜ(m(t), Σ cᵢ(t)·yⁱ) as a polynomial in y: all values of y at which the second polynomial
/// vanishes for some root t of m. `None` if it vanishes for one whatever y is.
pub(super) fn norm(m: &Uni<Q>, coefficients: &[Uni<Q>], fuel: &Fuel) -> Option<Vec<BigInt>> {
    let degree = m.deg() * (coefficients.len().checked_sub(1)?);
    let words = m.0.iter().chain(coefficients.iter().flat_map(|c| &c.0));
    let words = words.map(|q| q.numer().bits() + q.denom().bits()).max().unwrap_or(0) / 64 + 1;
    let size = (degree as u64 + 1) * (m.deg() as u64 + 1).pow(3);
    fuel.spend(size.checked_mul(words)?).ok()?;
    let at: Vec<Q> = (0..=degree).map(|k| Q::from_integer(k.into())).collect();
    let values: Vec<Q> = at
        .iter()
        .map(|y| {
            let value = coefficients
                .iter()
                .rev()
                .fold(Uni::constant(Q::zero()), |sum, c| &sum.scale(y) + c);
            if value.is_zero() { Q::zero() } else { value_resultant(m, &value) }
        })
        .collect();
    let found = Uni::interpolate(&at, &values);
    (!found.is_zero()).then(|| whole(&found))
}

/// The resultant, also where the second polynomial is a constant.
fn value_resultant(m: &Uni<Q>, p: &Uni<Q>) -> Q {
    if p.deg() == 0 {
        let c = p.lc();
        return (0..m.deg()).fold(Q::one(), |product, _| product * &c);
    }
    m.resultant(p)
}

/// A polynomial times a positive number, with integers for coefficients.
pub(super) fn whole(p: &Uni<Q>) -> Vec<BigInt> {
    let common = p.0.iter().fold(BigInt::one(), |l, q| num_integer::lcm(l, q.denom().clone()));
    let integers: Vec<BigInt> = p.0.iter().map(|q| q.numer() * (&common / q.denom())).collect();
    let gcd = integers.iter().fold(BigInt::zero(), |g, c| num_integer::gcd(g, c.clone()));
    if gcd.is_zero() { integers } else { integers.iter().map(|c| c / &gcd).collect() }
}
