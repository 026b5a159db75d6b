//! Reads derivation documents and judges their statements.
#![deny(clippy::float_arithmetic)]

mod document;
mod explain;
mod goal;
mod judge;
mod prove;
mod reader;
mod verdict;

pub use document::*;
#[doc(hidden)]
pub use goal::{Findings, judge_goal};
pub use judge::{Options, audit};
pub use prove::Budget;
pub use reader::{Diagnostic, MAX_FILE_BYTES, MAX_STATEMENTS, read};
pub use verdict::*;
