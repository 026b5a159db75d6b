//! The matrix for a terminal.

use std::fmt::Write as _;

use anstyle::{AnsiColor, Style};
use kane_matrix::{Finding, unmarked};

use super::{MatrixReport, mark, parameters};
use crate::Page;
use crate::shorten::{padded, shorten};

/// Columns where the page has no width.
const WIDTH: usize = 120;
/// Columns of a law's id, and of a cell.
const ID: usize = 19;
const CELL: usize = 5;

/// The matrix as text: the table, what its heads mean, and what was found against each law.
#[must_use]
pub fn text(report: &MatrixReport<'_>, page: Page) -> String {
    let width = page.width.unwrap_or(WIDTH);
    let ink = |style: Style| if page.colour { style } else { Style::new() };
    let bold = ink(Style::new().bold());
    let matrix = report.matrix;
    let mut out = String::new();
    let _ = writeln!(out, "Laws and properties\n{bold}{}{bold:#}\n", report.headline());

    let heads: String = matrix.properties.iter().map(|p| padded(p.head, CELL)).collect();
    let _ = writeln!(out, "{}{}", padded("law", ID), heads.trim_end());
    for row in &matrix.rows {
        let _ = write!(out, "{}", padded(row.law.info.id, ID));
        for (index, cell) in row.cells.iter().enumerate() {
            let ink = ink(style(cell.finding));
            let last = index + 1 == row.cells.len();
            let mark = mark(cell.finding);
            let gap = if last { 0 } else { CELL - mark.len() };
            let _ = write!(out, "{ink}{mark}{ink:#}{:gap$}", "");
        }
        out.push('\n');
    }
    out.push_str("\nyes: proved, no: refuted, -: not applicable, ?: undecided; * for every planar contact, else W_tn = 0\n\n");
    for property in &matrix.properties {
        let row = format!(
            "{} {}: {}",
            padded(property.head, CELL),
            padded(property.id, 18).trim_end(),
            property.template
        );
        let _ = writeln!(out, "{}", shorten(&row, width));
    }
    for row in &matrix.rows {
        let remarks = report.remarks(row);
        if remarks.is_empty() {
            continue;
        }
        let with = parameters(row);
        let with = if with.is_empty() { with } else { format!(", {with}") };
        let _ = writeln!(out, "\n{bold}{}{with}{bold:#}", row.law.info.id);
        let _ = writeln!(out, "{}", shorten(&format!("  {}", row.law.info.source), width));
        for (property, cell) in remarks {
            let ink = ink(style(cell.finding));
            let line = format!(
                "  {} {} {}",
                padded(mark(cell.finding), 3),
                padded(property.id, 17),
                unmarked(&cell.reason)
            );
            let _ = writeln!(out, "{ink}{}{ink:#}", shorten(&line, width));
        }
    }
    let _ = writeln!(out, "\nkane {}: {}", env!("CARGO_PKG_VERSION"), report.command);
    out
}

/// The ink of a finding.
fn style(finding: Finding) -> Style {
    let colour = |colour: AnsiColor| Style::new().fg_color(Some(colour.into()));
    match finding {
        Finding::Proved => colour(AnsiColor::Green),
        Finding::Refuted => colour(AnsiColor::Red),
        Finding::NotApplicable => Style::new().dimmed(),
        Finding::Undecided => colour(AnsiColor::Yellow),
    }
}
