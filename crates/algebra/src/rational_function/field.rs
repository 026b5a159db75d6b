//! The arithmetic of rational functions: a field, hence a [`Number`].

use std::ops::{Add, Div, Mul, Neg, Sub};

use kane_number::{Number, Rational};
use num_traits::{One, Zero};

use super::RationalFunction;

impl From<Rational> for RationalFunction {
    fn from(constant: Rational) -> Self {
        Self::of(constant.into())
    }
}

impl PartialEq for RationalFunction {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl Eq for RationalFunction {}

impl Neg for RationalFunction {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl Add<&Self> for RationalFunction {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        let value = self.value.clone() + other.value.clone();
        Self { value, ..self }.with_conditions_of(other)
    }
}

impl Sub<&Self> for RationalFunction {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        let value = self.value.clone() - other.value.clone();
        Self { value, ..self }.with_conditions_of(other)
    }
}

impl Mul<&Self> for RationalFunction {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        let value = self.value.clone() * other.value.clone();
        Self { value, ..self }.with_conditions_of(other)
    }
}

impl Div<&Self> for RationalFunction {
    type Output = Self;

    /// # Panics
    /// If the divisor is zero everywhere.
    fn div(self, other: &Self) -> Self {
        self.checked_div(other).expect("division by the zero function")
    }
}

macro_rules! by_value {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for RationalFunction {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                $operator::$method(self, &other)
            }
        }
    )*};
}

by_value!(Add add, Sub sub, Mul mul, Div div);

impl Number for RationalFunction {
    type Wide = Self;

    fn widen(&self) -> Self {
        self.clone()
    }

    fn narrow(wide: &Self) -> Self {
        wide.clone()
    }

    fn zero() -> Self {
        <Rational as Zero>::zero().into()
    }

    fn one() -> Self {
        <Rational as One>::one().into()
    }

    fn from_rational(exact: &Rational) -> Self {
        exact.clone().into()
    }

    fn mul_add(&self, factor: &Self, addend: &Self) -> Self {
        self.clone() * factor + addend
    }

    fn checked_div(&self, divisor: &Self) -> Option<Self> {
        if divisor.is_zero() {
            return None;
        }
        let value = self.value.clone() / divisor.value.clone();
        let quotient = Self { value, conditions: self.conditions.clone() };
        quotient.with_conditions_of(divisor).provided(&divisor.fraction().0)
    }

    fn is_finite(&self) -> bool {
        true
    }
}
