//! The worst input that a search finds, and its exact error.
#![allow(
    clippy::float_arithmetic,
    reason = "the search is a heuristic; what it finds is measured exactly"
)]

use kane_number::{DoubleDouble, Number as _, Ordered as _};

use crate::draw::Random;
use crate::exact::{Compared, compared};
use crate::machine::{Machine, Runner, compares};
use crate::rigor::{Cell, Goal};
use crate::{Core, Operation, Precision, Program};

/// How hard to search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// points that are drawn
    pub drawn: usize,
    /// points from which the search climbs
    pub climbs: usize,
    /// rounds of a climb
    pub rounds: usize,
}

impl Default for Effort {
    fn default() -> Self {
        Self { drawn: 6_000, climbs: 10, rounds: 60 }
    }
}

/// A point at which a formula is wrong, and by how much, exactly.
#[derive(Clone, Debug)]
pub struct Worst<M> {
    /// the inputs
    pub at: Vec<M>,
    /// what the machine returns
    pub computed: M,
    /// beside the exact value
    pub compared: Compared,
}

impl<M: Machine> Worst<M> {
    /// The error in the unit of a goal, at least.
    #[must_use]
    pub fn error(&self, goal: Goal) -> f64 {
        match goal {
            Goal::Absolute => self.compared.error,
            Goal::Ulps => self.compared.ulps,
        }
    }

    /// The same, at most.
    #[must_use]
    pub fn error_at_most(&self, goal: Goal) -> f64 {
        match goal {
            Goal::Absolute => self.compared.error_at_most,
            Goal::Ulps => self.compared.ulps_at_most,
        }
    }
}

/// Where a pair of doubles has no room for its second one, and its difference from a float is 0: below this errors
/// are measured instead of estimated.
const DEEP: f64 = f64::MIN_POSITIVE / f64::EPSILON;

/// Points whose errors are measured exactly in the end.
const MEASURED: usize = 24;

/// Looks for the input with the greatest error: in the boxes given, at the ends of the domain and next to
/// them, everywhere, and uphill from the worst. Deterministic. The errors on the way are estimates in
/// double-double arithmetic; the result is exact. `None` if no point of the domain was found.
#[must_use]
pub fn worst<M: Machine>(
    core: &Core,
    boxes: &[Cell],
    goal: Goal,
    effort: Effort,
) -> Option<Worst<M>> {
    let whole = Cell::whole::<M>(core, crate::rigor::Inputs::Floats).ok()?;
    let places: Vec<(i64, i64)> = whole
        .ends
        .iter()
        .map(|(lower, upper)| (M::nearest(*lower).place(), M::nearest(*upper).place()))
        .collect();
    let constants = core.program.operations().iter().map(|operation| match operation {
        Operation::Number(number) => DoubleDouble::from_rational(number),
        _ => DoubleDouble::zero(),
    });
    let mut search = Search::<M> {
        core,
        goal,
        places,
        constants: constants.collect(),
        runner: Runner::new(&core.program),
        found: Vec::new(),
        results: Vec::new(),
        wide: Vec::new(),
        random: Random(0x2545_f491_4f6c_dd1d),
    };
    search.ends();
    search.draw(boxes, effort.drawn);
    search.keep(effort.climbs.max(MEASURED));
    let starts: Vec<Vec<i64>> =
        search.found.iter().take(effort.climbs).map(|(_, at)| at.clone()).collect();
    for start in starts {
        search.climb(start, effort.rounds);
    }
    search.keep(MEASURED);
    search.measured()
}

struct Search<'a, M> {
    core: &'a Core,
    goal: Goal,
    places: Vec<(i64, i64)>,
    constants: Vec<DoubleDouble>,
    runner: Runner<'a, M>,
    /// estimated errors, and where
    found: Vec<(f64, Vec<i64>)>,
    results: Vec<M>,
    wide: Vec<Option<DoubleDouble>>,
    random: Random,
}

