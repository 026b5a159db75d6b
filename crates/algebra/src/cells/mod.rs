//! Cells: finitely many pieces of space on which polynomials keep their signs, with a point in each
//! (Collins 1975).
//!
//! Conditions are projected, one variable after the other, and from the line on, cell by cell, points
//! are lifted again. In one and two variables that says all: either some point satisfies the
//! conditions, or none does. Coordinates are exact, in the field of one real algebraic number. What is
//! found is a proposal: the kernel looks at the point, and believes nobody who says that there is none.

mod fibre;
mod projection;
mod resultant;
#[cfg(test)]
mod tests;

use kane_kernel::{Atom, Fuel, Poly, Sign};

use crate::point::Partial;
use crate::sign_table::Cell;
use fibre::Fibre;
use projection::{equation, projection};

pub use resultant::{discriminant, resultant};

/// What the cells say of conditions.
#[derive(Clone, Debug)]
pub enum Cells {
    /// a point that satisfies them
    Point(Partial),
    /// no sample of a cell satisfies them: in one and two variables, no point does
    Empty,
    /// the cells take more than was allowed
    Open,
}

/// Conditions beyond which no cells are made.
const CONDITIONS: usize = 12;
/// The degree of a condition in one variable beyond which no cells are made.
const DEGREE: u32 = 8;
/// Bits of a coefficient beyond which no cells are made.
const BITS: u64 = 256;

/// Looks at the cells of space in these variables, the last of which is eliminated first; all other
/// variables of the conditions must have a value in `base`, which is rational there. Cells count as
/// steps of `steps`, coefficient operations are spent from `fuel`.
#[must_use]
pub fn cells(atoms: &[Atom], vars: &[usize], steps: &mut usize, fuel: &Fuel) -> Cells {
    let live: Vec<Atom> = atoms.iter().filter(|a| a.decided().is_none()).cloned().collect();
    if atoms.iter().any(|a| a.decided() == Some(false)) {
        return Cells::Empty;
    }
    let wide = |a: &Atom| a.poly.bits() > BITS || vars.iter().any(|v| a.poly.degree(*v) > DEGREE);
    let foreign = |a: &Atom| a.poly.vars().iter().any(|v| !vars.contains(v));
    if live.len() > CONDITIONS || live.iter().any(|a| wide(a) || foreign(a)) {
        return Cells::Open;
    }
    // Polynomials to cut the line of each variable with, given the variables before it.
    let mut levels: Vec<Vec<Poly>> = vec![live.iter().map(|a| a.poly.clone()).collect()];
    for (n, &v) in vars.iter().enumerate().skip(1).rev() {
        let Some(level) = levels.last() else { return Cells::Open };
        let central = if n + 1 == vars.len() { equation(&live, v) } else { None };
        let Some(next) = projection(level, central, v, fuel) else {
            return Cells::Open;
        };
        levels.push(next);
    }
    levels.reverse();
    // An open set, if it is not empty, has a point off all cuts.
    let open = live.iter().all(|a| matches!(a.sign, Sign::Positive | Sign::NonZero));
    let search = Lift { atoms: &live, vars, levels: &levels, open, fuel };
    search.over(&Partial::default(), 0, steps)
}

struct Lift<'a> {
    atoms: &'a [Atom],
    vars: &'a [usize],
    levels: &'a [Vec<Poly>],
    open: bool,
    fuel: &'a Fuel,
}

impl Lift<'_> {
    /// The cells over a point of the first n variables.
    fn over(&self, base: &Partial, n: usize, steps: &mut usize) -> Cells {
        let Some(&v) = self.vars.get(n) else {
            return Cells::Point(base.clone());
        };
        let Some(fibre) = Fibre::new(base, &self.levels[n], v, self.fuel) else {
            return Cells::Open;
        };
        // What speaks of v and of variables with values alone holds or fails here already.
        let known = &self.vars[..=n];
        let tells =
            |a: &&Atom| a.poly.degree(v) > 0 && a.poly.vars().iter().all(|w| known.contains(w));
        let told: Vec<&Atom> = self.atoms.iter().filter(tells).collect();
        let mut open = false;
        for cell in fibre.cells() {
            if self.open && matches!(cell, Cell::Root(_)) {
                continue;
            }
            if *steps == 0 {
                return Cells::Open;
            }
            *steps -= 1;
            let Some(point) = fibre.point(cell, self.fuel) else {
                open = true;
                continue;
            };
            let holds = |a: &&Atom| point.sign(&a.poly, self.fuel).map(|s| a.sign.admits(s));
            match told.iter().map(holds).find(|h| *h != Some(true)) {
                Some(Some(_)) => continue,
                Some(None) => {
                    open = true;
                    continue;
                }
                None => {}
            }
            match self.over(&point, n + 1, steps) {
                Cells::Point(found) => return Cells::Point(found),
                Cells::Open => open = true,
                Cells::Empty => {}
            }
        }
        if open { Cells::Open } else { Cells::Empty }
    }
}
