//! Sentences that are packed into lines of a bounded length, in any form.

use super::formula::Formulas;
use super::{Form, Line};

/// Letters of a line, with its indentation.
const WIDTH: usize = 140;

/// A piece of a sentence that stays on one line, and how many letters it has as text.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Piece {
    set: String,
    letters: usize,
}

/// A sentence in pieces.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Sentence(Vec<Piece>);

impl Sentence {
    /// Words without formulas that need setting.
    pub(super) fn of(words: &str) -> Self {
        Self(vec![Piece { set: words.to_owned(), letters: words.chars().count() }])
    }

    /// Letters as text on one line.
    pub(super) fn letters(&self) -> usize {
        let letters: usize = self.0.iter().map(|piece| piece.letters).sum();
        letters + self.0.len().saturating_sub(1)
    }

    /// Adds a sentence behind a blank.
    pub(super) fn and(mut self, more: Self) -> Self {
        self.0.extend(more.0);
        self
    }

    /// The sentence with a capital letter where it begins with an article, and not with a label or a formula.
    pub(super) fn begun(mut self) -> Self {
        if let Some(first) = self.0.first_mut() {
            for (article, capital) in [("the ", "The "), ("a ", "A ")] {
                if let Some(rest) = first.set.strip_prefix(article) {
                    first.set = format!("{capital}{rest}");
                    break;
                }
            }
        }
        self
    }

    /// Adds letters without a blank before them.
    pub(super) fn end(mut self, letters: &str) -> Self {
        if let Some(last) = self.0.last_mut() {
            last.set.push_str(letters);
            last.letters += letters.chars().count();
        }
        self
    }

    /// All of these, with a comma between.
    pub(super) fn list(all: Vec<Self>) -> Self {
        Self::joined(all, ",")
    }

    /// All of these, with letters behind each but the last.
    pub(super) fn joined(all: Vec<Self>, between: &str) -> Self {
        let count = all.len();
        let ended = |(i, one): (usize, Self)| if i + 1 < count { one.end(between) } else { one };
        Self(all.into_iter().enumerate().flat_map(|x| ended(x).0).collect())
    }

    /// The lines that it takes, the second and further ones a little deeper.
    pub(super) fn lines(self, depth: usize) -> Vec<Line> {
        let mut lines: Vec<Line> = Vec::new();
        let mut used = usize::MAX / 2;
        for Piece { set, letters } in self.0 {
            match lines.last_mut() {
                Some(line) if used + 1 + letters <= WIDTH => {
                    line.text.push(' ');
                    line.text.push_str(&set);
                    used += 1 + letters;
                }
                _ => {
                    let depth = depth + usize::from(!lines.is_empty());
                    used = 2 * depth + letters;
                    lines.push(Line { depth, text: set, folded: false });
                }
            }
        }
        lines
    }
}

/// Writes in one form, and knows how long it is as text.
pub(super) struct Pen<'a> {
    pub(super) set: &'a Formulas,
    pub(super) plain: &'a Formulas,
}

impl Pen<'_> {
    /// Formulas and words that stay on one line.
    pub(super) fn write(&self, write: impl Fn(&Formulas) -> String) -> Sentence {
        let plain = write(self.plain);
        let letters = plain.chars().count();
        let set = if self.set.form == Form::Plain { plain } else { write(self.set) };
        Sentence(vec![Piece { set, letters }])
    }
}
