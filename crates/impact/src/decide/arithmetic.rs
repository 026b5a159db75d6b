//! What a question is asked in: sums, products and absolute values, in three kinds of arithmetic.

use std::cmp::Ordering;

use kane_number::{Fixed, Interval, Number as _, Ordered as _};

/// Arithmetic in which a question can be evaluated, and its sign perhaps told.
///
/// There is no division, so every finite float, an integer times a power of two, stays one.
pub(crate) trait Arithmetic: Sized {
    /// An input of either sign.
    fn number(input: f64) -> Self;

    /// An input that is known not to be negative.
    fn size(input: f64) -> Self {
        Self::number(input)
    }

    /// 1 + e for 0 ≤ e ≤ 1.
    fn one_and(e: f64) -> Self {
        Self::number(1.0).plus(&Self::number(e))
    }

    /// 1 − e for 0 ≤ e ≤ 1.
    fn one_less(e: f64) -> Self {
        Self::number(1.0).minus(&Self::number(e))
    }

    /// The sum.
    fn plus(&self, other: &Self) -> Self;

    /// The difference.
    fn minus(&self, other: &Self) -> Self;

    /// The product.
    fn times(&self, other: &Self) -> Self;

    /// The absolute value.
    fn abs(&self) -> Self;

    /// The sign, or `None` if this arithmetic cannot tell.
    fn sign(&self) -> Option<Ordering>;

    /// Twice the number.
    fn double(&self) -> Self {
        self.plus(self)
    }
}

/// (M, E) with |float| = M·2^E and M odd or 0, and whether the sign bit is set. For finite floats.
pub(super) const fn parts(float: f64) -> (bool, u64, i64) {
    let bits = float.to_bits();
    let (fraction, biased) = (bits & ((1 << 52) - 1), (bits >> 52 & 0x7ff).cast_signed());
    let (mantissa, exponent) =
        if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
    if mantissa == 0 {
        return (false, 0, 0);
    }
    let twos = mantissa.trailing_zeros();
    (bits >> 63 == 1, mantissa >> twos, exponent + twos as i64)
}

impl Arithmetic for Interval {
    fn number(input: f64) -> Self {
        Self::from(input)
    }

    fn plus(&self, other: &Self) -> Self {
        *self + other
    }

    fn minus(&self, other: &Self) -> Self {
        *self - other
    }

    fn times(&self, other: &Self) -> Self {
        *self * other
    }

    fn abs(&self) -> Self {
        let Some(part) = self.intersection(&Self::between(0.0, f64::INFINITY)) else {
            return -*self;
        };
        if self.lower() >= 0.0 {
            return *self;
        }
        // both signs are possible: from 0 to the farther end
        Self::between(0.0, part.upper().max(self.lower().abs()))
    }

    fn sign(&self) -> Option<Ordering> {
        let sign = Interval::compare(self, &Self::zero());
        let certain = |known: Option<bool>, sign| (known == Some(true)).then_some(sign);
        certain(sign.is_greater(), Ordering::Greater)
            .or_else(|| certain(sign.is_less(), Ordering::Less))
            .or_else(|| certain(sign.is_equal(), Ordering::Equal))
    }
}

impl Arithmetic for Fixed {
    fn number(input: f64) -> Self {
        let (negative, mantissa, exponent) = parts(input);
        Self::new(negative, mantissa, exponent)
    }

    fn plus(&self, other: &Self) -> Self {
        Self::plus(self, other)
    }

    fn minus(&self, other: &Self) -> Self {
        Self::minus(self, other)
    }

    fn times(&self, other: &Self) -> Self {
        Self::times(self, other)
    }

    fn abs(&self) -> Self {
        Self::abs(self)
    }

    fn double(&self) -> Self {
        self.doubled()
    }

    fn sign(&self) -> Option<Ordering> {
        Self::sign(self)
    }
}
