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
    let mut power = leading_power(&magnitude);
    let mantissa = (&magnitude / power_of(10, power + 1 - i64::from(digits))).round().to_integer();
    if mantissa == Integer::from(10).pow(digits) {
        // rounded up to one digit and zeros
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

/// The power of ten of the first digit that is not 0, of a positive number: 10^power ≤ x < 10^(power + 1).
fn leading_power(x: &Rational) -> i64 {
    let length = |n: &Integer| i64::try_from(n.to_string().len()).expect("few digits");
    let whole = x.to_integer();
    if whole.is_zero() {
        // with 10^(k − 1) < 1/x ≤ 10^k the greatest integer below 1/x has k digits
        return -length(&(x.recip().ceil().to_integer() - 1));
    }
    length(&whole) - 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    /// What is written of x with so many digits, held against what the documentation says.
    fn is_nearest(x: &Rational, digits: u32) {
        let text = significant(x, digits);
        let written = parse(&text).expect("it is a number");
        let mut power = 0;
        while power_of(10, power) > x.abs() {
            power -= 1;
        }
        while power_of(10, power + 1) <= x.abs() {
            power += 1;
        }
        let unit = power_of(10, power + 1 - i64::from(digits));
        let off = (&written - x).abs() * Integer::from(2);
        assert!(off < unit || off == unit && written.abs() > x.abs(), "{x} as {text}");
        // rounded up to a power of ten it has one digit more before the point
        power += i64::from(written.abs() == power_of(10, power + 1));
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, ""));
        let plain = (-5..i64::from(digits)).contains(&power);
        let expected = if plain { String::new() } else { power.to_string() };
        assert_eq!(exponent, expected, "{x} as {text}");
        let figures = mantissa.trim_start_matches(['-', '0', '.']).replace('.', "");
        if mantissa.contains('.') {
            assert!(!mantissa.ends_with(['0', '.']), "{x} as {text}");
            assert!(figures.len() <= digits as usize, "{x} as {text}");
        }
        let whole = mantissa.trim_start_matches('-').split('.').next().unwrap_or("");
        assert_eq!(whole.starts_with('0'), plain && power < 0, "{x} as {text}");
        assert!(plain || whole.len() == 1, "{x} as {text}");
        assert_eq!(text.starts_with('-'), x.is_negative(), "{x} as {text}");
    }

    #[test]
    fn what_is_written_is_nearest_and_without_zeros_at_its_end() {
        for shift in -8..6 {
            for numer in (1..130).chain([995, 999, 1000, 1001, 9_949, 9_950, 9_999, 10_001]) {
                for denom in [1, 3, 4, 7, 16, 1000] {
                    let x = Rational::new(numer.into(), denom.into()) * power_of(10, shift);
                    (1..=3).for_each(|digits| is_nearest(&x, digits));
                    is_nearest(&-x, 4);
                }
            }
        }
        for exponent in [-310, -77, 40, 308] {
            for off in ["1", "0.99999999999", "1.0000000001", "0.95", "1.05", "7"] {
                let x = parse(off).expect("a number") * power_of(10, exponent);
                [1, 2, 9, 31].into_iter().for_each(|digits| is_nearest(&x, digits));
            }
        }
        assert_eq!(significant(&Rational::zero(), 3), "0");
    }
}
