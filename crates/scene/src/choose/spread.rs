//! How far the stated uncertainty moves an answer.

use kane_number::{Interval, Lane as _, Number as _, Rational};

use super::evaluate::{Failed, Found, at, evaluate};
use super::model::Mechanics;
use crate::scene::{Scene, Setup};
use crate::world::World;

/// How far the stated uncertainty moves an answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// To either side, in the unit of the quantity: no further, if it is enclosed.
    pub by: f64,
    /// Measured in floats at states within the uncertainty: the answer moves at least so far.
    pub at_least: f64,
    /// Enclosed by intervals; else measured at the corners of the uncertainty, which is heuristic.
    pub enclosed: bool,
}

impl Spread {
    /// Whether the inputs leave more open than was asked; the tolerance in the unit of the quantity.
    #[must_use]
    pub fn exceeds(&self, tolerance: f64) -> bool {
        self.at_least > tolerance
    }

    /// Whether it is not known that they do not.
    #[must_use]
    pub fn may_exceed(&self, tolerance: f64) -> bool {
        self.by > tolerance
    }
}

/// A part of the stated uncertainty: the ends of every uncertain number, in the order of the scene.
#[derive(Clone, Debug)]
pub(super) struct Part(Vec<(Rational, Rational)>);

impl Part {
    /// All of it.
    pub(super) fn whole(scene: &Scene) -> Self {
        let mut ends = Vec::new();
        scene.setup.map(|stated| {
            if !stated.is_certain() {
                ends.push((&stated.value - &stated.within, &stated.value + &stated.within));
            }
        });
        Self(ends)
    }

    /// The scene within this part.
    pub(super) fn enclosed(&self, scene: &Scene) -> Setup<Interval> {
        let mut ends = self.0.iter();
        scene.setup.map(|stated| {
            if stated.is_certain() {
                return Interval::from_rational(&stated.value);
            }
            ends.next().map_or(Interval::WHOLE, |(low, high)| {
                Interval::from_rational(low).hull(&Interval::from_rational(high))
            })
        })
    }

    /// In two, across one of the numbers.
    pub(super) fn halves(&self, across: usize) -> [Self; 2] {
        let (low, high) = &self.0[across];
        let middle = (low + high) / Rational::one().double();
        let with = |ends| {
            let mut part = self.clone();
            part.0[across] = ends;
            part
        };
        [with((low.clone(), middle.clone())), with((middle, high.clone()))]
    }

    /// The number that has been halved least.
    pub(super) fn widest(&self, whole: &Self) -> usize {
        let share = |i: usize| {
            let width = |part: &Self| &part.0[i].1 - &part.0[i].0;
            (width(self) / width(whole)).to_f64()
        };
        (0..self.0.len()).max_by(|a, b| share(*a).total_cmp(&share(*b))).unwrap_or(0)
    }
}

/// A part with what is enclosed of the answers over it; `None` where intervals cannot tell.
struct Enclosed {
    part: Part,
    values: Option<Vec<Interval>>,
}

/// Impacts that may be followed in all, over all parts.
const MOST_IMPACTS: usize = 6_000;
/// And parts.
const MOST_PARTS: usize = 400;
/// And at least so many, even where each costs a process.
const FEWEST_PARTS: usize = 8;

/// How many parts of a scene with so many impacts may be looked at.
pub(super) fn affordable(
    scene: &Scene,
    mechanics: Mechanics,
    found: &Result<Found<Interval>, Failed>,
) -> usize {
    if !mechanics.is_counted() {
        return FEWEST_PARTS;
    }
    let impacts = found.as_ref().ok().and_then(|found| found.end.as_ref()).map_or(1, |e| e.impacts);
    let impacts = usize::try_from(impacts).unwrap_or(usize::MAX);
    // a corner is looked for among all corners and walls, each in steps
    let looks = match &scene.setup {
        Setup::Bodies(World { corners: Some(corners), walls, planes, .. }) => {
            8 * corners.0.len() * (walls.len() + planes.len()).max(1)
        }
        _ => 1,
    };
    (MOST_IMPACTS / impacts.max(1) / looks).clamp(FEWEST_PARTS, MOST_PARTS)
}

/// What is enclosed has come near enough to what was measured.
const NEAR: f64 = 1.05;

