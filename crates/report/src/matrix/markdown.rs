//! The matrix for the web, and the page of its properties.

use std::fmt::Write as _;

use kane_matrix::{Finding, PROPERTIES, unmarked};

use super::{MatrixReport, mark, parameters, word};

/// The matrix as Markdown: the table, and a list of findings a law.
#[must_use]
pub fn markdown(report: &MatrixReport<'_>) -> String {
    let matrix = report.matrix;
    let mut out = format!("# Laws and properties\n\n{}.\n\n", report.headline());
    let heads: Vec<_> = matrix.properties.iter().map(|p| p.head.replace('|', "\\|")).collect();
    let _ = writeln!(out, "| law | {} |", heads.join(" | "));
    let _ = writeln!(out, "|---|{}", "---|".repeat(heads.len()));
    for row in &matrix.rows {
        let cells = row.cells.iter().map(|cell| match cell.finding {
            Finding::Refuted => "**no**",
            other => mark(other),
        });
        let _ =
            writeln!(out, "| {} | {} |", row.law.info.id, cells.collect::<Vec<_>>().join(" | "));
    }
    out.push_str("\nyes: proved, no: refuted, -: not applicable, ?: undecided; * for every planar contact, else W_tn = 0.\n\n");
    for property in &matrix.properties {
        let head = property.head.replace('|', "\\|");
        let _ = writeln!(
            out,
            "- {head} (`{}`): {}, `{}`",
            property.id, property.name, property.template
        );
    }
    for row in &matrix.rows {
        let _ = writeln!(out, "\n## {}\n\n{}.", row.law.info.id, row.law.info.source);
        let with = parameters(row);
        if !with.is_empty() {
            let _ = writeln!(out, "Here with {with}.");
        }
        out.push('\n');
        for (property, cell) in matrix.properties.iter().zip(&row.cells) {
            let _ = writeln!(
                out,
                "- {} {}: {}",
                property.name,
                word(cell.finding),
                unmarked(&cell.reason).replace('|', "\\|").replace('*', "\\*")
            );
        }
    }
    let _ = writeln!(out, "\nkane {}: `{}`", env!("CARGO_PKG_VERSION"), report.command);
    out
}

/// The page that says what each property asks: `docs/properties.md`, from its table on.
#[must_use]
pub fn properties() -> String {
    let mut out = String::from("| column | id | property | asked of |\n|---|---|---|---|\n");
    for p in &PROPERTIES {
        let head = p.head.replace('|', "\\|");
        let _ = writeln!(out, "| {head} | `{}` | {} | {} |", p.id, p.name, unmarked(p.domain));
    }
    for p in &PROPERTIES {
        let _ = writeln!(
            out,
            "\n## {}\n\n`{}`, for {}:\n\n```\n{}\n```\n\n{}",
            p.name,
            p.id,
            unmarked(p.domain),
            p.template,
            unmarked(p.meaning)
        );
    }
    out
}
