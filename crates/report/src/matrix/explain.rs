//! One cell in full: its template, and every proof or the witness, for a person with paper.

use std::fmt::Write as _;

use kane_algebra::syntax::Notation as _;
use kane_kernel::{Conclusion, Link};
use kane_matrix::{Cell, Part, Property, Row, SYMBOLS_IN_WORDS};

use super::{parameters, word};

/// A line of a proof or a witness, and how far it is indented.
pub(super) type Line = (usize, String);

/// Writes out a cell.
#[must_use]
pub fn explain(row: &Row, property: &Property, cell: &Cell) -> String {
    let mut out = String::new();
    let with = parameters(row);
    let with = if with.is_empty() { with } else { format!(" with {with}") };
    let _ = writeln!(out, "{}:{}: {}", row.law.info.id, property.id, word(cell.finding));
    let _ = writeln!(out, "  {}{with}", row.law.info.source);
    let _ = writeln!(out, "\n{}, for {}:", property.name, property.domain);
    let _ = writeln!(out, "  {}", property.template);
    let _ = writeln!(out, "  {}", property.meaning);
    let _ = writeln!(out, "\n{}: {}", word(cell.finding), cell.reason);
    write_lines(&mut out, seen(cell));
    if !cell.parts.is_empty() {
        let _ = writeln!(out, "\n{SYMBOLS_IN_WORDS}");
    }
    for part in &cell.parts {
        out.push('\n');
        write_lines(&mut out, [asked(part)]);
        write_lines(&mut out, premises(part));
        write_lines(&mut out, decided(part));
    }
    out
}

fn write_lines(out: &mut String, lines: impl IntoIterator<Item = Line>) {
    for (depth, text) in lines {
        let indent = 2 * depth;
        let _ = writeln!(out, "{:indent$}{text}", "");
    }
}

/// The contacts that speak against a cell, and what the law says of them.
pub(super) fn seen(cell: &Cell) -> Vec<Line> {
    let of = |witness: &kane_matrix::Witness| {
        let said = match &witness.outcome {
            None => "the law has no answer".to_owned(),
            Some(said) => {
                let values: Vec<_> =
                    said.values.iter().map(|(name, value)| format!("{name} = {value}")).collect();
                format!("\"{}\": {}", said.regime, values.join(", "))
            }
        };
        [(1, format!("at {}", witness.place())), (2, said)]
    };
    cell.witness.iter().flat_map(of).collect()
}

/// Where a goal is asked, and what in the words of the property.
pub(super) fn asked(part: &Part) -> Line {
    (0, format!("{}, \"{}\": {}", part.setting, part.regime, part.claim))
}

/// What a goal may use.
pub(super) fn premises(part: &Part) -> Vec<Line> {
    let context = &part.goal.context;
    let mut lines = Vec::new();
    for (label, hypothesis) in part.labels.iter().zip(&part.goal.hypotheses) {
        let sentence = &hypothesis.sentence;
        let relations: Vec<_> = sentence.relations().cloned().collect();
        let mut text = relations.plain(context);
        if !sentence.when.is_empty() {
            text = format!("{text} when {}", sentence.when.plain(context));
        }
        lines.push((1, format!("{label}: {text}")));
    }
    if !part.goal.when.is_empty() {
        lines.push((1, format!("when {}", part.goal.when.plain(context))));
    }
    lines
}

/// What a goal says, why it is decided as it is, and by which certificate.
pub(super) fn decided(part: &Part) -> Vec<Line> {
    let mut lines = Vec::new();
    if let Conclusion::Link(Link::Relation(relation)) = &part.goal.conclusion {
        lines.push((1, format!("then {}", relation.plain(&part.goal.context))));
    }
    lines.push((1, part.reason()));
    lines.extend(part.steps().into_iter().map(|step| (2 + step.depth, step.text)));
    lines.push((1, format!("the kernel accepted certificate {}", part.digest())));
    lines
}
