//! The first stage: a float, and a bound on its error that costs a second float.
//!
//! u = 2⁻⁵³. Every node of a formula carries its value x̂ in floats and a magnitude X̂, formed by the
//! same operations with − replaced by + and every input by its absolute value. Write x and X for what
//! exact arithmetic gives, D for the count of roundings, and θ(D) = (1 + u)^D − 1. All inputs are at
//! most 2^[`CAP`] in magnitude; so |x|, X, |x̂| and X̂ are at most 2^size with the sizes below, because
//! rounding is monotone and powers of two are floats.
//!
//! **Claim.** |x̂ − x| ≤ θ(D)·X + η, where η = 2^`lost` bounds what underflow took; the same for X̂.
//!
//! - *Input:* exact, D = 0, η = 0. *1 ± e:* one rounding of a number that is not negative, D = 1, and
//!   the magnitude may be the value itself; a sum never underflows.
//! - *Sum or difference*, D = max(a, b) + 1: before rounding the error is at most
//!   θ(a)·X + θ(b)·Y + η + η′, and rounding adds u times the computed sum: together at most
//!   ((1 + u)(1 + θ(max)) − 1)·(X + Y) + (1 + u)(η + η′), and the last is at most four times the larger.
//! - *Product*, D = a + b + 1: |x̂·ŷ − x·y| ≤ |x̂|·|ŷ − y| + |y|·|x̂ − x|, and |x̂| ≤ (1 + θ(a))·X + η:
//!   at most θ(a + b)·X·Y + η·(1 + θ(b))·Y + η′·|x̂|. Rounding multiplies by 1 + u, adds u·X·Y, and
//!   in the subnormal range at most 2⁻¹⁰⁷⁵: at most θ(D)·X·Y and four times the largest of
//!   2·η·2^size(y), η′·2^size(x) and 2⁻¹⁰⁷⁵.
//! - *Absolute value:* ||x̂| − |x|| ≤ |x̂ − x|.
//!
//! **Bound.** From the claim for X̂, X ≤ (X̂ + η)/(1 − θ(D)), so that |x̂ − x| ≤ θ/(1 − θ)·(X̂ + η) + η,
//! at most (D + 1)·u·X̂ + 2η for D < 2²⁰, where D²·u is far below 1/8. In floats we form
//! fl(fl((D + 2)·u·X̂) + 4η) with η ≥ 2⁻¹⁰²⁴: two roundings take less than u each from D + 2, an
//! underflow of the product less than η. So |x̂| beyond that proves that x has the sign of x̂.
//!
//! **Overflow** is excluded by the sizes; a NaN fails the comparison.
//!
//! D, size and lost are fields, and as every formula is inlined the compiler folds them to constants:
//! a new question derives its bound by itself.
#![allow(clippy::float_arithmetic, reason = "a float filter with a proved bound")]

use std::cmp::Ordering;

use super::arithmetic::Arithmetic;
use crate::bodies::SphereOnPlane;

/// Inputs are at most 2^this in magnitude, as the caller sees to.
const CAP: i32 = 100;

/// The bits of 2^[`CAP`]: magnitudes are ordered as their bits are.
pub(super) const GREATEST: u64 = (1023 + CAP.unsigned_abs() as u64) << 52;

/// 2^[`CAP`].
const LIMIT: f64 = f64::from_bits(GREATEST);

/// Whether all inputs are in their domains and at most 2^[`CAP`] in magnitude; may say no to some
/// that are. No branch, and vectors everywhere: for columns.
///
/// One comparison serves all upper ends: rounding is monotone, so where no summand is negative, a sum
/// in floats is at least as large as each of them. A NaN that a minimum passes over makes that sum
/// NaN, or is the restitution, and fails its comparison; so does an infinity.
#[inline]
pub(super) fn is_usual(sphere: &SphereOnPlane<f64>) -> bool {
    let SphereOnPlane { mass, radius, inertia, friction, restitution, before } = sphere;
    let least = |a: f64, b: f64| if a < b { a } else { b };
    let speeds = before.vy + (before.vx.abs() + before.omega.abs());
    let size = ((mass + radius) + (inertia + friction)) + speeds;
    let positive = least(*mass, least(*radius, *inertia)) > 0.0;
    let not_negative = least(*friction, least(*restitution, before.vy)) >= 0.0;
    positive & not_negative & (*restitution <= 1.0) & (size <= LIMIT)
}

/// Whether an input of either sign is at most 2^[`CAP`] in magnitude; false for NaN.
#[inline]
pub(super) const fn is_small(input: f64) -> bool {
    input.to_bits() << 1 <= GREATEST << 1
}

/// 2⁻⁵³.
const UNIT: f64 = f64::EPSILON / 2.0;

/// Below every exponent that matters: nothing is lost.
const NOTHING: i32 = -1_000_000;

/// A number in floats with a running bound on its error, for inputs of at most 2^[`CAP`].
#[derive(Clone, Copy)]
pub(super) struct Filter {
    value: f64,
    magnitude: f64,
    /// D.
    roundings: i32,
    size: i32,
    lost: i32,
}

/// 2^exponent for a normal one, which folds to a constant.
#[inline]
fn power(exponent: i32) -> f64 {
    f64::from_bits(u64::from((1023 + exponent).unsigned_abs()) << 52)
}

impl Filter {
    /// A number from 0 to 2, rounded once.
    #[inline]
    fn rounded_once(value: f64) -> Self {
        Self { value, magnitude: value, roundings: 1, size: 1, lost: NOTHING }
    }

