//! The trusted part: statements, their normal form, certificates and the check.
#![deny(clippy::float_arithmetic)]

mod ast;

pub use ast::*;
