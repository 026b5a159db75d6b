//! What a reader of the audit should know first: each claim that fails, why, what is proved in its place, and what
//! rests on it.

use std::collections::BTreeSet;

use kane_audit::{Content, Verdict};
use kane_kernel::{Expr, Link, Rel, Relation};
use maud::{Markup, PreEscaped, html};
use pulldown_latex::config::DisplayMode;

use super::math::math;
use super::{Page, marked};
use crate::reach::Reach;
use crate::report::Entry;
use crate::words::Form;

/// Claims that are told of; the others are found by their verdict.
const TOLD: usize = 12;

impl Page<'_> {
    /// The claims that fail, as a list, if one does. Where equations of a text fail as printed, it is they.
    pub(super) fn findings(&self) -> Option<Markup> {
        let failing: Vec<(usize, Entry<'_>)> = self.failing();
        let printed = |entry: &Entry<'_>| entry.is_equation();
        let as_printed = failing.iter().any(|(_, entry)| printed(entry));
        let of_the_text = |(_, entry): &&(usize, Entry<'_>)| !as_printed || printed(entry);
        let told: Vec<_> = failing.iter().filter(of_the_text).take(TOLD).collect();
        if told.is_empty() {
            return None;
        }
        let others = failing.len() - told.len();
        let weights = self.weights();
        Some(html! {
            section.findings aria-labelledby="findings" {
                h2 #findings { "Findings" }
                ol {
                    @for (index, entry) in &told {
                        li { (self.finding(*index, entry, weights.get(*index).copied().unwrap_or(0))) }
                    }
                }
                @if others > 0 {
                    @let fail = if others == 1 { "claim fails" } else { "claims fail" };
                    p.aside { (others) " more " (fail) "; each stands in its place below." }
                }
            }
        })
    }

    /// Claims that are refuted or have no meaning, in the order of the document.
    fn failing(&self) -> Vec<(usize, Entry<'_>)> {
        let shown = self.report.shown.iter().copied();
        let entries = shown.filter_map(|index| Some((index, self.entry(index)?)));
        let fails = |entry: &Entry<'_>| {
            matches!(entry.judgement.verdict, Verdict::Refuted | Verdict::IllDefined)
        };
        entries.filter(|(_, entry)| entry.is_claim() && fails(entry)).collect()
    }

    /// How many statements rest on each.
    fn weights(&self) -> Vec<usize> {
        let count = self.report.audit.document.statements.len();
        let cites = |index| self.entry(index).map(|entry| entry.premises()).unwrap_or_default();
        let cites: Vec<Vec<usize>> = (0..count).map(cites).collect();
        Reach::of(cites.iter().map(Vec::as_slice)).weights()
    }

    fn finding(&self, index: usize, entry: &Entry<'_>, weight: usize) -> Markup {
        let in_its_place = self.in_its_place(index, entry);
        let used = self.dependents.get(index).map_or(&[][..], Vec::as_slice);
        html! {
            p {
                (self.anchors.link(index)) " "
                @if let Some(latex) = entry.formula() { (math(&latex, DisplayMode::Inline)) " " }
                (marked(entry.judgement.verdict))
                @if let Some(reason) = entry.decisive_reason(Form::Html) { ": " (PreEscaped(reason)) }
            }
            @for (number, other) in &in_its_place {
                p.repair {
                    "From the same, proved: " (self.anchors.link(*number)) " "
                    @if let Some(latex) = other.formula() { (math(&latex, DisplayMode::Inline)) }
                }
            }
            @if !used.is_empty() {
                p.aside {
                    "Cited by " (self.anchors.links(used))
                    @if weight > used.len() { "; " (weight) " statements rest on it" }
                }
            }
        }
    }

    /// What is proved of the same left side by the same relation, under the same conditions and from no more.
    fn in_its_place(&self, index: usize, entry: &Entry<'_>) -> Vec<(usize, Entry<'_>)> {
        let Some(fails) = Said::of(entry) else { return Vec::new() };
        let shown = self.report.shown.iter().copied().filter(|other| *other != index);
        let others = shown.filter_map(|other| Some((other, self.entry(other)?)));
        let does = |entry: &Entry<'_>| {
            entry.judgement.verdict == Verdict::Proved
                && Said::of(entry).is_some_and(|said| said.is_in_place_of(&fails))
        };
        others.filter(|(_, other)| does(other)).collect()
    }
}

/// What a claim of one relation says, and from what.
struct Said<'a> {
    lhs: &'a Expr,
    rel: Rel,
    rhs: &'a Expr,
    when: &'a [Relation],
    from: BTreeSet<usize>,
}

impl<'a> Said<'a> {
    fn of(entry: &Entry<'a>) -> Option<Self> {
        let claim = entry.claim()?;
        let Content::Links(links) = &claim.content else { return None };
        let [(Link::Relation(relation), _)] = &links[..] else { return None };
        let from = claim.from.iter().copied().collect();
        Some(Self {
            lhs: &relation.lhs,
            rel: relation.rel,
            rhs: &relation.rhs,
            when: &claim.when,
            from,
        })
    }

    fn is_in_place_of(&self, other: &Self) -> bool {
        (self.lhs, self.rel) == (other.lhs, other.rel)
            && self.rhs != other.rhs
            && self.when == other.when
            && self.from.is_subset(&other.from)
    }
}
