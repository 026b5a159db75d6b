//! Number systems, from floats to exact real algebraic numbers, and the distances between them.
//!
//! A law is written once over the trait [`Number`] (with [`Ordered`] and [`Real`] for what needs
//! an order or a root) and runs in every system that implements it:
//!
//! | system | what is exact | when to use it |
//! |---|---|---|
//! | `f32`, `f64` | nothing; each operation is the nearest float | speed |
//! | [`DoubleDouble`] | nothing; 106 bits, relative error about 2^−104 | rounding errors of `f64` made visible |
//! | [`Scaled`] | nothing; the same without over- or underflow | the quantities of a body, rounded once |
//! | [`Interval`] | that the result lies inside | what is certain in spite of rounding |
//! | [`Rational`] | all but irrational roots | the reference, and guards decided exactly |
//! | [`Algebraic`] | everything, roots included | the reference for laws that take a root |
//!
//! ```
//! use kane_number::{
//!     Algebraic, DoubleDouble, Interval, Number, Rational, Real, Scaled, parse,
//! };
//!
//! /// The greatest solution of a·x² = b between 0 and b.
//! fn solve<N: Real>(a: &Rational, b: &Rational) -> Option<N> {
//!     let [a, b] = [a, b].map(N::from_rational);
//!     N::greatest_root(&[-b.clone(), N::zero(), a], &N::zero(), &b)
//! }
//!
//! let (half, one, two) = (parse("1/2")?, parse("1")?, parse("2")?);
//! assert_eq!(solve::<f64>(&one, &two), Some(1.4142135623730951));
//! assert_eq!(solve::<f32>(&one, &two), Some(1.4142135));
//! let shown = |root: Option<String>| root.unwrap_or_default();
//! let double = solve::<DoubleDouble>(&one, &two).map(|x| x.to_string());
//! assert!(shown(double).starts_with("1.4142135623730950488016887242"));
//! assert_eq!(solve::<Scaled>(&one, &two).map(Scaled::to_f64), Some(1.4142135623730951));
//! let enclosure = solve::<Interval>(&one, &two).map(|x| x.to_string());
//! assert_eq!(shown(enclosure), "[1.414213562373095, 1.4142135623730951]");
//! assert_eq!(solve::<Rational>(&one, &two), None);
//! assert_eq!(solve::<Rational>(&half, &two), Some(two.clone()));
//! assert_eq!(shown(solve::<Algebraic>(&one, &two).map(|x| x.to_string())), "sqrt(2)");
//! # Ok::<(), kane_number::ParseError>(())
//! ```
//!
//! [`OddFraction`] holds the same numbers as [`Rational`] for chains of operations, and [`Fixed`] is the
//! integer without allocation that it is made of.
//!
//! [`System`] names five of them as a value, for tables that run them side by side.
//!
//! The bridge between exact numbers and floats loses nothing that it need not: [`decode`] is
//! exact, [`encode`] rounds correctly, and [`error_in_ulps`] says how far a float is from the
//! truth.
//!
//! ```
//! use kane_number::{Rounding, encode, error_in_ulps, parse};
//!
//! let third = parse("1/3")?;
//! let nearest: f64 = encode(&third, Rounding::NearestEven);
//! assert_eq!(nearest, 1.0 / 3.0);
//! assert_eq!(error_in_ulps(nearest, &third)?.to_string(), "-1/3");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Exact modules touch floats by their bits alone; float arithmetic is denied for the crate and
//! allowed, with a reason, in each module that is made of it.
#![deny(clippy::float_arithmetic)]

mod algebraic;
mod binary;
mod changes;
mod comparison;
mod decimal;
mod decode;
mod directed;
mod double_double;
mod encode;
mod error_free;
mod exact_sum;
mod fixed;
mod float;
mod format;
mod interval;
mod number;
mod odd_fraction;
mod operators;
#[cfg(test)]
mod pairs;
mod parse;
mod rational;
mod root;
mod scaled;
mod sturm;
mod system;
#[cfg(feature = "testkit")]
pub mod testkit;
mod ulp;

pub use algebraic::{Algebraic, linear};
pub use binary::Binary;
pub use changes::changes;
pub use comparison::Comparison;
pub use decode::{NotFinite, decode};
pub use double_double::DoubleDouble;
pub use encode::{Rounding, encode};
pub use exact_sum::ExactSum;
pub use fixed::Fixed;
pub use interval::Interval;
pub use number::{Number, Ordered, Real};
pub use odd_fraction::OddFraction;
pub use parse::{MAX_DIGITS, MAX_EXPONENT, ParseError, parse};
pub use rational::{Integer, Rational, power_of};
pub use scaled::Scaled;
pub use system::{Lane, System};
pub use ulp::{error_in_ulps, steps_between, ulp};
