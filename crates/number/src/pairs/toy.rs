//! Formats of a few bits, for which everything can be tried.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::Binary;
use crate::format::Format;

/// A float of `P` bits of precision, with the exponents of a format of `E` binades, made from its definition: the result
/// of an operation in `f64`, rounded.
///
/// What it rounds is exact, or for quotients and roots so near that rounding twice is rounding once, since 53 bits are
/// more than 2·`P` + 1 (Figueroa 1995); the tests do not rest on that, they compare in integers.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(super) struct Toy<const P: u32, const E: i64>(pub(super) f64);

impl<const P: u32, const E: i64> Toy<P, E> {
    /// The toy nearest to a number, halfway the even one.
    pub(super) fn nearest(x: f64) -> Self {
        if x == 0.0 || !x.is_finite() {
            return Self(x);
        }
        let binade = i64::from(x.abs().log2().floor() as i32);
        let unit = 2_f64.powi((binade - i64::from(P) + 1).max(Self::LEAST_EXPONENT) as i32);
        let rounded = (x / unit).round_ties_even() * unit;
        let beyond = rounded.abs() >= 2_f64.powi(Self::GREATEST_EXPONENT as i32 + 1);
        Self(if beyond { f64::INFINITY.copysign(x) } else { rounded })
    }

    /// All finite ones, in their order, zero once.
    pub(super) fn all() -> Vec<Self> {
        let positive =
            (1..Self::infinity_bits()).map(|bits| Self::from_magnitude_bits(false, bits));
        let mut all: Vec<Self> = positive.clone().rev().map(|x| -x).collect();
        all.push(Self::zero());
        all.extend(positive);
        all
    }

    /// A finite one in units of the least positive one.
    #[track_caller]
    pub(super) fn units(self) -> i128 {
        let units = self.0 / 2_f64.powi(Self::LEAST_EXPONENT as i32);
        assert!(units.is_finite() && units.fract() == 0.0, "{self:?} is a number of the format");
        units as i128
    }

    fn stepped(self, up: bool) -> Self {
        if self.0 == 0.0 {
            return Self::from_magnitude_bits(!up, 1);
        }
        let away = up == (self.0 > 0.0);
        let bits = self.magnitude_bits();
        Self::from_magnitude_bits(self.0 < 0.0, if away { bits + 1 } else { bits - 1 })
    }
}

impl<const P: u32, const E: i64> Binary for Toy<P, E> {
    const PRECISION: u32 = P;
    const LEAST_EXPONENT: i64 = 2 - E - P as i64;
    const GREATEST_EXPONENT: i64 = E;

    fn magnitude_bits(self) -> u64 {
        let x = self.0.abs();
        if !x.is_finite() {
            return Self::infinity_bits() + u64::from(x.is_nan());
        }
        let units = (x / 2_f64.powi(Self::LEAST_EXPONENT as i32)) as u64;
        let hidden = 1 << (P - 1);
        if units < hidden {
            return units;
        }
        // a significand of P bits and how far it is moved
        let moved = u64::from(units.ilog2() + 1 - P);
        (moved << (P - 1)) + (units >> moved)
    }

    fn is_negative(self) -> bool {
        self.0.is_sign_negative()
    }

    fn from_magnitude_bits(negative: bool, bits: u64) -> Self {
        let hidden = 1_u64 << (P - 1);
        let (field, fraction) = (bits / hidden, bits % hidden);
        let least = 2_f64.powi(Self::LEAST_EXPONENT as i32);
        let x = match bits {
            bits if bits > Self::infinity_bits() => f64::NAN,
            bits if bits == Self::infinity_bits() => f64::INFINITY,
            _ if field == 0 => fraction as f64 * least,
            _ => (hidden + fraction) as f64 * least * 2_f64.powi(field as i32 - 1),
        };
        Self(if negative { -x } else { x })
    }
}

impl<const P: u32, const E: i64> Format for Toy<P, E> {
    const FUSED: bool = false;

    fn power_of_two(exponent: i64) -> Self {
        assert!((1 - E..=E).contains(&exponent), "2^{exponent} is a normal toy");
        Self(2_f64.powi(exponent as i32))
    }

    fn mul_add(self, factor: Self, addend: Self) -> Self {
        // the product is exact in 53 bits, and so is its sum with the float next to it
        Self::nearest(self.0.mul_add(factor.0, addend.0))
    }

    fn sqrt(self) -> Self {
        Self::nearest(self.0.sqrt())
    }

    fn next_up(self) -> Self {
        self.stepped(true)
    }

    fn next_down(self) -> Self {
        self.stepped(false)
    }
}

impl<const P: u32, const E: i64> Neg for Toy<P, E> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<const P: u32, const E: i64> Add for Toy<P, E> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::nearest(self.0 + other.0)
    }
}

impl<const P: u32, const E: i64> Sub for Toy<P, E> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::nearest(self.0 - other.0)
    }
}

impl<const P: u32, const E: i64> Mul for Toy<P, E> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::nearest(self.0 * other.0)
    }
}

impl<const P: u32, const E: i64> Div for Toy<P, E> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self::nearest(self.0 / other.0)
    }
}
