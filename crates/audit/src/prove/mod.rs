//! Finding proofs and witnesses for goals. Nothing here is trusted: what is found goes to the
//! kernel, and what the kernel does not accept is not reported.

mod approach;
mod asymptote;
mod attempt;
mod between;
mod bound;
mod bounds;
mod boxes;
mod budget;
mod cases;
mod cells;
mod change;
mod circuits;
mod cofactor;
mod colon;
mod combination;
mod comparison;
mod components;
mod conics;
mod conjugates;
mod contacts;
mod diagonal;
mod differences;
mod discriminant;
mod dominance;
mod elimination;
mod enclosure;
mod envelope;
mod expansion;
mod factors;
mod fixed;
mod functions;
mod germs;
mod ground;
mod hints;
mod homogeneous;
mod ideal;
mod idle;
mod isolated;
mod known_sign;
mod leaf;
mod lemmas;
mod lesser;
mod limits;
mod line;
mod linear;
mod lone_root;
mod means;
mod monomial;
mod nearness;
mod pairs;
mod parameter;
mod places;
mod primitive;
mod products;
mod radicals;
mod radicand;
mod ranges;
mod reciprocal;
mod retelling;
mod rule;
mod sample;
mod search;
mod series;
mod settled;
mod simplification;

mod squares;
mod squeeze;
mod summands;
mod surds;
mod symbols;
mod tactics;
mod tangents;
mod touching;
mod undefined;
mod valley;
mod variation;
mod witness;
mod written;

use std::cell::RefCell;
use std::rc::Rc;

use kane_kernel::{
    Atom, Certificate, Conclusion, Evidence, Expr, Finding, Fuel, Goal, Limit, Link, Model, Poly,
    Rejection, Sentence, Side, Sign, State, check, claim_state, constants, digest, scope, sides,
};

use crate::argument::{Course, Flaw, Grounds, contradiction, limit_proof};
use crate::kept::Kept;
use crate::{Open, explain};

/// Case distinctions on constants before what limits say of them is given up.
const PASS_SPLITS: u32 = 2;
/// Models of earlier claims that are tried again.
pub(crate) const REMEMBERED: usize = 4;
/// A search that is to be brief has one part in so many of the work.
const BRIEF: u64 = 64;
/// Bits of a coefficient beyond which the ways that take long are not gone.
const WIDE: u64 = 256;

pub(crate) use attempt::Attempt;
use budget::Ways;
use functions::Effort;
use germs::Germs;
pub(crate) use germs::Memory;
use hints::Hint;
pub(crate) use hints::expanded;

use search::{Outcome, Search};

pub use budget::Budget;
pub use variation::expression;

/// A certificate that the kernel accepted, and what it was written out from.
#[derive(Clone, Debug)]
pub struct Decided {
    /// what the kernel accepted
    pub certificate: Certificate,
    pub(crate) grounds: Grounds,
    /// a proof of more, if that is shorter to read
    pub(crate) kept: Option<Rc<Kept>>,
}

/// What was found about a goal.
#[derive(Clone, Debug, Default)]
pub(crate) struct Verdicts {
    /// what decides, if anything does
    pub(crate) decided: Option<Decided>,
    /// a model of the hypotheses, accepted too
    pub(crate) model: Option<Model>,
    /// why nothing decides
    pub(crate) open: Option<Open>,
    /// search steps spent
    pub(crate) cost: u64,
    /// what was tried in vain
    pub(crate) attempt: Attempt,
    /// whether a model that decides was found for the givens behind what is cited, too
    pub(crate) behind_met: bool,
    /// a side of a limit, and a given that was not shown to hold near it
    pub(crate) unreached: Option<(Side, Sentence)>,
}

