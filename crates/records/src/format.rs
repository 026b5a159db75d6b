//! In which format the numbers of a log were written.

use std::collections::BTreeSet;
use std::ops::RangeInclusive;

use crate::row::Row;
use crate::schema::{Axis, Column, Side, When};

/// The format of the velocities after the impact, which are what was computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Format {
    /// Binary floats of 53 bits.
    Binary64,
    /// Binary floats of 24 bits, printed exactly or by their shortest decimals.
    Binary32,
    /// Decimals with this many digits after the point.
    Decimals(u8),
    /// Decimals with this many digits in all.
    Significant(u8),
}

impl Format {
    /// Half a unit in the last place, by the value: the greatest relative rounding error.
    ///
    /// 2^−53, 2^−24, and 10^(1−d)/2 for d significant digits. Decimals after the point have an
    /// [`absolute`](Self::absolute) error beside that of binary64.
    #[must_use]
    pub fn relative(self) -> f64 {
        match self {
            Self::Binary64 | Self::Decimals(_) => f64::EPSILON / 2.0,
            Self::Binary32 => f64::from(f32::EPSILON) / 2.0,
            Self::Significant(digits) => 0.5 * 10_f64.powi(1 - i32::from(digits)),
        }
    }

    /// Half a unit of the last decimal: the greatest absolute rounding error.
    #[must_use]
    pub fn absolute(self) -> f64 {
        match self {
            Self::Decimals(digits) => 0.5 * 10_f64.powi(-i32::from(digits)),
            _ => 0.0,
        }
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            Self::Binary64 => "binary64".to_owned(),
            Self::Binary32 => "binary32".to_owned(),
            Self::Decimals(digits) => format!("{digits} decimals"),
            Self::Significant(digits) => format!("{digits} digits"),
        }
    }

    /// The format of these rows, as far as their numbers tell it. What cannot be told is taken for
    /// binary64, which asks most.
    ///
    /// A number of 16 digits or more in its shortest form is a binary64, unless all are binary32
    /// numbers printed exactly. Shorter ones are binary32 if all are the shortest decimals of such
    /// and some need 8 digits; otherwise decimals, if there are many, or some of six digits or more, and
    /// they are no small binary fractions.
    #[must_use]
    pub fn of(rows: &[Row]) -> Self {
        let mut values = BTreeSet::new();
        for row in rows {
            for side in [Side::First, Side::Second] {
                let columns = [
                    Column::Velocity(side, Axis::X, When::Post),
                    Column::Velocity(side, Axis::Y, When::Post),
                    Column::Spin(side, Axis::Z, When::Post),
                ];
                let found = columns.into_iter().filter_map(|column| row.get(column));
                values.extend(found.filter(|value| *value != 0.0).map(f64::to_bits));
            }
        }
        let values: Vec<f64> = values.into_iter().map(f64::from_bits).collect();
        Self::of_values(&values)
    }

    fn of_values(values: &[f64]) -> Self {
        let written: Vec<Written> = values.iter().map(|value| Written::of(*value)).collect();
        let digits = written.iter().map(|written| written.digits).max().unwrap_or(0);
        let decimals = written.iter().map(|written| written.decimals).max().unwrap_or(0);
        let odd = written.iter().filter(|written| !written.short_binary).count();
        let singles = written.iter().all(|written| written.single);
        let exact_singles = written.iter().all(|written| written.exact_single);
        let few = odd < MOST_CHANCE;
        if odd == 0 || few && !exact_singles && !ROUNDED.contains(&digits) {
            return Self::Binary64;
        }
        match digits {
            _ if exact_singles => Self::Binary32,
            8..=9 if singles => Self::Binary32,
            // few numbers of 24 bits may do without the eighth digit
            7 if singles && few => Self::Binary32,
            ..16 if decimals <= 9 => Self::Decimals(decimals),
            ..16 => Self::Significant(digits),
            _ => Self::Binary64,
        }
    }
}

