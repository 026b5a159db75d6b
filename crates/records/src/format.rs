//! In which format the numbers of a log were written.

use std::collections::BTreeSet;
use std::str::FromStr;

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
}

/// A text that names no [`Format`].
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("f32, f64, a count of decimals, `4 decimals` or `6 digits`, not `{0}`")]
pub struct NoFormat(String);

impl FromStr for Format {
    type Err = NoFormat;

    /// A format by its name for a flag: `f32`, `f64`, `4` or `4 decimals`, `6 digits`; of 15 digits at most.
    fn from_str(text: &str) -> Result<Self, NoFormat> {
        let (count, unit) = text.split_once(' ').unwrap_or((text, "decimals"));
        let count = count.parse().ok().filter(|count| (0..=15).contains(count));
        match (text, count, unit) {
            ("f32", ..) => Ok(Self::Binary32),
            ("f64", ..) => Ok(Self::Binary64),
            (_, Some(count), "decimals") => Ok(Self::Decimals(count)),
            (_, Some(count @ 1..), "digits") => Ok(Self::Significant(count)),
            _ => Err(NoFormat(text.to_owned())),
        }
    }
}

/// What the numbers of a log tell of their format.
///
/// A number of 16 digits or more in its shortest form is a binary64, unless all are binary32 numbers printed
/// exactly. Shorter ones are binary32 if all are the shortest decimals of such and some need 8 digits, and decimals
/// otherwise. They may be binary64 as well, though, since what is computed from short decimals is often a short one
/// itself; each is so by chance, and only many are no chance. Before that there is doubt, and then a check that
/// holds within the one format and not within the other is [undecided](crate::check::Verdict::Undecided).
/// Multiples of 2^−10 tell nothing, since every format holds them, and neither do numbers that an impact left as
/// they were. Without a number that tells, the format is binary64, which asks most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Told {
    /// the format in which the numbers seem to be
    pub format: Format,
    /// whether they may as well be binary64
    pub doubt: bool,
}

impl Told {
    /// A format that is known.
    #[must_use]
    pub const fn stated(format: Format) -> Self {
        Self { format, doubt: false }
    }

    /// By the velocities after the impact in these rows, which are what was computed.
    #[must_use]
    pub fn of(rows: &[Row]) -> Self {
        let mut values = BTreeSet::new();
        for row in rows {
            for side in [Side::First, Side::Second] {
                let columns = [
                    |side, when| Column::Velocity(side, Axis::X, when),
                    |side, when| Column::Velocity(side, Axis::Y, when),
                    |side, when| Column::Spin(side, Axis::Z, when),
                ];
                for column in columns {
                    let [before, after] =
                        [When::Pre, When::Post].map(|when| row.get(column(side, when)));
                    values.extend(after.filter(|_| after != before).map(f64::to_bits));
                }
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
        if odd == 0 {
            return Self::stated(Format::Binary64);
        }
        // few numbers of 24 bits may do without the eighth digit
        let long = written.iter().filter(|written| written.digits >= 8).count();
        let (format, no_chance) = match digits {
            _ if exact_singles => (Format::Binary32, odd >= SINGLES),
            8..=9 if singles => (Format::Binary32, long >= SINGLES),
            7 if singles && odd < SINGLES => (Format::Binary32, false),
            ..16 if decimals <= 9 => (Format::Decimals(decimals), odd >= SHORT),
            ..16 => (Format::Significant(digits), odd >= SHORT),
            _ => (Format::Binary64, true),
        };
        Self { format, doubt: !no_chance }
    }
}

/// So many numbers are no binary64 by chance, where each is a binary32, printed exactly or in eight digits or more: of
/// what a binary64 is for short decimals, less than half has 15 digits or fewer, and of such with eight digits less than
/// half are those of a binary32.
const SINGLES: usize = 8;
/// So many numbers are no binary64 by chance, where each has 15 digits or fewer: of sums of products of short decimals
/// less than half have, and of single products some two in three.
const SHORT: usize = 24;

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

    /// The format that is told beyond doubt.
    fn told(values: &[f64]) -> Format {
        let told = Told::of_values(values);
        assert!(!told.doubt, "{values:?}");
        told.format
    }

    fn thirds() -> impl Iterator<Item = f64> {
        (1..40).map(|i| f64::from(i) / 3.1)
    }

    #[test]
    fn the_format_is_told_by_the_numbers() {
        let double: Vec<f64> = thirds().collect();
        assert_eq!(told(&double), Format::Binary64);
        #[allow(clippy::cast_possible_truncation, reason = "the format in question")]
        let single: Vec<f64> = thirds().map(|x| f64::from(x as f32)).collect();
        assert_eq!(told(&single), Format::Binary32);
        #[allow(clippy::cast_possible_truncation, reason = "the format in question")]
        let shortest: Vec<f64> =
            thirds().map(|x| (x as f32).to_string().parse().expect("a float")).collect();
        assert_eq!(told(&shortest), Format::Binary32);
        #[allow(clippy::cast_possible_truncation, reason = "the format in question")]
        let nine: Vec<f64> =
            thirds().map(|x| format!("{:.8e}", x as f32).parse().expect("a float")).collect();
        assert_eq!(told(&nine), Format::Binary32);
        let fixed: Vec<f64> =
            thirds().map(|x| format!("{x:.4}").parse().expect("a float")).collect();
        assert_eq!(told(&fixed), Format::Decimals(4));
        let digits: Vec<f64> =
            thirds().map(|x| format!("{:.11e}", x * 1e-6).parse().expect("a float")).collect();
        assert_eq!(told(&digits), Format::Significant(12));
    }

    #[test]
    fn numbers_that_every_format_holds_tell_nothing() {
        let halves: Vec<f64> = (1..100).map(|i| f64::from(i) / 4.0).collect();
        assert_eq!(told(&halves), Format::Binary64);
    }

    #[test]
    fn few_short_numbers_leave_a_doubt_and_many_do_not() {
        let doubtful = |values: &[f64], format| {
            assert_eq!(Told::of_values(values), Told { format, doubt: true }, "{values:?}");
        };
        doubtful(&[0.5, 0.33333334], Format::Binary32);
        doubtful(&[f64::from(0.1_f32)], Format::Binary32);
        doubtful(&[0.333_333], Format::Decimals(6));
        doubtful(&[0.5, 1.625, 0.500_000_001], Format::Decimals(9));
        doubtful(&[0.1, 0.3], Format::Decimals(1));
        let rounded: Vec<f64> =
            thirds().map(|x| format!("{x:.3}").parse().expect("a float")).collect();
        doubtful(&rounded[..20], Format::Decimals(3));
        assert_eq!(told(&rounded), Format::Decimals(3));
        // one number with all its digits ends the doubt
        assert_eq!(told(&[0.1, 0.333_333, 1.0 / 3.0]), Format::Binary64);
    }
}
