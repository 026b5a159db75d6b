//! Bounds in few digits: rounded to the side on which they still hold.
#![allow(clippy::float_arithmetic, reason = "numbers are rounded for display")]

use kane_number::{decode, parse};

/// Halvings of the way to the next number of few digits.
const HALVINGS: u32 = 24;

/// A bound from above as `shown` tells numbers, rounded up: what is told is no less than the bound.
/// `shown` rounds to nearest, to at least one digit.
pub fn at_most(bound: f64, shown: impl Fn(f64) -> String) -> String {
    one_sided(bound, shown, true)
}

/// A bound from below as `shown` tells numbers, rounded down: what is told is no more than the bound.
/// `shown` rounds to nearest, to at least one digit.
pub fn at_least(bound: f64, shown: impl Fn(f64) -> String) -> String {
    one_sided(bound, shown, false)
}

fn one_sided(bound: f64, shown: impl Fn(f64) -> String, up: bool) -> String {
    let Ok(exact) = decode(bound) else { return shown(bound) };
    let holds =
        |text: &str| parse(text).is_ok_and(|told| if up { told >= exact } else { told <= exact });
    let nearest = shown(bound);
    if holds(&nearest) {
        return nearest;
    }
    // the least number beyond the bound that is told as one beyond it
    let (mut near, mut far) = (0.0, 1.0);
    let beyond = |share: f64| {
        let step = share * bound.abs();
        shown(if up { bound + step } else { bound - step })
    };
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(near, far);
        *(if holds(&beyond(middle)) { &mut far } else { &mut near }) = middle;
    }
    beyond(far)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn brief(x: f64) -> String {
        format!("{x:.1e}")
    }

    #[test]
    fn a_bound_from_above_is_told_as_no_less_and_one_from_below_as_no_more() {
        let cases = [
            (4.440_892_098_500_626e-15, "4.5e-15", "4.4e-15"),
            (7.105_427_357_601_002e-15, "7.2e-15", "7.1e-15"),
            (1.776_356_839_400_250_5e-15, "1.8e-15", "1.7e-15"),
            (9.91e-8, "1.0e-7", "9.9e-8"),
            (1.001e-7, "1.1e-7", "1.0e-7"),
            (0.5, "5.0e-1", "5.0e-1"),
            (0.0, "0.0e0", "0.0e0"),
        ];
        for (bound, up, down) in cases {
            assert_eq!(at_most(bound, brief), up, "{bound}");
            assert_eq!(at_least(bound, brief), down, "{bound}");
        }
    }

    #[test]
    fn a_bound_has_the_digits_that_other_numbers_have() {
        let thousandths = |x: f64| format!("{x:.3}");
        assert_eq!(at_most(0.049_864, thousandths), "0.050");
        assert_eq!(at_least(0.049_864, thousandths), "0.049");
        assert_eq!(at_most(542.000_1, |x| format!("{x:.0}")), "543");
    }

    #[test]
    fn what_is_no_number_is_told_as_it_is() {
        assert_eq!(at_most(f64::INFINITY, |x| format!("{x}")), "inf");
        assert_eq!(at_least(f64::NAN, |x| format!("{x}")), "NaN");
    }
}
