//! Numbers of FPCore, exactly.

use kane_number::{Integer, MAX_EXPONENT, Rational};

/// The exact value of a number: integers, decimals with or without exponent, fractions, hexadecimals
/// as `0x1.8p3`. `None` if this is none; `Some(Err)` if it begins like one and is none.
pub(super) fn literal(text: &str) -> Option<Result<Rational, String>> {
    let digits = text.trim_start_matches(['+', '-']);
    let begins = |c: char| c.is_ascii_digit() || c == '.';
    if !digits.starts_with(begins) || digits == "." {
        return None;
    }
    if let Some(hexadecimal) = digits.strip_prefix("0x") {
        let value = self::hexadecimal(hexadecimal);
        let value = value.map(|value| if text.starts_with('-') { -value } else { value });
        return Some(value.ok_or_else(|| "this is no hexadecimal number".to_owned()));
    }
    Some(kane_number::parse(text).map_err(|error| error.to_string()))
}

fn hexadecimal(text: &str) -> Option<Rational> {
    let (digits, exponent) = text.split_once(['p', 'P']).unwrap_or((text, "0"));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    if whole.len() + fraction.len() > 10_000 || whole.len() + fraction.len() == 0 {
        return None;
    }
    let all = format!("{whole}{fraction}");
    if !all.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return None;
    }
    let mantissa = Integer::parse_bytes(all.as_bytes(), 16)?;
    let exponent: i64 = exponent.parse().ok()?;
    if exponent.unsigned_abs() > u64::from(MAX_EXPONENT) {
        return None;
    }
    let exponent = exponent - 4 * i64::try_from(fraction.len()).ok()?;
    let power = Integer::from(1) << exponent.unsigned_abs();
    Some(if exponent >= 0 {
        Rational::from_integer(mantissa * power)
    } else {
        Rational::new(mantissa, power)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_notation_of_a_number_is_exact() {
        let value = |text: &str| literal(text).unwrap().unwrap().to_string();
        assert_eq!(value("0x1.8p3"), "12");
        assert_eq!(value("-0x.8p-1"), "-1/4");
        assert_eq!(value("1e-3"), "1/1000");
        assert_eq!(value("-2.50"), "-5/2");
        assert_eq!(value("1/3"), "1/3");
        assert!(literal("x1").is_none());
        assert!(literal("-").is_none());
        assert!(literal("1/0").unwrap().is_err());
        assert!(literal("0xg").unwrap().is_err());
        assert!(literal("1x").unwrap().is_err());
    }
}
