//! Legends: what the lines and areas of a picture are called.

use super::{Anchor, Canvas, Ink, LEADING, Pen, Point, WORDS, length};

/// What stands before a name.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Key {
    Line(Pen),
    Area(Ink),
    Dot(Ink),
    Ring(Ink),
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
        Key::Dot(ink) => canvas.dot((x + 12.0, y), 4.5, ink),
        Key::Ring(ink) => canvas.ring((x + 12.0, y), 4.5, Pen::new(ink, 2.0)),
    }
}
