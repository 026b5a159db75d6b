//! From characters to tokens, one at a time and without memory of its own.

use std::ops::Range;

use kane_kernel::Rel;

use super::letters::{is_name_part, is_name_start};

/// A lexical unit. Text and place are kept beside it, as a byte range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Token {
    /// `12`, `0.4` or `1e-3`
    Number,
    /// a run of characters that starts like a number and is none, such as `1.2.3` or `2a`
    BadNumber,
    /// a name or a reserved word
    Name,
    /// `+`
    Plus,
    /// `-` or `−`
    Minus,
    /// `*`, `·`, `⋅` or `×`
    Star,
    /// `/`
    Slash,
    /// `^`
    Caret,
    /// an exponent in raised digits, such as `²` or `⁻¹`
    Superscript,
    /// `|`
    Bar,
    /// `(`
    OpenParen,
    /// `)`
    CloseParen,
    /// `{`
    OpenBrace,
    /// `}`
    CloseBrace,
    /// `[`
    OpenBracket,
    /// `]`
    CloseBracket,
    /// `,`
    Comma,
    /// `;`
    Semicolon,
    /// `:`
    Colon,
    /// `..`
    Dots,
    /// `:=`
    Define,
    /// `->` or `→`
    Arrow,
    /// a comparison
    Rel(Rel),
    /// `oo` or `∞`
    Infinity,
    /// a character that belongs to no token
    Stray(char),
    /// nothing is left
    End,
}

impl Token {
    /// Whether it opens a bracket of any kind.
    pub(crate) const fn opens(self) -> bool {
        matches!(self, Self::OpenParen | Self::OpenBracket | Self::OpenBrace)
    }

    /// Whether it closes one.
    pub(crate) const fn closes(self) -> bool {
        matches!(self, Self::CloseParen | Self::CloseBracket | Self::CloseBrace)
    }
}

/// The token at or after byte `from` and its byte range; white space and comments are passed over.
pub(crate) fn next(text: &str, from: usize) -> (Token, Range<usize>) {
    let start = skip_blank(text, from);
    let rest = text.get(start..).unwrap_or_default();
    let mut chars = rest.chars();
    let Some(first) = chars.next() else {
        return (Token::End, start..start);
    };
    let second = chars.next();
    let one = |token| (token, start..start + first.len_utf8());
    // every two-character token is ASCII
    let two = |token| (token, start..start + 2);
    match (first, second) {
        ('-', Some('>')) => two(Token::Arrow),
        (':', Some('=')) => two(Token::Define),
        ('.', Some('.')) => two(Token::Dots),
        ('<', Some('=')) => two(Token::Rel(Rel::Le)),
        ('>', Some('=')) => two(Token::Rel(Rel::Ge)),
        ('!', Some('=')) => two(Token::Rel(Rel::Ne)),
        ('+', _) => one(Token::Plus),
        ('-' | '−', _) => one(Token::Minus),
        ('*' | '·' | '⋅' | '×', _) => one(Token::Star),
        ('/', _) => one(Token::Slash),
        ('^', _) => one(Token::Caret),
        ('|', _) => one(Token::Bar),
        ('(', _) => one(Token::OpenParen),
        (')', _) => one(Token::CloseParen),
        ('{', _) => one(Token::OpenBrace),
        ('}', _) => one(Token::CloseBrace),
        ('[', _) => one(Token::OpenBracket),
        (']', _) => one(Token::CloseBracket),
        (',', _) => one(Token::Comma),
        (';', _) => one(Token::Semicolon),
        (':', _) => one(Token::Colon),
        ('→', _) => one(Token::Arrow),
        ('=', _) => one(Token::Rel(Rel::Eq)),
        ('≠', _) => one(Token::Rel(Rel::Ne)),
        ('<', _) => one(Token::Rel(Rel::Lt)),
        ('>', _) => one(Token::Rel(Rel::Gt)),
        ('≤', _) => one(Token::Rel(Rel::Le)),
        ('≥', _) => one(Token::Rel(Rel::Ge)),
        ('∞', _) => one(Token::Infinity),
        ('.' | '0'..='9', _) => number(rest, start),
        _ if is_superscript(first) => superscript(rest, start),
        _ if is_name_start(first) => name(rest, start),
        _ => one(Token::Stray(first)),
    }
}

fn skip_blank(text: &str, from: usize) -> usize {
    let mut at = from;
    loop {
        let rest = text.get(at..).unwrap_or_default();
        let trimmed = rest.trim_start();
        at += rest.len() - trimmed.len();
        if !trimmed.starts_with('#') {
            return at;
        }
        at += trimmed.find(['\n', '\r']).unwrap_or(trimmed.len());
    }
}

fn number(rest: &str, start: usize) -> (Token, Range<usize>) {
    let run = |text: &str| {
        let end = text.find(|c| !is_name_part(c) && c != '.').unwrap_or(text.len());
        // a range, as in `1..n`
        text.get(..end).and_then(|run| run.find("..")).unwrap_or(end)
    };
    let mut end = run(rest);
    let part = rest.get(..end).unwrap_or_default();
    // the sign of an exponent: nothing else ends like a number and one `e`
    let mantissa = part.strip_suffix(['e', 'E']).is_some_and(is_decimal);
    let behind = rest.get(end..).unwrap_or_default();
    if let Some(digits) = behind.strip_prefix(['+', '-']).filter(|_| mantissa)
        && digits.starts_with(|c: char| c.is_ascii_digit())
    {
        end += 1 + run(digits);
    }
    let text = rest.get(..end).unwrap_or_default();
    let well_formed = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => {
            is_decimal(mantissa) && is_digits(exponent.strip_prefix(['+', '-']).unwrap_or(exponent))
        }
        None => is_decimal(text),
    };
    let token = if well_formed { Token::Number } else { Token::BadNumber };
    (token, start..start + end)
}

fn is_decimal(text: &str) -> bool {
    match text.split_once('.') {
        Some((whole, fraction)) => is_digits(whole) && is_digits(fraction),
        None => is_digits(text),
    }
}

fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}

fn is_superscript(c: char) -> bool {
    c == '⁻' || plain_digit(c).is_some()
}

/// The digit that a raised digit stands for.
pub(super) fn plain_digit(raised: char) -> Option<char> {
    let at = "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|c| c == raised)?;
    char::from_digit(u32::try_from(at).ok()?, 10)
}

fn superscript(rest: &str, start: usize) -> (Token, Range<usize>) {
    let run = rest.find(|c| !is_superscript(c)).unwrap_or(rest.len());
    (Token::Superscript, start..start + run)
}

fn name(rest: &str, start: usize) -> (Token, Range<usize>) {
    let run = rest.find(|c| !is_name_part(c)).unwrap_or(rest.len());
    let token = match rest.get(..run) {
        Some("oo") => Token::Infinity,
        _ => Token::Name,
    };
    (token, start..start + run)
}
