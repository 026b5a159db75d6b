//! The exact numbers satisfy their axioms, and every bridge to the floats keeps its promise.

/// Exact algebraic numbers: a field, an order, and a way to write them.
mod algebraic;
/// Field and order axioms, through the testkit that later number systems share.
mod axioms;
/// Algebraic numbers next to each other.
mod close_numbers;
/// Every number system against its promise, by one suite.
mod conformance;
/// Enclosures of roots.
mod enclosures;
/// Correct rounding, against two other ways of telling the nearest float.
mod encoding;
/// Fractions for chains of operations, against those on the heap.
mod fractions;
/// Enclosures.
mod intervals;
/// What every system of a table can do.
mod lanes;
/// What is read, what is refused, and where.
mod parsing;
/// The suites against number systems with a fault.
mod planted;
/// Floats byte by byte, with the numbers that they are.
mod reference;
/// The greatest root of a polynomial, in every system.
mod roots;
/// Float to rational and back, on random bit patterns.
mod round_trip;
/// Roots that rounding could move elsewhere.
mod rounded_roots;
/// The greatest root where it is known beforehand.
mod small_roots;
/// Units in the last place and steps, with the comparison's three answers.
mod ulps;
/// Twice the precision, with and without limits.
mod wide;

use kane_number::{Integer, Rational};
use quickcheck::{Gen, QuickCheck};

/// quickcheck with a fixed seed: the gate asks the same questions on every run.
fn quickcheck(tests: u64) -> QuickCheck {
    QuickCheck::new().rng(Gen::from_size_and_seed(100, 0x6b61_6e65)).tests(tests).max_tests(tests)
}

fn rational(numer: impl Into<Integer>, denom: impl Into<Integer>) -> Rational {
    Rational::new(numer.into(), denom.into())
}

/// 2^exponent.
fn two_to(exponent: i64) -> Rational {
    let scale = Integer::from(1) << exponent.unsigned_abs();
    if exponent >= 0 { Rational::from_integer(scale) } else { Rational::new(1.into(), scale) }
}
