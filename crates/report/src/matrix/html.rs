//! The matrix as a page: the table, and below it every law, every cell in full, and what each property asks.

use std::collections::BTreeMap;

use kane_matrix::{Cell, Finding, Part, Property, Row, SYMBOLS_IN_WORDS};
use maud::{Markup, PreEscaped, html};

use super::explain::Telling;
use super::{FINDINGS, MatrixReport, parameters, word};
use crate::html::{Frame, Passage, lines, passages, shared};
use crate::place::{Link, Place};
use crate::words::{Form, Line};

/// The matrix as one HTML file, which loads nothing. `laws` is the page of the laws, `docs/laws.md`, which tells
/// the formula and the source of each. Equal matrices give equal bytes.
///
/// It can be read without scripts; with them, cells can be filtered by finding.
#[must_use]
pub fn html(report: &MatrixReport<'_>, laws: &str) -> String {
    html_in_site(report, laws, &Place::default(), &[])
}

/// The same page with links to what is beside it, and from each law of this id to where it is derived.
#[must_use]
pub fn html_in_site(
    report: &MatrixReport<'_>,
    laws: &str,
    place: &Place,
    derived: &[(&str, Link)],
) -> String {
    let matrix = report.matrix;
    let told = Told::of(laws);
    let telling = Telling::new(Form::Html);
    let mut contents =
        vec![("matrix", html! { "The matrix" }), ("properties", html! { "What is asked" })];
    contents.extend(matrix.rows.iter().map(|row| (row.law.info.id, html! { (row.law.info.id) })));
    let mut known = Known::new();
    let found: Vec<Markup> = matrix
        .rows
        .iter()
        .map(|row| law(&telling, &matrix.properties, row, (&told, derived), &mut known))
        .collect();
    let content = html! {
        (filter(report))
        (table(report))
        h2 #properties { "What is asked" }
        dl.asked { @for property in &matrix.properties { (question(&telling, property)) } }
        h2 #laws { "What is found" }
        p.words {
            "Each law with its formula and its source, and each of its cells with the proof or the contact that \
             speaks against it. "
            code { "kane laws --explain LAW:PROPERTY" } " prints a cell in full."
        }
        p.words { (PreEscaped(telling.sentence(SYMBOLS_IN_WORDS))) }
        @for law in &found { (law) }
    };
    Frame {
        title: "Laws and properties",
        kind: "Matrix",
        place,
        news: html! { p.counts { (report.headline()) } },
        contents: contents.into_iter().map(|(id, words)| (id.to_owned(), words)).collect(),
        styles: &[shared::VERDICTS, shared::MATRIX],
        script: Some(shared::MATRIX_SCRIPT),
        provenance: vec![
            ("Program", html! { "kane " (env!("CARGO_PKG_VERSION")) }),
            ("Command", html! { code { (report.command) } }),
            ("Seed", html! { "none: nothing here is drawn at random" }),
        ],
    }
    .page(&content)
}

/// Which findings are shown; without scripts it stays hidden, and all of them are.
fn filter(report: &MatrixReport<'_>) -> Markup {
    html! {
        form.filter hidden aria-label="Show" {
            fieldset {
                legend { "Show" }
                @for finding in FINDINGS {
                    label {
                        input type="checkbox" name="v" value=(class(finding)) checked;
                        " " (marked(finding)) " " span.count { (report.matrix.count(finding)) }
                    }
                }
            }
            output aria-live="polite" {}
        }
    }
}

