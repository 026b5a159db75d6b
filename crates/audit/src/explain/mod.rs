//! Proofs and witnesses as steps that a person can check on paper.
//!
//! They are data, and made when something shows them; in which words is not decided here.

mod leaf;
mod names;
mod prune;
mod sides;
mod span;
mod step;
mod summary;
mod weight;
mod witness;

use kane_algebra::syntax::rebuild;
use kane_kernel::{
    Atom, Conclusion, Expr, Finding, Fuel, Goal, Limit, Link, Poly, Scope, Sign, State,
    claim_state, constants, scope,
};
use num_integer::Integer as _;
use num_traits::Signed as _;

use crate::argument::{
    Argument, Course, Grounds, LimitArgument, Passage, Rules as _, SideArgument,
};
use crate::kept::Kept;

pub(crate) use prune::without_idle;
pub use step::*;
pub(crate) use summary::{reason, used};
pub(crate) use witness::{beside, mentions, model, values};

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

/// The grounds of an accepted finding, step by step, or what is shorter to read and shows more.
pub(crate) fn told(
    goal: &Goal,
    finding: Finding,
    (grounds, kept): (&Grounds, Option<&Kept>),
) -> Proof {
    let Some(kept) = kept else { return steps(goal, finding, grounds) };
    let mut proof = steps(&kept.goal, finding, &kept.grounds);
    proof.steps.insert(0, Step::Kept(kept.definitions.clone()));
    proof.variables.iter_mut().for_each(|variable| kept.name(variable));
    proof
}

impl Kept {
    /// Names the definition that a symbol stands for, also within a root.
    pub(super) fn name(&self, variable: &mut Variable) {
        let first = self.goal.context.vars.len() - self.definitions.len();
        let definition = |v: usize| self.definitions.get(v.checked_sub(first)?).copied();
        match variable {
            Variable::Symbol(v) => {
                if let Some(i) = definition(*v) {
                    *variable = Variable::Definition(i);
                }
            }
            Variable::Root(root) => {
                let named = rebuild(root, &mut |part| match part {
                    Expr::Var(v) => Ok(definition(*v).map(Expr::Let)),
                    _ => Ok::<_, std::convert::Infallible>(None),
                });
                let Ok(named) = named;
                *root = named;
            }
            _ => {}
        }
    }
}

