//! Indices, sequences, and claims that are shown by induction.
//!
//! What is said of an index is said of all natural numbers. So a `given` may not speak of one: what is
//! assumed of a single n could not be used one step further. And an index keeps away from what varies
//! continuously: the symbol of a power does not tell that it varies with its base.

use std::ops::Range;

use kane_algebra::syntax::{MAX_INDEX, Parser, Scope, Symbol, SyntaxError, SyntaxErrorKind, Token};
use kane_kernel::{Expr, Link, Rel, Relation};
use num_rational::BigRational;

use super::citation::{DraftBody, DraftClaim, DraftContent};
use super::symbol::Item;
use super::{Fault, Reader, tie};
use crate::{Induction, Parts};

/// A name and where it stands.
type Named = (String, Range<usize>);

/// A sequence by its first term and its step, in which a placeholder is the term before.
pub(super) struct Recursion {
    /// the index, and where it stands
    index: (String, Range<usize>),
    first: Expr,
    next: Expr,
}

/// `for n >= 1`
#[derive(Clone, Copy)]
pub(super) struct From {
    index: usize,
    from: u32,
}

impl From {
    /// The condition that it is.
    pub(super) fn condition(&self) -> Relation {
        let from = Expr::Num(BigRational::from_integer(self.from.into()));
        Relation { lhs: Expr::Var(self.index), rel: Rel::Ge, rhs: from }
    }
}

/// The index that is the only parameter of a definition.
pub(super) fn index(scope: &Scope, parameters: &[Named]) -> Option<usize> {
    match parameters {
        [(name, _)] => index_named(scope, name),
        _ => None,
    }
}

fn index_named(scope: &Scope, name: &str) -> Option<usize> {
    match scope.resolve(name) {
        Some(Symbol::Var(v)) if scope.sequences().index_of(v) == Some(v) => Some(v),
        _ => None,
    }
}

/// Passes the `0` of `s(0)`.
pub(super) fn zero(p: &mut Parser<'_>) -> Result<(), SyntaxError> {
    if p.lexeme() != "0" {
        return Err(p.unexpected("`0` (a sequence begins there), or names of arguments"));
    }
    p.advance();
    Ok(())
}

/// Passes `FIRST, s(n + 1) := NEXT` behind `let s(0) :=`.
pub(super) fn recursion(
    p: &mut Parser<'_>,
    name: &Option<Named>,
) -> Result<Recursion, SyntaxError> {
    let name = name.as_ref().map_or("", |(name, _)| name);
    let first = p.expr()?;
    let again = format!("`, {name}(n + 1) :=` and the step of the sequence");
    p.expect(Token::Comma, &again)?;
    let (other, at) = p.name()?;
    if other != name {
        let found = format!("`{other}`");
        let kind = SyntaxErrorKind::Expected { expected: format!("`{name}`"), found };
        return Err(SyntaxError { kind, span: at });
    }
    p.expect(Token::OpenParen, "`(` and the index")?;
    let (n, at) = p.name()?;
    p.expect(Token::Plus, "`+ 1` behind the index")?;
    if p.lexeme() != "1" {
        return Err(p.unexpected("`1` (a step leads from `n` to `n + 1`)"));
    }
    p.advance();
    p.expect(Token::CloseParen, "`)` behind the index")?;
    p.expect(Token::Define, "`:=` and the step")?;
    let n = n.to_owned();
    match index_named(p.scope(), &n) {
        Some(index) => p.bind_term(name, index),
        None => {
            p.report(SyntaxErrorKind::NotAnIndex(n.clone()), at.clone());
            // so that the term is no further fault
            p.bind_term(name, usize::MAX);
        }
    }
    let next = p.expr()?;
    Ok(Recursion { index: (n, at), first, next })
}

/// Passes `for n >= 1`, if it is ahead.
pub(super) fn range(
    p: &mut Parser<'_>,
    content: &DraftContent,
) -> Result<Option<From>, SyntaxError> {
    if !p.at_word("for") {
        return Ok(None);
    }
    let relations = |links: &[(Link, Range<usize>)]| {
        links.iter().all(|(link, _)| matches!(link, Link::Relation(_)))
    };
    if !matches!(content, DraftContent::Links(links) if relations(links)) {
        return Err(p.unexpected("the end (only relations take `for`)"));
    }
    p.advance();
    let (name, at) = p.name()?;
    let Some(index) = index_named(p.scope(), name) else {
        return Err(SyntaxError { kind: SyntaxErrorKind::NotAnIndex(name.to_owned()), span: at });
    };
    if p.token() != Token::Rel(Rel::Ge) {
        return Err(p.unexpected("`>=` and the first value of the index"));
    }
    p.advance();
    let from = p.lexeme().parse::<u32>().ok().filter(|n| *n <= MAX_INDEX);
    match (p.token(), from) {
        (Token::Number, Some(from)) => {
            p.advance();
            Ok(Some(From { index, from }))
        }
        _ => Err(p.unexpected("a natural number up to 64")),
    }
}

