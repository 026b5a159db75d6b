//! In which format the numbers of a log are, as a word in a query.

use std::fmt;
use std::str::FromStr;

use kane_records::format::{Format, Told};
use kane_records::tolerance::{EXTENT, Precision};

/// The format of a log's numbers and the size of its world, from which tolerances follow.
///
/// As text it is `f64`, `f32`, `4 decimals` or `6 digits`, ` or f64` behind it where that is as likely, and
/// `, extent N` behind it where the world is not of a thousand arms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Numbers {
    /// the format, and whether it may be binary64 as well
    pub told: Told,
    /// how large the world is, in arms
    pub extent: f64,
}

/// A text that is no [`Numbers`].
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{0}` is no format of numbers: f64, f32, `4 decimals` or `6 digits`, and perhaps `, extent 1000`"
)]
pub struct NoNumbers(String);

/// What stands behind a format that is in doubt.
const OR_DOUBLE: &str = " or f64";

impl Numbers {
    /// Of what is told of a format, in a world of a thousand arms.
    #[must_use]
    pub const fn new(told: Told) -> Self {
        Self { told, extent: EXTENT }
    }

    /// What tolerances are made from.
    #[must_use]
    pub fn precision(self) -> Precision {
        Precision::told(self.told, self.extent)
    }
}

impl fmt::Display for Numbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.told.format {
            Format::Binary64 => f.write_str("f64")?,
            Format::Binary32 => f.write_str("f32")?,
            Format::Decimals(count) => write!(f, "{count} decimals")?,
            Format::Significant(count) => write!(f, "{count} digits")?,
        }
        if self.told.doubt {
            f.write_str(OR_DOUBLE)?;
        }
        if self.extent.to_bits() == EXTENT.to_bits() {
            Ok(())
        } else {
            write!(f, ", extent {}", self.extent)
        }
    }
}

impl FromStr for Numbers {
    type Err = NoNumbers;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let wrong = || NoNumbers(text.to_owned());
        let (format, extent) = match text.split_once(',') {
            None => (text, EXTENT),
            Some((format, extent)) => {
                let extent = extent.trim().strip_prefix("extent").ok_or_else(wrong)?;
                (format, extent.trim().parse().map_err(|_| wrong())?)
            }
        };
        if !(0.0..=1e12).contains(&extent) {
            return Err(wrong());
        }
        let format = format.trim();
        let doubtful = format.strip_suffix(OR_DOUBLE);
        let format = doubtful.unwrap_or(format).parse().map_err(|_| wrong())?;
        Ok(Self { told: Told { format, doubt: doubtful.is_some() }, extent })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_format_is_read_as_it_is_written() {
        for format in
            [Format::Binary64, Format::Binary32, Format::Decimals(4), Format::Significant(6)]
        {
            for (extent, doubt) in [(EXTENT, false), (0.0, true), (1e6, false), (EXTENT, true)] {
                let numbers = Numbers { told: Told { format, doubt }, extent };
                assert_eq!(numbers.to_string().parse(), Ok(numbers));
            }
        }
        for wrong in ["", "f16", "16", "f32, 10", "f64, extent -1", "x digits"] {
            assert!(wrong.parse::<Numbers>().is_err(), "{wrong}");
        }
    }
}
