//! Models as data: points and functions, with what becomes of each statement there.

use crate::spoken::within;
use std::collections::BTreeSet;

use kane_algebra::point::Partial;
use kane_algebra::rational_function::RationalFunction;
use kane_algebra::syntax::{Evaluator, Logic, NoValue, compares, eval};
use kane_kernel::{
    Approach, Conclusion, Context, Expr, Failure, Finding, Fuel, Functions, Goal, Hypothesis,
    Limit, Link, Model, Point, Proof, Relation, Root, Sentence, Target, expressions,
};
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::span::{Enclosure, Span};
use super::{Assignment, Comparison, End, Held, Measured, Reason, Said, Speaker, Step, Value};

type Q = BigRational;

/// The values of a model, only of the symbols that the goal mentions.
pub(crate) fn model(goal: &Goal, model: &Model) -> Vec<Assignment> {
    let shown = mentioned(goal, true);
    match model {
        Model::Point(point) => values(point, &shown),
        Model::Functions(f) => functions(goal, f),
    }
}

/// A model in outline.
pub(super) fn reason(goal: &Goal, finding: Finding, model: &Model) -> Reason {
    match model {
        Model::Functions(f) => Reason::Functions { values: functions(goal, f), end: end(goal, f) },
        Model::Point(point) => {
            let claim = conclusion(goal, finding, point).pop();
            let shown = mentioned(goal, false);
            let near = if shown.is_empty() { mentioned(goal, true) } else { shown };
            Reason::Point { values: values(point, &near), claim }
        }
    }
}

/// What becomes of each statement in a model.
pub(super) fn step(goal: &Goal, finding: Finding, model: &Model) -> Step {
    match model {
        Model::Point(point) => {
            let mut said = Vec::new();
            let coordinates = Coordinates::of(goal, point);
            let mut at = Evaluator::new(&goal.context, &coordinates.at);
            for (h, hypothesis) in goal.hypotheses.iter().enumerate() {
                said.extend(coordinates.hypothesis(&mut at, h, hypothesis));
            }
            let when: Vec<Link> = goal.when.iter().cloned().map(Link::Relation).collect();
            said.extend(coordinates.said(&mut at, Speaker::Condition, &when, false));
            let undefined = finding == Finding::IllDefined;
            let links = goal.conclusion.links();
            said.extend(coordinates.said(&mut at, Speaker::Claim, links, undefined));
            let value = |i| (i, coordinates.value(&mut at, &Expr::Let(i)));
            let definitions = defined(goal).into_iter().map(value).collect();
            let values = values(point, &mentioned(goal, true));
            Step::Point { values, definitions, said }
        }
        Model::Functions(f) => {
            let held = |(proof, limits): &(Proof, Vec<_>)| Held {
                by_proof: !matches!(proof, Proof::Assume { cases, .. } if cases.is_empty()),
                limits: !limits.is_empty(),
            };
            Step::Functions {
                of: f.var,
                values: functions(goal, f),
                hypotheses: f.premises.iter().map(held).collect(),
                end: end(goal, f),
            }
        }
    }
}

/// What givens that are not cited say at the witness of a goal, and the values that this asks for besides.
pub(crate) fn beside(
    context: &Context,
    givens: &[Hypothesis],
    goal: &Goal,
    point: &Point,
) -> (Vec<Assignment>, Vec<Said>) {
    let speaks = Goal {
        context: context.clone(),
        hypotheses: givens.to_vec(),
        behind: Vec::new(),
        when: Vec::new(),
        conclusion: Conclusion::Contradiction,
    };
    let coordinates = Coordinates::of(&speaks, point);
    let mut at = Evaluator::new(&speaks.context, &coordinates.at);
    let said = givens.iter().enumerate().flat_map(|(h, g)| coordinates.hypothesis(&mut at, h, g));
    let said = said.collect();
    let known = mentioned(goal, true);
    let besides: Vec<usize> =
        mentioned(&speaks, true).into_iter().filter(|v| !known.contains(v)).collect();
    (values(point, &besides), said)
}

/// The coordinates of a point: numbers, or where they are.
struct Coordinates<'g> {
    context: &'g Context,
    /// the coordinates; of an irrational point, numbers near them
    at: Vec<Q>,
    /// enclosed
    within: Vec<Span>,
    is_exact: bool,
    exact: Partial,
}