impl<M: Machine> Search<'_, M> {
    /// Tries a point, and keeps it.
    fn visit(&mut self, at: Vec<i64>) -> Option<f64> {
        let error = self.estimate(&at)?;
        self.found.push((error, at));
        if self.found.len() > 4_096 {
            self.keep(256);
        }
        Some(error)
    }

    fn keep(&mut self, count: usize) {
        self.found.sort_by(|a, b| b.0.total_cmp(&a.0).then_with(|| a.1.cmp(&b.1)));
        self.found.dedup_by(|a, b| a.1 == b.1);
        self.found.truncate(count);
    }

    /// About how wrong the formula is; `None` outside of the domain.
    fn estimate(&mut self, at: &[i64]) -> Option<f64> {
        let floats: Vec<M> = at.iter().map(|place| M::at(*place)).collect();
        self.runner.run(&floats, &mut self.results);
        let inputs: Vec<DoubleDouble> =
            floats.iter().map(|x| DoubleDouble::from(x.wide())).collect();
        wide(&self.core.program, &self.constants, &inputs, &mut self.wide);
        let assumed = self.core.assumed.iter().all(|test| {
            let compare = |rel, a: usize, b: usize| {
                let (a, b) = (self.results.get(a)?, self.results.get(b)?);
                Some(compares(rel, a.partial_cmp(b)))
            };
            test.holds(&compare) == Some(true)
        });
        if !assumed {
            return None;
        }
        let computed = self.results.get(self.core.root)?;
        let exact = self.wide.get(self.core.root).copied().flatten();
        let Some(exact) = exact.filter(|exact| exact.is_finite()) else {
            // beyond double-double: worth a look, but not before what is known to be wrong
            return Some(if computed.finite() { 0.0 } else { f64::MAX });
        };
        if !computed.finite() {
            return Some(f64::MAX);
        }
        let size = exact.high().abs();
        if M::FORMAT == Precision::F64 && size > 0.0 && size < DEEP {
            let found = compared(&self.core.program, self.core.root, &floats, *computed)?;
            return Some(match self.goal {
                Goal::Absolute => found.error_at_most,
                Goal::Ulps => found.ulps,
            });
        }
        let error = (DoubleDouble::from(computed.wide()) - exact).high().abs();
        Some(match self.goal {
            Goal::Absolute => error,
            Goal::Ulps => {
                let unit = exact.high().abs() * epsilon::<M>();
                error / unit.max(crate::rigor::upward::power(M::LEAST_EXPONENT))
            }
        })
    }

    /// All corners of the domain, and floats next to them at distances that double.
    fn ends(&mut self) {
        let count = self.places.len();
        for corner in 0..(1_usize << count.min(10)) {
            let at = |search: &Self, index: usize| {
                let &(first, last) = search.places.get(index).unwrap_or(&(0, 0));
                if corner >> (index % 10) & 1 == 0 { first } else { last }
            };
            let point: Vec<i64> = (0..count).map(|index| at(self, index)).collect();
            self.visit(point.clone());
            if corner >= 64 {
                continue;
            }
            for index in 0..count {
                let &(first, last) = self.places.get(index).unwrap_or(&(0, 0));
                for bit in 0..M::PRECISION + 6 {
                    // several in every doubling, since errors come and go from float to float
                    for _ in 0..if count == 1 { 12 } else { 3 } {
                        let within = 1_u64 << bit;
                        let drawn = within + self.random.next() % within;
                        let step = i64::try_from(drawn).unwrap_or(i64::MAX);
                        let mut moved = point.clone();
                        if let Some(place) = moved.get_mut(index) {
                            let inward = if *place == first {
                                place.saturating_add(step)
                            } else {
                                place.saturating_sub(step)
                            };
                            *place = inward.clamp(first, last);
                        }
                        self.visit(moved);
                    }
                }
            }
        }
    }

    /// Points of boxes, of the domain by value, and of the domain by the order of floats.
    fn draw(&mut self, boxes: &[Cell], count: usize) {
        for turn in 0..count {
            let from = boxes.get(turn / 3 % boxes.len().max(1)).filter(|_| turn % 3 == 0);
            let mut point = Vec::with_capacity(self.places.len());
            for index in 0..self.places.len() {
                let &(first, last) = self.places.get(index).unwrap_or(&(0, 0));
                let (low, high) = match from.and_then(|cell| cell.ends.get(index)) {
                    Some(&(low, high)) => (M::nearest(low).place(), M::nearest(high).place()),
                    None => (first, last),
                };
                let place = self.random.place::<M>((low, high), turn % 3 != 2);
                point.push(place.clamp(first, last));
            }
            self.visit(point);
        }
    }

    /// To worse points nearby, in steps of every size.
    fn climb(&mut self, start: Vec<i64>, rounds: usize) {
        let Some(mut best) = self.estimate(&start) else { return };
        let mut point = start;
        let mut size = M::PRECISION + 2;
        for _ in 0..rounds {
            let mut next: Option<(f64, Vec<i64>)> = None;
            for _ in 0..16 {
                let mut moved = point.clone();
                for (place, &(first, last)) in moved.iter_mut().zip(&self.places) {
                    if !self.random.next().is_multiple_of(3) {
                        let bit = self.random.next() % u64::from(size.max(2));
                        let step = self.random.upto(1 << bit.min(58));
                        let step = if self.random.next().is_multiple_of(2) { step } else { -step };
                        *place = place.saturating_add(step).clamp(first, last);
                    }
                }
                if let Some(error) = self.estimate(&moved)
                    && error > next.as_ref().map_or(best, |(error, _)| *error)
                {
                    next = Some((error, moved));
                }
            }
            match next {
                Some((error, moved)) => {
                    self.found.push((error, moved.clone()));
                    (best, point) = (error, moved);
                }
                None => size = size.saturating_sub(4).max(6),
            }
        }
    }

    /// The worst of those that are left, measured exactly.
    fn measured(&mut self) -> Option<Worst<M>> {
        let mut worst: Option<Worst<M>> = None;
        for (_, at) in std::mem::take(&mut self.found) {
            let at: Vec<M> = at.iter().map(|place| M::at(*place)).collect();
            self.runner.run(&at, &mut self.results);
            let Some(&computed) = self.results.get(self.core.root) else { continue };
            let found = compared(&self.core.program, self.core.root, &at, computed);
            let Some(compared) = found else { continue };
            let found = Worst { at, computed, compared };
            if worst.as_ref().is_none_or(|known| found.error(self.goal) > known.error(self.goal)) {
                worst = Some(found);
            }
        }
        worst
    }
}

