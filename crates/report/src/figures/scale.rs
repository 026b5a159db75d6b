//! An axis for the plotting library, which bears numbers where it is told to.
//!
//! Of its own choice the library leaves out the ends of a logarithmic axis.

use std::ops::Range;

use plotters::coord::combinators::{IntoLogRange, LogCoord};
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;

use super::Axis;

pub(super) struct Scale {
    range: Range<f64>,
    ticks: Vec<f64>,
    is_logarithmic: bool,
}

impl From<&Axis> for Scale {
    fn from(axis: &Axis) -> Self {
        let (from, to) = axis.range;
        let ticks = axis.ticks.clone();
        Self { range: from..to, ticks, is_logarithmic: axis.is_logarithmic }
    }
}

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        if self.is_logarithmic {
            LogCoord::from(self.range.clone().log_scale()).map(value, limit)
        } else {
            RangedCoordf64::from(self.range.clone()).map(value, limit)
        }
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() { Vec::new() } else { self.ticks.clone() }
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for Scale {
    fn format(value: &f64) -> String {
        value.to_string().replace('-', "−")
    }
}
