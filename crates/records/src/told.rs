//! What the numbers of a log tell of their format, column by column.

use std::collections::BTreeSet;
use std::fmt;
use std::str::FromStr;

use crate::format::{Format, NoFormat};
use crate::row::Row;
use crate::schema::{Axis, Column, Side, When};

/// The format of a log's numbers, and of the columns that have another.
///
/// A number of 16 digits or more in its shortest form is a binary64, unless all are binary32 numbers printed
/// exactly. Shorter ones are binary32 if all are the shortest decimals of such and some need 8 digits, and
/// otherwise rounded: to digits if more of them have as many digits as any has, than have as many decimals as any
/// has, and to decimals if not. They may be binary64 as well, though, since what is computed from short decimals is
/// often a short one itself; each is so by chance, and only many are no chance. Before that there is doubt, and then
/// a check that holds within the one format and not within the other is
/// [undecided](crate::check::Verdict::Undecided). Multiples of 2^−10 tell nothing, since every format holds them, and
/// neither do numbers that an impact left as they were. Without a number that tells, the format is binary64, which
/// asks most.
///
/// A column has a format of its own where it has enough numbers that tell another, rounded one than all numbers
/// of the log do together, and two in three of them are as long as any: rounding leaves a zero at the end of one in
/// ten. Products of short decimals vary more in their length.
///
/// As text it is `f64`, `f32`, `6 decimals` or `6 digits`, ` or f64` behind it where that is as likely, and behind
/// that the columns with a format of their own, `, omega1_post_rad_s 3 decimals`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Told {
    /// the format in which the numbers seem to be
    pub format: Format,
    /// the stricter one in which they may be as well, in all columns
    pub or: Option<Format>,
    /// the formats of columns that seem to have their own
    pub own: Own,
}

/// For each body the formats of v_x, v_y, v_z, ω_x, ω_y and ω_z that are not the log's.
pub type Own = [[Option<Format>; 6]; 2];

/// Bodies and columns in the order of [`Own`].
const SIDES: [Side; 2] = [Side::First, Side::Second];

/// The columns of a body's motion at a time, in the order of [`Own`].
#[must_use]
pub(crate) const fn motion(side: Side, when: When) -> [Column; 6] {
    [
        Column::Velocity(side, Axis::X, when),
        Column::Velocity(side, Axis::Y, when),
        Column::Velocity(side, Axis::Z, when),
        Column::Spin(side, Axis::X, when),
        Column::Spin(side, Axis::Y, when),
        Column::Spin(side, Axis::Z, when),
    ]
}

impl Told {
    /// A format that is known, of all columns.
    #[must_use]
    pub const fn stated(format: Format) -> Self {
        Self { format, or: None, own: [[None; 6]; 2] }
    }

    /// By the velocities after the impact in these rows, which are what was computed.
    #[must_use]
    pub fn of(rows: &[Row]) -> Self {
        let columns = SIDES.map(|side| {
            let [before, after] = [When::Pre, When::Post].map(|when| motion(side, when));
            [0, 1, 2, 3, 4, 5].map(|place: usize| changed(rows, before[place], after[place]))
        });
        let all: BTreeSet<u64> = columns.iter().flatten().flatten().copied().collect();
        let mut told = Self::of_values(&all);
        let whole = told.format;
        for (own, values) in told.own.iter_mut().flatten().zip(columns.iter().flatten()) {
            let numbers = Numbers::of(values);
            *own = numbers.rounded().filter(|format| *format != whole);
            if own.is_some() && numbers.odd < SHORT {
                told.or = told.or.or(Some(whole));
            }
        }
        told
    }

    fn of_values(values: &BTreeSet<u64>) -> Self {
        let numbers = Numbers::of(values);
        if numbers.odd == 0 {
            return Self::stated(Format::Binary64);
        }
        // few numbers of 24 bits may do without the eighth digit
        let long = numbers.all.iter().filter(|number| number.digits >= 8).count();
        let (enough, singles) = (numbers.odd >= SHORT, numbers.are_singles());
        let (format, no_chance) = match numbers.digits {
            _ if numbers.all.iter().all(|number| number.exact_single) => {
                (Format::Binary32, numbers.odd >= SINGLES)
            }
            8..=9 if singles && long >= SINGLES => (Format::Binary32, true),
            8..=9 if singles && !(enough && numbers.are_even()) => (Format::Binary32, false),
            7 if singles && numbers.odd < SINGLES => (Format::Binary32, false),
            ..16 => (numbers.decimal(), enough),
            _ => (Format::Binary64, true),
        };
        Self { or: (!no_chance).then_some(Format::Binary64), ..Self::stated(format) }
    }

    /// The columns with a format of their own.
    pub fn columns(&self) -> impl Iterator<Item = (Column, Format)> {
        let columns = SIDES.map(|side| motion(side, When::Post)).into_iter().flatten();
        columns.zip(self.own.into_iter().flatten()).filter_map(|(column, own)| Some((column, own?)))
    }
}

