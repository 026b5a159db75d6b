//! A finding in one sentence, and the hypotheses that it used: read off the argument as it stands,
//! without the states that it passes through.

use kane_kernel::{Conclusion, Finding, Fuel, Goal, Link, constants, scope, sides};

use super::{FUEL, names, witness};
use crate::argument::{Argument, Course, Grounds, SideArgument};

/// What a formula of a goal's state stands for; hypotheses by their index.
pub(super) enum Formula {
    /// a hypothesis, at a point
    Premise(usize),
    /// a limit in a hypothesis
    Limit(usize),
    /// the `when` of the claim
    Condition,
    /// the claim, which fails
    Failure,
}

impl Formula {
    /// The formula with this index.
    pub(super) fn of(goal: &Goal, i: usize) -> Self {
        let Some(further) = i.checked_sub(goal.hypotheses.len()) else {
            return Self::Premise(i);
        };
        let limits = |(h, hypothesis): (usize, &kane_kernel::Hypothesis)| {
            hypothesis.sentence.limits().map(move |_| h).collect::<Vec<_>>()
        };
        let limits: Vec<usize> = goal.hypotheses.iter().enumerate().flat_map(limits).collect();
        match limits.get(further) {
            Some(h) => Self::Limit(*h),
            None if further == limits.len() => Self::Condition,
            None => Self::Failure,
        }
    }
}

/// The hypotheses that grounds use, ascending; of a model, the first `cited`.
pub(crate) fn used(goal: &Goal, grounds: &Grounds, cited: usize) -> Vec<usize> {
    let mut uses = Uses::default();
    match grounds {
        Grounds::Contradiction(course) => uses.course(course),
        Grounds::Limit(arguments) => arguments.iter().for_each(|a| uses.argument(&a.along)),
        Grounds::Model(_) => return (0..goal.hypotheses.len().min(cited)).collect(),
    }
    let hypothesis = |i: usize| match Formula::of(goal, i) {
        Formula::Premise(h) | Formula::Limit(h) => Some(h),
        Formula::Condition | Formula::Failure => None,
    };
    let mut used: Vec<usize> = uses.formulas.into_iter().filter_map(hypothesis).collect();
    used.sort_unstable();
    used.dedup();
    used
}

/// Grounds of an accepted finding in one sentence.
pub(crate) fn reason(goal: &Goal, finding: Finding, grounds: &Grounds) -> String {
    match grounds {
        Grounds::Model(model) => witness::reason(goal, finding, model),
        Grounds::Limit(arguments) => {
            limit(goal, arguments).unwrap_or_else(|| "accepted".to_string())
        }
        Grounds::Contradiction(course) => {
            let mut uses = Uses::default();
            uses.course(course);
            uses.sentence(goal, finding)
        }
    }
}

/// A limit as it was read off on the first side.
fn limit(goal: &Goal, arguments: &[SideArgument]) -> Option<String> {
    let Conclusion::Link(Link::Limit(limit)) = &goal.conclusion else {
        return None;
    };
    let scope = scope(goal, Fuel::new(FUEL)).ok()?;
    let first = sides(&scope, limit).into_iter().zip(arguments).next();
    let told = first.filter(|_| constants(&scope, goal, limit.var).is_ok());
    Some(told.map_or_else(String::new, |(side, argument)| {
        let ratio = names::ratio(goal, &scope, &argument.num, &argument.den);
        let long = ratio.len() > 60;
        let short = if long { "a quotient of polynomials in t".to_string() } else { ratio };
        format!("{} gives {short}", names::side(goal, &side))
    }))
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

    fn sentence(&self, goal: &Goal, finding: Finding) -> String {
        let mut parts = Vec::new();
        if self.limits {
            parts.push("passage to the limit".to_string());
        }
        if !self.substituted.is_empty() {
            let names = if self.substituted.len() > 4 {
                format!("{} solved premises", self.substituted.len())
            } else {
                listed(goal, &self.substituted)
            };
            parts.push(format!("substituting {names}"));
        }
        if !self.tables.is_empty() {
            parts.push(format!("sign table in {}", listed(goal, &self.tables)));
        }
        if self.sums {
            parts.push("a sum of non-negative terms".to_string());
        }
        if self.signs {
            parts.push("signs of coefficients".to_string());
        }
        let how = if parts.is_empty() {
            "directly".to_string()
        } else {
            format!("by {}", parts.join("; "))
        };
        match finding {
            Finding::Vacuous => format!("the hypotheses contradict each other, {how}"),
            Finding::Refuted => format!("it does follow, {how}"),
            _ => how,
        }
    }
}

/// Names of variables of a goal's scope, which is only made if one is no symbol.
fn listed(goal: &Goal, vars: &[usize]) -> String {
    let symbol = |v: &usize| goal.context.vars.get(*v).map(|var| var.name.clone());
    let symbols: Option<Vec<String>> = vars.iter().map(symbol).collect();
    let names = symbols.or_else(|| {
        let scope = scope(goal, Fuel::new(FUEL)).ok()?;
        Some(vars.iter().map(|v| names::name(goal, &scope, *v)).collect())
    });
    names.unwrap_or_default().join(", ")
}
