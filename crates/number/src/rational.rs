//! The exact end of the scale.

use num_traits::{One, Pow as _, Zero};

use crate::{Comparison, Number, Ordered};

/// An integer of any size.
pub type Integer = num_bigint::BigInt;

/// An exact fraction, always in lowest terms with a positive denominator.
pub type Rational = num_rational::BigRational;

impl Number for Rational {
    type Wide = Self;

    const IS_EXACT: bool = true;

    fn widen(&self) -> Self {
        self.clone()
    }

    fn narrow(wide: &Self) -> Self {
        wide.clone()
    }

    fn zero() -> Self {
        Zero::zero()
    }

    fn one() -> Self {
        One::one()
    }

    fn from_rational(exact: &Rational) -> Self {
        exact.clone()
    }

    fn mul_add(&self, factor: &Self, addend: &Self) -> Self {
        self * factor + addend
    }

    fn checked_div(&self, divisor: &Self) -> Option<Self> {
        (!divisor.is_zero()).then(|| self / divisor)
    }

    fn is_finite(&self) -> bool {
        true
    }
}

impl Ordered for Rational {
    fn compare(&self, other: &Self) -> Comparison {
        self.cmp(other).into()
    }
}

/// base to the power of an exponent, which may be negative; exact. The base is not 0.
#[must_use]
pub fn power_of(base: u32, exponent: i64) -> Rational {
    let power = Rational::from_integer(Integer::from(base).pow(exponent.unsigned_abs()));
    if exponent.is_negative() { power.recip() } else { power }
}
