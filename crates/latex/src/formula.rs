//! Expressions: from LaTeX to the language of derivations, products written out.

use crate::adjacent::Adjacent;
use crate::command::{Beginning, beginning};
use crate::name::{Names, letter, part};
use crate::part::{Level, Part, one, over, power, times};
use crate::plain::is_empty_group;
use crate::token::{Token, written};
use crate::unreadable::Unreadable;

/// Parts in one another beyond which nothing is read.
const DEPTH: usize = 120;

/// Reads expressions from tokens.
pub(crate) struct Reader<'a> {
    pub(crate) tokens: &'a [Token],
    pub(crate) at: usize,
    pub(crate) names: &'a mut Names,
    pub(crate) bars: usize,
    pub(crate) depth: usize,
}

impl<'a> Reader<'a> {
    pub(crate) fn new(tokens: &'a [Token], names: &'a mut Names) -> Self {
        Self { tokens, at: 0, names, bars: 0, depth: 0 }
    }

    pub(crate) fn peek(&self) -> Option<&'a Token> {
        self.tokens.get(self.at)
    }

    pub(crate) fn next(&mut self) -> Option<&'a Token> {
        let token = self.tokens.get(self.at);
        self.at += 1;
        token
    }

    /// The last token that was passed.
    pub(crate) fn passed(&self) -> Option<&'a Token> {
        self.at.checked_sub(1).and_then(|at| self.tokens.get(at))
    }

    pub(crate) fn takes(&mut self, token: &Token) -> bool {
        let found = self.peek() == Some(token);
        self.at += usize::from(found);
        found
    }

    pub(crate) fn takes_char(&mut self, wanted: char) -> bool {
        self.takes(&Token::Char(wanted))
    }

    pub(crate) fn command(&self) -> Option<&'a str> {
        match self.peek() {
            Some(Token::Command(name)) => Some(name),
            _ => None,
        }
    }

    /// Passes empty groups, which are printed as nothing.
    pub(crate) fn pass_empty(&mut self) {
        while self.tokens.get(self.at..).is_some_and(is_empty_group) {
            self.at += 2;
        }
    }

    /// A sum of products.
    pub(crate) fn sum(&mut self) -> Result<Part, Unreadable> {
        self.depth += 1;
        if self.depth > DEPTH {
            return Err(Unreadable::Depth);
        }
        self.pass_empty();
        let negative = if self.takes_char('-') || self.takes_char('−') {
            true
        } else {
            self.takes_char('+');
            false
        };
        let mut out = self.product()?;
        if negative {
            out = Part {
                text: format!("-{}", out.at(Level::Product)),
                level: Level::Sum,
                literal: false,
                ..out
            };
        }
        loop {
            let sign = match self.peek() {
                Some(Token::Char('+')) => '+',
                Some(Token::Char('-' | '−')) => '-',
                _ => break,
            };
            self.at += 1;
            let next = self.product()?;
            if next.vector != out.vector {
                return Err(Unreadable::Mixed(format!("{} {sign} {}", out.text, next.text)));
            }
            let text = format!("{} {sign} {}", out.text, next.at(Level::Product));
            out = Part { text, level: Level::Sum, vector: out.vector, literal: false };
        }
        self.depth -= 1;
        Ok(out)
    }

    /// A product of factors.
    pub(crate) fn product(&mut self) -> Result<Part, Unreadable> {
        let mut out = self.factor()?;
        let mut adjacent = Adjacent::behind(&out, self.passed());
        loop {
            let before = self.at;
            self.pass_empty();
            // printed as a value at what stands in the brackets, and written as something else
            if self.at > before && matches!(self.peek(), Some(Token::Char('(' | '['))) {
                return Err(Unreadable::Ambiguous(format!("{}{{}}(…)", out.text)));
            }
            match self.peek() {
                Some(Token::Char('*' | '·')) => {
                    self.at += 1;
                    out = times(&out, &self.factor()?)?;
                }
                Some(Token::Command(name)) if name == "cdot" || name == "ast" => {
                    self.at += 1;
                    let next = self.factor()?;
                    out = if out.vector && next.vector {
                        Part::atom(format!("dot({}, {})", out.text, next.text))
                    } else {
                        times(&out, &next)?
                    };
                }
                Some(Token::Command(name)) if name == "times" || name == "wedge" => {
                    let closed = self.passed() == Some(&Token::Char(')'));
                    self.at += 1;
                    let next = self.factor()?;
                    out = if out.vector && next.vector {
                        if out.text.starts_with("cross(") && !closed {
                            return Err(Unreadable::Ambiguous(format!("{} × …", out.text)));
                        }
                        let text = format!("cross({}, {})", out.text, next.text);
                        Part { vector: true, ..Part::atom(text) }
                    } else if next.vector {
                        // the product of all three, or of a vector and the number of two
                        return Err(Unreadable::Ambiguous(format!("{} × {}", out.text, next.text)));
                    } else {
                        times(&out, &next)?
                    };
                }
                Some(Token::Char('/') | Token::Command(_)) if self.divides() => {
                    self.at += 1;
                    let next = self.factor()?.number()?;
                    let numbers = out.literal && next.literal;
                    if !numbers && self.begins_factor() {
                        let text = format!("{}/{}…", out.text, next.text);
                        return Err(Unreadable::Ambiguous(text));
                    }
                    out = over(&out, &next);
                }
                _ if self.begins_factor() => {
                    adjacent.before(self.peek())?;
                    let next = self.factor()?;
                    adjacent.then(&next, self.passed())?;
                    // vectors side by side are a matrix and what it is applied to
                    out = times(&out, &next)?;
                    continue;
                }
                _ => return Ok(out),
            }
            adjacent = Adjacent::behind(&out, self.passed());
        }
    }

    pub(crate) fn divides(&self) -> bool {
        matches!(self.peek(), Some(Token::Char('/'))) || self.command() == Some("div")
    }

    pub(crate) fn begins_factor(&self) -> bool {
        match self.peek() {
            Some(Token::Char(c)) => {
                c.is_alphanumeric() || matches!(c, '(' | '[') || (*c == '|' && self.bars == 0)
            }
            Some(Token::Open | Token::Upright(_)) => true,
            Some(Token::Begin(name)) => is_cases(name) || is_matrix(name),
            Some(Token::Command(name)) => match beginning(name) {
                Some(Beginning::Bar(opens)) => opens || self.bars == 0,
                found => found.is_some(),
            },
            _ => false,
        }
    }

    pub(crate) fn factor(&mut self) -> Result<Part, Unreadable> {
        self.depth += 1;
        if self.depth > DEPTH {
            return Err(Unreadable::Depth);
        }
        self.pass_empty();
        let base = self.base()?;
        self.depth -= 1;
        self.powers(base)
    }

    /// Whether a digit follows one that stands without braces: `x^23` is printed as a square and a 3.
    pub(crate) fn goes_on(&self, group: &[Token]) -> bool {
        let digit = |t: Option<&Token>| matches!(t, Some(Token::Char(c)) if c.is_ascii_digit());
        group.len() == 1 && digit(group.first()) && digit(self.passed()) && digit(self.peek())
    }

    pub(crate) fn powers(&mut self, mut base: Part) -> Result<Part, Unreadable> {
        while self.takes(&Token::Superscript) {
            let exponent = self.group()?;
            if self.goes_on(exponent) {
                return Err(Unreadable::Ambiguous(format!("{}^{}…", base.text, written(exponent))));
            }
            let number = base.number()?;
            base = match power(&number, exponent) {
                Err(Unreadable::Exponent) => self.running_power(&number, exponent)?,
                read => read?,
            };
        }
        Ok(base)
    }

    /// The tokens of a group in braces, or the one token that stands for it.
    pub(crate) fn group(&mut self) -> Result<&'a [Token], Unreadable> {
        let start = self.at;
        match self.next() {
            None => Err(Unreadable::Missing("an argument")),
            Some(Token::Open) => {
                let mut depth = 1;
                while depth > 0 {
                    match self.next() {
                        Some(Token::Open) => depth += 1,
                        Some(Token::Close) => depth -= 1,
                        Some(_) => {}
                        None => return Err(Unreadable::Missing("a closing brace")),
                    }
                }
                Ok(&self.tokens[start + 1..self.at - 1])
            }
            Some(_) => Ok(&self.tokens[start..self.at]),
        }
    }

    /// The whole of some tokens as one expression.
    pub(crate) fn whole(&mut self, tokens: &'a [Token]) -> Result<Part, Unreadable> {
        let (depth, parent) = (self.depth, (self.tokens, self.at, self.bars));
        (self.tokens, self.at, self.bars) = (tokens, 0, 0);
        let read = self.sum();
        let rest = self.peek().cloned();
        (self.tokens, self.at, self.bars) = parent;
        let part = read?;
        self.depth = depth;
        match rest {
            None => Ok(part),
            Some(token) => Err(out_of_place(&token)),
        }
    }

    pub(crate) fn argument(&mut self) -> Result<Part, Unreadable> {
        let group = self.group()?;
        self.whole(group)
    }

    pub(crate) fn base(&mut self) -> Result<Part, Unreadable> {
        let Some(token) = self.next() else { return Err(Unreadable::Missing("an expression")) };
        match token {
            Token::Char(c) if c.is_ascii_digit() || *c == '.' => self.number(*c),
            Token::Char('d') if self.passes_to_name() => {
                let mut rest = Reader {
                    tokens: self.tokens,
                    at: self.at,
                    names: &mut Names::default(),
                    bars: 0,
                    depth: 0,
                };
                let name = rest.factor().map_or_else(|_| String::new(), |part| part.text);
                Err(Unreadable::Differential(name))
            }
            Token::Char(c) if c.is_alphabetic() => self.name(c.to_string(), false, c.to_string()),
            Token::Char('(') => self.bracket(')'),
            Token::Char('[') => self.bracket(']'),
            Token::Char('|') => self.magnitude(false),
            Token::Upright(word) if word == "d" => Err(Unreadable::Differential(String::new())),
            Token::Upright(word) if is_word(word) => {
                self.name(word.clone(), false, format!("\\mathrm{{{word}}}"))
            }
            Token::Open => {
                self.at -= 1;
                self.argument()
            }
            Token::Begin(name) if is_cases(name) => self.cases(name),
            Token::Begin(name) if is_matrix(name) => self.matrix(name),
            Token::Begin(name) => Err(Unreadable::Environment(name.clone())),
            Token::Command(name) => self.by_command(name),
            other => Err(out_of_place(other)),
        }
    }

    /// Whether a name follows, behind empty groups or at once.
    fn passes_to_name(&mut self) -> bool {
        self.pass_empty();
        self.begins_name()
    }

    pub(crate) fn begins_name(&self) -> bool {
        match self.peek() {
            Some(Token::Char(c)) => c.is_alphabetic(),
            Some(Token::Command(name)) => letter(name).is_some(),
            _ => false,
        }
    }

    pub(crate) fn number(&mut self, first: char) -> Result<Part, Unreadable> {
        let mut text = String::from(if first == '.' { "0." } else { "" });
        if first != '.' {
            text.push(first);
        }
        while let Some(Token::Char(c)) = self.peek() {
            let behind = self.tokens.get(self.at + 1);
            let digit_behind = matches!(behind, Some(Token::Char(n)) if n.is_ascii_digit());
            if c.is_ascii_digit() || (*c == '.' && !text.contains('.') && digit_behind) {
                text.push(*c);
                self.at += 1;
            } else {
                break;
            }
        }
        if text.ends_with('.') {
            return Err(Unreadable::Character('.'));
        }
        Ok(Part { literal: true, ..Part::atom(text) })
    }

    pub(crate) fn bracket(&mut self, close: char) -> Result<Part, Unreadable> {
        let bars = std::mem::take(&mut self.bars);
        let inside = self.sum()?;
        self.bars = bars;
        if self.takes_char(close) {
            Ok(Part { literal: false, ..inside })
        } else {
            Err(self.peek().map_or(Unreadable::Missing("a closing bracket"), out_of_place))
        }
    }

    /// What stands between bars; one that can only open has one that can only close as its other end.
    pub(crate) fn magnitude(&mut self, opens: bool) -> Result<Part, Unreadable> {
        let bars = if opens { std::mem::take(&mut self.bars) } else { self.bars };
        self.bars += usize::from(!opens);
        let inside = self.sum()?;
        self.bars = bars;
        let closed = match self.command() {
            Some("rvert") => opens,
            Some("vert") => !opens,
            _ => !opens && self.peek() == Some(&Token::Char('|')),
        };
        if !closed {
            return Err(Unreadable::Missing("a closing bar"));
        }
        self.at += 1;
        let function = if inside.vector { "norm" } else { "abs" };
        Ok(Part::atom(format!("{function}({})", inside.text)))
    }

    pub(crate) fn by_command(&mut self, name: &str) -> Result<Part, Unreadable> {
        match beginning(name) {
            Some(Beginning::Letter(known)) => {
                // Δ before a letter is part of its name
                if let ("Delta", Some(Token::Char(c))) = (known, self.peek())
                    && c.is_ascii_alphabetic()
                {
                    self.at += 1;
                    return self.name(format!("Delta{c}"), false, format!("\\Delta {c}"));
                }
                self.name(known.to_owned(), false, format!("\\{name}"))
            }
            Some(Beginning::Pi) => Ok(Part::atom("pi")),
            Some(Beginning::Fraction) => self.fraction(),
            Some(Beginning::Root) => {
                if self.takes_char('[') && !(self.takes_char('2') && self.takes_char(']')) {
                    return Err(Unreadable::Exponent);
                }
                let radicand = self.argument()?.number()?;
                Ok(Part::atom(format!("sqrt({})", radicand.text)))
            }
            Some(Beginning::Angle(function) | Beginning::Exponential(function)) => {
                self.angle_function(function)
            }
            Some(Beginning::Summation(function)) => self.summation(function),
            Some(Beginning::Quotient(over_it, under)) => {
                let start = self.at;
                let bottom = self.angle_function(under)?;
                let Some(function) = over_it else { return Ok(over(&one(), &bottom)) };
                self.at = start;
                Ok(over(&self.angle_function(function)?, &bottom))
            }
            Some(Beginning::Extreme(which)) => self.extreme(which),
            Some(Beginning::Rate(order)) => self.rate(order),
            Some(Beginning::Mark(mark)) => self.marked(mark),
            Some(Beginning::Vector) => {
                let group = self.group()?;
                let base = part(group)?;
                let spelled = format!("\\mathbf{{{base}}}");
                self.name(base, true, spelled)
            }
            Some(Beginning::Brace) => {
                let inside = self.sum()?;
                if self.command().is_some_and(|close| matches!(close, "}" | "rbrace")) {
                    self.at += 1;
                    Ok(inside)
                } else {
                    Err(Unreadable::Missing("a closing brace"))
                }
            }
            Some(Beginning::Bar(opens)) => self.magnitude(opens),
            None => Err(Unreadable::Command(name.to_owned())),
        }
    }
}

