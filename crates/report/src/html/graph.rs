//! The graph of the derivation as a picture in the page.
//!
//! Two marks tell the two states apart: the border says what the author expects, the filling and the sign how the
//! statement fares. A proved claim rests on proved claims alone: one that cites another is unsupported.

use std::fmt::Write as _;

use kane_audit::{Body, Verdict};
use maud::{Markup, PreEscaped, html};
use unicode_width::UnicodeWidthStr as _;

use super::overview::{self, Section, overview};
use super::{Page, verdict_class};
use crate::layers::{Layout, Measures, Node, Place, layout};
use crate::outline::headings;
use crate::reach::Reach;
use crate::report::Entry;
use crate::shorten::shorten;
use crate::wording::mark;

const MEASURES: Measures = Measures { row: 28, gap: 44, head: 36, foot: 12, margin: 12, rows: 12 };
/// Height of a node, width of a letter in the fixed font, and what a node needs beside letters.
const HEIGHT: u32 = 20;
const LETTER: u32 = 7;
const PADDING: u32 = 14;
/// The widest and the highest graph that can be read on a page of A4, whose 672 pixels it fills.
const PAPER: (u32, u32) = (1000, 1300);

/// The graph with its legend, in a section of its own.
pub(super) fn graph(page: &Page<'_>) -> Markup {
    let shown: Vec<(usize, Entry<'_>)> = page
        .report
        .shown
        .iter()
        .filter_map(|&index| Some((index, page.entry(index)?)))
        .filter(|(_, entry)| !matches!(entry.statement.body, Body::Let(_) | Body::Defined(_)))
        .collect();
    let headings = headings(&page.report.audit.document.text);
    let sections: Vec<_> = headings.iter().filter(|heading| heading.level == 2).collect();
    let nodes: Vec<Node> = shown
        .iter()
        .map(|(index, entry)| {
            let start = page.start(*index);
            let cites = entry.premises();
            let letters = 2 + entry.statement.label.width();
            Node {
                // statements above the first section have a band of their own
                band: sections.iter().filter(|section| section.start < start).count(),
                width: PADDING + LETTER * u32::try_from(letters).unwrap_or(u32::MAX / LETTER / 2),
                cites: cites
                    .iter()
                    .filter_map(|cited| shown.binary_search_by_key(cited, |(i, _)| *i).ok())
                    .collect(),
            }
        })
        .collect();
    let reach = Reach::of(nodes.iter().map(|node| node.cites.as_slice()));
    let weights = reach.weights();
    let heaviest = weights.iter().copied().max().unwrap_or(0).max(1);
    let layout = layout(&nodes, sections.len() + 1, &MEASURES);
    let height = layout.tops.last().copied().unwrap_or(0);
    let titles: Vec<&str> = std::iter::once("Before the first section")
        .chain(sections.iter().map(|section| section.title.as_str()))
        .collect();
    let listed = listed(&titles, &nodes, &shown);
    let width = layout.width.max(widest(&listed));
    let between: Vec<(usize, usize)> = nodes
        .iter()
        .flat_map(|node| {
            node.cites.iter().filter_map(|&cited| Some((nodes.get(cited)?.band, node.band)))
        })
        .collect();
    html! {
        section.graph aria-labelledby="graph" {
            h2 id="graph" { "Graph of the derivation" }
            p {
                "A line leads from a premise to a claim that cites it; within a section it leads to the right. "
                "A citation that others imply has no line. "
                "The longer the bar below a node, the more statements rest on it. "
                "Lines between sections are faint; where scripts run, they show for the node that is pointed at. "
                "A node leads to its statement."
            }
            (legend())
            @if listed.len() > 1 {
                p {
                    "Each section at a glance, a cell for each statement, leads to its place in the graph; an arc joins two "
                    "sections of which the lower one cites the upper, the thicker the more often."
                }
                (overview(&listed, &between))
            }
            p.zoom hidden {
                button type="button" data-zoom="0.8" { "Smaller" } " "
                button type="button" data-zoom="1.25" { "Larger" } " "
                button type="button" data-zoom="0" { "Whole" }
            }
            @let on_paper = width <= PAPER.0 && height <= PAPER.1;
            @if !on_paper { p.paper { "The graph itself is too large for this paper; the page has it on a screen." } }
            div.scroll.large[!on_paper] tabindex="0" role="region" aria-label="The graph, which scrolls" {
                svg width=(width) height=(height) viewBox=(format!("0 0 {width} {height}"))
                    role="group" aria-label="Statements and what they cite" {
                    (bands(&titles, &layout, width))
                    (PreEscaped(lines(&nodes, &reach, &layout)))
                    @for ((index, entry), (number, place)) in
                        shown.iter().zip(layout.places.iter().enumerate())
                    {
                        (node(page, *index, entry, *place, (weights[number], heaviest)))
                    }
                }
            }
        }
    }
}

/// What borders, fillings and signs mean.
fn legend() -> Markup {
    let swatch = |class: &str| {
        html! {
            svg.swatch width="26" height="16" aria-hidden="true" {
                g class=(class) { rect x="2" y="2" width="22" height="12" rx="3" {} }
            }
        }
    };
    let fillings = [
        Verdict::Proved,
        Verdict::Refuted,
        Verdict::IllDefined,
        Verdict::Vacuous,
        Verdict::Unsupported,
        Verdict::Undecided,
    ];
    html! {
        ul.legend {
            li { (swatch("n given ground")) " " (mark(Verdict::Assumed)) " premise" }
            @for verdict in fillings {
                li {
                    (swatch(&format!("n {}", verdict_class(verdict)))) " " (mark(verdict)) " " (verdict)
                    @if verdict == Verdict::Proved { ", with all that it cites" }
                    @if verdict == Verdict::Unsupported { ": cites what is not proved" }
                }
            }
            li { (swatch("n")) " border: expected to be proved" }
            li { (swatch("n other")) " expected to end otherwise" }
            li { (swatch("n surprise")) " not as expected" }
        }
    }
}

/// The sections that have nodes, with the verdicts of these.
fn listed<'t>(
    titles: &[&'t str],
    nodes: &[Node],
    shown: &[(usize, Entry<'_>)],
) -> Vec<Section<'t>> {
    let section = |(band, title): (usize, &&'t str)| {
        let inside = nodes.iter().zip(shown).filter(|(node, _)| node.band == band);
        let verdicts = inside.map(|(_, (_, entry))| entry.judgement.verdict).collect();
        Section { band, title, verdicts }
    };
    let all = titles.iter().enumerate().map(section);
    all.filter(|section| !section.verdicts.is_empty()).collect()
}

/// What the titles of sections need, which may be wider than a graph of few nodes.
fn widest(sections: &[Section<'_>]) -> u32 {
    let letters = sections.iter().map(|section| section.title.width().min(overview::LETTERS)).max();
    2 * MEASURES.margin + u32::try_from(overview::LETTER * letters.unwrap_or(0)).unwrap_or(0)
}

/// A stripe and a title behind each section.
fn bands(titles: &[&str], layout: &Layout, width: u32) -> Markup {
    let room = width.saturating_sub(2 * MEASURES.margin);
    let letters = usize::try_from(room).unwrap_or(usize::MAX) / overview::LETTER;
    let tops = layout.tops.windows(2);
    let bands =
        titles.iter().zip(tops).enumerate().filter_map(|(band, (title, tops))| match tops {
            [top, next] if next > top => Some((band, title, *top, next - top)),
            _ => None,
        });
    html! {
        @for (number, (band, title, top, height)) in bands.enumerate() {
            rect id={ "band-" (band) } class=(if number % 2 == 0 { "band" } else { "band odd" })
                x="0" y=(top) width="100%" height=(height) {}
            text.title x=(MEASURES.margin) y=(top + 20) { (shorten(title, letters)) }
        }
    }
}

/// One line a citation that others do not imply: curves to the right within a section, downwards between two.
fn lines(nodes: &[Node], reach: &Reach, layout: &Layout) -> String {
    let mut out = String::new();
    for (to, node) in nodes.iter().enumerate() {
        for &from in node.cites.iter().filter(|cited| reach.is_direct(**cited, &node.cites)) {
            let (Some(a), Some(b)) = (layout.places.get(from), layout.places.get(to)) else {
                continue;
            };
            let inside = nodes.get(from).is_some_and(|cited| cited.band == node.band);
            let _ = if inside {
                let (x1, y1) = (a.x + a.width, a.y + HEIGHT / 2);
                let (x2, y2) = (b.x, b.y + HEIGHT / 2);
                let bend = MEASURES.gap / 2;
                let ends = [x1 + bend, y1, x2.saturating_sub(bend), y2, x2, y2];
                write!(
                    out,
                    "<path class=\"e\" data-e=\"{from} {to}\" d=\"{}\"/>",
                    curve((x1, y1), ends)
                )
            } else {
                let (x1, y1) = (a.x + a.width / 2, a.y + HEIGHT);
                let (x2, y2) = (b.x + b.width / 2, b.y);
                let bend = y2.saturating_sub(y1) / 2;
                let ends = [x1, y1 + bend, x2, y2.saturating_sub(bend), x2, y2];
                write!(
                    out,
                    "<path class=\"e far\" data-e=\"{from} {to}\" d=\"{}\"/>",
                    curve((x1, y1), ends)
                )
            };
        }
    }
    out
}

/// A curve from a place, by its two handles and its end, each told from that place.
fn curve((x, y): (u32, u32), ends: [u32; 6]) -> String {
    let mut d = format!("M{x} {y}c");
    for (number, end) in ends.into_iter().enumerate() {
        let from = if number % 2 == 0 { x } else { y };
        let sign = if end < from { "-" } else { " " };
        d.push_str(if number == 0 { sign.trim() } else { sign });
        let _ = write!(d, "{}", end.abs_diff(from));
    }
    d
}

/// A statement, and a bar for how many of the others rest on it.
fn node(
    page: &Page<'_>,
    index: usize,
    entry: &Entry<'_>,
    place: Place,
    (weight, heaviest): (usize, usize),
) -> Markup {
    let judgement = entry.judgement;
    let verdict = judgement.verdict;
    let mut class = format!("n {} {}", entry.kind(), verdict_class(verdict));
    if entry.is_claim() && judgement.expect.is_some_and(|expected| expected != Verdict::Proved) {
        class.push_str(" other");
    }
    if !judgement.as_expected() {
        class.push_str(" surprise");
    }
    let label = &entry.statement.label;
    let mut told = format!("{label}, {}, {verdict}", entry.kind());
    if let Some(remark) = entry.expectation() {
        let _ = write!(told, ", {remark}");
    }
    if weight > 0 {
        let _ = write!(told, ", {weight} rest on it");
    }
    let share = u32::try_from(100 * weight / heaviest).unwrap_or(100);
    let corner = if entry.is_claim() { 9 } else { 0 };
    html! {
        a class=(class) href={ "#" (page.anchors.name(index)) } {
            title { (told) ": " (entry.saying()) }
            rect x=(place.x) y=(place.y) width=(place.width) height=(HEIGHT) rx=(corner) {}
            @if share > 0 {
                rect.w x=(place.x) y=(place.y + HEIGHT + 1) width=(place.width * share / 100) height="3" {}
            }
            text x=(place.x + 7) y=(place.y + 14) { (mark(verdict)) " " (label) }
        }
    }
}
