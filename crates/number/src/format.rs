//! Float arithmetic as the algorithms on rounding errors see it.
#![allow(clippy::float_arithmetic, reason = "this is the arithmetic of floats, by its names")]

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::Binary;

/// A binary format with its arithmetic: each operation gives the float nearest to the exact result, halfway the even one
/// (IEEE 754, 2019, section 5.4).
///
/// What is written over it holds for every such format: the program runs it in `f64`, and the tests in formats of a few
/// bits, where all pairs of floats can be tried.
pub(crate) trait Format:
    Binary
    + PartialOrd
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
{
    /// Whether the target has a fused multiply-add as one instruction.
    const FUSED: bool;

    /// The float 2^exponent, which is normal.
    fn power_of_two(exponent: i64) -> Self;

    /// self·factor + addend, rounded once.
    fn mul_add(self, factor: Self, addend: Self) -> Self;

    /// √self.
    fn sqrt(self) -> Self;

    /// The least float above.
    fn next_up(self) -> Self;

    /// The greatest float below.
    fn next_down(self) -> Self;

    /// +0.
    fn zero() -> Self {
        Self::from_magnitude_bits(false, 0)
    }

    /// The greatest finite float.
    fn greatest() -> Self {
        Self::from_magnitude_bits(false, Self::infinity_bits() - 1)
    }

    /// Without its sign.
    fn abs(self) -> Self {
        Self::from_magnitude_bits(false, self.magnitude_bits())
    }

    /// Whether it is NaN.
    fn is_nan(self) -> bool {
        self.magnitude_bits() > Self::infinity_bits()
    }

    /// Whether it is +∞ or −∞.
    fn is_infinite(self) -> bool {
        self.magnitude_bits() == Self::infinity_bits()
    }

    /// Below this in magnitude, 2^−960 in `f64`, the error of a product may underflow: its sign is no longer known. It
    /// may from 2^(LEAST_EXPONENT + 2·PRECISION) down; 8 binades are left between.
    fn small() -> Self {
        Self::power_of_two(Self::LEAST_EXPONENT + 2 * i64::from(Self::PRECISION) + 8)
    }

    /// 2^s + 1, a product with which parts a float into halves; s is half of the precision, rounded up.
    fn spread() -> Self {
        Self::power_of_two(i64::from(Self::PRECISION.div_ceil(2))) + Self::power_of_two(0)
    }

    /// Below this in magnitude, 2^990 in `f64`, a float can be parted: the product with 2^s + 1 does not overflow.
    fn splittable() -> Self {
        Self::power_of_two(Self::GREATEST_EXPONENT - i64::from(Self::PRECISION.div_ceil(2)) - 6)
    }
}

impl Format for f64 {
    const FUSED: bool = cfg!(target_feature = "fma");

    fn power_of_two(exponent: i64) -> Self {
        debug_assert!((-1022..=1023).contains(&exponent), "2^{exponent} is not a normal float");
        Self::from_bits((exponent + 1023).cast_unsigned() << 52)
    }

    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self::mul_add(self, factor, addend)
    }

    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }

    fn next_up(self) -> Self {
        Self::next_up(self)
    }

    fn next_down(self) -> Self {
        Self::next_down(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_infinite_is_not_nan() {
        for x in [0.0, -1.0, f64::MAX, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            assert_eq!(Format::is_nan(x), x.is_nan(), "{x}");
            assert_eq!(Format::is_infinite(x), x.is_infinite(), "{x}");
        }
    }
}
