//! A document that is open in the editor.

use std::ops::Range;
use std::sync::Arc;

use kane_audit::{Outline, Survey, survey};
use serde_json::Value;

use crate::findings::Findings;
use crate::position::{self, Lines, Position};

/// A document as the editor has it.
#[derive(Debug)]
pub(crate) struct Open {
    /// the editor's number of the text
    pub(crate) version: i64,
    pub(crate) text: Arc<str>,
    lines: Option<Lines>,
    survey: Option<Box<Survey>>,
    /// what was found of this text; `None` while it is judged
    pub(crate) findings: Option<Findings>,
}

impl Open {
    pub(crate) fn new(version: i64, text: String) -> Self {
        Self { version, text: text.into(), lines: None, survey: None, findings: None }
    }

    /// Applies what was typed. `None`, and nothing is changed, if this is no change.
    pub(crate) fn change(&mut self, version: i64, changes: &[Value]) -> Option<()> {
        let mut text = self.text.to_string();
        for change in changes {
            let new = change.get("text")?.as_str()?;
            match change.get("range") {
                None | Some(Value::Null) => new.clone_into(&mut text),
                Some(range) => {
                    let range = position::bytes(&text, &Lines::of(&text), range)?;
                    text.replace_range(range, new);
                }
            }
        }
        *self = Self::new(version, text);
        Some(())
    }

    pub(crate) fn lines(&mut self) -> &Lines {
        self.lines.get_or_insert_with(|| Lines::of(&self.text))
    }

    /// The byte at a position.
    pub(crate) fn byte(&mut self, position: Position) -> usize {
        let text = self.text.clone();
        self.lines().byte(&text, position)
    }

    /// A range of bytes as the protocol has it.
    pub(crate) fn range(&mut self, range: &Range<usize>) -> Value {
        let text = self.text.clone();
        self.lines().range(&text, range)
    }

    /// The document as far as it can be read.
    pub(crate) fn survey(&mut self, uri: &str) -> &Survey {
        self.survey.get_or_insert_with(|| Box::new(survey(name(uri), self.text.as_bytes())))
    }

    /// What stands where.
    pub(crate) fn outline(&mut self, uri: &str) -> &Outline {
        &self.survey(uri).outline
    }
}

/// What a document is called in messages: the last part of its address.
pub(crate) fn name(uri: &str) -> &str {
    uri.rsplit(['/', '\\']).find(|part| !part.is_empty()).unwrap_or(uri)
}

/// The index of the label in which this byte stands, there or where it is cited, and the place.
pub(crate) fn label_at(outline: &Outline, at: usize) -> Option<(usize, Range<usize>)> {
    let covers = |place: &Range<usize>| place.start <= at && at <= place.end;
    let own = outline.labels.iter().position(|label| covers(&label.place));
    if let Some(index) = own {
        return Some((index, outline.labels[index].place.clone()));
    }
    let citation = outline.citations.iter().find(|citation| covers(&citation.place))?;
    Some((citation.cites?, citation.place.clone()))
}

/// The word of letters, digits, `_` and `'` around a byte.
pub(crate) fn word_at(text: &str, at: usize) -> Option<Range<usize>> {
    let inside = |c: char| c.is_alphanumeric() || "_'′".contains(c);
    let (before, after) = (text.get(..at)?, text.get(at..)?);
    let start = before.trim_end_matches(inside).len();
    let end = at + after.find(|c| !inside(c)).unwrap_or(after.len());
    (start < end).then_some(start..end)
}
