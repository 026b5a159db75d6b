//! The matrix as rows for spreadsheets: the data of its picture.

use kane_matrix::unmarked;

use super::{MatrixReport, word};

/// A row a cell: law, property, finding, how many certificates, and why.
#[must_use]
pub fn csv(report: &MatrixReport<'_>) -> String {
    let rows = report.matrix.rows.iter().flat_map(|row| {
        report.matrix.properties.iter().zip(&row.cells).map(|(property, cell)| {
            let cells = [row.law.info.id, property.id, word(cell.finding)].map(str::to_owned);
            [&cells[..], &[cell.parts.len().to_string(), unmarked(&cell.reason)]].concat()
        })
    });
    crate::sheet::csv("law,property,finding,certificates,reason", rows)
}
