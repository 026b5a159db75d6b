//! Reads derivation documents and judges their statements.
#![deny(clippy::float_arithmetic)]

mod document;
mod reader;
mod verdict;

pub use document::*;
pub use reader::{Diagnostic, MAX_FILE_BYTES, MAX_STATEMENTS, read};
pub use verdict::*;
