//! Names of symbols: from letters, subscripts and marks to words of the language.

use std::collections::{BTreeMap, BTreeSet};

use kane_algebra::syntax::{RESERVED, greek_letter};

use crate::token::Token;
use crate::unreadable::Unreadable;

/// The name of a command that is a letter; π is a number.
pub(crate) fn letter(command: &str) -> Option<&str> {
    let plain = match command {
        "varepsilon" => "epsilon",
        "vartheta" => "theta",
        "varphi" => "phi",
        "varrho" => "rho",
        "varsigma" => "sigma",
        "ell" | "hbar" => return Some(command),
        "pi" | "varpi" => return None,
        other => other,
    };
    greek_letter(plain).map(|_| plain)
}

/// A symbol of a paper.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// as the language writes it
    pub name: String,
    /// whether it is set as a vector or a matrix
    pub vector: bool,
    /// whether it is differentiated by t, or written with t as its argument
    pub of_time: bool,
}

/// The symbols of a paper, in the order in which they come.
#[derive(Clone, Debug, Default)]
pub struct Names {
    symbols: Vec<Symbol>,
    /// how each name is written in LaTeX: two symbols do not become one
    spellings: BTreeMap<String, String>,
    /// names that are defined with arguments, `f(x) = …`
    pub(crate) functions: BTreeSet<String>,
    /// those of them whose definition is read
    pub(crate) defined: BTreeSet<String>,
    /// what the sums run over that are read
    pub(crate) over: Vec<String>,
    /// parameters of the definition that is read
    pub(crate) parameters: Vec<String>,
}

impl Names {
    /// The symbols, in the order in which they come.
    #[must_use]
    pub fn symbols(&self) -> &[Symbol] {
        &self.symbols
    }

    /// How a symbol is written in LaTeX.
    pub(crate) fn spelled(&self, name: &str) -> String {
        self.spellings.get(name).cloned().unwrap_or_else(|| name.to_owned())
    }

    /// Takes note of a symbol.
    pub(crate) fn meet(
        &mut self,
        name: &str,
        vector: bool,
        spelled: &str,
    ) -> Result<(), Unreadable> {
        if RESERVED.contains(&name) {
            return Err(Unreadable::Reserved(name.to_owned()));
        }
        let bound = self.parameters.iter().chain(&self.over).any(|known| known == name);
        if bound || self.functions.contains(name) {
            return Ok(());
        }
        let first = self.spellings.entry(name.to_owned()).or_insert_with(|| spelled.to_owned());
        if first != spelled {
            return Err(Unreadable::SameName(first.clone(), spelled.to_owned()));
        }
        match self.symbols.iter().find(|known| known.name == name) {
            None => self.symbols.push(Symbol { name: name.to_owned(), vector, of_time: false }),
            Some(known) if known.vector == vector => {}
            Some(_) => return Err(Unreadable::Mixed(format!("`{name}` is both"))),
        }
        Ok(())
    }

    /// Takes note that a symbol varies with t.
    pub(crate) fn varies(&mut self, name: &str) {
        if let Some(symbol) = self.symbols.iter_mut().find(|symbol| symbol.name == name) {
            symbol.of_time = true;
        }
    }

    /// The symbols met so far, to go back to if a formula cannot be read.
    pub(crate) fn mark(&self) -> Vec<Symbol> {
        self.symbols.clone()
    }

    /// Back to an earlier state.
    pub(crate) fn back(&mut self, mark: Vec<Symbol>) {
        self.symbols = mark;
    }
}

/// What a subscript or a mark adds to a name: letters and digits.
pub(crate) fn part(tokens: &[Token]) -> Result<String, Unreadable> {
    let sign = match tokens {
        [Token::Char('+')] => Some("plus"),
        [Token::Char('-' | '−')] => Some("minus"),
        [Token::Char('*')] => Some("star"),
        _ => None,
    };
    if let Some(sign) = sign {
        return Ok(sign.to_owned());
    }
    let mut out = String::new();
    for token in tokens {
        match token {
            Token::Char(c) if c.is_ascii_alphanumeric() => out.push(*c),
            Token::Char(',' | '.' | '(' | ')') | Token::Open | Token::Close | Token::Subscript => {}
            Token::Words(word) | Token::Upright(word) => {
                out.extend(word.chars().filter(char::is_ascii_alphanumeric));
            }
            Token::Command(name) => out.push_str(match name.as_str() {
                "infty" => "inf",
                "perp" | "bot" => "perp",
                "parallel" | "|" => "par",
                "ast" | "star" => "star",
                "prime" => "prime",
                "pi" => "pi",
                "max" => "max",
                "min" => "min",
                other => letter(other).ok_or(Unreadable::Subscript)?,
            }),
            _ => return Err(Unreadable::Subscript),
        }
    }
    if out.is_empty() { Err(Unreadable::Subscript) } else { Ok(out) }
}
