//! Figures for print: curves over one variable and maps of a plane, as SVG with their data as CSV.
//!
//! Colours are those of Okabe and Ito, and colour never tells anything alone: lines bear the number
//! of their legend and differ in their dashes, zones in their hatching, points in their shape. Legends
//! stand beside the plot.

mod curves;
mod data;
mod labels;
mod legend;
mod map;

use crate::picture;

/// A figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// What its files are called, without an ending.
    pub stem: &'static str,
    /// What it shows, in a line.
    pub title: String,
    /// What one must know to read it, a line each.
    pub notes: Vec<String>,
    /// The variable.
    pub x: Axis,
    /// The quantity.
    pub y: Axis,
    /// What is drawn.
    pub content: Content,
}

/// What a figure draws.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// Lines and points, over zones.
    Curves {
        /// Lines and points, in the order of the legend.
        series: Vec<Series>,
        /// At most two, the graver first.
        zones: Vec<Zone>,
    },
    /// Stretches of the variable, one panel a case.
    Map(Vec<Panel>),
}

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The symbol, a column's name in the data.
    pub symbol: &'static str,
    /// What it is, with its unit.
    pub label: String,
    /// From where to where it is shown; a logarithmic axis is positive.
    pub range: (f64, f64),
    /// Where it bears numbers.
    pub ticks: Vec<f64>,
    /// Whether it is logarithmic.
    pub is_logarithmic: bool,
}

/// What kind of thing a series is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A rigid law: a line.
    Law,
    /// A process in time: a line.
    Process,
    /// What was measured: points.
    Measured,
}

/// A line or points.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// What it shows; several names share a line.
    pub names: Vec<String>,
    /// What kind of thing it is.
    pub kind: Kind,
    /// x, and y where there is one; a line is broken where there is none.
    pub points: Vec<(f64, Option<f64>)>,
    /// How far each point may be off to either side, where that is told; otherwise empty.
    pub bars: Vec<f64>,
    /// To how many decimals y is written.
    pub decimals: usize,
}

/// A part of the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Zone {
    /// What holds inside.
    pub name: String,
    /// Beyond any of these it begins.
    pub borders: Vec<Border>,
}

/// A border of a zone, from left to right.
#[derive(Clone, Debug, PartialEq)]
pub struct Border {
    /// The points of the border.
    pub points: Vec<(f64, f64)>,
    /// Whether the zone is above it.
    pub is_zone_above: bool,
}

/// A map's panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// The body, and the law.
    pub case: [String; 2],
    /// The stretches.
    pub stretches: Vec<Stretch>,
    /// Places that are marked by a ring.
    pub marks: Vec<(f64, f64)>,
    /// Whether the law's name bears a mark, which the notes explain.
    pub is_marked: bool,
}

/// A stretch of x at one y.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// Where.
    pub y: f64,
    /// Where it begins.
    pub from: f64,
    /// Where it ends, or the end of the axis.
    pub to: Option<f64>,
}

/// The figure as SVG; the bytes depend on the figure alone.
#[must_use]
pub fn svg(figure: &Figure) -> String {
    match &figure.content {
        Content::Curves { series, zones } => curves::draw(figure, series, zones),
        Content::Map(panels) => map::draw(figure, panels),
    }
}

pub use data::{csv, text};

impl Axis {
    /// The axis as it is drawn.
    fn drawn(&self) -> picture::Axis {
        let name = |tick: &f64| (*tick, tick.to_string().replace('-', "−"));
        let ticks = self.ticks.iter().map(name).collect();
        picture::Axis::told(&self.label, self.range, ticks).with_logarithms(self.is_logarithmic)
    }
}
