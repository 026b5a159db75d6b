//! Laws against properties: a sheet, a page of its own, JSON, CSV, a picture, and one cell in full.

mod csv;
mod explain;
mod finding;
mod html;
mod json;
mod picture;
mod sheet;

use kane_matrix::{Finding, Matrix, Row};

pub use csv::csv;
pub use explain::explain;
pub(crate) use finding::{breaking, conflicts};
pub use html::{html, html_in_site};
#[cfg(feature = "schema")]
pub(crate) use json::schema;
pub use json::{LAWS_SCHEMA_NAME, LAWS_SCHEMA_VERSION, json};
pub use picture::picture;
pub use sheet::{properties, sheet};

/// The matrix, and the command that prints it again.
#[derive(Clone, Debug)]
pub struct MatrixReport<'a> {
    /// the findings
    pub matrix: &'a Matrix,
    /// a command that prints this report
    pub command: String,
}

impl MatrixReport<'_> {
    /// How many laws, properties, and cells of each finding.
    pub(crate) fn headline(&self) -> String {
        let matrix = self.matrix;
        let counted = |n: usize, one: &str, many: &str| {
            if n == 1 { format!("1 {one}") } else { format!("{n} {many}") }
        };
        let mut parts = Vec::new();
        for finding in FINDINGS {
            let count = matrix.count(finding);
            if count > 0 {
                parts.push(format!("{count} {}", word(finding)));
            }
        }
        format!(
            "{}, {}: {}",
            counted(matrix.rows.len(), "law", "laws"),
            counted(matrix.properties.len(), "property", "properties"),
            parts.join(", ")
        )
    }
}

/// All findings, in the order in which they are counted and explained.
pub(crate) const FINDINGS: [Finding; 4] =
    [Finding::Proved, Finding::Refuted, Finding::NotApplicable, Finding::Undecided];

/// A finding in a word.
pub(crate) fn word(finding: Finding) -> &'static str {
    match finding {
        Finding::Proved => "proved",
        Finding::Refuted => "refuted",
        Finding::NotApplicable => "not applicable",
        Finding::Undecided => "undecided",
    }
}

/// A finding in a cell.
pub(crate) fn mark(finding: Finding) -> &'static str {
    match finding {
        Finding::Proved => "yes",
        Finding::Refuted => "no",
        Finding::NotApplicable => "-",
        Finding::Undecided => "?",
    }
}

/// The law's id, with a mark where something must not be missed.
pub(crate) fn marked(row: &Row) -> String {
    let mark = if row.law.info.caveat.is_some() { "†" } else { "" };
    format!("{}{mark}", row.law.info.id)
}

/// What must not be missed of the laws that bear the mark.
pub(crate) fn caveats(matrix: &Matrix) -> Vec<String> {
    let told = matrix.rows.iter().filter_map(|row| Some((row.law.info.id, row.law.info.caveat?)));
    told.map(|(id, caveat)| format!("† {id}: {caveat}.")).collect()
}

/// The law's own parameters, `name = value, …`.
pub(crate) fn parameters(row: &Row) -> String {
    let pairs = row.law.parameters().into_iter().map(|(name, value)| format!("{name} = {value}"));
    pairs.collect::<Vec<_>>().join(", ")
}
