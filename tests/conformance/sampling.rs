//! Exact points at which a goal's hypotheses hold, found and evaluated without the kernel.

use std::collections::{BTreeMap, BTreeSet};

use kane::algebra::syntax::{Evaluator, NoValue};
use kane::kernel::{Bound, Conclusion, Context, Expr, Goal, Link, Rel, Relation, Sentence, Var};
use num_traits::{One, Signed, Zero};

use crate::support::{Chance, Q, q};

/// What a goal says about a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum At {
    /// a hypothesis does not hold
    Outside,
    /// roots or limits: nothing is known
    Unknown,
    /// the conclusion holds
    True,
    /// the conclusion is defined and does not hold
    False,
    /// the conclusion is undefined
    Undefined,
}

fn within(var: &Var, x: &Q) -> bool {
    let above = |b: &Bound| if b.strict { *x > b.value } else { *x >= b.value };
    let below = |b: &Bound| if b.strict { *x < b.value } else { *x <= b.value };
    var.lower.as_ref().is_none_or(above) && var.upper.as_ref().is_none_or(below)
}

fn relations(sentence: &Sentence) -> impl Iterator<Item = &Relation> {
    sentence.links.iter().filter_map(|l| match l {
        Link::Relation(r) => Some(r),
        Link::Limit(_) => None,
    })
}

/// Whether a premise holds; `Err` if that is not known.
fn premise(at: &mut Evaluator<'_>, s: &Sentence, given: bool) -> Result<bool, NoValue> {
    match at.all_hold(&s.when) {
        Ok(true) => {}
        Ok(false) => return Ok(true),
        Err(why) if why.is_undefined() => return Ok(true),
        Err(why) => return Err(why),
    }
    for r in relations(s) {
        match at.holds(r) {
            Ok(true) => {}
            Ok(false) => return Ok(false),
            Err(why) if why.is_undefined() => return Ok(!given),
            Err(why) => return Err(why),
        }
    }
    Ok(true)
}

/// What a goal says about a point with a value for each symbol.
pub(crate) fn at(goal: &Goal, point: &[Q]) -> At {
    // Ranges of symbols that nothing mentions do not matter: all are in force here.
    if !goal.context.vars.iter().zip(point).all(|(var, x)| within(var, x)) {
        return At::Outside;
    }
    let mut here = Evaluator::new(&goal.context, point);
    let mut known = true;
    for h in &goal.hypotheses {
        match premise(&mut here, &h.sentence, h.given) {
            Ok(true) => {}
            Ok(false) => return At::Outside,
            Err(_) => known = false,
        }
    }
    match here.all_hold(&goal.when) {
        Ok(true) => {}
        Ok(false) => return At::Outside,
        Err(why) if why.is_undefined() => return At::Outside,
        Err(_) => known = false,
    }
    if !known {
        return At::Unknown;
    }
    match &goal.conclusion {
        Conclusion::Link(Link::Relation(r)) => match here.holds(r) {
            Ok(true) => At::True,
            Ok(false) => At::False,
            Err(why) if why.is_undefined() => At::Undefined,
            Err(_) => At::Unknown,
        },
        Conclusion::Contradiction => At::False,
        Conclusion::Link(Link::Limit(_)) | Conclusion::NotImplied(_) => At::Unknown,
    }
}

/// Whether a goal, its hypotheses included, speaks of limits.
pub(crate) fn has_limits(goal: &Goal) -> bool {
    let limit = |l: &Link| matches!(l, Link::Limit(_));
    let claimed = match &goal.conclusion {
        Conclusion::Link(l) => limit(l),
        Conclusion::NotImplied(s) => s.links.iter().any(limit),
        Conclusion::Contradiction => false,
    };
    claimed || goal.hypotheses.iter().any(|h| h.sentence.links.iter().any(limit))
}