/// The grounds of an accepted finding, step by step.
pub(crate) fn steps(goal: &Goal, finding: Finding, grounds: &Grounds) -> Proof {
    if let Grounds::Model(model) = grounds {
        let variables = (0..goal.context.vars.len()).map(Variable::Symbol).collect();
        return Proof { variables, steps: vec![witness::step(goal, finding, model)] };
    }
    let Ok(scope) = scope(goal, Fuel::new(FUEL)) else { return Proof::default() };
    let mut teller = Teller { goal, finding, count: 0 };
    let steps = match grounds {
        Grounds::Model(_) => Vec::new(),
        Grounds::Contradiction(course) => match claim_state(&scope, goal, finding) {
            Ok(state) => {
                teller.count += 1;
                // what is the same everywhere is said first; what is supposed then is that it has no meaning
                let equal = sides::equal(goal, finding, &At::new(state.clone()));
                let then = teller.course(&state, course);
                let what = match (finding, &equal) {
                    (Finding::Vacuous, _) => Supposed::Hypotheses,
                    (_, None) => Supposed::Failure,
                    (_, Some(_)) => Supposed::NoValue,
                };
                let suppose = Step::Suppose { what, then };
                equal.into_iter().chain([suppose]).collect()
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
    finding: Finding,
    /// steps made so far
    count: usize,
}

/// Where an argument has got to.
#[derive(Clone)]
struct At<'s, 'g> {
    state: State<'s, 'g>,
    /// where the atoms come from, as far as the argument has assumed them
    origins: Vec<Option<Source>>,
    /// how many of the atoms are there from the first: ranges of symbols
    ranges: usize,
    /// what was replaced, by which quotient; nothing is known any more once powers were lowered
    replaced: Option<Vec<(usize, (Poly, Poly))>>,
}

impl<'s, 'g> At<'s, 'g> {
    fn new(state: State<'s, 'g>) -> Self {
        let ranges = state.atoms.len();
        Self { origins: vec![None; ranges], ranges, state, replaced: Some(Vec::new()) }
    }

    /// In a state that has further atoms, from one source.
    fn into(&self, state: State<'s, 'g>, source: Option<Source>) -> Self {
        let mut origins = self.origins.clone();
        origins.resize(state.atoms.len(), source);
        Self { state, origins, ..self.clone() }
    }
}

impl Teller<'_> {
    /// Notes a step; `false` once there are more than are told.
    fn goes_on(&mut self) -> bool {
        self.count += 1;
        self.count <= MAX_STEPS + 1
    }

    fn argument(&mut self, state: &State<'_, '_>, argument: &Argument) -> Vec<Step> {
        let lean = prune::pruned(state, argument);
        self.steps(&At::new(state.clone()), &lean)
    }

    fn steps(&mut self, at: &At<'_, '_>, argument: &Argument) -> Vec<Step> {
        let mut steps = Vec::new();
        self.walk(at, argument, &mut steps);
        steps
    }

    fn walk(&mut self, at: &At<'_, '_>, argument: &Argument, steps: &mut Vec<Step>) {
        if !self.goes_on() {
            return;
        }
        match argument {
            Argument::Assume { formula, cases } => self.assume(at, *formula, cases, steps),
            Argument::Split { poly, zero, positive, negative } => {
                let case = |atom| at.into(at.state.with(atom), None);
                let [is_zero, is_positive, is_negative] = signs(poly).map(case);
                steps.push(Step::Split {
                    poly: poly.clone(),
                    zero: self.steps(&is_zero, zero),
                    positive: self.steps(&is_positive, positive),
                    negative: self.steps(&is_negative, negative),
                });
            }
            Argument::Cancel { .. } if !prune::is_end(argument) => {
                self.solve(at, argument, steps);
            }
            Argument::Substitute { equation, var, lead, then } => {
                let Some(by) = at.state.atoms.get(*equation) else { return };
                if by.poly.degree(*var) < 2 {
                    return self.solve(at, argument, steps);
                }
                let Ok(next) = at.state.substitute(*equation, *var, lead) else { return };
                let leaves = left(&at.state, &next, then);
                steps.push(Step::Reduce { variable: *var, by: by.clone(), leaves });
                let next = At { state: next, replaced: None, ..at.clone() };
                self.walk(&next, then, steps);
            }
            _ => steps.extend(leaf::step(self.goal, self.finding, at, argument)),
        }
    }

    fn assume(
        &mut self,
        at: &At<'_, '_>,
        formula: usize,
        cases: &[Argument],
        steps: &mut Vec<Step>,
    ) {
        let source = summary::source(self.goal, formula);
        let Ok(states) = at.state.assume(formula) else {
            return;
        };
        let first = at.state.atoms.len();
        let among = |s: &State<'_, '_>, indices: &std::collections::BTreeSet<usize>| {
            let new = s.atoms.iter().enumerate().skip(first);
            let new = new.filter(|(i, _)| indices.contains(i));
            new.map(|(_, atom)| atom.clone()).collect::<Vec<_>>()
        };
        let new = |s: &State<'_, '_>, then: &Argument| among(s, &prune::shown(then, &s.atoms));
        if let ([next], [then]) = (&states[..], cases) {
            let atoms = new(next, then);
            match atoms.is_empty() {
                true => self.count -= 1,
                false => steps.push(Step::Assume { source, atoms }),
            }
            return self.walk(&at.into(next.clone(), Some(source)), then, steps);
        }
        let cases = states.iter().zip(cases).map(|(next, then)| {
            // a case has to be told from the others
            let mut atoms = new(next, then);
            if atoms.is_empty() {
                atoms = among(next, &prune::needed(then));
            }
            (atoms, self.steps(&at.into(next.clone(), Some(source)), then))
        });
        steps.push(Step::Cases { source, cases: cases.collect() });
    }

    /// All replacements and divisions up to what follows from them.
    fn solve(&mut self, at: &At<'_, '_>, argument: &Argument, steps: &mut Vec<Step>) {
        let (mut solved, mut divided) = (Vec::new(), Vec::new());
        let (mut now, mut argument) = (at.clone(), argument);
        loop {
            let state = &now.state;
            match argument {
                Argument::Substitute { equation, var, lead, then } => {
                    let by = state.atoms.get(*equation).and_then(|by| solved_for(&by.poly, *var));
                    let (Some(value), Ok(next)) = (by, state.substitute(*equation, *var, lead))
                    else {
                        break;
                    };
                    let source = now.origins.get(*equation).copied().flatten();
                    solved.push(Solved { variable: *var, value: value.clone(), source });
                    now.state = next;
                    now.replaced.iter_mut().for_each(|all| all.push((*var, value.clone())));
                    argument = then;
                }
                Argument::Cancel { atom, factors, quotient, then } if !prune::is_end(argument) => {
                    let Ok(next) = state.cancel(*atom, factors, quotient) else { break };
                    for (i, _) in factors {
                        let factor = state.atoms.get(*i).cloned();
                        divided.extend(factor.filter(|f: &Atom| !divided.contains(f)));
                    }
                    now.state = next;
                    argument = then;
                }
                _ => break,
            }
            self.count += 1;
        }
        let leaves = left(&at.state, &now.state, argument);
        steps.push(Step::Solve { solved, divided, leaves });
        self.walk(&now, argument, steps);
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
            return steps.extend(self.argument(state, then));
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

    fn limit(&mut self, scope: &Scope<'_>, argument: &LimitArgument) -> Vec<Step> {
        let Conclusion::Link(Link::Limit(limit)) = &self.goal.conclusion else {
            return Vec::new();
        };
        match constants(scope, self.goal, limit.var) {
            Ok(state) => self.limit_in(&state, limit, argument),
            Err(_) => Vec::new(),
        }
    }

    /// A limit in a case of the constants.
    fn limit_in(
        &mut self,
        state: &State<'_, '_>,
        limit: &Limit,
        argument: &LimitArgument,
    ) -> Vec<Step> {
        match argument {
            LimitArgument::Sides(sides) => self.sides(state, limit, sides),
            LimitArgument::Absurd(argument) => self.argument(state, argument),
            LimitArgument::Split { poly, zero, positive, negative } => {
                self.count += 1;
                let [is_zero, is_positive, is_negative] = signs(poly).map(|atom| state.with(atom));
                vec![Step::Split {
                    poly: poly.clone(),
                    zero: self.limit_in(&is_zero, limit, zero),
                    positive: self.limit_in(&is_positive, limit, positive),
                    negative: self.limit_in(&is_negative, limit, negative),
                }]
            }
        }
    }

    /// A limit from each of its sides.
    fn sides(
        &mut self,
        state: &State<'_, '_>,
        limit: &Limit,
        arguments: &[SideArgument],
    ) -> Vec<Step> {
        let (scope, mut steps) = (state.scope, Vec::new());
        for proof in arguments.iter().flat_map(|a| std::iter::once(a).chain(a.upper.as_deref())) {
            if !self.goes_on() {
                break;
            }
            // Proved when the certificate was checked.
            let (Ok(along), Ok(cases)) = (
                state.along_unproved(&proof.germ),
                kane_kernel::differs(
                    scope,
                    &limit.compared(scope),
                    (&proof.num, &proof.den),
                    proof.sense,
                ),
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

/// What is left of the atoms that were changed, as far as what follows speaks of them.
fn left(before: &State<'_, '_>, after: &State<'_, '_>, then: &Argument) -> Vec<Atom> {
    let shown = prune::shown(then, &after.atoms);
    let changed = after.atoms.iter().zip(&before.atoms).enumerate();
    let changed = changed.filter(|(i, (new, old))| shown.contains(i) && new != old);
    let undecided = changed.filter(|(_, (new, _))| new.decided() != Some(true));
    undecided.map(|(_, (new, _))| new.clone()).collect()
}

/// The quotient that an equation of the first degree in v says that v is, in lowest terms. What is divided out
/// divides the coefficient of v, which does not vanish.
fn solved_for(equation: &Poly, v: usize) -> Option<(Poly, Poly)> {
    let parts = equation.coefficients(v);
    let [rest, lead] = &parts[..] else { return None };
    Some(lowest((rest.neg(), lead.clone())))
}

/// A quotient in lowest terms, below a polynomial that begins with a positive term where that can be.
fn lowest((num, den): (Poly, Poly)) -> (Poly, Poly) {
    if num.is_empty() {
        return (num, Poly::one());
    }
    let (num, den) = kane_algebra::ring::cancelled(&num, &den);
    let common = num.primitive().0.gcd(&den.primitive().0);
    let part = |p: &Poly| {
        let (content, rest) = p.primitive();
        rest.scale(&(content / &common))
    };
    let (num, den) = (part(&num), part(&den));
    let negative = |p: &Poly| p.terms().filter(|(_, c)| c.is_negative()).count() * 2 > p.len();
    if negative(&den) { (num.neg(), den.neg()) } else { (num, den) }
}