impl<'g> Coordinates<'g> {
    fn of(goal: &'g Goal, point: &Point) -> Self {
        let root = point.generator.as_ref().map(|root| tight(root, CLOSE));
        let generator = root.map_or_else(|| Span::at(Q::zero()), |r| Span::between(r.lo, r.hi));
        let value = |v: usize| {
            let known = point.values.iter().find(|x| x.0 == v);
            let coefficients = known.map_or(&[][..], |x| &x.1[..]);
            let horner = |sum: Span, c: &Q| sum.times(&generator).plus(Span::at(c.clone()));
            coefficients.iter().rev().fold(Span::at(Q::zero()), horner)
        };
        let within: Vec<Span> = (0..goal.context.vars.len()).map(value).collect();
        let at = within.iter().map(Span::middle).collect();
        // a root may be that of a symbol's value, and the symbols rational
        let is_exact = within.iter().all(Span::is_number);
        Self { context: &goal.context, at, within, is_exact, exact: point.into() }
    }

    /// The value of an expression. At an irrational point, guards are decided where they are plain.
    fn value(&self, at: &mut Evaluator<'_>, e: &Expr) -> Measured {
        if self.is_exact {
            return match at.value(e) {
                Ok(value) => Measured::Exact(value),
                Err(why @ NoValue::Irrational) => {
                    self.enclosed(e).map_or(Measured::None(why), |within| near(&within))
                }
                Err(why) => Measured::None(why),
            };
        }
        // what cancels is not there where it divides by 0: an enclosure tells
        let Some(within) = self.enclosed(e) else { return Measured::None(NoValue::Irrational) };
        let exact = if self.has_guards(e) { None } else { self.rational(e) };
        exact.map_or_else(|| near(&within), Measured::Exact)
    }

    /// Where the value is.
    fn enclosed(&self, e: &Expr) -> Option<Span> {
        Enclosure::new(self.context, &self.within).value(e)
    }

    /// The value at an irrational point, if it is rational: the square of a root of two is two, and not near it.
    fn rational(&self, e: &Expr) -> Option<Q> {
        let (num, den) = RationalFunction::from_expr(e, self.context).ok()?.fraction();
        self.exact.rational(&num, &den, &Fuel::new(OPERATIONS))
    }

    /// Whether an expression or a definition in it has cases, a derivative or a root.
    fn has_guards(&self, e: &Expr) -> bool {
        let mut todo = vec![e];
        while let Some(e) = todo.pop() {
            match e {
                Expr::Cases(..) | Expr::Deriv(..) | Expr::Sqrt(_) => return true,
                Expr::Let(i) => todo.extend(self.context.lets.get(*i).map(|known| &known.body)),
                _ => {}
            }
            todo.extend(e.children());
        }
        false
    }

    /// What becomes of a hypothesis, the index of which is given; if it says nothing at the point, why. Nothing is told
    /// where it is not seen whether its condition holds.
    fn hypothesis(&self, at: &mut Evaluator<'_>, h: usize, hypothesis: &Hypothesis) -> Vec<Said> {
        let Sentence { when, links } = &hypothesis.sentence;
        let (mut idle, mut is_seen) = (None, true);
        for r in when {
            let comparison = self.compared(at, r, true);
            match self.holds(r, &comparison) {
                Some(true) => {}
                Some(false) => idle = idle.or(Some((r, comparison))),
                None => is_seen = false,
            }
        }
        if idle.is_none() && !is_seen {
            return Vec::new();
        }
        // a premise is defined, a cited claim need not be
        if idle.is_none() && !hypothesis.given {
            let relations = hypothesis.sentence.relations();
            let mut told = relations.map(|r| (r, self.compared(at, r, true)));
            idle = told.find(|(_, told)| matches!(told, Comparison::Undefined(..)));
        }
        match idle {
            Some((relation, comparison)) => {
                let (of, relation) = (Speaker::Idle(h), relation.clone());
                vec![Said { of, relation, comparison, parts: Vec::new() }]
            }
            None => self.said(at, Speaker::Hypothesis(h), links, false),
        }
    }

    /// Whether a relation holds, if that is seen; one that is undefined does not.
    fn holds(&self, relation: &Relation, comparison: &Comparison) -> Option<bool> {
        match comparison {
            Comparison::Undefined(..) => Some(false),
            Comparison::Truth(holds) => Some(*holds),
            Comparison::Sides(Measured::Exact(a), Measured::Exact(b)) => {
                Some(compares(relation.rel, a.cmp(b)))
            }
            Comparison::Sides(..) => Enclosure::new(self.context, &self.within).holds(relation),
        }
    }

    /// What becomes of links at the point.
    fn said(
        &self,
        at: &mut Evaluator<'_>,
        of: Speaker,
        links: &[Link],
        undefined: bool,
    ) -> Vec<Said> {
        let relations = links.iter().filter_map(|link| match link {
            Link::Relation(r) => Some(r),
            Link::Limit(_) => None,
        });
        let mut one = |r: &Relation| {
            let comparison = self.compared(at, r, undefined);
            let parts = Logic::of(r).map(|logic| joined(&logic)).unwrap_or_default();
            let parts = parts.into_iter();
            let parts = parts.map(|r| (r.clone(), self.compared(at, r, true))).collect();
            Said { of, relation: r.clone(), comparison, parts }
        };
        relations.map(&mut one).collect()
    }

