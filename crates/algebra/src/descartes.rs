//! Descartes' bound on the roots of a polynomial on any interval of the line. The kernel knows it on
//! bounded ones only.

use kane_kernel::{Fuel, Rejection, shift};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

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
    if lo.zip(hi).is_some_and(|(a, b)| a >= b) {
        return Ok(0);
    }
    let n = u64::try_from(p.len()).unwrap_or(u64::MAX);
    let bits = p.iter().map(BigInt::bits).max().unwrap_or(0);
    let end_bits = |x: Option<&BigRational>| x.map_or(0, |q| q.numer().bits() + q.denom().bits());
    let width = 1 + (bits + n.saturating_mul(end_bits(lo) + end_bits(hi) + 1)) / 64;
    fuel.spend(n.saturating_mul(n).saturating_mul(width))?;
    let mapped = match (lo, hi) {
        (None, None) => {
            let zero = usize::from(p.first().is_some_and(Zero::is_zero));
            return Ok(variations(p) + variations(&reflect(p)) + zero);
        }
        (Some(a), None) => shift(p, a),
        (None, Some(b)) => shift(&reflect(p), &-b),
        (Some(a), Some(b)) => {
            // x = a + 1/y with y > 1/(b − a).
            let mut q = shift(p, a);
            q.reverse();
            shift(&q, &(b - a).recip())
        }
    };
    Ok(variations(&mapped))
}

/// p(−x)
fn reflect(p: &[BigInt]) -> Vec<BigInt> {
    p.iter().enumerate().map(|(i, c)| if i % 2 == 0 { c.clone() } else { -c }).collect()
}

fn variations(p: &[BigInt]) -> usize {
    let signs: Vec<bool> = p.iter().filter(|c| !c.is_zero()).map(Signed::is_positive).collect();
    signs.windows(2).filter(|w| w[0] != w[1]).count()
}
