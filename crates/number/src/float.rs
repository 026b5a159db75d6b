//! `f32` and `f64` as number systems: the only place of this crate where floats are computed.
#![allow(clippy::float_arithmetic, reason = "this module is where float arithmetic lives")]

use crate::{Comparison, Number, Ordered, Rational, Rounding, encode};

macro_rules! float_number {
    ($float:ident) => {
        impl Number for $float {
            fn zero() -> Self {
                0.0
            }

            fn one() -> Self {
                1.0
            }

            fn from_rational(exact: &Rational) -> Self {
                encode(exact, Rounding::NearestEven)
            }

            fn mul_add(&self, factor: &Self, addend: &Self) -> Self {
                $float::mul_add(*self, *factor, *addend)
            }

            fn checked_div(&self, divisor: &Self) -> Option<Self> {
                (*divisor != 0.0).then(|| self / divisor)
            }

            fn is_finite(&self) -> bool {
                $float::is_finite(*self)
            }
        }

        impl Ordered for $float {
            fn compare(&self, other: &Self) -> Comparison {
                self.partial_cmp(other).into()
            }
        }
    };
}

float_number!(f32);
float_number!(f64);
