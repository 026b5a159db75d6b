//! Factors side by side that can be read in two ways: a mixed number, digits in braces, bars that close or open.

use crate::part::Part;
use crate::token::Token;
use crate::unreadable::Unreadable;

/// What the factors so far leave open for the next one.
pub(crate) struct Adjacent {
    /// the last one, if it is a number in digits
    number: Option<String>,
    /// whether a bar has closed, and something stood behind it
    behind_bar: Option<bool>,
}

impl Adjacent {
    /// Behind a first factor, or a sign and its factor, of which this is the last token.
    pub(crate) fn behind(part: &Part, last: Option<&Token>) -> Self {
        let behind_bar = is_bar(last).then_some(false);
        Self { number: digits(part), behind_bar }
    }

    /// Refuses a bar ahead that may be the end of what another one has begun: `|x|y|z|`.
    pub(crate) fn before(&self, ahead: Option<&Token>) -> Result<(), Unreadable> {
        match self.behind_bar {
            Some(true) if is_bar(ahead) => Err(Unreadable::Ambiguous("|…|…|…|".to_owned())),
            _ => Ok(()),
        }
    }

    /// Takes in the next factor with its last token; refuses a number behind a number, which is a mixed one or has more digits.
    pub(crate) fn then(&mut self, next: &Part, last: Option<&Token>) -> Result<(), Unreadable> {
        if let Some(number) = self.number.as_ref().filter(|_| next.literal) {
            return Err(Unreadable::Ambiguous(format!("{number} {}", next.text)));
        }
        self.number = digits(next);
        self.behind_bar = if is_bar(last) { Some(false) } else { self.behind_bar.map(|_| true) };
        Ok(())
    }
}

/// Whether it is a bar that may open and close.
fn is_bar(token: Option<&Token>) -> bool {
    match token {
        Some(Token::Char('|')) => true,
        Some(Token::Command(name)) => name == "vert",
        _ => false,
    }
}

/// A number that is no fraction.
fn digits(part: &Part) -> Option<String> {
    (part.literal && !part.text.contains('/')).then(|| part.text.clone())
}
