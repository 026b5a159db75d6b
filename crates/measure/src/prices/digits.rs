//! Decimal digits that are right, by the relative error beside the exact value.
#![allow(clippy::float_arithmetic, reason = "digits are a logarithm, for a chart")]

use kane_floats::Core;
use kane_floats::exact::{Enclosure, value};
use kane_number::{Rational, Rounding, encode};
use num_traits::{Signed as _, Zero as _};

use crate::chart::Answer;

/// The exact value of a formula, so closely that all digits of every system can be judged; `None` if there is
/// none, or it is not found so closely. An exact 0 is a value.
pub(super) fn reference(core: &Core, at: &[f64]) -> Option<Rational> {
    let inputs: Option<Vec<Enclosure>> = at.iter().map(|x| Enclosure::of(*x)).collect();
    let inputs = inputs?;
    [320, 1_280, 6_144].into_iter().find_map(|bits| {
        let exact = value(&core.program, core.root, &inputs, bits)?;
        (exact.sharpness() > 200).then(|| exact.middle())
    })
}

/// Hundredths of decimal digits of an answer that are right, rounded down; `i64::MAX` for the exact value, or what
/// is within 10^-60 of it. Without an answer none is.
pub(super) fn right(answer: Option<&Answer>, exact: &Rational) -> i64 {
    let error = match answer {
        None => return 0,
        Some(Answer::Number(x)) => (x - exact).abs(),
        Some(Answer::Between(lower, upper)) => (lower - exact).abs().max((upper - exact).abs()),
    };
    if error.is_zero() {
        return i64::MAX;
    }
    if exact.is_zero() {
        return 0;
    }
    let digits = -100.0 * logarithm(&(error / exact.abs()));
    if digits > 6_000.0 { i64::MAX } else { whole(digits) }
}

/// log₁₀ of a positive number, to some 10^-12 of it.
fn logarithm(number: &Rational) -> f64 {
    let bits = |n: &kane_number::Integer| i64::try_from(n.bits()).unwrap_or(i64::MAX);
    let exponent = bits(number.numer()) - bits(number.denom());
    let power = kane_number::Integer::from(1) << exponent.unsigned_abs();
    let scaled = if exponent > 0 { number / power } else { number * power };
    let near: f64 = encode(&scaled, Rounding::NearestEven);
    let exponent = f64::from(i32::try_from(exponent).unwrap_or(i32::MAX));
    (near.log2() + exponent) * std::f64::consts::LOG10_2
}

#[allow(clippy::cast_possible_truncation, reason = "it is between 0 and 6,000")]
fn whole(digits: f64) -> i64 {
    digits.floor().clamp(0.0, 1e6) as i64
}

#[cfg(test)]
mod tests {
    use super::*;
    use kane_number::parse;

    #[test]
    fn digits_are_counted_from_the_relative_error() {
        let of = |x: &str, exact: &str| {
            right(Some(&Answer::Number(parse(x).unwrap())), &parse(exact).unwrap())
        };
        assert_eq!(of("1.001", "1"), 300);
        // −log₁₀ 0.002 is 2.698…: rounded down
        assert_eq!(of("998e300", "1e303"), 269);
        assert_eq!(of("1/3", "1/3"), i64::MAX);
        assert_eq!(of("1e-9", "0"), 0);
        assert_eq!(of("3", "1"), 0);
        let between = Answer::Between(parse("0.98").unwrap(), parse("1.001").unwrap());
        assert_eq!(right(Some(&between), &parse("1").unwrap()), 169);
        assert_eq!(right(None, &parse("1").unwrap()), 0);
    }
}
