//! Sums of floats that do not depend on the order of their terms.
#![allow(clippy::float_arithmetic, reason = "the rounding errors of floats are kept as floats")]

use crate::error_free::two_sum;

/// A sum of floats without rounding, as floats of which none overlaps another (Shewchuk, Discrete &
/// Computational Geometry 18, 1997, section 2.4).
///
/// Sums of parts, added up in any order, are the same number. Terms of one binary order are integers times one
/// power of two: they are added as such, for the last `ORDERS` orders, and what another order displaces goes
/// to the floats, of which there are forty at most. So an addition is one of integers where the terms differ by
/// less than 2^`ORDERS`. Exact unless a sum overflows; then, and with a term that is not finite, the value is
/// that of IEEE 754.
///
/// ```
/// let mut sum = kane_number::ExactSum::default();
/// [1e100, 1.0, -1e100].into_iter().for_each(|term| sum.add(term));
/// assert_eq!(sum.value(), 1.0);
/// ```
#[derive(Clone, Debug, Default)]
pub struct ExactSum {
    /// sums of the significands of an order, each at the place of its order modulo `ORDERS`
    sums: [i128; ORDERS],
    /// the biased exponents of these orders
    orders: [u16; ORDERS],
    /// by rising magnitude; none is zero
    parts: Vec<f64>,
    /// what is not finite
    beyond: Option<f64>,
}

/// How many binary orders are summed as integers.
const ORDERS: usize = 32;

/// The bits of a significand that are written.
const WRITTEN: u32 = f64::MANTISSA_DIGITS - 1;

impl ExactSum {
    /// Adds a term.
    #[inline]
    pub fn add(&mut self, term: f64) {
        let bits = term.abs().to_bits();
        let order = u16::try_from(bits >> WRITTEN).unwrap_or(0x7ff);
        if order == 0x7ff {
            self.beyond = Some(self.beyond.unwrap_or(0.0) + term);
            return;
        }
        let written = i128::from(bits & ((1 << WRITTEN) - 1));
        // a subnormal has the order of the least normal numbers, and no hidden bit
        let (order, significand) =
            if order == 0 { (1, written) } else { (order, written | 1 << WRITTEN) };
        let place = usize::from(order) % ORDERS;
        if self.orders[place] != order {
            self.displace(place);
            self.orders[place] = order;
        }
        self.sums[place] += if term.is_sign_negative() { -significand } else { significand };
    }

    /// Takes the integers of an order to the floats.
    fn displace(&mut self, place: usize) {
        let mut left = std::mem::take(&mut self.sums[place]);
        // 2^(order − 1075), which a subnormal may be
        let (half, rest) = match i32::from(self.orders[place]) - 1075 {
            scale @ ..-1000 => (2_f64.powi(-1000), 2_f64.powi(scale + 1000)),
            scale => (1.0, 2_f64.powi(scale)),
        };
        while left != 0 {
            // at most 53 bits of the highest, so that the conversion and the scaling are exact
            let low = (i128::BITS - left.unsigned_abs().leading_zeros()).saturating_sub(53);
            let high = left >> low << low;
            left -= high;
            #[allow(clippy::cast_precision_loss, reason = "it has 53 bits at most")]
            let high = high as f64;
            self.add_float(high * half * rest);
        }
    }

    /// Adds a float to the floats.
    fn add_float(&mut self, term: f64) {
        if !term.is_finite() {
            self.beyond = Some(self.beyond.unwrap_or(0.0) + term);
            return;
        }
        let (mut carry, mut kept) = (term, 0);
        for place in 0..self.parts.len() {
            let (sum, error) = two_sum(carry, self.parts[place]);
            if error != 0.0 {
                self.parts[kept] = error;
                kept += 1;
            }
            carry = sum;
        }
        self.parts.truncate(kept);
        if !carry.is_finite() {
            self.parts.clear();
            self.beyond = Some(self.beyond.unwrap_or(0.0) + carry);
        } else if carry != 0.0 {
            self.parts.push(carry);
        }
    }

    /// Adds another sum.
    pub fn merge(&mut self, other: &Self) {
        other.terms().for_each(|term| self.add(term));
    }

    /// Floats whose sum it is, few.
    pub fn terms(&self) -> impl Iterator<Item = f64> + use<> {
        let Self { parts, beyond, .. } = self.settled();
        parts.into_iter().chain(beyond)
    }

    /// The same sum in floats alone.
    fn settled(&self) -> Self {
        let mut settled = self.clone();
        (0..ORDERS).for_each(|place| settled.displace(place));
        settled
    }

