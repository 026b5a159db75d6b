//! The report for a terminal.

use std::fmt::Write as _;

use anstyle::{AnsiColor, Style};
use kane_measure::Fault;

use super::{Entry, StabilityReport, bits, interval, named, short, short_all, title};
use crate::Page;
use crate::shorten::{padded, shorten};

/// Columns where the page has no width.
const WIDTH: usize = 100;

/// The report as text: the formulas that fail, each with its ranges, then those that do not.
#[must_use]
pub fn text(report: &StabilityReport<'_>, page: Page) -> String {
    let width = page.width.unwrap_or(WIDTH);
    let ink = |style: Style| if page.colour { style } else { Style::new() };
    let bold = ink(Style::new().bold());
    let stability = report.stability;
    let mut out = String::new();
    match &stability.title {
        Some(title) => _ = writeln!(out, "{title} ({})", stability.name),
        None => _ = writeln!(out, "{}", stability.name),
    }
    let _ = writeln!(out, "{bold}{}{bold:#}", report.headline());
    out.push_str(
        "a range runs from the first to the last failing input; bits lost at its worst input\n\
         cells are of a plane of two inputs >= 0; points are a search over more inputs or other signs\n",
    );

    let entries = report.entries();
    for entry in entries.iter().filter(|entry| entry.fails()) {
        out.push('\n');
        let _ = writeln!(out, "{bold}{}{bold:#}", shorten(&heading(entry), width));
        let betters = betters(report, entry);
        for line in &entry.lines {
            for range in &line.ranges {
                let mark = mark(report, &betters, range.better.as_ref());
                let row = format!(
                    "  {:4}{} {} {:>5} of {} at {} {mark}{}",
                    line.format,
                    padded(&range.fault.to_string(), 12),
                    padded(&interval(range), 24),
                    bits(range.lost),
                    line.precision,
                    padded(&short(&range.worst), 11),
                    range.cause,
                );
                let ink = ink(style(range.fault));
                let _ = writeln!(out, "{ink}{}{ink:#}", shorten(&row, width));
            }
        }
        for plane in &entry.planes {
            for (fault, count, (first, second)) in &plane.faults {
                let row = format!(
                    "  {:4}{} {count} of {} cells, as at {}, {}",
                    plane.format,
                    padded(&fault.to_string(), 12),
                    plane.cells.len(),
                    short(first),
                    short(second),
                );
                let ink = ink(style(*fault));
                let _ = writeln!(out, "{ink}{}{ink:#}", shorten(&row, width));
            }
        }
        for search in &entry.searches {
            for (fault, count, example) in &search.faults {
                let row = format!(
                    "  {:4}{} {count} of {} points, as at {}",
                    search.format,
                    padded(&fault.to_string(), 12),
                    search.tried,
                    short_all(example),
                );
                let ink = ink(style(*fault));
                let _ = writeln!(out, "{ink}{}{ink:#}", shorten(&row, width));
            }
        }
        for (index, better) in betters.iter().enumerate() {
            let mark = if betters.len() > 1 { letter(index) } else { String::new() };
            let row = format!("  {} {better}", padded(&format!("better {mark}"), 15));
            let _ = writeln!(out, "{}", shorten(&row, width));
        }
    }

    sound(&mut out, &entries, width);
    if !stability.subject.left_out.is_empty() {
        out.push_str("\nleft out\n");
    }
    for (label, why) in &stability.subject.left_out {
        let _ = writeln!(out, "{}", shorten(&format!("  {label}: {why}"), width));
    }
    let _ = writeln!(out, "\nkane {}: {}", env!("CARGO_PKG_VERSION"), report.command);
    out
}

/// Label, quantity and formula, and what is evaluated first.
fn heading(entry: &Entry<'_>) -> String {
    let formula = entry.formula;
    let notes = entry.notes();
    let notes = if notes.is_empty() { notes } else { format!("    {notes}") };
    format!("{}{notes}", title(formula))
}

/// The formulas that are better somewhere, in the order of their first mention.
fn betters(report: &StabilityReport<'_>, entry: &Entry<'_>) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for range in entry.lines.iter().flat_map(|line| &line.ranges) {
        if let Some(formula) = range.better.as_ref().and_then(|better| report.better(better)) {
            let name = named(formula);
            if !found.contains(&name) {
                found.push(name);
            }
        }
    }
    found
}

/// The letter behind a row that says which of several better formulas is meant.
fn mark(
    report: &StabilityReport<'_>,
    betters: &[String],
    better: Option<&kane_measure::Better>,
) -> String {
    let Some(better) = better.and_then(|better| report.better(better)) else {
        return if betters.is_empty() { String::new() } else { "[none] ".to_owned() };
    };
    let name = named(better);
    match betters.iter().position(|known| *known == name) {
        Some(index) if betters.len() > 1 => format!("{} ", letter(index)),
        _ => String::new(),
    }
}

fn letter(index: usize) -> String {
    let letters = "abcdefghijklmnopqrstuvwxyz";
    letters.chars().nth(index).map_or_else(String::new, |letter| format!("[{letter}]"))
}

/// The formulas that never lose half of the digits, with the worst that they do.
fn sound(out: &mut String, entries: &[Entry<'_>], width: usize) {
    let sound: Vec<&Entry<'_>> = entries.iter().filter(|entry| !entry.fails()).collect();
    if sound.is_empty() {
        return;
    }
    out.push_str("\nno failure, and the most bits lost\n");
    for entry in sound {
        let mut losses = Vec::new();
        for (format, lost, at) in entry.losses() {
            let at = at.map_or_else(String::new, |at| format!(" at {}", padded(&short(at), 9)));
            losses.push(padded(&format!("{format} {:>4}{at}", bits(lost)), 21));
        }
        let row = format!("  {}  {}", losses.join("  "), heading(entry));
        let _ = writeln!(out, "{}", shorten(&row, width));
    }
}

/// The ink of a fault.
fn style(fault: Fault) -> Style {
    let colour = |colour: AnsiColor| Style::new().fg_color(Some(colour.into()));
    match fault {
        Fault::Lost => colour(AnsiColor::Yellow),
        _ => colour(AnsiColor::Red),
    }
}
