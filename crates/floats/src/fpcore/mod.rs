//! FPCore, the s-expressions of FPBench: read and written.
//!
//! The arithmetic part of FPCore 2.0 (<https://fpbench.org/spec/fpcore-2.0.html>): `+ - * / sqrt fma
//! fabs fmin fmax`, `let`, `let*`, `if`, comparisons, `and or not`, numbers, and the properties `:name`,
//! `:pre`, `:precision`; other properties are kept as they are written. What is beyond that is an error
//! with its place.

mod literal;
mod reader;
mod sexpr;
mod writer;

pub use reader::read;
pub use writer::write;
