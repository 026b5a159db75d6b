//! The picture of speed against accuracy: one panel for each quantity of each law.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_measure::chart::{Measured, Time, front};
use kane_number::System;

use super::{ChartReport, reach};
use crate::picture::{
    Axis, Callout, Canvas, Frame, Ink, Key, Panel, Pen, Point, Shape, callouts, count, legend,
    mark, staircase,
};
use crate::shorten::shorten;

/// Size of a panel; panels in a row; the height of the legend.
const PANEL: Point = (480.0, 330.0);
const COLUMNS: usize = 2;
const LEGEND: f64 = 30.0;
/// Where exact methods are drawn, in digits.
pub(super) const EXACT: f64 = 38.0;

/// The ink of a system of numbers.
pub(crate) const fn ink(system: System) -> Ink {
    match system {
        System::F32 => Ink::VERMILION,
        System::F64 => Ink::BLUE,
        System::DoubleDouble => Ink::GREEN,
        System::Interval => Ink::PURPLE,
        System::Rational => Ink::Text,
    }
}

/// The shape of its marks.
pub(crate) const fn shape(system: System) -> Shape {
    match system {
        System::F32 => Shape::Triangle,
        System::F64 => Shape::Disc,
        System::DoubleDouble => Shape::Square,
        System::Interval => Shape::Diamond,
        System::Rational => Shape::Ring,
    }
}

/// A way to compute, where it is drawn, and whether nothing else is both cheaper and better.
pub(crate) struct Spot {
    system: System,
    /// picoseconds and digits
    at: Point,
    /// the quartiles of the time
    bar: Option<(f64, f64)>,
    on_front: bool,
    /// what it is called, if it is on the front
    name: String,
}

/// Where a way is drawn, by hundredths of digits and its time.
pub(crate) fn spot(
    system: System,
    worst: i64,
    time: Option<&Time>,
    on_front: bool,
    name: String,
) -> Spot {
    let bar = time.map(|time| (float(time.quartiles.0), float(time.quartiles.1)));
    let median = time.map_or(1, |time| time.median.max(1));
    Spot { system, at: (float(median), height(worst)), bar, on_front, name }
}

fn float(n: u64) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}

/// Hundredths of digits on the axis.
fn height(worst: i64) -> f64 {
    match worst {
        i64::MAX => EXACT,
        worst => f64::from(i32::try_from(worst).unwrap_or(0)) / 100.0,
    }
}

/// Every quantity with more than one method, as SVG: decimal digits that are right at the worst input, against the
/// time; the Pareto front is a staircase, and its methods bear their names.
#[must_use]
pub fn picture(report: &ChartReport<'_>) -> String {
    let on_front = front(report.all);
    let mut groups: Vec<(String, Vec<Spot>)> = Vec::new();
    for ((law, quantity), group) in report.groups() {
        let drawn = |index: &usize| {
            let measured = report.all.get(*index)?;
            let (system, worst) = (measured.method.system, measured.accuracy.worst);
            let on_front = *on_front.get(*index)?;
            Some(spot(system, worst, measured.time.as_ref(), on_front, name(measured)))
        };
        if group.len() > 1 {
            groups.push((format!("{law}: {quantity}"), group.iter().filter_map(drawn).collect()));
        }
    }
    let notes = [
        "Digits right at the worst input, by the time of one evaluation; the line is the Pareto front: nothing else is \
         both cheaper and better. A bar is from the first to the third quartile. Quantities with one method alone are \
         in the table."
            .to_owned(),
        report.machine.clone(),
        format!("kane {}: {}", env!("CARGO_PKG_VERSION"), report.command),
    ];
    panels(&groups, &notes, "Pareto front")
}

