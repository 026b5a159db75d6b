//! The report for a terminal.

use std::fmt::Write as _;

use anstyle::{AnsiColor, Style};
use kane_scene::Verdict;
use kane_scene::simulate::Ending;
use unicode_width::UnicodeWidthStr as _;

use super::{SceneReport, brief, cost, error, moved, number, verdict, who};
use crate::Page;
use crate::shorten::{padded, shorten};

/// Columns where the page has no width.
const WIDTH: usize = 100;
/// Impacts that a terminal is shown; the files have all.
const ROWS: usize = 16;

/// The report as text: the answer, why, the models, the ledger.
#[must_use]
pub fn text(report: &SceneReport<'_>, page: Page) -> String {
    let width = page.width.unwrap_or(WIDTH);
    let bold = if page.colour { Style::new().bold() } else { Style::new() };
    let answer = report.answer;
    let mut out = String::new();
    let _ = writeln!(out, "{}", report.title);
    let _ = writeln!(out, "{bold}{}{bold:#}\n", report.headline());

    let uncertain = answer.lines.iter().any(|line| line.spread.is_some());
    let mut rows =
        vec![vec!["asked".to_owned(), "answer".into(), "error".into(), "tolerance".into()]];
    if uncertain {
        rows[0].push("inputs move it by".into());
    }
    for line in &answer.lines {
        let value = line.exact.as_ref().filter(|exact| exact.width() <= 24);
        let value = value.cloned().unwrap_or_else(|| number(line.value));
        let mut row = vec![
            line.quantity.to_string(),
            value,
            error(line.error, answer.known),
            brief(line.tolerance),
        ];
        if uncertain {
            row.push(moved(line.spread));
        }
        rows.push(row);
    }
    table(&mut out, &rows, width);

    out.push('\n');
    wrapped(&mut out, &answer.reasons.join(" "), width);

    out.push('\n');
    let mut rows =
        vec![vec!["model".to_owned(), "cost".into(), "error/tol.".into(), "verdict".into()]];
    for judged in &answer.judged {
        rows.push(vec![
            judged.model.to_string(),
            cost(judged),
            judged.ratio.map_or_else(|| "-".to_owned(), brief),
            verdict(&judged.verdict, answer.known),
        ]);
    }
    let good: Vec<bool> =
        answer.judged.iter().map(|judged| judged.verdict == Verdict::Meets).collect();
    for (index, line) in formatted(&rows, width).into_iter().enumerate() {
        let good = index > 0 && good.get(index - 1).copied().unwrap_or(false);
        let ink = match good && page.colour {
            true => Style::new().fg_color(Some(AnsiColor::Green.into())),
            false => Style::new(),
        };
        let _ = writeln!(out, "{ink}{line}{ink:#}");
    }

    if !answer.bounces.is_empty() {
        out.push_str("\nenergy by part, J\n");
        ledger(&mut out, report, width);
    }
    let _ = writeln!(out, "\nkane {}: {}", env!("CARGO_PKG_VERSION"), report.command);
    out
}

fn ledger(out: &mut String, report: &SceneReport<'_>, width: usize) {
    let answer = report.answer;
    let bodies = answer.end.as_ref().map_or(1, |end| end.bodies.len());
    let head = ["t, s", "who", "what", "normal", "tangential", "rotational", "gravity"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    for bounce in answer.bounces.iter().take(ROWS) {
        let brief = |x: &kane_scene::Shown| short(x.value);
        rows.push(vec![
            short(bounce.time.value),
            who(bounce.encounter, bodies),
            bounce.regime.to_owned(),
            brief(&bounce.ledger.normal),
            brief(&bounce.ledger.tangential),
            brief(&bounce.ledger.rotational),
            brief(&bounce.gravity),
        ]);
    }
    table(out, &rows, width);
    let Some(end) = &answer.end else { return };
    let more = end.impacts.saturating_sub(u64::try_from(rows.len() - 1).unwrap_or(u64::MAX));
    if more > 0 {
        let _ = writeln!(out, "… and {more} more impacts");
    }
    let how = match end.ending {
        Ending::Impacts => "after the impacts asked for",
        Ending::Duration => "at the end of the time asked for",
        Ending::Rest => "at rest, after infinitely many more impacts",
        Ending::Quiet => "nothing meets any more",
    };
    let _ = writeln!(out, "t = {} s: {how}", short(end.time.value));
}

/// Six digits.
fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let magnitude = value.abs();
    if (1e-3..1e5).contains(&magnitude) {
        let text = format!("{value:.5}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{value:.3e}")
    }
}

fn table(out: &mut String, rows: &[Vec<String>], width: usize) {
    for line in formatted(rows, width) {
        let _ = writeln!(out, "{line}");
    }
}

/// Columns as wide as their widest cell; the last one may be cut.
fn formatted(rows: &[Vec<String>], width: usize) -> Vec<String> {
    let columns = rows.first().map_or(0, Vec::len);
    let wide = |column: usize| {
        rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.width()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(wide).collect();
    let line = |row: &Vec<String>| {
        let cells = row.iter().zip(&widths).map(|(cell, width)| padded(cell, *width));
        shorten(cells.collect::<Vec<_>>().join("  ").trim_end(), width)
    };
    rows.iter().map(line).collect()
}

/// Prose, broken at blanks.
fn wrapped(out: &mut String, prose: &str, width: usize) {
    let mut line = String::new();
    for word in prose.split_whitespace() {
        if !line.is_empty() && line.width() + 1 + word.width() > width {
            let _ = writeln!(out, "{line}");
            line.clear();
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    let _ = writeln!(out, "{line}");
}