fn table(report: &MatrixReport<'_>) -> Markup {
    let matrix = report.matrix;
    html! {
        div.scroll #matrix tabindex="0" role="region" aria-label="The matrix" {
            table {
                caption.quiet { "Findings, a law a row and a property a column" }
                thead { tr {
                    th scope="col" { "law" }
                    @for p in &matrix.properties {
                        th scope="col" { a href={ "#" (p.id) } title=(p.template) { (p.name) } }
                    }
                } }
                tbody { @for row in &matrix.rows { tr {
                    th scope="row" { a href={ "#" (row.law.info.id) } { (row.law.info.id) } }
                    @for (p, cell) in matrix.properties.iter().zip(&row.cells) {
                        td class=(class(cell.finding)) {
                            a href={ "#" (row.law.info.id) ":" (p.id) } title={ (row.law.info.id) ", " (p.name) } {
                                span aria-hidden="true" { (mark(cell.finding)) }
                                span.quiet { (word(cell.finding)) }
                            }
                        }
                    }
                } } }
            }
        }
        ul.key { @for finding in FINDINGS { li { (marked(finding)) } } }
    }
}

fn question(telling: &Telling, property: &Property) -> Markup {
    let (domain, meaning) = (telling.sentence(property.domain), telling.sentence(property.meaning));
    html! {
        div id=(property.id) {
            dt { (property.name) " " code { (property.id) } }
            dd {
                p.template { (PreEscaped(telling.formula(property.template))) }
                p { "For " (PreEscaped(domain)) ". " (PreEscaped(meaning)) }
            }
        }
    }
}

