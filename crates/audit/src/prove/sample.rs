//! The sample: a point that satisfies what the search leaves, from simple values.

use kane_algebra::field::theta;
use kane_algebra::point::{Partial, burden, specialised};
use kane_algebra::ring::univariate;
use kane_algebra::sign_table::Cell as LineCell;
use kane_kernel::{Atom, Point, Sign, State};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::conics::conics;
use super::diagonal::diagonal;
use super::elimination::{Elimination, open_vars};
use super::line::{self, open_cells};
use super::parameter::Parametrised;
use super::search::Search;
use super::surds::surds;

type Q = BigRational;

impl Search<'_> {
    /// A point that satisfies a state without solvable equations: conics and surds by their
    /// parameters first, then by the variables themselves.
    pub(super) fn sample(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
        vars: &[usize],
        reach: (usize, usize),
    ) -> Option<Point> {
        let by_parameters = || {
            let mut found = Parametrised::new(state);
            conics(&mut found)?;
            surds(&mut found)?;
            if !found.is_of_use() {
                return None;
            }
            let trail = [trail, &found.eliminations].concat();
            let mut vars = open_vars(&found.state);
            vars.extend(&found.parameters);
            vars.sort_unstable();
            vars.dedup();
            let mut point = self.sample_of(&found.state, &trail, &vars, reach)?;
            point.values.retain(|(v, _)| !found.parameters.contains(v));
            Some(point)
        };
        by_parameters().or_else(|| self.sample_of(state, trail, vars, reach))
    }

    /// Simple rationals for all variables but one, and the sign table of that one.
    fn sample_of(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
        vars: &[usize],
        (lasts, tries): (usize, usize),
    ) -> Option<Point> {
        if vars.is_empty() {
            return complete(state, Partial::default(), trail);
        }
        // Variables on their own take any value that suits them; the others depend on each other.
        let coupled: Vec<usize> = vars
            .iter()
            .copied()
            .filter(|v| {
                state.atoms.iter().any(|a| a.poly.vars().len() > 1 && a.poly.degree(*v) > 0)
            })
            .collect();
        let mut alone = Vec::new();
        let mut order = coupled.clone();
        for &v in vars.iter().filter(|v| !coupled.contains(v)) {
            match candidates(state, v).into_iter().next() {
                Some(q) => alone.push((v, q)),
                // Perhaps an irrational value only.
                None => order.push(v),
            }
        }
        let uses = |v: usize| {
            let count = |sign: &dyn Fn(Sign) -> bool| {
                state.atoms.iter().filter(|a| sign(a.sign) && a.poly.degree(v) > 0).count()
            };
            (count(&|s| s == Sign::Zero), count(&|_| true))
        };
        if order.is_empty() {
            let mut partial = Partial::default();
            alone.into_iter().for_each(|(v, q)| partial.set(v, q));
            return complete(state, partial, trail);
        }
        let all = order.clone();
        order.sort_by_key(|&v| (std::cmp::Reverse(uses(v)), std::cmp::Reverse(v)));
        for &last in order.iter().take(lasts) {
            let others: Vec<usize> = all.iter().copied().filter(|v| *v != last).collect();
            let lists: Vec<Vec<Q>> = others.iter().map(|&v| candidates(state, v)).collect();
            for values in diagonal(&lists, tries) {
                if !self.step(state) {
                    return None;
                }
                let mut assignment: Vec<(usize, Q)> = others.iter().copied().zip(values).collect();
                assignment.extend(alone.iter().cloned());
                let burdens = state.atoms.iter().map(|a| burden(&a.poly, &assignment));
                let work = burdens.fold(0, u64::saturating_add);
                if state.scope.fuel.spend_beyond(work).is_err() {
                    return None;
                }
                let at = |a: &Atom| {
                    let a = Atom::new(specialised(&a.poly, &assignment), a.sign);
                    (a.decided() != Some(false)).then_some(a)
                };
                let Some(atoms) = state.atoms.iter().map(at).collect() else { continue };
                let special = State { atoms, ..state.clone() };
                if line::is_empty(&special, last) {
                    continue;
                }
                let mut partial = Partial::default();
                match line::cut(&special, last) {
                    None => {
                        let Some(simple) = candidates(&special, last).into_iter().next() else {
                            continue;
                        };
                        partial.set(last, simple);
                    }
                    Some((table, indices)) => {
                        let Some(cell) = open_cells(&special, &table, &indices).first().copied()
                        else {
                            continue;
                        };
                        match cell {
                            LineCell::Root(i) if !table.roots[i].is_exact() => {
                                partial.generator = Some(table.roots[i].clone());
                                partial.values.insert(last, theta());
                            }
                            _ => partial.set(last, table.sample(cell)),
                        }
                    }
                }
                for (v, q) in assignment {
                    partial.set(v, q);
                }
                if let Some(point) = complete(state, partial, trail) {
                    return Some(point);
                }
            }
        }
        None
    }
}

