//! A small reader of Coq's terms over the reals, by the levels of its manual: application binds most
//! tightly, then `^`, a sign, `*` and `/`, `+` and `-`; `if` reaches as far as it can.

use std::collections::HashMap;

use num_traits::{One, Zero};

use crate::support::Q;

/// The value of a term: `None` where a denominator is zero or a root is not rational. A function
/// stands for its value, whatever it is applied to.
pub(super) fn value(text: &str, values: &HashMap<String, Q>) -> Result<Option<Q>, String> {
    let mut reader = Reader { words: words(text), at: 0, values };
    let value = reader.sum()?;
    if reader.at < reader.words.len() {
        return Err(format!("{:?} is left of {text}", &reader.words[reader.at..]));
    }
    Ok(value)
}

fn words(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut open = false;
    for c in text.chars() {
        let part = c.is_alphanumeric() || c == '_' || c == '\'';
        match words.last_mut() {
            Some(word) if part && open => word.push(c),
            _ if c.is_whitespace() => {}
            _ => words.push(c.to_string()),
        }
        open = part;
    }
    words
}

struct Reader<'a> {
    words: Vec<String>,
    at: usize,
    values: &'a HashMap<String, Q>,
}

type Value = Result<Option<Q>, String>;

impl Reader<'_> {
    fn peek(&self) -> &str {
        self.words.get(self.at).map_or("", String::as_str)
    }

    fn accept(&mut self, word: &str) -> bool {
        let found = self.peek() == word;
        self.at += usize::from(found);
        found
    }

    fn expect(&mut self, word: &str) -> Result<(), String> {
        if self.accept(word) { Ok(()) } else { Err(format!("{} where {word} is due", self.peek())) }
    }

    fn sum(&mut self) -> Value {
        let mut left = self.product()?;
        loop {
            let minus = self.peek() == "-";
            if !minus && self.peek() != "+" {
                return Ok(left);
            }
            self.at += 1;
            let right = self.product()?;
            left = left.zip(right).map(|(a, b)| if minus { a - b } else { a + b });
        }
    }

    fn product(&mut self) -> Value {
        let mut left = self.signed()?;
        loop {
            let by = self.peek() == "/";
            if !by && self.peek() != "*" {
                return Ok(left);
            }
            self.at += 1;
            let right = self.signed()?;
            left = match (left, right) {
                (Some(_), Some(b)) if by && b.is_zero() => None,
                (Some(a), Some(b)) => Some(if by { a / b } else { a * b }),
                _ => None,
            };
        }
    }

    fn signed(&mut self) -> Value {
        if self.accept("-") {
            return Ok(self.signed()?.map(|a| -a));
        }
        self.power()
    }

    fn power(&mut self) -> Value {
        let base = self.application()?;
        if !self.accept("^") {
            return Ok(base);
        }
        let digits = self.peek().to_owned();
        self.at += 1;
        let exponent: u32 = digits.parse().map_err(|e| format!("{digits}: {e}"))?;
        if self.peek() == "^" {
            return Err("a tower".to_owned());
        }
        Ok(base.map(|a| (0..exponent).fold(Q::one(), |product, _| product * &a)))
    }

    fn argument(&mut self) -> Value {
        if self.accept("(") {
            let value = self.sum()?;
            self.expect(")")?;
            return Ok(value);
        }
        let word = self.peek().to_owned();
        self.at += 1;
        if let Ok(value) = word.parse() {
            return Ok(Some(value));
        }
        self.values.get(&word).cloned().map(Some).ok_or_else(|| format!("unknown: {word}"))
    }

    fn application(&mut self) -> Value {
        if self.accept("if") {
            return self.choice();
        }
        let f = self.peek().to_owned();
        let two = ["Rmin", "Rmax"].contains(&f.as_str());
        if two || ["Rabs", "sqrt"].contains(&f.as_str()) {
            self.at += 1;
            let a = self.argument()?;
            if !two {
                return Ok(a.and_then(|a| if f == "sqrt" { root(&a) } else { Some(abs(a)) }));
            }
            let b = self.argument()?;
            return Ok(a.zip(b).map(|(a, b)| if (a < b) == (f == "Rmin") { a } else { b }));
        }
        let value = self.argument()?;
        // a function, applied
        if f == "E" {
            self.argument()?;
        }
        Ok(value)
    }

    /// `if DEC a b then … else …`; only the branch that is taken has to have a value.
    fn choice(&mut self) -> Value {
        let decide = self.peek().to_owned();
        self.at += 1;
        let (a, b) = (self.argument()?, self.argument()?);
        self.expect("then")?;
        let then = self.sum()?;
        self.expect("else")?;
        let otherwise = self.sum()?;
        let Some((a, b)) = a.zip(b) else { return Ok(None) };
        let holds = match decide.as_str() {
            "Req_EM_T" => a == b,
            "Rlt_dec" => a < b,
            "Rle_dec" => a <= b,
            "Rgt_dec" => a > b,
            "Rge_dec" => a >= b,
            other => return Err(format!("no decision: {other}")),
        };
        Ok(if holds { then } else { otherwise })
    }
}

fn abs(a: Q) -> Q {
    if a < Q::zero() { -a } else { a }
}

/// The root, if it is rational.
fn root(a: &Q) -> Option<Q> {
    if *a < Q::zero() {
        return None;
    }
    let root = Q::new(a.numer().sqrt(), a.denom().sqrt());
    (&root * &root == *a).then_some(root)
}
