//! What each number system promises of a result, so that one suite can hold all to it.

use num_traits::{Signed, Zero};

use crate::{
    Algebraic, DoubleDouble, Interval, Number as _, OddFraction, Rational, Real, Rounding, Scaled,
    decode, encode, power_of, steps_between,
};

/// A number system together with its promise.
pub trait Contract: Real + PartialEq {
    /// The number for an exact one, and the exact one that it stands for from then on: itself
    /// where the system holds it or encloses it, otherwise the one it was rounded to. `None` if
    /// it is beyond the system's range.
    fn operand(exact: &Rational) -> Option<(Self, Rational)>;

    /// Whether the result of one operation may stand for the exact one.
    fn admits(result: &Self, exact: &Rational) -> bool;

    /// Whether an answer for the greatest root may stand for the exact root.
    fn admits_root(answer: Option<&Self>, exact: &Algebraic) -> bool;
}

macro_rules! float_contract {
    ($float:ident) => {
        /// Each operation is the exact one rounded to the nearest; a root errs by a step at most.
        impl Contract for $float {
            fn operand(exact: &Rational) -> Option<(Self, Rational)> {
                let float: $float = encode(exact, Rounding::NearestEven);
                Some((float, decode(float).ok()?))
            }

            fn admits(result: &Self, exact: &Rational) -> bool {
                // Equal as numbers: the sign of a zero is not the rationals' concern.
                *result == encode::<$float>(exact, Rounding::NearestEven)
            }

            fn admits_root(answer: Option<&Self>, exact: &Algebraic) -> bool {
                let nearest: $float = exact.encode(Rounding::NearestEven);
                answer.is_some_and(|root| {
                    *root == nearest || steps_between(*root, nearest).is_ok_and(|steps| steps <= 1)
                })
            }
        }
    };
}

float_contract!(f32);
float_contract!(f64);

/// Each operation errs by 2^−101 relatively, where no part of the number can underflow.
impl Contract for DoubleDouble {
    fn operand(exact: &Rational) -> Option<(Self, Rational)> {
        let number = Self::from_rational(exact);
        Some((number, number.to_rational().ok()?))
    }

    fn admits(result: &Self, exact: &Rational) -> bool {
        let (least, most) = (power_of(2, -850), power_of(2, 1023));
        if exact.abs() >= most || (exact.abs() < least && !exact.is_zero()) {
            return true;
        }
        result.to_rational().is_ok_and(|value| is_near(&value, exact, 101))
    }

    fn admits_root(answer: Option<&Self>, exact: &Algebraic) -> bool {
        let value = answer.and_then(|root| root.to_rational().ok());
        value.is_some_and(|value| is_near_root(&value, exact, 90))
    }
}

/// Each operation errs by 2^−101 relatively.
impl Contract for Scaled {
    fn operand(exact: &Rational) -> Option<(Self, Rational)> {
        let number = Self::from_rational(exact);
        Some((number, number.to_rational()?))
    }

    fn admits(result: &Self, exact: &Rational) -> bool {
        result.to_rational().is_some_and(|value| is_near(&value, exact, 101))
    }

    fn admits_root(answer: Option<&Self>, exact: &Algebraic) -> bool {
        let value = answer.and_then(|root| root.to_rational());
        value.is_some_and(|value| is_near_root(&value, exact, 90))
    }
}

/// Each result encloses the exact one.
impl Contract for Interval {
    fn operand(exact: &Rational) -> Option<(Self, Rational)> {
        Some((Self::from_rational(exact), exact.clone()))
    }

    fn admits(result: &Self, exact: &Rational) -> bool {
        result.contains(exact)
    }

    fn admits_root(answer: Option<&Self>, exact: &Algebraic) -> bool {
        let inside = |interval: &Self| {
            let (low, high): (f64, f64) =
                (exact.encode(Rounding::Down), exact.encode(Rounding::Up));
            interval.lower() <= low && high <= interval.upper()
        };
        answer.is_some_and(inside)
    }
}

/// Each result is the exact one; a root is found if it is rational.
impl Contract for Rational {
    fn operand(exact: &Rational) -> Option<(Self, Rational)> {
        Some((exact.clone(), exact.clone()))
    }

    fn admits(result: &Self, exact: &Rational) -> bool {
        result == exact
    }

    fn admits_root(answer: Option<&Self>, exact: &Algebraic) -> bool {
        answer == exact.as_rational()
    }
}

/// As [`Rational`].
impl Contract for OddFraction {
    fn operand(exact: &Rational) -> Option<(Self, Rational)> {
        Some((Self::from_rational(exact), exact.clone()))
    }

    fn admits(result: &Self, exact: &Rational) -> bool {
        result.to_rational() == *exact
    }

    fn admits_root(answer: Option<&Self>, exact: &Algebraic) -> bool {
        answer.map(Self::to_rational).as_ref() == exact.as_rational()
    }
}

/// Each result is the exact one.
impl Contract for Algebraic {
    fn operand(exact: &Rational) -> Option<(Self, Rational)> {
        Some((exact.clone().into(), exact.clone()))
    }

    fn admits(result: &Self, exact: &Rational) -> bool {
        result.as_rational() == Some(exact)
    }

    fn admits_root(answer: Option<&Self>, exact: &Algebraic) -> bool {
        answer == Some(exact)
    }
}

/// |value − exact| ≤ 2^−bits·|exact|.
fn is_near(value: &Rational, exact: &Rational, bits: i64) -> bool {
    (value - exact).abs() <= exact.abs() * power_of(2, -bits)
}

fn is_near_root(value: &Rational, exact: &Algebraic, bits: i64) -> bool {
    let slack = value.abs() * power_of(2, -bits);
    let (low, high) = (value - &slack, value + &slack);
    Algebraic::from(low) <= *exact && *exact <= Algebraic::from(high)
}
