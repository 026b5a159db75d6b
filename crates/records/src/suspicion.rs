//! Signs that a whole log is in other units or in other axes.

use crate::rejection::Rejections;
use crate::seen::Seen;
use crate::statistics::median;

/// What a log is suspected of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Suspicion {
    /// J·Δω is 180/π times r × p: spins in degrees a second.
    Degrees,
    /// J·Δω is 30/π times r × p: spins in revolutions a minute.
    Revolutions,
    /// J·Δω is −r × p: spins count the other way, from y to x, or y points down.
    Turned,
    /// J·Δω is this much of r × p in half of the rows: an arm, a mass or an inertia is off.
    Lever(f64),
    /// Most bodies move apart before they collide: y points down, or the normal into body 2.
    Down,
}

/// By how much a ratio may differ from that of a unit.
const ALIKE: f64 = 0.02;
/// A lever that is off by less is left to the check of moments, and so is one that is not the same,
/// to a tenth of that, in most rows.
const OFF: f64 = 5e-3;

/// What the rows are suspected of.
#[must_use]
pub fn suspicions(rows: &[Seen], rejections: &Rejections, accepted: u64) -> Vec<Suspicion> {
    let mut found = Vec::new();
    if rejections.of_kind("the bodies move apart") > accepted {
        found.push(Suspicion::Down);
    }
    let turned: Vec<f64> =
        rows.iter().map(|seen| seen.turned).filter(|turned| turned.is_finite()).collect();
    let told = turned.len();
    let Some(middle) = median(turned.clone()) else { return found };
    let alike = |ratio: f64| (middle / ratio - 1.0).abs() < ALIKE;
    let same = turned.iter().filter(|turned| (*turned / middle - 1.0).abs() < ALIKE).count();
    if told < 3 || same * 2 < told {
        return found;
    }
    if alike(180.0 / std::f64::consts::PI) {
        found.push(Suspicion::Degrees);
    } else if alike(30.0 / std::f64::consts::PI) {
        found.push(Suspicion::Revolutions);
    } else if alike(-1.0) {
        found.push(Suspicion::Turned);
    } else if (middle - 1.0).abs() > OFF
        && turned.iter().filter(|turned| (*turned - middle).abs() < OFF / 10.0).count() * 2 > told
    {
        found.push(Suspicion::Lever(middle));
    }
    found
}
