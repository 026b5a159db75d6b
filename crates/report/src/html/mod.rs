//! The report as a page: the document with notes in its margin.

mod anchors;
mod declarations;
mod entry;
mod findings;
mod frame;
mod graph;
mod math;
mod overview;
mod prose;
pub(crate) mod shared;
mod thrift;

use std::ops::Range;

use kane_audit::Verdict;
use maud::{Markup, PreEscaped, html};

use crate::judges;
use crate::origin::Origin;
use crate::report::Entry;
use crate::{Picture, Report, Summary};
use anchors::Anchors;
use declarations::{declaration_around, declarations};
pub(crate) use entry::lines;
pub(crate) use frame::Frame;
use prose::Part;
pub(crate) use prose::{Part as Passage, parts as passages};
pub(crate) use thrift::shortened;

/// The report as one HTML file, which loads nothing: the document's words, and beside each statement its verdict.
///
/// It can be read without scripts; with them, statements can be filtered by verdict, and the graph shows what a
/// statement rests on. Equal reports give equal bytes.
#[must_use]
pub fn html(report: &Report<'_>) -> String {
    let document = &report.audit.document;
    let page = Page::of(report);
    let parts = prose::parts(&document.text, &|label| page.anchors.find(label));
    let mut contents: Vec<(String, Markup)> = Vec::new();
    let findings = page.findings();
    if findings.is_some() {
        contents.push(("findings".to_owned(), html! { "Findings" }));
    }
    let body = page.body(&parts, &mut contents);
    if !report.pictures.is_empty() {
        contents.push(("figures".to_owned(), html! { "Figures" }));
    }
    contents.push(("graph".to_owned(), html! { "Graph of the derivation" }));
    let content = html! {
        @if let Some(findings) = findings { (findings) }
        (page.filter())
        (body)
        (pictures(report.pictures))
        (graph::graph(&page))
    };
    Frame {
        title: document.title.as_deref().unwrap_or(&document.name),
        kind: "Audit",
        place: &report.place,
        news: page.news(),
        contents,
        styles: &[shared::VERDICTS, shared::AUDIT],
        script: Some(shared::AUDIT_SCRIPT),
        provenance: vec![
            ("Program", html! { "kane " (env!("CARGO_PKG_VERSION")) }),
            ("Document", html! { (document.name) ", " (document.text.len()) " bytes" }),
            ("SHA-256 of the document", html! { code { (document.sha256()) } }),
            ("Command", html! { code { (report.command) } }),
            ("Seed", html! { "none: nothing here is drawn at random" }),
        ],
    }
    .page(&content)
}

/// Where the statement with this label is in the page of a report, if it is shown.
pub(crate) fn anchor(report: &Report<'_>, label: &str) -> Option<String> {
    Anchors::of(&report.audit.document.statements, &report.shown).find(label)
}

/// What all parts of the page look up.
struct Page<'a> {
    report: &'a Report<'a>,
    anchors: Anchors<'a>,
    /// by statement, the statements shown that name it
    dependents: Vec<Vec<usize>>,
    /// whether a text with numbered equations is under audit, so that statements have origins
    has_equations: bool,
}

impl<'a> Page<'a> {
    fn of(report: &'a Report<'a>) -> Self {
        let document = &report.audit.document;
        let mut dependents = vec![Vec::new(); document.statements.len()];
        for (&index, entry) in report.shown.iter().zip(report.entries()) {
            for premise in entry.premises() {
                if let Some(dependents) = dependents.get_mut(premise) {
                    dependents.push(index);
                }
            }
        }
        let has_equations = report.entries().any(|entry| entry.is_equation());
        let anchors = Anchors::of(&document.statements, &report.shown);
        Self { report, anchors, dependents, has_equations }
    }

