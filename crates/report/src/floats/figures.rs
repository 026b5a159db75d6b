//! Bounds and errors in few digits: bounds never below, errors never above what they are.
#![allow(clippy::float_arithmetic, reason = "numbers are rounded for display")]

use kane_floats::Precision;

/// A bound in three digits, rounded up.
pub(super) fn at_most(x: f64) -> String {
    shown(x, true)
}

/// An error in three digits, rounded down.
pub(super) fn at_least(x: f64) -> String {
    shown(x, false)
}

/// Three digits, rounded in a direction: the exact value of the decimal is compared with that of the float.
fn shown(x: f64, up: bool) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    if !x.is_finite() {
        return "infinite".to_owned();
    }
    let text = format!("{x:.2e}");
    let exact = kane_number::decode(x);
    let is_enough = |text: &str| match (kane_number::parse(text), &exact) {
        (Ok(shown), Ok(exact)) => {
            if up {
                shown >= *exact
            } else {
                shown <= *exact
            }
        }
        _ => false,
    };
    if is_enough(&text) {
        return text;
    }
    // one more in the last digit, in the direction
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let digits: i32 = mantissa.replace('.', "").parse().unwrap_or(100);
    let (digits, exponent) = match (if up { digits + 1 } else { digits - 1 }, exponent) {
        (1000, exponent) => (100, exponent + 1),
        (99, exponent) => (999, exponent - 1),
        other => other,
    };
    format!("{}.{:02}e{exponent}", digits / 100, digits % 100)
}

fn bits(ulps: f64, precision: Precision) -> f64 {
    ulps.log2().clamp(0.0, f64::from(precision.bits()))
}

/// Bits lost at most, in tenths, rounded up.
pub(crate) fn bits_at_most(ulps: f64, precision: Precision) -> String {
    tenths((ulps.log2() * 10.0 + LOGARITHM).ceil(), precision)
}

/// Bits lost at least, in tenths, rounded down.
pub(super) fn bits_at_least(ulps: f64, precision: Precision) -> String {
    tenths((ulps.log2() * 10.0 - LOGARITHM).floor(), precision)
}

/// By how much ten times a logarithm is off at most.
const LOGARITHM: f64 = 1e-9;

/// Whole tenths of a bit, within what a format has.
fn tenths(tenths: f64, precision: Precision) -> String {
    let all = f64::from(precision.bits());
    let bits = (tenths / 10.0).max(0.0);
    if bits >= all { "all".to_owned() } else { format!("{bits:.1}") }
}

/// The shortest decimal that names a float of a format.
#[allow(clippy::cast_possible_truncation, reason = "floats of f32 are held as f64")]
pub(super) fn shortest(x: f64, precision: Precision) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    match precision {
        Precision::F32 => format!("{:e}", x as f32),
        Precision::F64 => format!("{x:e}"),
    }
}

/// How many times the error that was found the bound is.
pub(super) fn ratio(bound: f64, found: f64) -> String {
    if !bound.is_finite() {
        String::new()
    } else if bound == 0.0 {
        "1".to_owned()
    } else if found == 0.0 {
        "found 0".to_owned()
    } else if bound / found < 1000.0 {
        format!("{:.2}", bound / found)
    } else {
        format!("{:.1e}", bound / found)
    }
}

/// By how many bits a bound exceeds what was found.
pub(super) fn bits_apart(bound: f64, found: f64, precision: Precision) -> String {
    format!("{:.1}", (bits(bound, precision) - bits(found, precision)).max(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_rounded_up_and_errors_down() {
        assert_eq!((at_most(1.0), at_least(1.0)), ("1.00e0".to_owned(), "1.00e0".to_owned()));
        assert_eq!((at_most(0.1), at_least(0.1)), ("1.01e-1".to_owned(), "1.00e-1".to_owned()));
        assert_eq!(at_most(9.999), "1.00e1");
        assert_eq!(at_least(9.9999), "9.99e0");
        assert_eq!(at_least(1.0_f64.next_down()), "9.99e-1");
        assert_eq!((at_most(0.0), at_most(f64::INFINITY)), ("0".to_owned(), "infinite".to_owned()));
        assert_eq!(bits_at_most(2.1, Precision::F64), "1.1");
        assert_eq!(bits_at_least(2.1, Precision::F64), "1.0");
        assert_eq!(bits_at_least(1e300, Precision::F64), "all");
        assert_eq!(bits_at_most(0.5, Precision::F32), "0.0");
    }

    #[test]
    fn a_bound_is_told_as_so_many_times_what_was_found() {
        assert_eq!(ratio(f64::INFINITY, 1.0), "");
        assert_eq!([ratio(0.0, 0.0), ratio(1.0, 0.0)], ["1", "found 0"]);
        assert_eq!([ratio(3.0, 2.0), ratio(500.0, 3.0)], ["1.50", "166.67"]);
        // the logarithm of a power of two may be off by as much as any
        assert_eq!(bits_at_most(2.0, Precision::F64), "1.1");
        assert_eq!(bits_at_least(2.0, Precision::F64), "0.9");
        assert_eq!([ratio(999.5, 1.0), ratio(1000.0, 1.0)], ["999.50", "1.0e3"]);
        let apart = |bound, found| bits_apart(bound, found, Precision::F32);
        assert_eq!([apart(8.0, 2.0), apart(2.0, 8.0), apart(8.0, 0.5)], ["2.0", "0.0", "3.0"]);
        // no more than there are
        assert_eq!(apart(f64::INFINITY, 1.0), "24.0");
    }

    #[test]
    fn the_shortest_decimal_of_a_float_names_it_in_its_format() {
        for precision in [Precision::F32, Precision::F64] {
            assert_eq!([0.0, 0.5, 3.0].map(|x| shortest(x, precision)), ["0", "5e-1", "3e0"]);
        }
        let tenth = f64::from(0.1_f32);
        assert_eq!(shortest(tenth, Precision::F32), "1e-1");
        assert_eq!(shortest(tenth, Precision::F64), "1.0000000149011612e-1");
    }

    #[test]
    fn a_carry_goes_on_to_the_next_power_of_ten() {
        // in both directions, next to 10 and next to 1
        assert_eq!(at_most(9.995_000_1), "1.00e1");
        assert_eq!(at_most(9.990_000_1), "1.00e1");
        assert_eq!(at_least(0.999_999), "9.99e-1");
        assert_eq!((at_most(1.2345e-7), at_least(1.2345e-7)), ("1.24e-7".into(), "1.23e-7".into()));
        assert_eq!((at_most(1.2399e7), at_least(1.2399e7)), ("1.24e7".into(), "1.23e7".into()));
    }
}