    /// The sum, correctly rounded to the nearest float, ties to even.
    #[must_use]
    pub fn value(&self) -> f64 {
        let Self { parts, beyond, .. } = self.settled();
        if let Some(beyond) = beyond {
            return beyond;
        }
        let mut parts = parts.into_iter().rev();
        let Some(mut high) = parts.next() else { return 0.0 };
        while let Some(part) = parts.next() {
            let (sum, error) = two_sum(high, part);
            high = sum;
            if error == 0.0 {
                continue;
            }
            // half a unit that was rounded to even: what is left says to which side
            let twice = error * 2.0;
            let next = parts.next().unwrap_or(0.0);
            let same_side = next.is_sign_negative() == error.is_sign_negative();
            if next != 0.0 && same_side && (high + twice) - high == twice {
                high += twice;
            }
            break;
        }
        high
    }
}

#[cfg(test)]
mod tests {
    use num_traits::Zero as _;

    use super::*;
    use crate::{Rational, Rounding, decode, encode};

    /// Numbers of many magnitudes and both signs.
    fn terms() -> Vec<f64> {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        (0..400)
            .map(|_| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                let exponent = (state >> 40) % 120 + 960;
                f64::from_bits(state & 0x800f_ffff_ffff_ffff | exponent << 52)
            })
            .collect()
    }

    #[test]
    fn a_sum_is_the_nearest_float_of_the_sum_in_fractions() {
        let terms = terms();
        let mut sum = ExactSum::default();
        let mut fraction = Rational::zero();
        for term in &terms {
            sum.add(*term);
            fraction += decode(*term).expect("it is finite");
            let parts = sum.terms().map(|part| decode(part).expect("it is finite"));
            assert_eq!(parts.sum::<Rational>(), fraction);
            assert_eq!(sum.value(), encode::<f64>(&fraction, Rounding::NearestEven));
        }
    }

    /// Terms from the least subnormal on, in orders that displace each other.
    #[test]
    fn sums_of_any_floats_are_those_of_fractions() {
        let mut state = 1_u64;
        for spread in [1, 3, 40, 900] {
            for base in [0, 1, 2, 60, 1000] {
                let (mut sum, mut fraction) = (ExactSum::default(), Rational::zero());
                for _ in 0..60 {
                    state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                    let exponent = base + (state >> 40) % spread;
                    let term = f64::from_bits(state & 0x800f_ffff_ffff_ffff | exponent << 52);
                    sum.add(term);
                    fraction += decode(term).expect("it is finite");
                    assert_eq!(sum.value(), encode::<f64>(&fraction, Rounding::NearestEven));
                }
            }
        }
    }

    #[test]
    fn half_a_unit_is_rounded_by_what_is_below_it() {
        for (terms, expected) in [
            (vec![1.0, f64::EPSILON / 2.0], 1.0),
            (vec![1.0, f64::EPSILON / 2.0, 1e-300], 1.0 + f64::EPSILON),
            (vec![1.0, f64::EPSILON / 2.0, -1e-300], 1.0),
            (vec![-1.0, -f64::EPSILON / 2.0, -1e-300], -1.0 - f64::EPSILON),
        ] {
            let mut sum = ExactSum::default();
            terms.iter().for_each(|term| sum.add(*term));
            assert_eq!(sum.value(), expected, "{terms:?}");
        }
    }

    #[test]
    fn the_order_of_parts_does_not_matter() {
        let terms = terms();
        let mut whole = ExactSum::default();
        terms.iter().for_each(|term| whole.add(*term));
        let mut merged = ExactSum::default();
        for part in terms.rchunks(37) {
            let mut sum = ExactSum::default();
            part.iter().for_each(|term| sum.add(*term));
            merged.merge(&sum);
        }
        assert_eq!(merged.value().to_bits(), whole.value().to_bits());
    }

    #[test]
    fn what_is_not_finite_is_said() {
        let mut sum = ExactSum::default();
        [f64::MAX, f64::MAX, 1.0].into_iter().for_each(|term| sum.add(term));
        assert_eq!(sum.value(), f64::INFINITY);
        sum.add(f64::NEG_INFINITY);
        assert!(sum.value().is_nan());
        // of two orders, each of whose sums is a float
        for sign in [1.0, -1.0] {
            let mut sum = ExactSum::default();
            [f64::MAX, 8e307].into_iter().for_each(|term| sum.add(sign * term));
            assert_eq!(sum.value(), sign * f64::INFINITY);
        }
        // what is not finite stays, whatever comes after it
        for (first, then, whole) in [
            (f64::INFINITY, f64::MAX, f64::INFINITY),
            (f64::INFINITY, f64::INFINITY, f64::INFINITY),
            (f64::NEG_INFINITY, 1.0, f64::NEG_INFINITY),
        ] {
            let mut sum = ExactSum::default();
            [first, then, then, then].into_iter().for_each(|term| sum.add(term));
            assert_eq!(sum.value(), whole);
        }
    }
}
