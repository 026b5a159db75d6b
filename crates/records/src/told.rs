//! What the numbers of a log tell of their format, column by column.

use std::collections::BTreeSet;
use std::fmt;
use std::str::FromStr;

use crate::digits::{Numbers, SHORT};
use crate::format::{Format, NoFormat, Printed};
use crate::row::Row;
use crate::schema::{Axis, COLUMNS, Column, Side, When};

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
/// ten. Products of short decimals vary more in their length. Masses, arms, normals and other settings have one where
/// they are as long as the numbers that were rounded; shorter and longer ones stand as they were stated.
///
/// As text it is `f64`, `f32`, `6 decimals` or `6 digits`, ` to 6` behind it where no number has more decimals, ` or
/// f64` behind that where it is as likely, and at the end the columns with a format of their own,
/// `, omega1_post_rad_s 3 decimals`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Told {
    /// the format in which the numbers seem to be
    pub format: Format,
    /// the most decimals that any number has
    pub decimals: Option<u8>,
    /// the stricter format in which they may be as well, in all columns
    pub or: Option<Format>,
    /// the formats of columns that seem to have their own
    pub own: Own,
}

/// By the [places](Column::index) of columns the formats that are not the log's. A velocity or spin before an impact has
/// that of the one behind it.
pub type Own = [Option<Printed>; COLUMNS];

/// The columns of a body's motion at a time.
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

/// The columns of a body's motion, before and after.
fn motions() -> impl Iterator<Item = (Column, Column)> {
    let of = |side| motion(side, When::Pre).into_iter().zip(motion(side, When::Post));
    [Side::First, Side::Second].into_iter().flat_map(of)
}

/// What is stated of an impact, and not computed in it.
pub(crate) fn settings() -> impl Iterator<Item = Column> {
    let axes = [Axis::X, Axis::Y, Axis::Z];
    let all = [Column::Dt, Column::Friction, Column::Restitution].into_iter();
    let of_axes = axes.into_iter().flat_map(|axis| {
        let of = |side| Column::Arm(side, axis);
        let [first, second] = [Side::First, Side::Second].map(of);
        [Column::Normal(axis), Column::Gravity(axis), Column::Impulse(axis), first, second]
    });
    let of_sides = [Side::First, Side::Second]
        .into_iter()
        .flat_map(|side| [Column::Mass(side), Column::Inertia(side), Column::Radius(side)]);
    all.chain(of_axes).chain(of_sides)
}

impl Told {
    /// A format that is known, of all columns.
    #[must_use]
    pub const fn stated(format: Format) -> Self {
        Self { format, decimals: None, or: None, own: [None; COLUMNS] }
    }

    /// By the velocities after the impact in these rows, which are what was computed, and by the settings beside them.
    #[must_use]
    pub fn of(rows: &[Row]) -> Self {
        let columns: Vec<(Column, BTreeSet<u64>)> = motions()
            .map(|(before, after)| (after, changed(rows, before, after)))
            .filter(|(_, values)| !values.is_empty())
            .collect();
        let all: BTreeSet<u64> = columns.iter().flat_map(|(_, values)| values).copied().collect();
        let mut told = Self::of_values(&all);
        let whole = told.format;
        for (column, values) in &columns {
            let numbers = Numbers::of(values);
            let own = numbers.own(told.printed());
            told.own[column.index()] = own;
            if own.is_some_and(|own| own.format != whole) && numbers.odd < SHORT {
                told.or = told.or.or(Some(whole));
            }
        }
        if told.or.is_none() { told.with_settings(rows, &columns) } else { told }
    }

    /// With the settings that were printed as the motion was.
    fn with_settings(mut self, rows: &[Row], columns: &[(Column, BTreeSet<u64>)]) -> Self {
        let of_columns = columns.iter().map(|(column, _)| self.of_column(*column));
        let formats: Vec<Printed> = of_columns.collect();
        for column in settings() {
            let values = rows.iter().filter_map(|row| row.get(column)).map(f64::to_bits).collect();
            let numbers = Numbers::of(&values);
            self.own[column.index()] = formats.iter().find_map(|format| numbers.beside(*format));
        }
        self
    }

    fn of_values(values: &BTreeSet<u64>) -> Self {
        let (Printed { format, decimals }, no_chance) = Numbers::of(values).told();
        let or = (!no_chance).then_some(Format::Binary64);
        Self { decimals, or, ..Self::stated(format) }
    }

    /// That of columns without their own.
    #[must_use]
    pub const fn printed(&self) -> Printed {
        Printed { format: self.format, decimals: self.decimals }
    }

    /// That of a column of motion behind the impact.
    pub(crate) fn of_column(&self, column: Column) -> Printed {
        self.own[column.index()].unwrap_or(self.printed())
    }

    /// Half a unit in the last place of what was computed with, by the value: that of the log, or of a column in
    /// binary32.
    #[must_use]
    pub fn unit(&self) -> f64 {
        let single = |own: &Printed| own.format == Format::Binary32;
        let format =
            if self.own.iter().flatten().any(single) { Format::Binary32 } else { self.format };
        format.unit().max(self.format.unit())
    }