/// Passes `induction` behind `by`.
pub(super) fn induction(p: &mut Parser<'_>, range: Option<From>) -> Result<Induction, SyntaxError> {
    if !p.accept_word("induction") {
        return Err(p.unexpected(
            "`induction` (only `exists` and `not implied` take values; labels stand behind `from`)",
        ));
    }
    match range {
        Some(From { index, from }) => Ok(Induction { index, from }),
        None => Err(p.unexpected("`for n >= 0` behind the relation, which `by induction` needs")),
    }
}

impl Reader {
    /// Enters an index.
    pub(super) fn declare_index(&mut self, item: &Item) {
        if item.is_bounded() || item.of.is_some() {
            let message = format!("the index `{}` has no bounds, and is no function", item.name);
            let note = "it is 0, 1, 2, …; a claim states its range by `for n >= 1`, or by `when`";
            self.faults.push(Fault::new(item.whole.clone(), message).with_note(note));
        }
        if self.wanted.parts(&item.name).is_some() {
            let message = format!("`{}` is an index, and no angle", item.name);
            self.faults.push(Fault::new(item.whole.clone(), message));
        }
        match self.scope.declare_index(&item.name) {
            Ok(_) => self.var_sites.push(item.span.start),
            Err(error) => self.refuse(&error, item.span.clone()),
        }
    }

    /// Enters the symbols of the powers whose base and index are declared by now.
    pub(super) fn declare_powers(&mut self, site: usize) {
        for (base, n) in self.wanted.clone().powers() {
            let Some(index) = index_named(&self.scope, n) else { continue };
            let number = base.parse::<u64>().ok().filter(|n| n.to_string() == *base);
            let (name, base) = match (number, self.scope.resolve(base)) {
                (Some(number), _) => {
                    (base.clone(), Expr::Num(BigRational::from_integer(number.into())))
                }
                (None, Some(Symbol::Var(v))) => {
                    let var = self.scope.context().vars.get(v);
                    (var.map_or_else(String::new, |var| var.name.clone()), Expr::Var(v))
                }
                (None, Some(Symbol::Let(i))) => {
                    let definition = self.scope.context().lets.get(i);
                    (definition.map_or_else(String::new, |d| d.name.clone()), Expr::Let(i))
                }
                (None, None) => continue,
            };
            if self.scope.has_power(&name, index) || !self.scope.is_total(&base, None) {
                continue;
            }
            if let Err(error) = self.scope.declare_power(&name, base, index) {
                self.refuse(&error, site..site);
            }
            self.var_sites.resize(self.scope.context().vars.len(), site);
        }
    }

    /// Enters the symbols of the sums up to an index that stand in the statement that is read next for the
    /// first time.
    pub(super) fn declare_sums(&mut self, site: usize) {
        let names: Vec<String> = self.wanted.sums(self.count).map(str::to_owned).collect();
        for name in names {
            let sum = Parser::new(&name, 0, &self.scope).sum_to_declare();
            let Some(sum) = sum.filter(|sum| self.scope.sum(sum).is_none()) else { continue };
            if let Err(error) = self.scope.declare_sum(&name, sum) {
                self.refuse(&error, site..site);
            }
            self.var_sites.resize(self.scope.context().vars.len(), site);
        }
    }

    /// Enters a sequence by its term.
    pub(super) fn define_term(
        &mut self,
        name: &str,
        site: Range<usize>,
        index: Option<usize>,
        term: Expr,
    ) -> DraftBody {
        let Some(index) = index else { return DraftBody::Broken };
        match self.scope.declare_sequence(name, index, term) {
            Ok(()) => DraftBody::Defined(Vec::new()),
            Err(error) => {
                self.refuse(&error, site);
                DraftBody::Broken
            }
        }
    }

