//! The report for the web.

use std::fmt::Write as _;

use super::{StabilityReport, bits, interval, named, short, short_all};

/// The report as Markdown: one table a formula that fails, and one of those that do not.
#[must_use]
pub fn markdown(report: &StabilityReport<'_>) -> String {
    let stability = report.stability;
    let mut out = String::new();
    let title = stability.title.as_deref().unwrap_or(&stability.name);
    let _ = writeln!(out, "# {title}: stability\n\n{}.\n", report.headline());
    out.push_str("A range runs from the first to the last failing input; what is lost is that at its worst input.\n");
    let entries = report.entries();
    for entry in entries.iter().filter(|entry| entry.fails()) {
        let formula = entry.formula;
        let _ =
            writeln!(out, "\n## {}: `{} = {}`\n", formula.label, formula.quantity, formula.text);
        let notes = entry.notes();
        if !notes.is_empty() {
            let _ = writeln!(out, "({notes})\n");
        }
        if !entry.lines.is_empty() {
            out.push_str(
                "| | fault | range | bits lost | at | returns | exact | where | better |\n",
            );
            out.push_str("|---|---|---|---|---|---|---|---|---|\n");
        }
        for line in &entry.lines {
            for range in &line.ranges {
                let better = range.better.as_ref().and_then(|better| report.better(better));
                let better = better.map_or_else(String::new, |better| {
                    format!("`{}`", named(better).replace("  ", "` "))
                });
                let _ = writeln!(
                    out,
                    "| {} | {} | {} | {} of {} | {} | {} | {} | `{}` | {} |",
                    line.format,
                    range.fault,
                    interval(range),
                    bits(range.lost),
                    line.precision,
                    short(&range.worst),
                    range.computed,
                    range.exact,
                    range.cause,
                    better.trim_end_matches('`'),
                );
            }
        }
        if !entry.planes.is_empty() {
            out.push_str("| | fault | cells | as at |\n|---|---|---|---|\n");
        }
        for plane in &entry.planes {
            for (fault, count, (first, second)) in &plane.faults {
                let (cells, a, b) = (plane.cells.len(), short(first), short(second));
                let _ =
                    writeln!(out, "| {} | {fault} | {count} of {cells} | {a}, {b} |", plane.format);
            }
        }
        if !entry.searches.is_empty() {
            out.push_str("\n| | fault | points | as at |\n|---|---|---|---|\n");
        }
        for search in &entry.searches {
            for (fault, count, example) in &search.faults {
                let (points, at) = (search.tried, short_all(example));
                let _ =
                    writeln!(out, "| {} | {fault} | {count} of {points} | {at} |", search.format);
            }
        }
    }
    if entries.iter().any(|entry| !entry.fails()) {
        out.push_str("\n## No failure\n\n| formula | most bits lost |\n|---|---|\n");
    }
    for entry in entries.iter().filter(|entry| !entry.fails()) {
        let formula = entry.formula;
        let losses = entry.losses();
        let losses: Vec<String> =
            losses.iter().map(|(format, lost, _)| format!("{format} {}", bits(*lost))).collect();
        let _ = writeln!(
            out,
            "| {}: `{} = {}` | {} |",
            formula.label,
            formula.quantity,
            formula.text,
            losses.join(", ")
        );
    }
    if !stability.subject.left_out.is_empty() {
        out.push_str("\n## Left out\n\n");
    }
    for (label, why) in &stability.subject.left_out {
        let _ = writeln!(out, "- {label}: {why}");
    }
    let _ = writeln!(out, "\nkane {}: `{}`", env!("CARGO_PKG_VERSION"), report.command);
    out
}
