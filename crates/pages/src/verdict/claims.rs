//! Audited documents, and links to their claims.

use std::path::Path;

use kane::audit::{Audit, Body, Options, Statement, Verdict, audit, read};

use crate::NotMade;

/// A document with its verdicts.
pub(super) struct Claims {
    name: &'static str,
    pub(super) audit: Audit,
}

impl Claims {
    /// Audits a document of `docs/derivations`; where labels are given, these alone and what they cite.
    pub(super) fn of(
        root: &Path,
        name: &'static str,
        labels: Option<&[&str]>,
    ) -> Result<Self, NotMade> {
        let bytes = std::fs::read(root.join("docs/derivations").join(name));
        let bytes = bytes.map_err(|error| NotMade::because(name, error))?;
        let document = read(name, &bytes).map_err(|_| NotMade::because(name, "it has errors"))?;
        let mut only = None;
        if let Some(labels) = labels {
            let place = |label: &&str| {
                let found = document.statements.iter().position(|one| one.label == *label);
                found.ok_or_else(|| NotMade::because(name, format!("nothing is called {label}")))
            };
            only = Some(labels.iter().map(place).collect::<Result<Vec<_>, _>>()?);
        }
        let options = Options { only, ..Options::default() };
        Ok(Self { name, audit: audit(document, &options, &mut |_, _| {}) })
    }

    fn statements(&self) -> impl Iterator<Item = (&Statement, Verdict)> {
        let verdicts = self.audit.judgements.iter().map(|judgement| judgement.verdict);
        self.audit.document.statements.iter().zip(verdicts)
    }

    /// The label of a claim with a link to where it stands, if its verdict is what a sentence says.
    pub(super) fn told(&self, label: &str, verdict: Verdict) -> Result<String, NotMade> {
        let statement = self.statement(label)?;
        let found = self.statements().find(|(one, _)| one.label == label).map(|(_, found)| found);
        if found == Some(verdict) {
            return Ok(self.link(statement));
        }
        let found = found.map_or_else(String::new, |found| found.to_string());
        Err(NotMade::because(self.name, format!("{label} is {found}, not {verdict}")))
    }

    fn statement(&self, label: &str) -> Result<&Statement, NotMade> {
        let found = self.audit.document.statements.iter().find(|one| one.label == label);
        found.ok_or_else(|| NotMade::because(self.name, format!("nothing is called {label}")))
    }

    /// What a statement says, as written.
    pub(super) fn saying(&self, label: &str) -> Result<String, NotMade> {
        let parts = &self.statement(label)?.parts;
        Ok(self.audit.document.on_one_line(parts.content.clone()))
    }

    /// The condition of a claim, as written.
    pub(super) fn condition(&self, label: &str) -> Result<String, NotMade> {
        let when = self.statement(label)?.parts.when.clone();
        let when = when.ok_or_else(|| NotMade::because(self.name, format!("{label} has none")))?;
        let text = self.audit.document.on_one_line(when);
        Ok(text.trim_start_matches("when").trim().to_owned())
    }

    fn link(&self, statement: &Statement) -> String {
        let place = anchor(&self.audit.document.text, statement.span.start);
        format!("[{}](derivations/{}#{place})", statement.label, self.name)
    }

    /// Links to all numbered equations with this verdict.
    pub(super) fn equations(&self, verdict: Verdict) -> Vec<String> {
        let is_number = |label: &str| {
            let inner = label.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
            inner.is_some_and(|inner| inner.bytes().all(|byte| byte.is_ascii_digit()))
        };
        let wanted = |(statement, found): &(&Statement, Verdict)| {
            *found == verdict && is_number(&statement.label)
        };
        self.statements().filter(wanted).map(|(statement, _)| self.link(statement)).collect()
    }

    /// How many claims cite a refuted equation.
    pub(super) fn citing_refuted(&self) -> usize {
        let refuted = |index: &usize| {
            let judged = self.audit.judgements.get(*index);
            judged.is_some_and(|judgement| judgement.verdict == Verdict::Refuted)
        };
        let cites = |(statement, _): &(&Statement, Verdict)| match &statement.body {
            Body::Claim(claim) => claim.from.iter().any(refuted),
            _ => false,
        };
        self.statements().filter(cites).count()
    }
}

/// The anchor of the last heading before a place, as readers of Markdown on the web make it.
fn anchor(text: &str, place: usize) -> String {
    let before = text.get(..place).unwrap_or_default();
    let heading = before.lines().rev().find(|line| line.starts_with('#')).unwrap_or_default();
    slug(heading.trim_start_matches('#').trim())
}

/// Letters and digits in small letters, spaces as hyphens.
pub(super) fn slug(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
    kept.map(|c| if c == ' ' { '-' } else { c.to_ascii_lowercase() }).collect()
}
