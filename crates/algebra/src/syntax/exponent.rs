//! Exponents: literal integers behind `^`, or in raised digits.

use std::ops::Range;

use kane_kernel::Expr;
use num_traits::{Signed as _, ToPrimitive as _};

use super::bounds::{MAX_DIGITS, MAX_EXPONENT};
use super::error::{SyntaxError, SyntaxErrorKind};
use super::lexer::{self, Token};
use super::number::parse_literal;
use super::parser::{Level, Node, Parser};
use super::sequence::power;

impl Parser<'_> {
    /// Passes `^n`, or raised digits, behind a base.
    pub(crate) fn raised_to(&mut self, base: Node) -> Result<Node, SyntaxError> {
        let exponent = match self.accept(Token::Caret) {
            true => self.exponent()?,
            false => self.raised()?,
        };
        let span = base.span.start..exponent.span.end;
        let (at, exponent) = (exponent.span.clone(), self.number_of(exponent));
        if self.scope().symbols(&exponent).into_iter().any(|v| self.is_index(v)) {
            return self.power_of_index(base, &exponent, at);
        }
        // what a sum runs over is a number by now
        let folded = self.scope().sequences().linear(&exponent).filter(|_| !self.locals.is_empty());
        let folded = folded.and_then(|sum| i32::try_from(sum.plus).ok());
        let folded = folded.filter(|n| n.abs() <= MAX_EXPONENT).map(Ok);
        let value = match folded.unwrap_or_else(|| exponent_value(&exponent)) {
            Ok(value) => value,
            Err(kind) => {
                self.report(kind, at);
                1
            }
        };
        let height = base.height + 1;
        let base = self.number_of(base);
        self.build(Expr::Pow(base.into(), value), span, height)
    }

    fn is_index(&self, v: usize) -> bool {
        self.scope().sequences().index_of(v).is_some()
    }

    /// Passes `b, n)` behind `pow(`.
    pub(crate) fn power_call(&mut self) -> Result<Node, SyntaxError> {
        self.advance();
        let open = self.span();
        self.expect(Token::OpenParen, "`(` after a function's name")?;
        let whole = self.nested(|p| {
            let base = p.node()?;
            p.expect(Token::Comma, "`,` and an exponent")?;
            let exponent = p.node()?;
            let (at, exponent) = (exponent.span.clone(), p.number_of(exponent));
            p.power_of_index(base, &exponent, at)
        })?;
        self.close(Token::CloseParen, '(', &open)?;
        Ok(whole)
    }

    /// b^(n + 2) as b²·bⁿ: the power of an index is a symbol.
    fn power_of_index(
        &mut self,
        base: Node,
        exponent: &Expr,
        at: Range<usize>,
    ) -> Result<Node, SyntaxError> {
        let span = base.span.start..at.end;
        let at_base = base.span.clone();
        let base = self.number_of(base);
        let one = |p: &Self| p.build(Expr::int(1), span.clone(), 1);
        let sum = self.scope().sequences().linear(exponent).and_then(|sum| {
            let small = |n: &i64| i32::try_from(*n).ok().filter(|n| (0..=MAX_EXPONENT).contains(n));
            let times = sum.times.iter().map(|(index, n)| Some((*index, small(n)?)));
            Some((times.collect::<Option<Vec<_>>>()?, small(&sum.plus)?))
        });
        let Some((times, plus)) = sum else {
            self.report(SyntaxErrorKind::PowerExponent, at);
            return one(self);
        };
        let Some(name) = self.name_of_base(&base) else {
            self.report(SyntaxErrorKind::PowerBase, at_base);
            return one(self);
        };
        let mut whole = (plus > 0 || times.is_empty()).then(|| power(base, plus));
        for (index, n) in times {
            let Some(symbol) = self.scope().power(&name, index) else {
                let vars = &self.scope().context().vars;
                let index = vars.get(index).map_or_else(String::new, |var| var.name.clone());
                self.report(SyntaxErrorKind::NoPower { base: name, index }, span.clone());
                return one(self);
            };
            let factor = power(Expr::Var(symbol), n);
            whole = Some(match whole {
                None => factor,
                Some(whole) => Expr::Mul(whole.into(), factor.into()),
            });
        }
        let whole = whole.unwrap_or_else(|| Expr::int(1));
        let height = self.scope().height(&whole);
        self.build(whole, span, height)
    }

    /// The name of what may be the base of a power of an index.
    fn name_of_base(&self, base: &Expr) -> Option<String> {
        let context = self.scope().context();
        let name = match base {
            Expr::Num(q) if q.is_integer() && !q.is_negative() => return Some(q.to_string()),
            Expr::Var(v) if !self.is_index(*v) => &context.vars.get(*v)?.name,
            Expr::Let(i) => &context.lets.get(*i)?.name,
            _ => return None,
        };
        self.scope().is_total(base, None).then(|| name.clone())
    }

    fn exponent(&mut self) -> Result<Node, SyntaxError> {
        self.nested(|p| p.prefix(Level::Power))
    }

    /// Passes an exponent in raised digits.
    fn raised(&mut self) -> Result<Node, SyntaxError> {
        let (text, span) = (self.lexeme(), self.span());
        self.advance();
        let Some((minus, plain)) = raised_digits(text) else {
            return Err(SyntaxError { kind: SyntaxErrorKind::ExponentNotInteger, span });
        };
        if plain.len() > MAX_DIGITS {
            return Err(SyntaxError { kind: SyntaxErrorKind::LiteralTooLong, span });
        }
        let value = Expr::Num(parse_literal(&plain));
        let value = if minus { Expr::Neg(value.into()) } else { value };
        self.build(value, span, 1)
    }
}

/// Whether an exponent in raised digits is negative, and its digits.
pub(super) fn raised_digits(text: &str) -> Option<(bool, String)> {
    let (minus, digits) = match text.strip_prefix('⁻') {
        Some(digits) => (true, digits),
        None => (false, text),
    };
    let plain: Option<String> = digits.chars().map(lexer::plain_digit).collect();
    plain.filter(|plain| !plain.is_empty()).map(|plain| (minus, plain))
}

/// The value of a literal integer or a tower of them.
fn exponent_value(expr: &Expr) -> Result<i32, SyntaxErrorKind> {
    let value = match expr {
        Expr::Num(value) if value.is_integer() => value.numer().to_i32(),
        Expr::Neg(inner) => exponent_value(inner)?.checked_neg(),
        Expr::Pow(base, exponent) => {
            let exponent =
                u32::try_from(*exponent).map_err(|_| SyntaxErrorKind::ExponentNotInteger)?;
            exponent_value(base)?.checked_pow(exponent)
        }
        _ => return Err(SyntaxErrorKind::ExponentNotInteger),
    };
    value
        .filter(|v| v.unsigned_abs() <= MAX_EXPONENT.unsigned_abs())
        .ok_or(SyntaxErrorKind::ExponentTooLarge)
}
