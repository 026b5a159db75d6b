//! How long proofs are to read.

use kane_audit::{Audit, Verdict};

use crate::report::Entry;
use crate::words::{Form, Line};

/// How long one proof is, as it is told in text: the measure by which proofs are kept short.
///
/// What is folded away, because a reader looks it up and does not follow it, counts as letters alone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProofLength {
    /// the label of the claim
    pub label: String,
    /// which of its links, from 0
    pub link: usize,
    /// lines that are read
    pub lines: usize,
    /// letters of the longest of them, two of indentation a level
    pub longest: usize,
    /// letters of all of them, without indentation
    pub letters: usize,
    /// letters that are folded away
    pub folded: usize,
}

/// How long the proof of every proved link is, in the order of the document.
#[must_use]
pub fn proof_lengths(audit: &Audit) -> Vec<ProofLength> {
    let entries = (0..audit.document.statements.len()).filter_map(|i| Entry::new(audit, i));
    let of = |entry: Entry<'_>| {
        let proved = entry.judgement.links.iter().enumerate();
        let proved = proved.filter(|(_, link)| link.verdict == Verdict::Proved);
        let length = |(number, link)| length(&entry, number, &entry.steps(link, Form::Plain));
        proved.map(length).collect::<Vec<_>>()
    };
    entries.flat_map(of).collect()
}

fn length(entry: &Entry<'_>, link: usize, lines: &[Line]) -> ProofLength {
    let letters = |line: &Line| line.text.chars().count();
    let (folded, lines): (Vec<&Line>, Vec<&Line>) = lines.iter().partition(|line| line.folded);
    ProofLength {
        label: entry.statement.label.clone(),
        link,
        lines: lines.len(),
        longest: lines.iter().map(|line| 2 * line.depth + letters(line)).max().unwrap_or(0),
        letters: lines.iter().map(|line| letters(line)).sum(),
        folded: folded.iter().map(|line| letters(line)).sum(),
    }
}
