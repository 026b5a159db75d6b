//! Polynomials in one variable: values, and Descartes' bound on the roots in an interval.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::{Checked, Fuel};

/// Sign of Σ cᵢxⁱ at a rational x: −1, 0 or 1. Exact.
#[must_use]
pub fn sign_at(p: &[BigInt], x: &BigRational) -> i8 {
    // Homogeneous Horner: Σ cᵢ nⁱ d^(k−i), d > 0.
    let (mut sum, mut power) = (BigInt::zero(), BigInt::one());
    for c in p.iter().rev() {
        sum = sum * x.numer() + c * &power;
        power *= x.denom();
    }
    sign(&sum)
}

/// Sign of an integer: −1, 0 or 1.
#[must_use]
pub fn sign(c: &BigInt) -> i8 {
    i8::from(c.is_positive()) - i8::from(c.is_negative())
}

/// Sign variations after mapping the open interval (lo, hi) onto (0, ∞): an upper bound on the
/// number of roots there, with multiplicity; 0 and 1 are exact (Descartes 1637). An empty interval
/// has none.
///
/// # Errors
/// [`crate::Rejection::Budget`].
pub fn descartes(p: &[BigInt], lo: &BigRational, hi: &BigRational, fuel: &Fuel) -> Checked<usize> {
    if lo >= hi {
        return Ok(0);
    }
    let n = u64::try_from(p.len()).unwrap_or(u64::MAX);
    let bits = p.iter().map(BigInt::bits).max().unwrap_or(0);
    let ends: u64 = [lo, hi].iter().map(|q| q.numer().bits() + q.denom().bits()).sum();
    fuel.spend(n.saturating_mul(n).saturating_mul(1 + (bits + n.saturating_mul(ends + 1)) / 64))?;
    // x = lo + 1/y with y > 1/(hi − lo).
    let mut q = shift(p, lo);
    q.reverse();
    let mapped = shift(&q, &(hi - lo).recip());
    let signs: Vec<bool> =
        mapped.iter().filter(|c| !c.is_zero()).map(Signed::is_positive).collect();
    Ok(signs.windows(2).filter(|w| w[0] != w[1]).count())
}

/// A positive multiple of p(x + a), exact: d^k·p(x + a) for a = n/d and k + 1
/// coefficients.
#[must_use]
pub fn shift(p: &[BigInt], a: &BigRational) -> Vec<BigInt> {
    // With a = n/d: Taylor coefficients of d^k·p(x/d) at n, then x := d·x.
    let powers = |c: &BigInt| Some(c * a.denom());
    let powers: Vec<_> = std::iter::successors(Some(BigInt::one()), powers).take(p.len()).collect();
    let mut out: Vec<BigInt> = p.iter().zip(powers.iter().rev()).map(|(c, d)| c * d).collect();
    for i in 0..out.len() {
        for j in (i + 1..out.len()).rev() {
            let carry = &out[j] * a.numer();
            out[j - 1] += carry;
        }
    }
    out.iter().zip(&powers).map(|(c, d)| c * d).collect()
}