    /// Enters a sequence by its first term and its step.
    pub(super) fn define_recursion(
        &mut self,
        name: &str,
        site: Range<usize>,
        parts: Recursion,
    ) -> DraftBody {
        let Some(index) = index_named(&self.scope, &parts.index.0) else {
            return DraftBody::Broken;
        };
        for (part, own, what) in
            [(&parts.first, None, "first term"), (&parts.next, Some(index), "step")]
        {
            if !self.scope.is_total(part, own) {
                let message = format!("the {what} of `{name}` may have no value somewhere");
                let note = "a polynomial in plain symbols and terms at its own index has one, also divided \
                            by numbers and by symbols that are not 0 by their bounds";
                self.faults.push(Fault::new(site, message).with_note(note));
                return DraftBody::Broken;
            }
        }
        let step =
            |term: &Expr| kane_algebra::syntax::put_in(&parts.next, std::slice::from_ref(term));
        let defined = self.scope.declare_recursion(name, index, parts.first.clone(), step);
        self.var_sites.resize(self.scope.context().vars.len(), site.start);
        match defined {
            Ok(()) => DraftBody::Defined(Vec::new()),
            Err(error) => {
                self.refuse(&error, site);
                DraftBody::Broken
            }
        }
    }

    fn speaks_of_index(&self, e: &Expr) -> bool {
        let sequences = self.scope.sequences();
        !sequences.is_empty()
            && self.scope.symbols(e).into_iter().any(|v| sequences.index_of(v).is_some())
    }

    /// Whether a plain definition speaks of no index; otherwise that is noted.
    pub(super) fn is_free_of_indices(
        &mut self,
        name: &str,
        site: &Range<usize>,
        parts: &[Expr],
    ) -> bool {
        if !parts.iter().any(|part| self.speaks_of_index(part)) {
            return true;
        }
        let message = format!("`{name}` varies with an index");
        let note = format!("say so: `let {name}(n) := …`");
        self.faults.push(Fault::new(site.clone(), message).with_note(note));
        false
    }

    /// Notes what may not speak of an index: givens, and the conditions of an induction.
    pub(super) fn refuse_indices(&mut self, body: &DraftBody, parts: &Parts) {
        let speaks = |sides: Vec<&Expr>| sides.iter().any(|side| self.speaks_of_index(side));
        let (message, note, at) = match body {
            DraftBody::Given(_) if speaks(tie::sides(body)) => (
                "a `given` speaks of no index",
                "what holds for every n is defined, `let s(0) := …, s(n + 1) := …`, or claimed; what is to \
                 hold for some is a `when`",
                parts.content.clone(),
            ),
            DraftBody::Claim(DraftClaim { induction: Some(_), when, .. })
                if speaks(when.iter().skip(1).flat_map(|r| [&r.lhs, &r.rhs]).collect()) =>
            {
                (
                    "the `when` of an induction speaks of no index",
                    "what holds under a condition at n need not be known at n + 1; its range stands \
                     behind `for`",
                    parts.when.clone().unwrap_or_default(),
                )
            }
            _ => return,
        };
        self.faults.push(Fault::new(at, message.to_owned()).with_note(note));
    }

    /// That a claim, or something that it cites, speaks of an index, and it or another of them of
    /// functions, derivatives or limits.
    pub(super) fn index_beside_variation(&self, index: usize, spoken: &[usize]) -> Option<Fault> {
        if self.scope.sequences().is_empty() {
            return None;
        }
        let (mut of_index, mut varies) = (false, false);
        for body in spoken.iter().filter_map(|i| Some(&self.drafts.get(*i)?.body)) {
            for limit in tie::limits(body) {
                varies = true;
                of_index |= self.scope.sequences().index_of(limit).is_some();
            }
            for side in tie::sides(body) {
                of_index |= self.speaks_of_index(side);
                self.scope.visit(side, &mut |node| match node {
                    Expr::Deriv(..) => varies = true,
                    Expr::Var(v) => {
                        let var = self.scope.context().vars.get(*v);
                        varies |= var.is_some_and(|var| var.of.is_some());
                    }
                    _ => {}
                });
            }
        }
        if !(of_index && varies) {
            return None;
        }
        let at = self.drafts.get(index).map(|draft| draft.parts.label.clone());
        let message = "an index does not go with functions, derivatives and limits".to_owned();
        let note = "not in one claim, nor in what it cites: the power `q^n` does not tell how it varies with \
                    `q`; in place of `s(n) -> L as n -> oo` claim a bound for all n, such as `abs(s(n) - L) <= c*q^n`";
        Some(Fault::new(at.unwrap_or_default(), message).with_note(note))
    }
}
