//! Reads derivation documents and judges their statements.
#![deny(clippy::float_arithmetic)]

mod argument;
mod document;
mod explain;
mod goal;
mod judge;
mod motion;
mod open;
mod prove;
mod reader;
mod verdict;

pub use argument::contradicts_bounds;
pub use document::*;
pub use explain::*;
pub use goal::{Findings, find_witness, judge_goal, prove_goal, refute_goal};
pub use judge::{Options, audit};
pub use kane_algebra::syntax::Diagnostic;
pub use open::*;
pub use prove::{Budget, Decided, expression};
pub use reader::{MAX_FILE_BYTES, MAX_STATEMENTS, read};
pub use verdict::*;
