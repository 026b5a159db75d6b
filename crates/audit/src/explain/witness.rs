//! Models as data: points and functions, with what becomes of each statement there.

use kane_algebra::syntax::{Evaluator, NoValue};
use kane_kernel::{
    Conclusion, Expr, Failure, Finding, Fuel, Functions, Goal, Link, Model, Point, Proof, Root,
    expressions,
};
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::{Assignment, Comparison, End, Held, Reason, Step, Value};

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
        Model::Functions(f) => Reason::Functions { values: functions(goal, f), end: end(f) },
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
            let mut sides = Vec::new();
            if let Some(values) = coordinates(goal, point) {
                let mut at = Evaluator::new(&goal.context, &values);
                for (h, hypothesis) in goal.hypotheses.iter().enumerate() {
                    // premises are defined; it is the claim that may not be
                    let links = hypothesis.sentence.links.iter();
                    let compared = links.filter_map(|link| compared(&mut at, link, false));
                    sides.extend(compared.map(|comparison| (Some(h), comparison)));
                }
            }
            let claim = conclusion(goal, finding, point).into_iter();
            sides.extend(claim.map(|comparison| (None, comparison)));
            Step::Point { values: values(point, &mentioned(goal, true)), sides }
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
                end: end(f),
            }
        }
    }
}

/// The symbols at a point; `None` if it is irrational.
fn coordinates(goal: &Goal, point: &Point) -> Option<Vec<Q>> {
    let value = |v: usize| {
        let known = point.values.iter().find(|x| x.0 == v);
        known.and_then(|x| x.1.first().cloned()).unwrap_or_else(Q::zero)
    };
    let symbols = 0..goal.context.vars.len();
    point.generator.is_none().then(|| symbols.map(value).collect())
}

/// Both sides of a relation at a point; of one that may be undefined, why it is.
fn compared(at: &mut Evaluator<'_>, link: &Link, undefined: bool) -> Option<Comparison> {
    let Link::Relation(r) = link else {
        return None;
    };
    let (a, b) = (at.value(&r.lhs), at.value(&r.rhs));
    let tells = |why: &NoValue| undefined && !matches!(why, NoValue::Irrational);
    let why = [&a, &b].into_iter().filter_map(|side| side.as_ref().err().copied()).find(tells);
    Some(match why {
        Some(why) => Comparison::Undefined(r.clone(), why),
        None => Comparison::Sides(a, b),
    })
}

/// What becomes of the claim at a point.
fn conclusion(goal: &Goal, finding: Finding, point: &Point) -> Vec<Comparison> {
    let Some(values) = coordinates(goal, point) else {
        return Vec::new();
    };
    let mut at = Evaluator::new(&goal.context, &values);
    let undefined = finding == Finding::IllDefined;
    let links = goal.conclusion.links().iter();
    links.filter_map(|link| compared(&mut at, link, undefined)).collect()
}

/// Values of these symbols.
fn values(point: &Point, symbols: &[usize]) -> Vec<Assignment> {
    let one = |v: &usize| Some(Assignment { symbol: *v, value: value(point, *v)? });
    symbols.iter().filter_map(one).collect()
}

/// Functions for the symbols that the goal mentions.
fn functions(goal: &Goal, f: &Functions) -> Vec<Assignment> {
    let shown = mentioned(goal, true);
    let values = f.values.iter().filter(|(v, _)| shown.contains(v));
    let one = |(v, e): &(usize, Expr)| Assignment { symbol: *v, value: Value::Function(e.clone()) };
    values.map(one).collect()
}

/// How a claim fails for functions.
fn end(f: &Functions) -> End {
    match &f.failure {
        Failure::Reaches(_) => End::Holds,
        Failure::At(point) => End::At(f.var, value(point, f.var)),
        Failure::Limit { target, .. } => End::Limit(target.clone()),
    }
}

/// Symbols that the conclusion and `when` mention, and with `all` also the hypotheses, in order of
/// declaration.
fn mentioned(goal: &Goal, all: bool) -> Vec<usize> {
    let mut todo: Vec<&Expr> = goal.when.iter().flat_map(|r| [&r.lhs, &r.rhs]).collect();
    fn links<'g>(links: &'g [Link], todo: &mut Vec<&'g Expr>) {
        todo.extend(expressions(&[], links));
    }
    match &goal.conclusion {
        Conclusion::Link(l) => links(std::slice::from_ref(l), &mut todo),
        Conclusion::NotImplied(s) => {
            todo.extend(s.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
            links(&s.links, &mut todo);
        }
        Conclusion::Contradiction => {}
    }
    if all {
        for h in &goal.hypotheses {
            todo.extend(h.sentence.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
            links(&h.sentence.links, &mut todo);
        }
    }
    let (mut out, mut lets) = (std::collections::BTreeSet::new(), Vec::new());
    while let Some(e) = todo.pop() {
        match e {
            Expr::Var(v) => {
                out.insert(*v);
            }
            Expr::Let(i) if !lets.contains(i) => {
                lets.push(*i);
                todo.extend(goal.context.lets.get(*i).map(|d| &d.body));
            }
            _ => {}
        }
        todo.extend(e.children());
    }
    out.into_iter().collect()
}

/// A value at a point.
fn value(point: &Point, v: usize) -> Option<Value> {
    let (_, coefficients) = point.values.iter().find(|x| x.0 == v)?;
    let root = match &point.generator {
        Some(root) if coefficients.len() > 1 => tight(root),
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

/// A root, confined closely enough to be written as a decimal.
pub(super) fn tight(root: &Root) -> Root {
    let (mut tight, fuel) = (root.clone(), Fuel::new(TIGHTENING));
    for _ in 0..40 {
        if tight.is_exact() || kane_algebra::sign_table::refine(&mut tight, &fuel).is_err() {
            break;
        }
    }
    tight
}
