//! Formulas: relations with `and`, `or`, `implies`, `iff` and parentheses between them.
//!
//! ```text
//! formula := clause [ "iff" clause ]
//! clause  := choice [ "implies" choice ]
//! choice  := both { "or" both }
//! both    := part { "and" part }
//! part    := "(" formula ")" | chain of relations
//! ```

use kane_kernel::Relation;

use super::error::{SyntaxError, SyntaxErrorKind};
use super::lexer::{self, Token};
use super::links::RelationNode;
use super::logic;
use super::names::CONNECTIVES;
use super::parser::{Node, Parser};

/// Tokens of a group that are looked through for a comparison.
const MAX_AHEAD: usize = 50_000;

/// Relations that are meant together.
type Part = Vec<RelationNode>;

impl Parser<'_> {
    /// Passes one formula, whose first side may have been passed already.
    pub(crate) fn formula(&mut self, first: Option<Node>) -> Result<Part, SyntaxError> {
        let part = self.part(first)?;
        match CONNECTIVES.contains(&self.lexeme()) {
            true => self.connected_with(part),
            false => Ok(part),
        }
    }

    /// Passes what is connected with the part that was passed first.
    fn connected_with(&mut self, part: Part) -> Result<Part, SyntaxError> {
        let left = self.clause(part)?;
        if !self.accept_word("iff") {
            return Ok(left);
        }
        let right = self.part(None)?;
        let right = self.clause(right)?;
        self.once("iff")?;
        self.connected(vec![left, right], |parts| two(parts, logic::iff))
    }

    fn clause(&mut self, first: Part) -> Result<Part, SyntaxError> {
        let left = self.choice(first)?;
        if !self.accept_word("implies") {
            return Ok(left);
        }
        let right = self.part(None)?;
        let right = self.choice(right)?;
        self.once("implies")?;
        self.connected(vec![left, right], |parts| two(parts, logic::implies))
    }

    fn choice(&mut self, first: Part) -> Result<Part, SyntaxError> {
        let mut parts = vec![self.both(first)?];
        while self.at_word("or") {
            self.within_list(parts.len())?;
            self.advance();
            let next = self.part(None)?;
            parts.push(self.both(next)?);
        }
        match parts.len() {
            1 => Ok(parts.swap_remove(0)),
            _ => self.connected(parts, |parts| Some(logic::or(parts))),
        }
    }

    fn both(&mut self, mut links: Part) -> Result<Part, SyntaxError> {
        while self.at_word("and") {
            self.within_list(links.len())?;
            self.advance();
            links.extend(self.part(None)?);
        }
        Ok(links)
    }

    fn part(&mut self, first: Option<Node>) -> Result<Part, SyntaxError> {
        if first.is_none() && self.at_formula() {
            return self.formula_in_parentheses();
        }
        let first = match first {
            Some(first) => first,
            None => self.left_side()?,
        };
        let mut links = Vec::new();
        self.chain(first, &mut links)?;
        Ok(links)
    }

    fn formula_in_parentheses(&mut self) -> Result<Part, SyntaxError> {
        let open = self.span();
        self.advance();
        let inner = self.nested(|p| p.formula(None))?;
        self.close(Token::CloseParen, '(', &open)?;
        Ok(inner)
    }

    /// Whether a formula in parentheses is ahead.
    pub(crate) fn at_formula(&self) -> bool {
        self.token() == Token::OpenParen && self.group_compares()
    }

    /// Whether a comparison stands in the group that is ahead: then it is a formula, as in an
    /// expression comparisons stand between braces only.
    fn group_compares(&self) -> bool {
        let (text, mut at) = self.ahead();
        let (mut depth, mut braces) = (0_usize, 0_usize);
        for _ in 0..MAX_AHEAD {
            let (token, span) = lexer::next(text, at);
            at = span.end;
            match token {
                Token::OpenParen => depth += 1,
                Token::CloseParen if depth <= 1 => return false,
                Token::CloseParen => depth -= 1,
                Token::OpenBrace => braces += 1,
                Token::CloseBrace => braces = braces.saturating_sub(1),
                Token::Rel(_) if braces == 0 => return true,
                Token::End => return false,
                _ => {}
            }
        }
        false
    }

    /// A second `implies` or `iff` beside the first could mean two things.
    fn once(&self, word: &'static str) -> Result<(), SyntaxError> {
        match self.at_word(word) {
            true => Err(self.fault(SyntaxErrorKind::Ambiguous(word))),
            false => Ok(()),
        }
    }

    /// One relation that is made of parts.
    fn connected(
        &self,
        parts: Vec<Part>,
        make: impl FnOnce(Vec<Vec<Relation>>) -> Option<Relation>,
    ) -> Result<Part, SyntaxError> {
        let all = || parts.iter().flatten();
        let start = all().map(|link| link.span.start).min().unwrap_or(0);
        let end = all().map(|link| link.span.end).max().unwrap_or(0);
        // `implies` puts `cases` into `cases`
        let height = all().map(|link| link.height).max().unwrap_or(0) + 2;
        let relations = |part: Part| part.into_iter().map(|l| l.relation).collect();
        let relation = make(parts.into_iter().map(relations).collect());
        let relation = relation.into_iter().map(|relation| {
            self.within_height(height, &(start..end))?;
            Ok(RelationNode { relation, span: start..end, height })
        });
        relation.collect()
    }
}

/// A relation made of the first two parts.
fn two(
    parts: Vec<Vec<Relation>>,
    make: fn(Vec<Relation>, Vec<Relation>) -> Relation,
) -> Option<Relation> {
    let mut parts = parts.into_iter();
    Some(make(parts.next()?, parts.next()?))
}
