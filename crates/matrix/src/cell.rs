//! What is found about one law and one property.

use kane_impact::{Contact, Impulse};
use kane_number::Rational;

use crate::sample::Exact;
use crate::study::Part;

/// How a property fares with a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Finding {
    /// every goal has a certificate that the kernel accepted
    Proved,
    /// an exact witness, which the kernel accepted
    Refuted,
    /// the question has no meaning for this law
    NotApplicable,
    /// neither
    Undecided,
}

/// A cell of the matrix.
#[derive(Clone, Debug)]
pub struct Cell {
    /// the finding
    pub finding: Finding,
    /// why, in a sentence
    pub reason: String,
    /// what the kernel accepted
    pub parts: Vec<Part>,
    /// the contacts that speak against it, in the order in which they happen
    pub witness: Vec<Witness>,
}

/// A contact and what the law says of it, as text, exactly.
#[derive(Clone, Debug)]
pub struct Witness {
    /// the contact
    pub contact: Contact<Rational>,
    /// regime, p_t, p_n, v_t⁺, v_n⁺, E_t, E_n; `None` where the law has no answer
    pub outcome: Option<Said>,
}

/// An outcome as text, exactly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Said {
    /// the regime
    pub regime: &'static str,
    /// (symbol, value) pairs
    pub values: Vec<(&'static str, String)>,
}

impl Witness {
    pub(crate) fn new(contact: &Contact<Rational>, outcome: &Exact) -> Self {
        let outcome = match outcome {
            Exact::Rational(o) => said(o),
            Exact::Algebraic(o) => said(o),
        };
        Self { contact: contact.clone(), outcome: Some(outcome) }
    }

    pub(crate) fn silent(contact: &Contact<Rational>) -> Self {
        Self { contact: contact.clone(), outcome: None }
    }

    /// The contact in words: v, a, W, mu, e.
    #[must_use]
    pub fn place(&self) -> String {
        crate::unmarked(&self.marked_place())
    }

    /// The same with backticks around its formulas.
    #[must_use]
    pub fn marked_place(&self) -> String {
        let (c, w) = (&self.contact, self.contact.delassus());
        format!(
            "`v = {}`, `a = {}`, `W` = [[{}, {}], [{}, {}]], `mu = {}`, `e = {}`",
            c.slip(),
            c.approach(),
            w.tt(),
            w.tn(),
            w.tn(),
            w.nn(),
            c.friction(),
            c.restitution()
        )
    }
}

fn said<N: kane_number::Number>(outcome: &kane_impact::Outcome<N>) -> Said {
    let Impulse { tangential, normal } = &outcome.impulse;
    let work = &outcome.work;
    let values = vec![
        ("p_t", tangential.to_string()),
        ("p_n", normal.to_string()),
        ("v_1", outcome.slip.to_string()),
        ("E_t", work.tangential.to_string()),
        ("E_n", work.normal.to_string()),
    ];
    Said { regime: outcome.regime, values }
}

impl Cell {
    pub(crate) fn refuted(witness: Witness, part: Part) -> Self {
        let reason = format!("at {}", witness.marked_place());
        Self { finding: Finding::Refuted, reason, parts: vec![part], witness: vec![witness] }
    }

    pub(crate) fn not_applicable(reason: impl Into<String>) -> Self {
        Self {
            finding: Finding::NotApplicable,
            reason: reason.into(),
            parts: Vec::new(),
            witness: Vec::new(),
        }
    }

    pub(crate) fn undecided(reason: impl Into<String>) -> Self {
        Self { finding: Finding::Undecided, ..Self::not_applicable(reason) }
    }

    /// The same cell with a remark behind its reason.
    pub(crate) fn remarked(self, remark: &str) -> Self {
        Self { reason: format!("{}; {remark}", self.reason), ..self }
    }

    /// Proved if nothing is open.
    pub(crate) fn from_parts(parts: Vec<Part>, open: Vec<String>) -> Self {
        if !open.is_empty() {
            return Self::undecided(open.join("; "));
        }
        let reason = match parts.len() {
            0 => "0 goals: the formulas leave nothing to show".to_owned(),
            1 => "1 goal".to_owned(),
            n => format!("{n} goals"),
        };
        Self { finding: Finding::Proved, reason, parts, witness: Vec::new() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_without_goals_says_why_it_is_proved() {
        let cell = Cell::from_parts(Vec::new(), Vec::new());
        assert_eq!(cell.finding, Finding::Proved);
        assert_eq!(cell.reason, "0 goals: the formulas leave nothing to show");
    }
}
