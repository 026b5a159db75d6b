//! Fractions as decimals of a few digits, for the eye: what is exact stands beside them or is too long.

use kane_number::power_of;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed as _, Zero as _};

/// Digits behind the point; of a number below 1, from the first that is not 0.
const DIGITS: u32 = 4;
/// Digits of which two numbers have to differ in one; values that are enclosed are known to so many.
const MOST_DIGITS: u32 = 11;
/// Powers of ten between which a number is written without one.
const PLAIN: std::ops::Range<i64> = -6..20;

/// Rounded to nearest: `0.7071`, `12.3457`, `0.001235`, `1.2346e-9`.
pub(super) fn decimal(q: &BigRational) -> String {
    to_digits(q, DIGITS)
}

/// Two numbers, to as many digits as tell them apart, if some do.
pub(super) fn apart(a: &BigRational, b: &BigRational) -> (String, String) {
    let both = |digits| (to_digits(a, digits), to_digits(b, digits));
    let told = (DIGITS..=MOST_DIGITS).map(both).find(|(a, b)| a != b);
    told.unwrap_or_else(|| both(DIGITS))
}

fn to_digits(q: &BigRational, digits: u32) -> String {
    if q.is_zero() {
        return "0".to_owned();
    }
    let first = first_place(q);
    let sign = if q.is_negative() { "-" } else { "" };
    if PLAIN.contains(&first) {
        let places = i64::from(digits) - (first + 1).min(0);
        let text = rounded(q, places);
        let places = usize::try_from(places).unwrap_or_default();
        let text = format!("{text:0>width$}", width = places + 1);
        let (whole, rest) = text.split_at(text.len() - places);
        return format!("{sign}{whole}.{rest}");
    }
    let text = rounded(q, i64::from(digits) - first);
    // 9.99995 is 10.0000
    let first = first + i64::from(text.len() > digits as usize + 1);
    format!("{sign}{}.{}e{first}", &text[..1], &text[1..=digits as usize])
}

/// |q|·10^places to the nearest integer, halves up.
fn rounded(q: &BigRational, places: i64) -> String {
    let half = BigRational::new(1.into(), 2.into());
    (q.abs() * power_of(10, places) + half).floor().to_integer().to_string()
}

/// The power of ten of the first digit that is not 0.
fn first_place(q: &BigRational) -> i64 {
    let length = |n: &BigInt| i64::try_from(n.magnitude().to_string().len()).unwrap_or(i64::MAX);
    let first = length(q.numer()) - length(q.denom());
    if q.abs() >= power_of(10, first) { first } else { first - 1 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn q(n: i64, d: i64) -> BigRational {
        BigRational::new(n.into(), d.into())
    }

    #[test]
    fn numbers_keep_their_first_digits() {
        let told = [
            (q(2, 3), "0.6667"),
            (q(-1, 3), "-0.3333"),
            (q(123_456_789, 1000), "123456.7890"),
            (q(1, 800), "0.001250"),
            (q(99_999_999, 100_000_000), "1.0000"),
            (q(1, 3_000_000_000), "3.3333e-10"),
            (q(999_999_999, 1_000_000_000_000_000_000), "1.0000e-9"),
            (q(0, 1), "0"),
        ];
        for (number, text) in told {
            assert_eq!(decimal(&number), text);
        }
        let large = BigRational::from_integer(BigInt::from(10).pow(30));
        assert_eq!(decimal(&large), "1.0000e30");
    }

    #[test]
    fn digits_are_added_until_two_numbers_differ() {
        let (a, b) = apart(&q(1, 1), &q(1_000_000_001, 1_000_000_000));
        assert_eq!((&*a, &*b), ("1.000000000", "1.000000001"));
    }

    proptest! {
        /// Half a unit of the last of four digits is at most 1/2·10⁻³ of the number.
        #[test]
        fn a_decimal_is_within_a_part_in_two_thousand(n in any::<i64>(), d in 1..i64::MAX) {
            let number = q(n, d);
            let text = decimal(&number);
            let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            let places = digits.split_once('.').map_or(0, |(_, rest)| rest.len());
            let digits: BigInt = digits.replace('.', "").parse().expect("digits");
            let exponent: i64 = exponent.parse().expect("an exponent");
            let shown = BigRational::from_integer(digits) * power_of(10, exponent - i64::try_from(places).expect("few places"));
            prop_assert!((shown - &number).abs() * BigRational::from_integer(2_000.into()) <= number.abs());
        }
    }
}
