//! A statement in LaTeX as its author wrote it, where the reader writes something out: vectors by their components,
//! functions of a document by their bodies, sums by their terms, angles by sines and cosines of one.
//!
//! It goes by the grammar alone and knows no meanings. What is set is shown and never judged; the tests hold it against
//! what is set from the syntax that was judged, wherever nothing is written out.

use std::cell::RefCell;
use std::rc::Rc;

use kane_kernel::{Context, Expr, Relation};

use super::chain::{Hand, chained};
use super::exponent::raised_digits;
use super::latex::{comparison, latex_with, parentheses};
use super::lexer::{self, Token};
use super::names::{RESERVED, canonical_name, latex_name};
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
    /// whether it needs parentheses in a product
    is_loose: bool,
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

    fn set(&self, e: &Expr) -> String {
        let texts = self.texts.borrow();
        let text = |v: usize| Some(texts.get(v.checked_sub(TEXTS)?)?.latex.clone());
        latex_with(e, self.context, &text)
    }

    /// A text in the place of a symbol.
    fn text(&self, latex: String, is_loose: bool) -> Expr {
        self.keep(Text { latex, is_loose, name: None })
    }

    fn named(&self, name: String) -> Expr {
        self.keep(Text { latex: latex_name(&name), is_loose: false, name: Some(name) })
    }

    fn keep(&self, text: Text) -> Expr {
        let mut texts = self.texts.borrow_mut();
        texts.push(text);
        Expr::Var(TEXTS + texts.len() - 1)
    }

    fn known(&self, v: usize) -> Option<Text> {
        self.texts.borrow().get(v.checked_sub(TEXTS)?).cloned()
    }

    /// The same as a factor.
    fn factor(&self, e: Expr) -> Expr {
        let Expr::Var(v) = e else { return e };
        match self.known(v).filter(|text| text.is_loose) {
            Some(text) => self.text(parentheses(&text.latex), false),
            None => e,
        }
    }

    fn statement(&mut self) -> Option<String> {
        let first = self.sum()?;
        if self.accept(Token::Define) {
            let body = self.sum()?;
            return Some(format!("{} := {}", self.set(&first), self.set(&body)));
        }
        if self.accept(Token::Arrow) {
            return self.limit(&first);
        }
        self.relations(Some(first))
    }

    /// What follows `f ->`.
    fn limit(&mut self, f: &Expr) -> Option<String> {
        let to = self.end()?;
        if !self.accept_word("as") {
            return None;
        }
        let x = latex_name(self.lexeme());
        self.expect(Token::Name)?;
        self.expect(Token::Arrow)?;
        let mut point = self.end()?;
        for (token, side) in [(Token::Plus, "+"), (Token::Minus, "-")] {
            if self.accept(token) {
                point = format!("{point}^{{{side}}}");
            }
        }
        Some(format!("{} \\to {to} \\text{{ as }} {x} \\to {point}", self.set(f)))
    }

    /// Where something tends to: a number, a symbol or infinity, or for a target a product.
    fn end(&mut self) -> Option<String> {
        let is_negative = self.accept(Token::Minus);
        let sign = if is_negative { "-" } else { "" };
        if self.accept(Token::Infinity) {
            return Some(format!("{sign}\\infty"));
        }
        let e = self.binary(Level::Product)?;
        Some(format!("{sign}{}", self.set(&e)))
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
            if !self.accept(Token::Comma) {
                return Some(relations);
            }
        }
    }

    fn sum(&mut self) -> Option<Expr> {
        self.depth += 1;
        let e = if self.depth < NESTING { self.binary(Level::Sum) } else { None };
        self.depth -= 1;
        e
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
                Token::Star => Expr::Mul(self.factor(left).into(), self.factor(right).into()),
                _ => Expr::Div(left.into(), right.into()),
            };
        }
    }

    fn prefix(&mut self, level: Level) -> Option<Expr> {
        if !self.accept(Token::Minus) {
            return self.power();
        }
        self.depth += 1;
        let inner =
            if self.depth < NESTING { self.binary(level.max(Level::Product)) } else { None };
        self.depth -= 1;
        Some(Expr::Neg(inner?.into()))
    }

    fn power(&mut self) -> Option<Expr> {
        let base = self.atom()?;
        match self.token {
            Token::Superscript => {
                let (is_negative, digits) = raised_digits(self.lexeme())?;
                let n: i32 = digits.parse().ok()?;
                self.advance();
                let n = if is_negative { -n } else { n };
                Some(Expr::Pow(self.factor(base).into(), n))
            }
            Token::Caret => {
                self.advance();
                self.raised(base)
            }
            _ => Some(base),
        }
    }

    /// A base with the exponent ahead: a number, or what stands for one.
    fn raised(&mut self, base: Expr) -> Option<Expr> {
        let base = self.factor(base);
        let is_negative = self.accept(Token::Minus);
        let exponent = self.power()?;
        let exponent = if is_negative { Expr::Neg(exponent.into()) } else { exponent };
        if let Some(n) = whole(&exponent) {
            return Some(Expr::Pow(base.into(), n));
        }
        self.is_written_out = true;
        let with_one = self.set(&Expr::Pow(base.into(), 1));
        let base = with_one.strip_suffix("^{1}")?;
        Some(self.text(format!("{base}^{{{}}}", self.set(&exponent)), false))
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
                let row: Vec<String> = self.list(Token::CloseBracket)?;
                row.join(" & ")
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
        Some(self.text(format!("\\begin{{pmatrix}} {rows} \\end{{pmatrix}}"), false))
    }

    /// Expressions with commas between, and what ends them.
    fn list(&mut self, close: Token) -> Option<Vec<String>> {
        let all = self.arguments(close)?;
        Some(all.iter().map(|e| self.set(e)).collect())
    }

    fn arguments(&mut self, close: Token) -> Option<Vec<Expr>> {
        let mut all = vec![self.sum()?];
        while self.accept(Token::Comma) {
            all.push(self.sum()?);
        }
        self.expect(close)?;
        Some(all)
    }

    fn word(&mut self) -> Option<Expr> {
        let name = self.lexeme().to_owned();
        if name == "cases" {
            return None;
        }
        self.advance();
        if self.accept(Token::OpenParen) {
            return self.call(&name);
        }
        if RESERVED.contains(&name.as_str()) {
            return None;
        }
        Some(self.symbol(&name))
    }

    /// A symbol of the context, or a name that it lacks.
    fn symbol(&mut self, name: &str) -> Expr {
        let canonical = canonical_name(name);
        let is = |other: &str| canonical_name(other) == canonical;
        if let Some(v) = self.context.vars.iter().position(|var| is(&var.name)) {
            return Expr::Var(v);
        }
        if let Some(i) = self.context.lets.iter().position(|def| is(&def.name)) {
            return Expr::Let(i);
        }
        self.is_written_out = true;
        self.named(canonical.into_owned())
    }

    /// d(f, x): a symbol of the context where motion has one, a name where f is a name that the context lacks.
    fn derivative(&mut self, f: &Expr, x: usize) -> Expr {
        let by = &self.context.vars.get(x).map_or("?", |var| &var.name);
        let name = match f {
            Expr::Var(v) if *v < TEXTS => self.context.vars.get(*v).map(|var| var.name.clone()),
            Expr::Var(v) => self.known(*v).and_then(|text| text.name),
            _ => None,
        };
        let name = name.map(|name| format!("d({name}, {by})"));
        let symbol = name
            .as_ref()
            .and_then(|name| self.context.vars.iter().position(|var| var.name == *name));
        match (symbol, name, f) {
            (Some(v), ..) => Expr::Var(v),
            (None, Some(name), Expr::Var(v)) if *v >= TEXTS => self.named(name),
            _ => Expr::Deriv(f.clone().into(), x),
        }
    }

    /// A function behind its opened parenthesis.
    fn call(&mut self, name: &str) -> Option<Expr> {
        if matches!(name, "sum" | "prod") {
            return self.summed(name);
        }
        let all = self.arguments(Token::CloseParen)?;
        let one = |e: &Expr| Rc::new(e.clone());
        let known = match (name, all.as_slice()) {
            ("abs", [a]) => Expr::Abs(one(a)),
            ("sqrt", [a]) => Expr::Sqrt(one(a)),
            ("min", [a, b]) => Expr::Min(one(a), one(b)),
            ("max", [a, b]) => Expr::Max(one(a), one(b)),
            ("d", [f, Expr::Var(x)]) if *x < TEXTS => self.derivative(f, *x),
            _ => {
                self.is_written_out = true;
                return self.written_out(name, all);
            }
        };
        Some(known)
    }

    /// A function that the reader writes out.
    fn written_out(&self, name: &str, all: Vec<Expr>) -> Option<Expr> {
        if RESERVED.contains(&name) {
            return None;
        }
        // factors of a product of their own
        let factor = |e: &Expr| {
            let set = self.set(&self.factor(e.clone()));
            let is_loose = !matches!(e, Expr::Var(_) | Expr::Let(_) | Expr::Num(_) | Expr::Pow(..));
            if is_loose { parentheses(&set) } else { set }
        };
        let own = (self.is_own)(name);
        let (text, is_loose) = match (name, all.as_slice()) {
            ("dot", [a, b]) if !own => (format!("{} \\cdot {}", factor(a), factor(b)), true),
            ("cross", [a, b]) if !own => (format!("{} \\times {}", factor(a), factor(b)), true),
            ("norm", [a]) if !own => (format!("\\left|{}\\right|", self.set(a)), false),
            ("transpose", [a]) if !own => (format!("{}^{{\\mathsf{{T}}}}", factor(a)), false),
            ("inverse", [a]) if !own => (format!("{}^{{-1}}", factor(a)), false),
            ("pow", [a, n]) => (format!("{}^{{{}}}", factor(a), self.set(n)), false),
            (_, all) => {
                let arguments = all.iter().map(|e| self.set(e)).collect::<Vec<_>>().join(", ");
                let name = match name {
                    "sin" | "cos" | "tan" | "exp" | "log" => format!("\\{name}"),
                    "det" if !own => "\\det".to_owned(),
                    _ => latex_name(name),
                };
                (format!("{name}{}", parentheses(&arguments)), false)
            }
        };
        Some(self.text(text, is_loose))
    }

    /// `f for k in a..b)`
    fn summed(&mut self, name: &str) -> Option<Expr> {
        self.is_written_out = true;
        let term = self.sum()?;
        let is_sum = matches!(term, Expr::Add(..) | Expr::Sub(..) | Expr::Neg(_));
        let term = self.set(&self.factor(term));
        let term = if is_sum { parentheses(&term) } else { term };
        if !self.accept_word("for") {
            return None;
        }
        let over = latex_name(self.lexeme());
        self.expect(Token::Name)?;
        if !self.accept_word("in") {
            return None;
        }
        let from = self.sum()?;
        self.expect(Token::Dots)?;
        let to = self.sum()?;
        self.expect(Token::CloseParen)?;
        let (from, to) = (self.set(&from), self.set(&to));
        Some(self.text(format!("\\{name}_{{{over}={from}}}^{{{to}}} {term}"), true))
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