    /// Both sides of a relation at the point; of one that may be undefined, why it is.
    fn compared(&self, at: &mut Evaluator<'_>, r: &Relation, undefined: bool) -> Comparison {
        let (a, b) = (self.value(at, &r.lhs), self.value(at, &r.rhs));
        let undefined = undefined && self.is_exact;
        let why = [&a, &b].into_iter().find_map(|side| match side {
            Measured::None(why) if undefined && *why != NoValue::Irrational => Some(*why),
            _ => None,
        });
        match (why, &a, &b) {
            (Some(why), ..) => {
                let by = why == NoValue::DivisionByZero;
                let by = by.then(|| vanishing(at, self.context, r)).flatten();
                // of a zero that is written nothing is to be told
                let by = by.filter(|by| !is_numeral(by));
                Comparison::Undefined(r.clone(), why, by)
            }
            (None, Measured::Exact(a), Measured::Exact(b)) if Logic::of(r).is_some() => {
                Comparison::Truth(a == b)
            }
            (None, ..) => Comparison::Sides(a, b),
        }
    }
}

/// All relations that a formula joins.
fn joined<'r>(logic: &Logic<'r>) -> Vec<&'r Relation> {
    match logic {
        Logic::Or(parts) => parts.iter().flat_map(|part| part.iter()).collect(),
        Logic::Implies(a, b) | Logic::Iff(a, b) => a.iter().chain(b.iter()).collect(),
    }
}

/// What a relation divides by though it is 0, as it is written or in a definition.
fn vanishing(at: &mut Evaluator<'_>, context: &Context, r: &Relation) -> Option<Expr> {
    let mut todo: Vec<Expr> = vec![r.rhs.clone(), r.lhs.clone()];
    for _ in 0..MOST_PARTS {
        let e = todo.pop()?;
        match &e {
            Expr::Div(_, by) if at.value(by).is_ok_and(|value| value.is_zero()) => {
                return Some((**by).clone());
            }
            Expr::Pow(base, n) if *n < 0 && at.value(base).is_ok_and(|value| value.is_zero()) => {
                return Some((**base).clone());
            }
            Expr::Let(i) => todo.extend(context.lets.get(*i).map(|known| known.body.clone())),
            _ => {}
        }
        todo.extend(e.children().into_iter().cloned());
    }
    None
}

fn is_numeral(e: &Expr) -> bool {
    match e {
        Expr::Num(_) => true,
        Expr::Neg(inner) => is_numeral(inner),
        _ => false,
    }
}

/// Operations that the exact value of a side may take.
const OPERATIONS: u64 = 1_000_000;
/// Parts of a relation among which the one that vanishes is looked for.
const MOST_PARTS: usize = 10_000;

/// What becomes of the claim at a point.
fn conclusion(goal: &Goal, finding: Finding, point: &Point) -> Vec<Comparison> {
    let values = Coordinates::of(goal, point);
    let mut at = Evaluator::new(&goal.context, &values.at);
    let undefined = finding == Finding::IllDefined;
    let links = goal.conclusion.links();
    let said = values.said(&mut at, Speaker::Claim, links, undefined);
    said.into_iter().map(|said| said.comparison).collect()
}

/// Values of these symbols.
pub(crate) fn values<'v>(
    point: &Point,
    symbols: impl IntoIterator<Item = &'v usize>,
) -> Vec<Assignment> {
    let one = |v: &usize| Some(Assignment { symbol: *v, value: value(point, *v)? });
    symbols.into_iter().filter_map(one).collect()
}

/// Functions for the symbols that the goal mentions.
fn functions(goal: &Goal, f: &Functions) -> Vec<Assignment> {
    let shown = mentioned(goal, true);
    let values = f.values.iter().filter(|(v, _)| shown.contains(v));
    let one = |(v, e): &(usize, Expr)| Assignment { symbol: *v, value: Value::Function(e.clone()) };
    values.map(one).collect()
}

/// How a claim fails for functions.
fn end(goal: &Goal, f: &Functions) -> End {
    match &f.failure {
        Failure::Reaches(_) => End::Holds,
        Failure::At(point) => End::At(f.var, value(point, f.var)),
        Failure::Limit { link, target, proof, .. } => {
            let limit = match goal.conclusion.links().get(*link) {
                Some(Link::Limit(limit)) => Some(limit),
                _ => None,
            };
            let is_wide = limit.is_some_and(|limit| is_from_both_sides(goal, limit));
            End::Limit {
                target: target.clone(),
                above: is_wide.then_some(proof.germ.side.above),
                against_nothing: limit.is_some_and(|limit| has_no_target(goal, f, limit)),
            }
        }
    }
}