    #[inline]
    fn sum(&self, other: &Self, value: f64) -> Self {
        Self {
            value,
            magnitude: self.magnitude + other.magnitude,
            roundings: self.roundings.max(other.roundings) + 1,
            size: self.size.max(other.size) + 1,
            lost: self.lost.max(other.lost) + 2,
        }
    }
}

impl Filter {
    /// The value, which has the sign of the exact one if it exceeds the bound in magnitude.
    #[inline]
    pub(super) const fn value(&self) -> f64 {
        self.value
    }

    /// The bound; ∞ for a formula that is too long for one.
    #[inline]
    pub(super) fn bound(&self) -> f64 {
        let slack = (self.lost + 2).max(-1022);
        if self.size > 1023 || self.roundings >= 1 << 20 || slack > 1023 {
            return f64::INFINITY;
        }
        f64::from(self.roundings + 2) * UNIT * self.magnitude + power(slack)
    }
}

impl Arithmetic for Filter {
    #[inline]
    fn number(input: f64) -> Self {
        Self { value: input, magnitude: input.abs(), roundings: 0, size: CAP, lost: NOTHING }
    }

    /// The magnitude is the value, which the compiler then computes once for both.
    #[inline]
    fn size(input: f64) -> Self {
        Self { magnitude: input, ..Self::number(input) }
    }

    #[inline]
    fn one_and(e: f64) -> Self {
        Self::rounded_once(1.0 + e)
    }

    #[inline]
    fn one_less(e: f64) -> Self {
        Self::rounded_once(1.0 - e)
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        self.sum(other, self.value + other.value)
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        self.sum(other, self.value - other.value)
    }

    #[inline]
    fn times(&self, other: &Self) -> Self {
        let lost = (self.lost + other.size + 1).max(other.lost + self.size).max(-1075);
        Self {
            value: self.value * other.value,
            magnitude: self.magnitude * other.magnitude,
            roundings: self.roundings + other.roundings + 1,
            size: self.size + other.size,
            lost: lost + 2,
        }
    }

    #[inline]
    fn abs(&self) -> Self {
        Self { value: self.value.abs(), ..*self }
    }

    #[inline]
    fn sign(&self) -> Option<Ordering> {
        let bound = self.bound();
        (self.value.abs() > bound).then_some(if self.value > 0.0 {
            Ordering::Greater
        } else {
            Ordering::Less
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_abstains_where_nothing_is_proved() {
        let x = Filter::number;
        assert_eq!(f64::from_bits(GREATEST), 2.0_f64.powi(CAP));
        assert_eq!(x(f64::NAN).sign(), None);
        assert_eq!(x(1e-200).times(&x(1e-200)).sign(), None); // underflow
        assert_eq!(x(1e-100).times(&x(1e-100)).sign(), Some(Ordering::Greater));
        assert_eq!(x(1.0).minus(&x(1.0)).sign(), None); // a tie is for a later stage
        let mut product = x(1.0);
        for _ in 0..10 {
            product = product.times(&x(1.0));
        }
        assert_eq!(product.sign(), None); // too long a product to exclude overflow
        assert_eq!(x(1.0).minus(&x(1.0_f64.next_up())).sign(), None); // within 3u of 2
        assert_eq!(x(1.0).minus(&x(1.0 + 8.0 * f64::EPSILON)).sign(), Some(Ordering::Less));
    }

    #[test]
    fn no_input_outside_of_its_domain_is_usual() {
        use crate::bodies::Motion;
        let sphere = |inputs: [f64; 8]| {
            let [mass, radius, inertia, friction, restitution, vx, vy, omega] = inputs;
            let before = Motion { vx, vy, omega };
            SphereOnPlane { mass, radius, inertia, friction, restitution, before }
        };
        let sound = [1.0, 2.0, 0.5, 0.0, 1.0, -3.0, 0.0, -4.0];
        assert!(is_usual(&sphere(sound)));
        let beyond =
            [f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 2.0 * LIMIT, -2.0 * LIMIT];
        let negative = [-1.0, -f64::from_bits(1), -f64::MIN_POSITIVE];
        for index in 0..8 {
            let with = |value: f64| {
                let mut inputs = sound;
                inputs[index] = value;
                is_usual(&sphere(inputs))
            };
            assert!(beyond.iter().all(|&value| !with(value)), "{index}");
            let may_be_negative = index == 5 || index == 7;
            assert!(negative.iter().all(|&value| with(value) == may_be_negative), "{index}");
            assert_eq!(with(0.0), index > 2, "{index}");
            assert_eq!(with(1.0_f64.next_up()), index != 4, "{index}");
        }
        // two wrongs do not make a right: one negative input hides a large one from the sum only
        let mut inputs = sound;
        (inputs[0], inputs[1]) = (-2.0 * LIMIT, 2.0 * LIMIT);
        assert!(!is_usual(&sphere(inputs)));
    }

    /// What underflow takes from a factor grows with the cofactor.
    #[test]
    fn a_large_cofactor_does_not_hide_an_underflow() {
        let x = Filter::number;
        let (tiny, large) = (x(2.0_f64.powi(-538)), x(2.0_f64.powi(100)));
        let lost = tiny.times(&tiny); // 2^−1076 in truth, 0 in floats
        let raised = (0..5).fold(lost, |product, _| product.times(&large)); // 2^−576 in truth
        let other = x(2.0_f64.powi(-600));
        assert_eq!(raised.minus(&other).sign(), None);
    }
}
