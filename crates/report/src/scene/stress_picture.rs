//! Where methods fail, as a picture: a panel for each hard case.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::stress::Row;

use super::power;
use crate::picture::{Axis, Canvas, Frame, Ink, Panel, Pen, Point, count};

const PANEL: Point = (600.0, 290.0);
const COLUMNS: usize = 2;
/// What no error is drawn below, and above: an answer that is not there.
const LEAST: f64 = 1e-17;
const MOST: f64 = 1e3;

/// The table of stress as SVG: the error, on a logarithmic scale, by how far each case is pushed.
#[must_use]
pub fn stress_picture(rows: &[Row]) -> String {
    let cases = distinct(rows.iter().map(|row| row.case));
    let lines = count(cases.len().div_ceil(COLUMNS));
    let size = (PANEL.0 * count(COLUMNS), PANEL.1 * lines);
    let notes = ["The error of an answer that is not there is drawn at the top.".to_owned()];
    let mut canvas = Canvas::new(size, "Where methods fail in hard cases", &notes);
    for (index, case) in cases.iter().enumerate() {
        let rows: Vec<&Row> = rows.iter().filter(|row| row.case == *case).collect();
        let at = (PANEL.0 * count(index % COLUMNS), PANEL.1 * count(index / COLUMNS));
        draw(&mut canvas, Frame { at, size: PANEL, head: 28.0, beside: 210.0 }, case, &rows);
    }
    canvas.finish()
}

/// Each once, in the order of their first mention.
fn distinct<T: PartialEq>(all: impl Iterator<Item = T>) -> Vec<T> {
    let mut found = Vec::new();
    for one in all {
        if !found.contains(&one) {
            found.push(one);
        }
    }
    found
}

fn draw(canvas: &mut Canvas, frame: Frame, case: &str, rows: &[&Row]) {
    let places = distinct(rows.iter().map(|row| row.to.as_str()));
    let methods = distinct(rows.iter().map(|row| (row.method, row.pushed)));
    let pushed = rows.first().map_or("", |row| row.pushed);
    let label = if methods.iter().all(|(_, p)| *p == pushed) { pushed } else { "pushed by" };
    let ticks = places.iter().enumerate().map(|(at, place)| (count(at), (*place).to_owned()));
    let last = count(places.len().saturating_sub(1));
    let axes = (
        Axis::told(label, (-0.3, last + 0.3), ticks.collect()),
        Axis::logarithmic("error", (LEAST, MOST), power),
    );
    let panel = Panel::new(canvas, frame, axes, case);
    let line = |(index, (method, pushed)): (usize, &(&str, &str))| {
        let own = rows.iter().filter(|row| (row.method, row.pushed) == (*method, *pushed));
        let point = |row: &&Row| {
            let place = places.iter().position(|place| *place == row.to)?;
            Some((count(place), row.error.clamp(LEAST, MOST)))
        };
        ((*method).to_owned(), own.filter_map(point).collect(), Pen::new(Ink::Series(index), 2.0))
    };
    panel.named(canvas, &methods.iter().enumerate().map(line).collect::<Vec<_>>());
}