    /// The columns with another format than the log has.
    pub fn columns(&self) -> impl Iterator<Item = (Column, Format)> {
        self.own().map(|(column, own)| (column, own.format)).filter(|(_, own)| *own != self.format)
    }

    /// The columns with a format of their own.
    fn own(&self) -> impl Iterator<Item = (Column, Printed)> {
        Column::all().into_iter().filter_map(|column| Some((column, self.own[column.index()]?)))
    }
}

/// The numbers of a column that an impact changed, as bits.
fn changed(rows: &[Row], before: Column, after: Column) -> BTreeSet<u64> {
    let value = |row: &Row| row.get(after).filter(|after| Some(*after) != row.get(before));
    rows.iter().filter_map(value).map(f64::to_bits).collect()
}

impl From<Format> for Told {
    fn from(format: Format) -> Self {
        Self::stated(format)
    }
}

impl fmt::Display for Told {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.printed())?;
        if let Some(or) = self.or {
            write!(f, "{OR}{}", or.flag())?;
        }
        self.own().try_for_each(|(column, own)| write!(f, ", {} {own}", column.name()))
    }
}

impl FromStr for Told {
    type Err = NoFormat;

    fn from_str(text: &str) -> Result<Self, NoFormat> {
        let mut parts = text.split(',').map(str::trim);
        let all = parts.next().unwrap_or_default();
        let (all, or) = match all.split_once(OR) {
            Some((all, or)) => (all, Some(or.parse()?)),
            None => (all, None),
        };
        let Printed { format, decimals } = all.parse()?;
        let mut told = Self { decimals, or, ..Self::stated(format) };
        for part in parts {
            let wrong = || NoFormat(part.to_owned());
            let (name, format) = part.split_once(' ').ok_or_else(wrong)?;
            let mut columns = motions().map(|(_, after)| after).chain(settings());
            let column = columns.find(|column| column.name() == name).ok_or_else(wrong)?;
            told.own[column.index()] = Some(format.parse()?);
        }
        Ok(told)
    }
}

/// What stands before a format that is as likely.
const OR: &str = " or ";

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
        let long: Vec<f64> =
            thirds().map(|x| format!("{:.15}", x * x).parse().expect("a float")).collect();
        assert_eq!(all(&long).decimals, Some(15));
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
            let told = all(values);
            assert_eq!((told.format, told.or), (format, Some(Format::Binary64)), "{values:?}");
        };
        doubtful(&[0.5, 0.33333334], Format::Binary32);
        doubtful(&[f64::from(0.1_f32)], Format::Binary32);
        doubtful(&[0.333_333], Format::Significant(6));
        doubtful(&[0.5, 1.625, 0.500_000_001], Format::Significant(9));
        doubtful(&[0.1, 0.3], Format::Significant(1));
        let rounded: Vec<f64> =
            thirds().map(|x| format!("{x:.3}").parse().expect("a float")).collect();
        doubtful(&rounded[..20], Format::Decimals(3));
        assert_eq!(told(&rounded), Format::Decimals(3));
        // one number with all its digits ends the doubt
        assert_eq!(told(&[0.1, 0.333_333, 1.0 / 3.0]), Format::Binary64);
    }

    #[test]
    fn a_number_is_off_by_half_of_its_last_digit_or_decimal() {
        let step = |values: &[f64], of: f64| all(values).printed().step().of(of);
        let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
        // four digits, where the one that is longer than others ends in a zero
        let four = [1.234, 2.345, 7.891, 12.3];
        near(step(&four, 12.3), 0.005);
        near(step(&four, 1.234), 0.0005);
        near(step(&four, 0.0123), 0.0005);
        near(Format::Significant(4).step().of(1000.0), 0.5);
        near(Format::Significant(4).step().of(999.9), 0.05);
        // binary32, printed with six decimals: large numbers show the float, small ones the decimals
        #[allow(clippy::cast_possible_truncation, reason = "the format in question")]
        let single: Vec<f64> = (1..40)
            .map(|i| f64::from(i * i * i) / 310.0)
            .map(|x| format!("{:.6}", x as f32).parse().expect("a float"))
            .collect();
        let told = all(&single);
        assert_eq!(told.format, Format::Binary32);
        near(told.printed().step().of(0.003_226), 5e-7);
    }

    #[test]
    fn settings_are_rounded_where_they_are_as_long_as_what_was() {
        let rounded = |x: f64| format!("{x:.4}").parse::<f64>().expect("a float");
        let rows: Vec<Row> = thirds()
            .map(|x| {
                let mut row = Row::empty(1);
                for (column, value) in [
                    (Column::Mass(Side::First), 0.5),
                    (Column::Inertia(Side::First), rounded(1.0 / 12.0)),
                    (Column::Arm(Side::First, Axis::Y), 0.061_25),
                    (Column::Velocity(Side::First, Axis::X, When::Post), rounded(x)),
                ] {
                    row.set(column, value);
                }
                row
            })
            .collect();
        let told = Told::of(&rows);
        assert_eq!(told.format, Format::Decimals(4));
        let own: Vec<Column> = told.own().map(|(column, _)| column).collect();
        assert_eq!(own, [Column::Inertia(Side::First)]);
        assert_eq!(told.to_string().parse(), Ok(told));
    }
}
