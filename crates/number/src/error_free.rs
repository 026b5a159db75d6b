//! Error-free transformations: a float operation together with its rounding error.
#![allow(clippy::float_arithmetic, reason = "rounding errors are themselves found by floats")]

use crate::format::Format;

/// a + b as (s, e) with s the nearest float and s + e = a + b.
///
/// Exact unless s overflows (Knuth, TAOCP 2, section 4.2.2, theorem B).
pub(crate) fn two_sum<F: Format>(a: F, b: F) -> (F, F) {
    let sum = a + b;
    let b_part = sum - a;
    let a_part = sum - b_part;
    let error = (a - a_part) + (b - b_part);
    if error.is_nan() { ordered_two_sum(a, b) } else { (sum, error) }
}

/// The same where a part overflows though s does not: with the greatest float as b and a sum that is rounded away from 0
/// (Boldo, Graillat and Muller 2017, "On the robustness of the 2Sum and Fast2Sum algorithms", section 3).
#[cold]
fn ordered_two_sum<F: Format>(a: F, b: F) -> (F, F) {
    if a.abs() < b.abs() { fast_two_sum(b, a) } else { fast_two_sum(a, b) }
}

/// The same for |a| ≥ |b| or a = 0, at half the cost (Dekker 1971).
pub(crate) fn fast_two_sum<F: Format>(a: F, b: F) -> (F, F) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// a·b as (p, e) with p the nearest float and p + e = a·b.
///
/// Exact if p does not overflow and |a·b| ≥ 2^(LEAST_EXPONENT + 2·PRECISION), which is 2^−968 in `f64`, or if the product
/// is zero: below that the error itself may underflow. By a fused multiply-add where the target has one, by the splitting
/// of Dekker and Veltkamp elsewhere (Dekker 1971).
pub(crate) fn two_product<F: Format>(a: F, b: F) -> (F, F) {
    // Splitting multiplies by 2^27 + 1, which would overflow; and the upper halves, rounded up, have a product above that
    // of the floats. The library's fused operation is slow there but right.
    let top = F::power_of_two(F::GREATEST_EXPONENT);
    let splits = a.abs() < F::splittable() && b.abs() < F::splittable() && (a * b).abs() < top;
    if F::FUSED || !splits { fused_product(a, b) } else { split_product(a, b) }
}

pub(crate) fn fused_product<F: Format>(a: F, b: F) -> (F, F) {
    let product = a * b;
    (product, a.mul_add(b, -product))
}

pub(crate) fn split_product<F: Format>(a: F, b: F) -> (F, F) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    let rest = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, rest)
}

/// A float as the sum of two of half its bits, the second signed (Veltkamp).
fn split<F: Format>(a: F) -> (F, F) {
    let spread = F::spread() * a;
    let high = spread - (spread - a);
    (high, a - high)
}

/// The power of two 2^exponent, for −1022 ≤ exponent ≤ 1023.
pub(crate) fn power_of_two(exponent: i64) -> f64 {
    Format::power_of_two(exponent)
}

/// x·2^exponent, rounded once: overflow gives ±∞, underflow the nearest subnormal or zero.
pub(crate) fn scale(x: f64, exponent: i64) -> f64 {
    // Steps toward zero leave 53 bits above the subnormals, so that only the last one rounds.
    const DOWN: i64 = 53 - 1022;
    let (mut x, mut left) = (x, exponent.clamp(-2200, 2200));
    while left > 1023 {
        x *= power_of_two(1023);
        left -= 1023;
    }
    while left < -1022 {
        x *= power_of_two(DOWN);
        left -= DOWN;
    }
    x * power_of_two(left)
}

/// The binade of a finite non-zero float: the b with 2^b ≤ |x| < 2^(b+1), subnormals included.
pub(crate) fn binade(x: f64) -> i64 {
    let biased = (x.to_bits() >> 52 & 0x7ff).cast_signed();
    if biased == 0 {
        let fraction = x.to_bits() & ((1 << 52) - 1);
        return i64::from(63 - fraction.leading_zeros()) - 1074;
    }
    biased - 1023
}

/// A sum of floats as (h, l): h within an ulp of the sum, h + l within 2^−104 of it, relatively.
///
/// The sum is first formed without any error as an expansion of floats that do not overlap
/// (Shewchuk 1997, "Adaptive precision floating-point arithmetic", figures 7 and 15).
pub(crate) fn sum_of(terms: &[f64]) -> (f64, f64) {
    const MOST: usize = 16;
    let mut expansion = [0.0; MOST];
    let mut length = 0;
    debug_assert!(terms.len() <= MOST, "room for {MOST} terms");
    for &term in terms {
        let mut carry = term;
        let mut kept = 0;
        for index in 0..length {
            let (sum, error) = two_sum(carry, expansion[index]);
            carry = sum;
            if error != 0.0 {
                expansion[kept] = error;
                kept += 1;
            }
        }
        expansion[kept] = carry;
        length = kept + 1;
    }
    // From the greatest down, then up again: each pass moves bits toward the front.
    let mut rest = [0.0; MOST];
    let (mut carry, mut bottom) = (expansion[length - 1], length);
    for &part in expansion[..length - 1].iter().rev() {
        let (sum, error) = fast_two_sum(carry, part);
        carry = sum;
        if error != 0.0 {
            bottom -= 1;
            rest[bottom] = sum;
            carry = error;
        }
    }
    bottom -= 1;
    rest[bottom] = carry;
    let (mut high, mut low) = (rest[bottom], 0.0);
    for &part in &rest[bottom + 1..length] {
        let (sum, error) = fast_two_sum(part, high);
        high = sum;
        low += error;
    }
    fast_two_sum(high, low)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Rounding, decode, encode, power_of};

    #[test]
    fn binades_and_scaled_floats_are_those_of_fractions() {
        let mut state = 7_u64;
        for round in 0..4_000_u64 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            // of every binade, and every fourth subnormal with as many leading zeros as it likes
            let bits = state >> 1;
            let bits = if round % 4 == 0 { bits >> (11 + round % 53) } else { bits };
            let x = f64::from_bits(bits);
            if !x.is_finite() || x == 0.0 {
                continue;
            }
            let exact = decode(x).expect("it is finite");
            let at = binade(x);
            assert!(power_of(2, at) <= exact && exact < power_of(2, at + 1), "{x:e}: {at}");
            assert_eq!(binade(-x), at);
            let by = i64::try_from(state % 4_400).expect("it is small") - 2_200;
            let scaled: f64 = encode(&(exact * power_of(2, by)), Rounding::NearestEven);
            assert_eq!(scale(x, by), scaled, "{x:e}·2^{by}");
        }
    }
}
