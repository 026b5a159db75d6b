//! Macros of a source: `\newcommand`, `\def`, `\DeclareMathOperator`.

use std::collections::BTreeMap;

use crate::token::{Token, braced, tokens};
use crate::unreadable::Unreadable;

/// Tokens that a formula may come to.
const MOST: usize = 20_000;
/// Tokens that macros and their arguments may move on the way: long arguments move again in each macro around them.
const MOVED: usize = 20 * MOST;
/// Arguments that a macro may have in TeX.
const ARGUMENTS: usize = 9;

/// What commands stand for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Macros(BTreeMap<String, Macro>);

#[derive(Clone, Debug)]
struct Macro {
    arguments: usize,
    body: Vec<Token>,
}

impl Macros {
    /// Reads the definition behind `\name`, if that is what defines macros; what follows it.
    pub(crate) fn define<'a>(&mut self, name: &str, rest: &'a str) -> Option<&'a str> {
        let rest = rest.strip_prefix('*').unwrap_or(rest).trim_start();
        let (defined, rest) = match name {
            "newcommand" | "renewcommand" | "providecommand" | "DeclareMathOperator" => {
                match braced(rest) {
                    Some((inside, rest)) => (inside.trim(), rest),
                    None => command(rest)?,
                }
            }
            "def" => command(rest)?,
            _ => return None,
        };
        let defined = defined.strip_prefix('\\')?;
        let mut rest = rest.trim_start();
        let mut arguments = 0;
        if let Some(inside) = rest.strip_prefix('[') {
            let end = inside.find(']')?;
            arguments = inside[..end].trim().parse().ok()?;
            rest = inside[end + 1..].trim_start();
        }
        while let Some(parameter) = rest.strip_prefix('#') {
            arguments += 1;
            rest = parameter.get(1..)?;
        }
        if arguments > ARGUMENTS {
            return None;
        }
        let (body, rest) = braced(rest)?;
        let body = match name {
            "DeclareMathOperator" => tokens(&format!("\\operatorname{{{body}}}"), true),
            _ => tokens(body, true),
        };
        self.0.insert(defined.to_owned(), Macro { arguments, body });
        Some(rest)
    }

    /// The tokens with all macros written out.
    ///
    /// # Errors
    /// [`Unreadable::Macros`] if that is too much, as it is of a macro that stands for itself.
    pub(crate) fn expand(&self, all: &[Token]) -> Result<Vec<Token>, Unreadable> {
        let mut out = Vec::new();
        // what is still to be read, last first
        let mut todo: Vec<Token> = all.iter().rev().cloned().collect();
        let (mut steps, mut moved) = (0, 0);
        while let Some(token) = todo.pop() {
            steps += 1;
            if steps > MOST || todo.len() > MOST {
                return Err(Unreadable::Macros(MOST));
            }
            let known = match &token {
                Token::Command(name) => self.0.get(name),
                _ => None,
            };
            let Some(known) = known else {
                out.push(token);
                continue;
            };
            let arguments: Vec<Vec<Token>> =
                (0..known.arguments).map(|_| argument(&mut todo)).collect();
            let mut written = Vec::new();
            let mut body = known.body.iter();
            while let Some(token) = body.next() {
                match token {
                    Token::Char('#') => {
                        let place = match body.next() {
                            Some(Token::Char(digit)) => digit.to_digit(10).map(|n| n as usize),
                            _ => None,
                        };
                        let value = place.and_then(|n| arguments.get(n.checked_sub(1)?));
                        written.extend(value.into_iter().flatten().cloned());
                    }
                    other => written.push(other.clone()),
                }
            }
            moved += arguments.iter().map(Vec::len).sum::<usize>() + written.len();
            if moved > MOVED {
                return Err(Unreadable::Macros(MOST));
            }
            todo.extend(written.into_iter().rev());
        }
        Ok(out)
    }
}

/// `\name` at the beginning, and what follows.
fn command(text: &str) -> Option<(&str, &str)> {
    let letters = text.strip_prefix('\\')?;
    let end = letters.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(letters.len());
    (end > 0).then(|| text.split_at(end + 1))
}

/// Takes the next group, or the next token.
fn argument(todo: &mut Vec<Token>) -> Vec<Token> {
    match todo.pop() {
        Some(Token::Open) => {
            let (mut depth, mut out) = (1, Vec::new());
            while let Some(token) = todo.pop() {
                match token {
                    Token::Open => depth += 1,
                    Token::Close => depth -= 1,
                    _ => {}
                }
                if depth == 0 {
                    break;
                }
                out.push(token);
            }
            out
        }
        Some(token) => vec![token],
        None => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::token::written;

    fn expanded(definitions: &[(&str, &str)], text: &str) -> Result<String, Unreadable> {
        let mut macros = Macros::default();
        for (name, rest) in definitions {
            assert_eq!(macros.define(name, rest), Some(""));
        }
        macros.expand(&tokens(text, true)).map(|all| written(&all))
    }

    #[test]
    fn macros_are_written_out() {
        let definitions = [
            ("newcommand", "{\\vp}{v^{+}}"),
            ("newcommand", "{\\half}[1]{\\frac{#1}{2}}"),
            ("def", "\\twice#1{2 #1}"),
        ];
        assert_eq!(expanded(&definitions, "\\half{m\\vp}").unwrap(), "\\frac{mv^{+}}{2}");
        assert_eq!(expanded(&definitions, "\\twice x").unwrap(), "2x");
    }

    #[test]
    fn a_macro_that_stands_for_itself_is_refused() {
        let definitions = [("def", "\\a{\\a\\a}")];
        assert_eq!(expanded(&definitions, "\\a"), Err(Unreadable::Macros(MOST)));
    }

    /// Room for all of them was asked for before they were looked for.
    #[test]
    fn a_macro_of_more_arguments_than_tex_allows_is_none() {
        let mut macros = Macros::default();
        assert_eq!(macros.define("newcommand", "{\\post}[11111111111]{#1^{+}}"), None);
        assert_eq!(macros.define("def", "\\a#1#2#3#4#5#6#7#8#9#1{#1}"), None);
        assert_eq!(macros.define("newcommand", "{\\post}[9]{#9^{+}}"), Some(""));
    }

    /// Its arguments grow, and each step copies them: that took longer than ten seconds.
    #[test]
    fn a_macro_that_takes_itself_for_an_argument_is_refused_before_it_has_copied_much() {
        let definitions = [("newcommand", "{\\f}[2]{\\f{\\partial #1}{\\partial #2}}")];
        assert_eq!(expanded(&definitions, "\\f{a}{b}"), Err(Unreadable::Macros(MOST)));
    }
}
