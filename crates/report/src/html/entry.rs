//! One statement: what it says, the note in the margin, and its proof or witness folded away.

use kane_audit::{LinkJudgement, Verdict};
use maud::{Markup, PreEscaped, html};
use pulldown_latex::config::DisplayMode;

use super::math::math;
use super::{Page, marked, verdict_class};
use crate::judges;
use crate::report::Entry;
use crate::wording::{evidence, mark};
use crate::words::{Form, Line, equations, example};

/// Places where a statement is used that its note names at once.
const MOST_USED: usize = 10;

impl Page<'_> {
    /// The statement, under a heading of this level.
    pub(super) fn statement(&self, index: usize, entry: &Entry<'_>, level: u8) -> Markup {
        let judgement = entry.judgement;
        let anchor = self.anchors.name(index);
        let class = verdict_class(judgement.verdict);
        let surprise = if judgement.as_expected() { "" } else { " surprise" };
        let kind = entry.kind();
        html! {
            article class={ "s " (kind) " " (class) (surprise) } id=(anchor) data-v=(class)
                data-o=[self.has_equations.then(|| entry.origin().name())] {
                div.say {
                    @let label = html! {
                        a href={ "#" (anchor) } { (entry.statement.label) }
                        span.quiet { ", " (kind) ", " (judgement.verdict) }
                    };
                    @match level {
                        ..=3 => h3.label { (label) },
                        4 => h4.label { (label) },
                        5 => h5.label { (label) },
                        _ => h6.label { (label) },
                    }
                    div.formula { (self.formula(entry)) (self.cites(entry)) }
                }
                div.note { (self.note(index, entry)) }
                @if entry.is_claim() { (self.evidence(entry)) }
            }
        }
    }

    /// What it says, as a formula or in words.
    fn formula(&self, entry: &Entry<'_>) -> Markup {
        let set = |(said, when): &(String, Option<String>)| {
            html! {
                div.said {
                    (math(said, DisplayMode::Block))
                    @if let Some(when) = when {
                        span.when { "when " (math(when, DisplayMode::Block)) }
                    }
                }
            }
        };
        if let Some(said) = entry.said() {
            return html! {
                (set(&said))
                @if let Some(judged) = entry.judged(&said) {
                    details.more { summary { "written out" } (set(&judged)) }
                }
            };
        }
        match entry.denied() {
            Some(denied) => html! {
                p { (self.anchors.link(denied)) " does not follow" }
                @if let Some(latex) = self.entry(denied).and_then(|denied| denied.formula()) {
                    (math(&latex, DisplayMode::Block))
                }
            },
            // what is set in no other way is shown as it is written
            None if !entry.is_contradiction() => html! { p { code { (entry.saying()) } } },
            None => html! { p { "The premises contradict each other" } },
        }
    }

    /// What the author cites for it.
    fn cites(&self, entry: &Entry<'_>) -> Markup {
        let from = entry.claim().map_or(&[][..], |claim| &claim.from);
        html! { @if !from.is_empty() { p.cites { "from " (self.anchors.links(from)) } } }
    }

    /// The note in the margin.
    fn note(&self, index: usize, entry: &Entry<'_>) -> Markup {
        let judgement = entry.judgement;
        let dependents = self.dependents.get(index).map_or(&[][..], Vec::as_slice);
        html! {
            p {
                (marked(judgement.verdict))
                @if let Some(remark) = entry.expectation() { span.remark { " · " (remark) } }
            }
            @if let Some(support) = entry.support() { p { (support) } }
            @if let Some(reason) = entry.decisive_reason(Form::Html) {
                p.reason { (PreEscaped(reason)) }
            }
            @if judgement.verdict == Verdict::Proved && judgement.met.is_none() {
                p { "No model of its hypotheses was found." }
            }
            @if entry.is_claim() { (self.judges(index, judgement.links.len())) }
            (self.used(dependents))
        }
    }

    /// Where it is used; of many places some, and the others folded away.
    fn used(&self, dependents: &[usize]) -> Markup {
        let shown = if dependents.len() > MOST_USED + 2 { MOST_USED } else { dependents.len() };
        let (first, others) = dependents.split_at(shown);
        html! {
            @if !first.is_empty() {
                div.used {
                    "used in " (self.anchors.links(first))
                    @if !others.is_empty() {
                        details.more {
                            summary { "and in " (others.len()) " more" }
                            (self.anchors.links(others))
                        }
                    }
                }
            }
        }
    }

    /// What other judges answer to the claim, each with a sign.
    fn judges(&self, index: usize, links: usize) -> Markup {
        html! {
            @for judge in self.report.judges {
                @let said = judges::on(judge, index, links);
                @let disagrees = judge.disagrees_on(index);
                @let sign = if disagrees { mark(Verdict::Refuted) }
                    else if said == "agrees" { mark(Verdict::Proved) }
                    else { mark(Verdict::Undecided) };
                p.judge.surprise[disagrees] {
                    span.mark aria-hidden="true" { (sign) } " " (judge.name) ": " (said)
                }
            }
        }
    }

    /// The proof or witness of every link, and what it rests on.
    fn evidence(&self, entry: &Entry<'_>) -> Markup {
        let judgement = entry.judgement;
        let several = judgement.links.len() > 1;
        html! {
            details {
                summary {
                    (evidence(judgement.verdict))
                    span.quiet { " of " (entry.statement.label) }
                }
                @for (number, link) in judgement.links.iter().enumerate() {
                    (self.link(entry, (number, link), several))
                }
                @if !judgement.rests_on.is_empty() {
                    p { "Rests on " (self.anchors.links(&judgement.rests_on)) "." }
                }
                @if let Some(example) = example(judgement, Form::Html).filter(|e| !e.is_empty()) {
                    p {
                        "Its hypotheses hold, for example, at "
                        (PreEscaped(equations(&example, Form::Html))) "."
                    }
                }
                p.source { "Line " (entry.statement.line) ": " code { (entry.source()) } }
            }
        }
    }

    fn link(
        &self,
        entry: &Entry<'_>,
        (number, link): (usize, &LinkJudgement),
        several: bool,
    ) -> Markup {
        html! {
            div.link {
                @if several {
                    (math(&entry.link_latex(number), DisplayMode::Block))
                    p { (marked(link.verdict)) ": " (PreEscaped(entry.reason(link, Form::Html))) }
                }
                (lines(&entry.steps(link, Form::Html)))
                p.check {
                    @if !link.used.is_empty() { "Uses " (self.anchors.links(&link.used)) ". " }
                    @match &link.certificate {
                        Some(digest) => { "The kernel accepted certificate " code { (digest) } },
                        None => "No certificate",
                    }
                    "; search steps: " (link.cost) "."
                    @if entry.judgement.verdict == Verdict::Unsupported {
                        " What it cites is taken as proved here."
                    }
                }
            }
        }
    }
}

/// Lines in HTML as a list, indented by their depth.
pub(crate) fn lines(lines: &[Line]) -> Markup {
    html! {
        @if !lines.is_empty() {
            ol.steps {
                @for Line { depth, text, folded } in lines {
                    li class={ "d" (depth.min(&9)) } {
                        @if *folded {
                            @let (name, told) = text.split_once(": ").unwrap_or(("", text));
                            details.long {
                                summary { "where " (PreEscaped(name)) " is" }
                                (PreEscaped(told))
                            }
                        } @else { (PreEscaped(text)) }
                    }
                }
            }
        }
    }
}
