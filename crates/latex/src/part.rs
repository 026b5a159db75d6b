//! Pieces of expressions in the language, put together with the parentheses that they need.

use crate::token::Token;
use crate::unreadable::Unreadable;

/// How tightly a text holds together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Level {
    Sum,
    Product,
    Power,
    Atom,
}

/// An expression that is written in the language.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub(crate) text: String,
    pub(crate) level: Level,
    pub(crate) vector: bool,
    /// a number as it stands
    pub(crate) literal: bool,
}

impl Part {
    pub(crate) fn new(text: impl Into<String>, level: Level) -> Self {
        Self { text: text.into(), level, vector: false, literal: false }
    }

    pub(crate) fn atom(text: impl Into<String>) -> Self {
        Self::new(text, Level::Atom)
    }

    /// The text, in parentheses unless it holds together as tightly as asked.
    pub(crate) fn at(&self, level: Level) -> String {
        if self.level >= level { self.text.clone() } else { format!("({})", self.text) }
    }

    pub(crate) fn number(self) -> Result<Self, Unreadable> {
        if self.vector { Err(Unreadable::Mixed(self.text)) } else { Ok(self) }
    }
}

pub(crate) fn one() -> Part {
    Part::atom("1")
}

pub(crate) fn times(a: &Part, b: &Part) -> Result<Part, Unreadable> {
    let text = format!("{}*{}", a.at(Level::Product), b.at(Level::Power));
    Ok(Part { vector: a.vector || b.vector, ..Part::new(text, Level::Product) })
}

pub(crate) fn over(a: &Part, b: &Part) -> Part {
    let text = format!("{}/{}", a.at(Level::Product), b.at(Level::Power));
    Part { vector: a.vector, ..Part::new(text, Level::Product) }
}

/// base^exponent: integers, and halves of odd ones as roots.
pub(crate) fn power(base: &Part, exponent: &[Token]) -> Result<Part, Unreadable> {
    let mut text = String::new();
    let mut fraction = false;
    for token in exponent {
        match token {
            Token::Char(c) if c.is_ascii_digit() || matches!(c, '-' | '/') => text.push(*c),
            Token::Char('−') => text.push('-'),
            Token::Open if matches!(text.trim(), "" | "-") => text.push(' '),
            // digits in braces behind digits are more of them
            Token::Open if fraction => text.push('/'),
            Token::Close => {}
            Token::Command(name) if matches!(name.as_str(), "frac" | "tfrac" | "dfrac") => {
                fraction = true;
            }
            _ => return Err(Unreadable::Exponent),
        }
    }
    let text = text.replace(' ', "");
    // `\frac12` has no braces
    let bare = exponent.iter().any(|t| matches!(t, Token::Command(_)));
    let text = match (bare, text.contains('/'), text.len()) {
        (true, false, 2) => format!("{}/{}", &text[..1], &text[1..]),
        (true, false, _) => return Err(Unreadable::Exponent),
        _ => text,
    };
    let (above, below) = match text.split_once('/') {
        Some((above, below)) => (above, below),
        None => (text.as_str(), "1"),
    };
    let n: i32 = above.parse().map_err(|_| Unreadable::Exponent)?;
    let root = format!("sqrt({})", base.text);
    match (below, n) {
        ("1", _) => Ok(Part::new(format!("{}^{n}", base.at(Level::Atom)), Level::Power)),
        ("2", 1) => Ok(Part::atom(root)),
        ("2", _) if n % 2 != 0 => Ok(Part::new(format!("{root}^{n}"), Level::Power)),
        _ => Err(Unreadable::Exponent),
    }
}

/// Whether a part is a symbol alone.
pub(crate) fn is_name(part: &Part) -> bool {
    part.text.starts_with(char::is_alphabetic)
        && part.text.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '\''))
}
