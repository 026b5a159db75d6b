//! Reads derivation documents and judges their statements.
#![deny(clippy::float_arithmetic)]

mod argument;
mod behind;
mod burden;
mod document;
mod existence;
mod explain;
mod goal;
mod index;
mod judge;
mod kept;
mod memo;
mod motion;
mod open;
mod origin;
mod outline;
mod prove;
mod reader;
mod spoken;
mod verdict;

pub use argument::{BoundedSum, contradicts_bounds};
pub use burden::Burden;
pub use document::*;
pub use existence::Existence;
pub use explain::*;
pub use goal::{Findings, find_witness, judge_goal, prove_goal, refute_goal};
pub use judge::{Options, audit, audit_again};
pub use kane_algebra::syntax::Diagnostic;
pub use memo::Memo;
pub use open::*;
pub use origin::Origin;
pub use outline::{Citation, Kind, Label, Name, Outline, Survey};
pub use prove::{Budget, Decided, expression};
pub use reader::{MAX_FILE_BYTES, MAX_STATEMENTS, read, survey};
pub use verdict::*;
