//! Powers of polynomials.

use num_bigint::BigInt;
use num_traits::Signed as _;

use crate::poly::{WIDEST, times};
use crate::{Checked, Fuel, Monomial, Poly, Power, Rejection};

/// From this exponent on, a sum of two terms is raised by its binomial coefficients.
const BINOMIAL: u32 = 8;

impl Poly {
    /// Power: by repeated squaring, or, of two terms, by the binomial theorem.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn pow(&self, mut n: u32, fuel: &Fuel) -> Checked<Self> {
        let mut terms = self.terms();
        if let (Some(a), Some(b), None, BINOMIAL..) = (terms.next(), terms.next(), terms.next(), n)
        {
            return binomial(a, b, n, fuel);
        }
        let (mut power, mut base) = (Self::one(), self.clone());
        while n > 0 {
            if n & 1 == 1 {
                power = power.mul(&base, fuel)?;
            }
            n >>= 1;
            if n > 0 {
                base = base.mul(&base, fuel)?;
            }
        }
        Ok(power)
    }
}

/// (c·m + d·p)ⁿ: each coefficient from the one before, aₖ₊₁ = aₖ·(n − k)·d / ((k + 1)·c).
fn binomial(
    (m, c): (&[Power], &BigInt),
    (p, d): (&[Power], &BigInt),
    n: u32,
    fuel: &Fuel,
) -> Checked<Poly> {
    // none is longer than (|c| + |d|)ⁿ; each is multiplied and divided once, and held with its powers
    let words = (c.abs() + d.abs()).bits().saturating_mul(n.into()) / 64 + 1;
    let powers = u64::try_from(m.len() + p.len()).unwrap_or(u64::MAX);
    let held = words.saturating_add(powers).saturating_mul(n.into());
    if usize::try_from(held).map_or(true, |held| held > WIDEST) {
        return Err(Rejection::Budget);
    }
    fuel.spend(8 * held)?;
    let mut coefficient = c.pow(n);
    let mut terms: Vec<(Monomial, BigInt)> = Vec::new();
    for k in 0..=n {
        let mut monomial = Vec::new();
        times(&raised(m, n - k)?, &raised(p, k)?, &mut monomial)?;
        let next = &coefficient * (d * (n - k)) / (c * (k + 1));
        terms.push((monomial, std::mem::replace(&mut coefficient, next)));
    }
    Ok(Poly::sum(terms))
}

fn raised(m: &[Power], n: u32) -> Checked<Monomial> {
    let power = |&(v, e): &Power| Ok((v, e.checked_mul(n).ok_or(Rejection::Budget)?));
    m.iter().map(power).filter(|_| n > 0).collect()
}
