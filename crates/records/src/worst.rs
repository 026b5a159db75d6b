//! The rows that miss a check most.

use crate::case::Case;
use crate::check::{Check, Finding};
use crate::replay::{Replay, replay};
use crate::schema::Side;

/// One of the worst rows.
#[derive(Clone, Debug)]
pub struct Worst {
    /// the line of the file, or 0 if it is not known
    pub line: u64,
    /// the name of the row
    pub id: String,
    /// what fails most
    pub check: Check,
    /// by how much
    pub finding: Finding,
    /// how to see what laws say of it
    pub replay: Replay,
}

/// How many of the worst rows are kept.
pub const WORST: usize = 5;

impl Worst {
    /// A row that fails a check.
    #[must_use]
    pub fn of(case: &Case<'_>, check: Check, finding: Finding) -> Self {
        Self {
            line: case.row.line,
            id: case.row.id.clone(),
            check,
            finding,
            replay: replay(&case.event, &case.given, case.row.stated_shape(Side::First)),
        }
    }
}
