//! The sections of a derivation at a glance: how their statements fare, and which section cites which.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use kane_audit::Verdict;
use maud::{Markup, PreEscaped, html};
use unicode_width::UnicodeWidthStr as _;

use super::verdict_class;
use crate::shorten::shorten;

/// A section: its title, and the verdicts of its statements in their order.
pub(super) struct Section<'t> {
    /// its place in the graph below
    pub(super) band: usize,
    pub(super) title: &'t str,
    pub(super) verdicts: Vec<Verdict>,
}

/// Height of a row; width of a letter of a title, and of the cell of a statement.
const ROW: usize = 24;
pub(super) const LETTER: usize = 7;
const CELL: usize = 8;
/// The most columns of a title.
pub(super) const LETTERS: usize = 60;
/// The farthest that an arc reaches to the right.
const REACH: usize = 150;

/// A row a section with a cell for each statement, and arcs from sections to those that cite them; `citations` holds
/// the bands of what is cited and of what cites it, one a citation.
pub(super) fn overview(sections: &[Section<'_>], citations: &[(usize, usize)]) -> Markup {
    let rows: BTreeMap<usize, usize> =
        sections.iter().enumerate().map(|(row, section)| (section.band, row)).collect();
    let mut between: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for (from, to) in citations {
        if let (Some(from), Some(to)) = (rows.get(from), rows.get(to))
            && from != to
        {
            *between.entry((*from, *to)).or_default() += 1;
        }
    }
    let cells = sections.iter().map(|section| section.verdicts.len()).max().unwrap_or(0);
    let letters = sections.iter().map(|section| section.title.width().min(LETTERS)).max();
    let titles = LETTER * letters.unwrap_or(0) + 20;
    let right = titles + CELL * cells + 6;
    let (width, height) = (right + REACH + 12, ROW * sections.len() + 4);
    html! {
        div.drawn.overview tabindex="0" role="group" aria-label="Sections of the graph" {
            svg viewBox=(format!("0 0 {width} {height}")) width=(width) {
                (PreEscaped(arcs(&between, sections, right)))
                @for (row, section) in sections.iter().enumerate() {
                    @let y = ROW * row + 4;
                    a href={ "#band-" (section.band) } aria-label={ (section.title) ": " (counted(&section.verdicts)) } {
                        title { (section.title) ": " (counted(&section.verdicts)) }
                        text.title x="0" y=(y + 13) { (shorten(section.title, LETTERS)) }
                        @for (cell, verdict) in section.verdicts.iter().enumerate() {
                            rect class=(verdict_class(*verdict)) x=(titles + CELL * cell) y=(y)
                                width=(CELL - 2) height=(ROW - 8) {}
                        }
                    }
                }
            }
        }
    }
}

/// How many statements end how: `3 proved, 1 refuted`.
fn counted(verdicts: &[Verdict]) -> String {
    let mut counts: Vec<(Verdict, usize)> = Vec::new();
    for verdict in verdicts {
        match counts.iter_mut().find(|(known, _)| known == verdict) {
            Some((_, count)) => *count += 1,
            None => counts.push((*verdict, 1)),
        }
    }
    counts
        .iter()
        .map(|(verdict, count)| format!("{count} {verdict}"))
        .collect::<Vec<_>>()
        .join(", ")
}

/// One arc for each pair of sections of which one cites the other, the thicker the more citations it stands for.
fn arcs(
    between: &BTreeMap<(usize, usize), usize>,
    sections: &[Section<'_>],
    right: usize,
) -> String {
    let mut out = String::new();
    let farthest = between.keys().map(|(from, to)| to.abs_diff(*from)).max().unwrap_or(1).max(1);
    for ((from, to), count) in between {
        let [y1, y2] = [from, to].map(|row| ROW * row + ROW / 2);
        let x = right + 30 + REACH * to.abs_diff(*from) / farthest;
        // the square root of the count, in tenths of a pixel
        let width = (count * 100).isqrt();
        let [cited, cites] = [from, to].map(|row| sections.get(*row).map_or("", |s| s.title));
        let times = if *count == 1 { "once".to_owned() } else { format!("{count} times") };
        let told = html! { title { (cites) " cites " (cited) " " (times) } }.into_string();
        let _ = write!(
            out,
            "<path class=\"a\" stroke-width=\"{}.{}\" d=\"M{right} {y1}C{x} {y1} {x} {y2} {right} {y2}\">{told}</path>",
            width / 10,
            width % 10
        );
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sections_are_joined_once_and_a_section_not_with_itself() {
        let section = |band, title| Section {
            band,
            title,
            verdicts: vec![Verdict::Proved, Verdict::Refuted, Verdict::Proved],
        };
        let sections = [section(1, "Model"), section(3, "Energy <b>")];
        let shown = overview(&sections, &[(1, 3), (1, 3), (3, 3), (1, 1), (7, 3)]).into_string();
        assert_eq!(shown.matches("class=\"a\"").count(), 1, "{shown}");
        assert!(shown.contains("Energy &lt;b&gt; cites Model 2 times"), "{shown}");
        assert!(shown.contains("Model: 2 proved, 1 refuted"), "{shown}");
        assert_eq!(shown.matches("<rect").count(), 6);
    }
}