/// The distance from 1 to the next float.
fn epsilon<M: Machine>() -> f64 {
    crate::rigor::upward::power(1 - i64::from(M::PRECISION))
}

/// All results in double-double arithmetic.
fn wide(
    program: &Program,
    constants: &[DoubleDouble],
    inputs: &[DoubleDouble],
    results: &mut Vec<Option<DoubleDouble>>,
) {
    results.clear();
    for (operation, constant) in program.operations().iter().zip(constants) {
        let at = |index: usize| results.get(index).copied().flatten();
        let less = |a: DoubleDouble, b: DoubleDouble| a.compare(&b).is_less() == Some(true);
        let result = match *operation {
            Operation::Number(_) => Some(*constant),
            Operation::Input(input) => inputs.get(input).copied(),
            Operation::Neg(a) => at(a).map(|a| -a),
            Operation::Add(a, b) => at(a).zip(at(b)).map(|(a, b)| a + b),
            Operation::Sub(a, b) => at(a).zip(at(b)).map(|(a, b)| a - b),
            Operation::Mul(a, b) => at(a).zip(at(b)).map(|(a, b)| a * b),
            Operation::Div(a, b) => at(a).zip(at(b)).and_then(|(a, b)| a.checked_div(&b)),
            Operation::Sqrt(a) => at(a).and_then(DoubleDouble::sqrt),
            Operation::Fma(a, b, c) => {
                at(a).zip(at(b)).zip(at(c)).map(|((a, b), c)| a.mul_add(&b, &c))
            }
            Operation::Abs(a) => at(a).map(|a| if a.high() < 0.0 { -a } else { a }),
            Operation::Min(a, b) => at(a).zip(at(b)).map(|(a, b)| if less(b, a) { b } else { a }),
            Operation::Max(a, b) => at(a).zip(at(b)).map(|(a, b)| if less(a, b) { b } else { a }),
            Operation::If(ref test, a, b) => {
                let compare = |rel, a, b| {
                    let (a, b) = (at(a)?, at(b)?);
                    let order = if less(a, b) {
                        std::cmp::Ordering::Less
                    } else if less(b, a) {
                        std::cmp::Ordering::Greater
                    } else {
                        std::cmp::Ordering::Equal
                    };
                    Some(compares(rel, Some(order)))
                };
                test.holds(&compare).and_then(|holds| at(if holds { a } else { b }))
            }
        };
        results.push(result);
    }
}
