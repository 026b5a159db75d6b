//! Boxes of inputs, and how they are split.
#![allow(clippy::float_arithmetic, reason = "where a box is split is free")]

use kane_kernel::Bound;
use kane_number::{Rounding, encode};

use crate::Core;
use crate::machine::{Machine, places};

/// What an argument of a formula may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inputs {
    /// floats of the format: arguments are exact
    Floats,
    /// real numbers, which are rounded to the format first: their rounding counts as an error
    Reals,
}

/// A box: per argument its least and its greatest value, which are floats of the format.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// the ends
    pub ends: Vec<(f64, f64)>,
}

impl Cell {
    /// The whole domain; the name of the first argument without a float in its range otherwise.
    ///
    /// # Errors
    /// That name.
    pub fn whole<M: Machine>(core: &Core, inputs: Inputs) -> Result<Self, String> {
        let mut ends = Vec::new();
        for argument in &core.arguments {
            let (lower, upper) = (argument.lower.as_ref(), argument.upper.as_ref());
            let nowhere = || argument.name.clone();
            let (first, last) = match inputs {
                Inputs::Floats => places::<M>(lower, upper).ok_or_else(nowhere)?,
                Inputs::Reals => outer_places::<M>(lower, upper).ok_or_else(nowhere)?,
            };
            ends.push((M::at(first).wide(), M::at(last).wide()));
        }
        Ok(Self { ends })
    }

    /// Whether it is a single point.
    #[must_use]
    pub fn is_point(&self) -> bool {
        self.ends.iter().all(|(lower, upper)| lower == upper)
    }

    /// A point inside, of floats.
    #[must_use]
    pub fn middle<M: Machine>(&self) -> Self {
        let middle = |&(lower, upper): &(f64, f64)| {
            let at = middle::<M>(lower, upper).wide();
            (at, at)
        };
        Self { ends: self.ends.iter().map(middle).collect() }
    }

    /// Both halves along an argument; `None` if it has one value there. Between floats there is nothing to
    /// keep, between reals there is.
    #[must_use]
    pub fn halves<M: Machine>(&self, argument: usize, inputs: Inputs) -> Option<(Self, Self)> {
        let &(lower, upper) = self.ends.get(argument)?;
        let middle = middle::<M>(lower, upper);
        let after = match inputs {
            Inputs::Floats => M::at(middle.place() + 1).wide(),
            Inputs::Reals => middle.wide(),
        };
        if lower == upper || (inputs == Inputs::Reals && middle.wide() == lower) {
            return None;
        }
        let (mut left, mut right) = (self.clone(), self.clone());
        if let (Some(first), Some(second)) =
            (left.ends.get_mut(argument), right.ends.get_mut(argument))
        {
            *first = (lower, middle.wide());
            *second = (after, upper);
        }
        Some((left, right))
    }

    /// How wide it is along an argument beside the magnitudes there: 0 for a point, at most 2.
    #[must_use]
    pub fn relative_width(&self, argument: usize) -> f64 {
        let Some(&(lower, upper)) = self.ends.get(argument) else { return 0.0 };
        if lower == upper {
            return 0.0;
        }
        let most = lower.abs().max(upper.abs());
        upper / most - lower / most
    }
}

/// The floats around a range of real numbers.
fn outer_places<M: Machine>(lower: Option<&Bound>, upper: Option<&Bound>) -> Option<(i64, i64)> {
    let end = |bound: &Bound, rounding: Rounding| encode::<M>(&bound.value, rounding).place();
    let greatest = M::at(i64::MAX).place();
    let first = lower.map_or(-greatest, |bound| end(bound, Rounding::Down));
    let last = upper.map_or(greatest, |bound| end(bound, Rounding::Up));
    let empty = lower.zip(upper).is_some_and(|(lower, upper)| lower.value > upper.value);
    (!empty).then_some((first.max(-greatest), last.min(greatest)))
}

/// A float from `lower` on and below `upper`: the middle of magnitudes where these differ much.
fn middle<M: Machine>(lower: f64, upper: f64) -> M {
    let (low, high) = (M::nearest(lower), M::nearest(upper));
    let by_value = M::nearest(f64::midpoint(lower, upper));
    let (first, last) = (low.place(), high.place());
    let place = if (lower < 0.0) != (upper < 0.0) && lower != 0.0 && upper != 0.0 {
        // across 0: the signs part
        if by_value.place().abs() < first.abs().max(last.abs()) / 4 { by_value.place() } else { 0 }
    } else {
        let (small, large) = (lower.abs().min(upper.abs()), lower.abs().max(upper.abs()));
        if small > 0.0 && large / small > 4.0 {
            first + (last - first) / 2
        } else if small == 0.0 && large > 0.0 {
            // toward 0 by a few binades at a time
            let step = i64::try_from(1_u64 << (M::PRECISION - 1)).unwrap_or(i64::MAX);
            if last > 0 {
                (last - 2 * step).max(first + (last - first) / 2)
            } else {
                (first + 2 * step).min(first + (last - first) / 2)
            }
        } else {
            by_value.place()
        }
    };
    // the upper half must have a float of its own
    M::at(place.clamp(first, (last - 1).max(first)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_part_all_floats_and_end_at_points() {
        let mut cells = vec![Cell { ends: vec![(-1.0, 1.0_f64.next_up())] }];
        let mut points = 0;
        for _ in 0..4_000 {
            let Some(cell) = cells.pop() else { break };
            if let Some((left, right)) = cell.halves::<f64>(0, Inputs::Floats) {
                assert_eq!(left.ends[0].0, cell.ends[0].0);
                assert_eq!(right.ends[0].1, cell.ends[0].1);
                assert!(left.ends[0].1.next_up() == right.ends[0].0);
                assert!(left.ends[0].0 <= left.ends[0].1 && right.ends[0].0 <= right.ends[0].1);
                cells.push(left);
                cells.push(right);
            } else {
                assert!(cell.is_point());
                points += 1;
            }
        }
        assert!(points > 1_000);
    }
}
