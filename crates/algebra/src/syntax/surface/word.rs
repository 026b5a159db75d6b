//! Symbols and functions as their author wrote them.

use std::rc::Rc;

use kane_kernel::Expr;

use super::super::arrays::FUNCTIONS;
use super::super::latex::{is_loose, parentheses};
use super::super::lexer::Token;
use super::super::names::{RESERVED, canonical_name, latex_name};
use super::super::parser::Level;
use super::{Setter, TEXTS};

impl Setter<'_> {
    pub(super) fn word(&mut self) -> Option<Expr> {
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
        let factor = |e: &Expr| {
            let set = self.set(&self.operand(e.clone(), Level::Power));
            if is_loose(e, Level::Atom) { parentheses(&set) } else { set }
        };
        let own = FUNCTIONS.contains(&name) && (self.is_own)(name);
        let product = |a, sign, b| format!("{} \\{sign} {}", factor(a), factor(b));
        Some(match (name, all.as_slice()) {
            ("dot", [a, b]) if !own => self.text(product(a, "cdot", b), Level::Product),
            ("cross", [a, b]) if !own => self.text(product(a, "times", b), Level::Product),
            ("norm", [a]) if !own => {
                self.text(format!("\\left|{}\\right|", self.set(a)), Level::Atom)
            }
            ("transpose", [a]) if !own => self.raised(a.clone(), "\\mathsf{T}")?,
            ("inverse", [a]) if !own => self.raised(a.clone(), "-1")?,
            ("pow", [a, n]) => self.raised(a.clone(), &self.set(n))?,
            (_, all) => {
                let arguments = all.iter().map(|e| self.set(e)).collect::<Vec<_>>().join(", ");
                let name = match name {
                    "sin" | "cos" | "tan" | "exp" | "log" => format!("\\{name}"),
                    "det" if !own => "\\det".to_owned(),
                    _ => latex_name(name),
                };
                self.text(format!("{name}{}", parentheses(&arguments)), Level::Atom)
            }
        })
    }

    /// `f for k in a..b)`
    fn summed(&mut self, name: &str) -> Option<Expr> {
        self.is_written_out = true;
        let term = self.sum()?;
        let is_sum = is_loose(&term, Level::Product);
        let term = self.set(&self.operand(term, Level::Power));
        let term = if is_sum { parentheses(&term) } else { term };
        if !self.accept_word("for") {
            return None;
        }
        let over = self.name()?;
        if !self.accept_word("in") {
            return None;
        }
        let from = self.sum()?;
        self.expect(Token::Dots)?;
        let to = self.sum()?;
        self.expect(Token::CloseParen)?;
        let (from, to) = (self.set(&from), self.set(&to));
        Some(self.text(format!("\\{name}_{{{over}={from}}}^{{{to}}} {term}"), Level::Product))
    }
}
