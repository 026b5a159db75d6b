//! `f32` and `f64` as number systems: each operation is rounded once.
#![allow(clippy::float_arithmetic, reason = "this module is where float arithmetic lives")]

use crate::operators::works_in_itself;
use crate::root::{float, quadratic};
use crate::{
    Binary, Comparison, DoubleDouble, Number, Ordered, Rational, Real, Rounding, Scaled, encode,
};

macro_rules! float_number {
    ($float:ident, $narrow:ident, $nearest:expr) => {
        impl Number for $float {
            type Wide = Scaled;

            fn widen(&self) -> Scaled {
                Scaled::from(f64::from(*self))
            }

            fn narrow(wide: &Scaled) -> Self {
                wide.$narrow()
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
            #[inline]
            #[allow(
                clippy::neg_cmp_op_on_partial_ord,
                clippy::double_comparisons,
                reason = "NaN leaves every ordering possible, without a branch"
            )]
            fn compare(&self, other: &Self) -> Comparison {
                let (a, b) = (self, other);
                Comparison::possible(!(a >= b), !(a < b || a > b), !(a <= b))
            }
        }

        impl Real for $float {
            type WideReal = Scaled;

            works_in_itself!();

            const IS_FLOAT: bool = true;

            fn greatest_root(coefficients: &[Self], lower: &Self, upper: &Self) -> Option<Self> {
                if let [c0, c1] = coefficients
                    && let Some(root) = c0.checked_div(c1)
                {
                    // One division is rounded correctly; only then can it stray past an end.
                    let root = -root;
                    if *lower < root && root < *upper {
                        return Some(root);
                    }
                }
                if let [c0, c1, c2] = coefficients
                    && let Some(root) = quadratic::greatest_root(
                        [*c0, *c1, *c2].map(f64::from),
                        f64::from(*lower),
                        f64::from(*upper),
                    )
                {
                    return Some($nearest(root));
                }
                let wide: Vec<Scaled> = coefficients.iter().map(Number::widen).collect();
                let noise = 4 - i64::from(<$float as Binary>::PRECISION);
                let root = float::greatest_root(&wide, &lower.widen(), &upper.widen(), noise)?;
                // Rounding is monotone, so the ends of the interval stay the ends.
                Some(Self::narrow(&root))
            }
        }
    };
}

float_number!(f32, to_f32, |root| Scaled::from(root).to_f32());
float_number!(f64, to_f64, DoubleDouble::high);
