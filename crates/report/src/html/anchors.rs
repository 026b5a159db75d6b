//! Where in the page each statement is.

use std::collections::{HashMap, HashSet};

use kane_audit::Statement;
use maud::{Markup, html};

/// The anchors of all statements of a document.
pub(crate) struct Anchors<'a> {
    statements: &'a [Statement],
    names: Vec<String>,
    by_label: HashMap<&'a str, usize>,
    shown: HashSet<usize>,
}

impl<'a> Anchors<'a> {
    /// Anchors that can be read in an address, `s-16` for `(16)`, and lead only to what is shown.
    pub(crate) fn of(statements: &'a [Statement], shown: &[usize]) -> Self {
        let mut taken = HashSet::new();
        let names = statements.iter().enumerate().map(|(index, statement)| {
            let inner = statement.label.trim_start_matches('(').trim_end_matches(')');
            let safe = |c: char| if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' };
            let mut name = format!("s-{}", inner.chars().map(safe).collect::<String>());
            if !taken.insert(name.clone()) {
                // a dot occurs in no other anchor
                name = format!("{name}.{index}");
            }
            name
        });
        let by_label = statements.iter().enumerate().map(|(i, s)| (s.label.as_str(), i)).collect();
        Self {
            names: names.collect(),
            by_label,
            shown: shown.iter().copied().collect(),
            statements,
        }
    }

    /// The anchor of the statement at this index.
    pub(crate) fn name(&self, index: usize) -> &str {
        self.names.get(index).map_or("", String::as_str)
    }

    /// The anchor of the statement with this label, if the page shows it.
    pub(crate) fn find(&self, label: &str) -> Option<String> {
        let index = *self.by_label.get(label)?;
        self.shown.contains(&index).then(|| self.name(index).to_owned())
    }

    /// The label, as a link where there is something to go to.
    pub(crate) fn link(&self, index: usize) -> Markup {
        let label = self.statements.get(index).map_or("?", |statement| statement.label.as_str());
        html! {
            @if self.shown.contains(&index) {
                a href={ "#" (self.name(index)) } { (label) }
            } @else {
                (label)
            }
        }
    }

    /// The labels, with commas between.
    pub(crate) fn links(&self, indices: &[usize]) -> Markup {
        html! {
            @for (number, index) in indices.iter().enumerate() {
                @if number > 0 { ", " }
                (self.link(*index))
            }
        }
    }
}
