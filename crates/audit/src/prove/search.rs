//! The search: assume what is given, solve equations, look at what is left.

use std::cell::{Cell, OnceCell, RefCell};

use kane_kernel::{Atom, Conclusion, Fuel, Link, Point, Poly, Rel, Sign, State};

use super::attempt::Attempt;
use super::bound::bound;
use super::elimination::{Elimination, open_vars};
use super::factors::{content_to_split, pinched, positive_factor, squared_factor};
use super::hints::Hint;
use super::radicand;
use super::tactics;
use crate::argument::Argument;
use crate::open::Method;

/// How a search ends.
#[derive(Clone, Debug)]
pub(crate) enum Outcome {
    /// no point satisfies the state
    Closed(Argument),
    /// this point does
    Model(Point),
    /// neither was found
    Open,
}

/// A bounded search. Budgets count steps, so the outcome does not depend on the machine.
pub(crate) struct Search<'a> {
    steps: Cell<u64>,
    /// whether a variable may be eliminated by an equation
    pub(crate) may_eliminate: &'a dyn Fn(usize, &Poly) -> bool,
    /// steps taken on the way to the present state
    depth: Cell<u32>,
    /// whether points are looked for
    pub(crate) models: bool,
    /// whether proofs are looked for where they take long
    pub(crate) proofs: bool,
    /// terms of a polynomial beyond which a branch is left open
    pub(crate) widest: usize,
    /// variables better kept, with a weight: those that the claim is about
    pub(crate) keep: Vec<(usize, u32)>,
    /// symbols that premises define: they are replaced first, in this order
    pub(crate) defined: Vec<usize>,
    /// whether ideals may be computed
    pub(crate) ideals: bool,
    /// whether products of premises and boxes may be tried
    pub(crate) products: bool,
    /// whether ranges may be cut into boxes
    pub(crate) cuts: bool,
    /// for sums of squares
    pub(crate) squares: Fuel,
    /// for points by approach, cells and elimination by cases
    pub(crate) cells: Fuel,
    /// whether cells and elimination by cases are tried, which take long
    pub(crate) far: bool,
    /// whether points are looked for among simple ones only
    pub(crate) brief: bool,
    /// what the author says to use
    pub(crate) hints: Vec<Hint>,
    /// whether summands are looked at as they are written
    pub(crate) as_written: bool,
    /// whether sides with several roots are squared before anything is solved for along a germ, too
    pub(crate) squares_first: bool,
    /// whether tangent planes are set against roots and quotients
    pub(crate) tangents: bool,
    /// the summands of the goal, once they are looked at
    pub(super) written: OnceCell<Vec<Hint>>,
    /// what was tried, and the smallest conditions on which all of it failed
    pub(crate) attempt: RefCell<Attempt>,
}

/// What a look at a state costs, in coefficient operations: what it does there is not all counted.
const STEP: u64 = 5_000;
/// Steps along one branch: a proof is checked recursively, and so has to fit on the stack.
const MAX_DEPTH: u32 = 160;
/// Places of symbols at which roots are looked at where it is to be brief.
pub(super) const BRIEFLY: usize = 12;
/// Case distinctions after which summands are no longer looked at as they are written.
const WRITTEN: u32 = 1;
/// Case distinctions on the sign of a polynomial along one branch.
pub(super) const MAX_SPLITS: u32 = 10;

impl<'a> Search<'a> {
    pub(crate) fn new(
        steps: u64,
        may_eliminate: &'a dyn Fn(usize, &Poly) -> bool,
        models: bool,
    ) -> Self {
        Self {
            steps: Cell::new(steps),
            depth: Cell::new(0),
            may_eliminate,
            models,
            proofs: true,
            widest: 2000,
            keep: Vec::new(),
            defined: Vec::new(),
            ideals: false,
            products: true,
            cuts: true,
            squares: Fuel::new(0),
            cells: Fuel::new(0),
            far: false,
            brief: false,
            hints: Vec::new(),
            as_written: false,
            squares_first: false,
            tangents: false,
            written: OnceCell::new(),
            attempt: RefCell::default(),
        }
    }

