//! Relations, chains, comma lists and limits.

use std::ops::Range;

use kane_kernel::{Approach, Context, Expr, Limit, Link, Relation, Sentence, Target, Var};
use num_rational::BigRational;
use num_traits::Zero as _;

use super::angle::Turn;
use super::error::{SyntaxError, SyntaxErrorKind};
use super::eval::eval;
use super::lexer::{self, Token};
use super::names::{CONNECTIVES, PI};
use super::parser::{Node, Parser, excerpt};
use super::scope::Symbol;
use super::shift::{Motion, Point};

/// Tokens that are looked at to see where a symbol stands beside its bounds.
const MOST_AHEAD: usize = 1000;

/// A relation with its place and the height of its taller side.
pub(crate) struct RelationNode {
    pub(crate) relation: Relation,
    pub(crate) span: Range<usize>,
    pub(crate) height: usize,
}

/// A link before the `as` clause has told where the limit variable goes.
enum Open {
    Relation(Relation),
    Limit(Expr, Target, Range<usize>),
}

impl Parser<'_> {
    /// Passes a comma list of relations and chains; a chain counts as its links.
    ///
    /// # Errors
    /// On any fault after which the structure is unclear.
    pub fn relations(&mut self) -> Result<Vec<Relation>, SyntaxError> {
        let links = self.guard_links()?;
        Ok(links.into_iter().map(|link| link.relation).collect())
    }

    /// As [`Parser::relations`], each link with its place.
    ///
    /// # Errors
    /// As [`Parser::relations`].
    pub fn spanned_relations(&mut self) -> Result<Vec<(Relation, Range<usize>)>, SyntaxError> {
        let links = self.guard_links()?;
        Ok(links.into_iter().map(|link| (link.relation, link.span)).collect())
    }

    pub(crate) fn guard_links(&mut self) -> Result<Vec<RelationNode>, SyntaxError> {
        let mut links = Vec::new();
        loop {
            links.extend(self.formula(None)?);
            if !self.next_item(links.len())? {
                return Ok(links);
            }
        }
    }

    pub(crate) fn left_side(&mut self) -> Result<Node, SyntaxError> {
        match self.token() {
            Token::Rel(_) | Token::Arrow => Err(self.fault(SyntaxErrorKind::NoLeftSide)),
            _ => self.node(),
        }
    }

    fn right_side(&mut self, operator: &Range<usize>) -> Result<Node, SyntaxError> {
        let missing = match self.token() {
            Token::Rel(_)
            | Token::Arrow
            | Token::Comma
            | Token::Semicolon
            | Token::Colon
            | Token::End => true,
            Token::Name => {
                let word = self.lexeme();
                ["when", "from", "using", "expect", "by", "as"].contains(&word)
                    || CONNECTIVES.contains(&word)
            }
            _ => false,
        };
        if missing {
            let nothing =
                SyntaxError { kind: SyntaxErrorKind::NoRightSide, span: operator.clone() };
            return Err(self.foreign_operator().unwrap_or(nothing));
        }
        self.node()
    }

    /// Passes `⋈ b ⋈ c …` after the side `left`.
    pub(crate) fn chain(
        &mut self,
        left: Node,
        links: &mut Vec<RelationNode>,
    ) -> Result<(), SyntaxError> {
        let alone = left.span.clone();
        let mut left = left;
        let mut linked = false;
        while let Token::Rel(rel) = self.token() {
            self.within_list(links.len())?;
            linked = true;
            let operator = self.span();
            self.advance();
            let right = self.right_side(&operator)?;
            let next = matches!(self.token(), Token::Rel(_)).then(|| right.clone());
            links.extend(self.compared(left, rel, right)?);
            match next {
                Some(node) => left = node,
                None => break,
            }
        }
        if self.token() == Token::Arrow {
            return Err(self.fault(SyntaxErrorKind::MisplacedLimit));
        }
        if linked {
            return Ok(());
        }
        // what follows an expression tells whether a relation or an operator was forgotten
        match self.token() {
            Token::End | Token::Comma | Token::Colon | Token::Semicolon => {
                Err(SyntaxError { kind: SyntaxErrorKind::NoRelation, span: alone })
            }
            Token::Name if CONNECTIVES.contains(&self.lexeme()) => {
                Err(SyntaxError { kind: SyntaxErrorKind::NoRelation, span: alone })
            }
            _ => Err(self.missing_operator().unwrap_or_else(|| self.unexpected("a relation"))),
        }
    }

    /// Passes `RELATION [as x -> a]`: links with their places.
    ///
    /// # Errors
    /// On any fault after which the structure is unclear.
    pub fn links(&mut self) -> Result<Vec<(Link, Range<usize>)>, SyntaxError> {
        let mut open = Vec::new();
        loop {
            let first = if self.at_formula() { None } else { Some(self.left_side()?) };
            match first {
                Some(first) if self.token() == Token::Arrow => open.push(self.limit(first)?),
                first => {
                    let links = self.formula(first)?;
                    open.extend(links.into_iter().map(|l| (Open::Relation(l.relation), l.span)));
                }
            }
            if !self.next_item(open.len())? {
                break;
            }
        }
        let has_limit = open.iter().any(|(link, _)| matches!(link, Open::Limit(..)));
        if !self.at_word("as") {
            if has_limit {
                return Err(self.fault(SyntaxErrorKind::LimitWithoutAs));
            }
        } else if !has_limit {
            return Err(self.fault(SyntaxErrorKind::AsWithoutLimit));
        }
        let motion = if has_limit { self.motion()? } else { None };
        Ok(self.close_links(open, motion))
    }

    fn limit(&mut self, expr: Node) -> Result<(Open, Range<usize>), SyntaxError> {
        let operator = self.span();
        self.advance();
        let start = self.span().start;
        let to = match self.infinity()? {
            Some(positive) if positive => Target::PlusInf,
            Some(_) => Target::MinusInf,
            None => {
                let value = self.right_side(&operator)?;
                Target::Finite(self.number_of(value))
            }
        };
        if matches!(self.token(), Token::Rel(_) | Token::Arrow) {
            return Err(self.fault(SyntaxErrorKind::MisplacedLimit));
        }
        let (from, end) = (expr.span.start, self.last_end());
        Ok((Open::Limit(self.number_of(expr), to, start..end), from..end))
    }

    /// Passes `oo`, `+oo` or `-oo` and tells whether it was positive; passes nothing else.
    ///
    /// # Errors
    /// Never by itself; the type serves its callers.
    fn infinity(&mut self) -> Result<Option<bool>, SyntaxError> {
        let (rest, _) = self.rest();
        let unsigned = rest.strip_prefix(['-', '−', '+']).map_or(rest, str::trim_start);
        let after = unsigned.strip_prefix('∞').or_else(|| unsigned.strip_prefix("oo"));
        let is_infinite = after.is_some_and(|after| {
            unsigned.starts_with('∞') || !after.starts_with(super::letters::is_name_part)
        });
        if !is_infinite {
            return Ok(None);
        }
        let negative = self.accept(Token::Minus);
        if !negative {
            self.accept(Token::Plus);
        }
        self.expect(Token::Infinity, "`oo`")?;
        Ok(Some(!negative))
    }

    /// Passes `as x -> a`. `None` after a fault that was recorded.
    fn motion(&mut self) -> Result<Option<Motion>, SyntaxError> {
        self.advance();
        let (name, name_span) = self.name()?;
        self.expect(Token::Arrow, "`->` after the limit variable")?;
        let start = self.span().start;
        let at = self.approach()?;
        let point_span = start..self.last_end();
        let var = match self.scope().resolve(name) {
            Some(Symbol::Var(var)) => var,
            Some(Symbol::Let(_)) => {
                self.report(SyntaxErrorKind::NotALimitVariable(excerpt(name)), name_span);
                return Ok(None);
            }
            None => {
                self.report(SyntaxErrorKind::UnknownSymbol(excerpt(name)), name_span);
                return Ok(None);
            }
        };
        let Some(declared) = self.scope().context().vars.get(var) else {
            return Ok(None);
        };
        let is_index = self.scope().sequences().index_of(var).is_some();
        let at_number = matches!(at, Point::Fixed(_));
        if declared.of.is_none() && !at_number && self.scope().angle(var).is_some() {
            self.report(SyntaxErrorKind::AngleAtASymbol(excerpt(name)), name_span);
            return Ok(None);
        }
        if declared.of.is_some() || !at_number && is_index {
            self.report(SyntaxErrorKind::NotALimitVariable(excerpt(name)), name_span);
            return Ok(None);
        }
        let at = match at {
            Point::Fixed(at) => at,
            Point::At(expr, side, span) => return Ok(self.shifted(var, (expr, side, span))),
        };
        if !reaches(declared, &at) {
            let kind = SyntaxErrorKind::NoLimitPoint(declared.name.clone());
            self.report(kind, point_span);
        }
        Ok(Some(Motion { var, at, put: None }))
    }

    /// Passes the point of a limit: an infinity, or an expression, and perhaps the side of it.
    fn approach(&mut self) -> Result<Point, SyntaxError> {
        match self.infinity()? {
            Some(positive) if positive => return Ok(Point::Fixed(Approach::PlusInf)),
            Some(_) => return Ok(Point::Fixed(Approach::MinusInf)),
            None => {}
        }
        self.side_may_follow = true;
        let point = self.spanned_expr();
        self.side_may_follow = false;
        let (point, span) = point?;
        let side = match self.token() {
            Token::Plus => Some(true),
            Token::Minus => Some(false),
            _ => None,
        };
        if side.is_some() {
            self.advance();
        }
        let Ok(value) = eval(&point, &Context::default(), &[]) else {
            return Ok(Point::At(point, side, span));
        };
        Ok(Point::Fixed(match side {
            Some(true) => Approach::Above(value),
            Some(false) => Approach::Below(value),
            None => Approach::To(value),
        }))
    }

    /// Passes the bound of a symbol: a rational number, a rational multiple of `pi`, an infinity, or
    /// another expression, with its place.
    ///
    /// # Errors
    /// As [`Parser::expr`].
    pub fn bound(&mut self) -> Result<Endpoint, SyntaxError> {
        if let Some(positive) = self.infinity()? {
            return Ok(if positive { Endpoint::PlusInf } else { Endpoint::MinusInf });
        }
        let node = self.with_angles()?;
        let (span, expr) = (node.span.clone(), self.number_of(node));
        if let Ok(value) = eval(&expr, &Context::default(), &[]) {
            return Ok(Endpoint::Finite(value));
        }
        // `L - L` is no angle, though nothing is left of it
        let of_pi = self.scope().symbols(&expr).into_iter().all(|v| v == PI);
        Ok(match Turn::of(&expr) {
            Some(Turn { half_turns, number, .. }) if of_pi && number.is_zero() => {
                Endpoint::HalfTurns(half_turns)
            }
            _ => Endpoint::Expression(expr, span),
        })
    }

    /// Whether what is ahead, up to the next comma, is a bound and then a symbol, and not a symbol first:
    /// `a < x < b` and `2*a < x`, but neither `x < a` nor `x(t) < a`.
    #[must_use]
    pub fn bound_stands_first(&self) -> bool {
        if self.token() != Token::Name {
            return true;
        }
        let mut tokens = Vec::new();
        let (mut depth, mut relations, mut count) = (0_usize, 0, 0);
        let (text, mut at) = self.ahead();
        loop {
            let (token, span) = lexer::next(text, at);
            at = span.end;
            match token {
                bracket if bracket.opens() => depth += 1,
                bracket if bracket.closes() => depth = depth.saturating_sub(1),
                Token::Rel(_) if depth == 0 => relations += 1,
                Token::Comma if depth == 0 => break,
                Token::End => break,
                _ => {}
            }
            count += 1;
            if count > MOST_AHEAD {
                break;
            }
            if relations == 0 {
                tokens.push(token);
            }
        }
        let function = [Token::Name, Token::OpenParen, Token::Name, Token::CloseParen];
        let goes_on = tokens.get(1).is_some_and(|token| {
            use Token::{Caret, Minus, OpenParen, Plus, Slash, Star, Superscript};
            [Plus, Minus, Star, Slash, Caret, Superscript, OpenParen].contains(token)
        });
        relations == 2 || relations == 1 && goes_on && tokens != function
    }

    fn close_links(
        &mut self,
        open: Vec<(Open, Range<usize>)>,
        motion: Option<Motion>,
    ) -> Vec<(Link, Range<usize>)> {
        let mut links = Vec::with_capacity(open.len());
        for (link, span) in open {
            match (link, &motion) {
                (Open::Relation(relation), _) => links.push((Link::Relation(relation), span)),
                (Open::Limit(expr, to, to_span), Some(Motion { var, at, put })) => {
                    let scope = self.scope();
                    let moving = put.as_ref().map_or(*var, |(x, _)| *x);
                    if let Target::Finite(value) = &to
                        && scope.varies_with(value, moving)
                        && let Some(declared) = scope.context().vars.get(moving)
                    {
                        let kind = SyntaxErrorKind::LimitNotFree(declared.name.clone());
                        self.report(kind, to_span);
                    }
                    let written = match put {
                        Some((x, value)) => self.scope().with_value(&expr, *x, value),
                        None => Ok(expr),
                    };
                    let expr = match written {
                        Ok(expr) => expr,
                        Err(kind) => {
                            self.report(kind, span);
                            continue;
                        }
                    };
                    let limit = Limit { expr, to, var: *var, at: at.clone() };
                    links.push((Link::Limit(limit), span));
                }
                // the fault in the `as` clause is recorded already
                (Open::Limit(..), None) => {}
            }
        }
        links
    }

    /// Passes `RELATION [as x -> a] [when RELATION]`.
    ///
    /// # Errors
    /// On any fault after which the structure is unclear.
    pub fn sentence(&mut self) -> Result<Sentence, SyntaxError> {
        let links = self.links()?.into_iter().map(|(link, _)| link).collect();
        let when = if self.accept_word("when") { self.relations()? } else { Vec::new() };
        Ok(Sentence { when, links })
    }
}

/// An end of a range as written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Endpoint {
    /// a number
    Finite(BigRational),
    /// a multiple of π
    HalfTurns(BigRational),
    /// an expression that is neither, and where it stands
    Expression(Expr, Range<usize>),
    /// +∞
    PlusInf,
    /// −∞
    MinusInf,
}

/// Whether the point can be approached, in the way stated, by points of the symbol's range.
fn reaches(var: &Var, at: &Approach) -> bool {
    let lower = var.lower.as_ref().map(|bound| &bound.value);
    let upper = var.upper.as_ref().map(|bound| &bound.value);
    let is_point = lower.is_some() && lower == upper;
    let from_above = |a| lower.is_none_or(|l| l <= a) && upper.is_none_or(|u| a < u);
    let from_below = |a| lower.is_none_or(|l| l < a) && upper.is_none_or(|u| a <= u);
    !is_point
        && match at {
            Approach::To(a) => from_above(a) || from_below(a),
            Approach::Above(a) => from_above(a),
            Approach::Below(a) => from_below(a),
            Approach::PlusInf => upper.is_none(),
            Approach::MinusInf => lower.is_none(),
        }
}
