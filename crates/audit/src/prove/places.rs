//! Points by places: the symbols have simple values, and the roots those that follow.

use kane_algebra::point::{burden, specialised};
use kane_kernel::{Atom, Point, Poly, Sign, State};
use num_rational::BigRational;
use num_traits::Zero as _;

use super::diagonal::diagonal;
use super::elimination::{Elimination, open_vars};
use super::line;
use super::radicals::Radicals;
use super::sample::candidates;
use super::search::Search;

/// Places at which all symbols are equal.
const EQUAL: usize = 8;
/// Places with 0, 1 and −1 alone that are tried after all others.
const CORNERS: usize = 81;
/// Roots below which a sample of all variables is as good.
const FEWEST: usize = 2;

impl Search<'_> {
    /// A point of a state with several roots.
    pub(super) fn at_places(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
        vars: &[usize],
        tries: usize,
    ) -> Option<Point> {
        let is_root = |v: &usize| state.scope.root(*v).is_some();
        let (roots, mut symbols): (Vec<usize>, Vec<usize>) =
            vars.iter().copied().partition(is_root);
        let following = following(state, &symbols);
        symbols.retain(|v| following.iter().all(|(w, _)| w != v));
        if roots.len() < FEWEST || symbols.is_empty() {
            return None;
        }
        let lists: Vec<_> = symbols.iter().map(|&v| candidates(state, v)).collect();
        // first where all are equal, as are most that hold an equation by their sum
        let shared = lists[0].iter().filter(|q| lists.iter().all(|list| list.contains(q)));
        let equal = shared.take(EQUAL).map(|q| vec![q.clone(); lists.len()]);
        let mut places: Vec<_> = equal.chain(diagonal(&lists, tries)).collect();
        let units: Vec<Vec<BigRational>> = lists.iter().map(|list| units(list)).collect();
        let corners: usize = units.iter().map(Vec::len).product();
        if !self.brief && corners <= CORNERS {
            let mut corners: Vec<_> = diagonal(&units, corners).collect();
            corners.retain(|at| !places.contains(at));
            places.extend(corners);
        }
        places.into_iter().map_while(|values| self.step(state).then_some(values)).find_map(
            |values| {
                let mut place: Vec<(usize, BigRational)> =
                    symbols.iter().copied().zip(values).collect();
                for (v, equation) in &following {
                    let left = specialised(equation, &place);
                    let [d, e] = [1, 0].map(|n| left.coefficient(*v, n).as_constant());
                    place.push((*v, BigRational::new(-e?, d.filter(|d| !d.is_zero())?)));
                }
                let work = state.atoms.iter().map(|a| burden(&a.poly, &place));
                state.scope.fuel.spend_beyond(work.fold(0, u64::saturating_add)).ok()?;
                let at = |a: &Atom| {
                    let atom = Atom::new(specialised(&a.poly, &place), a.sign);
                    (atom.decided() != Some(false)).then_some(atom)
                };
                let atoms = state.atoms.iter().map(at).collect::<Option<_>>()?;
                let special = State { atoms, ..state.clone() };
                if roots.iter().any(|&v| line::is_empty(&special, v)) || is_false(&special) {
                    return None;
                }
                let here = place.into_iter().map(|(var, q)| {
                    let [d, e] = [q.denom().clone(), -q.numer()].map(Poly::constant);
                    Elimination { var, d, e }
                });
                let trail: Vec<Elimination> = trail.iter().cloned().chain(here).collect();
                self.sample(&special, &trail, &open_vars(&special), (1, 4))
            },
        )
    }
}

/// Of some values those that are 0, 1 or −1.
fn units(values: &[BigRational]) -> Vec<BigRational> {
    let is_unit = |q: &&BigRational| q.is_integer() && q.numer().bits() <= 1;
    values.iter().filter(is_unit).cloned().collect()
}

/// Symbols that equations without roots give from the others, and those equations: each after those whose symbols it has.
fn following(state: &State<'_, '_>, symbols: &[usize]) -> Vec<(usize, Poly)> {
    let mut found: Vec<(usize, Poly)> = Vec::new();
    for atom in state.atoms.iter().filter(|a| a.sign == Sign::Zero) {
        let vars = atom.poly.vars();
        let is_new = |v: &usize| found.iter().all(|(w, p)| w != v && p.degree(*v) == 0);
        let gives = |v: &usize| {
            atom.poly.degree(*v) == 1 && atom.poly.coefficient(*v, 1).is_constant() && is_new(v)
        };
        if vars.len() > 1
            && vars.iter().all(|v| symbols.contains(v))
            && let Some(v) = vars.iter().rev().copied().find(gives)
        {
            found.push((v, atom.poly.clone()));
        }
    }
    found
}

/// Whether roots of numbers have values at which something is not as it is said.
fn is_false(state: &State<'_, '_>) -> bool {
    Radicals::of(state).is_some_and(|radicals| {
        let fuel = &state.scope.fuel;
        let seen = |a: &Atom| radicals.seen(&a.poly, fuel).is_some_and(|sign| !a.sign.admits(sign));
        state.atoms.iter().any(seen)
    })
}
