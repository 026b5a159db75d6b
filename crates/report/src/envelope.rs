//! What every report for programs has: what it is, what wrote it, and the line feed at its end.

use serde::Serialize;

/// The name and the version of a report's format.
#[derive(Serialize)]
pub(crate) struct Schema {
    pub(crate) name: &'static str,
    pub(crate) version: u32,
}

/// The program that wrote it.
#[derive(Serialize)]
pub(crate) struct Program {
    name: &'static str,
    version: &'static str,
}

/// A report for programs as text, ended by a line feed.
pub(crate) fn written(report: &impl Serialize) -> String {
    let mut out = serde_json::to_string_pretty(report)
        .expect("numbers, strings, lists and maps with string keys always serialise");
    out.push('\n');
    out
}

impl Program {
    /// This program.
    pub(crate) const THIS: Self = Self { name: "kane", version: env!("CARGO_PKG_VERSION") };
}
