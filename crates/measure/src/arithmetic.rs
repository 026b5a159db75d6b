//! Number systems as a formula sees them: the operations that it is written with, one at a time.
#![allow(clippy::float_arithmetic, reason = "this module evaluates formulas in floats")]

use std::cmp::Ordering;
use std::marker::PhantomData;

use kane_number::{Algebraic, DoubleDouble, Interval, Lane, Number as _, Ordered, Rational};

/// The operations of a formula in one number system. `None` is "no value": a division by zero in
/// an exact system, or a root that the system does not hold. Floats always have a value, be it NaN.
pub trait Arithmetic {
    /// A number of the system.
    type Value: Clone;

    /// The number nearest to an exact one.
    fn number(&self, exact: &Rational) -> Self::Value;
    /// −a.
    fn neg(&self, a: &Self::Value) -> Self::Value;
    /// a + b.
    fn add(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// a − b.
    fn sub(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// a · b.
    fn mul(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// a / b.
    fn div(&self, a: &Self::Value, b: &Self::Value) -> Option<Self::Value>;
    /// √a.
    fn sqrt(&self, a: &Self::Value) -> Option<Self::Value>;
    /// How two numbers compare; `None` if that is not known, as for NaN.
    fn compare(&self, a: &Self::Value, b: &Self::Value) -> Option<Ordering>;
}

/// A number system of `kane_number` whose own operators are meant, as in a program that computes
/// the formula.
#[derive(Clone, Copy, Debug, Default)]
pub struct Plain<N>(PhantomData<N>);

impl<N> Plain<N> {
    /// The system.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

/// What [`Plain`] needs beyond a [`Number`](kane_number::Number): the quotient and the root as the system gives them.
pub trait PlainNumber: Ordered {
    /// a / b; floats give ±∞ or NaN at b = 0, exact systems nothing.
    fn quotient(&self, divisor: &Self) -> Option<Self>;
    /// √a; floats give NaN for a < 0, other systems nothing.
    fn root(&self) -> Option<Self>;
}

macro_rules! float {
    ($($float:ident),*) => { $(
        impl PlainNumber for $float {
            fn quotient(&self, divisor: &Self) -> Option<Self> {
                Some(self / divisor)
            }

            fn root(&self) -> Option<Self> {
                Some($float::sqrt(*self))
            }
        }
    )* };
}
float!(f32, f64);

impl PlainNumber for DoubleDouble {
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        Some(*self / divisor)
    }

    fn root(&self) -> Option<Self> {
        (*self).sqrt()
    }
}

impl PlainNumber for Interval {
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        Some(*self / divisor)
    }

    fn root(&self) -> Option<Self> {
        self.sqrt()
    }
}

impl PlainNumber for Rational {
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        self.checked_div(divisor)
    }

    fn root(&self) -> Option<Self> {
        Lane::sqrt(self)
    }
}

impl PlainNumber for Algebraic {
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        self.checked_div(divisor)
    }

    fn root(&self) -> Option<Self> {
        self.sqrt()
    }
}

impl<N: PlainNumber> Arithmetic for Plain<N> {
    type Value = N;

    fn number(&self, exact: &Rational) -> N {
        N::from_rational(exact)
    }

    fn neg(&self, a: &N) -> N {
        -a.clone()
    }

    fn add(&self, a: &N, b: &N) -> N {
        a.clone() + b
    }

    fn sub(&self, a: &N, b: &N) -> N {
        a.clone() - b
    }

    fn mul(&self, a: &N, b: &N) -> N {
        a.clone() * b
    }

    fn div(&self, a: &N, b: &N) -> Option<N> {
        a.quotient(b)
    }

    fn sqrt(&self, a: &N) -> Option<N> {
        a.root()
    }

    fn compare(&self, a: &N, b: &N) -> Option<Ordering> {
        let order = a.compare(b);
        match (order.is_less(), order.is_greater(), order.is_equal()) {
            (Some(true), _, _) => Some(Ordering::Less),
            (_, Some(true), _) => Some(Ordering::Greater),
            (_, _, Some(true)) => Some(Ordering::Equal),
            _ => None,
        }
    }
}
