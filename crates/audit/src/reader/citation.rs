//! What statements cite: labels become indices, and what cannot be cited is refused.

use std::collections::{BTreeSet, HashSet};
use std::ops::Range;

use kane_kernel::{Expr, Link, Relation, Sentence};

use super::tie::{self, Ties};
use super::{Fault, MAX_FAULTS, Reader, label};
use crate::{Body, Claim, Content, Existence, Induction, Parts, Statement, Verdict};

/// A statement before its citations are resolved.
#[derive(Debug)]
pub(super) struct Draft {
    pub(super) label: String,
    pub(super) parts: Parts,
    pub(super) body: DraftBody,
    pub(super) span: Range<usize>,
    pub(super) line: usize,
}

#[derive(Debug)]
pub(super) enum DraftBody {
    Let(usize),
    /// the components of a vector or a matrix; none for a definition with arguments
    Defined(Vec<usize>),
    Given(Sentence),
    Claim(DraftClaim),
    /// a statement with a fault, kept for its label
    Broken,
}

#[derive(Debug)]
pub(super) struct DraftClaim {
    pub(super) content: DraftContent,
    /// whether it says that something exists, for which a witness is put in
    pub(super) exists: bool,
    /// the names for which a witness is looked for
    pub(super) sought: Vec<String>,
    pub(super) when: Vec<Relation>,
    pub(super) induction: Option<Induction>,
    pub(super) from: Vec<Cited>,
    pub(super) using: Vec<Expr>,
    pub(super) by: Vec<(usize, Expr)>,
    pub(super) expect: Option<Verdict>,
}

#[derive(Debug)]
pub(super) enum DraftContent {
    Links(Vec<(Link, Range<usize>)>),
    Contradiction,
    NotImplied(Cited),
}

/// A label where it is cited.
#[derive(Clone, Debug)]
pub(super) struct Cited {
    pub(super) label: String,
    pub(super) span: Range<usize>,
    /// of `d(LABEL, t)`: what is differentiated, and by which variable
    pub(super) derivative: Option<(Box<Self>, String)>,
}

/// The citations of a statement as indices.
#[derive(Debug, Default)]
struct Resolved {
    from: Vec<usize>,
    target: Option<usize>,
}

impl Reader {
    /// The finished statements, once all labels are known; faults are noted.
    pub(super) fn resolve(&mut self) -> Vec<Statement> {
        let mut faults = Vec::new();
        let mut ties = Ties::new(&self.scope, &self.drafts);
        let mut resolved: Vec<Resolved> = Vec::with_capacity(self.drafts.len());
        for index in 0..self.drafts.len() {
            let found = self.citations(index, &mut ties, &mut faults);
            faults.extend(self.beside_shift(index, &found.from, &resolved));
            resolved.push(found);
        }
        self.faults.extend(faults);
        let (drafts, units) = (std::mem::take(&mut self.drafts), !self.units.is_empty());
        drafts
            .into_iter()
            .zip(resolved)
            .filter_map(|(draft, resolved)| draft.finish(resolved, units))
            .collect()
    }

    fn citations(&self, index: usize, ties: &mut Ties<'_>, faults: &mut Vec<Fault>) -> Resolved {
        let Some(DraftBody::Claim(claim)) = self.drafts.get(index).map(|draft| &draft.body) else {
            return Resolved::default();
        };
        let mut resolved = Resolved::default();
        let mut seen = HashSet::new();
        let mut cites = Vec::new();
        for cited in &claim.from {
            if faults.len() > MAX_FAULTS {
                break;
            }
            match self.cite(index, cited) {
                Ok(premise) => {
                    for said in self.with_sources(premise) {
                        if seen.insert(said) {
                            resolved.from.push(said);
                            cites.push((said, cited));
                        }
                    }
                }
                Err(_) if self.may_be_lost(&cited.label) => {}
                Err(fault) => faults.push(fault),
            }
        }
        if let DraftContent::NotImplied(cited) = &claim.content {
            match self.cite(index, cited) {
                Ok(target) if self.is_definition(target) => {
                    let message = format!("`{}` is a definition, which says nothing", cited.label);
                    faults.push(Fault::new(cited.span.clone(), message));
                }
                Ok(target) if self.is_existence(target) => {
                    let message = format!("`{}` says that something exists", cited.label);
                    let note = "that its witness does not do says nothing of others";
                    faults.push(Fault::new(cited.span.clone(), message).with_note(note));
                }
                Ok(target) => resolved.target = Some(target),
                Err(fault) => faults.push(fault),
            }
        }
        let stated =
            [index].into_iter().chain(resolved.from.iter().copied()).chain(resolved.target);
        let ranges: Vec<(usize, Cited)> = self.ranges_of(stated, index);
        let fresh = ranges.iter().filter(|(given, _)| seen.insert(*given));
        cites.extend(fresh.map(|(given, cited)| (*given, cited)));
        faults.extend(ties.find(index, &cites, resolved.target));
        let spoken =
            [index].into_iter().chain(resolved.from.iter().copied()).chain(resolved.target);
        let spoken: Vec<usize> = spoken.collect();
        faults.extend(self.index_beside_variation(index, &spoken));
        let mut made: BTreeSet<usize> = ranges.iter().map(|(given, _)| *given).collect();
        if self.circles.is_empty() && self.exponentials.is_empty() && made.is_empty() {
            return resolved;
        }
        let mut symbols = BTreeSet::new();
        let spoken = spoken.iter().chain(&made);
        for body in spoken.filter_map(|i| Some(&self.drafts.get(*i)?.body)) {
            symbols.extend(tie::limits(body));
            symbols.extend(tie::sides(body).into_iter().flat_map(|side| self.scope.symbols(side)));
        }
        made.extend(self.bounds_of(&symbols));
        made.extend(self.arcs_of(&symbols));
        made.extend(self.circles_of(&symbols));
        let fresh = made.into_iter().filter(|given| !resolved.from.contains(given));
        resolved.from.extend(fresh.collect::<Vec<_>>());
        resolved
    }