/// The symbols that expressions mention, through definitions too.
fn symbols(context: &Context, roots: &[&Expr]) -> BTreeSet<usize> {
    let (mut out, mut seen) = (BTreeSet::new(), BTreeSet::new());
    let mut todo: Vec<&Expr> = roots.to_vec();
    while let Some(e) = todo.pop() {
        match e {
            Expr::Var(v) | Expr::Deriv(_, v) => {
                out.insert(*v);
            }
            Expr::Let(i) if seen.insert(*i) => todo.push(&context.lets[*i].body),
            _ => {}
        }
        todo.extend(e.children());
    }
    out
}

/// Failures in a row after which an equation is seldom tried again: each takes up to fifteen evaluations.
const HOPELESS: usize = 16;

/// Finds points for a goal: free symbols at random, the others from the equations.
pub(crate) struct Sampler<'g> {
    goal: &'g Goal,
    equations: Vec<(&'g Relation, BTreeSet<usize>)>,
    /// what else has to hold, to give up early
    others: Vec<(&'g Relation, BTreeSet<usize>)>,
    mentioned: Vec<usize>,
    /// the order of free symbols that worked last
    order: Vec<usize>,
    /// equations and symbols that were found to be linear
    linear: BTreeSet<(usize, usize)>,
    /// how often in a row an equation was not solved for a symbol
    unsolved: BTreeMap<(usize, usize), usize>,
}

impl<'g> Sampler<'g> {
    pub(crate) fn new(goal: &'g Goal) -> Self {
        let mut all: Vec<&Relation> = goal.when.iter().collect();
        let mut others = all.clone();
        let mut sides: Vec<&Expr> = Vec::new();
        for h in &goal.hypotheses {
            sides.extend(h.sentence.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
            sides.extend(relations(&h.sentence).flat_map(|r| [&r.lhs, &r.rhs]));
            all.extend(relations(&h.sentence));
            if h.sentence.when.is_empty() {
                others.extend(relations(&h.sentence));
            }
        }
        sides.extend(goal.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
        if let Conclusion::Link(Link::Relation(r)) = &goal.conclusion {
            sides.extend([&r.lhs, &r.rhs]);
        }
        let with_symbols = |r: &'g Relation| (r, symbols(&goal.context, &[&r.lhs, &r.rhs]));
        let equation = |r: &&Relation| r.rel == Rel::Eq;
        let equations = all.into_iter().filter(equation).map(with_symbols).collect();
        let others = others.into_iter().filter(|r| !equation(r)).map(with_symbols).collect();
        let mentioned = symbols(&goal.context, &sides).into_iter().collect();
        Self {
            goal,
            equations,
            others,
            mentioned,
            order: Vec::new(),
            linear: BTreeSet::new(),
            unsolved: BTreeMap::new(),
        }
    }

    /// How many operations it takes to evaluate all hypotheses once, nearly: definitions once, but anew within each
    /// derivative, where each operation stands for three.
    pub(crate) fn weight(&self) -> usize {
        fn weight(context: &Context, e: &Expr, seen: &mut BTreeSet<usize>) -> usize {
            let own: usize = match e {
                Expr::Deriv(f, _) => return 1 + 3 * weight(context, f, &mut BTreeSet::new()),
                Expr::Let(i) if seen.insert(*i) => weight(context, &context.lets[*i].body, seen),
                _ => 1,
            };
            own + e.children().into_iter().map(|e| weight(context, e, seen)).sum::<usize>()
        }
        let all = self.equations.iter().chain(&self.others);
        let sides = all.flat_map(|(r, _)| [&r.lhs, &r.rhs]);
        let mut seen = BTreeSet::new();
        sides.map(|e| weight(&self.goal.context, e, &mut seen)).sum()
    }

    /// A point where the hypotheses hold, as far as that is known.
    pub(crate) fn point(&mut self, chance: &mut Chance, tries: usize) -> Option<(Vec<Q>, At)> {
        for _ in 0..tries {
            let found = self.attempt(chance);
            if found.as_ref().is_some_and(|(_, says)| *says != At::Outside) {
                return found;
            }
        }
        None
    }

    fn attempt(&mut self, chance: &mut Chance) -> Option<(Vec<Q>, At)> {
        let vars = &self.goal.context.vars;
        let mut point: Vec<Q> = vars
            .iter()
            .map(|v| match (&v.lower, &v.upper) {
                (None, None) => Q::zero(),
                (Some(a), None) => &a.value + Q::one(),
                (None, Some(b)) => &b.value - Q::one(),
                (Some(a), Some(b)) => (&a.value + &b.value) / q(2, 1),
            })
            .collect();
        let mut open: BTreeSet<usize> = self.mentioned.iter().copied().collect();
        let mut used = vec![false; self.equations.len()];
        let reuse = !chance.once_in(4);
        let mut plan = if reuse { self.order.clone() } else { Vec::new() };
        plan.reverse();
        let (mut order, mut last) = (Vec::new(), None);
        loop {
            let decided = |symbols: &BTreeSet<usize>| {
                last.is_some_and(|v| symbols.contains(&v)) && symbols.is_disjoint(&open)
            };
            for (r, _) in self.others.iter().filter(|o| decided(&o.1)) {
                if Evaluator::new(&self.goal.context, &point).holds(r) == Ok(false) {
                    return None;
                }
            }
            if open.is_empty() {
                break;
            }
            let ready = self.equations.iter().zip(&used).position(|((_, symbols), used)| {
                !used && symbols.iter().filter(|v| open.contains(v)).count() == 1
            });
            if let Some(i) = ready {
                used[i] = true;
                let (_, symbols) = &self.equations[i];
                let v = symbols.iter().copied().find(|v| open.contains(v))?;
                let failures = self.unsolved.get(&(i, v)).copied().unwrap_or(0);
                if failures >= HOPELESS && !chance.once_in(HOPELESS) {
                    return None;
                }
                let solved = self.solved(i, v, &point, chance);
                let failures = if solved.is_some() { 0 } else { failures + 1 };
                self.unsolved.insert((i, v), failures);
                point[v] = solved?;
                open.remove(&v);
                last = Some(v);
                continue;
            }
            let v = match plan.pop().filter(|v| open.contains(v)) {
                Some(v) => v,
                None => *open.iter().nth(chance.below(open.len()))?,
            };
            point[v] = self.value(v, chance);
            open.remove(&v);
            last = Some(v);
            order.push(v);
        }
        let says = at(self.goal, &point);
        if says != At::Outside {
            self.order = order;
        }
        Some((point, says))
    }

    /// A value in the range of a symbol: corners and near-zeros among them.
    fn value(&self, v: usize, chance: &mut Chance) -> Q {
        let var = &self.goal.context.vars[v];
        let tiny = q(1, 1_000);
        let step = match chance.below(8) {
            0 => Q::zero(),
            1 => tiny.clone(),
            2 => Q::one(),
            3 => q(chance.within(1, 9), chance.within(1, 9)),
            4 => q(chance.within(1, 4), 1),
            5 => q(chance.within(1, 99), 100),
            6 => q(chance.within(1, 9_999), chance.within(1, 9)),
            _ => q(chance.within(1, 20), 4),
        };
        match (&var.lower, &var.upper) {
            (None, None) => {
                if chance.once_in(2) {
                    -step
                } else {
                    step
                }
            }
            (Some(a), None) => {
                if a.strict && step.is_zero() {
                    &a.value + tiny
                } else {
                    &a.value + step
                }
            }
            (None, Some(b)) => {
                if b.strict && step.is_zero() {
                    &b.value - tiny
                } else {
                    &b.value - step
                }
            }
            (Some(a), Some(b)) => {
                let part = match chance.below(6) {
                    0 if !a.strict => Q::zero(),
                    1 if !b.strict => Q::one(),
                    2 => tiny,
                    3 => Q::one() - tiny,
                    _ => q(chance.within(1, 11), 12),
                };
                &a.value + (&b.value - &a.value) * part
            }
        }
    }

    fn fits(&self, v: usize, t: &Q) -> bool {
        within(&self.goal.context.vars[v], t)
    }

    /// A root in v of an equation whose other symbols have values: linear, Möbius or quadratic.
    fn solved(&mut self, i: usize, v: usize, point: &[Q], chance: &mut Chance) -> Option<Q> {
        let (r, context) = (self.equations[i].0, &self.goal.context);
        let mut here = point.to_vec();
        let mut gap = |t: &Q| -> Option<Q> {
            here[v] = t.clone();
            let mut e = Evaluator::new(context, &here);
            Some(e.value(&r.lhs).ok()? - e.value(&r.rhs).ok()?)
        };
        // Most equations are linear: two points, and a third to be sure.
        if let (Some(at_0), Some(at_1)) = (gap(&q(1, 1)), gap(&q(2, 1))) {
            let slope = &at_1 - &at_0;
            if !slope.is_zero() {
                let t = q(1, 1) - at_0 / slope;
                // once seen to be linear: all is checked again in the end
                if self.linear.contains(&(i, v)) || gap(&t).is_some_and(|f| f.is_zero()) {
                    self.linear.insert((i, v));
                    return self.fits(v, &t).then_some(t);
                }
            }
        }
        for scale in [q(1, 1), q(1, 7), q(-1, 1), q(13, 1)] {
            let mut seen: Vec<(Q, Q)> = Vec::new();
            for t in [1, 2, 3, 5] {
                let t = q(t, 1) * &scale;
                if let Some(f) = gap(&t) {
                    seen.push((t, f));
                }
                if seen.len() == 3 {
                    break;
                }
            }
            let [(a, fa), (b, fb), (c, fc)] = &seen[..] else {
                continue;
            };
            if fa.is_zero() && fb.is_zero() && fc.is_zero() {
                return Some(self.value(v, chance));
            }
            let mut found: Vec<Q> = Vec::new();
            let slope = (fb - fa) / (b - a);
            let bend = ((fc - fa) / (c - a) - &slope) / (c - b);
            if bend.is_zero() {
                if !slope.is_zero() {
                    found.push(a - fa / &slope);
                }
            } else {
                // f = fa + slope·(t − a) + bend·(t − a)(t − b)
                let linear = &slope - &bend * (a + b);
                let constant = fa - &slope * a + &bend * a * b;
                let square = &linear * &linear - q(4, 1) * &bend * &constant;
                if let Some(s) = root(&square) {
                    found.push((-&linear + &s) / (q(2, 1) * &bend));
                    found.push((-&linear - &s) / (q(2, 1) * &bend));
                }
                // f = (p + w·t)/(1 + s·t): f + s·t·f = p + w·t at the three points
                let (ga, gb, gc) = (a * fa, b * fb, c * fc);
                let (db, dc) = ((b - a), (c - a));
                let det = (&gb - &ga) * &dc - (&gc - &ga) * &db;
                if !det.is_zero() {
                    let s = ((fc - fa) * &db - (fb - fa) * &dc) / det;
                    let w = ((fb - fa) + &s * (&gb - &ga)) / &db;
                    let p = fa + &s * &ga - &w * a;
                    if !w.is_zero() {
                        found.push(-p / w);
                    }
                }
            }
            if chance.once_in(2) {
                found.reverse();
            }
            for t in found {
                if self.fits(v, &t) && gap(&t).is_some_and(|f| f.is_zero()) {
                    return Some(t);
                }
            }
        }
        None
    }
}

/// The rational root of a square.
fn root(x: &Q) -> Option<Q> {
    if x.is_negative() {
        return None;
    }
    let s = Q::new(x.numer().sqrt(), x.denom().sqrt());
    (&s * &s == *x).then_some(s)
}
