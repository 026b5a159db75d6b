//! Linear arithmetic, complete: a combination of the conditions that is a contradiction (Farkas 1902),
//! or a point. Both come from the same simplex method over the rationals. A condition ≠ needs no
//! cases but its own two: a convex set that lies in the union of some planes lies in one of them.

use std::collections::BTreeMap;

use kane_algebra::linear_program::{Entering, feasible, whole};
use kane_algebra::point::{Partial, specialised};
use kane_kernel::{Atom, Fuel, Point, Poly, Power, Sign, State, Term};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::diagonal::diagonal;
use super::elimination::Elimination;
use super::sample::{candidates, complete};
use super::search::Search;
use super::tactics;
use crate::argument::{Argument, Rules};

type Q = BigRational;

/// Monomials, conditions and terms of a condition beyond which no combination is looked for.
const ROWS: usize = 300;
/// Conditions.
const CONDITIONS: usize = 120;
/// Terms of a condition.
const TERMS: usize = 200;
/// Pivots of a linear program.
const PIVOTS: usize = 600;
/// Conditions ≠ whose cases are told.
const DISTINCT: usize = 6;
/// Variables that take simple values so that the others are linear, and how many values.
const FIXED: (usize, usize) = (3, 40);

/// A combination of the atoms, their monomials taken as variables, that is a contradiction.
pub(crate) fn combination(state: &State<'_, '_>) -> Option<Argument> {
    if let Some(proof) = weighted(state) {
        return Some(proof);
    }
    let distinct = state.atoms.iter().filter(|a| a.sign == Sign::NonZero && a.decided().is_none());
    // Only a plane through what the other conditions leave can make the difference.
    distinct.filter(|a| is_linear(&a.poly)).take(DISTINCT).find_map(|a| {
        let case = |sign, poly: &Poly| state.with(Atom::new(poly.clone(), sign));
        let positive = weighted(&case(Sign::Positive, &a.poly))?;
        let negative = weighted(&case(Sign::Positive, &a.poly.neg()))?;
        let zero = tactics::quick(&case(Sign::Zero, &a.poly))?;
        let [zero, positive, negative] = [zero, positive, negative].map(Box::new);
        Some(Argument::Split { poly: a.poly.clone(), zero, positive, negative })
    })
}

/// Non-negative multiples of atoms and multiples of equations that sum to a negative number, or to zero
/// with one of them strict.
fn weighted(state: &State<'_, '_>) -> Option<Argument> {
    let live = |i: &usize| {
        let a = &state.atoms[*i];
        a.decided().is_none() && a.poly.len() <= TERMS
    };
    let all = || (0..state.atoms.len()).filter(live);
    let known: Vec<usize> = all().filter(|&i| state.atoms[i].sign.is_order()).collect();
    let equations: Vec<usize> = all().filter(|&i| state.atoms[i].sign == Sign::Zero).collect();
    // The constant is a row of its own, since 1 is positive.
    let mut rows: BTreeMap<&[Power], usize> = BTreeMap::from([(&[][..], 0)]);
    for i in known.iter().chain(&equations) {
        for (m, _) in state.atoms[*i].poly.terms() {
            let next = rows.len();
            rows.entry(m).or_insert(next);
        }
    }
    let height = rows.len();
    if height > ROWS || known.len() + equations.len() > CONDITIONS {
        return None;
    }
    let column = |i: usize, sign: i64| -> Vec<(usize, Q)> {
        let entries = state.atoms[i].poly.terms();
        entries.map(|(m, c)| (rows[m], Q::from_integer(c * sign))).collect()
    };
    let mut matrix: Vec<Vec<(usize, Q)>> = Vec::new();
    for &i in &known {
        let mut entries = column(i, 1);
        if state.atoms[i].sign == Sign::Positive {
            entries.push((height, Q::one()));
        }
        matrix.push(entries);
    }
    for &i in &equations {
        matrix.extend([column(i, 1), column(i, -1)]);
    }
    matrix.push(vec![(0, Q::one()), (height, Q::one())]);
    let mut b = vec![Q::zero(); height];
    b.push(Q::one());
    let weights = whole(&feasible(&matrix, &b, Entering::First, PIVOTS, &state.scope.fuel)?);
    let term = |weight: &num_bigint::BigInt, factors| Term {
        weight: weight.clone(),
        square: Poly::one(),
        factors,
    };
    let used = known.iter().zip(&weights).filter(|(_, w)| w.is_positive());
    let mut terms: Vec<Term> = used.map(|(i, w)| term(w, vec![(*i, 1)])).collect();
    terms.extend(weights.last().filter(|w| w.is_positive()).map(|w| term(w, Vec::new())));
    let cofactors = equations
        .iter()
        .zip(weights[known.len()..].chunks(2))
        .map(|(i, w)| (*i, Poly::constant(&w[0] - &w[1])))
        .filter(|(_, p)| !p.is_empty())
        .collect();
    let proof = Argument::Positive { terms, cofactors };
    state.closes(&proof).is_ok().then_some(proof)
}

/// Whether a polynomial has degree one at most.
fn is_linear(p: &Poly) -> bool {
    p.terms().all(|(m, _)| m.iter().map(|x| x.1).sum::<u32>() <= 1)
}

/// Whether all conditions are linear.
pub(super) fn is_linear_in_all(state: &State<'_, '_>) -> bool {
    state.atoms.iter().all(|a| is_linear(&a.poly))
}

