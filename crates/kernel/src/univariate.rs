//! Polynomials in one variable: values, and Descartes' bound on the roots in an interval.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::{Fuel, Rejection};

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
    if c.is_zero() {
        0
    } else if c.is_negative() {
        -1
    } else {
        1
    }
}

/// Sign variations after mapping the open interval onto (0, ∞): an upper bound on the number of
/// roots there, with multiplicity; 0 and 1 are exact (Descartes 1637). `None` stands for ∓∞.
/// An empty interval has none.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn descartes(
    p: &[BigInt],
    lo: Option<&BigRational>,
    hi: Option<&BigRational>,
    fuel: &Fuel,
) -> Result<usize, Rejection> {
    if let (Some(a), Some(b)) = (lo, hi) {
        if a >= b {
            return Ok(0);
        }
    }
    let n = u64::try_from(p.len()).unwrap_or(u64::MAX);
    let bits = p.iter().map(BigInt::bits).max().unwrap_or(0);
    let end_bits = |x: Option<&BigRational>| x.map_or(0, |q| q.numer().bits() + q.denom().bits());
    let width = 1 + (bits + n.saturating_mul(end_bits(lo) + end_bits(hi) + 1)) / 64;
    fuel.spend(n.saturating_mul(n).saturating_mul(width))?;
    let mapped = match (lo, hi) {
        (None, None) => {
            let negative = reflect(p.to_vec());
            let zero = usize::from(p.first().is_some_and(Zero::is_zero));
            return Ok(variations(p) + variations(&negative) + zero);
        }
        (Some(a), None) => shift(p.to_vec(), a),
        (None, Some(b)) => shift(reflect(p.to_vec()), &-b),
        (Some(a), Some(b)) => {
            // x = a + (b − a)·y, then y = 1/(1 + z).
            let mut q = shift(p.to_vec(), a);
            let step = b - a;
            let (mut up, mut powers) = (BigInt::one(), vec![BigInt::one()]);
            for _ in 1..q.len() {
                up *= step.denom();
                powers.push(up.clone());
            }
            let mut numer = BigInt::one();
            for (c, scale) in q.iter_mut().zip(powers.iter().rev()) {
                *c *= &numer * scale;
                numer *= step.numer();
            }
            q.reverse();
            shift(q, &BigRational::one())
        }
    };
    Ok(variations(&mapped))
}

/// p(−x)
fn reflect(mut p: Vec<BigInt>) -> Vec<BigInt> {
    for c in p.iter_mut().skip(1).step_by(2) {
        *c = -&*c;
    }
    p
}

/// A positive multiple of p(x + a).
fn shift(mut p: Vec<BigInt>, a: &BigRational) -> Vec<BigInt> {
    // With a = n/d: d^k p((x + n)/d), then x := d·x.
    let mut power = BigInt::one();
    for c in p.iter_mut().rev() {
        *c *= &power;
        power *= a.denom();
    }
    for i in 0..p.len() {
        for j in (i..p.len().saturating_sub(1)).rev() {
            let carry = &p[j + 1] * a.numer();
            p[j] += carry;
        }
    }
    let mut power = BigInt::one();
    for c in &mut p {
        *c *= &power;
        power *= a.denom();
    }
    p
}

fn variations(p: &[BigInt]) -> usize {
    let signs: Vec<bool> = p.iter().filter(|c| !c.is_zero()).map(Signed::is_positive).collect();
    signs.windows(2).filter(|w| w[0] != w[1]).count()
}
