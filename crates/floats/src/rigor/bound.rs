//! Branch and bound over boxes.
#![allow(clippy::float_arithmetic, reason = "bounds are floats, rounded upward")]

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use kane_number::Interval;

use super::domain::{Cell, Inputs};
use super::pass::{FaultKind, Known, Pass, constant};
use super::slopes::reached;
use super::upward::{binade, least, over, power};
use crate::exact::compared;
use crate::machine::{Machine, Runner};
use crate::{Core, Operation};

/// What is bounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Goal {
    /// |computed − exact|
    Absolute,
    /// the same in ulps of the exact value: an ulp is that of its binade, at least the least subnormal
    Ulps,
}

/// When to stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget {
    /// boxes that may be looked at
    pub cells: usize,
    /// a bound this many times the best possible one is good enough
    pub ratio: f64,
}

impl Default for Budget {
    fn default() -> Self {
        Self { cells: 12_000, ratio: 1.02 }
    }
}

/// An operation that may fail, and a box in which it may.
#[derive(Clone, Debug, PartialEq)]
pub struct Pole {
    /// the operation
    pub operation: usize,
    /// how it fails
    pub kind: FaultKind,
    /// where
    pub cell: Cell,
    /// whether it does fail there, at a point
    pub certain: bool,
}

/// A bound, or why there is none.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounded {
    /// what no error exceeds; ∞ if there is a pole. Rigorous.
    pub bound: f64,
    /// the least bound that this method could have found: its value at a single point
    pub least: f64,
    /// the boxes with the greatest bounds, the greatest first: where to look for large errors
    pub worst: Vec<Cell>,
    /// an operation that may fail
    pub pole: Option<Pole>,
    /// boxes that were looked at
    pub cells: usize,
}

/// A box that waits, by its bound.
pub(super) struct Waiting {
    pub(super) bound: f64,
    pub(super) cell: Cell,
    pub(super) split: Option<usize>,
    pole: Option<(usize, FaultKind)>,
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Waiting {}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bound.total_cmp(&other.bound)
    }
}

/// Boxes of large bounds that are kept.
const KEPT: usize = 12;

/// Bounds the error of a formula over its domain in the format of `M`. Rigorous, deterministic.
///
/// # Errors
/// The name of an argument that has no float in its range.
pub fn bounded<M: Machine>(
    core: &Core,
    inputs: Inputs,
    goal: Goal,
    budget: Budget,
) -> Result<Bounded, String> {
    let whole = Cell::whole::<M>(core, inputs)?;
    Ok(Search::<M>::of(core, inputs, goal).run(whole, budget))
}

/// A formula with what every box needs.
pub(super) struct Search<'a, M> {
    core: &'a Core,
    pub(super) inputs: Inputs,
    goal: Goal,
    constants: Vec<Option<Known>>,
    runner: Runner<'a, M>,
}

impl<'a, M: Machine> Search<'a, M> {
    pub(super) fn of(core: &'a Core, inputs: Inputs, goal: Goal) -> Self {
        let constant = |operation: &Operation| match operation {
            Operation::Number(number) => Some(constant::<M>(number)),
            _ => None,
        };
        let constants: Vec<Option<Known>> =
            core.program.operations().iter().map(constant).collect();
        Self { core, inputs, goal, constants, runner: Runner::new(&core.program) }
    }

    fn run(&self, whole: Cell, budget: Budget) -> Bounded {
        let mut heap = BinaryHeap::new();
        let mut done: Vec<Waiting> = Vec::new();
        let (mut cells, mut best) = (0, 0.0_f64);
        heap.extend(self.look(whole));
        let mut pole = None;
        while let Some(top) = heap.pop() {
            if let Some((operation, kind)) = top.pole {
                let found = self.fails_at(&top.cell);
                let certain = found.is_some();
                if certain || top.split.is_none() || cells > budget.cells / 2 {
                    let (operation, kind, cell) =
                        found.unwrap_or((operation, kind, top.cell.clone()));
                    pole = Some(Pole { operation, kind, cell, certain });
                    heap.push(top);
                    break;
                }
            }
            // where every digit may be wrong at a point there is nothing left to refine
            let hopeless = self.goal == Goal::Ulps && best >= power(i64::from(M::PRECISION));
            let settled = hopeless || top.bound <= best * budget.ratio;
            if settled || cells >= budget.cells {
                heap.push(top);
                break;
            }
            let Some(argument) = top.split else {
                done.push(top);
                // what cannot be split ends the search if it is the greatest
                break;
            };
            let Some((left, right)) = top.cell.halves::<M>(argument, self.inputs) else {
                done.push(top);
                break;
            };
            for half in [left, right] {
                cells += 1;
                let middle = half.middle::<M>();
                if self.is_assumed(&middle)
                    && let Some(point) = self.look(middle)
                {
                    best = best.max(if point.bound.is_finite() { point.bound } else { 0.0 });
                }
                heap.extend(self.look(half));
            }
        }
        done.extend(heap.into_sorted_vec().into_iter().rev().take(KEPT));
        done.sort_by(|a, b| b.cmp(a));
        let bound = done.first().map_or(0.0, |greatest| greatest.bound);
        let bound = if pole.is_some() { f64::INFINITY } else { bound };
        let worst = done.into_iter().take(KEPT).map(|waiting| waiting.cell).collect();
        Bounded { bound, least: best, worst, pole, cells }
    }

