//! Pictures of a log: k over α on the curves of laws, e over the phase, and where energy is gained.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

mod energy;
mod phase;
mod ratio;

pub(super) use energy::energy;
pub(super) use phase::phase;
pub(super) use ratio::ratio;

use crate::picture::{Axis, Frame, Point};

/// Pixels of a picture.
const WIDTH: f64 = 860.0;
const HEIGHT: f64 = 400.0;

/// The one plot of a picture, below its legend.
const fn frame(top: f64, beside: f64) -> Frame {
    Frame { at: (0.0, top), size: (WIDTH, HEIGHT - top), head: 10.0, beside }
}

/// The axis of α, from a tenth to ten or as far as the values go, within six decades; and its ends.
fn alpha_axis(values: impl Iterator<Item = f64>) -> (Axis, Point) {
    let ends =
        values.fold((0.1_f64, 10.0_f64), |(low, high), alpha| (low.min(alpha), high.max(alpha)));
    let (low, high) = (ends.0.max(1e-3), ends.1.min(1e3));
    (Axis::logarithmic("alpha", (low, high), number), (low, high))
}

/// The range of values, with room about it and with zero or one value told apart.
fn range(values: impl Iterator<Item = f64>, (least, greatest): Point) -> Point {
    let inside = values.filter(|value| value.is_finite());
    let (low, high) =
        inside.fold((least, greatest), |(low, high), value| (low.min(value), high.max(value)));
    let room = 0.05 * (high - low);
    (low - room, high + room)
}

/// A number at an axis.
fn number(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text.is_empty() || text == "-" || text == "-0" { "0".to_owned() } else { text.to_owned() }
}
