//! Where more than half of the bits may be lost.

use std::collections::VecDeque;

use super::bound::{Goal, Search};
use super::domain::{Cell, Inputs};
use super::upward::power;
use crate::Core;
use crate::machine::Machine;

/// Boxes that are told apart; more are drawn together.
const TOLD: usize = 4;

/// Boxes of inputs outside of which no input loses more than half of the bits of the format of `M`, that is,
/// has an error above 2^(p/2) ulps for p bits, nor fails. Rigorous: inside of them digits may be lost, outside
/// they are not. Empty if no input of the domain loses as many. In order, apart from each other, at most four
/// for one argument; for several arguments one box.
///
/// The widest boxes are split first until `cells` boxes have been looked at. Deterministic.
///
/// # Errors
/// The name of an argument that has no float in its range.
pub fn lossy<M: Machine>(core: &Core, inputs: Inputs, cells: usize) -> Result<Vec<Cell>, String> {
    let whole = Cell::whole::<M>(core, inputs)?;
    let search = Search::<M>::of(core, inputs, Goal::Ulps);
    // for an odd p rounded down, so that "half" is never more than half
    let half = power(i64::from(M::PRECISION / 2));
    let is_lossy =
        |cell: Cell| search.look(cell).filter(|seen| seen.bound > half || seen.bound.is_nan());
    let mut waiting: VecDeque<_> = is_lossy(whole).into_iter().collect();
    let (mut seen, mut left) = (1, Vec::new());
    while let Some(next) = waiting.pop_front() {
        let halves = next.split.and_then(|argument| next.cell.halves::<M>(argument, inputs));
        match halves {
            Some((low, high)) if seen < cells => {
                seen += 2;
                waiting.extend([low, high].into_iter().filter_map(is_lossy));
            }
            _ => left.push(next.cell),
        }
    }
    Ok(joined::<M>(left))
}

/// Few boxes that hold all of these.
fn joined<M: Machine>(mut cells: Vec<Cell>) -> Vec<Cell> {
    let count = cells.first().map_or(0, |cell| cell.ends.len());
    if count != 1 {
        return cells.into_iter().reduce(|a, b| hull(&a, &b)).into_iter().collect();
    }
    let first = |cell: &Cell| cell.ends.first().map_or(0, |(lower, _)| M::nearest(*lower).place());
    let last = |cell: &Cell| cell.ends.first().map_or(0, |(_, upper)| M::nearest(*upper).place());
    cells.sort_by_key(first);
    loop {
        let gap = |pair: &[Cell]| match pair {
            [a, b] => first(b).saturating_sub(last(a)),
            _ => i64::MAX,
        };
        let closest = cells.windows(2).enumerate().map(|(at, pair)| (gap(pair), at)).min();
        match closest {
            // neighbours, or too many to tell
            Some((gap, at)) if gap <= 1 || cells.len() > TOLD => {
                let next = cells.remove(at + 1);
                if let Some(cell) = cells.get_mut(at) {
                    *cell = hull(cell, &next);
                }
            }
            _ => return cells,
        }
    }
}

/// The smallest box around two.
fn hull(a: &Cell, b: &Cell) -> Cell {
    let ends = a.ends.iter().zip(&b.ends);
    Cell { ends: ends.map(|(a, b)| (a.0.min(b.0), a.1.max(b.1))).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fpcore;

    fn of(text: &str) -> Vec<Cell> {
        let core = fpcore::read("t.fpcore", text).unwrap().remove(0);
        lossy::<f64>(&core, Inputs::Floats, 3_000).unwrap()
    }

    /// 1 − p² at p = 1 − d: the relative error is about u/(2d), beyond 2^26 ulps from d = 2^-27 on.
    #[test]
    fn a_cancellation_is_found_where_it_is_and_nowhere_else() {
        let found = of("(FPCore (p) :pre (<= -1/2 p 2) (- 1 (* p p)))");
        let [cell] = found.as_slice() else { panic!("{found:?}") };
        let (lower, upper) = cell.ends[0];
        assert!(lower < 1.0 - 1e-9 && 1.0 - 1e-7 < lower, "{cell:?}");
        assert!(1.0 + 1e-9 < upper && upper < 1.0 + 1e-7, "{cell:?}");
        assert_eq!(of("(FPCore (p) :pre (<= -1/2 p 1/2) (- 1 (* p p)))"), vec![]);
    }

    #[test]
    fn each_zero_has_a_range_of_its_own_and_poles_are_in_one() {
        let found = of("(FPCore (x) :pre (<= -2 x 2) (- (* x x) 0.3))");
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(found[0].ends[0].1 < 0.0 && found[1].ends[0].0 > 0.0);
        let found = of("(FPCore (x) :pre (<= 1 x 5) (/ 1 (- x 3)))");
        let [cell] = found.as_slice() else { panic!("{found:?}") };
        assert_eq!(cell.ends, [(3.0, 3.0)]);
    }

    #[test]
    fn of_two_arguments_one_box_holds_all() {
        let found = of("(FPCore (x y) :pre (and (<= 1 x 2) (<= 3/2 y 4)) (- (* x x) y))");
        let [cell] = found.as_slice() else { panic!("{found:?}") };
        assert!(cell.ends[0].0 > 1.2 && cell.ends[1].1 == 4.0, "{cell:?}");
    }
}