    /// The bound over a box; `None` if nothing in it is in the domain.
    pub(super) fn look(&self, cell: Cell) -> Option<Waiting> {
        let (program, root) = (&self.core.program, self.core.root);
        let pass = Pass::over::<M>(program, &self.constants, &cell, self.inputs);
        if self.core.assumed.iter().any(|test| pass.test(test).0 == Some(false)) {
            return None;
        }
        let count = cell.ends.len();
        let pole = pass.fault(program, root);
        let through = reached(program, &pass, root, count);
        let known = pass.at(root)?;
        let mut bound = self.measured(through.error.min(known.error), known.exact.range);
        if pole.is_some() {
            bound = f64::INFINITY;
        }
        if cell.is_point() && self.inputs == Inputs::Floats {
            bound = self.at_point(&cell).unwrap_or(bound).min(bound);
            return Some(Waiting { bound, cell, split: None, pole });
        }
        // along which argument a split helps most
        let total = through.error;
        let score = |argument: usize| {
            let influence = through.influence.get(argument).copied().unwrap_or(0.0) / total;
            let influence = if influence.is_finite() { influence.min(4.0) } else { 0.0 };
            influence + 0.25 * cell.relative_width(argument)
        };
        let split = (0..count)
            .filter(|argument| cell.halves::<M>(*argument, self.inputs).is_some())
            .max_by(|a, b| score(*a).total_cmp(&score(*b)));
        Some(Waiting { bound, cell, split, pole })
    }

    /// An error in the unit of the goal.
    fn measured(&self, error: f64, exact: Interval) -> f64 {
        match self.goal {
            Goal::Absolute => error,
            Goal::Ulps => {
                let magnitude = least(exact);
                let unit = if magnitude == 0.0 || !magnitude.is_finite() {
                    M::LEAST_EXPONENT
                } else {
                    (binade(magnitude) - i64::from(M::PRECISION) + 1).max(M::LEAST_EXPONENT)
                };
                over(error, power(unit))
            }
        }
    }

    /// The true error at a point.
    fn at_point(&self, cell: &Cell) -> Option<f64> {
        let point = floats::<M>(cell);
        let computed = self.runner.value(self.core.root, &point)?;
        let found = compared(&self.core.program, self.core.root, &point, computed)?;
        Some(match self.goal {
            Goal::Absolute => found.error_at_most,
            Goal::Ulps => found.ulps_at_most,
        })
    }

    fn is_assumed(&self, point: &Cell) -> bool {
        let mut results = Vec::new();
        self.runner.run(&floats::<M>(point), &mut results);
        let compare = |rel, a: usize, b: usize| {
            let (a, b) = (results.get(a)?, results.get(b)?);
            Some(crate::machine::compares(rel, a.partial_cmp(b)))
        };
        self.core.assumed.iter().all(|test| test.holds(&compare) == Some(true))
    }

    /// A point of a box at which an operation fails in fact: the middle, and the corners of small boxes.
    fn fails_at(&self, cell: &Cell) -> Option<(usize, FaultKind, Cell)> {
        let mut points = vec![cell.middle::<M>()];
        let count = cell.ends.len();
        for corner in 0..(1_usize << count.min(4)) {
            let end = |(index, &(lower, upper)): (usize, &(f64, f64))| {
                let at = if corner >> (index % 4) & 1 == 0 { lower } else { upper };
                (at, at)
            };
            points.push(Cell { ends: cell.ends.iter().enumerate().map(end).collect() });
        }
        points.into_iter().find_map(|point| {
            let computed = self.runner.value(self.core.root, &floats::<M>(&point))?;
            if computed.finite() || !self.is_assumed(&point) {
                return None;
            }
            let pass = Pass::over::<M>(&self.core.program, &self.constants, &point, Inputs::Floats);
            let (operation, kind) = pass.fault(&self.core.program, self.core.root)?;
            Some((operation, kind, point))
        })
    }
}

/// The floats of a point.
fn floats<M: Machine>(point: &Cell) -> Vec<M> {
    point.ends.iter().map(|(at, _)| M::nearest(*at)).collect()
}
