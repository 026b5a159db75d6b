//! A finding in outline, and the hypotheses that it used: read off the argument as it stands,
//! without the states that it passes through.

use std::cmp::Ordering;

use kane_kernel::{Conclusion, Finding, Fuel, Goal, Link, Poly, scope, sides};

use super::{FUEL, Means, Reason, Source, Variable, names, witness};
use crate::argument::{Argument, Course, Grounds, LimitArgument, SideArgument};
use crate::kept::Kept;

/// Where the formula with this index of a goal's state comes from.
pub(super) fn source(goal: &Goal, i: usize) -> Source {
    let Some(further) = i.checked_sub(goal.hypotheses.len()) else {
        return Source::Hypothesis(i);
    };
    let limits = |(h, hypothesis): (usize, &kane_kernel::Hypothesis)| {
        hypothesis.sentence.limits().map(move |_| h).collect::<Vec<_>>()
    };
    let limits: Vec<usize> = goal.hypotheses.iter().enumerate().flat_map(limits).collect();
    match limits.get(further) {
        Some(h) => Source::Limit(*h),
        None if further == limits.len() => Source::Condition,
        None => Source::Failure,
    }
}

/// The hypotheses that grounds use, ascending; of a model, the first `cited`.
pub(crate) fn used(goal: &Goal, grounds: &Grounds, cited: usize) -> Vec<usize> {
    let mut uses = Uses::default();
    match grounds {
        Grounds::Contradiction(course) => uses.course(course),
        Grounds::Limit(argument) => uses.limit(argument),
        Grounds::Model(_) => return (0..goal.hypotheses.len().min(cited)).collect(),
    }
    let hypothesis = |i: usize| match source(goal, i) {
        Source::Hypothesis(h) | Source::Limit(h) => Some(h),
        Source::Condition | Source::Failure => None,
    };
    let mut used: Vec<usize> = uses.formulas.into_iter().filter_map(hypothesis).collect();
    used.sort_unstable();
    used.dedup();
    used
}

/// Grounds of an accepted finding in outline, or what is shorter to read and shows more.
pub(crate) fn reason(
    goal: &Goal,
    finding: Finding,
    (grounds, kept): (&Grounds, Option<&Kept>),
) -> Reason {
    let Some(kept) = kept else { return alone(goal, finding, grounds) };
    let mut reason = alone(&kept.goal, finding, &kept.grounds);
    if let Reason::Contradiction(means) = &mut reason {
        let variables = means.substituted.iter_mut().chain(&mut means.tables);
        variables.for_each(|variable| kept.name(variable));
    }
    reason
}

fn alone(goal: &Goal, finding: Finding, grounds: &Grounds) -> Reason {
    match grounds {
        Grounds::Model(model) => witness::reason(goal, finding, model),
        Grounds::Limit(arguments) => limit(goal, arguments).unwrap_or(Reason::NoSide),
        Grounds::Contradiction(course) => {
            let mut uses = Uses::default();
            uses.course(course);
            uses.means(goal, finding)
        }
    }
}

/// A limit as it was read off on the first side, or of what it was told apart by sign.
fn limit(goal: &Goal, argument: &LimitArgument) -> Option<Reason> {
    let Conclusion::Link(Link::Limit(limit)) = &goal.conclusion else {
        return None;
    };
    let scope = scope(goal, Fuel::new(FUEL)).ok()?;
    let LimitArgument::Sides(arguments) = argument else {
        return Some(Reason::LimitByCases(told_apart(argument)));
    };
    let (side, argument) = sides(&scope, limit).into_iter().zip(arguments).next()?;
    let quotient = (argument.num.clone(), argument.den.clone());
    // between a quotient and itself it is that quotient
    let same = |upper: &SideArgument| (&upper.num, &upper.den) == (&argument.num, &argument.den);
    let is_both = argument.upper.as_deref().is_some_and(same);
    let sense = if is_both { Ordering::Equal } else { argument.sense };
    let power = argument.germ.power;
    Some(Reason::Limit { side, power, sense, quotient, variables: names::variables(goal, &scope) })
}

/// The polynomials of whose signs there are cases, each once, from the outside in.
fn told_apart(argument: &LimitArgument) -> Vec<Poly> {
    let (mut out, mut todo) = (Vec::new(), vec![argument]);
    while let Some(argument) = todo.pop() {
        if let LimitArgument::Split { poly, zero, positive, negative } = argument {
            if !out.contains(poly) {
                out.push(poly.clone());
            }
            todo.extend([&**negative, positive, zero]);
        }
    }
    out
}

/// What an argument uses.
#[derive(Default)]
struct Uses {
    /// variables that were substituted, in the order of the argument
    substituted: Vec<usize>,
    /// variables of sign tables
    tables: Vec<usize>,
    signs: bool,
    sums: bool,
    limits: bool,
    /// indices of formulas
    formulas: Vec<usize>,
}

impl Uses {
    fn limit(&mut self, argument: &LimitArgument) {
        match argument {
            LimitArgument::Sides(sides) => sides.iter().for_each(|side| self.side(side)),
            LimitArgument::Absurd(argument) => self.argument(argument),
            LimitArgument::Split { zero, positive, negative, .. } => {
                [zero, positive, negative].into_iter().for_each(|case| self.limit(case));
            }
        }
    }

    fn side(&mut self, side: &SideArgument) {
        self.argument(&side.along);
        self.argument(&side.at_zero);
        side.upper.iter().for_each(|upper| self.side(upper));
    }

    fn course(&mut self, course: &Course) {
        match course {
            Course::After(passages, then) => {
                for passage in passages {
                    self.limits = true;
                    self.argument(&passage.along);
                }
                self.argument(then);
            }
            Course::Split { zero, positive, negative, .. } => {
                [zero, positive, negative].into_iter().for_each(|case| self.course(case));
            }
        }
    }

    fn argument(&mut self, argument: &Argument) {
        match argument {
            Argument::Absurd(_) => {}
            Argument::Assume { formula, cases } => {
                self.formulas.push(*formula);
                cases.iter().for_each(|case| self.argument(case));
            }
            Argument::Split { zero, positive, negative, .. } => {
                [zero, positive, negative].into_iter().for_each(|case| self.argument(case));
            }
            Argument::Substitute { var, then, .. } => {
                if !self.substituted.contains(var) {
                    self.substituted.push(*var);
                }
                self.argument(then);
            }
            Argument::Cancel { then, .. } => self.argument(then),
            Argument::Positive { .. } => self.sums = true,
            Argument::Orthant { .. } => self.signs = true,
            Argument::SignTable { var, .. } => {
                if !self.tables.contains(var) {
                    self.tables.push(*var);
                }
            }
        }
    }

    fn means(self, goal: &Goal, finding: Finding) -> Reason {
        Reason::Contradiction(Means {
            finding,
            limits: self.limits,
            substituted: named(goal, &self.substituted),
            tables: named(goal, &self.tables),
            sums: self.sums,
            signs: self.signs,
        })
    }
}

/// What variables of a goal's scope stand for; the scope is only made if one is no symbol.
fn named(goal: &Goal, vars: &[usize]) -> Vec<Variable> {
    if vars.iter().all(|v| *v < goal.context.vars.len()) {
        return vars.iter().map(|v| Variable::Symbol(*v)).collect();
    }
    match scope(goal, Fuel::new(FUEL)) {
        Ok(scope) => vars.iter().map(|v| names::variable(goal, &scope, *v)).collect(),
        Err(_) => Vec::new(),
    }
}
