//! A small reader of mathematics in LaTeX, written from how people read print, and not from how the
//! program writes it:
//!
//! - An exponent belongs to the one thing before it: a letter, a number, a closed pair of brackets.
//! - Things side by side are multiplied; a number directly before a number or a fraction is not.
//! - d/dx acts on everything that is multiplied behind it, up to a dot, a sign or a bracket.
//! - An exponent behind a prime, behind ΔE or behind the arguments of a function is of the end alone.
//! - A function's letter directly before a bracket is applied to it.
//! - `cases` reaches to the end of its formula, so that nothing may follow its rows but a comparison.

use std::collections::HashMap;
use std::rc::Rc;

use kane::kernel::{Approach, Expr, Limit, Link, Rel, Relation, Sentence, Target};
use num_rational::BigRational;

use crate::support::Q;

/// A letter, a command, a digit string, or one other character.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Token {
    Letter(char),
    Command(String),
    Number(String),
    Other(char),
    /// text set upright, such as `when`
    Words(String),
}

/// The symbols that a name in print stands for.
pub(super) struct Names {
    pub(super) symbols: HashMap<String, Expr>,
    /// those that are functions
    pub(super) functions: Vec<Expr>,
}

pub(super) type Read<T> = Result<T, String>;

pub(super) fn tokens(latex: &str) -> Read<Vec<Token>> {
    let mut out = Vec::new();
    let mut chars = latex.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            ' ' => {}
            '\\' => {
                let mut name = String::new();
                while let Some(letter) = chars.next_if(char::is_ascii_alphabetic) {
                    name.push(letter);
                }
                if name.is_empty() {
                    name.extend(chars.next());
                }
                match name.as_str() {
                    ";" | "quad" => {}
                    "text" => {
                        if chars.next() != Some('{') {
                            return Err("words without a brace".to_owned());
                        }
                        let words: String = chars.by_ref().take_while(|c| *c != '}').collect();
                        out.push(Token::Words(words.trim().to_owned()));
                    }
                    _ => out.push(Token::Command(name)),
                }
            }
            c if c.is_ascii_digit() => {
                let mut digits = c.to_string();
                while let Some(digit) = chars.next_if(|c| c.is_ascii_digit() || *c == '.') {
                    digits.push(digit);
                }
                out.push(Token::Number(digits));
            }
            c if c.is_ascii_alphabetic() => out.push(Token::Letter(c)),
            c => out.push(Token::Other(c)),
        }
    }
    Ok(out)
}

pub(super) struct Reader<'a> {
    tokens: Vec<Token>,
    at: usize,
    names: &'a Names,
    /// whether what was read last is of several parts, so that an exponent would not be of the whole
    joined: bool,
}

