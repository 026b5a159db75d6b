//! The search over points of any number of inputs and of either sign.

use crate::{Axis, Fault, Format, Formula, Input, Plain, Sample, judge};

use super::scan::{reference, reference_value};
use super::{Point, Subject};

/// Points that are drawn, and binades around 1 from which two thirds of them are.
const DRAWN: u64 = 3_000;
const BINADES: i64 = 16;
/// Points through which lines are followed along each input, and how far from 1 they go.
const LINES: usize = 12;
const REACH: i64 = 64;
/// Sound points from which worse ones are sought nearby, and how often.
const CLIMBS: usize = 6;
const ROUNDS: usize = 6;

/// An input by its sign, true below 0, and the place of its magnitude.
type Place = (bool, u64);

/// A formula ready to be asked at any point.
pub(super) struct Asked<'a, F: Format> {
    formula: &'a Formula,
    constants: Vec<Option<F>>,
}

impl<'a, F: Format> Asked<'a, F> {
    pub(super) fn new(formula: &'a Formula) -> Self {
        Self { formula, constants: formula.program.constants(&Plain::<F>::new()) }
    }

    /// The judgement and the sign of the exact value; `None` outside the domain. A formula without
    /// any value in floats, where no case applies, counts as NaN.
    pub(super) fn at(&self, point: &[Place]) -> Option<(Sample, i8)> {
        let floats: Vec<F> = point.iter().map(|&(negative, at)| F::signed(negative, at)).collect();
        let inputs: Vec<_> = floats.iter().map(|x| x.exactly()).collect::<Option<_>>()?;
        let far = |x: &crate::DyadicNumber| if x.is_zero() { 0 } else { x.binade().unsigned_abs() };
        let wide = reference(inputs.iter().map(far).sum());
        if !self.formula.admits(&wide, &inputs) {
            return None;
        }
        let exact = reference_value(&self.formula.program, &wide, &inputs)?;
        let results =
            self.formula.program.values(&Plain::<F>::new(), &self.constants, &floats).pop();
        let sample = match results.flatten() {
            Some(computed) => judge(computed, &exact),
            None => Sample { fault: Some(Fault::Nan), lost: 100 * i64::from(F::PRECISION) },
        };
        let sign = match (exact.is_zero(), exact.is_negative()) {
            (true, _) => 0,
            (_, true) => -1,
            _ => 1,
        };
        Some((sample, sign))
    }
}

/// One formula of several inputs in one format, at points.
#[derive(Clone, Debug)]
pub struct Searched {
    /// index in [`Subject::formulas`]
    pub formula: usize,
    /// the format's name
    pub format: &'static str,
    /// its precision in bits
    pub precision: u32,
    /// how many points of the domain were tried
    pub tried: usize,
    /// per fault that was found: at how many points, and the first of them
    pub faults: Vec<(Fault, usize, Vec<Point>)>,
    /// the worst point, with the hundredths of bits lost
    pub worst: (Vec<Point>, i64),
}

/// Searches a formula that lines and planes do not cover: `None` for others, and where no point is
/// in the domain. Deterministic.
///
/// Points are drawn from all binades and signs of the inputs' ranges; through some of them lines run
/// along each input, on which the exact value is followed to its changes of sign, where a sum
/// cancels; and from the worst points the search climbs to worse neighbours.
pub(super) fn examine<F: Format>(subject: &Subject, index: usize) -> Option<Searched> {
    let formula = subject.formulas.get(index)?;
    let sides: Vec<Sides> = formula.inputs.iter().map(Sides::of::<F>).collect::<Option<_>>()?;
    let covered = sides.len() < 2 || (sides.len() == 2 && sides.iter().all(|s| s.below.is_none()));
    if covered {
        return None;
    }
    let asked = Asked::<F>::new(formula);
    let mut found = Found { asked, seen: Vec::new() };
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    for turn in 0..DRAWN {
        let point = sides.iter().map(|side| side.draw::<F>(&mut random, turn % 3 > 0)).collect();
        found.try_at(point);
    }
    let through: Vec<Vec<Place>> =
        found.seen.iter().take(LINES).map(|(point, ..)| point.clone()).collect();
    for point in &through {
        for (input, side) in sides.iter().enumerate() {
            found.follow(point, input, side);
        }
    }
    found.seen.sort_by_key(|(_, sample, _)| (sample.fault.is_some(), -sample.lost));
    let starts: Vec<(Vec<Place>, i64)> = found
        .seen
        .iter()
        .take_while(|(_, sample, _)| sample.fault.is_none())
        .take(CLIMBS)
        .map(|(point, sample, _)| (point.clone(), sample.lost))
        .collect();
    for (point, lost) in starts {
        found.climb(point, lost, &sides);
    }
    found.told(index)
}

/// The floats of an input, on both sides of 0.
struct Sides {
    above: Option<Axis>,
    below: Option<Axis>,
}

impl Sides {
    fn of<F: Format>(input: &Input) -> Option<Self> {
        let (above, below) = (input.axis::<F>(false), input.axis::<F>(true));
        (above.is_some() || below.is_some()).then_some(Self { above, below })
    }

    fn axes(&self) -> impl Iterator<Item = (bool, &Axis)> {
        let above = self.above.iter().map(|axis| (false, axis));
        above.chain(self.below.iter().map(|axis| (true, axis)))
    }