    pub(crate) fn left(&self) -> u64 {
        self.steps.get()
    }

    /// Notes that something is tried.
    pub(super) fn note(&self, method: Method) {
        self.attempt.borrow_mut().note(method);
    }

    /// Notes that nothing closes these conditions.
    pub(super) fn leave(&self, atoms: &[Atom]) {
        self.attempt.borrow_mut().leave(atoms);
    }

    pub(super) fn spend(&self) -> bool {
        let left = self.steps.get();
        self.steps.set(left.saturating_sub(1));
        left > 0
    }

    /// Takes a step that looks at a state; `false` where no step is left, or no work for one.
    pub(super) fn step(&self, state: &State<'_, '_>) -> bool {
        self.spend() && state.scope.fuel.spend_beyond(STEP).is_ok()
    }

    /// Searches from a state with all its formulas still to be assumed.
    pub(crate) fn solve(&self, state: &State<'_, '_>) -> Outcome {
        self.solve_from(state, 0)
    }

    /// The same without its first formulas, which are never assumed.
    pub(super) fn solve_from(&self, state: &State<'_, '_>, first: usize) -> Outcome {
        let pending = (first..state.formulas.len()).collect();
        self.run(state, &since(state, 0), pending, &[], 0)
    }

    /// Assumes all formulas of which one case survives, and solves what can be solved.
    pub(crate) fn reduced<'s, 'g>(
        &self,
        state: &State<'s, 'g>,
    ) -> Option<(State<'s, 'g>, Vec<Elimination>)> {
        let (mut state, mut trail) = (state.clone(), Vec::new());
        for formula in 0..state.formulas.len() {
            let fresh = state.atoms.len();
            let mut open: Vec<State<'s, 'g>> = state.assume(formula).ok()?;
            open.retain(|s| self.step(s) && tactics::quick_among(s, &since(s, fresh)).is_none());
            if open.len() > 1 {
                // Which case it is may take more than a look.
                let refuted = |s: &State<'s, 'g>| {
                    matches!(
                        self.run(s, &since(s, fresh), Vec::new(), &[], MAX_SPLITS),
                        Outcome::Closed(_)
                    )
                };
                open.retain(|s| !refuted(s));
            }
            // The case that says most: an equation rather than the exception from it.
            let says = |s: &State<'s, 'g>| {
                let equations = s.atoms[fresh..].iter();
                equations.filter(|a| a.sign == Sign::Zero && a.poly.vars().len() > 1).count()
            };
            let best = open.iter().map(says).max()?;
            state = open.into_iter().find(|s| says(s) == best)?;
        }
        while let Some((_, next, elimination)) =
            self.simplify(&state).or_else(|| self.assumed(&state))
        {
            if !self.step(&next) || next.atoms.iter().any(|a| a.decided() == Some(false)) {
                return None;
            }
            trail.extend(elimination);
            state = next;
        }
        Some((state, trail))
    }

    pub(super) fn run(
        &self,
        state: &State<'_, '_>,
        fresh: &[bool],
        pending: Vec<usize>,
        trail: &[Elimination],
        splits: u32,
    ) -> Outcome {
        let wide = state.atoms.iter().any(|a| a.poly.len() > self.widest);
        // without work nothing can be shown to close
        let is_spent = self.proofs && state.scope.fuel.left() == 0;
        if !self.step(state) || is_spent || wide || self.depth.get() > MAX_DEPTH {
            return Outcome::Open;
        }
        self.depth.set(self.depth.get() + 1);
        let outcome = self.run_inner(state, fresh, pending, trail, splits);
        self.depth.set(self.depth.get() - 1);
        outcome
    }

