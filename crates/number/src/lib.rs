//! Exact numbers, their floating-point counterparts, and the distance between them.
//!
//! A law is written once over the trait [`Number`] and runs in every number system that
//! implements it. This crate holds the two ends of that scale, exact rationals and IEEE floats,
//! and the bridge between them: [`decode`] loses nothing, [`encode`] rounds correctly, and
//! [`error_in_ulps`] says exactly how far a float is from the truth.
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
//! Floats are taken apart and put together by their bits alone; float arithmetic is confined to
//! the one private module that implements [`Number`] for `f32` and `f64`.
#![deny(clippy::float_arithmetic)]

mod algebraic;
mod binary;
mod comparison;
mod decimal;
mod decode;
mod directed;
mod double_double;
mod encode;
mod error_free;
mod float;
mod interval;
mod number;
mod operators;
mod parse;
mod rational;
mod root;
mod scaled;
mod sturm;
#[cfg(feature = "testkit")]
pub mod testkit;
mod ulp;

pub use algebraic::Algebraic;
pub use binary::Binary;
pub use comparison::Comparison;
pub use decode::{NotFinite, decode};
pub use double_double::DoubleDouble;
pub use encode::{Rounding, encode};
pub use interval::Interval;
pub use number::{Number, Ordered, Real};
pub use parse::{MAX_DIGITS, MAX_EXPONENT, ParseError, parse};
pub use rational::{Integer, Rational};
pub use scaled::Scaled;
pub use ulp::{error_in_ulps, steps_between, ulp};
