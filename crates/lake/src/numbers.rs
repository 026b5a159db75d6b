//! In which format the numbers of a log are, as a word in a query.

use std::fmt;
use std::str::FromStr;

use kane_records::told::Told;
use kane_records::tolerance::{EXTENT, Precision};

/// The format of a log's numbers and the size of its world, from which tolerances follow.
///
/// As text it is that of [`Told`], and `, extent N` behind it where the world is not of a thousand arms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Numbers {
    /// the format, that of columns with their own, and what it may be as well
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
        write!(f, "{}", self.told)?;
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
        let (told, extent) = match text.rsplit_once(", extent") {
            None => (text, EXTENT),
            Some((told, extent)) => (told, extent.trim().parse().map_err(|_| wrong())?),
        };
        if !(0.0..=1e12).contains(&extent) {
            return Err(wrong());
        }
        Ok(Self { told: told.parse().map_err(|_| wrong())?, extent })
    }
}

#[cfg(test)]
mod tests {
    use kane_records::format::Format;
    use kane_records::schema::{Axis, Column, Side, When};

    use super::*;

    #[test]
    fn a_format_is_read_as_it_is_written() {
        for format in
            [Format::Binary64, Format::Binary32, Format::Decimals(4), Format::Significant(6)]
        {
            for (extent, or, own) in [
                (EXTENT, None, None),
                (0.0, Some(Format::Binary64), Some(Format::Decimals(3))),
                (1e6, None, Some(Format::Significant(5))),
                (EXTENT, Some(Format::Decimals(9)), None),
            ] {
                let mut told = Told { or, ..Told::stated(format) };
                told.own[Column::Spin(Side::Second, Axis::Z, When::Post).index()] =
                    own.map(Into::into);
                told.decimals = or.map(|_| 9);
                let numbers = Numbers { told, extent };
                assert_eq!(numbers.to_string().parse(), Ok(numbers));
            }
        }
        for wrong in ["", "f16", "18", "f32, 10", "f64, extent -1", "x digits"] {
            assert!(wrong.parse::<Numbers>().is_err(), "{wrong}");
        }
    }
}
