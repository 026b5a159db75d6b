//! What is put to a judge.

use kane_audit::{Audit, LinkJudgement};

/// Claims of an audit that are put to a judge.
#[derive(Clone, Debug)]
pub struct Claims<'a> {
    pub(crate) audit: &'a Audit,
    /// indices, ascending
    statements: Vec<usize>,
}

/// One link of a claim.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Asked<'a> {
    /// indices of the statement, and of the link in it
    pub(crate) place: (usize, usize),
    /// the label of the statement
    pub(crate) label: &'a str,
    /// how many links the claim has
    pub(crate) links: usize,
    /// what the kernel says of it
    pub(crate) judged: &'a LinkJudgement,
}

impl<'a> Claims<'a> {
    /// All claims of an audit.
    #[must_use]
    pub fn of(audit: &'a Audit) -> Self {
        Self { audit, statements: (0..audit.document.statements.len()).collect() }
    }

    /// The same claims, narrowed to these statements.
    #[must_use]
    pub fn only(mut self, statements: &[usize]) -> Self {
        self.statements.retain(|index| statements.contains(index));
        self
    }

    /// The links of the claims, in their order.
    pub(crate) fn links(&self) -> impl Iterator<Item = Asked<'a>> + '_ {
        let audit = self.audit;
        self.statements.iter().flat_map(move |&statement| {
            let links = &audit.judgements[statement].links;
            links.iter().enumerate().map(move |(link, judged)| Asked {
                place: (statement, link),
                label: &audit.document.statements[statement].label,
                links: links.len(),
                judged,
            })
        })
    }
}

impl Asked<'_> {
    /// A name for it in a file: the label of its claim, and its number if the claim has several links.
    pub(crate) fn name(&self) -> String {
        let inner = self.label.trim_start_matches('(').trim_end_matches(')');
        let plain = |c: char| if c.is_ascii_alphanumeric() || c == '\'' { c } else { '_' };
        let label: String = inner.chars().map(plain).collect();
        if self.links > 1 { format!("{label}_{}", self.place.1 + 1) } else { label }
    }
}
