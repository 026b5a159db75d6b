//! e over the phase within the step.

use kane_records::scatter::Spot;
use kane_records::study::Study;

use super::{HEIGHT, WIDTH, frame, number, range};
use crate::picture::{Axis, Canvas, Ink, Key, Panel, Pen, Point, Shape, legend, mark};

/// e beyond which a spot is drawn at the border.
const FAR: f64 = 3.0;

/// The picture; `None` where the log has fewer than two phases.
pub(in crate::records) fn phase(study: &Study) -> Option<String> {
    let place = |spot: &Spot| Some((spot.phase?, spot.restitution?.clamp(-FAR, FAR), spot.stated));
    let spots: Vec<(f64, f64, Option<f64>)> = study.spots.iter().filter_map(place).collect();
    let first = spots.first()?.0;
    if spots.iter().all(|(phase, ..)| *phase == first) {
        return None;
    }
    let title = "Restitution over the phase of the contact within its time step";
    let notes = [
        "A ring is the restitution of an impact as measured, a line the one that is stated. Rings beside every line \
         at some phases are pushes out of the surface that depend on how deep a body was caught. Where e is beyond 3, \
         it is drawn there."
            .to_owned(),
    ];
    let mut canvas = Canvas::new((WIDTH, HEIGHT), title, &notes);
    let stated = Pen::new(Ink::Text, 1.5);
    let keys = [(Key::Mark(Shape::Ring, Ink::BLUE), "measured"), (Key::Line(stated), "stated")];
    let top = legend(&mut canvas, (60.0, 4.0), WIDTH - 60.0, &keys) + 10.0;
    let (low, high) = range(spots.iter().map(|(phase, ..)| *phase), (0.0, 1.0));
    let axes = (
        Axis::linear("phase within the step", (low, high), number),
        Axis::linear("e", range(spots.iter().map(|(_, e, _)| *e), (0.0, 1.0)), number),
    );
    let panel = Panel::new(&mut canvas, frame(top, 14.0), axes, "");
    let mut levels: Vec<f64> = spots.iter().filter_map(|(_, _, stated)| *stated).collect();
    levels.sort_by(f64::total_cmp);
    levels.dedup();
    for level in levels.into_iter().take(12) {
        panel.line(&mut canvas, [(low, level), (high, level)], stated);
    }
    for (phase, e, _) in spots {
        let at: Point = (phase, e);
        if let Some(at) = panel.at(at).filter(|at| panel.window.holds(*at)) {
            mark(&mut canvas, at, Shape::Ring, Ink::BLUE);
        }
    }
    Some(canvas.finish())
}
