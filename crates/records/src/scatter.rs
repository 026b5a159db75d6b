//! Impacts as points of a picture.

use crate::friction::FrictionLaw;
use crate::seen::Seen;
use crate::statistics::median;

/// An impact in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// α = μ·W_tt·p_n/(2·|s|), s the slip without friction and p_n as measured: 1/2 where sliding friction
    /// just ends the slip; `None` without slip or μ
    pub alpha: Option<f64>,
    /// k = u_t⁺/s
    pub ratio: Option<f64>,
    /// e as measured
    pub restitution: Option<f64>,
    /// e as stated
    pub stated: Option<f64>,
    /// the phase within the step
    pub phase: Option<f64>,
    /// ΔT by the energy before
    pub gain: f64,
    /// whether energy rises beyond its tolerance
    pub gains: bool,
}

/// Spots of a picture at most.
const MOST: usize = 600;

impl Spot {
    fn of(seen: &Seen) -> Self {
        let slip = seen.slip_without_friction();
        let slips = slip.abs() > 2.0 * seen.within[0] && seen.normal > 2.0 * seen.within[3];
        let friction = seen.given.friction.filter(|_| slips);
        Self {
            alpha: friction.map(|mu| mu * seen.mobility[0] * seen.normal / (2.0 * slip.abs())),
            ratio: slips.then(|| seen.slip_after / slip),
            restitution: seen.observed_restitution(),
            stated: seen.given.restitution,
            phase: seen.given.phase,
            gain: seen.gain.0,
            gains: seen.gain.1,
        }
    }
}

/// The rows as spots, evenly chosen where they are many; those that gain energy are all there, as far
/// as there is room for as many again.
#[must_use]
pub fn spots(rows: &[Seen]) -> Vec<Spot> {
    let stride = rows.len().div_ceil(MOST).max(1);
    let mut spots: Vec<Spot> = rows.iter().step_by(stride).map(Spot::of).collect();
    if stride > 1 {
        let others = rows.iter().enumerate().filter(|(place, _)| place % stride != 0);
        let gaining = others.filter(|(_, seen)| seen.gain.1);
        spots.extend(gaining.take(MOST).map(|(_, seen)| Spot::of(seen)));
    }
    spots
}

/// k of a law of friction at an α, on a contact that does not couple, with this e: by the law's own code
/// on such an impact.
#[must_use]
pub fn curve(law: FrictionLaw, restitution: f64, alpha: f64) -> Option<f64> {
    let mut seen = Seen::plain();
    seen.given.restitution = Some(restitution);
    // μ = 1, W_tt = 1 and u_t = 1, so that α is p_n/2
    seen.normal = 2.0 * alpha;
    Some(1.0 + law.impulse(&seen)?)
}

/// The stated e of the rows, each once, at most three of them: the least, the median and the greatest.
#[must_use]
pub fn stated(rows: &[Spot]) -> Vec<f64> {
    let mut values: Vec<f64> =
        rows.iter().filter_map(|spot| spot.stated.or(spot.restitution)).collect();
    values.sort_by(f64::total_cmp);
    let (Some(least), Some(greatest)) = (values.first().copied(), values.last().copied()) else {
        return Vec::new();
    };
    let middle = median(values).unwrap_or(least);
    let mut few = vec![least, middle, greatest];
    few.dedup();
    few
}
