//! Another proof of what is proved, where that is shorter to read: by what premises say of a symbol alone, and with
//! definitions left as they are.
//!
//! Both are checked by the kernel. The first proves the goal itself. The second proves more, for any values of what is
//! defined, and stands beside a certificate of the goal.

use std::collections::BTreeSet;
use std::rc::Rc;

use kane_algebra::syntax::rebuild;
use kane_kernel::{
    Certificate, Conclusion, Evidence, Expr, Finding, Fuel, Goal, Link, Poly, Rel, Relation,
    Sentence, Var, check, claim_state, digest, scope,
};

use super::{Outcome, Prover, Search, Verdicts, kept};
use crate::argument::{Course, Grounds, contradiction};
use crate::explain;
use crate::kept::Kept;
use crate::spoken::within;

/// States that a search for another proof may visit.
const STEPS: u64 = 150;
/// Coefficient operations of such a search, and of its check, of what the claim may take in all.
const FUEL: u64 = 1_000_000;
/// A proof of less weight is not told in another way.
const SHORT: usize = 30;
/// Search steps beyond which a proof is not looked for again.
const LONG: u64 = 400;

impl Prover<'_> {
    /// Looks for a proof that is shorter to read than what was found.
    pub(super) fn retell(&self, goal: &Goal, out: &mut Verdicts) {
        let Some(decided) = &mut out.decided else { return };
        let (cost, finding) = (out.cost, decided.certificate.finding);
        if finding != Finding::Proved || cost > LONG || !is_told_again(goal, &decided.grounds) {
            return;
        }
        let (defined, opaque) = (defined(goal), opaque(goal));
        if defined.is_empty() && opaque.is_none() {
            return;
        }
        let weight = |goal: &Goal, g: &Grounds| explain::steps(goal, finding, g).weight();
        let mut least = weight(goal, &decided.grounds);
        if least < SHORT {
            return;
        }
        if !defined.is_empty()
            && let Some((certificate, grounds)) = shown(goal, defined, &self.work)
        {
            let other = weight(goal, &grounds);
            if other < least {
                least = other;
                (decided.certificate, decided.grounds) = (certificate, grounds);
            }
        }
        let Some((opaque, definitions)) = opaque else { return };
        for order in [Vec::new(), self::defined(&opaque)] {
            let Some((_, grounds)) = shown(&opaque, order, &self.work) else { continue };
            let other = weight(&opaque, &grounds);
            if other < least && definitions.iter().all(|i| has_value(goal, *i, &self.work)) {
                least = other;
                let goal = opaque.clone();
                let definitions = definitions.clone();
                decided.kept = Some(Rc::new(Kept { goal, definitions, grounds }));
            }
        }
    }
}

/// Whether a proof is one at a point.
fn is_told_again(goal: &Goal, grounds: &Grounds) -> bool {
    let at_a_point = matches!(&goal.conclusion, Conclusion::Link(Link::Relation(_)));
    let plain = matches!(grounds, Grounds::Contradiction(Course::After(passages, _)) if passages.is_empty());
    at_a_point && plain
}

/// A proof of a goal that a small search finds and the kernel accepts, with these symbols replaced first.
fn shown(goal: &Goal, defined: Vec<usize>, work: &Fuel) -> Option<(Certificate, Grounds)> {
    let scope = scope(goal, work.within(FUEL)).ok()?;
    let state = claim_state(&scope, goal, Finding::Proved).ok()?;
    let any = |_: usize, _: &Poly| true;
    let mut search = Search::new(STEPS, &any, false);
    search.products = false;
    search.keep = kept(goal);
    search.defined = defined;
    let Outcome::Closed(argument) = search.solve(&state) else { return None };
    let course = Course::After(Vec::new(), argument);
    let evidence = Evidence::Contradiction(contradiction(&state, &course).ok()?);
    let certificate = Certificate { goal: digest(goal), finding: Finding::Proved, evidence };
    check(goal, &certificate, work.within(FUEL)).ok()?;
    Some((certificate, Grounds::Contradiction(course)))
}

/// Whether a definition has a value wherever the hypotheses and the condition of a goal hold.
fn has_value(goal: &Goal, definition: usize, work: &Fuel) -> bool {
    let itself = || Expr::Let(definition);
    let conclusion = Relation { lhs: itself(), rel: Rel::Eq, rhs: itself() };
    let conclusion = Conclusion::Link(Link::Relation(conclusion));
    shown(&Goal { conclusion, ..goal.clone() }, Vec::new(), work).is_some()
}

/// Symbols that stand alone on the left of an equation of a premise or of the condition, those first that no other
/// of these equations speaks of.
fn defined(goal: &Goal) -> Vec<usize> {
    let premises = goal.hypotheses.iter().flat_map(|h| h.sentence.relations());
    let mut open: Vec<(usize, BTreeSet<usize>)> = Vec::new();
    for relation in premises.chain(&goal.when) {
        let Relation { lhs: Expr::Var(v), rel: Rel::Eq, rhs } = relation else { continue };
        let (spoken, _) = within(&goal.context, vec![rhs]);
        if !spoken.contains(v) && open.iter().all(|o| o.0 != *v) {
            open.push((*v, spoken));
        }
    }
    let mut order = Vec::new();
    while !open.is_empty() {
        let free = |v: usize| open.iter().all(|(_, spoken)| !spoken.contains(&v));
        let next = (0..open.len()).find(|i| free(open[*i].0)).unwrap_or(0);
        order.push(open.remove(next).0);
    }
    order
}

/// The goal in which the definitions that it names are symbols, and which they are. Nothing where it names none, or
/// where it speaks of limits or derivatives, for which more counts than values.
fn opaque(goal: &Goal) -> Option<(Goal, Vec<usize>)> {
    let first = goal.context.vars.len();
    let mut definitions: Vec<usize> = Vec::new();
    let mut replaced = |e: &Expr| {
        rebuild(e, &mut |part| match part {
            Expr::Let(i) => {
                let at = definitions.iter().position(|known| known == i);
                let at = at.unwrap_or_else(|| {
                    definitions.push(*i);
                    definitions.len() - 1
                });
                Ok(Some(Expr::Var(first + at)))
            }
            Expr::Deriv(..) => Err(()),
            _ => Ok(None),
        })
        .ok()
    };
    let mut relation = |r: &Relation| {
        Some(Relation { lhs: replaced(&r.lhs)?, rel: r.rel, rhs: replaced(&r.rhs)? })
    };
    let mut opaque = goal.clone();
    for hypothesis in &mut opaque.hypotheses {
        let Sentence { when, links } = &mut hypothesis.sentence;
        for r in when.iter_mut() {
            *r = relation(r)?;
        }
        for link in links.iter_mut() {
            let Link::Relation(r) = link else { return None };
            *r = relation(r)?;
        }
    }
    for r in &mut opaque.when {
        *r = relation(r)?;
    }
    let Conclusion::Link(Link::Relation(r)) = &mut opaque.conclusion else { return None };
    *r = relation(r)?;
    if definitions.is_empty() {
        return None;
    }
    for i in &definitions {
        let name = goal.context.lets.get(*i)?.name.clone();
        opaque.context.vars.push(Var { name, of: None, lower: None, upper: None });
    }
    opaque.context.lets.iter_mut().for_each(|definition| definition.body = Expr::int(0));
    Some((opaque, definitions))
}
