//! The number systems in which bodies fly.

use kane_number::{DoubleDouble, Interval, Lane, Number, Rational, decode};

/// A number system in which a motion can be followed: a root gives the time of an impact.
pub trait Coordinate: Lane {
    /// Whether the number has become too long to go on with: exact ones grow with every impact.
    fn is_long(&self) -> bool {
        false
    }

    /// The least interval that holds the number.
    fn enclosed(&self) -> Interval {
        self.exact().map_or(Interval::WHOLE, |exact| Interval::from_rational(&exact))
    }

    /// A number of this system for what is only enclosed: the interval itself, or a float near its
    /// middle; `None` in exact systems.
    fn of_enclosure(enclosure: Interval) -> Option<Self>;
}

/// Bits of a fraction, above which a motion is not followed any further.
const MOST_BITS: u64 = 4_096;

impl Coordinate for f32 {
    fn of_enclosure(enclosure: Interval) -> Option<Self> {
        Some(Self::from_rational(&decode(enclosure.midpoint()).ok()?))
    }
}

impl Coordinate for f64 {
    fn of_enclosure(enclosure: Interval) -> Option<Self> {
        Some(enclosure.midpoint())
    }
}

impl Coordinate for DoubleDouble {
    fn of_enclosure(enclosure: Interval) -> Option<Self> {
        Some(Self::from_rational(&decode(enclosure.midpoint()).ok()?))
    }
}

impl Coordinate for Interval {
    fn enclosed(&self) -> Interval {
        *self
    }

    fn of_enclosure(enclosure: Interval) -> Option<Self> {
        Some(enclosure)
    }
}

impl Coordinate for Rational {
    fn is_long(&self) -> bool {
        self.numer().bits() + self.denom().bits() > MOST_BITS
    }

    fn of_enclosure(_: Interval) -> Option<Self> {
        None
    }
}

/// x/2.
pub(crate) fn half<N: Number>(x: N) -> N {
    x / N::one().double()
}
