//! A statement in LaTeX as its author wrote it, where the reader writes something out: vectors by their components,
//! functions of a document by their bodies, sums by their terms, angles by sines and cosines of one.
//!
//! It goes by the grammar alone and knows no meanings. What is set is shown and never judged; the tests hold it against
//! what is set from the syntax that was judged, wherever nothing is written out.

mod word;

use std::cell::RefCell;

use kane_kernel::{Context, Expr, Relation};

use super::chain::{Hand, chained};
use super::exponent::raised_digits;
use super::latex::{comparison, latex_with, parentheses, tends};
use super::lexer::{self, Token};
use super::names::latex_name;
use super::number::parse_literal;
use super::parser::Level;

/// Groups in groups.
const NESTING: usize = 40;
/// Symbols from here on are texts.
const TEXTS: usize = usize::MAX / 2;

/// What `text` says, and its conditions: a relation, a chain or a list of them, a limit or a definition, with `when` behind
/// it. `None` where nothing is written out, and where something stands there that is set in another way. `is_own` tells
/// which functions are the document's own.
#[must_use]
pub fn surface(
    text: &str,
    context: &Context,
    is_own: &dyn Fn(&str) -> bool,
) -> Option<(String, Option<String>)> {
    let (token, span) = lexer::next(text, 0);
    let texts = RefCell::default();
    let mut setter =
        Setter { text, token, span, context, is_own, texts, depth: 0, is_written_out: false };
    let said = setter.statement()?;
    let when = if setter.accept_word("when") { Some(setter.relations(None)?) } else { None };
    (setter.token == Token::End && setter.is_written_out).then_some((said, when))
}

/// What stands for a symbol.
#[derive(Clone)]
struct Text {
    latex: String,
    /// its loosest operator
    level: Level,
    /// its name, if it has one
    name: Option<String>,
}

struct Setter<'a> {
    text: &'a str,
    token: Token,
    span: std::ops::Range<usize>,
    context: &'a Context,
    is_own: &'a dyn Fn(&str) -> bool,
    /// what is set and no symbol of the context
    texts: RefCell<Vec<Text>>,
    depth: usize,
    is_written_out: bool,
}

