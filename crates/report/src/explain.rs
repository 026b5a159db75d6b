//! One statement in full: the proof or the witness, step by step, for a person with paper.

use std::fmt::Write as _;

use kane_audit::{Audit, LinkJudgement, Verdict};

use crate::report::Entry;
use crate::words::{Form, Line, equations, example};

/// Writes out the statement at `index`; `None` if the audit has no such statement.
#[must_use]
pub fn explain(audit: &Audit, index: usize) -> Option<String> {
    let entry = Entry::new(audit, index)?;
    let judgement = entry.judgement;
    let mut out = String::new();
    let _ = writeln!(out, "{}", entry.source());
    let _ = write!(out, "{}:{}: {}", audit.document.name, entry.statement.line, judgement.verdict);
    for remark in entry.expectation().into_iter().chain(entry.support()) {
        let _ = write!(out, ", {remark}");
    }
    out.push('\n');

    let count = judgement.links.len();
    for (number, link) in judgement.links.iter().enumerate() {
        out.push('\n');
        if count > 1 {
            let _ = write!(out, "link {} of {count}: ", number + 1);
        }
        write_link(&mut out, &entry, (number, link));
    }
    if entry.is_claim() {
        write_ground(&mut out, &entry);
    }
    Some(out)
}

/// The proof or witness of one link.
fn write_link(out: &mut String, entry: &Entry<'_>, (number, link): (usize, &LinkJudgement)) {
    let _ = writeln!(out, "{}", entry.link_text(number));
    let _ = writeln!(out, "  {}: {}", link.verdict, entry.reason(link, Form::Plain));
    for Line { depth, text, .. } in entry.steps(link, Form::Plain) {
        let _ = writeln!(out, "{:indent$}{text}", "", indent = 4 + 2 * depth);
    }
    if !link.used.is_empty() {
        let _ = writeln!(out, "  uses {}", entry.labels(&link.used).join(", "));
    }
    match &link.certificate {
        Some(digest) => {
            _ = writeln!(
                out,
                "  the kernel accepted certificate {digest}; search steps: {}",
                link.cost
            )
        }
        None => _ = writeln!(out, "  no certificate; search steps: {}", link.cost),
    }
}

/// What the whole rests on: the premises, each as written, and one point at which they hold.
fn write_ground(out: &mut String, entry: &Entry<'_>) {
    let judgement = entry.judgement;
    let givens = entry.cited(&judgement.rests_on);
    if !givens.is_empty() {
        out.push_str("\nrests on\n");
        for given in givens {
            let _ = writeln!(out, "  {}", given.source());
        }
    }
    match example(judgement, Form::Plain) {
        Some(example) if example.is_empty() => {}
        Some(example) => {
            let at = equations(&example, Form::Plain);
            let _ = writeln!(out, "\nits hypotheses hold, for example, at {at}");
        }
        None if judgement.verdict == Verdict::Vacuous => {}
        None => out.push_str("\nno point was found at which all its hypotheses hold\n"),
    }
}
