//! One cell in full: its template, and every proof or the witness, for a person with paper.

use std::fmt::Write as _;

use kane_algebra::syntax::Notation as _;
use kane_audit::matrix::{Cell, Part, Property, Row, SYMBOLS_IN_WORDS};
use kane_kernel::{Conclusion, Link};

use super::{parameters, word};

/// Writes out a cell.
#[must_use]
pub fn explain(row: &Row, property: &Property, cell: &Cell) -> String {
    let mut out = String::new();
    let with = parameters(row);
    let with = if with.is_empty() { with } else { format!(" with {with}") };
    let _ = writeln!(out, "{}:{}: {}", row.id, property.id, word(cell.finding));
    let _ = writeln!(out, "  {}{with}", row.source);
    let _ = writeln!(out, "\n{}, for {}:", property.name, property.domain);
    let _ = writeln!(out, "  {}", property.template);
    let _ = writeln!(out, "  {}", property.meaning);
    let _ = writeln!(out, "\n{}: {}", word(cell.finding), cell.reason);
    for witness in &cell.witness {
        let _ = writeln!(out, "  at {}", witness.place());
        match &witness.outcome {
            None => out.push_str("    the law has no answer\n"),
            Some(said) => {
                let values: Vec<_> =
                    said.values.iter().map(|(name, value)| format!("{name} = {value}")).collect();
                let _ = writeln!(out, "    \"{}\": {}", said.regime, values.join(", "));
            }
        }
    }
    if !cell.parts.is_empty() {
        let _ = writeln!(out, "\n{SYMBOLS_IN_WORDS}");
    }
    for part in &cell.parts {
        write_part(&mut out, part);
    }
    out
}

/// One goal: where, from what, and why.
fn write_part(out: &mut String, part: &Part) {
    let _ = writeln!(out, "\n{}, \"{}\": {}", part.setting, part.regime, part.claim);
    let context = &part.goal.context;
    for (label, hypothesis) in part.labels.iter().zip(&part.goal.hypotheses) {
        let sentence = &hypothesis.sentence;
        let relations: Vec<_> = sentence.relations().cloned().collect();
        let mut text = relations.plain(context);
        if !sentence.when.is_empty() {
            text = format!("{text} when {}", sentence.when.plain(context));
        }
        let _ = writeln!(out, "  {label}: {text}");
    }
    if !part.goal.when.is_empty() {
        let _ = writeln!(out, "  when {}", part.goal.when.plain(context));
    }
    if let Conclusion::Link(Link::Relation(relation)) = &part.goal.conclusion {
        let _ = writeln!(out, "  then {}", relation.plain(context));
    }
    let (reason, steps) = part.told();
    let _ = writeln!(out, "  {reason}");
    for step in steps {
        let indent = 4 + 2 * step.depth;
        let _ = writeln!(out, "{:indent$}{}", "", step.text);
    }
    let _ = writeln!(out, "  the kernel accepted certificate {}", part.digest());
}