    fn run_inner(
        &self,
        state: &State<'_, '_>,
        fresh: &[bool],
        mut pending: Vec<usize>,
        trail: &[Elimination],
        splits: u32,
    ) -> Outcome {
        if let Some(proof) = tactics::quick_among(state, fresh) {
            let further = self.sides_agree(state, &proof, &pending, trail, splits);
            return Outcome::Closed(further.unwrap_or(proof));
        }
        if !pending.is_empty() {
            let size = |f: &usize| state.formulas[*f].len();
            let at = (0..pending.len()).min_by_key(|&i| size(&pending[i])).unwrap_or(0);
            let formula = pending.remove(at);
            let Ok(states) = state.assume(formula) else {
                return Outcome::Open;
            };
            let fresh = state.atoms.len();
            let next =
                |s: &State<'_, '_>| self.run(s, &since(s, fresh), pending.clone(), trail, splits);
            return all(states.iter().map(next), |cases| Argument::Assume { formula, cases });
        }
        // before a symbol is solved for by what stands under a root
        if self.models
            && splits == 0
            && trail.is_empty()
            && let Some(point) = self
                .at_places(state, trail, &open_vars(state), BRIEFLY)
                .or_else(|| self.in_valleys(state))
        {
            return Outcome::Model(point);
        }
        // the two sides of a difference are told apart where nothing else helped
        if self.far
            && self.proofs
            && splits == 0
            && trail.is_empty()
            && let Some(difference) = denied(state)
        {
            return self.split(state, difference, trail, 1);
        }
        // before anything is multiplied out
        if splits == 0
            && trail.is_empty()
            && let Some(proof) = self
                .by_lemmas_of_hints(state)
                .or_else(|| self.by_tangents(state))
                .or_else(|| self.by_homogeneous(state))
        {
            return Outcome::Closed(proof);
        }
        // before a square is replaced that bounds what it is of
        if self.proofs
            && splits < MAX_SPLITS
            && let Some(found) = bound(state)
        {
            return self.by_not_negative(state, found, trail, splits);
        }
        // before equations between roots are solved for some of them
        if let Some(outcome) = self.by_roots(state, trail) {
            return outcome;
        }
        // before a root that is a product of others is solved for
        if self.proofs
            && let Some(equation) = radicand::equal_roots(state)
        {
            return self.by_settled(state, equation, trail, splits);
        }
        // before the square of a root is replaced, and nothing is left of the factor
        if self.proofs
            && splits < MAX_SPLITS
            && let Some(factor) = positive_factor(state, &|p| has_root(state, p))
        {
            return self.split(state, factor, trail, splits);
        }
        // before what stands under a root is no longer written in symbols
        let is_number = |e: &Elimination| e.d.is_constant() && e.e.is_constant();
        if trail.iter().all(is_number)
            && let Some(outcome) = self.by_squaring(state, splits)
        {
            return outcome;
        }
        if let Some((step, next, elimination)) = self.simplify(state) {
            let mut trail = trail.to_vec();
            trail.extend(elimination);
            return match self.run(&next, &changed(state, &next), pending, &trail, splits) {
                Outcome::Closed(proof) => Outcome::Closed(step.wrap(proof)),
                other => other,
            };
        }
        if let Some(proof) = self.by_hints(state, trail) {
            return Outcome::Closed(proof);
        }
        if splits <= WRITTEN
            && let Some(proof) = self.as_written(state, trail)
        {
            return Outcome::Closed(proof);
        }
        if splits < MAX_SPLITS {
            let poly = self
                .lead_to_split(state)
                .or_else(|| pinched(state))
                .or_else(|| content_to_split(state))
                .or_else(|| squared_factor(state));
            if let Some(poly) = poly {
                return self.split(state, poly, trail, splits + 1);
            }
        }
        self.leaf(state, trail, splits)
    }

