//! The clever, untrusted part: parsing, printing, rational functions, limits, signs.
#![deny(clippy::float_arithmetic)]

pub mod descartes;
mod fraction;
pub mod limit;
pub mod linear_program;
pub mod piecewise;
pub mod point;
pub mod rational_function;
pub mod ring;
pub mod sign;
pub mod sign_table;
pub mod squares;
pub mod syntax;
