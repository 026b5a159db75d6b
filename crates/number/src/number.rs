//! What a number system must offer for a law to run in it.

use std::fmt::{Debug, Display};
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::{Comparison, Rational};

/// A number system in which a law can be evaluated: field operations and constants, no order.
///
/// Implemented for [`Rational`] and [`Algebraic`](crate::Algebraic) (exact), `f32` and `f64` (each
/// operation correctly rounded), [`DoubleDouble`](crate::DoubleDouble) and
/// [`Scaled`](crate::Scaled) (bounded), and [`Interval`](crate::Interval) (enclosing).
/// Operations take the right operand by value or by reference, so that numbers on the heap are
/// not copied. Exact systems satisfy the field axioms; floats satisfy them up to rounding.
///
/// Division by zero is the caller's to exclude: `/` gives ±∞ or NaN in floats and panics for
/// rationals. Where a guard cannot exclude it, use [`checked_div`](Self::checked_div).
pub trait Number:
    Clone
    + Debug
    + Display
    + 'static
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + for<'a> Add<&'a Self, Output = Self>
    + for<'a> Sub<&'a Self, Output = Self>
    + for<'a> Mul<&'a Self, Output = Self>
    + for<'a> Div<&'a Self, Output = Self>
{
    /// The system in which the quantities of a body are formed before they are rounded once:
    /// wider in exponent and precision for floats, the system itself for exact ones.
    type Wide: Number;

    /// Whether every operation is known to be exact, so that no formula need give rounding errors back.
    const IS_EXACT: bool = false;

    /// The same number in the wider system. Exact.
    #[must_use]
    fn widen(&self) -> Self::Wide;

    /// The number of this system nearest to a wide one: exact where the system holds it,
    /// otherwise rounded once. Left inverse to [`widen`](Self::widen).
    #[must_use]
    fn narrow(wide: &Self::Wide) -> Self;

    /// The neutral element of addition, exact.
    #[must_use]
    fn zero() -> Self;

    /// The neutral element of multiplication, exact.
    #[must_use]
    fn one() -> Self;

    /// The number nearest to an exact rational: exact where the system holds it, otherwise
    /// correctly rounded (ties to even, overflow to ±∞).
    #[must_use]
    fn from_rational(exact: &Rational) -> Self;

    /// `self·factor + addend` with a single rounding, or in systems wider than a float with a
    /// bound that holds whatever cancels; each says which.
    ///
    /// A difference of nearly equal products keeps no correct digit if it is rounded twice, and
    /// then no error bound in ulps holds. Hence this is an operation of its own, without a
    /// default that a float system could inherit by mistake.
    #[must_use]
    fn mul_add(&self, factor: &Self, addend: &Self) -> Self;

    /// `self / divisor`, or `None` if the divisor is zero or cannot be told from zero.
    #[must_use]
    fn checked_div(&self, divisor: &Self) -> Option<Self>;

    /// Whether this is a number proper: false for NaN and ±∞, always true in exact systems.
    #[must_use]
    fn is_finite(&self) -> bool;

    /// Twice the number: exact in binary floats, save for overflow.
    #[must_use]
    fn double(&self) -> Self {
        self.clone() + self
    }

    /// The square, formed by one multiplication.
    #[must_use]
    fn square(&self) -> Self {
        self.clone() * self
    }
}

/// A number system with an order, which may be unable to decide a given comparison.
pub trait Ordered: Number {
    /// What is known about the order of `self` and `other`; exact for exact systems and for
    /// floats (where −0 = +0), [`Comparison::UNKNOWN`] if either is NaN.
    #[must_use]
    fn compare(&self, other: &Self) -> Comparison;

    /// What is known about the sign: the comparison with zero.
    #[must_use]
    fn sign(&self) -> Comparison {
        self.compare(&Self::zero())
    }
}

/// An ordered number system that can also find a real root of a polynomial of degree 3 at most.
///
/// This is the one step beyond field arithmetic that a law may take. Each system answers as it
/// can: exactly, to the nearest, by an enclosure, or not at all.
pub trait Real: Ordered + Number<Wide = <Self as Real>::WideReal> {
    /// The same type as [`Wide`](Number::Wide): the supertrait says so. It is named again because
    /// only thus can the trait promise that a wide number is again a [`Real`].
    type WideReal: Real;

    /// The system in which a law's formulas run on these numbers: the same numbers, held so that a
    /// chain of operations is cheap. The system itself but for [`Rational`].
    type Working: Real;

    /// Whether an operation costs no more than a few instructions, so that a law's formulas cost less
    /// than the way to them.
    const IS_FLOAT: bool = false;

    /// The same number in the working system. Exact.
    #[must_use]
    fn to_working(&self) -> Self::Working;

    /// The number that a working one is. Exact; inverse to [`to_working`](Self::to_working).
    #[must_use]
    fn from_working(working: &Self::Working) -> Self;

    /// The greatest root of c\[0\] + c\[1\]·x + … in the closed interval \[`lower`, `upper`\],
    /// of formal degree 3 at most; leading coefficients may be zero.
    ///
    /// The caller promises that one exists: the values at the two ends have opposite signs, or
    /// one of them is zero. `None` if no root can be found, or none can be told from the others,
    /// in this system; for rationals also if the root is irrational. `None` for more than four
    /// coefficients.
    #[must_use]
    fn greatest_root(coefficients: &[Self], lower: &Self, upper: &Self) -> Option<Self>;
}
