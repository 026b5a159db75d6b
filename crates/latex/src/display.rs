//! Displayed formulas as equations, each with its number.

use std::collections::BTreeMap;

use crate::formula::strip;
use crate::macros::Macros;
use crate::source::{Block, Shown, Source};
use crate::token::{Token, tokens};
use crate::unreadable::Unreadable;

/// An equation of a paper.
#[derive(Clone, Debug)]
pub(crate) struct Equation {
    /// the number that is printed beside it; `None` if there is none
    pub(crate) number: Option<String>,
    /// what is printed, macros written out
    pub(crate) tokens: Vec<Token>,
    /// why the macros could not be written out
    pub(crate) fault: Option<Unreadable>,
    /// line of the display, from 1
    pub(crate) line: usize,
}

/// Gives equations their numbers, as LaTeX does.
#[derive(Clone, Debug, Default)]
pub(crate) struct Numbering {
    by_section: bool,
    section: usize,
    last: usize,
    /// within equations that share a number: how many there were
    shared: Option<usize>,
    /// the numbers by their labels
    pub(crate) labels: BTreeMap<String, String>,
}

impl Numbering {
    pub(crate) fn of(source: &Source) -> Self {
        Self { by_section: source.by_section, ..Self::default() }
    }

    /// Takes note of a heading, and of equations that share a number.
    pub(crate) fn pass(&mut self, block: &Block) {
        match block {
            Block::Heading(2, _) => {
                self.section += 1;
                if self.by_section {
                    self.last = 0;
                }
            }
            Block::Shared(true) => {
                self.last += 1;
                self.shared = Some(0);
            }
            Block::Shared(false) => self.shared = None,
            Block::Counter(value) => self.last = *value,
            _ => {}
        }
    }

    fn next(&mut self) -> String {
        let whole = match self.shared.as_mut() {
            Some(count) => {
                *count += 1;
                let letter =
                    u32::try_from(*count).ok().and_then(|n| char::from_u32(96 + n.min(26)));
                format!("{}{}", self.last, letter.unwrap_or('z'))
            }
            None => {
                self.last += 1;
                self.last.to_string()
            }
        };
        if self.by_section { format!("{}.{whole}", self.section) } else { whole }
    }

    /// The equations of a display.
    pub(crate) fn equations(
        &mut self,
        shown: &Shown,
        macros: &Macros,
        latex: bool,
    ) -> Vec<Equation> {
        let mut body = shown.body.as_str();
        if matches!(shown.environment.as_str(), "alignat" | "IEEEeqnarray") {
            // how many columns there are
            body = crate::token::braced(body.trim_start()).map_or(body, |(_, rest)| rest);
        }
        let found = tokens(body, latex);
        let (all, fault) = match macros.expand(&found) {
            Ok(all) => (all, None),
            Err(fault) => (found, Some(fault)),
        };
        let single = matches!(
            shown.environment.as_str(),
            "equation" | "multline" | "[" | "displaymath" | "math" | "dmath"
        );
        let mut rows: Vec<Equation> = Vec::new();
        let mut pending: Vec<Token> = Vec::new();
        let parts = if single { vec![all.as_slice()] } else { split(&all) };
        let last = parts.len();
        for (i, part) in parts.into_iter().enumerate() {
            let mut number = None;
            let mut unnumbered = !shown.numbered;
            let mut labels = Vec::new();
            let mut plain = Vec::new();
            for token in part {
                match token {
                    Token::Tag(tag) => number = Some(tag.trim_matches(['(', ')']).to_owned()),
                    Token::Label(key) => labels.push(key.clone()),
                    Token::Unnumbered => unnumbered = true,
                    other => plain.push(other.clone()),
                }
            }
            if number.is_none() && !shown.numbered {
                number = by_hand(&mut plain);
            }
            let plain = joined(&plain);
            if plain.is_empty() && number.is_none() && i + 1 == last && i > 0 {
                continue;
            }
            if number.is_none() && !unnumbered {
                number = Some(self.next());
            }
            for key in labels {
                if let Some(number) = &number {
                    self.labels.insert(key, number.clone());
                }
            }
            if begins_with_sign(&plain) {
                match rows.last_mut() {
                    // one formula in several lines, which has one number at most
                    Some(row) if row.number.is_none() || number.is_none() => {
                        row.tokens.extend(plain);
                        row.number = row.number.take().or(number);
                        continue;
                    }
                    Some(row) => pending = left_side(&row.tokens),
                    None => {}
                }
            }
            pending.extend(plain);
            let tokens = std::mem::take(&mut pending);
            rows.push(Equation { number, tokens, fault: fault.clone(), line: shown.line });
        }
        rows.retain(|row| !strip(&row.tokens).is_empty());
        rows
    }
}

