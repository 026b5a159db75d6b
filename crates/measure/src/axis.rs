//! The representable numbers of a format, in order, and those of them that a domain admits.

use std::fmt::{Debug, Display, LowerExp};

use kane_kernel::Bound;
use kane_number::{Binary, Rational, Rounding, decode, encode};

use crate::{DyadicNumber, PlainNumber};

/// A binary format in which a formula is examined.
pub trait Format: Binary + PlainNumber + Debug + Display + LowerExp {
    /// Its name in reports.
    const NAME: &'static str;

    /// The positive float at this place of the order, 0 at place 0.
    #[must_use]
    fn at(place: u64) -> Self {
        Self::from_magnitude_bits(false, place)
    }

    /// The float of either sign at this place.
    #[must_use]
    fn signed(negative: bool, place: u64) -> Self {
        Self::from_magnitude_bits(negative, place)
    }

    /// The exact value, or `None` for NaN and ±∞.
    fn exactly(self) -> Option<DyadicNumber> {
        DyadicNumber::of(self).ok()
    }
}

impl Format for f32 {
    const NAME: &'static str = "f32";
}

impl Format for f64 {
    const NAME: &'static str = "f64";
}

/// The non-negative floats of a range, by their places in the order of representable numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axis {
    /// The least one.
    pub first: u64,
    /// The greatest one.
    pub last: u64,
}

impl Axis {
    /// Whether a place is one of them.
    #[must_use]
    pub fn holds(&self, place: u64) -> bool {
        (self.first..=self.last).contains(&place)
    }

    /// The finite floats ≥ 0 between two bounds; `None` if there is none.
    #[must_use]
    pub fn between<F: Format>(lower: Option<&Bound>, upper: Option<&Bound>) -> Option<Self> {
        let zero = Rational::from_integer(0.into());
        let place = |float: F| float.magnitude_bits();
        let first = match lower.filter(|bound| bound.value >= zero) {
            None => 0,
            Some(bound) => {
                let float: F = encode(&bound.value, Rounding::Up);
                let met = decode(float).ok()? == bound.value;
                place(float) + u64::from(met && bound.strict)
            }
        };
        let greatest = F::infinity_bits() - 1;
        let last = match upper {
            None => greatest,
            Some(bound) if bound.value < zero => return None,
            Some(bound) => {
                let float: F = encode(&bound.value, Rounding::Down);
                let met = decode(float).ok()? == bound.value;
                place(float).checked_sub(u64::from(met && bound.strict))?.min(greatest)
            }
        };
        (first <= last).then_some(Self { first, last })
    }

    /// The finite floats < 0 between two bounds, by the places of their magnitudes; `None` if there
    /// is none.
    #[must_use]
    pub fn below_zero<F: Format>(lower: Option<&Bound>, upper: Option<&Bound>) -> Option<Self> {
        let mirrored = |bound: &Bound| Bound { value: -bound.value.clone(), strict: bound.strict };
        let (least, most) = (upper.map(mirrored), lower.map(mirrored));
        let axis = Self::between::<F>(least.as_ref(), most.as_ref())?;
        let first = axis.first.max(1);
        (first <= axis.last).then_some(Self { first, ..axis })
    }

    /// A few places in every binade: both ends, their neighbours, and some between, the same in
    /// every run. With `density` 1 there are eight.
    #[must_use]
    pub fn places<F: Format>(&self, density: u64) -> Vec<u64> {
        let width = 1_u64 << (F::PRECISION - 1);
        let mut places = vec![self.first, self.last];
        let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
        let mut draw = |width: u64| {
            // a step of the generator `splitmix64`
            seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mixed = (seed ^ (seed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            (mixed ^ (mixed >> 29)) % width.max(1)
        };
        let mut add = |places: &mut Vec<u64>, start: u64, width: u64| {
            places.extend([start, start + 1, start + 2, start + width - 1]);
            for _ in 0..4 * density {
                places.push(start + draw(width));
            }
        };
        // subnormals have binades, too
        for bit in 1..F::PRECISION - 1 {
            add(&mut places, 1_u64 << bit, 1_u64 << bit);
        }
        places.push(0);
        places.push(1);
        let mut start = width;
        while start < F::infinity_bits() {
            if start + width > self.first && start <= self.last {
                add(&mut places, start, width);
            }
            start += width;
        }
        places.retain(|place| self.holds(*place));
        places.sort_unstable();
        places.dedup();
        places
    }
}
