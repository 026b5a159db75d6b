//! A study for a terminal.

use std::fmt::Write as _;

use anstyle::{AnsiColor, Style};
use kane_records::study::Study;

use super::RecordsReport;
use super::sentence::headline;
use super::wording::{
    alias, asks, asks_briefly, friction_name, interval, law, log_facts, pair, rejected, replayed,
    residual, suspicion, untold, verdict,
};
use crate::Page;
use crate::columns::{Column, lines, wrapped};

/// Columns of a page that has no width of its own, as in a file.
const WIDTH: usize = 100;
/// How many laws are listed that do not give every row.
const OTHERS: usize = 5;
/// Pairs of materials that are listed.
const PAIRS: usize = 20;

/// The study as text.
#[must_use]
pub fn text(report: &RecordsReport<'_>, page: Page) -> String {
    let study = report.study;
    let (width, cut) = (page.width.unwrap_or(WIDTH), page.width.is_some());
    let ink = |style| if page.colour { style } else { Style::new() };
    let bold = ink(Style::new().bold());
    let alarm = ink(Style::new().bold().fg_color(Some(AnsiColor::Red.into())));
    let mut out = format!("{}\n", report.log);
    for line in wrapped("", &headline(study), width) {
        let _ = writeln!(out, "{bold}{line}{bold:#}");
    }
    out.push('\n');
    paragraph(&mut out, "log        ", &log_facts(report), width);
    for line in rejected(study) {
        paragraph(&mut out, "REJECTED   ", &line, width);
    }
    for found in &study.suspicions {
        paragraph(&mut out, "SUSPECTED  ", &suspicion(found), width);
    }
    if !study.header.unread.is_empty() {
        paragraph(&mut out, "not read   ", &study.header.unread.join(", "), width);
    }
    if !study.header.unitless.is_empty() {
        let names = study.header.unitless.join(", ");
        paragraph(&mut out, "SI assumed ", &names, width);
    }
    checks(&mut out, study, (width, cut), alarm);
    friction(&mut out, study, (width, cut));
    laws(&mut out, study, (width, cut));
    coefficients(&mut out, study);
    if !study.untold.is_empty() {
        out.push_str(
            "\nWhat these rows cannot tell (kane check --generate prints impacts that would)\n",
        );
        for open in &study.untold {
            paragraph(&mut out, "  ", &untold(open), width);
        }
    }
    worst(&mut out, report);
    let _ = writeln!(out, "\nkane {}: {}", env!("CARGO_PKG_VERSION"), report.command);
    out
}

fn paragraph(out: &mut String, head: &str, text: &str, width: usize) {
    for line in wrapped(head, text, width) {
        let _ = writeln!(out, "{}", line.trim_end());
    }
}

fn table(out: &mut String, columns: &[Column], (width, cut): (usize, bool)) -> Vec<usize> {
    let mut starts = Vec::new();
    for block in lines(columns, width.saturating_sub(2), cut) {
        for line in block {
            starts.push(out.len());
            let _ = writeln!(out, "  {line}");
        }
    }
    starts
}

fn checks(out: &mut String, study: &Study, page: (usize, bool), alarm: Style) {
    out.push_str("\nChecks, with the worst residual and what is allowed\n");
    let asked: Vec<_> = study.checks.iter().filter(|checked| checked.rows > 0).collect();
    let of = |cell: &dyn Fn(&kane_records::study::Checked) -> String| {
        asked.iter().map(|checked| cell(checked)).collect::<Vec<_>>()
    };
    let worst = |checked: &kane_records::study::Checked| {
        checked.worst.map_or_else(String::new, |(line, finding)| {
            format!("{} (line {line})", residual(checked.check, &finding))
        })
    };
    let columns = [
        Column::left("check", of(&|checked| asks_briefly(checked.check).to_owned())),
        Column::left("verdict", of(&verdict)),
        Column::right("rows", of(&|checked| checked.rows.to_string())),
        Column::right("near", of(&|checked| checked.near.to_string())),
        Column::left("worst", of(&worst)),
    ];
    let mut text = String::new();
    table(&mut text, &columns, page);
    for line in text.lines() {
        if line.contains("FAILS") {
            let _ = writeln!(out, "{alarm}{line}{alarm:#}");
        } else {
            let _ = writeln!(out, "{line}");
        }
    }
}

fn friction(out: &mut String, study: &Study, page: (usize, bool)) {
    if study.friction.is_empty() {
        return;
    }
    out.push_str("\nFriction, given the measured normal impulse: misses of k\n");
    let of = |cell: &dyn Fn(&kane_records::friction::FrictionFit) -> String| {
        study.friction.iter().map(cell).collect::<Vec<_>>()
    };
    let columns = [
        Column::left("law", of(&|fit| friction_name(fit.law))),
        Column::right("within tolerance", of(&|fit| format!("{} of {}", fit.consistent, fit.rows))),
        Column::right("within 0.01", of(&|fit| fit.close.to_string())),
        Column::right("median", of(&|fit| format!("{:.1e}", fit.median))),
        Column::right("worst", of(&|fit| format!("{:.1e} (line {})", fit.worst, fit.worst_line))),
    ];
    table(out, &columns, page);
}

fn laws(out: &mut String, study: &Study, page: (usize, bool)) {
    let giving = study.consistent_laws().count();
    let shown: Vec<_> = study.laws.iter().take(giving.max(OTHERS)).collect();
    if shown.is_empty() {
        return;
    }
    out.push_str("\nRigid laws, with mu and e as stated: misses of the velocity afterwards\n");
    let of = |cell: &dyn Fn(&kane_records::rigid::LawFit) -> String| {
        shown.iter().map(|fit| cell(fit)).collect::<Vec<_>>()
    };
    let columns = [
        Column::left("law", of(&law)),
        Column::right("gives", of(&|fit| format!("{} of {}", fit.consistent, fit.rows))),
        Column::right("median", of(&|fit| format!("{:.1e}", fit.median))),
        Column::right("worst", of(&|fit| format!("{:.1e} (line {})", fit.worst, fit.worst_line))),
    ];
    table(out, &columns, page);
    for fit in shown.iter().filter(|fit| fit.gives_all() && !alias(fit).is_empty()) {
        paragraph(out, "  ", &format!("{}: {}.", fit.law.info.id, alias(fit)), page.0);
    }
}

fn coefficients(out: &mut String, study: &Study) {
    out.push_str("\nCoefficients, as measured\n");
    for fit in study.fits.iter().take(PAIRS) {
        let mut parts = Vec::new();
        for (symbol, fitted) in
            [("e", &fit.restitution), ("mu", &fit.friction), ("beta0", &fit.rebound)]
        {
            if let Some(fitted) = fitted {
                parts.push(format!("{symbol} {} ({} rows)", interval(fitted), fitted.rows));
            }
        }
        let _ = writeln!(out, "  {}: {}", pair(fit, study), parts.join("; "));
    }
    if study.fits.len() > PAIRS {
        let _ = writeln!(out, "  and {} pairs more", study.fits.len() - PAIRS);
    }
}

fn worst(out: &mut String, report: &RecordsReport<'_>) {
    if report.study.worst.is_empty() {
        return;
    }
    out.push_str("\nThe worst rows\n");
    for worst in &report.study.worst {
        let id = if worst.id.is_empty() { String::new() } else { format!(" ({})", worst.id) };
        let _ = writeln!(
            out,
            "  line {}{id}: {} - left {}\n    {}",
            worst.line,
            asks(worst.check),
            residual(worst.check, &worst.finding),
            replayed(worst, report.log)
        );
    }
}
