//! What is shown of an audit.

use kane_audit::{Audit, Body, Judgement, LinkJudgement, Statement, Verdict};
use kane_kernel::Context;

/// An audit, the statements of it that are shown, and the command that shows them again.
#[derive(Clone, Debug)]
pub struct Report<'a> {
    /// the judged document
    pub audit: &'a Audit,
    /// indices of the statements that are shown, ascending
    pub shown: Vec<usize>,
    /// a command that prints this report
    pub command: String,
}

impl<'a> Report<'a> {
    /// A report of every statement.
    #[must_use]
    pub fn new(audit: &'a Audit, command: impl Into<String>) -> Self {
        Self {
            audit,
            shown: (0..audit.document.statements.len()).collect(),
            command: command.into(),
        }
    }

    /// The same report, narrowed to these statements.
    #[must_use]
    pub fn only(mut self, indices: &[usize]) -> Self {
        self.shown.retain(|index| indices.contains(index));
        self
    }

    /// Whether every statement that is shown ends as its author expects.
    #[must_use]
    pub fn as_expected(&self) -> bool {
        self.entries().all(|entry| entry.judgement.as_expected())
    }

    /// The statements that are shown, with their judgements.
    pub(crate) fn entries(&self) -> impl Iterator<Item = Entry<'a>> + '_ {
        let audit = self.audit;
        self.shown.iter().filter_map(move |&index| Entry::new(audit, index))
    }
}

/// One statement and its judgement.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry<'a> {
    audit: &'a Audit,
    pub(crate) statement: &'a Statement,
    pub(crate) judgement: &'a Judgement,
}

impl<'a> Entry<'a> {
    /// The entry at `index`, if the audit has one.
    pub(crate) fn new(audit: &'a Audit, index: usize) -> Option<Self> {
        let statement = audit.document.statements.get(index)?;
        let judgement = audit.judgements.get(index)?;
        Some(Self { audit, statement, judgement })
    }

    /// `let`, `given` or `claim`.
    pub(crate) fn kind(&self) -> &'static str {
        match self.statement.body {
            Body::Let(_) => "let",
            Body::Given(_) => "given",
            Body::Claim(_) => "claim",
        }
    }

    /// The symbols and definitions of the document.
    pub(crate) fn context(&self) -> &'a Context {
        &self.audit.document.context
    }

    pub(crate) fn is_claim(&self) -> bool {
        matches!(self.statement.body, Body::Claim(_))
    }

    /// Whether the label is a number in parentheses: an equation of the text under audit.
    pub(crate) fn is_equation(&self) -> bool {
        let inner = self.statement.label.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
        inner.is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
    }

    /// The statement as written, on one line and without comments.
    pub(crate) fn source(&self) -> String {
        let lines = self.audit.document.source(self.statement).lines();
        let words =
            lines.flat_map(|line| line.split('#').next().unwrap_or_default().split_whitespace());
        words.collect::<Vec<_>>().join(" ")
    }

    /// What the statement says: the source without its kind and label, and without what it cites and expects.
    pub(crate) fn saying(&self) -> String {
        let source = self.source();
        let rest = source.strip_prefix(self.kind()).unwrap_or(&source).trim_start();
        let rest = match rest.strip_prefix(self.statement.label.as_str()) {
            // a `let` without a label goes by its name, which is part of what it says
            Some(after) if !after.trim_start().starts_with(":=") => {
                after.trim_start().trim_start_matches(':')
            }
            _ => rest,
        };
        let end = [" from ", " by ", " expect "].iter().filter_map(|word| rest.find(word)).min();
        rest[..end.unwrap_or(rest.len())].trim().to_owned()
    }

    /// Labels of the statements at these indices.
    pub(crate) fn labels(&self, indices: &[usize]) -> Vec<&'a str> {
        let statements = &self.audit.document.statements;
        indices
            .iter()
            .filter_map(|&index| statements.get(index))
            .map(|s| s.label.as_str())
            .collect()
    }

    /// The entries at these indices.
    pub(crate) fn cited(&self, indices: &[usize]) -> Vec<Self> {
        indices.iter().filter_map(|&index| Self::new(self.audit, index)).collect()
    }

    /// The first of the worst links.
    pub(crate) fn decisive(&self) -> Option<(usize, &'a LinkJudgement)> {
        let worst = self.judgement.links.iter().map(|link| link.verdict).max()?;
        self.judgement.links.iter().enumerate().find(|(_, link)| link.verdict == worst)
    }

    /// Whether the statement, or one link of it, is refuted.
    pub(crate) fn is_refuted(&self) -> bool {
        let refuted = |verdict| verdict == Verdict::Refuted;
        refuted(self.judgement.verdict)
            || self.judgement.links.iter().any(|link| refuted(link.verdict))
    }

    /// How the verdict stands to what the author expects; `None` where that goes without saying.
    pub(crate) fn expectation(&self) -> Option<String> {
        match self.judgement.expect {
            // only a claim can surprise
            _ if !self.is_claim() => None,
            Some(Verdict::Proved) | None if self.judgement.as_expected() => None,
            Some(_) if self.judgement.as_expected() => Some("expected".to_owned()),
            expect => {
                Some(format!("NOT EXPECTED (should be {})", expect.unwrap_or(Verdict::Proved)))
            }
        }
    }

    /// Why it is unsupported, and what it would be otherwise.
    pub(crate) fn support(&self) -> Option<String> {
        (self.judgement.verdict == Verdict::Unsupported).then(|| {
            let cited = self.labels(&self.judgement.unproved).join(", ");
            format!("cites {cited}, not proved; else {}", self.judgement.conditional)
        })
    }
}