    /// That a limit at a point that is no number rests on something that speaks of what tends to it: the limit is
    /// taken in the distance from the point, of which that says nothing.
    fn beside_shift(&self, index: usize, from: &[usize], above: &[Resolved]) -> Option<Fault> {
        let body = |i: usize| Some(&self.drafts.get(i)?.body);
        let limits = tie::limits(body(index)?);
        let moving: Vec<usize> =
            limits.into_iter().filter_map(|v| self.scope.shifted_by(v)).collect();
        let x = *moving.first()?;
        let name = self.scope.context().vars.get(x).map_or("?", |var| &var.name);
        let at = self.drafts.get(index).map(|draft| draft.parts.content.clone())?;
        if self.ranges.contains_key(&x) {
            let message = format!(
                "`{name}` is bounded by other symbols, and tends to a point that is no number"
            );
            return Some(Fault::new(at, message));
        }
        let (mut todo, mut seen) = (from.to_vec(), BTreeSet::new());
        while let Some(premise) = todo.pop() {
            if !seen.insert(premise) {
                continue;
            }
            todo.extend(above.get(premise).into_iter().flat_map(|resolved| &resolved.from));
            let Some(said) = body(premise) else { continue };
            let varies = tie::limits(said).contains(&x)
                || tie::sides(said).into_iter().any(|side| self.scope.varies_with(side, x));
            if varies {
                let label = self.drafts.get(premise).map_or("", |draft| &draft.label);
                let message = format!(
                    "`{label}` speaks of `{name}`, which tends to a point that is no number"
                );
                let note = "such a limit rests on what is said of other symbols alone; state it of their distance";
                return Some(Fault::new(at, message).with_note(note));
            }
        }
        None
    }

    /// A premise, and before it what it is the derivative of.
    fn with_sources(&self, mut premise: usize) -> Vec<usize> {
        let mut chain = vec![premise];
        while let Some(base) = self.derived.get(&premise) {
            chain.insert(0, *base);
            premise = *base;
        }
        chain
    }

    fn is_definition(&self, index: usize) -> bool {
        let draft = self.drafts.get(index);
        draft.is_some_and(|draft| matches!(draft.body, DraftBody::Let(_) | DraftBody::Defined(_)))
    }

    fn is_existence(&self, index: usize) -> bool {
        let draft = self.drafts.get(index);
        draft.is_some_and(|d| matches!(&d.body, DraftBody::Claim(claim) if claim.exists))
    }

    /// The index of the cited statement, if it can be cited there.
    fn cite(&self, index: usize, cited: &Cited) -> Result<usize, Fault> {
        let label = &cited.label;
        let fault = |message| Fault::new(cited.span.clone(), message);
        let key = label::key(label);
        let Some(&premise) = self.labels.get(&key) else {
            let mut fault = fault(format!("undeclared label `{label}`"));
            fault.note = self.hint_at_label(&key);
            return Err(fault);
        };
        if premise == index {
            return Err(fault(format!("cycle: `{label}` cites itself")));
        }
        let Some(draft) = self.drafts.get(premise) else {
            return Ok(premise);
        };
        if premise > index {
            let note = format!("`{}` stands on line {}", draft.label, draft.line);
            return Err(fault(format!("premise below its use: `{label}`")).with_note(note));
        }
        match &draft.body {
            DraftBody::Claim(DraftClaim {
                content: DraftContent::Contradiction | DraftContent::NotImplied(_),
                ..
            }) => Err(fault(format!("`{label}` states nothing that could be used"))
                .with_note("it is a `contradiction` or a `not implied`")),
            _ => Ok(premise),
        }
    }
}

impl Draft {
    /// The statement; `None` if it is broken.
    fn finish(self, resolved: Resolved, units: bool) -> Option<Statement> {
        let body = match self.body {
            DraftBody::Broken => return None,
            DraftBody::Let(definition) => Body::Let(definition),
            DraftBody::Defined(parts) => Body::Defined(parts),
            DraftBody::Given(sentence) => Body::Given(sentence),
            DraftBody::Claim(claim) => Body::Claim(Claim {
                content: match claim.content {
                    DraftContent::Links(links) if !claim.sought.is_empty() => {
                        Content::Sought(Existence { names: claim.sought, links, units })
                    }
                    DraftContent::Links(links) => Content::Links(links),
                    DraftContent::Contradiction => Content::Contradiction,
                    DraftContent::NotImplied(_) => Content::NotImplied(resolved.target?),
                },
                exists: claim.exists,
                found: Vec::new(),
                when: claim.when,
                induction: claim.induction,
                from: resolved.from,
                using: claim.using,
                by: claim.by,
                expect: claim.expect,
            }),
        };
        let Self { label, parts, span, line, .. } = self;
        Some(Statement { label, body, span, parts, line })
    }
}
