//! Sums and products over a range: `sum(k^2 for k in 1..n)`.
//!
//! Between numbers they are written out, the term read anew with each number in the place of k. Up to an
//! index they are a sequence by its first term and its step, as `let s(0) := …, s(n + 1) := …` defines one:
//! nothing is known of its symbol but these. A term of such a sum speaks of indices through k alone,
//! since the step from n to n + 1 adds a term and changes no other.

use std::ops::Range;

use kane_kernel::Expr;
use num_bigint::BigInt;

use super::error::{SyntaxError, SyntaxErrorKind};
use super::lexer::{self, Token};
use super::names::canonical_name;
use super::parser::{Node, Parser, excerpt};
use super::scope::Symbol;
use super::sequence::{Linear, MAX_INDEX};
use super::summation::{Summation, joined};
use super::value::size;

/// Sums in each other's terms.
const MOST_NESTED: usize = 8;

/// The sum or product of some terms.
fn total(product: bool, terms: Vec<Expr>) -> Expr {
    let whole = terms.into_iter().reduce(|whole, term| joined(product, whole, term));
    whole.unwrap_or_else(|| Expr::int(i64::from(product)))
}

/// A whole number as an expression, and added to another one.
fn number(n: i64) -> Expr {
    Expr::Num(BigInt::from(n).into())
}

fn shifted(e: Expr, by: i64) -> Expr {
    match by {
        0 => e,
        _ => Expr::Add(e.into(), number(by).into()),
    }
}

/// `sum(f for k in 1..n)` where it stands.
struct Written<'a> {
    product: bool,
    whole: Range<usize>,
    /// of the term: its place in the parser's own text, and in all
    term: (Range<usize>, Range<usize>),
    over: &'a str,
    from: i64,
    to: Linear,
    upper: Range<usize>,
}

impl<'a> Parser<'a> {
    /// The value of a name that a sum runs over; faults are recorded.
    pub(crate) fn local(&mut self, name: &str, span: &Range<usize>) -> Option<Expr> {
        let canonical = canonical_name(name);
        let place = self.locals.iter().rposition(|(known, _)| *known == canonical)?;
        if place < self.fixed {
            self.report(SyntaxErrorKind::IndexInTerm(excerpt(name)), span.clone());
            return Some(Expr::int(1));
        }
        self.locals.get(place).map(|(_, value)| value.clone())
    }

    /// Passes `sum(f for k in a..b)` or `prod(…)`.
    pub(crate) fn summation(&mut self) -> Result<Node, SyntaxError> {
        let written = self.range_of_sum()?;
        let whole = written.whole.clone();
        let found = if written.to.times.is_empty() {
            self.between_numbers(&written)?
        } else {
            self.up_to_index(&written)?
        };
        let e = match found {
            Ok(e) => e,
            Err((kind, span)) => {
                self.report(kind, span);
                Expr::int(1)
            }
        };
        let height = self.scope().height(&e);
        self.build(e, whole, height)
    }

    /// The sum up to an index that the text is, whole, and which is to be declared; nothing if it is none.
    #[must_use]
    pub fn sum_to_declare(mut self) -> Option<Summation> {
        let written = self.range_of_sum().ok()?;
        let (sum, ..) = self.sequence_of_sum(&written).ok()?.ok()?;
        (!self.has_faults()).then_some(sum)
    }

