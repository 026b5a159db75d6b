//! A witness and the givens that are not cited: which of them fail there, and which one would do if it were cited.

use std::cell::RefCell;

use kane_algebra::syntax::{Evaluator, compares};
use kane_kernel::{
    Certificate, Conclusion, Evidence, Finding, Fuel, Goal, Hypothesis, Link, Model, Point,
    Sentence,
};
use num_rational::BigRational;
use num_traits::Zero as _;

use crate::explain::mentions;
use crate::prove::{Budget, Decided, Prover};
use crate::{Behind, Body, Document};

/// Givens that are tried as a further premise.
const MOST_TRIED: usize = 4;
/// What one such attempt has of the work that a claim may take.
const SHARE: u64 = 8;

/// The givens above a claim, not cited by it, that fail at the point of a witness.
///
/// Only those are asked whose symbols all have a value there.
pub(crate) fn failing(
    document: &Document,
    above: usize,
    cited: &[usize],
    certificate: &Certificate,
) -> Vec<usize> {
    let Evidence::Model(Model::Point(point)) = &certificate.evidence else { return Vec::new() };
    if point.generator.is_some() {
        return Vec::new();
    }
    let values = coordinates(document, point);
    let mut at = Evaluator::new(&document.context, &values);
    let mut failing = Vec::new();
    for (i, statement) in document.statements.iter().enumerate().take(above) {
        let Body::Given(sentence) = &statement.body else { continue };
        let known = |v: &usize| point.values.iter().any(|known| known.0 == *v);
        let is_known = mentions(&document.context, sentence).iter().all(known);
        if is_known && !cited.contains(&i) && fails(&mut at, sentence) {
            failing.push(i);
        }
    }
    failing
}

fn coordinates(document: &Document, point: &Point) -> Vec<BigRational> {
    let value = |v: usize| {
        let known = point.values.iter().find(|known| known.0 == v);
        known.and_then(|known| known.1.first().cloned()).unwrap_or_else(BigRational::zero)
    };
    (0..document.context.vars.len()).map(value).collect()
}

/// Whether a sentence that speaks of points is false there.
fn fails(at: &mut Evaluator<'_>, sentence: &Sentence) -> bool {
    if !at.all_hold(&sentence.when).is_ok_and(|holds| holds) {
        return false;
    }
    let mut links = sentence.links.iter();
    links.any(|link| match link {
        Link::Relation(r) => match (at.value(&r.lhs), at.value(&r.rhs)) {
            (Ok(a), Ok(b)) => !compares(r.rel, a.cmp(&b)),
            _ => false,
        },
        Link::Limit(_) => false,
    })
}

/// The first of the givens that fail at a witness with which the claim is proved.
pub(crate) fn would_do(
    document: &Document,
    goal: &Goal,
    failing: &[usize],
    (budget, work): (Budget, &Fuel),
) -> Option<usize> {
    if !matches!(goal.conclusion, Conclusion::Link(Link::Relation(_))) {
        return None;
    }
    let proves = |i: &usize| {
        let Body::Given(sentence) = &document.statements[*i].body else { return false };
        let mut goal = goal.clone();
        goal.hypotheses.push(Hypothesis { sentence: sentence.clone(), given: true });
        goal.context.lets.clone_from(&document.context.lets);
        let earlier = RefCell::default();
        let prover = Prover {
            budget: budget.share(SHARE),
            work: work.clone(),
            using: &[],
            by: &[],
            earlier: &earlier,
            cited: goal.hypotheses.len(),
            resting: &goal,
        };
        // of premises that contradict each other anything would follow
        let found = prover.judge(&goal, true);
        let proved = |decided: &Decided| decided.certificate.finding == Finding::Proved;
        found.model.is_some() && found.decided.as_ref().is_some_and(proved)
    };
    failing.iter().take(MOST_TRIED).copied().find(proves)
}

/// What is to be said of a witness and the givens behind what is cited, if anything.
pub(crate) fn behind(
    goal: &Goal,
    resting: &Goal,
    certificate: &Certificate,
    failing: Vec<usize>,
) -> Option<Behind> {
    if goal.hypotheses.len() == resting.hypotheses.len() {
        return None;
    }
    match &certificate.evidence {
        Evidence::Model(Model::Point(_)) => {
            let goal = kane_kernel::digest(resting);
            let again = Certificate { goal, ..certificate.clone() };
            let met = kane_kernel::check(resting, &again, kane_kernel::Fuel::new(10_000_000));
            met.is_err().then_some(Behind::NotMet(failing))
        }
        Evidence::Model(Model::Functions(_)) => Some(Behind::NotShown),
        Evidence::Contradiction(_) | Evidence::Limit(_) => None,
    }
}
