//! Stretches of one variable at values of another, a panel a case.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use super::{Figure, Panel};
use crate::picture::{self, Anchor, Canvas, Frame, Ink, NUMBERS, Pen, Point, WORDS, count};

/// Size of a panel; panels in a row.
const PANEL: Point = (240.0, 250.0);
const COLUMNS: usize = 4;

pub(super) fn draw(figure: &Figure, panels: &[Panel]) -> String {
    let rows = panels.len().div_ceil(COLUMNS).max(1);
    let size = (PANEL.0 * count(COLUMNS), PANEL.1 * count(rows));
    let mut canvas = Canvas::new(size, &figure.title, &figure.notes);
    for (index, panel) in panels.iter().enumerate() {
        let (column, row) = (index % COLUMNS, index / COLUMNS);
        draw_panel(&mut canvas, (PANEL.0 * count(column), PANEL.1 * count(row)), figure, panel);
    }
    canvas.finish()
}

fn draw_panel(canvas: &mut Canvas, (left, top): Point, figure: &Figure, panel: &Panel) {
    let [body, law] = &panel.case;
    let mark = if panel.is_marked { "†" } else { "" };
    canvas.words((left + 66.0, top + 12.0), &format!("{law}{mark}"), WORDS, Anchor::Start);
    canvas.words((left + 66.0, top + 30.0), body, NUMBERS, Anchor::Start);
    let frame = Frame { at: (left, top), size: PANEL, head: 44.0, beside: 14.0 };
    let (x, y) = (&figure.x, &figure.y);
    let plot = picture::Panel::new(canvas, frame, (x.drawn(), y.drawn()), "");
    // a bar is nearly as high as the axis has room for each value
    let half = (plot.window.bottom - plot.window.top) / 27.0;
    let bar = |stretch: &super::Stretch| {
        let to = stretch.to.unwrap_or(x.range.1);
        let (left, middle) = plot.at((stretch.from, stretch.y))?;
        let (right, _) = plot.at((to, stretch.y))?;
        Some(((left, middle - half), (right, middle + half)))
    };
    let bars: Vec<_> = panel.stretches.iter().filter_map(bar).collect();
    canvas.boxes(&bars, Ink::VERMILION, 0.8);
    for place in panel.marks.iter().filter_map(|mark| plot.at(*mark)) {
        canvas.ring(place, 5.0, Pen::new(Ink::Text, 1.5));
    }
}
