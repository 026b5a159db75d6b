//! The leaf of a search: no equation can be solved any more, and each method has its turn, the cheap
//! ones first.

use kane_kernel::{Atom, Point, Poly, Sign, State, exponent};

use super::cofactor::cofactor;
use super::differences::differences;
use super::discriminant::discriminant;
use super::elimination::{Elimination, open_vars};
use super::factors::{common_factor, positive_factor};
use super::hints::{Hint, Wealth, hinted, untold};
use super::idle::without_idle;
use super::isolated::{isolated, isolated_weakly};
use super::linear::{combination, is_linear_in_all, solution};
use super::rule::Rule;
use super::search::{BRIEFLY, MAX_SPLITS, Outcome, Search, since};
use super::squares::{Reach, squares};
use super::{
    cases, colon, comparison, conjugates, expansion, ideal, line, means, pairs, products, tactics,
    written,
};
use crate::argument::Argument;
use crate::open::Method;

/// Case distinctions for which an inequality that is taken as an equation counts.
const BOUNDARY: u32 = 5;
/// Points from which others are approached.
const STARTS: usize = 4;
/// Places of symbols at which roots are looked at.
const PLACES: usize = 60;
/// Case distinctions for which one by elimination counts.
const CASE: u32 = 2;
/// What it costs, of the budget for squares or for cells, to tell a case.
const ORDER: u64 = 1_000_000;
/// Of the budget for squares, what cuts by successive differences may take at one leaf.
const DIFFERENCES: u64 = 10_000_000;