/// A question to the search and the budget for it.
pub(crate) struct Prover<'a> {
    pub(crate) budget: Budget,
    /// what is left for the claim of its document's budget; every other budget is a part of it
    pub(crate) work: Fuel,
    /// expressions whose squares and products are to be tried, without definitions
    pub(crate) using: &'a [Expr],
    /// proposed values or functions
    pub(crate) by: &'a [(usize, Expr)],
    /// models of earlier claims, which often serve again
    pub(crate) earlier: &'a RefCell<Vec<Model>>,
    /// functions with which givens held near limits of this claim
    pub(crate) near: Memory,
    /// number of the hypotheses that are cited
    pub(crate) cited: usize,
    /// the goal with all givens on which it finally rests as further hypotheses
    pub(crate) resting: &'a Goal,
}

impl Prover<'_> {
    fn fuel(&self) -> Fuel {
        self.work.within(self.budget.fuel)
    }

    /// A quarter of what is left for the claim: what a search gets that only guides to better points.
    fn quarter(&self) -> Fuel {
        self.work.within(self.work.left() / 4)
    }

    fn effort(&self, candidates: usize, guide: bool) -> Effort {
        let (steps, fuel) = (self.budget.steps, self.budget.fuel);
        let work = if guide { self.quarter() } else { self.work.clone() };
        Effort { steps, fuel, candidates, work }
    }

    /// Accepts a finding only through the kernel.
    fn accept(
        &self,
        goal: &Goal,
        finding: Finding,
        grounds: &Grounds,
    ) -> Result<Certificate, Open> {
        let fuel = || self.work.within(self.budget.check);
        // a budget that is spent has nothing left; what ends before that, no budget ends
        let open = |fuel: Fuel, why: Open| match why {
            Open::Unwritten(Flaw::Kernel(Rejection::Budget))
            | Open::Rejected(Rejection::Budget)
                if fuel.left() > 0 =>
            {
                Open::Bound
            }
            why => why,
        };
        let writing = fuel();
        let evidence = evidence(goal, finding, grounds, &writing)
            .map_err(|why| open(writing, Open::Unwritten(why)))?;
        let certificate = Certificate { goal: digest(goal), finding, evidence };
        let checking = fuel();
        match check(goal, &certificate, checking.clone()) {
            Ok(()) => Ok(certificate),
            Err(why) => Err(open(checking, Open::Rejected(why))),
        }
    }

    /// Judges a goal; with `doubt`, also whether its hypotheses can hold at all.
    pub(crate) fn judge(&self, goal: &Goal, doubt: bool) -> Verdicts {
        let mut out = Verdicts::default();
        match scope(goal, self.fuel()) {
            Err(why) => out.open = Some(Open::Unfit(why)),
            Ok(_) => match &goal.conclusion {
                Conclusion::Link(Link::Limit(l)) => self.judge_limit(goal, l, doubt, &mut out),
                _ => self.judge_pointwise(goal, doubt, &mut out),
            },
        }
        if out.decided.is_none() && self.work.left() == 0 {
            out.open = Some(Open::Document(out.cost));
        }
        if out.decided.is_none() && out.open.is_none() {
            // Along limits steps are not all counted.
            let limit = matches!(goal.conclusion, Conclusion::Link(Link::Limit(_)));
            out.open = Some(Open::Steps(if limit { self.budget.steps } else { out.cost }));
        }
        out
    }

    fn decide(&self, goal: &Goal, finding: Finding, grounds: Grounds, out: &mut Verdicts) -> bool {
        match self.accept(goal, finding, &grounds) {
            Ok(certificate) => {
                out.decided = Some(Decided { certificate, grounds, kept: None });
                true
            }
            Err(why) => {
                out.open = Some(why);
                false
            }
        }
    }

    /// Searches for a contradiction in the state of a finding.
    fn closed(
        &self,
        goal: &Goal,
        finding: Finding,
        ways: Ways,
        out: &mut Verdicts,
    ) -> Option<Grounds> {
        match self.search(goal, finding, false, ways, out) {
            (Some(course), _) => Some(Grounds::Contradiction(course)),
            (None, _) => None,
        }
    }

    /// Searches the state of a finding, premised limits passed first.
    fn search(
        &self,
        goal: &Goal,
        finding: Finding,
        models: bool,
        ways: Ways,
        out: &mut Verdicts,
    ) -> (Option<Course>, Outcome) {
        let open = (None, Outcome::Open);
        // Premises beyond the cited ones only guide to better points: a little search is enough.
        let brief = ways.are_brief();
        let guide = models && !brief && goal.hypotheses.len() > self.cited;
        let budget = if brief { self.budget.share(BRIEF) } else { self.budget };
        let (steps, fuel) =
            if guide { (budget.steps / 8, budget.fuel / 16) } else { (budget.steps, budget.fuel) };
        // What the near ways have tried in full is tried again on cases alone.
        let steps = if ways == Ways::Far { steps / 4 } else { steps };
        let work = if guide { self.quarter() } else { self.work.clone() };
        let Ok(scope) = scope(goal, work.within(fuel)) else {
            return open;
        };
        let state = match claim_state(&scope, goal, finding) {
            Ok(state) => state,
            Err(why) => {
                if why == Rejection::Budget && !guide && !brief {
                    out.open = Some(Open::Unfit(why));
                }
                return open;
            }
        };
        let wide = |a: &Atom| a.poly.bits() > WIDE;
        if ways == Ways::Far && state.formulas.iter().flatten().flatten().any(wide) {
            return open;
        }
        let mut germs = limits::premised_sides(&state, goal);
        if let (Conclusion::Link(Link::Limit(l)), Finding::Vacuous) = (&goal.conclusion, finding) {
            germs.extend(
                sides(&scope, l).into_iter().filter(|s| !germs.contains(s)).collect::<Vec<_>>(),
            );
        }
        germs.retain(|side| state.passages.allow(side.var));
        let any = |_: usize, _: &Poly| true;
        let mut search = Search::new(steps, &any, models && germs.is_empty());
        search.ideals = budget.ideals;
        search.products = budget.products && ways != Ways::Brief;
        search.squares = work.within(budget.squares);
        let cells = if guide { budget.cells / 16 } else { budget.cells };
        search.cells = work.within(cells);
        if ways == Ways::Far {
            search.far = true;
            search.squares = work.within(budget.squares / 16);
        }
        search.brief = brief;
        search.keep = kept(goal);
        search.hints = Hint::all(&scope, self.using);
        search.as_written = !models;
        search.tangents = ways == Ways::Near && finding == Finding::Proved;
        if guide {
            search.widest = 60;
        }
        // Who looks for a point does not also look for long proofs that there is none.
        search.proofs = !models;
        // Without the limits first: most claims do not need them.
        let assumed = if ways == Ways::Alone { goal.hypotheses.len() } else { 0 };
        let mut outcome = search.solve_from(&state, assumed);
        let mut course = None;
        if !germs.is_empty() && !brief && !matches!(outcome, Outcome::Closed(_)) {
            course = self.passed(&state, &germs, PASS_SPLITS);
        }
        out.cost += steps - search.left();
        // What is left open is told of the search for a proof; another one's is another question.
        let mut attempt = search.attempt.take();
        attempt.left.take_if(|_| models || !matches!(finding, Finding::Proved));
        out.attempt.join(attempt);
        if !guide && !brief && scope.fuel.spend(1).is_err() {
            out.open = Some(Open::Operations(fuel));
        }
        if let Outcome::Closed(argument) = outcome {
            course = Some(Course::After(Vec::new(), argument));
            outcome = Outcome::Open;
        }
        (course, outcome)
    }

    /// The search after what limits say of constants; by cases, if a given can hold near a limit
    /// only where some constant does not vanish.
    fn passed(&self, state: &State<'_, '_>, germs: &[Side], splits: u32) -> Option<Course> {
        let any = |_: usize, _: &Poly| true;
        let (next, found) = limits::passes(state, germs, self.budget.steps, &self.near);
        if !found.is_empty()
            && let Outcome::Closed(proof) = Search::new(self.budget.steps, &any, false).solve(&next)
        {
            return Some(explain::without_idle(state, found, &proof));
        }
        let splits = splits.checked_sub(1)?;
        let lead = germs.iter().find_map(|side| {
            Germs::new(state, side, self.budget.steps).leads().into_iter().next()
        })?;
        let case = |sign, poly: Poly| {
            let state = state.with(Atom::new(poly, sign));
            match Search::new(self.budget.steps / 8, &any, false).solve(&state) {
                Outcome::Closed(argument) => Some(Course::After(Vec::new(), argument)),
                _ => self.passed(&state, germs, splits),
            }
        };
        Some(Course::Split {
            zero: case(Sign::Zero, lead.clone())?.into(),
            positive: case(Sign::Positive, lead.clone())?.into(),
            negative: case(Sign::Positive, lead.neg())?.into(),
            poly: lead,
        })
    }

    /// Proves a pointwise goal, as is best to read.
    fn proves(&self, goal: &Goal, ways: Ways, out: &mut Verdicts) -> bool {
        let proved = self
            .closed(goal, Finding::Proved, ways, out)
            .is_some_and(|grounds| self.decide(goal, Finding::Proved, grounds, out));
        if proved {
            self.retell(goal, out);
        }
        proved
    }

    /// Looks for a proof of a pointwise goal, and for nothing else.
    pub(crate) fn prove(&self, goal: &Goal) -> Verdicts {
        let mut out = Verdicts::default();
        if !self.proves(goal, Ways::Near, &mut out) && out.open.is_none() {
            out.open = Some(Open::NoProof(self.budget.steps));
        }
        out
    }

    /// Whether a pointwise goal is proved, from hypotheses that can hold: of such as contradict each other anything would
    /// follow. No other verdict is looked for.
    pub(crate) fn follows(&self, goal: &Goal) -> bool {
        let mut out = Verdicts::default();
        self.closed(goal, Finding::Proved, Ways::Near, &mut out)
            .is_some_and(|grounds| self.decide(goal, Finding::Proved, grounds, &mut out))
            && !self.consistent(goal, &mut out)
            && out.model.is_some()
    }

    /// Looks for a point against a pointwise goal, and for nothing else.
    pub(crate) fn refute(&self, goal: &Goal) -> Verdicts {
        let mut out = Verdicts::default();
        self.witness(goal, Finding::Refuted, Ways::Near, &mut out);
        out
    }

    fn judge_pointwise(&self, goal: &Goal, doubt: bool, out: &mut Verdicts) {
        if goal.conclusion == Conclusion::Contradiction {
            for ways in [Ways::Near, Ways::Far] {
                let proved = self
                    .closed(goal, Finding::Proved, ways, out)
                    .is_some_and(|grounds| self.decide(goal, Finding::Proved, grounds, out));
                if proved || self.witness(goal, Finding::Refuted, ways, out) {
                    return;
                }
            }
            return;
        }
        if doubt && self.consistent(goal, out) {
            return;
        }
        if let Conclusion::NotImplied(_) = goal.conclusion {
            if self.witness(goal, Finding::Proved, Ways::Near, out) {
                return;
            }
            if !speaks_of_limits(&goal.conclusion)
                && let Some(grounds) = self.closed(goal, Finding::Refuted, Ways::Near, out)
                && self.decide(goal, Finding::Refuted, grounds, out)
            {
                return;
            }
            self.witness(goal, Finding::Proved, Ways::Far, out);
            return;
        }
        let counter = self.counterexample(goal, out);
        if counter.is_none() && (self.briefly(goal, out) || self.proves(goal, Ways::Near, out)) {
            return;
        }
        let near = self.witness(goal, Finding::IllDefined, Ways::Near, out)
            || self.witness(goal, Finding::Refuted, Ways::Near, out);
        if near {
            return;
        }
        if let Some(decided) = counter {
            (out.decided, out.open) = (Some(decided), None);
            return;
        }
        let far = self.witness(goal, Finding::IllDefined, Ways::Far, out)
            || self.witness(goal, Finding::Refuted, Ways::Far, out);
        if !far && let Some(grounds) = self.closed(goal, Finding::Proved, Ways::Far, out) {
            self.decide(goal, Finding::Proved, grounds, out);
        }
    }

    /// Decides a pointwise goal by what takes little work: a proof, one without the hypotheses, a point at which all givens
    /// hold.
    fn briefly(&self, goal: &Goal, out: &mut Verdicts) -> bool {
        let refuted = |finding, out: &mut Verdicts| {
            self.witness_from(self.resting, goal, finding, Ways::Brief, out)
        };
        self.proves(goal, Ways::Brief, out)
            || !goal.hypotheses.is_empty() && self.proves(goal, Ways::Alone, out)
            || refuted(Finding::IllDefined, out)
            || refuted(Finding::Refuted, out)
    }

    fn judge_limit(&self, goal: &Goal, limit: &Limit, doubt: bool, out: &mut Verdicts) {
        if doubt && self.consistent(goal, out) {
            return;
        }
        let steps = self.budget.steps;
        let proves = |argument: Option<_>, out: &mut Verdicts| {
            let grounds = argument.map(Grounds::Limit);
            grounds.is_some_and(|grounds| self.decide(goal, Finding::Proved, grounds, out))
        };
        // what is refuted by simple functions does not wait for its cases
        let decided = proves(limits::prove(goal, limit, steps, self.fuel()), out)
            || self.witness(goal, Finding::Refuted, Ways::Near, out)
            || proves(limits::prove_by_cases(goal, limit, steps, &|| self.fuel()), out);
        if !decided {
            out.unreached = self.unreached(goal, limit);
            if self.work.left() > 0 {
                out.open = undefined::undefined(goal, limit).or(out.open.take());
            }
        }
    }

    /// A side of a limit claim, and a given on which it rests that was not shown to hold near it.
    fn unreached(&self, goal: &Goal, limit: &Limit) -> Option<(Side, Sentence)> {
        let scope = scope(goal, self.fuel()).ok()?;
        let state = constants(&scope, goal, limit.var).ok()?;
        sides(&scope, limit).into_iter().find_map(|side| {
            let given = Germs::new(&state, &side, self.budget.steps).unreached()?.clone();
            Some((side, given))
        })
    }
}