/// A panel for each group under its caption, with one axis of time for all, so that they can be compared; `front` says in
/// the legend what the staircase is.
pub(crate) fn panels(groups: &[(String, Vec<Spot>)], notes: &[String], front: &str) -> String {
    let times = || groups.iter().flat_map(|(_, group)| group.iter().map(|drawn| drawn.at.0));
    let least = times().fold(f64::INFINITY, f64::min).min(1000.0);
    let most = times().fold(least * 10.0, f64::max);
    let columns = COLUMNS.min(groups.len().max(1));
    let rows = groups.len().div_ceil(columns);
    let size = (PANEL.0 * count(columns), LEGEND + PANEL.1 * count(rows));
    let mut canvas = Canvas::new(size, "What does the next digit cost?", notes);
    let names = System::ALL.map(|system| (system, system.to_string()));
    let mut keys: Vec<(Key, &str)> = names
        .iter()
        .map(|(system, name)| (Key::Mark(shape(*system), ink(*system)), name.as_str()))
        .collect();
    keys.push((Key::Line(FRONT), front));
    legend(&mut canvas, (12.0, 2.0), size.0, &keys);
    for (index, (caption, group)) in groups.iter().enumerate() {
        let (column, row) = (index % columns, index / columns);
        let at = (PANEL.0 * count(column), LEGEND + PANEL.1 * count(row));
        panel(&mut canvas, (at, PANEL), caption, group, (least / 2.0, most * 2.0));
    }
    canvas.finish()
}

const FRONT: Pen = Pen::new(Ink::GREY, 2.0);

/// Picoseconds and digits of a method.
pub(super) fn place(measured: &Measured) -> Point {
    let time = measured.time.as_ref().map_or(1, |time| time.median.max(1));
    (float(time), height(measured.accuracy.worst))
}

/// A panel at a place, of a size: the ways, and the front as a staircase.
fn panel(
    canvas: &mut Canvas,
    (at, size): (Point, Point),
    caption: &str,
    group: &[Spot],
    range: Point,
) {
    let time = Axis::logarithmic("time, ns", range, |picoseconds| {
        let nanoseconds = picoseconds / 1000.0;
        if nanoseconds < 1e4 { nanoseconds.to_string() } else { format!("{nanoseconds:e}") }
    });
    let frame = Frame { at, size, head: 28.0, beside: 14.0 };
    let panel = Panel::new(canvas, frame, (time, digits_axis()), caption);
    let mut steps: Vec<Point> = group.iter().filter(|d| d.on_front).map(|d| d.at).collect();
    steps.sort_by(|a, b| a.0.total_cmp(&b.0));
    steps.extend(steps.last().map(|last| (range.1, last.1)));
    panel.line(canvas, staircase(&steps), FRONT);
    let mut marks: Vec<Point> = Vec::new();
    for drawn in group {
        let Some(at) = panel.at(drawn.at) else { continue };
        let system = drawn.system;
        mark(canvas, at, shape(system), ink(system));
        if let Some((low, high)) = drawn.bar {
            let ends = [low, high].map(|time| (time, drawn.at.1));
            panel.line(canvas, ends, Pen::new(ink(system), 1.0));
        }
        marks.push(at);
    }
    // with a line to what is named: of marks close together a name beside them does not tell which is meant
    let named = |drawn: &Spot| {
        let lines = vec![drawn.name.clone()];
        Some(Callout { at: panel.at(drawn.at)?, lines, ink: Ink::Text })
    };
    let names: Vec<Callout> = group.iter().filter(|d| d.on_front).filter_map(named).collect();
    let stairs = panel.places(staircase(&steps));
    callouts(canvas, &panel.window, (&marks, &[stairs]), &names);
}

/// Digits, with the precisions of the systems.
pub(super) fn digits_axis() -> Axis {
    let ticks =
        [(0.0, "wrong"), (7.2, "7 f32"), (16.0, "16 f64"), (31.9, "32 dd"), (EXACT, "exact")];
    let ticks = ticks.map(|(at, name)| (at, name.to_owned())).to_vec();
    Axis::told("decimal digits right at the worst input", (-4.5, 41.0), ticks)
}

/// What a method on the front is called, with the bound that is proved of it.
fn name(measured: &Measured) -> String {
    let method = &measured.method;
    let text = match (method.is_law, method.name) {
        (true, "columns") => "the law's code, in columns".to_owned(),
        (true, _) => "the law's code".to_owned(),
        (false, name) => format!("{name} {}", method.text),
    };
    let bound = measured.proved.as_ref();
    let bound = bound.map(|p| format!(", proved: {} ulp to {}", p.ulps, reach(p)));
    shorten(&text, 30) + &bound.unwrap_or_default()
}
