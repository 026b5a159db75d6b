//! Proofs and witnesses as steps that a person can check on paper.
//!
//! They are data, and made when something shows them; in which words is not decided here.

mod names;
mod step;
mod summary;
mod witness;

use kane_kernel::{
    Atom, Conclusion, Finding, Fuel, Goal, Link, Poly, Scope, Sign, State, claim_state, constants,
    scope,
};
use num_traits::One;

use crate::argument::{Argument, Course, Grounds, Passage, Rules as _, SideArgument};

pub use step::*;
pub(crate) use summary::{reason, used};
pub(crate) use witness::model;

/// Work that one explanation may take.
const FUEL: u64 = 400_000_000;
/// Steps after which a proof is cut.
pub const MAX_STEPS: usize = 600;

/// What was tried in vain, its variables named; nothing where nothing was.
pub(crate) fn attempt(goal: &Goal, found: crate::prove::Attempt) -> Option<crate::Attempt> {
    if found.tried.is_empty() {
        return None;
    }
    let scope = scope(goal, Fuel::new(FUEL)).ok()?;
    let left = found.left.unwrap_or_default();
    Some(crate::Attempt { tried: found.tried, variables: names::variables(goal, &scope), left })
}

/// The grounds of an accepted finding, step by step.
pub(crate) fn steps(goal: &Goal, finding: Finding, grounds: &Grounds) -> Proof {
    if let Grounds::Model(model) = grounds {
        let variables = (0..goal.context.vars.len()).map(Variable::Symbol).collect();
        return Proof { variables, steps: vec![witness::step(goal, finding, model)] };
    }
    let Ok(scope) = scope(goal, Fuel::new(FUEL)) else { return Proof::default() };
    let mut teller = Teller { goal, count: 0 };
    let steps = match grounds {
        Grounds::Model(_) => Vec::new(),
        Grounds::Contradiction(course) => match claim_state(&scope, goal, finding) {
            Ok(state) => {
                teller.count += 1;
                let hypotheses_alone = finding == Finding::Vacuous;
                vec![Step::Suppose { hypotheses_alone, then: teller.course(&state, course) }]
            }
            Err(_) => Vec::new(),
        },
        Grounds::Limit(arguments) => teller.limit(&scope, arguments),
    };
    Proof { variables: names::variables(goal, &scope), steps }
}

/// Makes steps of arguments by taking them on the kernel's states.
struct Teller<'a> {
    goal: &'a Goal,
    /// steps made so far
    count: usize,
}