/// Grounds written out in the rules of the kernel.
fn evidence(
    goal: &Goal,
    finding: Finding,
    grounds: &Grounds,
    fuel: &Fuel,
) -> Result<Evidence, Flaw> {
    Ok(match (grounds, &goal.conclusion) {
        (Grounds::Model(model), _) => Evidence::Model(model.clone()),
        (Grounds::Contradiction(course), _) => {
            let scope = scope(goal, fuel.clone())?;
            let state = claim_state(&scope, goal, finding)?;
            Evidence::Contradiction(contradiction(&state, course)?)
        }
        (Grounds::Limit(argument), Conclusion::Link(Link::Limit(l))) => {
            let scope = scope(goal, fuel.clone())?;
            limit_proof(&constants(&scope, goal, l.var)?, l, argument)?
        }
        (Grounds::Limit(_), _) => return Err(Rejection::WrongEvidence.into()),
    })
}

/// Symbols that the claim itself writes, those of its conditions above those of its conclusion.
fn kept(goal: &Goal) -> Vec<(usize, u32)> {
    let mut out: Vec<(usize, u32)> = Vec::new();
    let mut add = |e: &Expr, weight: u32| {
        let mut todo = vec![e];
        while let Some(e) = todo.pop() {
            if let Expr::Var(v) = e {
                match out.iter_mut().find(|k| k.0 == *v) {
                    Some(k) => k.1 = k.1.max(weight),
                    None => out.push((*v, weight)),
                }
            }
            todo.extend(e.children());
        }
    };
    for r in &goal.when {
        add(&r.lhs, 2);
        add(&r.rhs, 2);
    }
    if let Conclusion::Link(Link::Relation(r)) = &goal.conclusion {
        add(&r.lhs, 1);
        add(&r.rhs, 1);
    }
    out
}

fn speaks_of_limits(conclusion: &Conclusion) -> bool {
    let links: &[Link] = match conclusion {
        Conclusion::Link(l) => std::slice::from_ref(l),
        Conclusion::NotImplied(s) => &s.links,
        Conclusion::Contradiction => &[],
    };
    links.iter().any(|l| matches!(l, Link::Limit(_)))
}
