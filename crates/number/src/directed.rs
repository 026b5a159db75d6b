//! Float operations rounded in a given direction, exact results left alone.
#![allow(clippy::float_arithmetic, reason = "directed rounding is a float operation and a step")]

use crate::error_free::{two_product, two_sum};

/// To which side a result is rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outward {
    /// Toward −∞.
    Down,
    /// Toward +∞.
    Up,
}

/// Below this, 2^−960, the error of a product may underflow: its sign is no longer known.
const SMALL: f64 = f64::from_bits((1023 - 960) << 52);

/// a + b, to the next float in the direction. Correctly rounded unless it overflows.
pub(crate) fn sum(a: f64, b: f64, direction: Outward) -> f64 {
    let (sum, error) = two_sum(a, b);
    settle(sum, error, direction, a.is_infinite() || b.is_infinite())
}

/// a·b, with 0·∞ = 0: an infinite end is a bound, and zero times any number is zero.
pub(crate) fn product(a: f64, b: f64, direction: Outward) -> f64 {
    if a == 0.0 || b == 0.0 {
        return 0.0;
    }
    let infinite = a.is_infinite() || b.is_infinite();
    let (product, error) = two_product(a, b);
    if product.abs() < SMALL {
        return step(product, direction);
    }
    settle(product, error, direction, infinite)
}

/// a/b for b ≠ 0; ∞/∞ may be anything from 0 on, and a corner of it is given as 0 or ±∞.
pub(crate) fn quotient(a: f64, b: f64, direction: Outward) -> f64 {
    if a == 0.0 {
        return 0.0;
    }
    if b.is_infinite() {
        // Bounded over beyond all bounds: as near to 0 as one likes, from one side. With an
        // infinite numerator the other corners reach ∞ already, and this one adds 0.
        return 0.0;
    }
    let quotient = a / b;
    let infinite = a.is_infinite();
    let small = |x: f64| x.abs() < SMALL;
    if small(quotient) || (small(a) && !infinite) {
        return step(quotient, direction);
    }
    if infinite || quotient.is_infinite() {
        return settle(quotient, 0.0, direction, infinite);
    }
    // The residue a − q·b is a float; over b it has the sign of the error.
    let (product, error) = two_product(quotient, b);
    let residue = (a - product) - error;
    if !residue.is_finite() {
        return step(quotient, direction);
    }
    let sign = if b < 0.0 { -residue } else { residue };
    settle(quotient, sign, direction, false)
}

/// √a for a ≥ 0.
pub(crate) fn root(a: f64, direction: Outward) -> f64 {
    let root = a.sqrt();
    if a == 0.0 || a.is_infinite() {
        return root;
    }
    if a < SMALL {
        return step(root, direction).max(0.0);
    }
    let (square, error) = two_product(root, root);
    settle(root, (a - square) - error, direction, false)
}

/// The least and the greatest magnitude between two floats.
pub(crate) fn power_range(lower: f64, upper: f64) -> (f64, f64) {
    let (a, b) = (lower.abs(), upper.abs());
    let least = if lower <= 0.0 && 0.0 <= upper { 0.0 } else { a.min(b) };
    (least, a.max(b))
}

/// The float on the wanted side, given the nearest one and the sign of what it lacks.
///
/// A finite operation that overflowed lies beyond the greatest float: toward zero that float
/// bounds it.
fn settle(nearest: f64, error: f64, direction: Outward, from_infinite: bool) -> f64 {
    if from_infinite {
        return nearest;
    }
    if nearest.is_infinite() {
        return match direction {
            Outward::Down => nearest.min(f64::MAX),
            Outward::Up => nearest.max(f64::MIN),
        };
    }
    let beyond = match direction {
        Outward::Down => error < 0.0,
        Outward::Up => error > 0.0,
    };
    // NaN stands for an error that is not known.
    if beyond || error.is_nan() { step(nearest, direction) } else { nearest }
}

fn step(float: f64, direction: Outward) -> f64 {
    match direction {
        Outward::Down => float.next_down(),
        Outward::Up => float.next_up(),
    }
}
