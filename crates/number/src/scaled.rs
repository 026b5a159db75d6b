//! Twice the precision of binary64, and no limits to its range.
#![allow(clippy::float_arithmetic, reason = "the mantissa is made of floats")]

use std::cmp::Ordering;
use std::fmt;

use crate::decimal::significant;
use crate::decode::magnitude_parts;
use crate::encode::binade as binade_of;
use crate::error_free::{binade, power_of_two, scale};
use crate::operators::{operators, works_in_itself};
use crate::{Binary, Comparison, DoubleDouble, Number, Ordered, Rational, Real};

/// A [`DoubleDouble`] mantissa times a power of two with an exponent of its own.
///
/// The system in which the quantities of a body are formed: no sum, product or quotient of finite
/// floats over- or underflows in it, so the bounds of [`DoubleDouble`] hold without their proviso,
/// and the result is rounded to a float once, at the end. Normalised after every operation:
/// 1 ≤ |mantissa| < 2 in its high part, or zero. Addends more than 2^500 apart do not meet: the
/// smaller is dropped.
///
/// Exponents go to ±2^62; beyond that, at a division by zero, and from NaN and ±∞, the number is
/// [not finite](Number::is_finite) and compares with nothing. Comparison is otherwise exact.
///
/// ```
/// use kane_number::{Number, Scaled};
/// let huge = Scaled::from(f64::MAX);
/// let one = huge.square() / huge.square();
/// assert_eq!(one.to_f64(), 1.0);
/// assert_eq!(huge.square().to_f64(), f64::INFINITY);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaled {
    mantissa: DoubleDouble,
    exponent: i64,
}

/// Exponents stay below this, so that sums of a few of them do not overflow.
const EXPONENT_LIMIT: i64 = 1 << 62;

/// The greatest exponent of a number that is written out exactly: two megabytes.
const MOST_BITS: u32 = 1 << 24;

/// A smaller addend than this, relatively, is dropped; scaling by it is exact.
const NEGLIGIBLE: i64 = 500;

impl Scaled {
    /// The exact value, or `None` if it is not finite or beyond 2^±(2^24): an exact
    /// number takes as many bits as its exponent says.
    #[must_use]
    pub fn to_rational(self) -> Option<Rational> {
        let power = i32::try_from(self.exponent).ok().filter(|e| e.unsigned_abs() <= MOST_BITS)?;
        let mantissa = self.mantissa.to_rational().ok()?;
        Some(mantissa * Rational::from_integer(2.into()).pow(power))
    }

