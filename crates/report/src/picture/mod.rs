//! The picture kit: a canvas, axes, panels, legends, strips and staircases, as SVG.
//!
//! Places are floats, so that a curve does not wobble on whole pixels. Every picture has a title and a description for
//! those who do not see it; its ink is `currentColor`, and its style has a dark version. The bytes depend on the
//! arguments alone: numbers are written to a hundredth of a pixel.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

mod axis;
mod callout;
mod canvas;
mod clip;
mod legend;
mod palette;
mod panel;
#[cfg(test)]
pub(crate) mod seen;
mod strip;
mod trace;

pub(crate) use axis::Axis;
pub(crate) use callout::{Callout, callouts};
pub(crate) use canvas::{Anchor, Canvas};
pub(crate) use clip::{Window, dense, height};
pub(crate) use legend::{Key, Shape, legend, mark};
pub(crate) use palette::{Ink, Pen};
pub(crate) use panel::{Frame, Panel, staircase};
pub(crate) use strip::{Bar, Strip, height_of, strips};

/// A place on the canvas, in pixels from its upper left corner; or a point of a plot.
pub(crate) type Point = (f64, f64);

/// Sizes of type: at a width of 170 mm of 960 pixels the smallest is 6 points on paper.
pub(crate) const TITLE: f64 = 17.0;
pub(crate) const WORDS: f64 = 13.0;
pub(crate) const NUMBERS: f64 = 12.0;
/// From one line of words to the next.
pub(crate) const LEADING: f64 = 17.0;

/// A count as a length.
pub(crate) fn count(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}

/// About how long words are in sans-serif of this size.
pub(crate) fn length(words: &str, size: f64) -> f64 {
    0.56 * size * count(words.chars().count())
}

/// Words in lines of so many characters.
pub(crate) fn broken(words: &str, columns: usize) -> Vec<String> {
    let lines = crate::sheet::wrapped("", words, columns);
    lines.into_iter().filter(|line| !line.is_empty()).collect()
}
