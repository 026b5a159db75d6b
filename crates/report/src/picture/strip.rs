//! Strips: for each of many cases one row along a common axis, with what holds where.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use super::{Anchor, Canvas, Ink, NUMBERS, Pen, Point, WORDS, count};

/// A row: its name, and bars that share its height from above to below.
pub(crate) struct Strip {
    pub(crate) name: String,
    pub(crate) bars: Vec<Bar>,
}

/// A bar: where it is defined, and where something holds; shares of the axis.
pub(crate) struct Bar {
    pub(crate) domain: Point,
    pub(crate) parts: Vec<(Point, Ink)>,
}

/// From one row to the next, and the height of what is below the last.
const ROW: f64 = 25.0;
const BELOW: f64 = 46.0;
/// What is narrower would not be seen.
const LEAST: f64 = 2.0;

/// How high strips are.
pub(crate) fn height_of(strips: &[Strip]) -> f64 {
    ROW * count(strips.len()) + BELOW
}

/// Draws strips with names up to `split` and the axis from there to `right`. `ticks` are shares of the axis with their
/// numbers, and `band` is the part of it that matters most.
pub(crate) fn strips(
    canvas: &mut Canvas,
    (top, split, right): (f64, f64, f64),
    strips: &[Strip],
    (label, ticks, band): (&str, &[(f64, String)], Point),
) {
    let x = |share: f64| split + share.clamp(0.0, 1.0) * (right - split);
    let bottom = top + ROW * count(strips.len());
    canvas.boxes(&[((x(band.0), top), (x(band.1), bottom))], Ink::Grid, 0.5);
    let grid: Vec<Vec<Point>> =
        ticks.iter().map(|(share, _)| vec![(x(*share), top), (x(*share), bottom)]).collect();
    canvas.lines(grid.iter().map(Vec::as_slice), Pen::new(Ink::Grid, 1.0));
    for (share, name) in ticks {
        canvas.words((x(*share), bottom + 12.0), name, NUMBERS, Anchor::Middle);
    }
    canvas.words(((split + right) / 2.0, bottom + 31.0), label, WORDS, Anchor::Middle);
    for (index, strip) in strips.iter().enumerate() {
        let y = top + ROW * count(index);
        canvas.words((split - 10.0, y + ROW / 2.0), &strip.name, NUMBERS, Anchor::End);
        let thick = (ROW - 7.0) / count(strip.bars.len().max(1));
        for (index, bar) in strip.bars.iter().enumerate() {
            let (above, below) =
                (y + 3.0 + thick * count(index), y + 2.0 + thick * count(index + 1));
            let middle = f64::midpoint(above, below);
            let domain = [(x(bar.domain.0), middle), (x(bar.domain.1), middle)];
            canvas.line(&domain, Pen::new(Ink::Quiet, 1.0).faint(0.5));
            for ((from, to), ink) in &bar.parts {
                let (from, to) = (x(*from), x(*to));
                let more = ((LEAST - (to - from)) / 2.0).max(0.0);
                canvas.boxes(&[((from - more, above), (to + more, below))], *ink, 1.0);
            }
        }
    }
}