/// The numbers of a column that an impact changed, as bits.
fn changed(rows: &[Row], before: Column, after: Column) -> BTreeSet<u64> {
    let value = |row: &Row| row.get(after).filter(|after| Some(*after) != row.get(before));
    rows.iter().filter_map(value).map(f64::to_bits).collect()
}

/// Different numbers, by their shortest decimals.
struct Numbers {
    all: Vec<Digits>,
    /// those that tell something
    odd: usize,
    /// the most digits
    digits: u8,
    /// the most decimals
    decimals: u8,
    /// how many of those that tell something have so many digits, and so many decimals
    longest: [usize; 2],
}

impl Numbers {
    fn of(values: &BTreeSet<u64>) -> Self {
        let all: Vec<Digits> =
            values.iter().map(|bits| Digits::of(f64::from_bits(*bits))).collect();
        let digits = all.iter().map(|number| number.digits).max().unwrap_or(0);
        let decimals = all.iter().map(|number| number.decimals).max().unwrap_or(0);
        let odd = || all.iter().filter(|number| !number.short_binary);
        let longest = [
            odd().filter(|number| number.digits == digits).count(),
            odd().filter(|number| number.decimals == decimals).count(),
        ];
        Self { odd: odd().count(), digits, decimals, longest, all }
    }

    /// Whether all may be binary32.
    fn are_singles(&self) -> bool {
        self.all.iter().all(|number| number.single)
    }

    /// Whether two in three are as long as any.
    fn are_even(&self) -> bool {
        3 * self.longest[0].max(self.longest[1]) >= 2 * self.odd
    }

    /// To what they were rounded, if they were.
    fn decimal(&self) -> Format {
        let [by_digits, by_decimals] = self.longest;
        if by_digits > by_decimals || self.decimals > 9 {
            Format::Significant(self.digits)
        } else {
            Format::Decimals(self.decimals)
        }
    }

    /// To what those of a column were rounded, if there are enough that look so.
    fn rounded(&self) -> Option<Format> {
        let short = self.digits < 8 || self.digits < 16 && !self.are_singles();
        (self.odd >= SOME && short && self.are_even()).then(|| self.decimal())
    }
}

impl From<Format> for Told {
    fn from(format: Format) -> Self {
        Self::stated(format)
    }
}

impl fmt::Display for Told {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.format.flag())?;
        if let Some(or) = self.or {
            write!(f, "{OR}{}", or.flag())?;
        }
        self.columns().try_for_each(|(column, own)| write!(f, ", {} {}", column.name(), own.flag()))
    }
}

impl FromStr for Told {
    type Err = NoFormat;

    fn from_str(text: &str) -> Result<Self, NoFormat> {
        let mut parts = text.split(',').map(str::trim);
        let all = parts.next().unwrap_or_default();
        let mut told = match all.split_once(OR) {
            Some((format, or)) => Self { or: Some(or.parse()?), ..Self::stated(format.parse()?) },
            None => Self::stated(all.parse()?),
        };
        for part in parts {
            let wrong = || NoFormat(part.to_owned());
            let (name, format) = part.split_once(' ').ok_or_else(wrong)?;
            let columns = SIDES.map(|side| motion(side, When::Post));
            let named = columns.into_iter().flatten().position(|column| column.name() == name);
            let own = named.and_then(|place| told.own.as_flattened_mut().get_mut(place));
            *own.ok_or_else(wrong)? = Some(format.parse()?);
        }
        Ok(told)
    }
}

/// What stands before a format that is as likely.
const OR: &str = " or ";

/// So many numbers are no binary64 by chance, where each is a binary32, printed exactly or in eight digits or more: of
/// what a binary64 is for short decimals, less than half has 15 digits or fewer, and of such with eight digits less than
/// half are those of a binary32.
const SINGLES: usize = 8;
/// So many numbers are no binary64 by chance, where each has 15 digits or fewer: of sums of products of short decimals
/// less than half have, and of single products some two in three.
const SHORT: usize = 24;
/// So many in a column are a chance of one in 25, by the same.
const SOME: usize = 8;

/// What the shortest decimals of a float tell.
struct Digits {
    digits: u8,
    decimals: u8,
    /// a multiple of 2^−10, which every format holds
    short_binary: bool,
    exact_single: bool,
    single: bool,
}

impl Digits {
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
        let told = all(values);
        assert_eq!(told.or, None, "{values:?}");
        told.format
    }

    fn all(values: &[f64]) -> Told {
        Told::of_values(&values.iter().map(|value| value.to_bits()).collect())
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
            let or = Some(Format::Binary64);
            assert_eq!(all(values), Told { or, ..Told::stated(format) }, "{values:?}");
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