/// Values at which linear conditions hold; `None` if there are none, or if they take too long.
pub(super) fn solution(atoms: &[Atom], vars: &[usize], fuel: &Fuel) -> Option<Vec<(usize, Q)>> {
    if atoms.iter().any(|a| a.decided() == Some(false) || !is_linear(&a.poly)) {
        return None;
    }
    let order: Vec<Atom> = atoms.iter().filter(|a| a.sign != Sign::NonZero).cloned().collect();
    let distinct: Vec<&Poly> =
        atoms.iter().filter(|a| a.sign == Sign::NonZero).map(|a| &a.poly).collect();
    let mut points = vec![vertex(&order, vars, fuel)?];
    let holds = |p: &Poly, point: &[(usize, Q)]| {
        specialised(p, point).as_constant().is_some_and(|c| !c.is_zero())
    };
    for p in &distinct {
        if !points.iter().any(|point| holds(p, point)) {
            let case = |p: Poly| {
                let more = [&order[..], &[Atom::new(p, Sign::Positive)]].concat();
                vertex(&more, vars, fuel)
            };
            points.push(case((*p).clone()).or_else(|| case(p.neg()))?);
        }
    }
    // Each lies off some of the planes, and almost all points between them lie off all of them.
    (0..40usize).find_map(|n| {
        let weight = |k: usize| Q::from_integer((1 + (n * (k + n)) % 11).into());
        let total = (0..points.len()).map(weight).fold(Q::zero(), |a, b| a + b);
        let middle = |at: usize| {
            let sum = points.iter().enumerate().map(|(k, point)| &point[at].1 * weight(k));
            sum.fold(Q::zero(), |a, b| a + b) / &total
        };
        let point: Vec<(usize, Q)> =
            vars.iter().enumerate().map(|(at, &v)| (v, middle(at))).collect();
        distinct.iter().all(|p| holds(p, &point)).then_some(point)
    })
}

/// The term without variables.
fn constant_of(p: &Poly) -> Q {
    let constant = p.terms().find(|(m, _)| m.is_empty());
    constant.map_or_else(Q::zero, |(_, c)| Q::from_integer(c.clone()))
}

/// Values at which linear equations and inequalities hold. With x = X/τ and τ ≥ 1 a strict condition
/// p(x) > 0 is τ·p ≥ 1, for p is as small there as its τ is large.
fn vertex(atoms: &[Atom], vars: &[usize], fuel: &Fuel) -> Option<Vec<(usize, Q)>> {
    // Columns: X as the difference of two, τ − 1, and one slack an inequality.
    let tau = 2 * vars.len();
    let mut columns: Vec<Vec<(usize, Q)>> = vec![Vec::new(); tau + 1];
    let mut b = Vec::new();
    for a in atoms.iter().filter(|a| a.decided().is_none()) {
        let row = b.len();
        let constant = constant_of(&a.poly);
        for (at, &v) in vars.iter().enumerate() {
            let c = Q::from_integer(a.poly.coefficient(v, 1).as_constant()?);
            if !c.is_zero() {
                columns[2 * at].push((row, c.clone()));
                columns[2 * at + 1].push((row, -c));
            }
        }
        if !constant.is_zero() {
            columns[tau].push((row, constant.clone()));
        }
        let least = if a.sign == Sign::Positive { Q::one() } else { Q::zero() };
        b.push(least - constant);
        if a.sign.is_order() {
            columns.push(vec![(row, -Q::one())]);
        }
    }
    let found = feasible(&columns, &b, Entering::First, PIVOTS, fuel)?;
    let scale = &found[tau] + Q::one();
    let value = |at: usize| (&found[2 * at] - &found[2 * at + 1]) / &scale;
    Some(vars.iter().enumerate().map(|(at, &v)| (v, value(at))).collect())
}

impl Search<'_> {
    /// A point by linear arithmetic; some variables take simple values if the others are linear then.
    pub(super) fn linear_point(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
        vars: &[usize],
    ) -> Option<Point> {
        let fixed = bent(state, vars);
        if fixed.len() > FIXED.0 || fixed.len() == vars.len() {
            return None;
        }
        let free: Vec<usize> = vars.iter().copied().filter(|v| !fixed.contains(v)).collect();
        let lists: Vec<Vec<Q>> = fixed.iter().map(|&v| candidates(state, v)).collect();
        diagonal(&lists, FIXED.1).find_map(|values| {
            if !self.step(state) {
                return None;
            }
            let values: Vec<(usize, Q)> = fixed.iter().copied().zip(values).collect();
            let at = |a: &Atom| Atom::new(specialised(&a.poly, &values), a.sign);
            let atoms: Vec<Atom> = state.atoms.iter().map(at).collect();
            let found = solution(&atoms, &free, &state.scope.fuel)?;
            let mut partial = Partial::default();
            values.into_iter().chain(found).for_each(|(v, q)| partial.set(v, q));
            complete(state, partial, trail)
        })
    }
}

/// Variables without which all conditions are linear, as few as are easily found.
fn bent(state: &State<'_, '_>, vars: &[usize]) -> Vec<usize> {
    let mut fixed: Vec<usize> = Vec::new();
    loop {
        let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
        for (m, _) in state.atoms.iter().flat_map(|a| a.poly.terms()) {
            let left = || m.iter().filter(|x| !fixed.contains(&x.0));
            if left().map(|x| x.1).sum::<u32>() > 1 {
                left().for_each(|x| *counts.entry(x.0).or_default() += x.1 as usize);
            }
        }
        let Some((&v, _)) = counts.iter().max_by_key(|(v, n)| (**n, **v)) else {
            fixed.sort_by_key(|v| vars.iter().position(|w| w == v));
            return fixed;
        };
        fixed.push(v);
    }
}
