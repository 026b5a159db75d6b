//! Proofs and witnesses in words: each step as a sentence that a person can check on paper.
//!
//! The one sentence of a verdict is a [`summary`] and made at once; the steps are made when
//! something shows them.

mod names;
mod summary;
mod witness;

use kane_algebra::syntax::Notation;
use kane_kernel::{
    Atom, Conclusion, Finding, Fuel, Goal, Link, Poly, Scope, Sign, State, claim_state, constants,
    scope, sides,
};
use num_traits::{One, Signed};

use crate::Step;
use crate::argument::{Argument, Course, Grounds, Passage, Rules as _, SideArgument};

use names::root_text;
use summary::Formula;

pub(crate) use summary::{reason, used};
pub(crate) use witness::model;

/// Work that one explanation may take.
const FUEL: u64 = 400_000_000;
/// Lines after which an explanation is cut.
const MAX_LINES: usize = 600;

/// Tells the grounds of an accepted finding step by step. The hypotheses of the goal have these
/// labels.
pub(crate) fn steps(
    goal: &Goal,
    finding: Finding,
    grounds: &Grounds,
    labels: &[&str],
) -> Vec<Step> {
    let mut teller = Teller { goal, labels, steps: Vec::new() };
    match grounds {
        Grounds::Model(model) => return witness::steps(goal, finding, model, labels),
        Grounds::Contradiction(course) => {
            if let Ok(scope) = scope(goal, Fuel::new(FUEL))
                && let Ok(state) = claim_state(&scope, goal, finding)
            {
                teller.open(finding);
                teller.course(&state, course, 1);
            }
        }
        Grounds::Limit(arguments) => {
            if let Ok(scope) = scope(goal, Fuel::new(FUEL)) {
                teller.limit(&scope, arguments);
            }
        }
    }
    teller.steps
}

struct Teller<'a> {
    goal: &'a Goal,
    labels: &'a [&'a str],
    steps: Vec<Step>,
}