impl Teller<'_> {
    /// Notes a step; `false` once there are more than are told.
    fn goes_on(&mut self) -> bool {
        self.count += 1;
        self.count <= MAX_STEPS + 1
    }

    /// Takes back a step that says nothing.
    fn says_nothing(&mut self) {
        self.count -= 1;
    }

    fn argument(&mut self, state: &State<'_, '_>, argument: &Argument) -> Vec<Step> {
        let mut steps = Vec::new();
        self.walk(state, argument, &mut steps);
        steps
    }

    fn walk(&mut self, state: &State<'_, '_>, argument: &Argument, steps: &mut Vec<Step>) {
        if !self.goes_on() {
            return;
        }
        let atom = |i: usize| state.atoms[i].clone();
        match argument {
            Argument::Absurd(i) => steps.extend(state.atoms.get(*i).cloned().map(Step::Absurd)),
            Argument::Assume { formula, cases } => {
                self.assume(state, *formula, cases, steps);
            }
            Argument::Split { poly, zero, positive, negative } => {
                let case = |atom| state.with(atom);
                let [is_zero, is_positive, is_negative] = signs(poly).map(case);
                steps.push(Step::Split {
                    poly: poly.clone(),
                    zero: self.argument(&is_zero, zero),
                    positive: self.argument(&is_positive, positive),
                    negative: self.argument(&is_negative, negative),
                });
            }
            Argument::Substitute { equation, var, lead, then } => {
                let Ok(next) = state.substitute(*equation, *var, lead) else {
                    return;
                };
                let changed = next.atoms.iter().zip(&state.atoms);
                let changed =
                    changed.filter(|(new, old)| new != old && new.decided() != Some(true));
                let leaves = changed.map(|(new, _)| new.clone()).collect();
                let by = &state.atoms[*equation];
                steps.push(match solved(&by.poly, *var) {
                    Some(value) => Step::Substitute { variable: *var, value, leaves },
                    None => Step::Reduce { variable: *var, by: by.clone(), leaves },
                });
                self.walk(&next, then, steps);
            }
            Argument::Cancel { atom: i, factors, quotient, then } => {
                let Ok(next) = state.cancel(*i, factors, quotient) else {
                    return;
                };
                let factor = |(i, n): &(usize, u32)| (state.atoms[*i].poly.clone(), *n);
                let by = factors.iter().map(factor).collect();
                steps.push(Step::Divide { atom: atom(*i), by, quotient: next.atoms[*i].clone() });
                self.walk(&next, then, steps);
            }
            Argument::Positive { terms, cofactors } => {
                let factor = |(i, n): &(usize, u32)| (state.atoms[*i].poly.clone(), *n);
                let term = |t: &kane_kernel::Term| Summand {
                    weight: t.weight.clone(),
                    square: t.square.clone(),
                    factors: t.factors.iter().map(factor).collect(),
                };
                let multiple = |(i, c): &(usize, Poly)| (c.clone(), state.atoms[*i].poly.clone());
                steps.push(Step::Positive {
                    terms: terms.iter().map(term).collect(),
                    multiples: cofactors.iter().map(multiple).collect(),
                });
            }
            Argument::Orthant { atom: i, bounds } => {
                let bounds = bounds.iter().flat_map(|(_, l, u)| [*l, *u]).flatten();
                let bounds = bounds.map(atom).collect();
                steps.push(Step::SignsOfCoefficients { atom: atom(*i), bounds });
            }
            Argument::SignTable { var, roots, atoms, .. } => {
                let atoms = atoms.iter().map(|(i, ..)| atom(*i)).collect();
                let cuts = roots.iter().map(witness::tight).collect();
                steps.push(Step::SignTable { variable: *var, cuts, atoms });
            }
        }
    }

    fn assume(
        &mut self,
        state: &State<'_, '_>,
        formula: usize,
        cases: &[Argument],
        steps: &mut Vec<Step>,
    ) {
        let source = summary::source(self.goal, formula);
        let Ok(states) = state.assume(formula) else {
            return;
        };
        let new = |s: &State<'_, '_>| s.atoms[state.atoms.len()..].to_vec();
        if let ([next], [then]) = (&states[..], cases) {
            let atoms = new(next);
            match atoms.is_empty() {
                true => self.says_nothing(),
                false => steps.push(Step::Assume { source, atoms }),
            }
            return self.walk(next, then, steps);
        }
        let cases = states.iter().zip(cases);
        let cases = cases.map(|(next, then)| (new(next), self.argument(next, then)));
        steps.push(Step::Cases { source, cases: cases.collect() });
    }

    fn course(&mut self, state: &State<'_, '_>, course: &Course) -> Vec<Step> {
        match course {
            Course::After(passages, then) => {
                let mut steps = Vec::new();
                self.passages(state, passages, then, &mut steps);
                steps
            }
            Course::Split { poly, zero, positive, negative } => {
                self.count += 1;
                let case = |atom| state.with(atom);
                let [is_zero, is_positive, is_negative] = signs(poly).map(case);
                vec![Step::Split {
                    poly: poly.clone(),
                    zero: self.course(&is_zero, zero),
                    positive: self.course(&is_positive, positive),
                    negative: self.course(&is_negative, negative),
                }]
            }
        }
    }

    /// Passages to limits, and what follows.
    fn passages(
        &mut self,
        state: &State<'_, '_>,
        passages: &[Passage],
        then: &Argument,
        steps: &mut Vec<Step>,
    ) {
        let Some((Passage { germ, atom, along }, rest)) = passages.split_first() else {
            return self.walk(state, then, steps);
        };
        let (Ok(at), Ok(end)) = (state.along_unproved(germ), state.at_zero(germ, atom)) else {
            return;
        };
        if !self.goes_on() {
            return;
        }
        let otherwise = self.argument(&at.with(atom.not()), along);
        let (side, along, next) = (germ.side.clone(), atom.clone(), state.with(end.clone()));
        steps.push(Step::Pass { side, power: germ.power, along, otherwise, end });
        self.passages(&next, rest, then, steps);
    }

    fn limit(&mut self, scope: &Scope<'_>, arguments: &[SideArgument]) -> Vec<Step> {
        let mut steps = Vec::new();
        let Conclusion::Link(Link::Limit(limit)) = &self.goal.conclusion else {
            return steps;
        };
        let Ok(state) = constants(scope, self.goal, limit.var) else {
            return steps;
        };
        for proof in arguments.iter().flat_map(|a| std::iter::once(a).chain(a.upper.as_deref())) {
            if !self.goes_on() {
                break;
            }
            // Proved when the certificate was checked.
            let (Ok(along), Ok(cases)) = (
                state.along_unproved(&proof.germ),
                kane_kernel::differs(scope, &limit.expr, (&proof.num, &proof.den), proof.sense),
            ) else {
                continue;
            };
            let start = |p: &Poly| p.coefficients(scope.germ()).swap_remove(0);
            steps.push(Step::LimitFrom {
                side: proof.germ.side.clone(),
                power: proof.germ.power,
                of: limit.expr.clone(),
                sense: proof.sense,
                quotient: (proof.num.clone(), proof.den.clone()),
                otherwise: self.argument(&along.with_cases(cases), &proof.along),
                start: (start(&proof.num), start(&proof.den)),
                order: proof.order,
            });
        }
        steps
    }
}

/// The three signs of a polynomial: zero, positive, negative.
fn signs(poly: &Poly) -> [Atom; 3] {
    [
        Atom::new(poly.clone(), Sign::Zero),
        Atom::new(poly.clone(), Sign::Positive),
        Atom::new(poly.neg(), Sign::Positive),
    ]
}

/// The quotient that an equation of the first degree in v says that v is; a denominator ±1 is 1.
fn solved(equation: &Poly, v: usize) -> Option<(Poly, Poly)> {
    let parts = equation.coefficients(v);
    let [rest, lead] = &parts[..] else { return None };
    Some(match lead.as_constant() {
        Some(c) if c.is_one() => (rest.neg(), Poly::one()),
        Some(c) if (-&c).is_one() => (rest.clone(), Poly::one()),
        _ => (rest.neg(), lead.clone()),
    })
}
