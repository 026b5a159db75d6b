//! Formulas of two inputs, over a grid of binades.

use crate::{Axis, Fault, Format, Sample};

use super::search::Asked;
use super::{Point, Subject};

/// Cells along each side at most.
const SIDE: usize = 56;

/// One input pair of a plane.
#[derive(Clone, Debug)]
pub struct Cell {
    /// the binades of both inputs
    pub binades: (i64, i64),
    /// hundredths of bits lost, and the fault
    pub sample: Sample,
}

/// One formula of two inputs in one format.
#[derive(Clone, Debug)]
pub struct Plane {
    /// index in [`Subject::formulas`]
    pub formula: usize,
    /// the format's name
    pub format: &'static str,
    /// its precision in bits
    pub precision: u32,
    /// the grid, by the first input and then the second
    pub cells: Vec<Cell>,
    /// per fault that occurs: how many cells, and the first pair of inputs
    pub faults: Vec<(Fault, usize, (Point, Point))>,
    /// the worst pair of inputs, with the hundredths of bits lost
    pub worst: ((Point, Point), i64),
}

/// Examines a formula; `None` if no cell is in its domain.
pub(super) fn examine<F: Format>(subject: &Subject, index: usize) -> Option<Plane> {
    let formula = subject.formulas.get(index)?;
    let [first, second] = formula.inputs.as_slice() else { return None };
    let places = |input: &crate::Input| input.axis::<F>(false).map(|axis| grid::<F>(&axis));
    let (first, second) = (places(first)?, places(second)?);
    let asked = Asked::<F>::new(formula);
    let mut cells = Vec::new();
    let mut faults: Vec<(Fault, usize, (Point, Point))> = Vec::new();
    let mut worst: Option<((u64, u64), Sample)> = None;
    let binade = |place: u64| F::at(place).exactly().map(|x| x.binade());
    let point = |place: u64| Point::of::<F>(false, place);
    for &a in &first {
        for &b in &second {
            let binades = (binade(a)?, binade(b)?);
            let Some((sample, _)) = asked.at(&[(false, a), (false, b)]) else { continue };
            cells.push(Cell { binades, sample });
            if let Some(fault) = sample.fault {
                match faults.iter_mut().find(|(known, ..)| *known == fault) {
                    Some((_, count, _)) => *count += 1,
                    None => faults.push((fault, 1, (point(a), point(b)))),
                }
            }
            let key = |sample: &Sample| (sample.fault, sample.lost);
            if worst.as_ref().is_none_or(|(_, known)| key(&sample) > key(known)) {
                worst = Some(((a, b), sample));
            }
        }
    }
    faults.sort_by_key(|(fault, ..)| std::cmp::Reverse(*fault));
    let ((a, b), sample) = worst?;
    Some(Plane {
        formula: index,
        format: F::NAME,
        precision: F::PRECISION,
        cells,
        faults,
        worst: ((point(a), point(b)), sample.lost),
    })
}

/// One float of every few binades, normal ones and subnormal ones.
fn grid<F: Format>(axis: &Axis) -> Vec<u64> {
    let mut all: Vec<u64> = Vec::new();
    let mut last = None;
    for place in axis.places::<F>(1) {
        let binade = F::at(place).exactly().filter(|x| !x.is_zero()).map(|x| x.binade());
        if binade.is_some() && binade != last {
            last = binade;
            all.push(place);
        } else if let (Some(_), Some(latest)) = (binade, all.last_mut()) {
            // the fourth place of a binade has an ordinary significand
            if (*latest).is_power_of_two() || place - *latest < 3 {
                *latest = place;
            }
        }
    }
    let step = all.len().div_ceil(SIDE).max(1);
    all.into_iter().step_by(step).collect()
}
