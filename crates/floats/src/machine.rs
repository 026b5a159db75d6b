//! Programs run as a machine runs them.
#![allow(clippy::float_arithmetic, reason = "this module is the machine")]

use std::cmp::Ordering;
use std::fmt::{Debug, LowerExp};
use std::ops::{Add, Div, Mul, Neg, Sub};

use kane_kernel::{Bound, Rel};
use kane_number::{Binary, Rational, Rounding, decode, encode};

use crate::{Operation, Precision, Program};

/// A binary format with its operations, each rounded to nearest, ties to even.
pub trait Machine:
    Binary
    + PartialOrd
    + Debug
    + LowerExp
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Which one it is.
    const FORMAT: Precision;

    /// The root; NaN below 0.
    #[must_use]
    fn root(self) -> Self;
    /// self·b + c, rounded once.
    #[must_use]
    fn fused(self, b: Self, c: Self) -> Self;
    /// The magnitude.
    #[must_use]
    fn magnitude(self) -> Self;
    /// The same value; exact.
    #[must_use]
    fn wide(self) -> f64;
    /// The nearest float.
    #[must_use]
    fn nearest(wide: f64) -> Self;
    /// Whether it is neither NaN nor ±∞.
    #[must_use]
    fn finite(self) -> bool {
        self.magnitude_bits() < Self::infinity_bits()
    }

    /// Its place in the order of all finite floats, 0 for ±0, negative below.
    #[must_use]
    fn place(self) -> i64 {
        let magnitude = i64::try_from(self.magnitude_bits()).unwrap_or(i64::MAX);
        if self.is_negative() { -magnitude } else { magnitude }
    }

    /// The float at a place, no further than the greatest finite one.
    #[must_use]
    fn at(place: i64) -> Self {
        let greatest = Self::infinity_bits() - 1;
        Self::from_magnitude_bits(place < 0, place.unsigned_abs().min(greatest))
    }
}

macro_rules! machine {
    ($float:ident, $format:ident) => {
        impl Machine for $float {
            const FORMAT: Precision = Precision::$format;

            fn root(self) -> Self {
                self.sqrt()
            }

            fn fused(self, b: Self, c: Self) -> Self {
                self.mul_add(b, c)
            }

            fn magnitude(self) -> Self {
                self.abs()
            }

            fn wide(self) -> f64 {
                f64::from(self)
            }

            #[allow(clippy::cast_possible_truncation, reason = "rounding is what is asked for")]
            fn nearest(wide: f64) -> Self {
                wide as Self
            }
        }
    };
}
machine!(f32, F32);
machine!(f64, F64);

/// The finite floats of a range, by their places; `None` if there is none. A bound is met to the float.
#[must_use]
pub fn places<M: Machine>(lower: Option<&Bound>, upper: Option<&Bound>) -> Option<(i64, i64)> {
    let greatest = i64::try_from(M::infinity_bits() - 1).unwrap_or(i64::MAX);
    let end = |bound: &Bound, rounding: Rounding, inward: i64| {
        let float: M = encode(&bound.value, rounding);
        let met = decode(float).is_ok_and(|value| value == bound.value);
        float.place() + if met && bound.strict { inward } else { 0 }
    };
    let first = lower.map_or(-greatest, |bound| end(bound, Rounding::Up, 1)).max(-greatest);
    let last = upper.map_or(greatest, |bound| end(bound, Rounding::Down, -1)).min(greatest);
    (first <= last).then_some((first, last))
}

/// A program with its constants rounded, ready to run many times.
#[derive(Clone, Debug)]
pub struct Runner<'a, M> {
    program: &'a Program,
    constants: Vec<M>,
}

impl<'a, M: Machine> Runner<'a, M> {
    /// Rounds the constants.
    #[must_use]
    pub fn new(program: &'a Program) -> Self {
        let constant = |operation: &Operation| match operation {
            Operation::Number(number) => rounded(number),
            _ => M::at(0),
        };
        Self { program, constants: program.operations().iter().map(constant).collect() }
    }

    /// The results of all operations.
    pub fn run(&self, inputs: &[M], results: &mut Vec<M>) {
        results.clear();
        for (operation, constant) in self.program.operations().iter().zip(&self.constants) {
            let at = |index: usize| results.get(index).copied().unwrap_or(*constant);
            let pick = |a: M, b: M, wanted: Ordering| match a.partial_cmp(&b) {
                Some(order) if order == wanted => a,
                Some(_) => b,
                None if a.magnitude_bits() > M::infinity_bits() => b,
                None => a,
            };
            let result = match *operation {
                Operation::Number(_) => *constant,
                Operation::Input(input) => inputs.get(input).copied().unwrap_or(*constant),
                Operation::Neg(a) => -at(a),
                Operation::Add(a, b) => at(a) + at(b),
                Operation::Sub(a, b) => at(a) - at(b),
                Operation::Mul(a, b) => at(a) * at(b),
                Operation::Div(a, b) => at(a) / at(b),
                Operation::Sqrt(a) => at(a).root(),
                Operation::Fma(a, b, c) => at(a).fused(at(b), at(c)),
                Operation::Abs(a) => at(a).magnitude(),
                Operation::Min(a, b) => pick(at(a), at(b), Ordering::Less),
                Operation::Max(a, b) => pick(at(a), at(b), Ordering::Greater),
                Operation::If(ref test, a, b) => {
                    let compare = |rel, a, b| Some(compares(rel, at(a).partial_cmp(&at(b))));
                    if test.holds(&compare) == Some(true) { at(a) } else { at(b) }
                }
            };
            results.push(result);
        }
    }

    /// The result of one operation.
    #[must_use]
    pub fn value(&self, root: usize, inputs: &[M]) -> Option<M> {
        let mut results = Vec::with_capacity(self.constants.len());
        self.run(inputs, &mut results);
        results.get(root).copied()
    }
}

/// The float nearest to a constant.
pub(crate) fn rounded<M: Machine>(number: &Rational) -> M {
    encode(number, Rounding::NearestEven)
}

/// Whether an order satisfies a comparison; NaN differs from everything.
pub(crate) fn compares(rel: Rel, order: Option<Ordering>) -> bool {
    match order {
        None => rel == Rel::Ne,
        Some(order) => kane_algebra::syntax::compares(rel, order),
    }
}
