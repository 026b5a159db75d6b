//! Legends: what the lines and areas of a picture are called.

use super::{Anchor, Canvas, Ink, LEADING, Pen, Point, WORDS, length};

/// What stands before a name.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Key {
    Line(Pen),
    Area(Ink),
    Mark(Shape, Ink),
}

/// The shape of a mark, so that marks never rest on colour alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    Disc,
    Ring,
    Square,
    Triangle,
    Diamond,
}

/// Draws a mark.
pub(crate) fn mark(canvas: &mut Canvas, (x, y): Point, shape: Shape, ink: Ink) {
    match shape {
        Shape::Disc => canvas.dot((x, y), 4.5, ink),
        Shape::Ring => canvas.ring((x, y), 4.5, Pen::new(ink, 2.0)),
        Shape::Square => canvas.boxes(&[((x - 4.0, y - 4.0), (x + 4.0, y + 4.0))], ink, 1.0),
        Shape::Triangle => {
            canvas.area(&[(x, y - 6.0), (x + 5.5, y + 4.0), (x - 5.5, y + 4.0)], ink, 1.0);
        }
        Shape::Diamond => {
            canvas.area(&[(x, y - 6.0), (x + 6.0, y), (x, y + 6.0), (x - 6.0, y)], ink, 1.0);
        }
    }
}

/// Draws a legend in rows from this place to the width, and returns how high it is.
pub(crate) fn legend(
    canvas: &mut Canvas,
    (left, top): Point,
    width: f64,
    keys: &[(Key, &str)],
) -> f64 {
    let (mut x, mut y) = (left, top + LEADING / 2.0);
    for (key, name) in keys {
        let needed = 30.0 + length(name, WORDS) + 18.0;
        if x > left && x + needed > left + width {
            (x, y) = (left, y + LEADING);
        }
        beside(canvas, (x, y), *key);
        canvas.words((x + 30.0, y), name, WORDS, Anchor::Start);
        x += needed;
    }
    y + LEADING / 2.0 - top
}

/// The key alone, 24 pixels wide.
fn beside(canvas: &mut Canvas, (x, y): Point, key: Key) {
    match key {
        Key::Line(pen) => canvas.line(&[(x, y), (x + 24.0, y)], pen),
        Key::Area(ink) => {
            let corners = ((x, y - 6.0), (x + 20.0, y + 6.0));
            canvas.boxes(&[corners], ink, 1.0);
        }
        Key::Mark(shape, ink) => mark(canvas, (x + 12.0, y), shape, ink),
    }
}