    fn entry(&self, index: usize) -> Option<Entry<'a>> {
        Entry::new(self.report.audit, index)
    }

    /// The counts, and what a reader should look at first.
    fn news(&self) -> Markup {
        let summary = Summary::of(self.report);
        let labels = |labels: &[String]| {
            html! {
                @for (number, label) in labels.iter().enumerate() {
                    @if number > 0 { ", " }
                    @match self.anchors.find(label) {
                        Some(anchor) => a href={ "#" (anchor) } { (label) },
                        None => (label),
                    }
                }
            }
        };
        html! {
            p.counts { (summary.counts()) }
            @if !summary.refuted_as_printed.is_empty() {
                p { "Refuted as printed: " (labels(&summary.refuted_as_printed)) }
            }
            @for judge in self.report.judges {
                p.judge.surprise[!judge.agrees() || !judge.asked] { (judges::headline(judge)) }
            }
            @if summary.surprises.is_empty() {
                p { (crate::markdown::capitalised(&summary.expectation())) "." }
            } @else {
                @for (what, those) in summary.groups() {
                    p.surprise { (what) ": " (labels(&those)) }
                }
            }
        }
    }

    /// Which statements are shown; without scripts it stays hidden, and all of them are.
    fn filter(&self) -> Markup {
        let summary = Summary::of(self.report);
        let ground = self.report.entries().filter(|entry| !entry.is_claim()).count();
        html! {
            form.filter hidden aria-label="Show" {
                fieldset {
                    legend { "Show" }
                    @for (verdict, count) in &summary.verdicts {
                        (choice("v", verdict_class(*verdict), html! {
                            (marked(*verdict)) " " span.count { (count) }
                        }))
                    }
                    (choice("v", "ground", html! { "premises and definitions " span.count { (ground) } }))
                    (choice("v", "words", html! { "words" }))
                }
                @if self.has_equations {
                    fieldset {
                        legend { "From" }
                        @for origin in Origin::ALL {
                            @let of = |entry: &Entry<'_>| entry.origin() == origin;
                            (choice("o", origin.name(), html! {
                                (origin.told()) " " span.count { (self.report.entries().filter(of).count()) }
                            }))
                        }
                    }
                }
                output aria-live="polite" {}
                button type="button" { "Open all proofs" }
            }
        }
    }

    /// The document: its words, and the statements where they stand in it.
    fn body(&self, parts: &[Part], contents: &mut Vec<(String, Markup)>) -> Markup {
        let mut level = 1;
        let mut shown = self.report.shown.iter().copied().peekable();
        let whole = self.report.shown.len() == self.report.audit.document.statements.len();
        let mut pieces = Vec::new();
        for part in parts {
            match part {
                // around some of the statements alone, the words would seem to belong to them
                Part::Heading { .. } | Part::Prose(_) if !whole => {}
                Part::Heading { level: found, start, words } => {
                    level = *found;
                    let anchor = format!("at-{start}");
                    pieces.push(heading(level, &anchor, words));
                    if level == 2 {
                        contents.push((anchor, words.clone()));
                    }
                }
                Part::Prose(words) => pieces.push(html! { div.words data-v="words" { (words) } }),
                Part::Statements(range) => {
                    let mut inside = Vec::new();
                    while let Some(index) = shown.next_if(|&index| self.start(index) < range.end) {
                        inside.push(index);
                    }
                    pieces.push(self.block(range, &inside, level, whole));
                }
            }
        }
        // a reading of the Markdown that differs from the auditor's must not lose a statement
        let rest: Vec<usize> = shown.collect();
        html! {
            @for piece in &pieces { (piece) }
            @if !rest.is_empty() { (self.block(&(0..0), &rest, level, false)) }
        }
    }

    fn start(&self, index: usize) -> usize {
        self.report.audit.document.statements.get(index).map_or(usize::MAX, |s| s.span.start)
    }

    /// A block of statements; between them, if all of them are shown, the declarations.
    fn block(&self, range: &Range<usize>, inside: &[usize], level: u8, whole: bool) -> Markup {
        let document = &self.report.audit.document;
        // declarations stand on lines of their own, after the one that opens the block or has a statement
        let mut from = document.text[range.clone()]
            .find('\n')
            .map_or(range.end, |first| range.start + first + 1);
        let mut pieces = Vec::new();
        for &index in inside {
            let Some(entry) = self.entry(index) else { continue };
            let span = &entry.statement.span;
            if whole && !range.is_empty() {
                // what a declaration brings along stands behind its whole line
                let line = declaration_around(&document.text, span.start);
                let (until, next) = match line {
                    Some(line) => (line.end, line.end),
                    None => {
                        let end = document.text[span.end..].find('\n').unwrap_or(0);
                        (span.start, span.end + end)
                    }
                };
                pieces.extend(document.text.get(from..until).and_then(declarations));
                from = next.max(from);
            }
            pieces.push(self.statement(index, &entry, level + 1));
        }
        if whole && !range.is_empty() {
            pieces.extend(document.text.get(from..range.end).and_then(declarations));
        }
        html! {
            @if !pieces.is_empty() {
                div.block { @for piece in &pieces { (piece) } }
            }
        }
    }
}

/// The pictures, each as it is: it has a dark version of its own.
fn pictures(pictures: &[Picture]) -> Markup {
    html! {
        @if !pictures.is_empty() {
            h2 #figures { "Figures" }
            @for Picture { title, svg } in pictures {
                figure.picture aria-label=(title) tabindex="0" { (PreEscaped(svg)) }
            }
        }
    }
}

fn heading(level: u8, anchor: &str, words: &Markup) -> Markup {
    html! {
        @match level {
            2 => h2 id=(anchor) { (words) },
            3 => h3 id=(anchor) { (words) },
            4 => h4 id=(anchor) { (words) },
            _ => h5 id=(anchor) { (words) },
        }
    }
}

/// A box of the filter by verdict, `v`, or by origin, `o`.
fn choice(of: &str, value: &str, words: Markup) -> Markup {
    html! {
        label { input type="checkbox" name=(of) value=(value) checked; " " (words) }
    }
}

/// The verdict; the style puts its mark before it.
fn marked(verdict: Verdict) -> Markup {
    html! {
        @let defined = if verdict == Verdict::Defined { " defined" } else { "" };
        span class={ "verdict " (verdict_class(verdict)) (defined) } { (verdict) }
    }
}

/// The verdict as a class; premises and definitions share one.
const fn verdict_class(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Defined | Verdict::Assumed => "ground",
        Verdict::Proved => "proved",
        Verdict::Undecided => "undecided",
        Verdict::Refuted => "refuted",
        Verdict::IllDefined => "ill-defined",
        Verdict::Vacuous => "vacuous",
        Verdict::Unsupported => "unsupported",
    }
}
