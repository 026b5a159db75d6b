//! Which number system, as a value, and what all systems of a table can do.

use std::fmt;

use num_traits::Signed as _;

use crate::{DoubleDouble, Interval, Number as _, Rational, Real, Rounding, decode, encode};

/// A number system in which formulas, laws and motions are run side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum System {
    /// binary32
    F32,
    /// binary64
    F64,
    /// pairs of binary64
    DoubleDouble,
    /// enclosures with ends in binary64
    Interval,
    /// exact fractions
    Rational,
}

impl System {
    /// All of them, in the order of tables.
    pub const ALL: [Self; 5] =
        [Self::F32, Self::F64, Self::DoubleDouble, Self::Interval, Self::Rational];

    /// What an addition, a multiplication, a division and a root cost in each system, in additions of
    /// `f64`. Set once, by the operations of floats that the system's own algorithms are made of; not
    /// measured, so that a rank does not depend on a machine.
    #[must_use]
    pub const fn weights(self) -> [u64; 4] {
        match self {
            Self::F32 | Self::F64 => [1, 1, 4, 5],
            Self::DoubleDouble => [20, 25, 45, 50],
            Self::Interval => [14, 40, 50, 30],
            Self::Rational => [1500, 1500, 1500, 3000],
        }
    }
}

impl fmt::Display for System {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::DoubleDouble => "double-double",
            Self::Interval => "interval",
            Self::Rational => "rational",
        })
    }
}

/// A number system that is one of [`System`], and whose numbers can be looked at.
pub trait Lane: Real {
    /// Which one it is.
    const SYSTEM: System;

    /// √x for x ≥ 0, in each system as it can: correctly rounded, bounded, enclosed, or exact;
    /// `None` for x < 0, and for rationals where the root is irrational.
    #[must_use]
    fn sqrt(&self) -> Option<Self>;

    /// A float for pictures and tables: the number itself in floats, else one near to it.
    #[must_use]
    fn to_f64(&self) -> f64;

    /// The number as a fraction, exactly, where it is a single finite one.
    #[must_use]
    fn exact(&self) -> Option<Rational>;
}

impl Lane for f32 {
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
}

impl Lane for f64 {
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
}

impl Lane for DoubleDouble {
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
}

impl Lane for Interval {
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
}

impl Lane for Rational {
    const SYSTEM: System = System::Rational;

    fn sqrt(&self) -> Option<Self> {
        if self.is_negative() {
            return None;
        }
        let root = Self::new(self.numer().sqrt(), self.denom().sqrt());
        (root.square() == *self).then_some(root)
    }

    fn to_f64(&self) -> f64 {
        encode(self, Rounding::NearestEven)
    }

    fn exact(&self) -> Option<Rational> {
        Some(self.clone())
    }
}