/// Takes away a number that stands behind a formula as a part of it, `x = y \qquad (28)`.
fn by_hand(row: &mut Vec<Token>) -> Option<String> {
    let close = row.len().checked_sub(1)?;
    let open = row.iter().rposition(|token| *token == Token::Char('('))?;
    let digit = |token: &Token| match token {
        Token::Char(c) if c.is_ascii_digit() => Some(*c),
        _ => None,
    };
    let number: Option<String> = row.get(open + 1..close)?.iter().map(digit).collect();
    let spaced = row.get(open.checked_sub(1)?) == Some(&Token::Quad);
    let number = number.filter(|number| {
        !number.is_empty() && spaced && row.get(close) == Some(&Token::Char(')'))
    })?;
    row.truncate(open);
    Some(number)
}

/// The rows of a display.
fn split(all: &[Token]) -> Vec<&[Token]> {
    let (mut rows, mut depth, mut start) = (Vec::new(), 0usize, 0);
    for (at, token) in all.iter().enumerate() {
        match token {
            Token::Begin(_) | Token::Open => depth += 1,
            Token::End(_) | Token::Close => depth = depth.saturating_sub(1),
            Token::Row if depth == 0 => {
                rows.push(&all[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    rows.push(&all[start..]);
    rows
}

fn is_block(name: &str) -> bool {
    matches!(name, "aligned" | "split" | "gathered" | "alignedat")
}

/// One formula of the lines that it is printed in: what begins with a sign goes on, the rest is listed.
fn joined(all: &[Token]) -> Vec<Token> {
    let inside: Vec<Token> = all
        .iter()
        .filter(|token| !matches!(token, Token::Begin(name) | Token::End(name) if is_block(name)))
        .filter(|token| **token != Token::Column || in_environment(all))
        .cloned()
        .collect();
    let mut out: Vec<Token> = Vec::new();
    for row in split(&inside) {
        if strip(row).is_empty() {
            continue;
        }
        if !out.is_empty() && !begins_with_sign(row) && !ends_with_sign(&out) {
            out = strip(&out).to_vec();
            out.push(Token::Char(','));
        }
        out.extend(row.iter().cloned());
    }
    strip(&out).to_vec()
}

/// Whether columns may belong to cases or a matrix inside.
fn in_environment(all: &[Token]) -> bool {
    all.iter().any(|token| matches!(token, Token::Begin(name) if !is_block(name)))
}

fn is_sign(token: &Token) -> bool {
    match token {
        Token::Char(c) => matches!(c, '=' | '<' | '>' | '+' | '-' | '−' | '≤' | '≥' | '/'),
        Token::Command(name) => matches!(
            name.as_str(),
            "le" | "leq"
                | "ge"
                | "geq"
                | "ne"
                | "neq"
                | "equiv"
                | "cdot"
                | "times"
                | "leqslant"
                | "geqslant"
                | "approx"
                | "to"
                | "lt"
                | "gt"
                | "pm"
        ),
        _ => false,
    }
}

fn begins_with_sign(row: &[Token]) -> bool {
    row.iter().find(|t| !matches!(t, Token::Column | Token::Quad)).is_some_and(is_sign)
}

fn ends_with_sign(row: &[Token]) -> bool {
    row.iter().rev().find(|t| !matches!(t, Token::Column | Token::Quad)).is_some_and(is_sign)
}

/// What stands before the first comparison.
fn left_side(row: &[Token]) -> Vec<Token> {
    let mut depth = 0usize;
    let compares = |token: &Token| {
        is_sign(token)
            && !matches!(token, Token::Char('+' | '-' | '−' | '/'))
            && !matches!(token, Token::Command(name) if matches!(name.as_str(), "cdot" | "times" | "pm"))
    };
    let end = row.iter().position(|token| {
        match token {
            Token::Open | Token::Begin(_) => depth += 1,
            Token::Close | Token::End(_) => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0 && compares(token)
    });
    row[..end.unwrap_or(0)].to_vec()
}