/// Simple values for a variable, inside its visible bounds; one of each piece of a line on which none of them lies.
pub(super) fn candidates(state: &State<'_, '_>, v: usize) -> Vec<Q> {
    const SIMPLE: [(i64, i64); 25] = [
        (1, 1),
        (2, 1),
        (1, 2),
        (3, 1),
        (0, 1),
        (-1, 1),
        (1, 3),
        (4, 1),
        (3, 2),
        (-2, 1),
        (1, 4),
        (2, 3),
        (-1, 2),
        (3, 4),
        (5, 1),
        (10, 1),
        (1, 10),
        (-3, 1),
        (9, 10),
        (1, 100),
        (100, 1),
        (-10, 1),
        (11, 10),
        (1000, 1),
        (1, 1000),
    ];
    let alone = state.atoms.iter().filter(|a| a.poly.vars() == [v]);
    let tests: Vec<(Sign, Vec<BigInt>)> =
        alone.filter_map(|a| Some((a.sign, univariate(&a.poly, v)?))).collect();
    // Horner's rule takes as many products as there are coefficients, of numbers that grow
    let pay = |p: &[BigInt], q: &Q| {
        let bits = q.numer().bits().max(q.denom().bits()).saturating_mul(p.len() as u64);
        state.scope.fuel.spend_beyond((bits / 64).saturating_mul(p.len() as u64) / 8)
    };
    let admits = |q: &Q| {
        let here = |(sign, p): &(Sign, Vec<BigInt>)| {
            pay(p, q).is_ok() && sign.admits(kane_kernel::sign_at(p, q))
        };
        tests.iter().all(here)
    };
    let simple = SIMPLE.iter().map(|&(n, d)| Q::new_raw(n.into(), d.into()));
    let mut out: Vec<Q> = simple.filter(admits).collect();
    if out.len() < 8 {
        let (lower, upper) = line::bounds(state, v);
        let value = |i: Option<usize>| i.map(|i| line::bound_value(state, i, v));
        let beside = match (value(lower), value(upper)) {
            // A narrow range: points inside it.
            (Some(a), Some(b)) => {
                let inside = (1..8i64).map(|k| &a + (&b - &a) * Q::new(k.into(), 8.into()));
                inside.chain([a.clone(), b.clone()]).collect()
            }
            // Beyond a bound that is far from all of these.
            (Some(a), None) if out.is_empty() => beyond(&a, 1),
            (None, Some(b)) if out.is_empty() => beyond(&b, -1),
            _ => Vec::new(),
        };
        for q in beside {
            if admits(&q) && !out.contains(&q) {
                out.push(q);
            }
        }
    }
    if out.is_empty()
        && let Some((table, indices)) = line::cut(state, v)
    {
        let cells = open_cells(state, &table, &indices);
        out.extend(cells.iter().filter_map(|cell| {
            let is_rational = !matches!(cell, LineCell::Root(i) if !table.roots[*i].is_exact());
            is_rational.then(|| table.sample(*cell))
        }));
        // what other conditions leave of a piece may lie at its end
        if let Some(LineCell::Gap(i)) = cells.iter().find(|cell| matches!(cell, LineCell::Gap(_))) {
            out.extend(table.near_ends(*i, &state.scope.fuel).unwrap_or_default());
        }
    }
    out
}

/// Values on one side of a bound, and the bound itself.
fn beyond(bound: &Q, sense: i64) -> Vec<Q> {
    let whole = if sense > 0 { bound.floor() } else { bound.ceil() };
    let at = |k: i64| &whole + Q::from_integer((k * sense).into());
    let twice = &whole + bound.abs() * Q::from_integer(sense.into());
    vec![at(1), at(2), twice, bound.clone(), at(100)]
}

/// Gives every other variable a simple value in its range and the eliminated ones theirs.
pub(super) fn complete(
    state: &State<'_, '_>,
    mut partial: Partial,
    trail: &[Elimination],
) -> Option<Point> {
    let symbols = state.goal.context.vars.len();
    let count = state.scope.germ() + 1 + kane_kernel::premised(state.goal).count();
    for v in state.scope.mentioned.iter().copied().chain(symbols..count) {
        let eliminated = trail.iter().any(|e| e.var == v);
        if partial.values.contains_key(&v) || eliminated {
            continue;
        }
        // Most symbols may be 1.
        let atoms = state.scope.range(v);
        let one = |a: &Atom| Atom::new(specialised(&a.poly, &[(v, Q::one())]), a.sign).decided();
        let value = if atoms.iter().all(|a| one(a) == Some(true)) {
            Q::one()
        } else {
            let range = State { atoms, ..state.clone() };
            candidates(&range, v).into_iter().next().unwrap_or_else(Q::zero)
        };
        partial.set(v, value);
    }
    for e in trail.iter().rev() {
        let value = partial.quotient(&e.e, &e.d, &state.scope.fuel)?;
        partial.values.insert(e.var, value);
    }
    Some(partial.finish())
}
