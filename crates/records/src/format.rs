//! In which format the numbers of a log were written.

use std::fmt;
use std::str::FromStr;

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
    /// Half a unit in the last place of what was computed with, by the value: 2^−53, or 2^−24.
    ///
    /// Numbers with no more than 6 decimals, or 7 digits, may come from binary32, which has 7 digits and a
    /// part of the eighth; longer ones would show it.
    #[must_use]
    pub const fn unit(self) -> f64 {
        match self {
            Self::Binary32 | Self::Decimals(..=6) | Self::Significant(..=7) => {
                f32::EPSILON as f64 / 2.0
            }
            _ => f64::EPSILON / 2.0,
        }
    }

    /// How far a number may be from its decimals, beside the error of its computation: half of the last one.
    #[must_use]
    pub fn step(self) -> Step {
        match self {
            Self::Binary64 | Self::Binary32 => Step::default(),
            Self::Decimals(decimals) => Step { absolute: half(decimals), digits: 0 },
            Self::Significant(digits) => Step { absolute: 0.0, digits },
        }
    }

    /// Its name in a flag, which [`FromStr`] reads.
    #[must_use]
    pub fn flag(self) -> String {
        match self {
            Self::Binary64 => "f64".to_owned(),
            Self::Binary32 => "f32".to_owned(),
            _ => self.name(),
        }
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            Self::Binary64 => "binary64".to_owned(),
            Self::Binary32 => "binary32".to_owned(),
            Self::Decimals(1) => "1 decimal".to_owned(),
            Self::Decimals(digits) => format!("{digits} decimals"),
            Self::Significant(1) => "1 digit".to_owned(),
            Self::Significant(digits) => format!("{digits} digits"),
        }
    }
}

/// Half of the last of so many decimals.
pub(crate) fn half(decimals: u8) -> f64 {
    0.5 * 10_f64.powi(-i32::from(decimals))
}

/// A format, and where numbers told it the most decimals that any of them has: none was printed with more, so that a
/// small one is off by as much as that whatever its digits are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Printed {
    /// the format
    pub format: Format,
    /// the most decimals
    pub decimals: Option<u8>,
}

impl Printed {
    /// How far a number may be from its decimals: by its digits or by the last decimal, whichever is more.
    #[must_use]
    pub fn step(self) -> Step {
        let step = self.format.step();
        match self.format {
            Format::Decimals(_) => step,
            _ => Step { absolute: self.decimals.map_or(0.0, half), ..step },
        }
    }
}

impl From<Format> for Printed {
    fn from(format: Format) -> Self {
        Self { format, decimals: None }
    }
}

/// What stands before the most decimals.
const TO: &str = " to ";

impl fmt::Display for Printed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.format.flag())?;
        self.decimals.map_or(Ok(()), |decimals| write!(f, "{TO}{decimals}"))
    }
}

impl FromStr for Printed {
    type Err = NoFormat;

    fn from_str(text: &str) -> Result<Self, NoFormat> {
        let Some((format, decimals)) = text.split_once(TO) else {
            return text.parse().map(Format::into);
        };
        let decimals = decimals.parse().map_err(|_| NoFormat(text.to_owned()))?;
        Ok(Self { format: format.parse()?, decimals: Some(decimals) })
    }
}

/// How far a number x may be from what was written of it: the greater of half a decimal and of half the last digit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Step {
    /// half of the last decimal, in the unit of the number
    pub absolute: f64,
    /// to how many digits it was rounded; 0 where that is not known
    pub digits: u8,
}

impl Step {
    /// Of a number. Half of the digit at 10^(k + 1 − digits), where 10^k ≤ |x| < 10^(k + 1).
    #[must_use]
    #[inline]
    pub fn of(self, value: f64) -> f64 {
        if self.digits == 0 || value == 0.0 {
            return self.absolute;
        }
        // a power of ten is in the decade above it, whatever the logarithm is rounded to
        let decade = (value.abs().log10() + 1e-12).floor() + 1.0;
        self.absolute.max(0.5 * 10_f64.powf(decade - f64::from(self.digits)))
    }
}

/// A text that names no [`Format`].
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("f32, f64, a count of decimals, `4 decimals` or `6 digits`, not `{0}`")]
pub struct NoFormat(pub(crate) String);

impl FromStr for Format {
    type Err = NoFormat;

    /// A format by its name for a flag: `f32`, `f64`, `4` or `4 decimals`, `6 digits`; of 17 digits at most.
    fn from_str(text: &str) -> Result<Self, NoFormat> {
        let (count, unit) = text.split_once(' ').unwrap_or((text, "decimals"));
        let count = count.parse().ok().filter(|count| (0..=17).contains(count));
        match (text, count, unit) {
            ("f32", ..) => Ok(Self::Binary32),
            ("f64", ..) => Ok(Self::Binary64),
            (_, Some(count), "decimals" | "decimal") => Ok(Self::Decimals(count)),
            (_, Some(count @ 1..), "digits" | "digit") => Ok(Self::Significant(count)),
            _ => Err(NoFormat(text.to_owned())),
        }
    }
}
