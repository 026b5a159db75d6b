//! The news: how many statements there are, and how they fare.

use std::fmt::Write as _;

use kane_audit::Verdict;

use crate::Report;
use crate::wording::number_of;

/// The verdicts of claims, in the order in which they are told.
const TOLD: [Verdict; 6] = [
    Verdict::Proved,
    Verdict::Refuted,
    Verdict::IllDefined,
    Verdict::Vacuous,
    Verdict::Unsupported,
    Verdict::Undecided,
];

/// Surprises that are named in the news; the others are found in the list.
const NAMED: usize = 10;

/// Counts over the statements that a report shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summary {
    /// statements whose label is a number in parentheses
    pub equations: usize,
    /// statements of any kind
    pub statements: usize,
    /// claims, numbered or not
    pub claims: usize,
    /// claims by verdict; verdicts that do not occur are left out
    pub verdicts: Vec<(Verdict, usize)>,
    /// numbered claims that are refuted, in whole or in one link
    pub refuted_as_printed: Vec<String>,
    /// claims that do not end as their author expects
    pub surprises: Vec<String>,
    /// those among them for which no verdict is written, and which are not proved
    pub unproved: Vec<String>,
    /// whether a verdict is written for any claim
    pub expects: bool,
}

impl Summary {
    /// Counts what `report` shows.
    #[must_use]
    pub fn of(report: &Report<'_>) -> Self {
        let claims: Vec<_> = report.entries().filter(|entry| entry.is_claim()).collect();
        let count =
            |verdict| claims.iter().filter(|entry| entry.judgement.verdict == verdict).count();
        let label = |entry: &crate::report::Entry<'_>| entry.statement.label.clone();
        Self {
            equations: report.entries().filter(|entry| entry.is_equation()).count(),
            statements: report.entries().count(),
            claims: claims.len(),
            verdicts: TOLD
                .map(|verdict| (verdict, count(verdict)))
                .into_iter()
                .filter(|(_, n)| *n > 0)
                .collect(),
            refuted_as_printed: claims
                .iter()
                .filter(|entry| {
                    entry.is_equation() && entry.judgement.verdict != Verdict::Unsupported
                })
                .filter(|entry| entry.is_refuted())
                .map(label)
                .collect(),
            surprises: claims
                .iter()
                .filter(|entry| !entry.judgement.as_expected())
                .map(label)
                .collect(),
            unproved: claims
                .iter()
                .filter(|entry| !entry.judgement.as_expected())
                .filter(|entry| entry.judgement.expect.is_none())
                .map(label)
                .collect(),
            expects: claims.iter().any(|entry| entry.judgement.expect.is_some()),
        }
    }

    /// One line: `29 equations, 113 claims: 80 proved, 20 refuted; refuted as printed: (1), (25)`.
    #[must_use]
    pub fn headline(&self) -> String {
        let mut line = self.counts();
        if !self.refuted_as_printed.is_empty() {
            let _ = write!(line, "; refuted as printed: {}", self.refuted_as_printed.join(", "));
        }
        line
    }

    /// The counts of the headline alone: `29 equations, 113 claims: 80 proved, 20 refuted`.
    pub(crate) fn counts(&self) -> String {
        let mut line = String::new();
        if self.equations > 0 {
            line.push_str(&counted(self.equations, "equation"));
            line.push_str(", ");
        }
        line.push_str(&counted(self.claims, "claim"));
        let verdicts: Vec<_> =
            self.verdicts.iter().map(|(verdict, n)| format!("{n} {verdict}")).collect();
        if !verdicts.is_empty() {
            let _ = write!(line, ": {}", verdicts.join(", "));
        }
        line
    }

    /// One line: whether all verdicts are as expected, and which are not. What no verdict is written for is to be proved.
    #[must_use]
    pub fn expectation(&self) -> String {
        match (self.claims, self.surprises.len()) {
            (0, _) if self.statements > 0 => {
                "nothing to check: none of these statements is a claim".to_owned()
            }
            (0, _) => "nothing to check: claims stand in blocks tagged kane".to_owned(),
            (_, 0) if self.expects => "every verdict is as expected".to_owned(),
            (_, 0) => "every claim is proved".to_owned(),
            _ => {
                let told = self.groups().into_iter().map(|(what, labels)| {
                    format!("{} {}: {}", labels.len(), what.to_uppercase(), named(&labels))
                });
                told.collect::<Vec<_>>().join("; ")
            }
        }
    }

    /// What did not end as it should, with the words for it; no group is empty.
    pub(crate) fn groups(&self) -> Vec<(&'static str, Vec<String>)> {
        let against = self.surprises.iter().filter(|label| !self.unproved.contains(label));
        [("Not proved", self.unproved.clone()), ("Not as expected", against.cloned().collect())]
            .into_iter()
            .filter(|(_, labels)| !labels.is_empty())
            .collect()
    }
}

/// `a, b, and 3 more`: the first few labels.
fn named(labels: &[String]) -> String {
    let more = labels.len().saturating_sub(NAMED);
    let rest = (more > 0).then(|| format!("and {more} more"));
    let list: Vec<&str> =
        labels.iter().take(NAMED).map(String::as_str).chain(rest.as_deref()).collect();
    list.join(", ")
}

/// `1 claim`, `2 claims`, `no claims`.
fn counted(n: usize, noun: &str) -> String {
    match n {
        0 => format!("no {noun}s"),
        n => number_of(n, noun),
    }
}

#[cfg(test)]
mod tests {
    use kane_audit::{Options, audit, read};

    use super::*;

    fn of(statements: &str) -> (String, String) {
        let text = format!("# T\n\n```kane\nvar x\n{statements}```\n");
        let document = read("summary.md", text.as_bytes()).expect("it is well formed");
        let audit = audit(document, &Options::default(), &mut |_, _| {});
        let summary = Summary::of(&Report::new(&audit, "kane audit summary.md"));
        (summary.headline(), summary.expectation())
    }

    #[test]
    fn a_summary_counts_what_is_claimed_and_names_what_is_a_surprise() {
        let told = |statements, headline: &str, expectation: &str| {
            assert_eq!(of(statements), (headline.to_owned(), expectation.to_owned()));
        };
        told("", "no claims", "nothing to check: claims stand in blocks tagged kane");
        let none = "nothing to check: none of these statements is a claim";
        told("given a: x > 0\n", "no claims", none);
        told("claim a: x^2 >= 0\n", "1 claim: 1 proved", "every claim is proved");
        told(
            "claim (1): x^2 >= 0\nclaim a: x > 0 expect refuted\n",
            "1 equation, 2 claims: 1 proved, 1 refuted",
            "every verdict is as expected",
        );
        told(
            "claim (1): x > 0\nclaim (2): x > 1 expect refuted\nclaim c: x^2 >= 0 expect refuted\n",
            "2 equations, 3 claims: 1 proved, 2 refuted; refuted as printed: (1), (2)",
            "1 NOT PROVED: (1); 1 NOT AS EXPECTED: c",
        );
    }

    #[test]
    fn of_many_surprises_the_first_are_named_and_the_others_counted() {
        let labels = |n: usize| (0..n).map(|i| format!("c{i}")).collect::<Vec<_>>();
        let all = |n: usize| labels(n).join(", ");
        assert_eq!(named(&labels(1)), "c0");
        assert_eq!(named(&labels(NAMED)), all(NAMED));
        assert_eq!(named(&labels(NAMED + 1)), format!("{}, and 1 more", all(NAMED)));
        assert_eq!(named(&labels(NAMED + 3)), format!("{}, and 3 more", all(NAMED)));
    }
}
