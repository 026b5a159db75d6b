//! The first stage: a float, and a bound on its error that costs a second float.
//!
//! u = 2⁻⁵³. Every node of a formula carries its value x̂ in floats and a magnitude X̂, formed by the
//! same operations with − replaced by + and every input by its absolute value. Write x and X for what
//! exact arithmetic gives, D for the count of roundings below, and θ(D) = (1 + u)^D − 1.
//!
//! **Claim.** Where nothing under- or overflows, |x̂ − x| ≤ θ(D)·X, |x| ≤ X and X̂ ≥ (1 − u)^D·X.
//!
//! - *Input:* exact, D = 0. *1 ± e:* one rounding of a number that is not negative, D = 1, and the
//!   magnitude may be the value itself.
//! - *Sum or difference*, D = max(a, b) + 1: before rounding the error is at most θ(a)·X + θ(b)·Y;
//!   rounding adds u times the computed sum: together at most ((1 + u)(1 + θ(max)) − 1)·(X + Y).
//! - *Product*, D = a + b + 1: |x̂·ŷ − x·y| ≤ |x̂|·|ŷ − y| + |y|·|x̂ − x| ≤ ((1 + θ(a))(1 + θ(b)) − 1)·X·Y
//!   and 1 + θ(a + b) = (1 + θ(a))(1 + θ(b)); then rounding as above.
//! - *Absolute value:* ||x̂| − |x|| ≤ |x̂ − x|.
//! - X̂ is made of sums and products of numbers ≥ 0, so that every rounding costs at most 1 − u.
//!
//! **Bound.** |x̂ − x| ≤ θ(D)·(1 − u)^−D·X̂ ≤ (D + 1)·u·X̂ for D < 2²⁰, where D²·u is far below 1/8.
//! The product (D + 2)·u·X̂ is rounded once and still at least that. So |x̂| > fl((D + 2)·u·X̂) proves
//! that x has the sign of x̂.
//!
//! **Overflow.** Rounding is monotone, so |x̂| ≤ X̂ at every node: if something overflows, or is NaN,
//! the last X̂ is ∞ or NaN, and the comparison fails.
//!
//! **Underflow.** An input that is 0 or at least 2⁻¹⁰⁰ in magnitude is a multiple of 2⁻¹⁵², and so
//! is no smaller unless it is 0; 1 ± e in floats is a multiple of 2⁻⁵³. A product of multiples of 2⁻ᵃ
//! and 2⁻ᵇ is a multiple of 2^−(a + b), a sum of 2^−max(a, b), and rounding keeps that, since it
//! either leaves a number alone or makes it a multiple of a larger power. A multiple of 2⁻¹⁰⁷⁴ that is
//! below the normal range is a float, and loses nothing. So with h for the exponent that results,
//! there is no underflow if h ≤ 1074; for the product with the constant, which is at least 2⁻⁵³, we
//! ask h + 53 ≤ 1022. If an input is smaller, the stage abstains.
//!
//! D and h are fields, and as every formula is inlined the compiler folds them to constants: a new
//! question derives its bound by itself.
#![allow(clippy::float_arithmetic, reason = "a float filter with a proved bound")]

use std::cmp::Ordering;

use super::arithmetic::Arithmetic;

/// 2⁻¹⁰⁰: inputs below it may underflow.
const LEAST: u64 = (1023 - 100) << 52;

/// An input of that size or above is a multiple of 2^−this.
const INPUT_HALVINGS: u32 = 100 + 52;

/// 2⁻⁵³.
const UNIT: f64 = f64::EPSILON / 2.0;

/// A number in floats with a running bound on its error.
#[derive(Clone, Copy)]
pub(super) struct Filter {
    value: f64,
    magnitude: f64,
    /// D.
    roundings: u32,
    /// h: value and magnitude are multiples of 2^−h.
    halvings: u32,
    /// Whether every input is 0 or at least 2⁻¹⁰⁰.
    in_range: bool,
}

impl Filter {
    /// A number that is not negative, rounded once and a multiple of 2⁻⁵³.
    #[inline]
    fn rounded_once(value: f64) -> Self {
        Self { value, magnitude: value, roundings: 1, halvings: 53, in_range: true }
    }

    #[inline]
    fn is_in_range(input: f64) -> bool {
        // twice the bits drop the sign, and 0 − 1 is the greatest integer: one comparison
        (input.to_bits() << 1).wrapping_sub(1) >= (LEAST << 1) - 1
    }

    #[inline]
    fn sum(&self, other: &Self, value: f64) -> Self {
        Self {
            value,
            magnitude: self.magnitude + other.magnitude,
            roundings: self.roundings.max(other.roundings) + 1,
            halvings: self.halvings.max(other.halvings),
            in_range: self.in_range & other.in_range,
        }
    }
}

impl Arithmetic for Filter {
    #[inline]
    fn number(input: f64) -> Self {
        let in_range = Self::is_in_range(input);
        let halvings = INPUT_HALVINGS;
        Self { value: input, magnitude: input.abs(), roundings: 0, halvings, in_range }
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
        Self {
            value: self.value * other.value,
            magnitude: self.magnitude * other.magnitude,
            roundings: self.roundings + other.roundings + 1,
            halvings: self.halvings + other.halvings,
            in_range: self.in_range & other.in_range,
        }
    }

    #[inline]
    fn abs(&self) -> Self {
        Self { value: self.value.abs(), ..*self }
    }

    #[inline]
    fn sign(&self) -> Option<Ordering> {
        let bound = f64::from(self.roundings + 2) * UNIT * self.magnitude;
        let proved = self.halvings <= 1022 - 53
            && self.roundings < 1 << 20
            && self.in_range & (self.value.abs() > bound);
        proved.then_some(if self.value > 0.0 { Ordering::Greater } else { Ordering::Less })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_range_begins_at_its_least_input() {
        let least = f64::from_bits(LEAST);
        assert_eq!(least, 2.0_f64.powi(-100));
        for inside in [0.0, -0.0, least, -least, 1.0, f64::MAX] {
            assert!(Filter::is_in_range(inside), "{inside}");
        }
        for outside in [least.next_down(), -least.next_down(), f64::from_bits(1)] {
            assert!(!Filter::is_in_range(outside), "{outside}");
        }
    }

    #[test]
    fn it_abstains_where_nothing_is_proved() {
        let x = Filter::number;
        let large = x(1e300);
        assert_eq!(large.times(&large).sign(), None); // overflow
        assert_eq!(x(f64::NAN).sign(), None);
        assert_eq!(x(1e-40).times(&x(1e-40)).sign(), None); // may underflow
        assert_eq!(x(1.0).minus(&x(1.0)).sign(), None); // a tie is for a later stage
        let mut product = x(1.0);
        for _ in 0..6 {
            product = product.times(&x(1.0));
        }
        assert_eq!(product.sign(), None); // too long a product to exclude underflow
        assert_eq!(x(1.0).minus(&x(1.0_f64.next_up())).sign(), None); // within 3u of 2
        assert_eq!(x(1.0).minus(&x(1.0 + 8.0 * f64::EPSILON)).sign(), Some(Ordering::Less));
    }
}
