//! Sentences in plain notation, taken apart so that each form of a report can set them as mathematics.
//!
//! The split decides how something looks and nothing else: put together again, the pieces are the sentence.

use std::collections::HashSet;

use kane_kernel::Context;

/// The names that a document declares.
#[derive(Debug, Default)]
pub(crate) struct Names<'a>(HashSet<&'a str>);

/// A stretch of a sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Piece<'t> {
    /// words, numbers and punctuation
    Text(&'t str),
    /// a declared name
    Name(&'t str),
    /// one of `*`, `-`, `<=`, `>=`, `!=`, `->`, `oo`, `<`, `>`, as an operator
    Operator(&'t str),
    /// the exponent that follows a `^`
    Power(&'t str),
}

const OPERATORS: [&str; 8] = ["<=", ">=", "!=", "->", "*", "-", "<", ">"];

impl<'a> Names<'a> {
    pub(crate) fn of(context: &'a Context) -> Self {
        let vars = context.vars.iter().map(|var| var.name.as_str());
        Self(vars.chain(context.lets.iter().map(|definition| definition.name.as_str())).collect())
    }

    /// These names, too.
    pub(crate) fn and(mut self, names: &[&'a str]) -> Self {
        self.0.extend(names);
        self
    }

    /// The sentence in pieces.
    pub(crate) fn pieces<'t>(&self, text: &'t str) -> Vec<Piece<'t>> {
        let mut pieces = Vec::new();
        let (mut start, mut at) = (0, 0);
        while let Some(first) = text[at..].chars().next() {
            let rest = &text[at..];
            let (length, piece) = if first.is_alphanumeric() {
                let word = word(rest);
                (word.len(), self.name(text, at, word))
            } else if let Some(power) = power(rest) {
                (1 + power.len(), Some(Piece::Power(power)))
            } else if let Some(operator) = OPERATORS.iter().find(|o| rest.starts_with(**o)) {
                (operator.len(), Some(Piece::Operator(operator)))
            } else {
                (first.len_utf8(), None)
            };
            if let Some(piece) = piece {
                if start < at {
                    pieces.push(Piece::Text(&text[start..at]));
                }
                pieces.push(piece);
                start = at + length;
            }
            at += length;
        }
        if start < text.len() {
            pieces.push(Piece::Text(&text[start..]));
        }
        pieces
    }

    /// The word as a name, if it is one here and not a word of English.
    fn name<'t>(&self, text: &'t str, at: usize, word: &'t str) -> Option<Piece<'t>> {
        if word == "oo" {
            return Some(Piece::Operator("oo"));
        }
        let beside = in_formula(&text[..at], &text[at + word.len()..]);
        if !self.0.contains(word) {
            // the letters that a proof brings itself, such as the t that tends to 0
            let letter = word.len() == 1 && word.starts_with(|c: char| c.is_ascii_alphabetic());
            return (letter && beside).then_some(Piece::Name(word));
        }
        let english = match word.len() {
            1 => matches!(word, "a" | "A" | "I"),
            _ => {
                word.bytes().all(|byte| byte.is_ascii_lowercase())
                    && kane_algebra::syntax::greek_letter(word).is_none()
            }
        };
        (!english || beside).then_some(Piece::Name(word))
    }
}

/// The word at the start; a hyphen between letters holds it together, as in a label.
fn word(text: &str) -> &str {
    let mut end = text.len();
    let mut chars = text.char_indices().peekable();
    while let Some((at, c)) = chars.next() {
        let next = chars.peek().map(|(_, c)| *c);
        let hyphen = c == '-' && next.is_some_and(char::is_alphabetic);
        if !(c.is_alphanumeric() || matches!(c, '_' | '\'' | '′') || hyphen) {
            end = at;
            break;
        }
    }
    &text[..end]
}

/// The integer after a `^` at the start.
fn power(text: &str) -> Option<&str> {
    let digits = text.strip_prefix('^')?;
    let end = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
    (end > 0).then(|| &digits[..end])
}

/// Whether what stands between the two has an operator at its side, or parentheses around it.
fn in_formula(before: &str, after: &str) -> bool {
    let (before, after) =
        (before.trim_end().chars().next_back(), after.trim_start().chars().next());
    let operates = |c: Option<char>| c.is_some_and(|c| "=+-*/^<>!".contains(c));
    operates(before)
        || operates(after)
        || (matches!(before, Some('(' | '[')) && matches!(after, Some(')' | ']')))
}

#[cfg(test)]
mod tests {
    use kane_kernel::Var;

    use super::*;

    fn shown(text: &str) -> String {
        let var = |name: &str| Var { name: name.to_owned(), of: None, lower: None, upper: None };
        let vars = ["a", "k", "I_y", "mu", "slip"].map(var).to_vec();
        let context = Context { vars, ..Context::default() };
        let names = Names::of(&context);
        let whole = |piece: &Piece<'_>| match *piece {
            Piece::Text(text) => text.to_owned(),
            Piece::Name(name) => format!("[{name}]"),
            Piece::Operator(operator) => format!("<{operator}>"),
            Piece::Power(power) => format!("^[{power}]"),
        };
        names.pieces(text).iter().map(whole).collect()
    }

    #[test]
    fn names_are_told_from_words_and_labels() {
        assert_eq!(shown("by a sum; a = 2*a, k"), "by a sum; [a] = 2<*>[a], [k]");
        assert_eq!(shown("I_y-pos: I_y > 0."), "I_y-pos: [I_y] <>> 0.");
        assert_eq!(shown("fails: a != 1/t at t"), "fails: [a] <!=> 1/[t] at t");
        assert_eq!(shown("the slip; slip - mu^2"), "the slip; [slip] <-> [mu]^[2]");
        assert_eq!(
            shown("non-negative terms as k -> -oo"),
            "non-negative terms as [k] <->> <-><oo>"
        );
    }
}
