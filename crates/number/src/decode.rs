//! From a float to the rational that it is.

use crate::{Binary, Integer, Rational};

/// A float that stands for no number: NaN, +∞ or −∞.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotFinite {
    /// Not a number.
    #[error("NaN is not a number")]
    Nan,
    /// Positive infinity.
    #[error("+inf is not a finite number")]
    PositiveInfinity,
    /// Negative infinity.
    #[error("-inf is not a finite number")]
    NegativeInfinity,
}

/// Gives the exact value of a finite float: normal, subnormal, or zero (both zeros give 0).
///
/// Exact. Inverse to [`encode`](crate::encode) up to the sign of zero.
///
/// # Errors
/// [`NotFinite`] for NaN and ±∞.
///
/// ```
/// use kane_number::decode;
/// assert_eq!(decode(0.75_f64)?.to_string(), "3/4");
/// assert!(decode(f64::NAN).is_err());
/// # Ok::<(), kane_number::NotFinite>(())
/// ```
pub fn decode<F: Binary>(float: F) -> Result<Rational, NotFinite> {
    let (mantissa, exponent) = magnitude_parts(float)?;
    if mantissa == 0 {
        return Ok(Rational::from_integer(Integer::ZERO));
    }
    // An odd numerator over a power of two is in lowest terms, so no gcd is needed.
    let twos = mantissa.trailing_zeros();
    let odd = Integer::from(mantissa >> twos);
    let exponent = exponent + i64::from(twos);
    let signed = if float.is_negative() { -odd } else { odd };
    let scale = exponent.unsigned_abs();
    Ok(if exponent >= 0 {
        Rational::from_integer(signed << scale)
    } else {
        Rational::new_raw(signed, Integer::from(1) << scale)
    })
}

/// The magnitude as (M, E) with |float| = M·2^E and M < 2^PRECISION.
pub(crate) fn magnitude_parts<F: Binary>(float: F) -> Result<(u64, i64), NotFinite> {
    let bits = float.magnitude_bits();
    if bits > F::infinity_bits() {
        return Err(NotFinite::Nan);
    }
    if bits == F::infinity_bits() {
        return Err(if float.is_negative() {
            NotFinite::NegativeInfinity
        } else {
            NotFinite::PositiveInfinity
        });
    }
    let hidden = 1_u64 << (F::PRECISION - 1);
    let fraction = bits & (hidden - 1);
    let biased = (bits >> (F::PRECISION - 1)).cast_signed();
    Ok(if biased == 0 {
        (fraction, F::LEAST_EXPONENT)
    } else {
        (fraction | hidden, F::LEAST_EXPONENT + biased - 1)
    })
}
