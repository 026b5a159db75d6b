//! What the reader of documents does not take, taken out of a draft.

use crate::draft::{Draft, one_line};
use crate::unreadable::Unreadable;

impl Draft {
    /// Takes what a claim must not rest on out of its `from`, which is a guess, and says so in a comment above it.
    /// The line and the column in characters, from 1, are those of a fault of the document; whether they are in a
    /// `from`.
    pub fn refuse_citation(&mut self, line: usize, column: usize, reason: &str) -> bool {
        let mut lines: Vec<String> = self.document.lines().map(str::to_owned).collect();
        let Some(at) = line.checked_sub(1) else { return false };
        let Some((claim, cited)) = lines.get(at).and_then(|line| line.split_once(" from ")) else {
            return false;
        };
        let mut start = claim.chars().count() + " from ".len();
        let Some(label) = claim.strip_prefix("claim ").and_then(|rest| rest.split(':').next())
        else {
            return false;
        };
        let (mut kept, mut refused) = (Vec::new(), None);
        for citation in cited.split(", ") {
            let end = start + citation.chars().count();
            if (start + 1..=end).contains(&column) {
                refused = Some(citation.to_owned());
            } else {
                kept.push(citation);
            }
            start = end + ", ".len();
        }
        let Some(refused) = refused else { return false };
        let comment = format!("# {label} does not rest on {refused}, {}", one_line(reason));
        let claim = if kept.is_empty() {
            claim.to_owned()
        } else {
            format!("{claim} from {}", kept.join(", "))
        };
        lines.splice(at..=at, [comment, claim]);
        self.document = format!("{}\n", lines.join("\n"));
        true
    }

    /// Turns the statement in a line of the document, from 1, into a comment with the reason, and takes
    /// its label from what claims rest on. Whether there is a statement in that line.
    pub fn refuse(&mut self, line: usize, reason: &str) -> bool {
        let mut lines: Vec<String> = self.document.lines().map(str::to_owned).collect();
        let Some(statement) = line.checked_sub(1).and_then(|at| lines.get_mut(at)) else {
            return false;
        };
        let words: Vec<&str> = statement.split(' ').collect();
        let (kind, label) = match words.as_slice() {
            [kind @ ("given" | "claim" | "let"), label, ..] => (*kind, label.trim_end_matches(':')),
            ["var", name, ..] => ("var", *name),
            _ => return false,
        };
        let (kind, label) = (kind.to_owned(), label.to_owned());
        let reason = one_line(reason);
        *statement = format!("# not accepted, {reason}: {statement}");
        if kind != "var" {
            lines = lines.into_iter().flat_map(|line| without(&label, line)).collect();
            if let Some(outcome) = self.equations.iter_mut().find(|outcome| outcome.label == label)
            {
                outcome.fault = Some(Unreadable::NotAccepted(reason));
            }
        }
        self.document = format!("{}\n", lines.join("\n"));
        true
    }
}

/// A line of a draft whose claim, if it is one, does not cite this label, with a comment above it that says so.
fn without(label: &str, line: String) -> Vec<String> {
    let Some((claim, cited)) = line.split_once(" from ") else { return vec![line] };
    let name = claim.strip_prefix("claim ").and_then(|rest| rest.split(':').next());
    let kept: Vec<&str> = cited.split(", ").filter(|cited| *cited != label).collect();
    match name {
        Some(name) if kept.len() < cited.split(", ").count() => {
            let comment = format!("# {name} does not rest on {label}, which is not accepted");
            let claim = match kept.as_slice() {
                [] => claim.to_owned(),
                _ => format!("{claim} from {}", kept.join(", ")),
            };
            vec![comment, claim]
        }
        _ => vec![line],
    }
}
