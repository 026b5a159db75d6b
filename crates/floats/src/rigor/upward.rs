//! Float arithmetic that never comes out too small, for numbers that are not negative.
#![allow(clippy::float_arithmetic, reason = "bounds are floats, rounded upward")]

/// a + b, rounded up.
pub(super) fn plus(a: f64, b: f64) -> f64 {
    if a == 0.0 {
        b
    } else if b == 0.0 {
        a
    } else {
        (a + b).next_up()
    }
}

/// a·b, rounded up; nothing times anything is nothing, and by a power of two nothing is lost.
pub(super) fn times(a: f64, b: f64) -> f64 {
    let product = a * b;
    if a == 0.0 || b == 0.0 {
        0.0
    } else if product.is_normal() && (is_power(a) || is_power(b)) {
        product
    } else {
        product.next_up()
    }
}

/// Whether a normal float is a power of two.
const fn is_power(x: f64) -> bool {
    x.is_normal() && x.to_bits() & ((1 << 52) - 1) == 0
}

/// a/b, rounded up; ∞ for b = 0 unless a = 0.
pub(super) fn over(a: f64, b: f64) -> f64 {
    if a == 0.0 {
        0.0
    } else if b == 0.0 {
        f64::INFINITY
    } else {
        (a / b).next_up()
    }
}

/// √a, rounded up.
pub(super) fn root(a: f64) -> f64 {
    if a == 0.0 { 0.0 } else { a.sqrt().next_up() }
}

/// 2^exponent, rounded up to the least subnormal; ∞ from 2^1024 on.
pub(crate) fn power(exponent: i64) -> f64 {
    match exponent {
        e if e > 1023 => f64::INFINITY,
        e if e >= -1022 => f64::from_bits((e + 1023).unsigned_abs() << 52),
        e if e >= -1074 => f64::from_bits(1 << (e + 1074).unsigned_abs()),
        _ => f64::from_bits(1),
    }
}

/// The exponent b with 2^b ≤ x < 2^(b+1), for finite x > 0.
pub(crate) fn binade(x: f64) -> i64 {
    let bits = x.to_bits() & (u64::MAX >> 1);
    let field = i64::try_from(bits >> 52).unwrap_or(0);
    if field > 0 { field - 1023 } else { 63 - i64::from(bits.leading_zeros()) - 1074 }
}

/// The greatest magnitude in an interval.
pub(super) fn greatest(interval: kane_number::Interval) -> f64 {
    interval.lower().abs().max(interval.upper().abs())
}

/// The least magnitude in an interval.
pub(super) fn least(interval: kane_number::Interval) -> f64 {
    if interval.contains_zero() { 0.0 } else { interval.lower().abs().min(interval.upper().abs()) }
}

/// An interval and what is within `by` of it.
pub(super) fn widened(interval: kane_number::Interval, by: f64) -> kane_number::Interval {
    use kane_number::Interval;
    if by == 0.0 {
        return interval;
    }
    if by.is_infinite() {
        return Interval::WHOLE;
    }
    Interval::between((interval.lower() - by).next_down(), (interval.upper() + by).next_up())
}