/// So many numbers look alike by chance.
const MOST_CHANCE: usize = 8;
/// With so many digits even one number was rounded to them: a binary64 has so few by chance once in 10 000 times,
/// and who writes down a number that is exact needs fewer.
const ROUNDED: RangeInclusive<u8> = 6..=12;

/// What the shortest decimals of a float tell.
struct Written {
    digits: u8,
    decimals: u8,
    /// a multiple of 2^−10, which every format holds
    short_binary: bool,
    exact_single: bool,
    single: bool,
}

impl Written {
    fn of(value: f64) -> Self {
        let text = format!("{value:e}");
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let digits = mantissa.bytes().filter(u8::is_ascii_digit).count();
        let digits = u8::try_from(digits).unwrap_or(u8::MAX);
        let exponent: i32 = exponent.parse().unwrap_or(0);
        let decimals = (i32::from(digits) - 1 - exponent).max(0);
        #[allow(clippy::cast_possible_truncation, reason = "to see what the shorter format holds")]
        let narrow = value as f32;
        let exact_single = f64::from(narrow).to_bits() == value.to_bits();
        // by its shortest decimals, or rounded to as many digits as stand there
        let places = usize::from(digits).saturating_sub(1);
        let decimals_of = [format!("{narrow:e}"), format!("{narrow:.places$e}")];
        let printed = |text: &String| text.parse().is_ok_and(|read: f64| read == value);
        let single = exact_single || decimals_of.iter().any(printed);
        Self {
            digits,
            decimals: u8::try_from(decimals).unwrap_or(u8::MAX),
            short_binary: (value * 1024.0).fract() == 0.0,
            exact_single,
            single,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn thirds() -> impl Iterator<Item = f64> {
        (1..40).map(|i| f64::from(i) / 3.1)
    }

    #[test]
    fn the_format_is_told_by_the_numbers() {
        let double: Vec<f64> = thirds().collect();
        assert_eq!(Format::of_values(&double), Format::Binary64);
        #[allow(clippy::cast_possible_truncation, reason = "the format in question")]
        let single: Vec<f64> = thirds().map(|x| f64::from(x as f32)).collect();
        assert_eq!(Format::of_values(&single), Format::Binary32);
        #[allow(clippy::cast_possible_truncation, reason = "the format in question")]
        let shortest: Vec<f64> =
            thirds().map(|x| (x as f32).to_string().parse().expect("a float")).collect();
        assert_eq!(Format::of_values(&shortest), Format::Binary32);
        #[allow(clippy::cast_possible_truncation, reason = "the format in question")]
        let nine: Vec<f64> =
            thirds().map(|x| format!("{:.8e}", x as f32).parse().expect("a float")).collect();
        assert_eq!(Format::of_values(&nine), Format::Binary32);
        let fixed: Vec<f64> =
            thirds().map(|x| format!("{x:.4}").parse().expect("a float")).collect();
        assert_eq!(Format::of_values(&fixed), Format::Decimals(4));
        let digits: Vec<f64> =
            thirds().map(|x| format!("{:.11e}", x * 1e-6).parse().expect("a float")).collect();
        assert_eq!(Format::of_values(&digits), Format::Significant(12));
    }

    #[test]
    fn numbers_that_every_format_holds_tell_nothing() {
        let halves: Vec<f64> = (1..100).map(|i| f64::from(i) / 4.0).collect();
        assert_eq!(Format::of_values(&halves), Format::Binary64);
        assert_eq!(Format::of_values(&[0.1, 0.3]), Format::Binary64);
    }

    #[test]
    fn one_number_tells_a_format_that_is_no_chance() {
        assert_eq!(Format::of_values(&[0.5, 0.33333334]), Format::Binary32);
        assert_eq!(Format::of_values(&[f64::from(0.1_f32)]), Format::Binary32);
        assert_eq!(Format::of_values(&[0.333_333]), Format::Decimals(6));
        assert_eq!(Format::of_values(&[1.0 / 3.0]), Format::Binary64);
    }
}
