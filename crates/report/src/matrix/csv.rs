//! The matrix as rows for spreadsheets: the data of its picture.

use std::fmt::Write as _;

use kane_matrix::unmarked;

use super::{MatrixReport, word};
use crate::sheet::quoted;

/// A row a cell: law, property, finding, how many certificates, and why.
#[must_use]
pub fn csv(report: &MatrixReport<'_>) -> String {
    let mut out = String::from("law,property,finding,certificates,reason\n");
    for row in &report.matrix.rows {
        for (property, cell) in report.matrix.properties.iter().zip(&row.cells) {
            let (finding, parts) = (word(cell.finding), cell.parts.len());
            let reason = quoted(&unmarked(&cell.reason));
            let _ = writeln!(out, "{},{},{finding},{parts},{reason}", row.law.info.id, property.id);
        }
    }
    out
}