fn law(
    telling: &Telling,
    properties: &[&'static Property],
    row: &Row,
    (told, derived): (&Told, &[(&str, Link)]),
    known: &mut Known,
) -> Markup {
    let with = parameters(row);
    let derived: Vec<&Link> =
        derived.iter().filter(|(id, _)| *id == row.law.info.id).map(|(_, link)| link).collect();
    let cells: Vec<Markup> = properties
        .iter()
        .zip(&row.cells)
        .map(|(property, cell)| entry(telling, row, property, cell, known))
        .collect();
    html! {
        section aria-labelledby=(row.law.info.id) {
            h3 id=(row.law.info.id) { (row.law.info.id) }
            p { (row.law.info.source) "." }
            @if let Some(caveat) = row.law.info.caveat { p { "Caution: " (caveat) "." } }
            @if !with.is_empty() { p { "Here with " (with) "." } }
            @if !derived.is_empty() {
                p { "Derived: " @for (n, link) in derived.iter().enumerate() {
                    @if n > 0 { ", " } a href=(link.to) { (link.words) }
                } }
            }
            @if let Some(words) = told.law(row.law.info.id) {
                details { summary { "Formula, source and domain" } div.told { (words) } }
            }
            @for cell in &cells { (cell) }
        }
    }
}

/// Lines of a proof that a page shows; a longer one is told in outline. A witness is always whole.
const MOST_LINES: usize = 30;

/// Proofs and witnesses that the page tells, by property and text, with the law at which they stand.
type Known = BTreeMap<(&'static str, String), &'static str>;

/// From so many bytes on, what is told of one law already is not told of another again.
const TOLD_ONCE: usize = 800;

/// A cell. Its anchor is inside of what is folded, so that a link to it unfolds it without scripts.
fn entry(
    telling: &Telling,
    row: &Row,
    property: &Property,
    cell: &Cell,
    known: &mut Known,
) -> Markup {
    let most = if cell.finding == Finding::Proved { MOST_LINES } else { usize::MAX };
    let proof = in_full(telling, &cell.parts, most);
    let is_long = proof.is_none();
    let proof = proof.unwrap_or_else(|| in_outline(telling, &cell.parts));
    let told = html! { (lines(&telling.seen(cell))) (lines(&proof)) };
    let id = row.law.info.id;
    let first = if told.0.len() < TOLD_ONCE {
        id
    } else {
        known.entry((property.id, told.0.clone())).or_insert(id)
    };
    html! {
        details class={ "cell " (class(cell.finding)) } data-v=(class(cell.finding)) {
            summary {
                (marked(cell.finding)) " " (property.name)
                @if cell.finding != Finding::Proved { span.why { (PreEscaped(telling.sentence(&cell.reason))) } }
            }
            div id={ (row.law.info.id) ":" (property.id) } {
                p {
                    a href={ "#" (property.id) } { (PreEscaped(telling.formula(property.template))) }
                    @if cell.finding == Finding::Proved { ": " (PreEscaped(telling.sentence(&cell.reason))) }
                    @if is_long {
                        ", here in outline; " code { "kane laws --explain " (row.law.info.id) ":" (property.id) }
                        " tells every step"
                    }
                }
                @if first == id {
                    (told)
                } @else {
                    p { "Word for word as for " a href={ "#" (first) ":" (property.id) } { (first) } "." }
                }
            }
        }
    }
}

/// All goals; where one has the premises of the one before, they stand there alone. `None` if these are more
/// lines than `most`.
fn in_full(telling: &Telling, parts: &[Part], most: usize) -> Option<Vec<Line>> {
    let mut lines = Vec::new();
    let mut known = Vec::new();
    for part in parts {
        lines.push(telling.asked(part));
        let own = telling.premises(part);
        if own.is_empty() || own != known {
            lines.extend(own.iter().cloned());
        } else {
            lines.push(Line { depth: 1, text: "from the same premises".to_owned(), folded: false });
        }
        known = own;
        lines.extend(telling.decided(part));
        if lines.len() > most {
            return None;
        }
    }
    Some(lines)
}

/// How many goals there are on each family of contacts, in which regimes, and on what grounds they are decided.
fn in_outline(telling: &Telling, parts: &[Part]) -> Vec<Line> {
    let mut lines = Vec::new();
    let mut settings: Vec<&str> = Vec::new();
    for part in parts {
        if !settings.contains(&part.setting) {
            settings.push(part.setting);
        }
    }
    for setting in settings {
        let mut regimes: Vec<&str> = Vec::new();
        let mut grounds: Vec<(String, usize)> = Vec::new();
        for part in parts.iter().filter(|part| part.setting == setting) {
            if !regimes.contains(&part.regime.as_str()) {
                regimes.push(&part.regime);
            }
            let ground = telling.reason(part);
            match grounds.iter_mut().find(|(known, _)| *known == ground) {
                Some((_, count)) => *count += 1,
                None => grounds.push((ground, 1)),
            }
        }
        let regimes = html! { (format!("\"{}\"", regimes.join("\", \""))) }.into_string();
        let text = format!("{}, {regimes}", telling.formula(setting));
        lines.push(Line { depth: 0, text, folded: false });
        lines.extend(grounds.into_iter().map(|(ground, count)| {
            let goals = if count == 1 { "goal" } else { "goals" };
            Line { depth: 1, text: format!("{count} {goals} {ground}"), folded: false }
        }));
    }
    lines
}

/// What the page of the laws tells of each.
struct Told(Vec<(String, Vec<Markup>)>);

impl Told {
    fn of(laws: &str) -> Self {
        let mut told: Vec<(String, Vec<Markup>)> = Vec::new();
        for passage in passages(laws, &|_| None) {
            match passage {
                Passage::Heading { words, .. } => told.push((words.into_string(), Vec::new())),
                Passage::Prose(words) => {
                    if let Some((_, passages)) = told.last_mut() {
                        passages.push(words);
                    }
                }
                Passage::Statements(_) => {}
            }
        }
        Self(told)
    }

    fn law(&self, id: &str) -> Option<Markup> {
        let (_, passages) = self.0.iter().find(|(heading, _)| heading == id)?;
        Some(html! { @for passage in passages { (passage) } })
    }
}

/// The finding; the style puts its sign before it, which means the same without colour.
fn marked(finding: Finding) -> Markup {
    html! {
        span class={ "verdict " (class(finding)) } { (word(finding)) }
    }
}

const fn mark(finding: Finding) -> &'static str {
    match finding {
        Finding::Proved => "✓",
        Finding::Refuted => "✗",
        Finding::NotApplicable => "–",
        Finding::Undecided => "?",
    }
}

const fn class(finding: Finding) -> &'static str {
    match finding {
        Finding::Proved => "proved",
        Finding::Refuted => "refuted",
        Finding::NotApplicable => "ground",
        Finding::Undecided => "undecided",
    }
}