impl Setter<'_> {
    fn lexeme(&self) -> &str {
        self.text.get(self.span.clone()).unwrap_or_default()
    }

    fn advance(&mut self) {
        (self.token, self.span) = lexer::next(self.text, self.span.end);
    }

    fn accept(&mut self, token: Token) -> bool {
        let found = self.token == token;
        if found {
            self.advance();
        }
        found
    }

    fn expect(&mut self, token: Token) -> Option<()> {
        self.accept(token).then_some(())
    }

    fn accept_word(&mut self, word: &str) -> bool {
        let found = self.token == Token::Name && self.lexeme() == word;
        if found {
            self.advance();
        }
        found
    }

    fn name(&mut self) -> Option<String> {
        let name = (self.token == Token::Name).then(|| latex_name(self.lexeme()))?;
        self.advance();
        Some(name)
    }

    fn set(&self, e: &Expr) -> String {
        let texts = self.texts.borrow();
        let text = |v: usize| Some(texts.get(v.checked_sub(TEXTS)?)?.latex.clone());
        latex_with(e, self.context, &text)
    }

    /// A text in the place of a symbol.
    fn text(&self, latex: String, level: Level) -> Expr {
        self.keep(Text { latex, level, name: None })
    }

    fn named(&self, name: String) -> Expr {
        self.keep(Text { latex: latex_name(&name), level: Level::Atom, name: Some(name) })
    }

    fn keep(&self, text: Text) -> Expr {
        let mut texts = self.texts.borrow_mut();
        texts.push(text);
        Expr::Var(TEXTS + texts.len() - 1)
    }

    fn known(&self, v: usize) -> Option<Text> {
        self.texts.borrow().get(v.checked_sub(TEXTS)?).cloned()
    }

    /// The same where an operand of at least `least` is due: in parentheses, if it is a looser text.
    fn operand(&self, e: Expr, least: Level) -> Expr {
        let Expr::Var(v) = e else { return e };
        match self.known(v).filter(|text| text.level < least) {
            Some(text) => self.text(parentheses(&text.latex), Level::Atom),
            None => e,
        }
    }

    /// A base with an exponent that is no number.
    fn raised(&self, base: Expr, exponent: &str) -> Option<Expr> {
        let with_one = self.set(&Expr::Pow(self.operand(base, Level::Atom).into(), 1));
        let base = with_one.strip_suffix("^{1}")?;
        Some(self.text(format!("{base}^{{{exponent}}}"), Level::Power))
    }

    /// Runs `read` one level of nesting further in.
    fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> Option<T>) -> Option<T> {
        self.depth += 1;
        let found = if self.depth < NESTING { read(self) } else { None };
        self.depth -= 1;
        found
    }

    fn statement(&mut self) -> Option<String> {
        if self.accept_word("exists") {
            return self.existence();
        }
        let first = self.sum()?;
        if self.accept(Token::Define) {
            let body = self.sum()?;
            return Some(format!("{} := {}", self.set(&first), self.set(&body)));
        }
        if self.accept(Token::Arrow) {
            return self.limit(&first);
        }
        let said = self.relations(Some(first))?;
        if !self.accept_word("for") {
            return Some(said);
        }
        self.is_written_out = true;
        Some(format!("{said} \\quad\\text{{for }} {}", self.relations(None)?))
    }

    /// What follows `exists`.
    fn existence(&mut self) -> Option<String> {
        self.is_written_out = true;
        let mut names = Vec::new();
        loop {
            names.push(self.name()?);
            if !self.accept(Token::Comma) {
                break;
            }
        }
        self.expect(Token::Colon)?;
        Some(format!("\\exists\\, {}:\\; {}", names.join(", "), self.relations(None)?))
    }

    /// What follows `f ->`.
    fn limit(&mut self, f: &Expr) -> Option<String> {
        let to = match self.infinite() {
            Some(infinite) => infinite,
            None => self.sum().map(|value| self.set(&value))?,
        };
        if !self.accept_word("as") {
            return None;
        }
        let x = self.name()?;
        self.expect(Token::Arrow)?;
        let mut point = match self.infinite() {
            Some(infinite) => infinite,
            // a sign behind it is no operator
            None => self.binary(Level::Product).map(|value| self.set(&value))?,
        };
        for (token, side) in [(Token::Plus, "+"), (Token::Minus, "-")] {
            if self.accept(token) {
                point = format!("{point}^{{{side}}}");
            }
        }
        Some(tends(&self.set(f), &to, &x, &point))
    }

    /// `oo` or `-oo`
    fn infinite(&mut self) -> Option<String> {
        let is_negative = self.token == Token::Minus;
        if is_negative && lexer::next(self.text, self.span.end).0 == Token::Infinity {
            self.advance();
        }
        let sign = if is_negative { "-" } else { "" };
        self.accept(Token::Infinity).then(|| format!("{sign}\\infty"))
    }

    /// Relations with commas between, of which the first side may have been read.
    fn relations(&mut self, first: Option<Expr>) -> Option<String> {
        let relations = self.chains(first)?;
        let side = |e: &Expr| self.set(e);
        let hand = Hand { side: &side, sign: comparison, formula: &|_| String::new() };
        Some(chained(&relations, ",\\; ", &hand))
    }

    fn chains(&mut self, mut first: Option<Expr>) -> Option<Vec<Relation>> {
        let mut relations = Vec::new();
        loop {
            let mut left = match first.take() {
                Some(side) => side,
                None => self.sum()?,
            };
            let before = relations.len();
            while let Token::Rel(rel) = self.token {
                self.advance();
                let right = self.sum()?;
                relations.push(Relation { lhs: left, rel, rhs: right.clone() });
                left = right;
            }
            if relations.len() == before {
                return None;
            }
            if !self.accept(Token::Comma) && !self.accept_word("and") {
                return Some(relations);
            }
        }
    }

    fn sum(&mut self) -> Option<Expr> {
        self.nested(|setter| setter.binary(Level::Sum))
    }

    fn binary(&mut self, level: Level) -> Option<Expr> {
        let mut left = self.prefix(level)?;
        loop {
            let token = self.token;
            let above = match token {
                Token::Plus | Token::Minus if level == Level::Sum => Level::Product,
                Token::Star | Token::Slash if level <= Level::Product => Level::Power,
                _ => return Some(left),
            };
            self.advance();
            let right = self.binary(above)?;
            left = match token {
                Token::Plus => Expr::Add(left.into(), right.into()),
                Token::Minus => Expr::Sub(left.into(), right.into()),
                Token::Star => {
                    let factor = |e| self.operand(e, Level::Power);
                    Expr::Mul(factor(left).into(), factor(right).into())
                }
                _ => Expr::Div(left.into(), right.into()),
            };
        }
    }

    fn prefix(&mut self, level: Level) -> Option<Expr> {
        if !self.accept(Token::Minus) {
            return self.power();
        }
        let inner = self.nested(|setter| setter.binary(level.max(Level::Product)))?;
        Some(Expr::Neg(inner.into()))
    }

    fn power(&mut self) -> Option<Expr> {
        let base = self.atom()?;
        match self.token {
            Token::Superscript => {
                let (is_negative, digits) = raised_digits(self.lexeme())?;
                let n: i32 = digits.parse().ok()?;
                self.advance();
                let n = if is_negative { -n } else { n };
                Some(Expr::Pow(self.operand(base, Level::Atom).into(), n))
            }
            Token::Caret => {
                self.advance();
                self.nested(|setter| setter.exponent(base))
            }
            _ => Some(base),
        }
    }

    /// A base with the exponent ahead: a number, or what stands for one.
    fn exponent(&mut self, base: Expr) -> Option<Expr> {
        let is_negative = self.accept(Token::Minus);
        let exponent = self.power()?;
        let exponent = if is_negative { Expr::Neg(exponent.into()) } else { exponent };
        if let Some(n) = whole(&exponent) {
            return Some(Expr::Pow(self.operand(base, Level::Atom).into(), n));
        }
        self.is_written_out = true;
        self.raised(base, &self.set(&exponent))
    }

    fn atom(&mut self) -> Option<Expr> {
        match self.token {
            Token::Number => {
                let value = parse_literal(self.lexeme());
                self.advance();
                Some(Expr::Num(value))
            }
            Token::OpenParen => {
                self.advance();
                let inner = self.sum()?;
                self.expect(Token::CloseParen)?;
                Some(inner)
            }
            Token::Bar => {
                self.advance();
                let inner = self.sum()?;
                self.expect(Token::Bar)?;
                Some(Expr::Abs(inner.into()))
            }
            Token::OpenBracket => self.components(),
            Token::Name => self.word(),
            _ => None,
        }
    }

    /// `[a, b]`, `[[a, b], [c, d]]`
    fn components(&mut self) -> Option<Expr> {
        self.is_written_out = true;
        self.advance();
        let mut rows = Vec::new();
        loop {
            let row = if self.accept(Token::OpenBracket) {
                let row = self.arguments(Token::CloseBracket)?;
                row.iter().map(|e| self.set(e)).collect::<Vec<_>>().join(" & ")
            } else {
                let e = self.sum()?;
                self.set(&e)
            };
            rows.push(row);
            if !self.accept(Token::Comma) {
                break;
            }
        }
        self.expect(Token::CloseBracket)?;
        let rows = rows.join(" \\\\ ");
        Some(self.text(format!("\\begin{{pmatrix}} {rows} \\end{{pmatrix}}"), Level::Atom))
    }

    /// Expressions with commas between, and what ends them.
    fn arguments(&mut self, close: Token) -> Option<Vec<Expr>> {
        let mut all = vec![self.sum()?];
        while self.accept(Token::Comma) {
            all.push(self.sum()?);
        }
        self.expect(close)?;
        Some(all)
    }
}

/// The whole number that an exponent is.
fn whole(e: &Expr) -> Option<i32> {
    match e {
        Expr::Num(value) if value.is_integer() => i32::try_from(value.to_integer()).ok(),
        Expr::Neg(inner) => whole(inner).map(|n| -n),
        _ => None,
    }
}
