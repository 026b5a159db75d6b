//! Signs of other languages: what is meant by them is clear, and they mean nothing here.

use super::error::{SyntaxError, SyntaxErrorKind};
use super::lexer::Token;
use super::parser::Parser;

/// Operators of programming languages, each two signs of this one beside each other, and what to write.
const FOREIGN: [(&str, &str); 5] =
    [("==", "`=`"), ("=>", "`>=` or `implies`"), ("=<", "`<=`"), ("<>", "`!=`"), ("**", "`^`")];

impl Parser<'_> {
    /// The fault that the sign ahead and the one right before it are an operator of another language.
    pub(crate) fn foreign_operator(&self) -> Option<SyntaxError> {
        let (text, at) = self.ahead();
        let both = text.get(at.checked_sub(1)?..)?;
        let (written, ours) = FOREIGN.into_iter().find(|(written, _)| both.starts_with(written))?;
        let start = self.span().start - 1;
        let kind = SyntaxErrorKind::Foreign { written, ours };
        Some(SyntaxError { kind, span: start..start + written.len() })
    }

    /// The fault that a semicolon ends the statement.
    pub(crate) fn last_semicolon(&self) -> Option<SyntaxError> {
        let is_last = self.token() == Token::Semicolon && self.rest().0.trim() == ";";
        is_last.then(|| self.fault(SyntaxErrorKind::LastSemicolon))
    }
}
