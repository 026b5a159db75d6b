//! Models in words: points and functions, with what becomes of each statement there.

use kane_algebra::syntax::{Evaluator, NoValue, Notation};
use kane_kernel::{
    Conclusion, Expr, Failure, Finding, Functions, Goal, Link, Model, Point, Poly, Proof, Target,
    expressions,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::names::{root_text, short, single};
use crate::Step;
use crate::prove::expression;

type Q = BigRational;

/// A model as names and values, only of the symbols that the goal mentions.
pub(crate) fn model(goal: &Goal, model: &Model) -> Vec<(String, String)> {
    let shown = mentioned(goal, true);
    let name = |v: &usize| goal.context.vars[*v].name.clone();
    match model {
        Model::Point(p) => {
            let values = shown.iter().filter_map(|v| Some((name(v), value(p, *v)?)));
            values.collect()
        }
        Model::Functions(f) => {
            let values = f.values.iter().filter(|(v, _)| shown.contains(v));
            values.map(|(v, e)| (name(v), e.plain(&goal.context))).collect()
        }
    }
}

/// A model in one sentence.
pub(super) fn reason(goal: &Goal, finding: Finding, model: &Model) -> String {
    match model {
        Model::Functions(f) => {
            let (pairs, end) = (functions(goal, f).join(", "), end(goal, f));
            if pairs.is_empty() { end } else { format!("for {pairs}: {end}") }
        }
        Model::Point(point) => {
            let told = conclusion(goal, finding, point).pop().unwrap_or_default();
            let shown = mentioned(goal, false);
            let near = if shown.is_empty() { mentioned(goal, true) } else { shown };
            let mut at = pairs(goal, point, &near);
            if at.len() > 8 {
                at.truncate(8);
                at.push("…".to_string());
            }
            let at = at.join(", ");
            match (told.is_empty(), at.is_empty()) {
                (true, true) => "everywhere".to_string(),
                (true, false) => format!("at {at}"),
                (false, true) => told,
                (false, false) => format!("at {at}: {told}"),
            }
        }
    }
}

/// What becomes of each statement in a model.
pub(super) fn steps(goal: &Goal, finding: Finding, model: &Model, labels: &[&str]) -> Vec<Step> {
    let mut steps = Vec::new();
    let mut say = |depth, text| steps.push(Step { depth, text });
    match model {
        Model::Point(point) => {
            let shown = pairs(goal, point, &mentioned(goal, true)).join(", ");
            say(0, format!("At the point {shown}:"));
            if let Some(values) = coordinates(goal, point) {
                let mut at = Evaluator::new(&goal.context, &values);
                for (h, label) in goal.hypotheses.iter().zip(labels) {
                    for link in &h.sentence.links {
                        // premises are defined; it is the claim that may not be
                        if let Some(text) = both(&mut at, goal, link, false) {
                            say(1, format!("{label}: {text}"));
                        }
                    }
                }
            }
            for text in conclusion(goal, finding, point) {
                say(1, format!("the claim: {text}"));
            }
        }
        Model::Functions(f) => {
            let (x, pairs) = (&goal.context.vars[f.var].name, functions(goal, f).join(", "));
            if !pairs.is_empty() {
                say(0, format!("Take {pairs}."));
            }
            for ((proof, limits), label) in f.premises.iter().zip(labels) {
                let how = if matches!(proof, Proof::Assume { cases, .. } if cases.is_empty()) {
                    ""
                } else {
                    ", by a sign table or substitution"
                };
                let limits = if limits.is_empty() { "" } else { "; its limit is as premised" };
                say(1, format!("{label} holds for all {x}{how}{limits}."));
            }
            say(0, format!("Then {}.", end(goal, f)));
        }
    }
    steps
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
fn both(at: &mut Evaluator<'_>, goal: &Goal, link: &Link, undefined: bool) -> Option<String> {
    let Link::Relation(r) = link else {
        return None;
    };
    let (a, b) = (at.value(&r.lhs), at.value(&r.rhs));
    let mut faults = [&a, &b].into_iter().filter_map(|side| side.as_ref().err());
    let why = faults.find(|why| !matches!(why, NoValue::Irrational)).filter(|_| undefined);
    if let Some(why) = why {
        return Some(format!("{} is undefined ({why})", r.plain(&goal.context)));
    }
    let shown = |side: &Result<Q, NoValue>| side.as_ref().map_or_else(ToString::to_string, short);
    Some(format!("left side {}, right side {}", shown(&a), shown(&b)))
}

/// What becomes of the claim at a point.
fn conclusion(goal: &Goal, finding: Finding, point: &Point) -> Vec<String> {
    let Some(values) = coordinates(goal, point) else {
        return Vec::new();
    };
    let mut at = Evaluator::new(&goal.context, &values);
    let undefined = finding == Finding::IllDefined;
    let links = goal.conclusion.links().iter();
    links.filter_map(|link| both(&mut at, goal, link, undefined)).collect()
}

/// Values of symbols, with their names.
fn pairs(goal: &Goal, point: &Point, vars: &[usize]) -> Vec<String> {
    let one = |v: &usize| Some(format!("{} = {}", goal.context.vars[*v].name, value(point, *v)?));
    vars.iter().filter_map(one).collect()
}

/// Functions for symbols, with their names.
fn functions(goal: &Goal, f: &Functions) -> Vec<String> {
    let shown = mentioned(goal, true);
    let values = f.values.iter().filter(|(v, _)| shown.contains(v));
    let one = |(v, e): &(usize, Expr)| {
        format!("{} = {}", goal.context.vars[*v].name, e.plain(&goal.context))
    };
    values.map(one).collect()
}

/// How a claim fails for functions.
fn end(goal: &Goal, f: &Functions) -> String {
    match &f.failure {
        Failure::Reaches(_) => "all hypotheses hold".to_string(),
        Failure::At(point) => match value(point, f.var) {
            Some(at) => format!("it fails at {} = {at}", goal.context.vars[f.var].name),
            None => "it fails".to_string(),
        },
        Failure::Limit { target, .. } => {
            let target = match target {
                Target::Finite(e) => e.plain(&goal.context),
                Target::PlusInf => "oo".to_string(),
                Target::MinusInf => "-oo".to_string(),
            };
            format!("the limit is {target}")
        }
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

/// A value at a point, as a number or as a root.
fn value(point: &Point, v: usize) -> Option<String> {
    let (_, coefficients) = point.values.iter().find(|x| x.0 == v)?;
    let root = match &point.generator {
        Some(root) if coefficients.len() > 1 => root,
        _ => return Some(coefficients.first().map_or("0".to_string(), short)),
    };
    if coefficients[..] == [Q::zero(), Q::one()] {
        return Some(root_text(root));
    }
    let mut p = Poly::default();
    let common =
        coefficients.iter().fold(BigInt::one(), |l, q| num_integer::lcm(l, q.denom().clone()));
    for (i, q) in (0u32..).zip(coefficients) {
        let m = if i == 0 { Vec::new() } else { vec![(0, i)] };
        p.add_term(m, q.numer() * (&common / q.denom()));
    }
    let text = expression(&p).plain(&single("r"));
    let scaled = if common.is_one() { text } else { format!("({text})/{common}") };
    Some(format!("{scaled} with r = {}", root_text(root)))
}
