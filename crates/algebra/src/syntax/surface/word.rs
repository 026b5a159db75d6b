//! Symbols and functions as their author wrote them.

use std::rc::Rc;

use kane_kernel::Expr;

use super::super::arrays::FUNCTIONS;
use super::super::latex::parentheses;
use super::super::lexer::Token;
use super::super::names::{RESERVED, canonical_name, latex_name};
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
        // factors of a product of their own
        let factor = |e: &Expr| {
            let set = self.set(&self.factor(e.clone()));
            let is_loose = !matches!(e, Expr::Var(_) | Expr::Let(_) | Expr::Num(_) | Expr::Pow(..));
            if is_loose { parentheses(&set) } else { set }
        };
        let own = FUNCTIONS.contains(&name) && (self.is_own)(name);
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
        let over = self.name()?;
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