impl Search<'_> {
    pub(super) fn leaf(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
        splits: u32,
    ) -> Outcome {
        if self.proofs
            && !self.models
            && let Some(state) = without_idle(state)
        {
            return self.leaf(&state, trail, splits);
        }
        let vars = open_vars(state);
        self.note(Method::SignTables);
        for &v in &vars {
            if let Some(proof) = line::sign_table(state, v) {
                return Outcome::Closed(proof);
            }
        }
        if self.proofs && !self.hints.is_empty() {
            self.note(Method::Hints);
            let hints = self.hints_after(state, trail);
            if let Some(proof) = hinted(state, &hints, Wealth::Many) {
                return Outcome::Closed(proof);
            }
            if splits < MAX_SPLITS
                && let Some(poly) = untold(state, &hints)
            {
                return self.split(state, poly, trail, splits + 1);
            }
        }
        if self.proofs
            && let Some(proof) =
                tactics::division_by_premise(state).or_else(|| expansion::expansion(state))
        {
            return Outcome::Closed(proof);
        }
        // of each three signs one is left, so that these are no case distinctions
        if self.proofs
            && vars.len() > 1
            && let Some(equation) = colon::divided(state)
        {
            return self.by_settled(state, equation, trail, splits);
        }
        if self.proofs
            && vars.len() > 1
            && let Some(factor) = positive_factor(state, &|_| true)
        {
            return self.split(state, factor, trail, splits);
        }
        if self.proofs
            && !self.models
            && splits < MAX_SPLITS
            && let Some(factor) = common_factor(state)
        {
            return self.split(state, factor, trail, splits + 1);
        }
        if self.models
            && let Some(point) = self.point(state, trail, &vars, splits)
        {
            return Outcome::Model(point);
        }
        if vars.len() > 1 && self.proofs {
            // A quick look for a point saves the long search for a proof that there is none.
            if !self.models
                && (self.sample(state, trail, &vars, (2, 12)).is_some()
                    || self.by_approach(state, trail, &vars, 1).is_some())
            {
                return Outcome::Open;
            }
            let squares = |reach| {
                self.note(Method::Squares);
                squares(state, reach, &self.squares)
            };
            let products = |degree| {
                self.note(Method::Products);
                products::products(state, degree)
            };
            let ideal = || {
                let tried = self.ideals.then(|| self.note(Method::Ideals));
                tried.and_then(|()| ideal::ideal(state))
            };
            let differences = || {
                self.note(Method::Differences);
                differences(state, &self.squares.within(DIFFERENCES))
            };
            let boxes = || {
                let tried = self.cuts.then(|| self.note(Method::Boxes));
                tried.and_then(|()| self.boxes(state, &vars, MAX_SPLITS.saturating_sub(splits)))
            };
            self.note(Method::Combinations);
            let combined = combination(state);
            // Of linear conditions the simplex method has said all.
            if combined.is_none() && solution(&state.atoms, &vars, &state.scope.fuel).is_some() {
                self.leave(&state.atoms);
                return Outcome::Open;
            }
            if !self.products {
                return combined.map_or(Outcome::Open, Outcome::Closed);
            }
            if combined.is_none() && self.far && self.cells.spend(ORDER).is_ok() {
                self.note(Method::Cases);
                if let Some(proof) = cases::closed(state, &vars, &self.cells) {
                    return Outcome::Closed(proof);
                }
                if splits + CASE <= MAX_SPLITS
                    && let Some(poly) = cases::telling(state, &vars, &self.cells)
                {
                    return self.split(state, poly, trail, splits + CASE);
                }
            }
            if combined.is_none() && splits < MAX_SPLITS {
                let rules = Rule::all(state);
                let settled = cofactor(state, &rules).or_else(|| isolated(state, &rules));
                if let Some(settled) = settled {
                    if let Some(left) = self.closed_alone(state, &settled, splits) {
                        return Outcome::Closed(settled.split(left));
                    }
                    return self.by_settled(state, settled, trail, splits + 1);
                }
                if let Some(found) = discriminant(state) {
                    return self.by_not_negative(state, found, trail, splits + 1);
                }
                if let Some(found) = isolated_weakly(state, &rules) {
                    return self.by_squares(state, found, trail, splits + 1);
                }
                let telling = || {
                    self.squares.spend(ORDER).ok()?;
                    comparison::telling(state, &rules).or_else(|| conjugates::telling(state))
                };
                if let Some(poly) = telling() {
                    return self.split(state, poly, trail, splits + 1);
                }
                if let Some(settled) = self.lead_by_itself(state, splits) {
                    return self.by_settled(state, settled, trail, splits + 1);
                }
            }
            let proof = combined
                .or_else(|| conjugates::closed(state))
                .or_else(differences)
                .or_else(|| products(1))
                .or_else(|| pairs::pairs(state, &vars))
                .or_else(|| squares(Reach::Atoms))
                .or_else(|| means::means(state))
                .or_else(|| squares(Reach::Pairs))
                .or_else(|| squares(Reach::Signed))
                .or_else(|| means::multiplied(state))
                .or_else(|| products(2))
                .or_else(|| pairs::by_sign(state, &vars))
                .or_else(ideal)
                .or_else(|| squares(Reach::Higher))
                .or_else(boxes)
                .or_else(|| products(3));
            if let Some(proof) = proof {
                return Outcome::Closed(proof);
            }
            if splits < MAX_SPLITS
                && self.squares.spend(ORDER).is_ok()
                && let Some(difference) = alike(state, &vars)
            {
                return self.split(state, difference, trail, splits + 1);
            }
        }
        if self.proofs {
            self.leave(&state.atoms);
        }
        Outcome::Open
    }

    /// A point of a state: a simple one, by linear arithmetic, of each component, by approach or by cells.
    pub(super) fn point(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
        vars: &[usize],
        splits: u32,
    ) -> Option<Point> {
        self.note(Method::Points);
        // Where all is linear a simple point is nicer, and the simplex method is sure.
        let linear = is_linear_in_all(state);
        let tries = if linear || self.brief { (2, 12) } else { (5, 200) };
        let near = self
            .at_places(state, trail, vars, if self.brief { BRIEFLY } else { PLACES })
            .or_else(|| self.between_bounds(state, trail, vars, (2, 12)))
            .or_else(|| self.sample(state, trail, vars, tries))
            .or_else(|| self.linear_point(state, trail, vars));
        if self.brief {
            return near;
        }
        let near = near.or_else(|| self.by_components(state, trail, vars, splits));
        if near.is_some() || linear {
            return near;
        }
        if self.far {
            self.note(Method::Cells);
            return self.by_cells(state, trail, vars);
        }
        self.by_approach(state, trail, vars, STARTS)
            .or_else(|| self.on_boundary(state, trail, splits))
    }

    /// A proof by the hints as they stand, before cases are told.
    pub(super) fn by_hints(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
    ) -> Option<Argument> {
        if self.hints.is_empty() || !self.proofs {
            return None;
        }
        self.note(Method::Hints);
        hinted(state, &self.hints_after(state, trail), Wealth::Few)
    }

    /// A proof by the summands of the goal as they are written.
    pub(super) fn as_written(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
    ) -> Option<Argument> {
        if !self.as_written || !self.proofs {
            return None;
        }
        let all = || Hint::all(state.scope, &written::summands(state.goal));
        let after = |hint: &Hint| hint.after(trail, &state.scope.fuel);
        let written: Vec<Hint> = self.written.get_or_init(all).iter().filter_map(after).collect();
        if written.is_empty() { None } else { written::closed(state, &written) }
    }

    fn hints_after(&self, state: &State<'_, '_>, trail: &[Elimination]) -> Vec<Hint> {
        self.hints.iter().filter_map(|hint| hint.after(trail, &state.scope.fuel)).collect()
    }

    /// A point on the boundary of the state, or where its boundaries meet: one weak inequality after
    /// the other taken as an equation.
    fn on_boundary(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
        splits: u32,
    ) -> Option<Point> {
        if splits + BOUNDARY > MAX_SPLITS {
            return None;
        }
        let weak = |i: &usize| {
            let a = &state.atoms[*i];
            a.sign == Sign::NonNegative && a.decided().is_none()
        };
        let fresh = state.atoms.len();
        (0..fresh).filter(weak).find_map(|i| {
            let poly = &state.atoms[i].poly;
            let zero = |p: Poly| Atom::new(p, Sign::Zero);
            let origin = vanishing(poly).into_iter().map(|v| zero(Poly::var(v))).collect();
            let on = |equations: Vec<Atom>| {
                if equations.is_empty() || equations.iter().all(|e| state.atoms.contains(e)) {
                    return None;
                }
                let next = equations.into_iter().fold(state.clone(), |state, e| state.with(e));
                match self.run(&next, &since(&next, fresh), Vec::new(), trail, splits + BOUNDARY) {
                    Outcome::Model(point) => Some(point),
                    _ => None,
                }
            };
            on(origin).or_else(|| on(vec![zero(poly.clone())]))
        })
    }
}

