//! What the shortest decimals of numbers tell of how they were printed.

use std::collections::BTreeSet;

use crate::format::{Format, Printed};

/// So many numbers are no binary64 by chance, where each is a binary32, printed exactly or in eight digits or more: of
/// what a binary64 is for short decimals, less than half has 15 digits or fewer, and of such with eight digits less than
/// half are those of a binary32.
const SINGLES: usize = 8;
/// So many numbers are no binary64 by chance, where each has 15 digits or fewer: of sums of products of short decimals
/// less than half have, and of single products some two in three.
pub(crate) const SHORT: usize = 24;
/// So many in a column are a chance of one in 25, by the same.
const SOME: usize = 8;
/// So many more zeros at the end of numbers are needed by one way of printing than by the other to tell it, a chance of
/// one in a hundred.
const ZEROS: usize = 2;

/// Binary floats that end after so many decimals were printed with as many; further ones are what is left of the float.
const MOST: u8 = 17;

/// Different numbers, by their shortest decimals.
pub(crate) struct Numbers {
    all: Vec<Digits>,
    /// those that tell something
    pub(crate) odd: usize,
    /// the most digits
    digits: u8,
    /// the most decimals
    decimals: u8,
    /// how many of those that tell something have so many digits, and so many decimals
    longest: [usize; 2],
    /// the zeros that those that tell something would end with, had they been printed with so many digits, and with so
    /// many decimals
    zeros: [usize; 2],
}

impl Numbers {
    /// Of floats, as bits.
    pub(crate) fn of(values: &BTreeSet<u64>) -> Self {
        let all: Vec<Digits> =
            values.iter().map(|bits| Digits::of(f64::from_bits(*bits))).collect();
        let digits = all.iter().map(|number| number.digits).max().unwrap_or(0);
        let decimals = all.iter().map(|number| number.decimals).max().unwrap_or(0);
        let odd = || all.iter().filter(|number| !number.short_binary);
        let missing = || odd().map(|number| [digits - number.digits, decimals - number.decimals]);
        let count = |place: usize| missing().filter(|missing| missing[place] == 0).count();
        let zeros = |place: usize| missing().map(|missing| usize::from(missing[place])).sum();
        let (longest, zeros) = ([count(0), count(1)], [zeros(0), zeros(1)]);
        Self { odd: odd().count(), digits, decimals, longest, zeros, all }
    }

    /// In which format they are, and whether that is no chance.
    pub(crate) fn told(&self) -> (Printed, bool) {
        if self.odd == 0 {
            return (Format::Binary64.into(), true);
        }
        let (enough, singles) = (self.odd >= SHORT, self.are_singles());
        let (format, no_chance) = match self.digits {
            _ if self.all.iter().all(|number| number.exact_single) => {
                (Format::Binary32, self.odd >= SINGLES)
            }
            // few numbers of 24 bits may do without the eighth digit
            7 if singles && self.odd < SINGLES => (Format::Binary32, false),
            8.. if singles => (Format::Binary32, self.long() >= SINGLES || enough),
            ..16 => match self.decimal() {
                // small numbers, which may be of 24 bits
                Format::Decimals(7..) if singles => (Format::Binary32, enough),
                format => (format, enough),
            },
            _ => (Format::Binary64, true),
        };
        (self.printed(format), no_chance)
    }

    /// How many have eight digits or more, which of a binary64 are those of a binary32 by chance alone.
    fn long(&self) -> usize {
        self.all.iter().filter(|number| number.digits >= 8).count()
    }

    fn printed(&self, format: Format) -> Printed {
        Printed { format, decimals: Some(self.decimals) }
    }

    /// Whether all may be binary32.
    fn are_singles(&self) -> bool {
        self.all.iter().all(|number| number.single)
    }

    /// Whether two in three are as long as any.
    fn are_even(&self) -> bool {
        3 * self.longest[0].max(self.longest[1]) >= 2 * self.odd
    }

    /// Whether they were printed with so many decimals, and not with so many digits.
    fn by_decimals(&self) -> bool {
        self.zeros[0] >= self.zeros[1] + ZEROS
    }

    /// To what they were rounded, if they were. Where too few zeros tell, to digits, since those are bounded by the
    /// [decimals](Printed) as well.
    fn decimal(&self) -> Format {
        if self.by_decimals() {
            Format::Decimals(self.decimals)
        } else {
            Format::Significant(self.digits)
        }
    }

    /// To what those of a column were rounded, if there are enough that look so.
    fn rounded(&self) -> Option<Printed> {
        let singles = self.are_singles();
        // a float that is printed in all its digits has no decimals in common with others
        let long = self.digits >= 16 || self.digits >= 8 && singles;
        let decimals = 3 * self.longest[1] >= 2 * self.odd && self.by_decimals();
        let format = match () {
            () if self.odd < SOME => return None,
            () if decimals || self.are_even() && !long => self.decimal(),
            () if singles && self.long() >= SINGLES => Format::Binary32,
            () => return None,
        };
        Some(self.printed(format))
    }

    /// To what those of a column were rounded, if that is not what all numbers of the log were.
    pub(crate) fn own(&self, all: Printed) -> Option<Printed> {
        // as many decimals as all, and no clear sign of digits
        let fits =
            all.format == Format::Decimals(self.decimals) && self.zeros[1] < self.zeros[0] + ZEROS;
        // a column of binary32 among decimals of as many places; among binary64 its numbers are short by chance
        let single =
            |own: &Printed| own.format.unit() > all.format.unit() && all.format != Format::Binary64;
        let differs = |own: &Printed| own.step() != all.step() || single(own);
        self.rounded().filter(|own| !fits && differs(own))
    }

    /// To what settings were rounded that stand beside numbers in this format: those that have as many decimals, or as
    /// many digits, were printed as these; shorter and longer ones stand as they were stated.
    pub(crate) fn beside(&self, printed: Printed) -> Option<Printed> {
        let fits = self.odd > 0
            && match printed.format {
                Format::Decimals(decimals) => self.decimals == decimals,
                Format::Significant(digits) => {
                    self.digits == digits
                        || self.digits < digits
                            && self.decimals > 0
                            && printed.decimals == Some(self.decimals)
                }
                Format::Binary32 | Format::Binary64 => {
                    (1..=MOST).contains(&self.decimals) && printed.decimals == Some(self.decimals)
                }
            };
        let format = match printed.format {
            Format::Binary32 | Format::Binary64 => Format::Decimals(self.decimals),
            format => format,
        };
        fits.then(|| self.printed(format))
    }
}

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
