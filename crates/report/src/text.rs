//! The report for a terminal: the news first, then one line a statement.

use std::fmt::Write as _;

use anstyle::{AnsiColor, Style};
use kane_audit::Verdict;
use unicode_width::UnicodeWidthStr;

use crate::report::Entry;
use crate::sheet::wrapped;
use crate::shorten::{padded, shorten};
use crate::words::Form;
use crate::{Page, Report, Summary};

/// Columns for the longest label that is shown in full.
const LABEL: usize = 16;
/// Columns for what a statement says, where the page has no width.
const SAYING: usize = 48;
/// Before a reason that stands below what is said.
const REASON: &str = "      ";
/// Columns for the longest verdict.
const VERDICT: usize = 11;

/// The report as text.
#[must_use]
pub fn text(report: &Report<'_>, page: Page) -> String {
    let ink = |style| if page.colour { style } else { Style::new() };
    let summary = Summary::of(report);
    let mut out = String::new();
    let document = &report.audit.document;
    match &document.title {
        Some(title) => _ = writeln!(out, "{title} ({})", document.name),
        None => _ = writeln!(out, "{}", document.name),
    }
    let bold = ink(Style::new().bold());
    let _ = writeln!(out, "{bold}{}{bold:#}", summary.headline());
    let tone = ink(if summary.surprises.is_empty() { Style::new() } else { alarm() });
    let _ = writeln!(out, "{tone}{}{tone:#}\n", summary.expectation());

    let columns = Columns::of(report, page);
    for entry in report.entries() {
        line(&mut out, &entry, &columns, ink(style(&entry)));
    }
    out.push('\n');
    if let Some(pointer) = report.pointer {
        let _ = writeln!(out, "{pointer}");
    }
    let _ = writeln!(out, "kane {}: {}", env!("CARGO_PKG_VERSION"), report.command);
    out
}

/// How wide the columns are.
struct Columns {
    label: usize,
    saying: usize,
    /// what is left for what is said and the reason; `None` is without end
    rest: Option<usize>,
    width: Option<usize>,
}

impl Columns {
    /// Labels take what they need; of the rest, what is said takes at most half, so that the reason is seen.
    fn of(report: &Report<'_>, page: Page) -> Self {
        let widest = |f: &dyn Fn(&Entry<'_>) -> usize| {
            report.entries().map(|entry| f(&entry)).max().unwrap_or(0)
        };
        let label = widest(&|entry| entry.statement.label.width()).min(LABEL);
        let longest = widest(&|entry| {
            if entry.is_claim() { entry.saying().width() } else { 0 }
        });
        let rest = page.width.map(|width| width.saturating_sub(2 + VERDICT + 2 + label + 2));
        let saying = longest.min(rest.map_or(SAYING, |rest| rest / 2));
        Self { label, saying, rest, width: page.width }
    }
}

/// Writes the line of one statement.
fn line(out: &mut String, entry: &Entry<'_>, columns: &Columns, style: Style) {
    let mark = if entry.judgement.as_expected() { ' ' } else { '!' };
    let verdict = entry.judgement.verdict.to_string();
    let label = padded(&shorten(&entry.statement.label, columns.label), columns.label);
    let _ = write!(out, "{style}{mark} {verdict:VERDICT$}{style:#}  {label}  ");
    let reason = reason(entry);
    let rest = columns.rest.unwrap_or(usize::MAX);
    let said = entry.saying();
    let whole = format!("{}  {reason}", padded(&shorten(&said, columns.saying), columns.saying));
    if reason.is_empty() {
        out.push_str(&shorten(&said, rest));
    } else if let Some(width) = columns.width
        && whole.width() > rest
        && (!entry.judgement.as_expected() || entry.judgement.verdict != Verdict::Proved)
    {
        // what decides against a claim is seen whole, below it
        out.push_str(&shorten(&said, rest));
        out.truncate(out.trim_end().len());
        for line in wrapped(REASON, &reason, width) {
            let _ = write!(out, "\n{}", shorten(&line, width));
        }
    } else {
        out.push_str(&shorten(&whole, rest));
    }
    out.truncate(out.trim_end().len());
    out.push('\n');
}

/// Why the verdict is what it is, in one line; empty where there is nothing to say.
fn reason(entry: &Entry<'_>) -> String {
    if !entry.is_claim() {
        return String::new();
    }
    let judgement = entry.judgement;
    let mut parts: Vec<String> = entry.expectation().into_iter().chain(entry.support()).collect();
    parts.extend(entry.decisive_reason(Form::Plain));
    if judgement.verdict == Verdict::Proved && judgement.met.is_none() && entry.supposes() {
        parts.push("no model of the hypotheses found".to_owned());
    }
    if !judgement.rests_on.is_empty() {
        parts.push(format!("rests on {}", entry.labels(&judgement.rests_on).join(", ")));
    }
    parts.join("; ")
}

/// The ink of a verdict.
fn style(entry: &Entry<'_>) -> Style {
    let colour = |colour: AnsiColor| Style::new().fg_color(Some(colour.into()));
    match entry.judgement.verdict {
        _ if !entry.judgement.as_expected() => alarm(),
        Verdict::Defined | Verdict::Assumed => Style::new().dimmed(),
        Verdict::Proved => colour(AnsiColor::Green),
        _ => colour(AnsiColor::Yellow),
    }
}

/// The ink of what should not be.
fn alarm() -> Style {
    Style::new().bold().fg_color(Some(AnsiColor::Red.into()))
}