/// Few variables without which nothing is left of a polynomial: where they vanish, so does it. None if it has a constant.
fn vanishing(p: &Poly) -> Vec<usize> {
    let (mut left, mut out) = (p.clone(), Vec::new());
    while !left.is_constant() {
        let terms = |v: &usize| left.terms().filter(|(m, _)| exponent(m, *v) > 0).count();
        let Some(v) = left.vars().into_iter().max_by_key(terms) else { break };
        left = left.coefficient(v, 0);
        out.push(v);
    }
    if left.is_empty() { out } else { Vec::new() }
}

/// The difference of two variables that a state treats alike, if their order is not known.
fn alike(state: &State<'_, '_>, vars: &[usize]) -> Option<Poly> {
    let known = |d: &Poly| {
        let same = |p: &Poly| *p == *d || *p == d.neg();
        state.atoms.iter().any(|a| same(&a.poly.primitive().1))
    };
    let pairs = vars.iter().enumerate().flat_map(|(n, v)| vars[..n].iter().map(move |w| (*w, *v)));
    pairs
        .filter(|&(v, w)| {
            let swapped = |a: &Atom| Atom::new(exchanged(&a.poly, v, w), a.sign);
            // What is about one pair of variables orders them, and says nothing about the others.
            let mut long = state.atoms.iter().filter(|a| a.poly.vars().len() > 2);
            long.clone().next().is_some() && long.all(|a| state.atoms.contains(&swapped(a)))
        })
        .map(|(v, w)| Poly::var(v).sub(&Poly::var(w)))
        .find(|d| !known(d))
}

/// A polynomial with two variables in each other's place.
fn exchanged(p: &Poly, v: usize, w: usize) -> Poly {
    Poly::sum(p.terms().map(|(m, c)| {
        let name = |x: usize| {
            if x == v {
                w
            } else if x == w {
                v
            } else {
                x
            }
        };
        let mut m: Vec<(usize, u32)> = m.iter().map(|&(x, n)| (name(x), n)).collect();
        m.sort_unstable();
        (m, c.clone())
    }))
}
