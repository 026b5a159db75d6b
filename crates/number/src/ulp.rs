//! Distances between floats and exact numbers.

use num_traits::Zero;

use crate::decode::magnitude_parts;
use crate::encode::binade;
use crate::{Binary, Integer, NotFinite, Rational, decode};

/// Gives the unit in the last place at an exact number x, in the format `F`.
///
/// ulp(x) = 2^(b − PRECISION + 1), where b is the binade of the exact value, 2^b ≤ |x| < 2^(b+1),
/// and never below the least subnormal, which is also the ulp of 0. At a power of two the larger
/// spacing, the one above it, counts. The binades go on beyond the largest finite float, so that
/// the distance to an unreachable number is still defined. Exact.
///
/// ```
/// use kane_number::{decode, parse, ulp};
/// assert_eq!(ulp::<f64>(&parse("1")?), decode(f64::EPSILON)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn ulp<F: Binary>(exact: &Rational) -> Rational {
    let exponent = if exact.is_zero() {
        F::LEAST_EXPONENT
    } else {
        let binade = binade(exact.numer().magnitude(), exact.denom().magnitude());
        (binade - i64::from(F::PRECISION) + 1).max(F::LEAST_EXPONENT)
    };
    let scale = Integer::from(1) << exponent.unsigned_abs();
    if exponent >= 0 {
        Rational::from_integer(scale)
    } else {
        Rational::new_raw(Integer::from(1), scale)
    }
}

/// Gives the signed error of a float, (computed − exact)/ulp(exact), with [`ulp`] as defined
/// there. Exact; at most 1/2 in magnitude for a correctly rounded result within the range.
///
/// # Errors
/// [`NotFinite`] if `computed` is NaN or ±∞.
pub fn error_in_ulps<F: Binary>(computed: F, exact: &Rational) -> Result<Rational, NotFinite> {
    Ok((decode(computed)? - exact) / ulp::<F>(exact))
}

/// Counts the representable steps between two finite floats: 0 for equal ones (and for −0 and
/// +0), 1 for neighbours. Exact; symmetric.
///
/// # Errors
/// [`NotFinite`] for the first argument that is NaN or ±∞.
///
/// ```
/// use kane_number::steps_between;
/// assert_eq!(steps_between(1.0_f64, 1.0_f64.next_up())?, 1);
/// assert_eq!(steps_between(-f64::MIN_POSITIVE, f64::MIN_POSITIVE)?, 1 << 53);
/// # Ok::<(), kane_number::NotFinite>(())
/// ```
pub fn steps_between<F: Binary>(a: F, b: F) -> Result<u64, NotFinite> {
    magnitude_parts(a)?;
    magnitude_parts(b)?;
    let (from, to) = (a.magnitude_bits(), b.magnitude_bits());
    // Finite patterns stay below 2^63, so the sum across zero cannot overflow.
    Ok(if a.is_negative() == b.is_negative() { from.abs_diff(to) } else { from + to })
}
