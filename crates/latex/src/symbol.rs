//! Symbols in a formula: their subscripts, marks and primes, and whether a bracket behind them is a factor.

use crate::formula::Reader;
use crate::name::{Names, part};
use crate::part::{Part, is_name};
use crate::token::{Token, written};
use crate::unreadable::Unreadable;

impl Reader<'_> {
    /// A name with its subscripts, marks and primes, and the argument of a function.
    pub(crate) fn name(
        &mut self,
        base: String,
        vector: bool,
        mut spelled: String,
    ) -> Result<Part, Unreadable> {
        let mut name = base;
        let mut primes = 0;
        loop {
            match (self.peek(), self.tokens.get(self.at + 1)) {
                (Some(Token::Subscript), _) => {
                    self.at += 1;
                    let group = self.group()?;
                    if self.goes_on(group) {
                        return Err(Unreadable::Ambiguous(format!("{name}_{}…", written(group))));
                    }
                    name = format!("{name}_{}", part(group)?);
                    spelled = format!("{spelled}_{}", unbraced(group));
                }
                (Some(Token::Char('\'' | '′' | '’')), _) => {
                    self.at += 1;
                    primes += 1;
                }
                (Some(Token::Superscript), Some(_)) => {
                    let back = self.at;
                    self.at += 1;
                    let group = self.group()?;
                    let prime = |t: &Token| *t == Token::Command("prime".to_owned());
                    if !group.is_empty() && group.iter().all(prime) {
                        primes += group.len();
                    } else if is_mark(group) {
                        name = format!("{name}_{}", part(group)?);
                        spelled = format!("{spelled}^{}", unbraced(group));
                    } else {
                        self.at = back;
                        break;
                    }
                }
                _ => break,
            }
        }
        if name == "d" && primes == 0 {
            // d(f, x) is a derivative in the language; a letter alone is mostly a distance
            name = "dist".to_owned();
        }
        name.push_str(&"'".repeat(primes));
        if self.names.functions.contains(&name) && self.peek() == Some(&Token::Char('(')) {
            self.at += 1;
            let mut arguments = vec![self.sum()?.text];
            while self.takes_char(',') {
                arguments.push(self.sum()?.text);
            }
            if !self.takes_char(')') {
                return Err(Unreadable::Missing("a closing bracket"));
            }
            return Ok(Part::atom(format!("{name}({})", arguments.join(", "))));
        }
        spelled.push_str(&"'".repeat(primes));
        self.names.meet(&name, vector, &spelled)?;
        let of_time = [Token::Char('('), Token::Char('t'), Token::Char(')')];
        if self.tokens[self.at.min(self.tokens.len())..].starts_with(&of_time) {
            self.at += 3;
            self.names.meet("t", false, "t")?;
            self.names.varies(&name);
        } else if self.applies() {
            return Err(Unreadable::Ambiguous(format!("{name}(…)")));
        }
        Ok(Part { vector, ..Part::atom(name) })
    }

    /// Whether a bracket follows that may hold an argument as well as a factor: one symbol, a number, or a
    /// list.
    fn applies(&self) -> bool {
        let rest = &self.tokens[self.at.min(self.tokens.len())..];
        let [Token::Char('('), inside @ ..] = rest else { return false };
        let mut depth = 0usize;
        let end = inside.iter().position(|token| {
            match token {
                Token::Char('(') => depth += 1,
                Token::Char(')') if depth == 0 => return true,
                Token::Char(')') => depth -= 1,
                _ => {}
            }
            false
        });
        let inside = &inside[..end.unwrap_or(inside.len())];
        if inside.contains(&Token::Char(',')) {
            return true;
        }
        let mut names = Names::default();
        let mut reader = Reader::new(inside, &mut names);
        let alone = reader.factor();
        reader.peek().is_none()
            && alone.is_ok_and(|part| {
                is_name(&part) || part.text.chars().all(|c| c.is_ascii_digit() || c == '.')
            })
    }

    /// A name with a hat, a bar or the like.
    pub(crate) fn marked(&mut self, mark: &str) -> Result<Part, Unreadable> {
        let group = self.group()?;
        let base = part(group)?;
        self.name(format!("{base}_{mark}"), false, format!("\\{mark}{{{base}}}"))
    }
}

/// Whether a superscript is a mark of a name and no exponent.
fn is_mark(group: &[Token]) -> bool {
    match group {
        [Token::Char('+' | '-' | '−' | '*')] => true,
        [Token::Char('('), inside @ .., Token::Char(')')] => !inside.is_empty(),
        [Token::Command(name)] => matches!(name.as_str(), "ast" | "star"),
        [Token::Words(_)] | [Token::Upright(_)] => true,
        _ => false,
    }
}

/// A subscript or a mark as it is written, braces aside.
fn unbraced(group: &[Token]) -> String {
    let plain: Vec<Token> =
        group.iter().filter(|t| !matches!(t, Token::Open | Token::Close)).cloned().collect();
    written(&plain)
}
