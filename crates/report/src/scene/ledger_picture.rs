//! What impacts and gravity do to the energy, as a picture.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::Bounced;

use super::{SceneReport, WIDTH, brief, notes};
use crate::picture::{Axis, Canvas, Frame, Ink, Panel, Pen, Point, staircase};

const HEIGHT: f64 = 400.0;
const PARTS: [(&str, Pen); 5] = [
    ("normal", Pen::new(Ink::BLUE, 2.0)),
    ("tangential", Pen::new(Ink::VERMILION, 2.0).dashed("9 4")),
    ("rotational", Pen::new(Ink::GREEN, 2.0).dashed("3 3")),
    ("gravity", Pen::new(Ink::GREY, 2.0)),
    ("air", Pen::new(Ink::PURPLE, 2.0).dashed("1 3")),
];
const KINETIC: Pen = Pen::new(Ink::Text, 1.5);

/// The ledger as SVG: what impacts have done to the energy so far, by part, what gravity and the air have, and the sum, which is
/// the change of the kinetic energy; `None` without impacts
/// after the start.
#[must_use]
pub fn ledger_picture(report: &SceneReport<'_>) -> Option<String> {
    let sums: &[Bounced] = &report.answer.sums;
    // a while after the last impact, so that its step is seen
    let end = sums.last().map(|last| last.time * 1.06).filter(|end| *end > 0.0)?;
    let curve = |name: &str, pen: Pen, of: &dyn Fn(&Bounced) -> f64| {
        let steps = sums.iter().map(|sum| (sum.time, of(sum)));
        let steps: Vec<Point> = std::iter::once((0.0, 0.0)).chain(steps).collect();
        let last = steps.last().map_or(0.0, |step| step.1);
        (name.to_owned(), staircase(&[&steps[..], &[(end, last)]].concat()), pen)
    };
    let in_air = report.answer.bounces.iter().any(|bounce| bounce.air.is_some());
    let parts = PARTS.iter().take(if in_air { 5 } else { 4 }).enumerate();
    let mut curves: Vec<(String, Vec<Point>, Pen)> =
        parts.map(|(part, (name, pen))| curve(name, *pen, &|sum| sum.parts[part])).collect();
    curves.push(curve("all: kinetic", KINETIC, &|sum| sum.parts.iter().sum()));
    let all = || curves.iter().flat_map(|(_, points, _)| points.iter().map(|point| point.1));
    let (low, high) = (all().fold(0.0, f64::min), all().fold(0.0, f64::max));
    // where nothing changes, the energy itself gives the scale
    let extent = if high > low { high - low } else { report.answer.start_energy.max(1e-300) };
    let margin = extent * 0.08;
    let title = format!("{}: energy by part", report.title);
    let note = "The change so far, right after each impact.";
    let mut canvas = Canvas::new((WIDTH, HEIGHT), &title, &notes(report, note));
    let axes = (
        Axis::linear("time, s", (0.0, end), brief),
        Axis::linear("change of energy so far, J", (low - margin, high + margin), brief),
    );
    let frame = Frame { at: (0.0, 0.0), size: (WIDTH, HEIGHT), head: 10.0, beside: 120.0 };
    let panel = Panel::new(&mut canvas, frame, axes, "");
    panel.ended(&mut canvas, &curves);
    Some(canvas.finish())
}