    fn holds(&self, (negative, place): Place) -> bool {
        self.axes().any(|(n, axis)| n == negative && axis.holds(place))
    }

    /// A float of either sign, evenly over the binades, near 1 if asked for.
    fn draw<F: Format>(&self, random: &mut Random, near: bool) -> Place {
        let turn = random.next();
        let some: Vec<(bool, &Axis)> = self.axes().collect();
        let choice = usize::try_from(turn % 2).unwrap_or(0) % some.len().max(1);
        let Some((negative, axis)) = some.get(choice) else { return (false, 0) };
        let (mut first, mut last) = (axis.first, axis.last);
        let window = (binade::<F>(-BINADES), binade::<F>(BINADES));
        if near && first.max(window.0) <= last.min(window.1) {
            (first, last) = (first.max(window.0), last.min(window.1));
        }
        (*negative, first + random.next() % (last - first + 1))
    }
}

/// The place of 2^exponent.
fn binade<F: Format>(exponent: i64) -> u64 {
    let biased = (exponent + F::GREATEST_EXPONENT).max(0).unsigned_abs();
    biased << (F::PRECISION - 1)
}

/// The points that were tried.
struct Found<'a, F: Format> {
    asked: Asked<'a, F>,
    seen: Vec<(Vec<Place>, Sample, i8)>,
}

impl<F: Format> Found<'_, F> {
    fn try_at(&mut self, point: Vec<Place>) -> Option<(Sample, i8)> {
        let (sample, sign) = self.asked.at(&point)?;
        self.seen.push((point, sample, sign));
        Some((sample, sign))
    }

    /// Along one input through a point: a place in each binade, and around each change of sign.
    fn follow(&mut self, point: &[Place], input: usize, side: &Sides) {
        let with = |place: Place| -> Vec<Place> {
            let replaced = |(i, old): (usize, &Place)| if i == input { place } else { *old };
            point.iter().enumerate().map(replaced).collect()
        };
        for (negative, axis) in side.axes() {
            let mut before: Option<(u64, i8)> = None;
            for exponent in -REACH..=REACH {
                // three quarters into the binade, so that powers of two do not meet by design
                let place = binade::<F>(exponent) + (3 << (F::PRECISION - 3));
                if !axis.holds(place) {
                    continue;
                }
                let Some((_, sign)) = self.try_at(with((negative, place))) else { continue };
                if let Some((low, known)) = before
                    && known != sign
                {
                    let (mut low, mut high) = (low, place);
                    while high - low > 1 {
                        let middle = low + (high - low) / 2;
                        match self.asked.at(&with((negative, middle))) {
                            Some((_, sign)) if sign == known => low = middle,
                            _ => high = middle,
                        }
                    }
                    for bit in 0..F::PRECISION - 1 {
                        for at in [high.saturating_add(1 << bit), high.saturating_sub(1 << bit)] {
                            if axis.holds(at) {
                                self.try_at(with((negative, at)));
                            }
                        }
                    }
                }
                before = Some((place, sign));
            }
        }
    }

    /// To worse neighbours, one input at a time, for as long as there are any.
    fn climb(&mut self, mut point: Vec<Place>, mut lost: i64, sides: &[Sides]) {
        for _ in 0..ROUNDS {
            let mut best: Option<(Vec<Place>, i64)> = None;
            for (input, side) in sides.iter().enumerate() {
                for bit in (0..F::PRECISION).step_by(2) {
                    for up in [true, false] {
                        let mut next = point.clone();
                        let Some((_, place)) = next.get_mut(input) else { continue };
                        let step = 1_u64 << bit;
                        *place = if up {
                            place.saturating_add(step)
                        } else {
                            place.saturating_sub(step)
                        };
                        if !next.get(input).is_some_and(|place| side.holds(*place)) {
                            continue;
                        }
                        let Some((sample, _)) = self.try_at(next.clone()) else { continue };
                        if sample.lost > best.as_ref().map_or(lost, |(_, lost)| *lost) {
                            best = Some((next, sample.lost));
                        }
                    }
                }
            }
            let Some(next) = best else { return };
            (point, lost) = next;
        }
    }

    /// What was found, the worst fault first.
    fn told(self, formula: usize) -> Option<Searched> {
        let named = |point: &[Place]| -> Vec<Point> {
            point.iter().map(|&(negative, place)| Point::of::<F>(negative, place)).collect()
        };
        let mut faults: Vec<(Fault, usize, Vec<Point>)> = Vec::new();
        for (point, sample, _) in &self.seen {
            let Some(fault) = sample.fault else { continue };
            match faults.iter_mut().find(|(known, ..)| *known == fault) {
                Some((_, count, _)) => *count += 1,
                None => faults.push((fault, 1, named(point))),
            }
        }
        faults.sort_by_key(|(fault, ..)| std::cmp::Reverse(*fault));
        let key = |sample: &Sample| (sample.fault, sample.lost);
        let mut worst = self.seen.first()?;
        for seen in &self.seen {
            if key(&seen.1) > key(&worst.1) {
                worst = seen;
            }
        }
        Some(Searched {
            formula,
            format: F::NAME,
            precision: F::PRECISION,
            tried: self.seen.len(),
            faults,
            worst: (named(&worst.0), worst.1.lost),
        })
    }
}

/// The generator `splitmix64`.
struct Random(u64);

impl Random {
    const fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }
}