/// Whether what a limit is claimed to be is undefined where constants have these values.
fn has_no_target(goal: &Goal, f: &Functions, limit: &Limit) -> bool {
    let Target::Finite(claimed) = &limit.to else { return false };
    let number = |v: usize| match f.values.iter().find(|(of, _)| *of == v) {
        Some((_, Expr::Num(q))) => Some(q.clone()),
        _ => None,
    };
    if within(&goal.context, vec![claimed]).0.into_iter().any(|v| number(v).is_none()) {
        return false;
    }
    let symbols = 0..goal.context.vars.len();
    let at: Vec<Q> = symbols.map(|v| number(v).unwrap_or_else(Q::zero)).collect();
    let value = eval(claimed, &goal.context, &at);
    matches!(value, Err(NoValue::DivisionByZero | NoValue::NegativeRadicand))
}

/// Whether a limit is one from both sides.
fn is_from_both_sides(goal: &Goal, limit: &Limit) -> bool {
    let Approach::To(a) = &limit.at else { return false };
    let Some(var) = goal.context.vars.get(limit.var) else { return false };
    var.lower.as_ref().is_none_or(|b| b.value < *a)
        && var.upper.as_ref().is_none_or(|b| b.value > *a)
}

/// Symbols that the conclusion and `when` mention, and with `all` also the hypotheses, in order of
/// declaration.
fn mentioned(goal: &Goal, all: bool) -> Vec<usize> {
    spoken_of(goal, all).0.into_iter().collect()
}

/// Definitions that anything in the goal mentions as it is written, in order.
fn defined(goal: &Goal) -> Vec<usize> {
    spoken_of(goal, true).1
}

/// Symbols and definitions that are mentioned, the latter also within each other.
fn spoken_of(goal: &Goal, all: bool) -> (BTreeSet<usize>, Vec<usize>) {
    let mut todo: Vec<&Expr> = goal.when.iter().flat_map(|r| [&r.lhs, &r.rhs]).collect();
    match &goal.conclusion {
        Conclusion::Link(l) => todo.extend(expressions(&[], std::slice::from_ref(l))),
        Conclusion::NotImplied(s) => todo.extend(expressions(&s.when, &s.links)),
        Conclusion::Contradiction => {}
    }
    if all {
        let sentences = goal.hypotheses.iter().map(|h| &h.sentence);
        todo.extend(sentences.flat_map(|s| expressions(&s.when, &s.links)));
    }
    within(&goal.context, todo)
}

/// Symbols that a sentence mentions, also in definitions.
pub(crate) fn mentions(context: &Context, sentence: &Sentence) -> BTreeSet<usize> {
    within(context, expressions(&sentence.when, &sentence.links).collect()).0
}

/// The value within an enclosure, or a number near it if digits of it are known.
fn near(within: &Span) -> Measured {
    if within.is_number() {
        Measured::Exact(within.middle())
    } else if within.is_close() {
        Measured::Near(within.middle())
    } else {
        Measured::None(NoValue::Irrational)
    }
}

/// A value at a point.
fn value(point: &Point, v: usize) -> Option<Value> {
    let (_, coefficients) = point.values.iter().find(|x| x.0 == v)?;
    let root = match &point.generator {
        Some(root) if coefficients.len() > 1 => shown(root),
        _ => return Some(Value::Number(coefficients.first().cloned().unwrap_or_else(Q::zero))),
    };
    Some(if coefficients[..] == [Q::zero(), Q::one()] {
        Value::Root(root)
    } else {
        Value::InRoot { coefficients: coefficients.clone(), root }
    })
}

/// Steps for the decimals of one root.
const TIGHTENING: u64 = 1_000_000;

/// Halvings of the interval of a root that is shown as a decimal.
const SHOWN: u32 = 40;
/// Halvings for the digits of what is computed from a root.
const CLOSE: u32 = 120;

/// A root, its interval narrow enough for the decimals that are shown of it.
pub(super) fn shown(root: &Root) -> Root {
    tight(root, SHOWN)
}

/// A root, its interval halved so many times.
fn tight(root: &Root, halvings: u32) -> Root {
    let (mut tight, fuel) = (root.clone(), Fuel::new(TIGHTENING));
    for _ in 0..halvings {
        if tight.is_exact() || kane_algebra::sign_table::refine(&mut tight, &fuel).is_err() {
            break;
        }
    }
    tight
}
