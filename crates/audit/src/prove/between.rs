//! Points between bounds: a variable that stands in linear bounds alone goes half the way from one to the other, and what
//! is left of the conditions says that its bounds leave room (Fourier 1826).

use kane_kernel::{Atom, Point, Poly, State};
use num_bigint::BigInt;
use num_traits::Signed as _;

use super::elimination::{Elimination, open_vars};
use super::search::Search;
use super::variation::homogeneous;

/// Pairs of bounds between which a variable is put.
const PAIRS: usize = 6;
/// Variables that are put between bounds, one after the other.
const VARIABLES: usize = 3;

/// k·v ≥ p with k > 0, or k·v ≤ p.
struct Bound {
    k: BigInt,
    p: Poly,
}

impl Search<'_> {
    /// A point of a state of which some variables have linear bounds alone: a simple one, if there is one.
    pub(super) fn between_bounds(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
        vars: &[usize],
        reach: (usize, usize),
    ) -> Option<Point> {
        let here = ways_of(state, vars)?;
        self.sample(state, trail, vars, reach)
            .or_else(|| self.moved(state, trail, here, reach, VARIABLES))
    }

    fn moved(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
        ways: Vec<Elimination>,
        reach: (usize, usize),
        left: usize,
    ) -> Option<Point> {
        ways.into_iter().find_map(|here| {
            // times a power of a number that is positive
            let parts = (&here.d, &here.e);
            let moved = |a: &Atom| {
                let poly = homogeneous(&a.poly, here.var, parts, &state.scope.fuel).ok()?;
                Some(Atom::new(poly, a.sign))
            };
            let atoms = state.atoms.iter().map(moved).collect::<Option<_>>()?;
            let there = State { atoms, ..state.clone() };
            if !self.step(&there) || there.atoms.iter().any(|a| a.decided() == Some(false)) {
                return None;
            }
            let trail = [trail, &[here]].concat();
            let vars = open_vars(&there);
            self.sample(&there, &trail, &vars, reach).or_else(|| {
                let ways = ways_of(&there, &vars).filter(|_| left > 1)?;
                self.moved(&there, &trail, ways, reach, left - 1)
            })
        })
    }
}

/// The values that are tried for the first variable that has such bounds.
fn ways_of(state: &State<'_, '_>, vars: &[usize]) -> Option<Vec<Elimination>> {
    vars.iter().find_map(|v| ways(state, *v))
}

/// The values that are tried for a variable, if it stands in linear bounds alone, and in one of them with others.
fn ways(state: &State<'_, '_>, v: usize) -> Option<Vec<Elimination>> {
    let (mut lower, mut upper) = (Vec::new(), Vec::new());
    let mut is_coupled = false;
    for a in state.atoms.iter().filter(|a| a.poly.degree(v) > 0) {
        let k = a.poly.coefficient(v, 1).as_constant().filter(|_| a.poly.degree(v) == 1)?;
        if !a.sign.is_order() {
            return None;
        }
        is_coupled |= a.poly.vars().len() > 1;
        let rest = a.poly.coefficient(v, 0);
        if k.is_positive() {
            lower.push(Bound { k, p: rest.neg() });
        } else {
            upper.push(Bound { k: -k, p: rest });
        }
    }
    let pairs = lower.len().max(1) * upper.len().max(1);
    if !is_coupled || pairs > PAIRS {
        return None;
    }
    // half the way, or 1 beyond the only ones
    let beyond = |b: &Bound, by: BigInt| Elimination {
        var: v,
        d: Poly::constant(b.k.clone()),
        e: b.p.add(&Poly::constant(&b.k * by)).neg(),
    };
    let half = |l: &Bound, u: &Bound| Elimination {
        var: v,
        d: Poly::constant(&l.k * &u.k * 2),
        e: l.p.scale(&u.k).add(&u.p.scale(&l.k)).neg(),
    };
    Some(match (&lower[..], &upper[..]) {
        (lower, []) => lower.iter().map(|l| beyond(l, 1.into())).collect(),
        ([], upper) => upper.iter().map(|u| beyond(u, (-1).into())).collect(),
        (lower, upper) => lower.iter().flat_map(|l| upper.iter().map(|u| half(l, u))).collect(),
    })
}
