//! `f32` and `f64` as number systems: the only place of this crate where floats are computed.
#![allow(clippy::float_arithmetic, reason = "this module is where float arithmetic lives")]

use crate::{Comparison, Number, Ordered, Rational, Real, Rounding, encode};

macro_rules! float_number {
    ($float:ident) => {
        impl Number for $float {
            type Wide = Self;

            fn widen(&self) -> Self {
                *self
            }

            fn narrow(wide: &Self) -> Self {
                *wide
            }

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

        impl Real for $float {
            type WideReal = Self;

            fn greatest_root(coefficients: &[Self], lower: &Self, upper: &Self) -> Option<Self> {
                let at = |x: $float| coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
                let (mut low, mut high) = (*lower, *upper);
                if at(high) == 0.0 || at(low) == 0.0 {
                    return Some(if at(high) == 0.0 { high } else { low });
                }
                if at(high) * at(low) > 0.0 {
                    return None;
                }
                // Halving until no float is left in between.
                loop {
                    let middle = low + (high - low) / 2.0;
                    if middle <= low || middle >= high {
                        return Some(high);
                    }
                    let same = (at(middle) < 0.0) == (at(high) < 0.0);
                    if same { high = middle } else { low = middle }
                }
            }
        }
    };
}

float_number!(f32);
float_number!(f64);
