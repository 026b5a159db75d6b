//! Signs of other languages: what is meant by them is clear, and they mean nothing here.

use super::error::{SyntaxError, SyntaxErrorKind};
use super::lexer::Token;
use super::parser::Parser;

/// Operators that are read as signs of this language beside each other until one is in the way, and what to
/// write. What holds another stands before it.
const OPERATORS: [(&str, &str); 8] = [
    ("<=>", "`iff`"),
    ("<->", "`iff`"),
    ("==>", "`implies`"),
    ("==", "`=`"),
    ("=>", "`>=` or `implies`"),
    ("=<", "`<=`"),
    ("<>", "`!=`"),
    ("**", "`^`"),
];

/// Signs with which nothing begins here, and what to write.
const SIGNS: [(&str, &str); 15] = [
    ("||", "`or`, and a product of bars with `*`"),
    ("&&", "`and`"),
    ("∧", "`and`"),
    ("∨", "`or`"),
    ("⇒", "`implies`"),
    ("⇔", "`iff`"),
    ("√", "`sqrt(f)`"),
    ("∂", "`d(f, x)`"),
    ("±", "as two cases, `x = a or x = -a`"),
    ("≈", "as a bound, `abs(a - b) <= c`"),
    ("~", "as a bound, `abs(a - b) <= c`"),
    ("∈", "as bounds, `0 <= e <= 1`, or `in N`, `in R^3`"),
    ("∑", "`sum(f for k in 1..n)`"),
    ("∏", "`prod(f for k in 1..n)`"),
    ("∫", "by what it is an integral of, `d(F, x) = f`"),
];

impl Parser<'_> {
    /// The fault that the sign ahead, with those right before it, is one of another language.
    pub(crate) fn foreign_operator(&self) -> Option<SyntaxError> {
        let (text, at) = self.ahead();
        let begins = |start: usize, written: &str| {
            text.get(start..).is_some_and(|rest| rest.starts_with(written))
        };
        let sign = SIGNS.into_iter().find(|(written, _)| begins(at, written));
        let (start, (written, ours)) = sign.map(|sign| (at, sign)).or_else(|| {
            [2, 1].into_iter().filter_map(|back| at.checked_sub(back)).find_map(|start| {
                let reaches = |written: &str| begins(start, written) && start + written.len() > at;
                let operator = OPERATORS.into_iter().find(|(written, _)| reaches(written))?;
                Some((start, operator))
            })
        })?;
        let start = self.span().start - at + start;
        let kind = SyntaxErrorKind::Foreign { written, ours };
        Some(SyntaxError { kind, span: start..start + written.len() })
    }

    /// The fault that a semicolon ends the statement.
    pub(crate) fn last_semicolon(&self) -> Option<SyntaxError> {
        let is_last = self.token() == Token::Semicolon && self.rest().0.trim() == ";";
        is_last.then(|| self.fault(SyntaxErrorKind::LastSemicolon))
    }
}
