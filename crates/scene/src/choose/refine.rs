//! Steps as fine as the tolerance asks for.

use kane_number::{Interval, Lane as _};

use super::evaluate::evaluate;
use super::model::Mechanics;
use crate::coordinate::Coordinate;
use crate::scene::Scene;

/// The finest grid that is tried, by the usual one.
const FINEST: usize = 16;
/// The part of the tolerance that the steps may take.
const SHARE: f64 = 0.25;
/// A grid twice as fine is worth its cost if the error falls to this part of it.
const WORTH: f64 = 0.7;

/// The scene with the grid of its compliant process refined until the estimated error is a quarter of
/// the tolerance, or finer steps make little difference.
pub(super) fn refined(scene: &Scene, mechanics: Mechanics) -> Scene {
    let with = |finer: usize| Scene { finer, ..scene.clone() };
    let mut best = with(1);
    if mechanics != Mechanics::Compliant {
        return best;
    }
    let Some(mut least) = error(&best, mechanics) else { return best };
    let mut finer = 2;
    while least > SHARE && finer <= FINEST {
        let next = with(finer);
        match error(&next, mechanics) {
            Some(error) if error < WORTH * least => (best, least) = (next, error),
            _ => break,
        }
        finer *= 2;
    }
    best
}

/// The worst estimated error by its tolerance; `None` where no process was needed, or none is known.
fn error(scene: &Scene, mechanics: Mechanics) -> Option<f64> {
    let nominal = scene.nominal().map(Coordinate::enclosed);
    let found = evaluate::<Interval>(scene, &nominal, mechanics, 1).ok()?;
    let ratios = found.values.iter().zip(&scene.asked);
    let worst = ratios
        .map(|(value, asked)| value.width() / 2.0 / asked.tolerance.to_f64())
        .fold(0.0, f64::max);
    (found.estimated && worst.is_finite()).then_some(worst)
}
