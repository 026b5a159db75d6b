//! Routh's diagram of a tip's impact.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::{Event, ImpulsePlane, PlaneLine};

use super::{SceneReport, WIDTH, brief, notes};
use crate::picture::{Anchor, Axis, Canvas, Frame, Ink, Key, Panel, Pen, Point, WORDS, legend};

const HEIGHT: f64 = 430.0;
const PATH: Pen = Pen::new(Ink::VERMILION, 3.0);

const fn look(line: PlaneLine) -> (Key, &'static str) {
    match line {
        PlaneLine::Cone => (Key::Line(Pen::new(Ink::GREY, 2.0)), "friction cone"),
        PlaneLine::Stick => (Key::Line(Pen::new(Ink::GREEN, 2.0).dashed("8 4")), "no slip"),
        PlaneLine::Compression => {
            (Key::Line(Pen::new(Ink::BLUE, 2.0).dashed("3 4")), "greatest compression")
        }
    }
}

const fn words(event: Event) -> &'static str {
    match event {
        // it is the origin
        Event::Start => "",
        Event::Stick => "sticks",
        Event::Reverse => "slides back",
        Event::Compressed => "compression ends",
        Event::End => "impulse",
    }
}

/// The impact in the plane of its impulse, as SVG.
pub(super) fn impulse_picture(report: &SceneReport<'_>, plane: &ImpulsePlane) -> String {
    let mut canvas =
        Canvas::new((WIDTH, HEIGHT), &format!("{}: its impulse", report.title), &notes(report, ""));
    let lines = [PlaneLine::Cone, PlaneLine::Stick, PlaneLine::Compression].map(look);
    let keys: Vec<(Key, &str)> =
        lines.into_iter().chain([(Key::Line(PATH), "the impulse as it grows")]).collect();
    let top = legend(&mut canvas, (66.0, 0.0), WIDTH, &keys);
    let [low, high] = plane.frame;
    let axes = (
        Axis::linear("tangential impulse p_t, N·s", (low[0], high[0]), brief),
        Axis::linear("normal impulse p_n, N·s", (low[1], high[1]), brief),
    );
    let frame = Frame { at: (0.0, top), size: (WIDTH, HEIGHT - top), head: 10.0, beside: 14.0 };
    let panel = Panel::new(&mut canvas, frame, axes, "");
    for (line, ends) in &plane.lines {
        if let (Key::Line(pen), _) = look(*line) {
            panel.line(&mut canvas, ends.map(|[x, y]| (x, y)), pen);
        }
    }
    let points: Vec<Point> = plane.path.iter().map(|(_, [x, y])| (*x, *y)).collect();
    panel.line(&mut canvas, points, PATH);
    for (event, [x, y]) in &plane.path {
        let Some(at) = panel.at((*x, *y)) else { continue };
        canvas.dot(at, 4.0, PATH.ink);
        // beside the point, away from the axis of the cone
        let (beside, anchor) =
            if *x < 0.0 { (at.0 - 12.0, Anchor::End) } else { (at.0 + 12.0, Anchor::Start) };
        canvas.words((beside, at.1), words(*event), WORDS, anchor);
    }
    canvas.finish()
}
