//! Literals: exact decimals, to and from text.

use std::borrow::Cow;

use kane_kernel::Expr;
use num_bigint::{BigInt, BigUint, Sign};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::bounds::MAX_DIGITS;

/// The digits that a literal has when its power of ten is written out, or more.
pub(crate) fn written_out(text: &str) -> usize {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let shift = exponent
        .parse::<i64>()
        .map_or(usize::MAX, |e| usize::try_from(e.unsigned_abs()).unwrap_or(usize::MAX));
    mantissa.len().saturating_sub(usize::from(mantissa.contains('.'))).saturating_add(shift)
}

/// A literal with its power of ten written out: `1.5e-3` as `0.0015`.
fn without_exponent(text: &str) -> Cow<'_, str> {
    let Some((mantissa, exponent)) = text.split_once(['e', 'E']) else {
        return Cow::Borrowed(text);
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let exponent = exponent.parse::<isize>().expect("the parser bounds the exponent");
    let places = fraction.len().cast_signed() - exponent;
    let Ok(places @ 1..) = usize::try_from(places) else {
        return Cow::Owned(digits + &"0".repeat(places.unsigned_abs()));
    };
    let digits = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    Cow::Owned(format!("{whole}.{fraction}"))
}

/// The value of a well-formed literal; the lexer has made sure that it is one.
///
/// The fraction is reduced here by twos and fives, the only factors of its denominator: a general
/// gcd of 10⁴ digits takes a hundred times as long.
pub(crate) fn parse_literal(text: &str) -> BigRational {
    let text = without_exponent(text);
    let (whole, fraction) = text.split_once('.').unwrap_or((&text, ""));
    let fraction = fraction.trim_end_matches('0');
    let digits = format!("{whole}{fraction}");
    let mut numer = digits.parse::<BigUint>().expect("the lexer lets only digits through");
    if fraction.is_empty() {
        return BigRational::from_integer(numer.into());
    }
    let places = fraction.len();
    // the last digit is not 0, so 2 and 5 do not both divide it
    let twos =
        usize::try_from(numer.trailing_zeros().unwrap_or(0)).unwrap_or(usize::MAX).min(places);
    numer >>= twos;
    let fives = strip_fives(&mut numer, places);
    let denom = power_of(5, places - fives) << (places - twos);
    BigRational::new_raw(numer.into(), denom.into())
}

fn power_of(base: u32, exponent: usize) -> BigUint {
    let exponent = u32::try_from(exponent).expect("literals have at most 10⁴ digits");
    BigUint::from(base).pow(exponent)
}

/// Divides `n` by the highest power of five, at most 5^`limit`, that divides it, and returns the exponent.
fn strip_fives(n: &mut BigUint, limit: usize) -> usize {
    let mut stripped = 0;
    let mut step = limit.next_power_of_two();
    while step > 0 {
        if stripped + step <= limit {
            let power = power_of(5, step);
            if power <= *n && (&*n % &power).is_zero() {
                *n /= power;
                stripped += step;
            }
        }
        step /= 2;
    }
    stripped
}

/// The magnitude of a number as a literal: `12`, `0.4`; `None` where it has no finite decimal
/// expansion, or one longer than a literal may be.
pub(crate) fn decimal(value: &BigRational) -> Option<String> {
    if value.is_integer() {
        return Some(value.numer().magnitude().to_string());
    }
    let mut odd = value.denom().magnitude().clone();
    let twos = usize::try_from(odd.trailing_zeros().unwrap_or(0)).ok()?;
    if twos > MAX_DIGITS {
        return None;
    }
    odd >>= twos;
    let fives = strip_fives(&mut odd, MAX_DIGITS);
    if !odd.is_one() {
        return None;
    }
    let places = twos.max(fives);
    let scaled =
        value.numer().magnitude() * power_of(2, places - twos) * power_of(5, places - fives);
    let digits = format!("{:0>width$}", scaled.to_string(), width = places + 1);
    if digits.len() > MAX_DIGITS {
        return None;
    }
    let (whole, fraction) = digits.split_at(digits.len() - places);
    Some(format!("{whole}.{fraction}"))
}

/// A rational number as an author writes it: `-(7/8)` as −(7/8), never as `-0.875`.
///
/// [`Expr::Num`] stands for a single literal and prints as a decimal where it can; this gives the
/// quotient of two integers instead.
#[must_use]
pub fn literal(value: &BigRational) -> Expr {
    let integer = |n: &BigInt| {
        Expr::Num(BigRational::from_integer(BigInt::from_biguint(
            Sign::Plus,
            n.magnitude().clone(),
        )))
    };
    let magnitude = if value.is_integer() {
        integer(value.numer())
    } else {
        Expr::Div(integer(value.numer()).into(), integer(value.denom()).into())
    };
    if value.is_negative() { Expr::Neg(magnitude.into()) } else { magnitude }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(n: i64, d: i64) -> BigRational {
        BigRational::new(n.into(), d.into())
    }

    #[test]
    fn decimals_are_exact_and_reduced() {
        for (text, n, d) in [
            ("0.4", 2, 5),
            ("12", 12, 1),
            ("0.000", 0, 1),
            ("1.250", 5, 4),
            ("00.5", 1, 2),
            ("0.0625", 1, 16),
            ("3.125", 25, 8),
            ("2.5", 5, 2),
            ("0.048", 6, 125),
            ("1e-3", 1, 1000),
            ("1E+3", 1000, 1),
            ("2.5e1", 25, 1),
            ("2.5e0", 5, 2),
            ("12.5e-2", 1, 8),
            ("0.25e1", 5, 2),
            ("0e9", 0, 1),
        ] {
            assert_eq!(parse_literal(text), ratio(n, d), "literal {text}");
        }
    }

    #[test]
    fn decimals_print_as_they_read() {
        for text in ["0.4", "12", "1.25", "0.0625", "0.048", "0"] {
            assert_eq!(decimal(&parse_literal(text)).as_deref(), Some(text));
        }
        assert_eq!(decimal(&ratio(1, 3)), None);
        assert_eq!(decimal(&BigRational::new(1.into(), BigInt::one() << 100_000)), None);
    }

    #[test]
    fn ten_thousand_digits_reduce_without_a_gcd() {
        let text = format!("0.{}5", "0".repeat(9_997));
        let value = parse_literal(&text);
        assert_eq!(decimal(&value), Some(text));
    }
}
