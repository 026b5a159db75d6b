//! What a judge answers, as data.

use std::collections::BTreeMap;

/// A judge's answer to one link of a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// it comes to the same finding
    Agrees,
    /// it agrees on the claim as it follows from what it cites, but was not asked whether that follows
    /// from the givens: why
    Partly(String),
    /// it comes to another one, or rejects the proof: what it said
    Disagrees(String),
    /// it came to no finding: why
    Undecided(String),
    /// the question was not put to it: why
    NotAsked(String),
}

/// The answers of one judge, by statement and link.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Judge {
    /// its name
    pub name: String,
    /// what it answers; empty if it is not installed
    pub answers: BTreeMap<(usize, usize), Answer>,
    /// whether it was there to be asked
    pub asked: bool,
    /// what its proofs rest on, where it says so
    pub axioms: Vec<String>,
}

impl Judge {
    /// Whether no answer disagrees.
    #[must_use]
    pub fn agrees(&self) -> bool {
        !self.answers.values().any(|a| matches!(a, Answer::Disagrees(_)))
    }

    /// Whether an answer to the statement disagrees.
    #[must_use]
    pub fn disagrees_on(&self, statement: usize) -> bool {
        let answers = self.answers.range((statement, 0)..(statement + 1, 0));
        answers.into_iter().any(|(_, answer)| matches!(answer, Answer::Disagrees(_)))
    }
}
