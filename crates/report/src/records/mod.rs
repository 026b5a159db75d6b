//! What was found in a log of impacts: the sentence that names it, and the report around it.

mod compared;
mod json;
mod junit;
#[cfg(test)]
mod made_up;
mod pictures;
mod sentence;
mod sheet;
mod wording;

#[cfg(feature = "schema")]
pub(crate) use compared::baseline_schema;
pub use compared::{compared_json, compared_markdown, compared_text};
#[cfg(feature = "schema")]
pub(crate) use json::report_schema;
pub use json::{RECORDS_SCHEMA_NAME, RECORDS_SCHEMA_VERSION, json};
pub use junit::{compared_junit, junit};
pub use sentence::headline;
pub use sheet::sheet;
pub use wording::schema;
pub(crate) use wording::{suspicion as suspected, told};

use kane_records::study::Study;

/// A study, and how its report is headed.
#[derive(Clone, Copy, Debug)]
pub struct RecordsReport<'a> {
    /// what was found
    pub study: &'a Study,
    /// the log, as its user calls it
    pub log: &'a str,
    /// the command that prints this again
    pub command: &'a str,
}
