//! Points by cells: where conditions are cut to pieces on which they keep their signs, and one of the
//! pieces is looked at after the other.

use kane_algebra::cells::{Cells, cells};
use kane_algebra::point::specialised;
use kane_kernel::{Atom, Point, State};
use num_rational::BigRational;

use super::diagonal::diagonal;
use super::elimination::Elimination;
use super::sample::{candidates, complete};
use super::search::Search;

type Q = BigRational;

/// Cells of the plane that are looked at, and of space.
const PLANE: usize = 400;
const SPACE: usize = 600;
/// Cells of one plane where all other variables have values, planes, and values for them.
const SLICE: usize = 80;
const SLICES: usize = 3;
const VALUES: usize = 10;

impl Search<'_> {
    /// A point of a state by cells: of all of the plane or of space, or of planes in it on which the
    /// other variables have simple values.
    pub(super) fn by_cells(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
        vars: &[usize],
    ) -> Option<Point> {
        let order = ordered(&state.atoms, vars);
        let most = match vars.len() {
            0 | 1 => return None,
            2 => PLANE,
            3 => SPACE,
            _ => return self.by_slices(state, trail, &order),
        };
        match self.cells_of(&state.atoms, &order, most) {
            Cells::Point(partial) => complete(state, partial, trail),
            Cells::Empty => None,
            Cells::Open => self.by_slices(state, trail, &order),
        }
    }

    fn cells_of(&self, atoms: &[Atom], vars: &[usize], most: usize) -> Cells {
        let mut left = most.min(usize::try_from(self.left()).unwrap_or(most));
        let before = left;
        let found = cells(atoms, vars, &mut left, &self.cells);
        (left..before).for_each(|_| _ = self.spend());
        found
    }

    /// The planes of the last two variables, for simple values of the others.
    fn by_slices(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
        order: &[usize],
    ) -> Option<Point> {
        for plane in order.windows(2).rev().take(SLICES) {
            let others: Vec<usize> = order.iter().copied().filter(|u| !plane.contains(u)).collect();
            let lists: Vec<Vec<Q>> = others.iter().map(|&u| candidates(state, u)).collect();
            for values in diagonal(&lists, VALUES) {
                if !self.step(state) {
                    return None;
                }
                let values: Vec<(usize, Q)> = others.iter().copied().zip(values).collect();
                let at = |a: &Atom| Atom::new(specialised(&a.poly, &values), a.sign);
                let atoms: Vec<Atom> = state.atoms.iter().map(at).collect();
                if let Cells::Point(mut partial) = self.cells_of(&atoms, plane, SLICE) {
                    values.into_iter().for_each(|(u, q)| partial.set(u, q));
                    if let Some(point) = complete(state, partial, trail) {
                        return Some(point);
                    }
                }
            }
        }
        None
    }
}

/// Variables in the order in which they take values: those of high degree and in many conditions
/// first, for what is eliminated first multiplies.
fn ordered(atoms: &[Atom], vars: &[usize]) -> Vec<usize> {
    let weight = |v: usize| {
        let degrees = atoms.iter().filter(|a| a.decided().is_none()).map(|a| a.poly.degree(v));
        let top = degrees.clone().max().unwrap_or(0);
        (top, degrees.filter(|n| *n > 0).count())
    };
    let mut out = vars.to_vec();
    out.sort_by_key(|v| (std::cmp::Reverse(weight(*v)), *v));
    out
}