impl<'a> Reader<'a> {
    pub(super) fn new(tokens: Vec<Token>, names: &'a Names) -> Self {
        Self { tokens, at: 0, names, joined: false }
    }

    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.at)
    }

    fn next(&mut self) -> Option<Token> {
        let token = self.peek().cloned();
        self.at += 1;
        token
    }

    fn is(&self, c: char) -> bool {
        self.peek() == Some(&Token::Other(c))
    }

    fn is_command(&self, name: &str) -> bool {
        matches!(self.peek(), Some(Token::Command(n)) if n == name)
    }

    fn accept(&mut self, c: char) -> bool {
        let found = self.is(c);
        self.at += usize::from(found);
        found
    }

    fn accept_command(&mut self, name: &str) -> bool {
        let found = self.is_command(name);
        self.at += usize::from(found);
        found
    }

    fn accept_words(&mut self, words: &str) -> bool {
        let found = self.peek() == Some(&Token::Words(words.to_owned()));
        self.at += usize::from(found);
        found
    }

    fn fault<T>(&self, why: &str) -> Read<T> {
        let rest = self.tokens.get(self.at.saturating_sub(1)..).unwrap_or_default();
        Err(format!("{why} before {:?}", rest.iter().take(6).collect::<Vec<_>>()))
    }

    fn expect(&mut self, c: char) -> Read<()> {
        if self.accept(c) { Ok(()) } else { self.fault(&format!("no {c}")) }
    }

    fn expect_command(&mut self, name: &str) -> Read<()> {
        if self.accept_command(name) { Ok(()) } else { self.fault(&format!("no \\{name}")) }
    }

    pub(super) fn sentence(mut self) -> Read<Sentence> {
        let mut links = Vec::new();
        loop {
            let first = self.sum()?;
            if self.accept_command("to") {
                links.push(Link::Limit(self.limit(first)?));
            } else {
                links.extend(self.chain(first)?.into_iter().map(Link::Relation));
            }
            if !self.accept(',') {
                break;
            }
        }
        let when = if self.accept_words("when") { self.relations()? } else { Vec::new() };
        if self.at < self.tokens.len() {
            return self.fault("something is left");
        }
        Ok(Sentence { when, links })
    }

    fn limit(&mut self, expr: Expr) -> Read<Limit> {
        let to = match self.infinity() {
            Some(true) => Target::PlusInf,
            Some(false) => Target::MinusInf,
            None => Target::Finite(self.sum()?),
        };
        if !self.accept_words("as") {
            return self.fault("no `as`");
        }
        let Expr::Var(var) = self.name()? else { return self.fault("no variable") };
        self.expect_command("to")?;
        let at = match self.infinity() {
            Some(true) => Approach::PlusInf,
            Some(false) => Approach::MinusInf,
            None => self.approach()?,
        };
        Ok(Limit { expr, to, var, at })
    }

    fn infinity(&mut self) -> Option<bool> {
        let start = self.at;
        let negative = self.accept('-');
        if self.accept_command("infty") {
            return Some(!negative);
        }
        self.at = start;
        None
    }

    /// A number, and the side from which it is approached.
    fn approach(&mut self) -> Read<Approach> {
        let negative = self.accept('-');
        let size = match self.primary()? {
            Expr::Num(value) => value,
            Expr::Div(a, b) => match (&*a, &*b) {
                (Expr::Num(a), Expr::Num(b)) => a / b,
                _ => return self.fault("no number"),
            },
            _ => return self.fault("no number"),
        };
        let value = if negative { -size } else { size };
        if !self.accept('^') {
            return Ok(Approach::To(value));
        }
        self.expect('{')?;
        let above = self.accept('+');
        if !above {
            self.expect('-')?;
        }
        self.expect('}')?;
        Ok(if above { Approach::Above(value) } else { Approach::Below(value) })
    }

    fn relations(&mut self) -> Read<Vec<Relation>> {
        let mut all = Vec::new();
        loop {
            let first = self.sum()?;
            all.extend(self.chain(first)?);
            if !self.accept(',') {
                return Ok(all);
            }
        }
    }

    fn chain(&mut self, first: Expr) -> Read<Vec<Relation>> {
        let mut all = Vec::new();
        let mut lhs = first;
        while let Some(rel) = self.comparison() {
            self.at += 1;
            let rhs = self.sum()?;
            all.push(Relation { lhs, rel, rhs: rhs.clone() });
            lhs = rhs;
        }
        if all.is_empty() { self.fault("no comparison") } else { Ok(all) }
    }

    fn comparison(&self) -> Option<Rel> {
        Some(match self.peek()? {
            Token::Other('=') => Rel::Eq,
            Token::Other('<') => Rel::Lt,
            Token::Other('>') => Rel::Gt,
            Token::Command(name) => match name.as_str() {
                "ne" => Rel::Ne,
                "le" => Rel::Le,
                "ge" => Rel::Ge,
                _ => return None,
            },
            _ => return None,
        })
    }

    fn sum(&mut self) -> Read<Expr> {
        if self.is_command("begin") {
            let cases = self.cases()?;
            let ends = self.comparison().is_some()
                || matches!(
                    self.peek(),
                    None | Some(Token::Other(',' | '}' | '&' | ')') | Token::Words(_))
                )
                || ["right", "to", "\\", "end"].iter().any(|name| self.is_command(name));
            return if ends { Ok(cases) } else { self.fault("something beside the rows of cases") };
        }
        let mut left =
            if self.accept('-') { Expr::Neg(self.product()?.into()) } else { self.product()? };
        loop {
            if self.accept('+') {
                left = Expr::Add(left.into(), self.product()?.into());
            } else if self.accept('-') {
                left = Expr::Sub(left.into(), self.product()?.into());
            } else {
                return Ok(left);
            }
        }
    }

    /// Whether something that can be multiplied comes next.
    fn begins_factor(&self) -> bool {
        match self.peek() {
            Some(Token::Letter(_) | Token::Number(_)) => true,
            Some(Token::Command(name)) => {
                !["right", "end", "to", "ne", "le", "ge", "cdot", "\\"].contains(&name.as_str())
            }
            Some(Token::Other(c)) => ['{', '('].contains(c),
            Some(Token::Words(_)) | None => false,
        }
    }

    fn product(&mut self) -> Read<Expr> {
        let mut left = self.factor()?;
        loop {
            if self.accept_command("cdot") {
                left = Expr::Mul(left.into(), self.factor()?.into());
            } else if self.begins_factor() {
                let digit =
                    matches!(self.tokens.get(self.at.wrapping_sub(1)), Some(Token::Number(_)));
                if digit
                    && (matches!(self.peek(), Some(Token::Number(_))) || self.is_command("frac"))
                {
                    return self.fault("a number directly behind a number");
                }
                left = Expr::Mul(left.into(), self.factor()?.into());
            } else {
                return Ok(left);
            }
        }
    }

    fn factor(&mut self) -> Read<Expr> {
        if self.derivative_begins() {
            return self.derivative();
        }
        self.joined = false;
        let base = self.primary()?;
        let high = self.is_command("left");
        let opens = self.tokens.get(self.at + usize::from(high)) == Some(&Token::Other('('));
        if self.names.functions.contains(&base) && opens {
            return self.fault("a function that is applied");
        }
        if !self.accept('^') {
            return Ok(base);
        }
        if std::mem::take(&mut self.joined) {
            return self.fault("an exponent of the end of a name or a call");
        }
        let exponent = self.exponent()?;
        if self.is('^') {
            return self.fault("two exponents");
        }
        Ok(Expr::Pow(base.into(), exponent))
    }

    fn exponent(&mut self) -> Read<i32> {
        self.expect('{')?;
        let negative = self.accept('-');
        let Some(Token::Number(digits)) = self.next() else { return self.fault("no exponent") };
        self.expect('}')?;
        let size: i32 = digits.parse().map_err(|e| format!("{digits}: {e}"))?;
        Ok(if negative { -size } else { size })
    }

    /// Whether a fraction of differentials comes next: an upright d on top.
    fn derivative_begins(&self) -> bool {
        let wanted = [
            Token::Command("frac".to_owned()),
            Token::Other('{'),
            Token::Command("mathrm".to_owned()),
            Token::Other('{'),
            Token::Letter('d'),
            Token::Other('}'),
            Token::Other('}'),
        ];
        self.tokens.get(self.at..).unwrap_or_default().starts_with(&wanted)
    }

    fn derivative(&mut self) -> Read<Expr> {
        self.at += 7;
        self.expect('{')?;
        self.expect_command("mathrm")?;
        self.expect('{')?;
        if self.next() != Some(Token::Letter('d')) {
            return self.fault("no d below");
        }
        self.expect('}')?;
        let Expr::Var(x) = self.name()? else { return self.fault("no variable below") };
        self.expect('}')?;
        let mut f = self.factor()?;
        while self.begins_factor() {
            f = Expr::Mul(f.into(), self.factor()?.into());
        }
        Ok(Expr::Deriv(f.into(), x))
    }

    /// The end of brackets, which grow at both ends or at none.
    fn closes(&mut self, high: bool, bracket: char) -> Read<()> {
        if self.accept_command("right") != high {
            return self.fault("brackets of two kinds");
        }
        self.expect(bracket)
    }

    /// What is in braces.
    fn braced(&mut self) -> Read<Expr> {
        self.expect('{')?;
        let e = self.sum()?;
        self.expect('}')?;
        Ok(e)
    }

    fn primary(&mut self) -> Read<Expr> {
        match self.peek() {
            Some(Token::Number(digits)) => {
                let value = decimal(digits)?;
                self.at += 1;
                Ok(Expr::Num(value))
            }
            Some(Token::Letter(_)) => self.name(),
            Some(Token::Command(name)) => match name.as_str() {
                "frac" => {
                    self.at += 1;
                    let (a, b) = (self.braced()?, self.braced()?);
                    self.joined = false;
                    Ok(Expr::Div(a.into(), b.into()))
                }
                "sqrt" => {
                    self.at += 1;
                    let a = self.braced()?;
                    self.joined = false;
                    Ok(Expr::Sqrt(a.into()))
                }
                "min" | "max" => {
                    let min = name == "min";
                    self.at += 1;
                    let high = self.accept_command("left");
                    self.expect('(')?;
                    let a = self.sum()?;
                    self.expect(',')?;
                    let b = self.sum()?;
                    self.closes(high, ')')?;
                    self.joined = true;
                    Ok(if min {
                        Expr::Min(a.into(), b.into())
                    } else {
                        Expr::Max(a.into(), b.into())
                    })
                }
                "left" => {
                    self.at += 1;
                    let bars = self.accept('|');
                    if !bars {
                        self.expect('(')?;
                    }
                    let e = self.sum()?;
                    self.closes(true, if bars { '|' } else { ')' })?;
                    self.joined = false;
                    Ok(if bars { Expr::Abs(e.into()) } else { e })
                }
                _ => self.name(),
            },
            Some(Token::Other('(')) => {
                self.at += 1;
                let e = self.sum()?;
                self.closes(false, ')')?;
                self.joined = false;
                Ok(e)
            }
            _ => self.fault("nothing"),
        }
    }

    /// A letter with its index and its primes; a difference such as ΔE is one name.
    fn name(&mut self) -> Read<Expr> {
        let mut written = match self.next() {
            Some(Token::Letter('d')) => match self.next() {
                Some(Token::Letter(c)) => format!("d{c}"),
                _ => return self.fault("a lone d"),
            },
            Some(Token::Letter(c)) => c.to_string(),
            Some(Token::Command(name)) if name == "mathrm" => {
                self.expect('{')?;
                format!("\\mathrm{{{}}}", self.until_brace()?)
            }
            Some(Token::Command(name)) if name == "Delta" => match self.peek() {
                Some(Token::Letter(c)) => {
                    let written = format!("\\Delta {c}");
                    self.at += 1;
                    written
                }
                _ => "\\Delta".to_owned(),
            },
            Some(Token::Command(name)) => format!("\\{name}"),
            _ => return self.fault("no name"),
        };
        if self.accept('_') {
            let index = if self.accept('{') {
                self.until_brace()?
            } else {
                match self.next() {
                    Some(Token::Letter(c)) => c.to_string(),
                    // an index without braces is one character
                    Some(Token::Number(digits)) if digits.len() == 1 => digits,
                    _ => return self.fault("no index"),
                }
            };
            let short = index.chars().count() == 1;
            written += &if short { format!("_{index}") } else { format!("_{{{index}}}") };
        }
        while self.accept('\'') {
            written.push('\'');
        }
        self.joined = written.contains(['\'', ' ']) || written.starts_with('d');
        match self.names.symbols.get(&written) {
            Some(e) => Ok(e.clone()),
            None => self.fault(&format!("the unknown name {written}")),
        }
    }

    fn until_brace(&mut self) -> Read<String> {
        let mut out = String::new();
        loop {
            match self.next() {
                Some(Token::Letter(c)) => out.push(c),
                Some(Token::Number(digits)) => out.push_str(&digits),
                Some(Token::Command(name)) => out.push_str(&format!("\\{name}")),
                Some(Token::Other('}')) => return Ok(out),
                Some(Token::Other(c)) => out.push(c),
                Some(Token::Words(_)) | None => return self.fault("no }"),
            }
        }
    }

    fn cases(&mut self) -> Read<Expr> {
        self.expect_command("begin")?;
        self.environment()?;
        let (mut branches, mut last) = (Vec::new(), None);
        loop {
            let value = self.sum()?;
            self.expect('&')?;
            if self.accept_words("otherwise") {
                last = Some(Rc::new(value));
            } else if self.accept_words("if") {
                branches.push((self.relations()?, value));
            } else {
                return self.fault("no condition");
            }
            if self.accept_command("\\") {
                if last.is_some() {
                    return self.fault("a row behind the last");
                }
                continue;
            }
            self.expect_command("end")?;
            self.environment()?;
            return Ok(Expr::Cases(branches, last));
        }
    }

    fn environment(&mut self) -> Read<()> {
        self.expect('{')?;
        let name = self.until_brace()?;
        if name == "cases" { Ok(()) } else { self.fault("another environment") }
    }
}

fn decimal(digits: &str) -> Read<Q> {
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let value = format!("{whole}{fraction}").parse().map_err(|_| format!("{digits}: no number"))?;
    let places = u32::try_from(fraction.len()).map_err(|e| e.to_string())?;
    Ok(BigRational::new(value, num_bigint::BigInt::from(10).pow(places)))
}