    /// The nearest `f64`, ties to even: correctly rounded from high + low, subnormals included.
    /// Overflow gives ±∞.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        self.to_binary()
    }

    /// The nearest `f32`, rounded once: not by way of `f64`.
    #[must_use]
    pub fn to_f32(self) -> f32 {
        self.to_binary()
    }

    /// The nearest pair of floats. Exact unless it over- or underflows.
    #[must_use]
    pub fn to_double_double(self) -> DoubleDouble {
        let high = self.to_f64();
        if !high.is_finite() || high == 0.0 {
            return DoubleDouble::from(high);
        }
        // Below the normal floats the nearest one takes a part of the low half with it; what that
        // half scales to is zero there, since it is no more than half of the least float.
        DoubleDouble::new(high, scale(self.mantissa.low(), self.exponent))
    }

    /// √a, or `None` if a is negative or not finite. Relative error at most 25/8·u².
    #[must_use]
    pub fn sqrt(self) -> Option<Self> {
        let odd = self.exponent.rem_euclid(2);
        let radicand = self.mantissa.times(power_of_two(odd));
        Some(Self::normal(radicand.sqrt()?, (self.exponent - odd) / 2))
    }

    /// The number times 2^exponent. Exact.
    #[must_use]
    pub fn scaled_by(self, exponent: i64) -> Self {
        Self::normal(self.mantissa, self.exponent.saturating_add(exponent))
    }

    /// The magnitude |a|. Exact.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.is_negative() { self.opposite() } else { self }
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.mantissa.high() == 0.0
    }

    /// Whether this is below 0.
    pub(crate) fn is_negative(self) -> bool {
        self.mantissa.high() < 0.0
    }

    /// The exponent of the leading bit; of 0 nothing that is useful.
    pub(crate) fn exponent(self) -> i64 {
        self.exponent
    }

    /// Brings the leading part of a mantissa of moderate size between 1 and 2.
    fn normal(mantissa: DoubleDouble, exponent: i64) -> Self {
        let high = mantissa.high();
        if high == 0.0 || !high.is_finite() {
            return Self { mantissa: DoubleDouble::from(high), exponent: 0 };
        }
        let shift = binade(high);
        let exponent = exponent.saturating_add(shift);
        if exponent.abs() >= EXPONENT_LIMIT {
            return Self { mantissa: DoubleDouble::from(f64::NAN), exponent: 0 };
        }
        // Operations on normal mantissas stay within 2^±700, far from the ends of the range.
        Self { mantissa: mantissa.times(power_of_two(-shift)), exponent }
    }

    fn opposite(self) -> Self {
        Self { mantissa: -self.mantissa, exponent: self.exponent }
    }

    /// The mantissa as seen from a greater exponent, zero if it is too small to matter.
    fn aligned(self, exponent: i64) -> DoubleDouble {
        let shift = exponent.saturating_sub(self.exponent);
        if shift > NEGLIGIBLE {
            return DoubleDouble::from(0.0);
        }
        self.mantissa.times(power_of_two(-shift))
    }

    /// The greater exponent of two, where zero and the non-finite have none.
    fn common_exponent(&self, other: &Self) -> i64 {
        let has_none = |a: &Self| a.is_zero() || !a.is_finite();
        match (has_none(self), has_none(other)) {
            (true, true) => 0,
            (true, false) => other.exponent,
            (false, true) => self.exponent,
            (false, false) => self.exponent.max(other.exponent),
        }
    }

    fn at_common_exponent(self, exponent: i64) -> DoubleDouble {
        let is_number = !self.is_zero() && self.is_finite();
        if is_number { self.aligned(exponent) } else { self.mantissa }
    }

    fn sum(&self, other: &Self) -> Self {
        let exponent = self.common_exponent(other);
        let (a, b) = (self.at_common_exponent(exponent), other.at_common_exponent(exponent));
        Self::normal(a + b, exponent)
    }

    fn difference(&self, other: &Self) -> Self {
        self.sum(&other.opposite())
    }

    fn product(&self, other: &Self) -> Self {
        Self::normal(self.mantissa * other.mantissa, self.exponent + other.exponent)
    }

    fn quotient(&self, other: &Self) -> Self {
        Self::normal(self.mantissa / other.mantissa, self.exponent - other.exponent)
    }

    /// high + low rounded to a binary format by its bits.
    fn to_binary<F: Binary>(self) -> F {
        let high = self.mantissa.high();
        let negative = high.is_sign_negative();
        let Ok((bits, unit)) = magnitude_parts(high) else {
            let nan = F::infinity_bits() + u64::from(high.is_nan());
            return F::from_magnitude_bits(negative, nan);
        };
        if bits == 0 {
            return F::from_magnitude_bits(negative, 0);
        }
        // The low part is at most half a unit of the high one. Every number that decides a
        // rounding is a multiple of that half unit, and high + low = such a number only if low is
        // zero or the half itself, where high is even already. So the side on which low lies, a
        // quarter unit, says all.
        let low = self.mantissa.low();
        let side = if low == 0.0 {
            0
        } else if low.is_sign_negative() == negative {
            1
        } else {
            -1
        };
        let quarters = (bits * 4).checked_add_signed(side).expect("bits are positive");
        let unit = unit.saturating_add(self.exponent).saturating_sub(2);
        F::from_magnitude_bits(negative, round_bits::<F>(quarters, unit))
    }
}

/// The magnitude pattern nearest to quarters·2^unit, ties to even; 2^53 < quarters < 2^56, more bits than a format has.
fn round_bits<F: Binary>(quarters: u64, unit: i64) -> u64 {
    let top = unit.saturating_add(i64::from(63 - quarters.leading_zeros()));
    if top > F::GREATEST_EXPONENT {
        return F::infinity_bits();
    }
    if top < F::LEAST_EXPONENT - 1 {
        return 0;
    }
    let target = (top - i64::from(F::PRECISION) + 1).max(F::LEAST_EXPONENT);
    let drop = target - unit;
    let (kept, rest) = (quarters >> drop, quarters & ((1 << drop) - 1));
    let half = 1 << (drop - 1);
    let significand = kept + u64::from(rest > half || (rest == half && kept % 2 == 1));
    let steps = (target - F::LEAST_EXPONENT).unsigned_abs() << (F::PRECISION - 1);
    steps + significand
}

operators!(Scaled);

impl From<f64> for Scaled {
    /// Exact; NaN and ±∞ stay what they are.
    fn from(float: f64) -> Self {
        DoubleDouble::from(float).into()
    }
}

