//! The exact stage for what does not fit: integers of any size times a power of two.

use std::cmp::Ordering;

use kane_number::Integer;

use super::arithmetic::{Arithmetic, parts};

/// n·2^exponent. Exact, without division and without a gcd.
#[derive(Clone, Debug)]
pub(crate) struct Dyadic {
    pub(super) integer: Integer,
    pub(super) exponent: i64,
}

impl Dyadic {
    fn aligned(&self, exponent: i64) -> Integer {
        &self.integer << (self.exponent - exponent).unsigned_abs()
    }

    fn together(&self, other: &Self) -> (Integer, Integer, i64) {
        let zero = Integer::ZERO;
        let exponent = match (self.integer == zero, other.integer == zero) {
            (true, _) => return (zero, other.integer.clone(), other.exponent),
            (_, true) => return (self.integer.clone(), zero, self.exponent),
            _ => self.exponent.min(other.exponent),
        };
        (self.aligned(exponent), other.aligned(exponent), exponent)
    }
}

impl Arithmetic for Dyadic {
    fn number(input: f64) -> Self {
        let (negative, mantissa, exponent) = parts(input);
        let integer = Integer::from(mantissa);
        Self { integer: if negative { -integer } else { integer }, exponent }
    }

    fn plus(&self, other: &Self) -> Self {
        let (a, b, exponent) = self.together(other);
        Self { integer: a + b, exponent }
    }

    fn minus(&self, other: &Self) -> Self {
        let (a, b, exponent) = self.together(other);
        Self { integer: a - b, exponent }
    }

    fn times(&self, other: &Self) -> Self {
        let exponent = self.exponent + other.exponent;
        Self { integer: &self.integer * &other.integer, exponent }
    }

    fn abs(&self) -> Self {
        if self.integer < Integer::ZERO {
            return Self { integer: -&self.integer, ..*self };
        }
        self.clone()
    }

    fn double(&self) -> Self {
        Self { integer: self.integer.clone(), exponent: self.exponent + 1 }
    }

    fn sign(&self) -> Option<Ordering> {
        Some(self.integer.cmp(&Integer::ZERO))
    }
}
