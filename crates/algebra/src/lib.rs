//! The clever, untrusted part: parsing, printing, rational functions, tables of signs.
#![deny(clippy::float_arithmetic)]

pub mod cells;
mod coprime;
pub mod descartes;
pub mod division;
pub mod factors;
pub mod field;
mod fraction;
mod irreducible;
pub mod linear_program;
pub mod point;
pub mod quotient;
pub mod rational_function;
mod ray;
pub mod ring;
pub mod sign_table;
pub mod squares;
pub mod syntax;
mod work;
