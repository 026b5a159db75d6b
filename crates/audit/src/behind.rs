//! A witness and the givens that are not cited: whether all of them hold there too, which of them fail, and which one would
//! do if it were cited.

use std::cell::RefCell;
use std::collections::BTreeSet;

use kane_algebra::syntax::{Evaluator, compares};
use kane_kernel::{
    Conclusion, Evidence, Expr, Finding, Fuel, Goal, Hypothesis, Link, Model, Point, Rel, Relation,
    Sentence,
};
use num_rational::BigRational;
use num_traits::Zero as _;

use crate::explain::{beside, mentions, values};
use crate::motion::mentioned;
use crate::prove::{Budget, Decided, Memory, Prover, Verdicts};
use crate::{Assignment, Beside, Body, Document, Standing, Step};

/// Givens that are tried as a further premise.
const MOST_TRIED: usize = 4;
/// What one such attempt, and the search for a point at which all givens hold, has of the work that a claim may take.
const SHARE: u64 = 8;

/// A goal that was decided by a witness, and where in the document its claim stands.
pub(crate) struct Witnessed<'a> {
    pub(crate) document: &'a Document,
    /// the number of statements above the claim
    pub(crate) above: usize,
    pub(crate) goal: &'a Goal,
    /// what the hypotheses of the goal are, as far as they are statements
    pub(crate) cited: &'a [usize],
    /// the givens on which the claim rests through what it cites
    pub(crate) further: &'a [usize],
    pub(crate) budget: Budget,
    pub(crate) work: &'a Fuel,
}