/// Encloses the answers over the whole uncertainty, in parts: one enclosure over all of it is too wide,
/// because it forgets that what comes in twice is the same both times. The part that reaches
/// furthest is halved until what is enclosed is within the tolerance, or what was measured inside is
/// beyond it, or both are near each other, or the budget is spent.
///
/// From corners alone where intervals cannot go; `None` if nothing can be told.
pub(super) fn spread(scene: &Scene, mechanics: Mechanics, budget: usize) -> Option<Vec<Spread>> {
    let measured = measured(scene, mechanics);
    if let Some(spread) = enclosed(scene, mechanics, budget, measured.as_deref()) {
        return Some(spread);
    }
    let measured = measured?;
    Some(measured.into_iter().map(|by| Spread { by, at_least: by, enclosed: false }).collect())
}

/// Half the width of what floats answer at the corners.
fn measured(scene: &Scene, mechanics: Mechanics) -> Option<Vec<f64>> {
    let middle = at(scene, mechanics, &scene.nominal())?;
    let mut ends: Vec<[f64; 2]> = middle.iter().map(|value| [*value; 2]).collect();
    for corner in scene.corners() {
        for (ends, value) in ends.iter_mut().zip(at(scene, mechanics, &corner)?) {
            *ends = [ends[0].min(value), ends[1].max(value)];
        }
    }
    Some(ends.into_iter().map(|[low, high]| (high - low) / 2.0).collect())
}

fn enclosed(
    scene: &Scene,
    mechanics: Mechanics,
    budget: usize,
    measured: Option<&[f64]>,
) -> Option<Vec<Spread>> {
    let whole = Part::whole(scene);
    let mut estimated = false;
    let mut look = |part: Part| {
        let found = evaluate(scene, &part.enclosed(scene), mechanics, 1).ok();
        estimated |= found.as_ref().is_some_and(|found| found.estimated);
        let finite = |found: &Found<Interval>| found.values.iter().all(|v| v.width().is_finite());
        Enclosed { part, values: found.filter(finite).map(|found| found.values) }
    };
    let mut parts = vec![look(whole.clone())];
    let at_least = |quantity: usize| measured.map_or(0.0, |measured| measured[quantity]);
    for _ in 0..budget {
        let next = match parts.iter().position(|part| part.values.is_none()) {
            Some(unknown) => Some(unknown),
            None => furthest(scene, &parts, &at_least),
        };
        let Some(next) = next else { break };
        let Enclosed { part, .. } = parts.swap_remove(next);
        let across = part.widest(&whole);
        parts.extend(part.halves(across).map(&mut look));
    }
    let hulls = hulls(scene, &parts)?;
    let spreads = hulls.iter().enumerate().map(|(quantity, hull)| {
        let by = hull.width() / 2.0;
        Spread { by, at_least: at_least(quantity).min(by), enclosed: true }
    });
    (!estimated).then(|| spreads.collect())
}

/// Of each quantity, all that the parts may answer.
fn hulls(scene: &Scene, parts: &[Enclosed]) -> Option<Vec<Interval>> {
    let mut hulls: Option<Vec<Interval>> = None;
    for part in parts {
        let values = part.values.as_ref()?;
        hulls = Some(match hulls {
            None => values.clone(),
            Some(hulls) => hulls.iter().zip(values).map(|(a, b)| a.hull(b)).collect(),
        });
    }
    hulls.filter(|hulls| hulls.len() == scene.asked.len())
}

/// The part to be halved: one that reaches furthest in the quantity that is least well known.
fn furthest(scene: &Scene, parts: &[Enclosed], at_least: &dyn Fn(usize) -> f64) -> Option<usize> {
    let hulls = hulls(scene, parts)?;
    let open = |quantity: usize| {
        let (by, tolerance) =
            (hulls[quantity].width() / 2.0, scene.asked[quantity].tolerance.to_f64());
        let told = by <= tolerance || at_least(quantity) > tolerance;
        let excess = by / at_least(quantity);
        if told && excess > 2.0 {
            1.0
        } else if told || excess <= NEAR {
            0.0
        } else {
            excess
        }
    };
    let quantity = (0..hulls.len()).max_by(|a, b| open(*a).total_cmp(&open(*b)))?;
    if open(quantity) == 0.0 {
        return None;
    }
    // the part at either end, whichever is the larger one
    let reach = |part: &Enclosed| {
        let values = part.values.as_ref();
        values.map_or(f64::INFINITY, |values| {
            let (value, hull) = (values[quantity], hulls[quantity]);
            let to_end = (value.lower() - hull.lower()).min(hull.upper() - value.upper());
            value.width() - to_end * 1e3
        })
    };
    (0..parts.len()).max_by(|a, b| reach(&parts[*a]).total_cmp(&reach(&parts[*b])))
}
