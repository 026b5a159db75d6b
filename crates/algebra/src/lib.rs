//! The clever, untrusted part: parsing, printing, rational functions, limits, signs.
#![deny(clippy::float_arithmetic)]

pub mod syntax;
