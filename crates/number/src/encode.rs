//! From a rational to the float that is nearest, or next in a direction.

use num_bigint::{BigUint, Sign};
use num_integer::Integer as _;
use num_traits::{ToPrimitive, Zero};

use crate::{Binary, Rational};

/// To which of the two neighbouring floats a rational goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// To the nearer one; halfway, to the one whose last bit is 0. Overflow gives ±∞.
    NearestEven,
    /// To the greatest float that is not above: toward −∞.
    Down,
    /// To the least float that is not below: toward +∞.
    Up,
}

/// Gives the float that represents a rational under the given rounding.
///
/// Correctly rounded for every rational, subnormal results included, by integer arithmetic alone.
/// As IEEE 754 (2019, sections 4.3 and 7.4) has it, a nearest result is ±∞ from
/// 2^(Emax+1) − 2^(Emax−PRECISION) on; a directed result beyond the range is ±∞ or the greatest
/// finite float, whichever lies on the right side. Zero gives +0; a negative number that rounds
/// to zero gives −0.
///
/// ```
/// use kane_number::{Rounding, encode, parse};
/// let tenth = parse("0.1")?;
/// assert_eq!(encode::<f64>(&tenth, Rounding::NearestEven), 0.1);
/// assert!(encode::<f32>(&tenth, Rounding::Down) < encode::<f32>(&tenth, Rounding::Up));
/// # Ok::<(), kane_number::ParseError>(())
/// ```
#[must_use]
pub fn encode<F: Binary>(exact: &Rational, rounding: Rounding) -> F {
    let negative = exact.numer().sign() == Sign::Minus;
    let (numer, denom) = (exact.numer().magnitude(), exact.denom().magnitude());
    if numer.is_zero() {
        return F::from_magnitude_bits(false, 0);
    }
    let away = match rounding {
        Rounding::NearestEven => None,
        Rounding::Down => Some(negative),
        Rounding::Up => Some(!negative),
    };

    let binade = binade(numer, denom);
    if binade > F::GREATEST_EXPONENT {
        return F::from_magnitude_bits(negative, overflow::<F>(away));
    }
    let unit = (binade - i64::from(F::PRECISION) + 1).max(F::LEAST_EXPONENT);
    let (floor, rest, divisor) = divide_by_unit(numer, denom, unit);
    let up = match away {
        None => match (rest << 1_u32).cmp(&divisor) {
            std::cmp::Ordering::Less => false,
            std::cmp::Ordering::Equal => floor % 2 == 1,
            std::cmp::Ordering::Greater => true,
        },
        Some(away) => away && !rest.is_zero(),
    };
    // The hidden bit of a normal significand adds one to the exponent field, and a carry out of
    // the significand lands on the next binade, or on infinity: one sum covers every case.
    let steps = (unit - F::LEAST_EXPONENT).unsigned_abs() << (F::PRECISION - 1);
    F::from_magnitude_bits(negative, steps + floor + u64::from(up))
}

/// The integer b with 2^b ≤ numer/denom < 2^(b+1), for positive arguments.
pub(crate) fn binade(numer: &BigUint, denom: &BigUint) -> i64 {
    let bits = |n: &BigUint| i64::try_from(n.bits()).expect("a bit count fits 63 bits");
    let upper = bits(numer) - bits(denom);
    let scale = upper.unsigned_abs();
    let reached = if upper >= 0 { *numer >= denom << scale } else { numer << scale >= *denom };
    if reached { upper } else { upper - 1 }
}

/// Divides numer/denom by 2^unit: the integer part, and the remainder with its divisor.
fn divide_by_unit(numer: &BigUint, denom: &BigUint, unit: i64) -> (u64, BigUint, BigUint) {
    let scale = unit.unsigned_abs();
    let (numer, denom) =
        if unit >= 0 { (numer.clone(), denom << scale) } else { (numer << scale, denom.clone()) };
    let (floor, rest) = numer.div_rem(&denom);
    let floor = floor.to_u64().expect("the unit leaves PRECISION bits");
    (floor, rest, denom)
}

/// The magnitude pattern of a number beyond the last binade.
fn overflow<F: Binary>(away: Option<bool>) -> u64 {
    match away {
        Some(false) => F::infinity_bits() - 1,
        None | Some(true) => F::infinity_bits(),
    }
}
