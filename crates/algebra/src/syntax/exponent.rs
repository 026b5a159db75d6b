//! Exponents: literal integers behind `^`, or in raised digits.

use kane_kernel::Expr;
use num_traits::ToPrimitive as _;

use super::bounds::{MAX_DIGITS, MAX_EXPONENT};
use super::error::{SyntaxError, SyntaxErrorKind};
use super::lexer::{self, Token};
use super::number::parse_literal;
use super::parser::{Level, Node, Parser};

impl Parser<'_> {
    /// Passes `^n`, or raised digits, behind a base.
    pub(crate) fn raised_to(&mut self, base: Node) -> Result<Node, SyntaxError> {
        let exponent = match self.accept(Token::Caret) {
            true => self.exponent()?,
            false => self.raised()?,
        };
        let span = base.span.start..exponent.span.end;
        let (at, exponent) = (exponent.span.clone(), self.number_of(exponent));
        let value = match exponent_value(&exponent) {
            Ok(value) => value,
            Err(kind) => {
                self.report(kind, at);
                1
            }
        };
        if value < 0 && base.value.is_literal_zero() {
            self.report(SyntaxErrorKind::DivisionByLiteralZero, span.clone());
        }
        let height = base.height + 1;
        let base = self.number_of(base);
        self.build(Expr::Pow(Box::new(base), value), span, height)
    }

    fn exponent(&mut self) -> Result<Node, SyntaxError> {
        self.nested(|p| p.prefix(Level::Power))
    }

    /// Passes an exponent in raised digits.
    fn raised(&mut self) -> Result<Node, SyntaxError> {
        let (text, span) = (self.lexeme(), self.span());
        self.advance();
        let (minus, digits) = match text.strip_prefix('⁻') {
            Some(digits) => (true, digits),
            None => (false, text),
        };
        let plain: Option<String> = digits.chars().map(lexer::plain_digit).collect();
        let Some(plain) = plain.filter(|plain| !plain.is_empty()) else {
            return Err(SyntaxError { kind: SyntaxErrorKind::ExponentNotInteger, span });
        };
        if plain.len() > MAX_DIGITS {
            return Err(SyntaxError { kind: SyntaxErrorKind::LiteralTooLong, span });
        }
        let value = Expr::Num(parse_literal(&plain));
        let value = if minus { Expr::Neg(Box::new(value)) } else { value };
        self.build(value, span, 1)
    }
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
