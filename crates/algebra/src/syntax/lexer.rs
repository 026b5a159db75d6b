//! From characters to tokens, one at a time and without memory of its own.

use std::ops::Range;

use kane_kernel::Rel;

use super::names::{is_name_part, is_name_start};

/// A lexical unit. Text and place are kept beside it, as a byte range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Token {
    /// `12` or `0.4`
    Number,
    /// a run of characters that starts like a number and is none, such as `1.2.3` or `2a`
    BadNumber,
    /// a name or a reserved word
    Name,
    /// `+`
    Plus,
    /// `-` or `−`
    Minus,
    /// `*`
    Star,
    /// `/`
    Slash,
    /// `^`
    Caret,
    /// `(`
    OpenParen,
    /// `)`
    CloseParen,
    /// `{`
    OpenBrace,
    /// `}`
    CloseBrace,
    /// `,`
    Comma,
    /// `;`
    Semicolon,
    /// `:`
    Colon,
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
        ('<', Some('=')) => two(Token::Rel(Rel::Le)),
        ('>', Some('=')) => two(Token::Rel(Rel::Ge)),
        ('!', Some('=')) => two(Token::Rel(Rel::Ne)),
        ('+', _) => one(Token::Plus),
        ('-' | '−', _) => one(Token::Minus),
        ('*', _) => one(Token::Star),
        ('/', _) => one(Token::Slash),
        ('^', _) => one(Token::Caret),
        ('(', _) => one(Token::OpenParen),
        (')', _) => one(Token::CloseParen),
        ('{', _) => one(Token::OpenBrace),
        ('}', _) => one(Token::CloseBrace),
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
    let run = rest.find(|c: char| !is_name_part(c) && c != '.').unwrap_or(rest.len());
    let text = rest.get(..run).unwrap_or_default();
    let digits = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
    let well_formed = match text.split_once('.') {
        Some((whole, fraction)) => digits(whole) && digits(fraction),
        None => digits(text),
    };
    let token = if well_formed { Token::Number } else { Token::BadNumber };
    (token, start..start + run)
}

fn name(rest: &str, start: usize) -> (Token, Range<usize>) {
    let run = rest.find(|c| !is_name_part(c)).unwrap_or(rest.len());
    let token = match rest.get(..run) {
        Some("oo") => Token::Infinity,
        _ => Token::Name,
    };
    (token, start..start + run)
}