impl Teller<'_> {
    fn say(&mut self, depth: usize, text: String) {
        match self.steps.len().cmp(&MAX_LINES) {
            std::cmp::Ordering::Less => self.steps.push(Step { depth, text }),
            std::cmp::Ordering::Equal => {
                let text = "(the rest of this proof is left out here)".to_string();
                self.steps.push(Step { depth: 0, text });
            }
            std::cmp::Ordering::Greater => {}
        }
    }

    fn open(&mut self, finding: Finding) {
        let text = match finding {
            Finding::Vacuous => "Suppose that all hypotheses hold. This is contradictory:",
            _ => "Suppose that the hypotheses hold and the claim does not. This is contradictory:",
        };
        self.say(0, text.to_string());
    }

    fn name(&self, scope: &Scope<'_>, v: usize) -> String {
        names::name(self.goal, scope, v)
    }

    fn poly(&self, scope: &Scope<'_>, p: &Poly) -> String {
        names::poly(self.goal, scope, p)
    }

    fn atom(&self, scope: &Scope<'_>, a: &Atom) -> String {
        // One side each for the positive and the negative terms reads best.
        let side = |negative: bool| {
            let terms = a.poly.terms().filter(|(_, c)| c.is_negative() == negative);
            Poly::sum(terms.map(|(m, c)| (m.to_vec(), c.abs())))
        };
        let (left, right) = (side(false), side(true));
        let relation = match a.sign {
            Sign::Zero => "=",
            Sign::NonZero => "!=",
            Sign::NonNegative => ">=",
            Sign::Positive => ">",
        };
        format!("{} {relation} {}", self.poly(scope, &left), self.poly(scope, &right))
    }

    fn atoms(&self, scope: &Scope<'_>, atoms: &[Atom]) -> String {
        if atoms.is_empty() {
            return "nothing more".to_string();
        }
        let all: Vec<String> = atoms.iter().map(|a| self.atom(scope, a)).collect();
        all.join(", ")
    }

    /// What a formula stands for.
    fn formula(&self, i: usize) -> String {
        let given = || "a given behind the cited claims".to_string();
        match Formula::of(self.goal, i) {
            Formula::Premise(h) => self.labels.get(h).map_or_else(given, ToString::to_string),
            Formula::Limit(h) => {
                format!("the limit in {}", self.labels.get(h).copied().unwrap_or("a given"))
            }
            Formula::Condition => "the condition of the claim".to_string(),
            Formula::Failure => "the claim fails".to_string(),
        }
    }

    fn walk(&mut self, state: &State<'_, '_>, argument: &Argument, depth: usize) {
        let scope = state.scope;
        match argument {
            Argument::Absurd(i) => {
                let text = match state.atoms.get(*i) {
                    Some(a) => format!("{} is false.", self.atom(scope, a)),
                    None => "Contradiction.".to_string(),
                };
                self.say(depth, text);
            }
            Argument::Assume { formula, cases } => {
                let what = self.formula(*formula);
                let Ok(states) = state.assume(*formula) else {
                    return;
                };
                let new = |s: &State<'_, '_>| s.atoms[state.atoms.len()..].to_vec();
                if let ([next], [then]) = (&states[..], &cases[..]) {
                    if !new(next).is_empty() {
                        let text = format!("{what}: {}.", self.atoms(scope, &new(next)));
                        self.say(depth, text);
                    }
                    return self.walk(next, then, depth);
                }
                self.say(depth, format!("{what}: one of {} cases.", cases.len()));
                for (i, (next, then)) in states.iter().zip(cases).enumerate() {
                    let text = format!("Case {}: {}.", i + 1, self.atoms(scope, &new(next)));
                    self.say(depth + 1, text);
                    self.walk(next, then, depth + 2);
                }
            }
            Argument::Split { poly, zero, positive, negative } => {
                let cases = [&**zero, positive, negative];
                self.split(state, poly, depth, &mut |teller, state, i| {
                    teller.walk(state, cases[i], depth + 2);
                });
            }
            Argument::Substitute { equation, var, lead, then } => {
                let Ok(next) = state.substitute(*equation, *var, lead) else {
                    return;
                };
                let name = self.name(scope, *var);
                let parts = state.atoms[*equation].poly.coefficients(*var);
                let solved = match &parts[..] {
                    [e, d] => {
                        let (num, den) = (e.neg(), d.clone());
                        match den.as_constant() {
                            Some(c) if c.is_one() => self.poly(scope, &num),
                            Some(c) if (-&c).is_one() => self.poly(scope, &num.neg()),
                            _ => {
                                format!("({})/({})", self.poly(scope, &num), self.poly(scope, &den))
                            }
                        }
                    }
                    _ => String::new(),
                };
                let text = if solved.is_empty() {
                    // of higher degree: powers are reduced, the variable stays
                    let by = self.atom(scope, &state.atoms[*equation]);
                    format!("Reduce powers of {name} by {by}.")
                } else {
                    format!("Substitute {name} = {solved}.")
                };
                self.say(depth, text);
                let changed: Vec<Atom> = next
                    .atoms
                    .iter()
                    .zip(&state.atoms)
                    .filter(|(new, old)| new != old && new.decided() != Some(true))
                    .map(|(new, _)| new.clone())
                    .collect();
                if !changed.is_empty() {
                    let text = format!("This leaves {}.", self.atoms(scope, &changed));
                    self.say(depth, text);
                }
                self.walk(&next, then, depth);
            }
            Argument::Cancel { atom, factors, quotient, then } => {
                let Ok(next) = state.cancel(*atom, factors, quotient) else {
                    return;
                };
                let by: Vec<String> = factors
                    .iter()
                    .map(|(i, n)| {
                        let p = self.poly(scope, &state.atoms[*i].poly);
                        if *n == 1 { p } else { format!("({p})^{n}") }
                    })
                    .collect();
                let text = format!(
                    "Divide {} by {}, which cannot vanish: {}.",
                    self.atom(scope, &state.atoms[*atom]),
                    by.join(" and "),
                    self.atom(scope, &next.atoms[*atom])
                );
                self.say(depth, text);
                self.walk(&next, then, depth);
            }
            Argument::Positive { terms, cofactors } => {
                let mut parts = Vec::new();
                for t in terms {
                    let mut factors = Vec::new();
                    if !t.weight.is_one() {
                        factors.push(t.weight.to_string());
                    }
                    if t.square != Poly::one() {
                        factors.push(format!("({})^2", self.poly(scope, &t.square)));
                    }
                    for (i, n) in &t.factors {
                        let p = self.poly(scope, &state.atoms[*i].poly);
                        factors.push(if *n == 1 { format!("({p})") } else { format!("({p})^{n}") });
                    }
                    parts.push(if factors.is_empty() {
                        "1".to_string()
                    } else {
                        factors.join("*")
                    });
                }
                for (i, c) in cofactors {
                    let (c, p) = (self.poly(scope, c), self.poly(scope, &state.atoms[*i].poly));
                    parts.push(format!("({c})*[{p}]"));
                }
                let text = format!(
                    "{} is 0 identically, yet it is a sum of non-negative terms, one of them positive{}.",
                    parts.join(" + "),
                    if cofactors.is_empty() { "" } else { " (brackets vanish)" }
                );
                self.say(depth, text);
            }
            Argument::Orthant { atom, bounds } => {
                let shown: Vec<String> = bounds
                    .iter()
                    .flat_map(|(_, l, u)| [*l, *u])
                    .flatten()
                    .map(|i| self.atom(scope, &state.atoms[i]))
                    .collect();
                let text = format!(
                    "{} contradicts {}: measured from these bounds, all its coefficients have the other sign.",
                    self.atom(scope, &state.atoms[*atom]),
                    shown.join(", ")
                );
                self.say(depth, text);
            }
            Argument::SignTable { var, roots, atoms, .. } => {
                let name = self.name(scope, *var);
                let shown: Vec<String> =
                    atoms.iter().map(|(i, ..)| self.atom(scope, &state.atoms[*i])).collect();
                let cuts: Vec<String> = roots.iter().map(root_text).collect();
                let where_ = if cuts.is_empty() {
                    "without a root".to_string()
                } else {
                    format!("cut at {}", cuts.join(", "))
                };
                self.say(
                    depth,
                    format!(
                        "On the line of {name}, {where_}, no part satisfies {}.",
                        shown.join(", ")
                    ),
                );
            }
        }
    }

    /// The three signs of a polynomial: zero, positive, negative.
    fn split<'s, 'g>(
        &mut self,
        state: &State<'s, 'g>,
        poly: &Poly,
        depth: usize,
        then: &mut dyn FnMut(&mut Self, &State<'s, 'g>, usize),
    ) {
        let shown = self.poly(state.scope, poly);
        self.say(depth, format!("Distinguish the sign of {shown}:"));
        let cases = [
            (" = 0", Atom::new(poly.clone(), Sign::Zero)),
            (" > 0", Atom::new(poly.clone(), Sign::Positive)),
            (" < 0", Atom::new(poly.neg(), Sign::Positive)),
        ];
        for (i, (sign, atom)) in cases.into_iter().enumerate() {
            self.say(depth + 1, format!("{shown}{sign}:"));
            then(self, &state.with(atom), i);
        }
    }

    fn course(&mut self, state: &State<'_, '_>, course: &Course, depth: usize) {
        match course {
            Course::After(passages, then) => self.passages(state, passages, then, depth),
            Course::Split { poly, zero, positive, negative } => {
                let cases = [&**zero, positive, negative];
                self.split(state, poly, depth, &mut |teller, state, i| {
                    teller.course(state, cases[i], depth + 2);
                });
            }
        }
    }

    /// Passages to limits, and what follows.
    fn passages(
        &mut self,
        state: &State<'_, '_>,
        passages: &[Passage],
        then: &Argument,
        depth: usize,
    ) {
        let scope = state.scope;
        let Some((Passage { germ, atom, along }, rest)) = passages.split_first() else {
            return self.walk(state, then, depth);
        };
        let (Ok(at), Ok(zero)) = (state.along_unproved(germ), state.at_zero(germ, atom)) else {
            return;
        };
        let text = format!(
            "Along {} for small t > 0: {}. (Square brackets stand for a quantity that has a limit.)",
            names::side(self.goal, &germ.side),
            self.atom(scope, atom)
        );
        self.say(depth, text);
        self.say(depth + 1, "Otherwise:".to_string());
        self.walk(&at.with(atom.not()), along, depth + 2);
        let text = format!("In the limit t = 0: {}.", self.atom(scope, &zero));
        self.say(depth, text);
        self.passages(&state.with(zero), rest, then, depth);
    }

    fn limit(&mut self, scope: &Scope<'_>, arguments: &[SideArgument]) {
        let Conclusion::Link(Link::Limit(limit)) = &self.goal.conclusion else {
            return;
        };
        for (side, proof) in sides(scope, limit).iter().zip(arguments) {
            let ratio = names::ratio(self.goal, scope, &proof.num, &proof.den);
            let f = limit.expr.plain(&self.goal.context);
            let start = |p: &Poly| {
                let zero = p.coefficients(scope.germ()).swap_remove(0);
                self.poly(scope, &zero)
            };
            let with = names::side(self.goal, side);
            let text = format!("With {with}, {f} = {ratio} for all small t > 0.");
            let ends = if proof.order == 0 {
                format!("At t = 0 this is ({})/({}).", start(&proof.num), start(&proof.den))
            } else {
                format!(
                    "At t = 0 the numerator is {} and the denominator vanishes to order {}.",
                    start(&proof.num),
                    proof.order
                )
            };
            self.say(0, text);
            let Ok(state) = constants(scope, self.goal, limit.var) else {
                continue;
            };
            // Proved when the certificate was checked.
            if let Ok(along) = state.along_unproved(&proof.germ)
                && let Ok(cases) =
                    kane_kernel::differs(scope, &limit.expr, (&proof.num, &proof.den))
            {
                self.say(1, "Otherwise:".to_string());
                self.walk(&along.with_cases(cases), &proof.along, 2);
            }
            self.say(0, ends);
        }
    }
}