    fn range_of_sum(&mut self) -> Result<Written<'a>, SyntaxError> {
        let (start, word) = (self.span().start, self.lexeme());
        let product = word == "prod";
        if self.locals.len() == MOST_NESTED {
            return Err(self.fault(SyntaxErrorKind::TooNested));
        }
        self.advance();
        let open = self.span();
        self.expect(Token::OpenParen, "`(` after a function's name")?;
        let from_term = self.ahead().1;
        // what was looked at counts, so that many sums without an end are not looked through again
        self.charge(1, &(start..open.end))?;
        let (found, behind) = self.end_of_term();
        self.charge(behind - from_term, &(start..open.end))?;
        let Some(end) = found else {
            let kind = SyntaxErrorKind::NoRange(if product { "prod" } else { "sum" });
            return Err(SyntaxError { kind, span: start..open.end });
        };
        let term = (from_term..end, self.span().start..self.span().start + (end - from_term));
        self.jump(end);
        self.advance();
        let (over, at) = self.name()?;
        let canonical = canonical_name(over).into_owned();
        let taken = self.bound.contains(&canonical)
            || self.locals.iter().any(|(known, _)| *known == canonical);
        if taken || !self.scope().is_unused(over) {
            self.report(SyntaxErrorKind::Shadowed(over.to_owned()), at);
        }
        if !self.accept_word("in") {
            return Err(self.unexpected("`in` and a range, as in `for k in 1..n`"));
        }
        let (from, lower) = self.nested(Self::end_of_range)?;
        self.expect(Token::Dots, "`..` between the ends of a range, as in `1..n`")?;
        let (to, upper) = self.nested(Self::end_of_range)?;
        let end = self.close(Token::CloseParen, '(', &open)?;
        let whole = start..end;
        let fine = from.times.is_empty()
            && (to.times.is_empty() || to.times.len() == 1 && to.times.values().all(|n| *n == 1));
        if !fine {
            let span = if from.times.is_empty() { upper.clone() } else { lower };
            return Err(SyntaxError { kind: SyntaxErrorKind::Range, span });
        }
        Ok(Written { product, whole, term, over, from: from.plus, to, upper })
    }

    /// The byte of the parser's own text at which the `for` of the sum stands whose term is ahead, and the
    /// byte up to which it was looked for.
    fn end_of_term(&self) -> (Option<usize>, usize) {
        let (text, mut at) = self.ahead();
        let mut depth = 0_usize;
        loop {
            let (token, span) = lexer::next(text, at);
            at = span.end;
            match token {
                bracket if bracket.opens() => depth += 1,
                bracket if bracket.closes() => match depth.checked_sub(1) {
                    Some(less) => depth = less,
                    None => return (None, at),
                },
                Token::Name if depth == 0 && text.get(span.clone()) == Some("for") => {
                    return (Some(span.start), at);
                }
                Token::End => return (None, at),
                _ => {}
            }
        }
    }

    /// An end of a range: a whole number, or an index and a whole number.
    fn end_of_range(&mut self) -> Result<(Linear, Range<usize>), SyntaxError> {
        let node = self.node()?;
        let span = node.span.clone();
        let e = self.number_of(node);
        match self.scope().sequences().linear(&e) {
            Some(sum) => Ok((sum, span)),
            None => Err(SyntaxError { kind: SyntaxErrorKind::Range, span }),
        }
    }

    /// The term with a value for what the sum runs over.
    fn term_at(&mut self, written: &Written<'_>, value: Expr) -> Result<Expr, SyntaxError> {
        let (place, span) = &written.term;
        self.charge(place.len(), span)?;
        let back = self.ahead().1;
        self.jump(place.start);
        self.locals.push((canonical_name(written.over).into_owned(), value));
        let term = self.nested(|p| {
            let node = p.node()?;
            Ok(p.number_of(node))
        });
        self.locals.pop();
        let term = term?;
        if self.ahead().1 != place.end {
            return Err(self
                .missing_operator()
                .unwrap_or_else(|| self.unexpected("an operator or `for`")));
        }
        self.jump(back);
        Ok(term)
    }

    /// The terms with all numbers of a range.
    fn terms(&mut self, written: &Written<'_>, to: i64) -> Result<Vec<Expr>, SyntaxError> {
        let (mut terms, before) = (Vec::new(), self.faults());
        for k in written.from..=to {
            terms.push(self.term_at(written, number(k))?);
            // a fault in one is one in all
            if self.faults() > before {
                break;
            }
        }
        Ok(terms)
    }

    fn between_numbers(&mut self, written: &Written<'_>) -> Result<Found<Expr>, SyntaxError> {
        let to = written.to.plus;
        if to.saturating_sub(written.from) >= i64::from(MAX_INDEX) {
            return Ok(Err((SyntaxErrorKind::LongSum, written.whole.clone())));
        }
        if to < written.from {
            // read all the same, for its faults
            self.term_at(written, number(written.from))?;
        }
        let terms = self.terms(written, to)?;
        let parts = terms.iter().map(size).fold(0, usize::saturating_add);
        self.charge(parts, &written.whole)?;
        Ok(Ok(total(written.product, terms)))
    }

    fn up_to_index(&mut self, written: &Written<'_>) -> Result<Found<Expr>, SyntaxError> {
        let before = self.faults();
        let (sum, name, further) = match self.sequence_of_sum(written)? {
            Ok(found) => found,
            Err(fault) => return Ok(Err(fault)),
        };
        if self.faults() > before {
            return Ok(Ok(Expr::int(1)));
        }
        let scope = self.scope();
        // in a finished context it is known by its name
        let named = || match scope.resolve(&name) {
            Some(Symbol::Var(symbol)) => Some(symbol),
            _ => None,
        };
        let Some(symbol) = scope.sum(&sum).or_else(named) else {
            return Ok(Err((SyntaxErrorKind::NoSum(name), written.whole.clone())));
        };
        let mut steps = 0..further;
        let e = steps.try_fold(Expr::Var(symbol), |e, _| scope.sequences().next(&e, sum.index));
        match e.filter(|_| further <= i64::from(MAX_INDEX)) {
            Some(e) => {
                self.charge(size(&e), &written.whole)?;
                Ok(Ok(e))
            }
            None => Ok(Err((SyntaxErrorKind::LongTerm, written.whole.clone()))),
        }
    }

    /// The sequence that a sum up to an index is: what its symbol comes from and its name, and how many
    /// steps beyond the index are meant.
    fn sequence_of_sum(
        &mut self,
        written: &Written<'_>,
    ) -> Result<Found<(Summation, String, i64)>, SyntaxError> {
        let Written { product, from, ref to, .. } = *written;
        let Some(index) = to.times.keys().next().copied() else {
            return Ok(Err((SyntaxErrorKind::Range, written.upper.clone())));
        };
        // the symbol stands for the sum up to n + end, which has no or some terms at n = 0
        let end = from.saturating_sub(1).max(0);
        if to.plus < end {
            let kind = SyntaxErrorKind::HighRange { end: to.plus, least: end };
            return Ok(Err((kind, written.upper.clone())));
        }
        if from.saturating_abs() > i64::from(MAX_INDEX) {
            return Ok(Err((SyntaxErrorKind::LongSum, written.whole.clone())));
        }
        let (fixed, in_term, before) = (self.fixed, self.in_term, self.faults());
        (self.fixed, self.in_term) = (self.locals.len(), true);
        let read = (|| {
            let term = self.term_at(written, shifted(Expr::Var(index), end + 1))?;
            // a fault in one is one in all
            if self.faults() > before {
                return Ok((term, Expr::int(1), Expr::int(1)));
            }
            let at_number = self.term_at(written, number(from))?;
            let first = self.terms(written, end)?;
            Ok((term, at_number, total(product, first)))
        })();
        (self.fixed, self.in_term) = (fixed, in_term);
        let (term, at_number, first) = read?;
        let span = &written.term.1;
        let bound = [&term, &at_number].into_iter().any(|e| self.has_placeholder(e, span));
        if bound || self.faults() > before {
            return Ok(Ok((Summation { product, index, first, term }, String::new(), 0)));
        }
        let scope = self.scope();
        // what is left of an index where a number stands was not there by what the sum runs over
        let numbers = scope.is_total(&at_number, None) && scope.is_total(&first, None);
        if !(numbers && scope.is_total(&term, Some(index))) {
            return Ok(Err((SyntaxErrorKind::PartialTerm, span.clone())));
        }
        let n = scope.context().vars.get(index).map_or("?", |var| &var.name);
        let n = canonical_name(n).into_owned();
        let upper = if end == 0 { n } else { format!("{n} + {end}") };
        let word = if product { "prod" } else { "sum" };
        let (text, over) = (self.plain_term(&written.term.0), canonical_name(written.over));
        let name = format!("{word}({text} for {over} in {from}..{upper})");
        Ok(Ok((Summation { product, index, first, term }, name, to.plus - end)))
    }

    /// The text of a term with single blanks, and in plain letters.
    fn plain_term(&self, place: &Range<usize>) -> String {
        let (text, _) = self.ahead();
        let (mut out, mut at) = (String::new(), place.start);
        loop {
            let (token, span) = lexer::next(text, at);
            if token == Token::End || span.start >= place.end {
                return out;
            }
            if span.start > at && !out.is_empty() {
                out.push(' ');
            }
            at = span.end;
            let lexeme = text.get(span).unwrap_or_default();
            match token {
                Token::Star => out.push('*'),
                Token::Minus => out.push('-'),
                Token::Name => out.push_str(&canonical_name(lexeme)),
                _ => out.push_str(lexeme),
            }
        }
    }
}

/// What a text comes to, or a fault that leaves its structure clear.
type Found<T> = Result<T, (SyntaxErrorKind, Range<usize>)>;
