//! An exact number written with a given count of significant digits.

use num_bigint::Sign;
use num_traits::{Signed, Zero};

use crate::{Integer, Rational, power_of};

/// The decimal of `digits` significant digits that is nearest (ties away from zero), without
/// trailing zeros: `-0.25`, `1.5e-30`. Plain between 10^−5 and 10^digits, otherwise scientific.
pub(crate) fn significant(exact: &Rational, digits: u32) -> String {
    if exact.is_zero() {
        return "0".to_owned();
    }
    let magnitude = exact.abs();
    // A first guess from the bit lengths, off by one at most; then exactly.
    let bits = |n: &Integer| i64::try_from(n.bits()).expect("a bit count fits 63 bits");
    let mut power = (bits(magnitude.numer()) - bits(magnitude.denom())) * 30103 / 100_000 - 1;
    while power_of(10, power + 1) <= magnitude {
        power += 1;
    }
    while power_of(10, power) > magnitude {
        power -= 1;
    }
    let mut mantissa =
        (&magnitude / power_of(10, power + 1 - i64::from(digits))).round().to_integer();
    if mantissa == Integer::from(10).pow(digits) {
        mantissa /= 10;
        power += 1;
    }
    let text = mantissa.to_string();
    let text = text.trim_end_matches('0');
    let sign = if exact.numer().sign() == Sign::Minus { "-" } else { "" };
    let length = i64::try_from(text.len()).expect("few digits");
    let zeros = |count: i64| "0".repeat(usize::try_from(count).unwrap_or(0));
    let cut = usize::try_from(power + 1).unwrap_or(0);
    match power {
        -5..0 => format!("{sign}0.{}{text}", zeros(-power - 1)),
        0.. if power + 1 >= length && power < i64::from(digits) => {
            format!("{sign}{text}{}", zeros(power + 1 - length))
        }
        0.. if power < i64::from(digits) => format!("{sign}{}.{}", &text[..cut], &text[cut..]),
        _ if length == 1 => format!("{sign}{text}e{power}"),
        _ => format!("{sign}{}.{}e{power}", &text[..1], &text[1..]),
    }
}
