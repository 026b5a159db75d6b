//! Reads derivation documents and judges their statements.
#![deny(clippy::float_arithmetic)]

mod document;
mod verdict;

pub use document::*;
pub use verdict::*;