    /// Where a proof is to be read and a sum would close the state, the proof by further replacements instead, if
    /// they end with two sides that are the same.
    fn sides_agree(
        &self,
        state: &State<'_, '_>,
        sum: &Argument,
        pending: &[usize],
        trail: &[Elimination],
        splits: u32,
    ) -> Option<Argument> {
        if self.defined.is_empty() || !matches!(sum, Argument::Positive { .. }) {
            return None;
        }
        let (step, next, elimination) = self.simplify(state)?;
        let trail: Vec<Elimination> = trail.iter().cloned().chain(elimination).collect();
        let fresh = changed(state, &next);
        match self.run(&next, &fresh, pending.to_vec(), &trail, splits) {
            Outcome::Closed(proof) if ends_absurd(&proof) => Some(step.wrap(proof)),
            _ => None,
        }
    }

    /// One branch a sign of a polynomial.
    pub(super) fn split(
        &self,
        state: &State<'_, '_>,
        poly: Poly,
        trail: &[Elimination],
        splits: u32,
    ) -> Outcome {
        let fresh = state.atoms.len();
        let branch = |sign, p: &Poly| {
            let next = state.with(Atom::new(p.clone(), sign));
            self.run(&next, &since(&next, fresh), Vec::new(), trail, splits)
        };
        let signs = [
            (Sign::Positive, poly.clone()),
            (Sign::Zero, poly.clone()),
            (Sign::Positive, poly.neg()),
        ];
        all(signs.iter().map(|(s, p)| branch(*s, p)), |proofs| {
            let mut proofs = proofs.into_iter().map(Box::new);
            // One argument a branch; what is missing would be no argument.
            let mut next =
                || proofs.next().unwrap_or_else(|| Box::new(Argument::Absurd(usize::MAX)));
            let (positive, zero, negative) = (next(), next(), next());
            Argument::Split { poly, zero, positive, negative }
        })
    }
}

/// The difference that is not zero where a claimed equation fails.
fn denied(state: &State<'_, '_>) -> Option<Poly> {
    let Conclusion::Link(Link::Relation(relation)) = &state.goal.conclusion else { return None };
    let open = |a: &&Atom| a.sign == Sign::NonZero && a.decided().is_none();
    let last = state.atoms.iter().rfind(open)?;
    (relation.rel == Rel::Eq).then(|| last.poly.primitive().1)
}

/// Whether a root stands in a polynomial.
pub(super) fn has_root(state: &State<'_, '_>, p: &Poly) -> bool {
    p.vars().into_iter().any(|v| state.scope.root(v).is_some())
}

/// Whether an argument of one branch ends with a false constant.
fn ends_absurd(argument: &Argument) -> bool {
    match argument {
        Argument::Absurd(_) => true,
        Argument::Substitute { then, .. } | Argument::Cancel { then, .. } => ends_absurd(then),
        _ => false,
    }
}

/// Marks the atoms from an index on.
pub(super) fn since(state: &State<'_, '_>, from: usize) -> Vec<bool> {
    (0..state.atoms.len()).map(|i| i >= from).collect()
}

/// Marks the atoms that a step changed.
fn changed(before: &State<'_, '_>, after: &State<'_, '_>) -> Vec<bool> {
    let same = |(i, a): (usize, &Atom)| before.atoms.get(i) == Some(a);
    after.atoms.iter().enumerate().map(|x| !same(x)).collect()
}

/// Closed if all are closed; the first model otherwise.
fn all(
    outcomes: impl Iterator<Item = Outcome>,
    wrap: impl FnOnce(Vec<Argument>) -> Argument,
) -> Outcome {
    let (mut proofs, mut open) = (Vec::new(), false);
    for outcome in outcomes {
        match outcome {
            Outcome::Closed(proof) => proofs.push(proof),
            Outcome::Model(point) => return Outcome::Model(point),
            Outcome::Open => open = true,
        }
    }
    if open { Outcome::Open } else { Outcome::Closed(wrap(proofs)) }
}
