//! Error against cost, as a picture.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::{Judged, Known, Verdict};

use super::{SceneReport, WIDTH, notes, power};
use crate::picture::{
    Anchor, Axis, Canvas, Frame, Ink, Key, NUMBERS, Panel, Pen, Shape, legend, length, mark,
};

const HEIGHT: f64 = 430.0;
/// What no error is drawn below.
const LEAST: f64 = 1e-18;
const TOLERANCE: Pen = Pen::new(Ink::VERMILION, 2.0);

/// Error by tolerance against counted cost, as SVG, for every model that was tried and has an error.
#[must_use]
pub fn compare_picture(report: &SceneReport<'_>) -> String {
    let drawn = report.answer.judged.iter().filter_map(|judged| {
        let cost = f64::from(u32::try_from(judged.cost).unwrap_or(u32::MAX));
        Some((judged, cost, judged.ratio?.clamp(LEAST, 1e18)))
    });
    let drawn: Vec<(&Judged, f64, f64)> = drawn.collect();
    let most = drawn.iter().map(|(_, cost, _)| *cost).fold(100.0, f64::max);
    let worst = drawn.iter().map(|(.., ratio)| *ratio).fold(10.0, f64::max);
    let best = drawn.iter().map(|(.., ratio)| *ratio).fold(0.1, f64::min);
    let title = format!("{}: error against cost", report.title);
    let mut canvas = Canvas::new((WIDTH, HEIGHT), &title, &notes(report, ""));
    let keys = [
        (Key::Line(TOLERANCE), "the tolerance"),
        (Key::Mark(Shape::Ring, Ink::GREEN), "good enough"),
        (Key::Mark(Shape::Disc, Ink::GREEN), "the chosen one"),
        (Key::Mark(Shape::Ring, Ink::GREY), "not, or not known to be"),
    ];
    let top = legend(&mut canvas, (66.0, 0.0), WIDTH, &keys);
    let what = match report.answer.known {
        Some(Known::Estimated) => "worst error by its tolerance, estimated",
        _ => "worst error by its tolerance",
    };
    let (left, right) = (20.0, most * 12.0);
    let axes = (
        Axis::logarithmic("cost of an impact, additions of f64", (left, right), power),
        Axis::logarithmic(what, (best / 10.0, worst * 10.0), power),
    );
    let frame = Frame { at: (0.0, top), size: (WIDTH, HEIGHT - top), head: 10.0, beside: 14.0 };
    let panel = Panel::new(&mut canvas, frame, axes, "");
    panel.line(&mut canvas, [(left, 1.0), (right, 1.0)], TOLERANCE);
    let mut labels: Vec<(String, f64, f64)> = Vec::new();
    for (judged, cost, ratio) in drawn {
        let ink = if judged.verdict == Verdict::Meets { Ink::GREEN } else { Ink::GREY };
        let Some(at) = panel.at((cost, ratio)) else { continue };
        let chosen = report.answer.chosen == Some(judged.model);
        mark(&mut canvas, at, if chosen { Shape::Disc } else { Shape::Ring }, ink);
        // models in one place share a label
        match labels.iter_mut().find(|(_, x, y)| *x == cost && (ratio / *y).ln().abs() < 0.2) {
            Some((text, ..)) => text.push_str(&format!(", {}", judged.model.system)),
            None => labels.push((judged.model.to_string(), cost, ratio)),
        }
    }
    // beside its circle, and lower where another one is in the way
    let mut taken: Vec<(f64, f64, f64)> = Vec::new();
    labels.sort_by(|a, b| b.2.total_cmp(&a.2).then(a.1.total_cmp(&b.1)));
    for (text, cost, ratio) in labels {
        let Some((x, mut y)) = panel.at((cost, ratio)) else { continue };
        let (left, right) = (x + 10.0, x + 10.0 + length(&text, NUMBERS));
        let meets = |y: f64, other: &&(f64, f64, f64)| {
            left < other.2 && other.0 < right && (y - other.1).abs() < 13.0
        };
        while let Some(other) = taken.iter().find(|other| meets(y, other)) {
            y = other.1 + 13.5;
        }
        taken.push((left, y, right));
        canvas.words((left, y), &text, NUMBERS, Anchor::Start);
    }
    canvas.finish()
}
