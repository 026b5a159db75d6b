//! Float operations rounded in a given direction, exact results left alone.
#![allow(clippy::float_arithmetic, reason = "directed rounding is a float operation and a step")]

use crate::error_free::{two_product, two_sum};
use crate::format::Format;

/// To which side a result is rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outward {
    /// Toward −∞.
    Down,
    /// Toward +∞.
    Up,
}

/// a + b, to the next float in the direction. Correctly rounded unless it overflows.
pub(crate) fn sum<F: Format>(a: F, b: F, direction: Outward) -> F {
    let (sum, error) = two_sum(a, b);
    settle(sum, error, direction, a.is_infinite() || b.is_infinite())
}

/// a·b, with 0·∞ = 0: an infinite end is a bound, and zero times any number is zero.
pub(crate) fn product<F: Format>(a: F, b: F, direction: Outward) -> F {
    let zero = F::zero();
    if a == zero || b == zero {
        return zero;
    }
    let infinite = a.is_infinite() || b.is_infinite();
    let (product, error) = two_product(a, b);
    if product.abs() < F::small() {
        return step(product, direction);
    }
    settle(product, error, direction, infinite)
}

/// a/b for b ≠ 0; ∞/∞ may be anything from 0 on, and a corner of it is given as 0 or ±∞.
pub(crate) fn quotient<F: Format>(a: F, b: F, direction: Outward) -> F {
    let zero = F::zero();
    // Bounded over beyond all bounds: as near to 0 as one likes, from one side. With an
    // infinite numerator the other corners reach ∞ already, and this one adds 0.
    if a == zero || b.is_infinite() {
        return zero;
    }
    let quotient = a / b;
    if a.is_infinite() {
        return quotient;
    }
    let small = |x: F| x.abs() < F::small();
    if small(quotient) || small(a) {
        return step(quotient, direction);
    }
    // The residue a − q·b is a float; over b it has the sign of the error.
    let (product, error) = two_product(quotient, b);
    // It is NaN where the product overflows, or the quotient has.
    let residue = (a - product) - error;
    let sign = if b.is_negative() { -residue } else { residue };
    settle(quotient, sign, direction, false)
}

/// √a for a ≥ 0.
pub(crate) fn root<F: Format>(a: F, direction: Outward) -> F {
    let root = a.sqrt();
    if a == F::zero() || a.is_infinite() {
        return root;
    }
    if a < F::small() {
        // it is not below 0: the least float has a root that is greater by far
        return step(root, direction);
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
fn settle<F: Format>(nearest: F, error: F, direction: Outward, from_infinite: bool) -> F {
    if from_infinite {
        return nearest;
    }
    if nearest.is_infinite() {
        let negative = nearest.is_negative();
        return match direction {
            Outward::Down if !negative => F::greatest(),
            Outward::Up if negative => -F::greatest(),
            Outward::Down | Outward::Up => nearest,
        };
    }
    let beyond = match direction {
        Outward::Down => error < F::zero(),
        Outward::Up => error > F::zero(),
    };
    // NaN stands for an error that is not known.
    if beyond || error.is_nan() { step(nearest, direction) } else { nearest }
}

fn step<F: Format>(float: F, direction: Outward) -> F {
    match direction {
        Outward::Down => float.next_down(),
        Outward::Up => float.next_up(),
    }
}
