//! Spheres that touch at once, over the time of their contact.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::simulate::ContactTime;

use super::{SceneReport, WIDTH, brief, notes};
use crate::picture::{Axis, Canvas, Frame, Ink, Panel, Pen, Point};

/// The height of a panel.
const HEIGHT: f64 = 270.0;

/// Velocities above, forces below, as SVG.
pub(super) fn contact_picture(report: &SceneReport<'_>, contact: &ContactTime) -> String {
    let first = contact.moments.first();
    let (bodies, pairs) = first.map_or((0, 0), |m| (m.velocities.len(), m.forces.len()));
    let of = |values: &dyn Fn(usize) -> f64| -> Vec<Point> {
        let times = contact.moments.iter().map(|moment| moment.time * 1e6);
        times.enumerate().map(|(index, time)| (time, values(index))).collect()
    };
    let pen = |n: usize| Pen::new(Ink::Series(n), 2.0);
    let velocities: Vec<(String, Vec<Point>, Pen)> = (0..bodies)
        .map(|n| (format!("sphere {}", n + 1), of(&|m| contact.moments[m].velocities[n]), pen(n)))
        .collect();
    // in the colour of the sphere that is pushed
    let forces: Vec<(String, Vec<Point>, Pen)> = (0..pairs)
        .map(|n| {
            let name = format!("{} on {}", n + 1, n + 2);
            (name, of(&|m| contact.moments[m].forces[n]), pen(n + 1))
        })
        .collect();
    let title = format!("{}: velocities, and forces between neighbours", report.title);
    let mut canvas = Canvas::new((WIDTH, 2.0 * HEIGHT), &title, &notes(report, ""));
    panel(&mut canvas, 0.0, "velocity, m/s", &velocities);
    panel(&mut canvas, HEIGHT, "force, N", &forces);
    canvas.finish()
}

fn panel(canvas: &mut Canvas, top: f64, what: &str, lines: &[(String, Vec<Point>, Pen)]) {
    let all = || lines.iter().flat_map(|(_, points, _)| points);
    let end = all().map(|(time, _)| *time).fold(0.0, f64::max).max(f64::MIN_POSITIVE);
    let (low, high) =
        all().fold((0.0_f64, 0.0_f64), |(low, high), (_, y)| (low.min(*y), high.max(*y)));
    let margin = ((high - low) * 0.08).max(1e-300);
    let axes = (
        Axis::linear("time since the first touch, µs", (0.0, end), brief),
        Axis::linear(what, (low - margin, high + margin), brief),
    );
    let frame = Frame { at: (0.0, top), size: (WIDTH, HEIGHT), head: 10.0, beside: 110.0 };
    let panel = Panel::new(canvas, frame, axes, "");
    panel.named(canvas, lines);
}
