//! One cell in full: its template, and every proof or the witness, for a person with paper.

use std::fmt::Write as _;

use kane_kernel::{Conclusion, Link};
use kane_matrix::{Cell, Part, Property, Row, SYMBOLS_IN_WORDS, unmarked};

use super::{parameters, word};
use crate::words::{Form, Formulas, Line, Prose, Subject, words};

/// Writes out a cell.
#[must_use]
pub fn explain(row: &Row, property: &Property, cell: &Cell) -> String {
    let telling = Telling::new(Form::Plain);
    let mut out = String::new();
    // before the source: behind it they would read as part of what it says
    let with = parameters(row);
    let with = if with.is_empty() { with } else { format!(" with {with}") };
    let _ = writeln!(out, "{}{with}:{}: {}", row.law.info.id, property.id, word(cell.finding));
    let _ = writeln!(out, "  {}", row.law.info.source);
    let _ = writeln!(out, "\n{}, for {}:", property.name, unmarked(property.domain));
    let _ = writeln!(out, "  {}", property.template);
    let _ = writeln!(out, "  {}", unmarked(property.meaning));
    let _ = writeln!(out, "\n{}: {}", word(cell.finding), unmarked(&cell.reason));
    write_lines(&mut out, telling.seen(cell));
    if !cell.parts.is_empty() {
        let _ = writeln!(out, "\n{}", unmarked(SYMBOLS_IN_WORDS));
    }
    for part in &cell.parts {
        out.push('\n');
        write_lines(&mut out, [telling.asked(part)]);
        write_lines(&mut out, telling.premises(part));
        write_lines(&mut out, telling.decided(part));
    }
    out
}

fn write_lines(out: &mut String, lines: impl IntoIterator<Item = Line>) {
    for Line { depth, text, .. } in lines {
        let indent = 2 * depth;
        let _ = writeln!(out, "{:indent$}{text}", "");
    }
}

/// What parts and cells are told in.
pub(super) struct Telling {
    form: Form,
    prose: Prose,
}

fn line(depth: usize, text: String) -> Line {
    Line { depth, text, folded: false }
}

impl Telling {
    pub(super) fn new(form: Form) -> Self {
        Self { form, prose: Prose::new(form) }
    }

    /// A sentence of the matrix.
    pub(super) fn sentence(&self, text: &str) -> String {
        self.prose.sentence(text)
    }

    /// A template or what else is a formula, if it is one.
    pub(super) fn formula(&self, text: &str) -> String {
        self.prose.formula(text)
    }

    /// The proof or the witness of a part in one sentence.
    pub(super) fn reason(&self, part: &Part) -> String {
        Subject { goal: &part.goal, labels: &[] }.reason(&part.reason(), self.form)
    }

    /// The contacts that speak against a cell, and what the law says of them.
    pub(super) fn seen(&self, cell: &Cell) -> Vec<Line> {
        let of = |witness: &kane_matrix::Witness| {
            let said = match &witness.outcome {
                None => words("the law has no answer", self.form),
                Some(said) => {
                    let value = |(name, value): &(&str, String)| format!("{name} = {value}");
                    let values: Vec<_> = said.values.iter().map(value).collect();
                    let regime = words(&format!("\"{}\"", said.regime), self.form);
                    format!("{regime}: {}", self.formula(&values.join(", ")))
                }
            };
            let place = self.sentence(&witness.marked_place());
            [line(1, format!("at {place}")), line(2, said)]
        };
        cell.witness.iter().flat_map(of).collect()
    }

    /// Where a goal is asked, and what in the words of the property.
    pub(super) fn asked(&self, part: &Part) -> Line {
        let regime = words(&format!("\"{}\"", part.regime), self.form);
        let (setting, claim) = (self.formula(part.setting), self.formula(&part.claim));
        line(0, format!("{setting}, {regime}: {claim}"))
    }

    /// What a goal may use.
    pub(super) fn premises(&self, part: &Part) -> Vec<Line> {
        let formulas = Formulas::new(self.form, &part.goal.context, &[]);
        let mut lines = Vec::new();
        for (label, hypothesis) in part.labels.iter().zip(&part.goal.hypotheses) {
            let sentence = &hypothesis.sentence;
            let relations: Vec<_> = sentence.relations().cloned().collect();
            let mut text = formulas.relations(&relations);
            if !sentence.when.is_empty() {
                text = format!("{text} when {}", formulas.relations(&sentence.when));
            }
            lines.push(line(1, format!("{}: {text}", self.formula(label))));
        }
        if !part.goal.when.is_empty() {
            lines.push(line(1, format!("when {}", formulas.relations(&part.goal.when))));
        }
        lines
    }

    /// What a goal says, why it is decided as it is, and by which certificate.
    pub(super) fn decided(&self, part: &Part) -> Vec<Line> {
        let mut lines = Vec::new();
        if let Conclusion::Link(Link::Relation(relation)) = &part.goal.conclusion {
            let formulas = Formulas::new(self.form, &part.goal.context, &[]);
            let relation = formulas.relations(std::slice::from_ref(relation));
            lines.push(line(1, format!("then {relation}")));
        }
        lines.push(line(1, self.reason(part)));
        let labels: Vec<&str> = part.labels.iter().map(String::as_str).collect();
        let steps = Subject { goal: &part.goal, labels: &labels }.steps(&part.steps(), self.form);
        lines.extend(steps.into_iter().map(|step| line(2 + step.depth, step.text)));
        lines.push(line(1, format!("the kernel accepted certificate {}", part.digest())));
        lines
    }
}