fn is_word(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_alphabetic())
        && word.chars().all(|c| c.is_ascii_alphanumeric())
}

fn is_cases(name: &str) -> bool {
    matches!(name, "cases" | "dcases")
}

fn is_matrix(name: &str) -> bool {
    matches!(name, "pmatrix" | "bmatrix")
}

/// Tokens without punctuation at their end.
pub(crate) fn strip(mut tokens: &[Token]) -> &[Token] {
    while let [rest @ .., Token::Char(',' | '.' | ';') | Token::Quad | Token::Row] = tokens {
        tokens = rest;
    }
    tokens
}

/// What is wrong with a token that nothing can begin with.
pub(crate) fn out_of_place(token: &Token) -> Unreadable {
    match token {
        Token::Char(c) => Unreadable::Character(*c),
        Token::Command(name) => Unreadable::Command(name.clone()),
        Token::Words(words) => Unreadable::Words(words.clone()),
        Token::Begin(name) | Token::End(name) => Unreadable::Environment(name.clone()),
        Token::Upright(word) => Unreadable::Words(word.clone()),
        Token::Close => Unreadable::Character('}'),
        Token::Open => Unreadable::Character('{'),
        Token::Superscript => Unreadable::Character('^'),
        Token::Subscript => Unreadable::Character('_'),
        Token::Column => Unreadable::Character('&'),
        _ => Unreadable::Missing("a sign"),
    }
}