impl From<DoubleDouble> for Scaled {
    /// Exact, unless the parts lie more than 2^1000 apart.
    fn from(number: DoubleDouble) -> Self {
        let high = number.high();
        if high == 0.0 || !high.is_finite() {
            return Self { mantissa: DoubleDouble::from(high), exponent: 0 };
        }
        let exponent = binade(high);
        let (high, low) = (scale(high, -exponent), scale(number.low(), -exponent));
        Self { mantissa: DoubleDouble::of((high, low)), exponent }
    }
}

impl PartialOrd for Scaled {
    /// Exact; `None` if either is not finite.
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let mantissas = || self.mantissa.partial_cmp(&other.mantissa);
        let zero = self.is_zero() || other.is_zero();
        if zero || !self.is_finite() || !other.is_finite() {
            return mantissas();
        }
        match (self.is_negative(), other.is_negative()) {
            (false, false) => Some(self.exponent.cmp(&other.exponent).then(mantissas()?)),
            (true, true) => Some(other.exponent.cmp(&self.exponent).then(mantissas()?)),
            (false, true) => Some(Ordering::Greater),
            (true, false) => Some(Ordering::Less),
        }
    }
}

impl fmt::Display for Scaled {
    /// 31 significant digits; beyond 2^±16384 the mantissa and the power of two.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let moderate = (self.exponent.abs() <= 16_384).then(|| self.to_rational()).flatten();
        match moderate {
            Some(exact) => f.write_str(&significant(&exact, 31)),
            None if self.is_finite() => write!(f, "{}*2^{}", self.mantissa, self.exponent),
            None => write!(f, "{}", self.mantissa),
        }
    }
}

impl Number for Scaled {
    type Wide = Self;

    fn widen(&self) -> Self {
        *self
    }

    fn narrow(wide: &Self) -> Self {
        *wide
    }

    fn zero() -> Self {
        Self::from(0.0)
    }

    fn one() -> Self {
        Self::from(1.0)
    }

    /// The nearest float mantissa, and the float nearest to the rest: relative error at most u²/2.
    fn from_rational(exact: &Rational) -> Self {
        use num_traits::Zero as _;
        if exact.is_zero() {
            return Self::zero();
        }
        let exponent = binade_of(exact.numer().magnitude(), exact.denom().magnitude());
        let scale = crate::Integer::from(1) << exponent.unsigned_abs();
        let mantissa = if exponent >= 0 { exact / scale } else { exact * scale };
        Self::normal(DoubleDouble::from_rational(&mantissa), exponent)
    }

    /// To the working precision, relative error at most 32u², whatever cancels; not one rounding.
    fn mul_add(&self, factor: &Self, addend: &Self) -> Self {
        let product = Self { exponent: self.exponent + factor.exponent, ..*self };
        let far = addend.exponent.saturating_sub(product.exponent).abs() > NEGLIGIBLE;
        if far || self.is_zero() || factor.is_zero() || addend.is_zero() {
            return self.product(factor).sum(addend);
        }
        let addend = addend.mantissa.times(power_of_two(addend.exponent - product.exponent));
        let sum = self.mantissa.mul_add(&factor.mantissa, &addend);
        Self::normal(sum, product.exponent)
    }

    fn checked_div(&self, divisor: &Self) -> Option<Self> {
        (!divisor.is_zero()).then(|| self.quotient(divisor))
    }

    fn is_finite(&self) -> bool {
        self.mantissa.is_finite()
    }
}

impl Ordered for Scaled {
    fn compare(&self, other: &Self) -> Comparison {
        self.partial_cmp(other).into()
    }
}

impl Real for Scaled {
    type WideReal = Self;

    works_in_itself!();

    /// Closed forms for degrees 1 and 2, bracketed Newton for 3: the exact root of coefficients
    /// that differ by 2^−96 relatively. Double roots are told from two or none only to within
    /// that.
    fn greatest_root(coefficients: &[Self], lower: &Self, upper: &Self) -> Option<Self> {
        crate::root::float::greatest_root(coefficients, lower, upper, -96)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::power_of;

    #[test]
    fn zero_has_no_sign_and_addends_meet_up_to_their_distance() {
        assert!(!Scaled::zero().is_negative() && !(-Scaled::zero()).is_negative());
        assert!(Scaled::zero().abs().to_f64().is_sign_positive());
        let one = Scaled::one();
        for (exponent, meets) in [(-499, true), (-500, true), (-501, false)] {
            for sum in [one.scaled_by(exponent) + one, one + one.scaled_by(exponent)] {
                let small = if meets { power_of(2, exponent) } else { Rational::zero() };
                assert_eq!(sum.to_rational(), Some(Rational::one() + small), "1 + 2^{exponent}");
            }
        }
    }
}
