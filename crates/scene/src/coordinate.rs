//! The number systems in which bodies fly.

use kane_measure::chart::System;
use kane_number::{DoubleDouble, Interval, Number, Rational, Real, Rounding, decode, encode};
use num_traits::Signed as _;

/// A number system in which a motion can be followed: a root gives the time of an impact.
pub trait Coordinate: Real {
    /// Which one it is.
    const SYSTEM: System;

    /// √x for x ≥ 0, in each system as it can: correctly rounded, bounded, enclosed, or exact;
    /// `None` for x < 0, and for rationals where the root is irrational.
    fn sqrt(&self) -> Option<Self>;

    /// A float for pictures and tables: the number itself in floats, else one near to it.
    fn to_f64(&self) -> f64;

    /// The number as a fraction, where it is a single finite one.
    fn exact(&self) -> Option<Rational>;

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
    const SYSTEM: System = System::F32;

    fn sqrt(&self) -> Option<Self> {
        (*self >= 0.0).then(|| f32::sqrt(*self))
    }

    fn to_f64(&self) -> f64 {
        f64::from(*self)
    }

    fn exact(&self) -> Option<Rational> {
        decode(*self).ok()
    }

    fn of_enclosure(enclosure: Interval) -> Option<Self> {
        Some(Self::from_rational(&decode(enclosure.midpoint()).ok()?))
    }
}

impl Coordinate for f64 {
    const SYSTEM: System = System::F64;

    fn sqrt(&self) -> Option<Self> {
        (*self >= 0.0).then(|| f64::sqrt(*self))
    }

    fn to_f64(&self) -> f64 {
        *self
    }

    fn exact(&self) -> Option<Rational> {
        decode(*self).ok()
    }

    fn of_enclosure(enclosure: Interval) -> Option<Self> {
        Some(enclosure.midpoint())
    }
}

impl Coordinate for DoubleDouble {
    const SYSTEM: System = System::DoubleDouble;

    fn sqrt(&self) -> Option<Self> {
        DoubleDouble::sqrt(*self)
    }

    fn to_f64(&self) -> f64 {
        self.to_rational().map_or(f64::NAN, |exact| encode(&exact, Rounding::NearestEven))
    }

    fn exact(&self) -> Option<Rational> {
        self.to_rational().ok()
    }

    fn of_enclosure(enclosure: Interval) -> Option<Self> {
        Some(Self::from_rational(&decode(enclosure.midpoint()).ok()?))
    }
}

impl Coordinate for Interval {
    const SYSTEM: System = System::Interval;

    fn sqrt(&self) -> Option<Self> {
        Interval::sqrt(self)
    }

    fn to_f64(&self) -> f64 {
        self.midpoint()
    }

    fn exact(&self) -> Option<Rational> {
        if self.is_point() { decode(self.lower()).ok() } else { None }
    }

    fn enclosed(&self) -> Interval {
        *self
    }

    fn of_enclosure(enclosure: Interval) -> Option<Self> {
        Some(enclosure)
    }
}

impl Coordinate for Rational {
    const SYSTEM: System = System::Rational;

    fn sqrt(&self) -> Option<Self> {
        if self.is_negative() {
            return None;
        }
        let (numer, denom) = (self.numer().sqrt(), self.denom().sqrt());
        let root = Self::new(numer, denom);
        (root.square() == *self).then_some(root)
    }

    fn to_f64(&self) -> f64 {
        encode(self, Rounding::NearestEven)
    }

    fn exact(&self) -> Option<Rational> {
        Some(self.clone())
    }

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