impl Witnessed<'_> {
    /// How the witness of a finding stands to the givens above; `None` where nothing was refuted by one.
    ///
    /// The witness is continued to a point at which all of them hold. Where that cannot be, another witness is looked for
    /// that can, and takes its place.
    pub(crate) fn standing(&self, found: &mut Verdicts) -> Option<(Standing, Option<Beside>)> {
        let certificate = &found.decided.as_ref()?.certificate;
        let Evidence::Model(model) = &certificate.evidence else { return None };
        if !matches!(certificate.finding, Finding::Refuted | Finding::IllDefined) {
            return None;
        }
        let others = self.others();
        if others.is_empty() {
            return Some((Standing::AllMet, None));
        }
        let Model::Point(point) = model else { return Some((Standing::NotShown, None)) };
        let failing = self.failing(&others, point);
        let finding = certificate.finding;
        let pins = if failing.is_empty() { self.pins(point) } else { Vec::new() };
        let stays = if pins.is_empty() { None } else { self.everywhere(&others, pins, finding) };
        let all_met = stays.or_else(|| self.everywhere(&others, Vec::new(), finding));
        if let Some((decided, model)) = all_met {
            found.decided = Some(decided);
            let beside = match model {
                Model::Point(point) => {
                    Some(Beside { all: true, givens: others, point, further: Vec::new() })
                }
                Model::Functions(_) => None,
            };
            return Some((Standing::AllMet, beside));
        }
        if failing.is_empty() {
            return Some((Standing::NotShown, None));
        }
        let beside = Beside {
            all: false,
            givens: failing.clone(),
            further: self.further_values(&failing, point),
            point: point.clone(),
        };
        Some((Standing::Unmet(failing), Some(beside)))
    }

    /// The values of the symbols that these givens speak of.
    fn further_values(&self, givens: &[usize], point: &Point) -> Vec<Assignment> {
        let said: Vec<Hypothesis> = givens.iter().filter_map(|i| said(self.document, *i)).collect();
        let context = &self.document.context;
        let all = said.iter().flat_map(|given| mentions(context, &given.sentence));
        values(point, &all.collect::<BTreeSet<usize>>())
    }

    /// The givens above that are not cited, those first on which the claim rests.
    fn others(&self) -> Vec<usize> {
        let statements = &self.document.statements[..self.above];
        let is_other =
            |i: &usize| matches!(statements[*i].body, Body::Given(_)) && !self.cited.contains(i);
        let mut others: Vec<usize> = (0..self.above).filter(is_other).collect();
        self.leave_conventions(&mut others);
        others.sort_by_key(|i| !self.further.contains(i));
        others
    }

    /// Takes away what a document says of itself about exponentials, logarithms and angles of which neither the claim nor
    /// another given speaks: with their values it holds at every point.
    fn leave_conventions(&self, others: &mut Vec<usize>) {
        let stands_for = &self.document.motion.stands_for;
        let context = &self.document.context;
        let mut spoken = mentioned(self.goal);
        for i in others.iter().filter(|i| !self.document.is_convention(**i)) {
            if let Body::Given(sentence) = &self.document.statements[*i].body {
                spoken.extend(mentions(context, sentence));
            }
        }
        others.retain(|i| {
            stands_for.get(i).is_none_or(|symbols| symbols.iter().any(|v| spoken.contains(v)))
        });
    }

    /// Those of the givens that fail at a point. Only those are asked whose symbols all have a rational value there.
    fn failing(&self, others: &[usize], point: &Point) -> Vec<usize> {
        let document = self.document;
        let values = coordinates(document, point);
        let mut at = Evaluator::new(&document.context, &values);
        let known = |v: &usize| rational(point, *v).is_some();
        let mut fails_there = |i: &usize| {
            let Body::Given(sentence) = &document.statements[*i].body else { return false };
            mentions(&document.context, sentence).iter().all(known) && fails(&mut at, sentence)
        };
        others.iter().copied().filter(|i| fails_there(i)).collect()
    }

    /// That the symbols of the goal have the values of a point, if these are rational.
    fn pins(&self, point: &Point) -> Vec<Hypothesis> {
        let symbols = self.document.context.vars.len();
        let all = point.values.iter().map(|(v, _)| *v).filter(|v| *v < symbols);
        let pin = |v: usize| {
            let value = Expr::Num(rational(point, v)?);
            let equation = Relation { lhs: Expr::Var(v), rel: Rel::Eq, rhs: value };
            let sentence = Sentence { when: Vec::new(), links: vec![Link::Relation(equation)] };
            Some(Hypothesis { sentence, given: true })
        };
        all.map(pin).collect::<Option<_>>().unwrap_or_default()
    }

    /// A witness of the goal at which these givens and these pins hold too.
    fn everywhere(
        &self,
        others: &[usize],
        pins: Vec<Hypothesis>,
        finding: Finding,
    ) -> Option<(Decided, Model)> {
        let given: Vec<Hypothesis> =
            others.iter().filter_map(|i| said(self.document, *i)).collect();
        let is_limit = |link: &Link| matches!(link, Link::Limit(_));
        // a point cannot be held against a limit
        if given.iter().any(|h| h.sentence.links.iter().any(is_limit)) {
            return None;
        }
        let mut all = self.goal.clone();
        all.context.lets.clone_from(&self.document.context.lets);
        all.hypotheses.extend(given);
        let mut pinned = all.clone();
        pinned.hypotheses.extend(pins.into_iter().chain(self.document.motion.pins(&all)));
        let earlier = RefCell::default();
        let prover = self.prover(&all, &earlier);
        let (decided, model) = prover.witness_within(&pinned, self.goal, finding)?;
        let ids: Vec<usize> = self.cited.iter().chain(others).copied().collect();
        let motion = &self.document.motion;
        let moves = !motion.concerns(&all)
            || ids.len() == all.hypotheses.len()
                && motion.is_met(&all, &ids, &Evidence::Model(model.clone()));
        moves.then_some((decided, model))
    }

    fn prover<'p>(&self, resting: &'p Goal, earlier: &'p RefCell<Vec<Model>>) -> Prover<'p> {
        Prover {
            budget: self.budget.share(SHARE),
            work: self.work.clone(),
            using: &[],
            by: &[],
            earlier,
            near: Memory::default(),
            cited: resting.hypotheses.len(),
            resting,
        }
    }

    /// The first of the givens that fail at a witness with which the claim is proved.
    pub(crate) fn would_do(&self, standing: Option<&Standing>) -> Option<usize> {
        let Some(Standing::Unmet(failing)) = standing else { return None };
        if !matches!(self.goal.conclusion, Conclusion::Link(Link::Relation(_))) {
            return None;
        }
        let proves = |i: &usize| {
            let Some(given) = said(self.document, *i) else { return false };
            let mut goal = self.goal.clone();
            goal.hypotheses.push(given);
            goal.context.lets.clone_from(&self.document.context.lets);
            self.prover(&goal, &RefCell::default()).follows(&goal)
        };
        failing.iter().take(MOST_TRIED).copied().find(proves)
    }
}

impl Beside {
    /// What the givens say there, as a step; each is the hypothesis of its place. The goal is that of the witness.
    #[must_use]
    pub fn step(&self, document: &Document, goal: &Goal) -> Step {
        let givens: Vec<Hypothesis> =
            self.givens.iter().filter_map(|i| said(document, *i)).collect();
        let (values, said) = beside(&document.context, &givens, goal, &self.point);
        Step::Beside { all: self.all, values, said }
    }
}

/// What a given says.
fn said(document: &Document, index: usize) -> Option<Hypothesis> {
    match &document.statements.get(index)?.body {
        Body::Given(sentence) => Some(Hypothesis { sentence: sentence.clone(), given: true }),
        _ => None,
    }
}

/// The value of a variable at a point, if it has one there that is rational.
fn rational(point: &Point, v: usize) -> Option<BigRational> {
    let (_, value) = point.values.iter().find(|known| known.0 == v)?;
    let is_rational = value.iter().skip(1).all(BigRational::is_zero);
    is_rational.then(|| value.first().cloned().unwrap_or_else(BigRational::zero))
}

/// The values of all symbols; 0 for those that have none that is rational.
fn coordinates(document: &Document, point: &Point) -> Vec<BigRational> {
    let symbols = 0..document.context.vars.len();
    symbols.map(|v| rational(point, v).unwrap_or_else(BigRational::zero)).collect()
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
