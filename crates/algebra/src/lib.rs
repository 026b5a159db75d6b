//! The clever, untrusted part: parsing, printing, rational functions, limits, signs.
#![deny(clippy::float_arithmetic)]

pub mod linear_program;
pub mod point;
pub mod ring;
pub mod sign_table;
pub mod syntax;
