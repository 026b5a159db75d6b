//! Callouts: words beside a point of a plot, where nothing else is drawn, with a line that leads to it.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use super::{Anchor, Canvas, Ink, LEADING, Pen, Point, WORDS, Window, count, dense, length};

/// Words, a line each, about a point.
pub(crate) struct Callout {
    pub(crate) at: Point,
    pub(crate) lines: Vec<String>,
    pub(crate) ink: Ink,
}

/// Words keep this far from marks and lines, and from their own point at least so far.
const APART: f64 = 9.0;
const NEAR: f64 = 16.0;
/// From one place that is tried to the next.
const STEP: f64 = 6.0;

/// A box of words, by two corners.
type Corners = (Point, Point);

/// Draws each callout as near to its point as there is room within the window, beside the marks and the lines that
/// are drawn already. One for which there is no room is left out.
pub(crate) fn callouts(
    canvas: &mut Canvas,
    window: &Window,
    (marks, lines): (&[Point], &[Vec<Point>]),
    callouts: &[Callout],
) {
    let mut taken: Vec<Point> = lines.iter().flat_map(|line| dense(line, STEP)).collect();
    taken.extend_from_slice(marks);
    let mut boxes: Vec<Corners> = Vec::new();
    for callout in callouts {
        let Some(corners) = place(callout, window, &taken, &boxes) else { continue };
        let ((left, top), _) = corners;
        let end = nearest(corners, callout.at);
        canvas.line(&[callout.at, end], Pen::new(callout.ink, 1.0));
        for (n, words) in callout.lines.iter().enumerate() {
            let at = (left, top + LEADING * (count(n) + 0.5));
            canvas.inked(at, words, WORDS, Anchor::Start, callout.ink);
        }
        // nor do later words cross the line that leads to these
        taken.extend(dense(&[callout.at, end], STEP));
        boxes.push(corners);
    }
}

/// The free place whose box is nearest to the point.
fn place(
    callout: &Callout,
    window: &Window,
    taken: &[Point],
    boxes: &[Corners],
) -> Option<Corners> {
    let width = callout.lines.iter().map(|line| length(line, WORDS)).fold(0.0, f64::max);
    let height = LEADING * count(callout.lines.len());
    let inside = window.inset(4.0);
    let from = |start: f64, end: f64| {
        std::iter::successors(Some(start), |at| Some(at + STEP)).take_while(move |at| *at <= end)
    };
    let mut best: Option<(f64, Corners)> = None;
    for left in from(inside.left, inside.right - width) {
        for top in from(inside.top, inside.bottom - height) {
            let corners = ((left, top), (left + width, top + height));
            let far = distance(nearest(corners, callout.at), callout.at);
            if far < NEAR || best.is_some_and(|(least, _)| least <= far) {
                continue;
            }
            let is_free = taken.iter().all(|at| distance(nearest(corners, *at), *at) >= APART)
                && boxes.iter().all(|other| are_apart(corners, *other))
                && boxes.iter().all(|other| {
                    let way = dense(&[callout.at, nearest(corners, callout.at)], STEP);
                    way.iter().all(|at| distance(nearest(*other, *at), *at) > 1.0)
                });
            if is_free {
                best = Some((far, corners));
            }
        }
    }
    best.map(|(_, corners)| corners)
}

/// The point of a box that is nearest to another.
fn nearest(((left, top), (right, bottom)): Corners, (x, y): Point) -> Point {
    (x.clamp(left, right), y.clamp(top, bottom))
}

fn are_apart(a: Corners, b: Corners) -> bool {
    a.1.0 + APART < b.0.0 || b.1.0 + APART < a.0.0 || a.1.1 + 2.0 < b.0.1 || b.1.1 + 2.0 < a.0.1
}

fn distance(a: Point, b: Point) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: Window = Window { left: 0.0, right: 300.0, top: 0.0, bottom: 200.0 };

    fn words(x: f64, y: f64) -> Callout {
        Callout { at: (x, y), lines: vec!["six ns".to_owned()], ink: Ink::BLUE }
    }

    #[test]
    fn words_stand_near_their_point_and_on_no_mark_line_or_other_words() {
        let callout = words(150.0, 100.0);
        let marks = [(150.0, 80.0), (170.0, 100.0)];
        let first = place(&callout, &WINDOW, &marks, &[]).expect("there is room");
        assert!(distance(nearest(first, callout.at), callout.at) < 40.0, "{first:?}");
        for at in marks {
            assert!(distance(nearest(first, at), at) >= APART, "{first:?} covers {at:?}");
        }
        let second = place(&callout, &WINDOW, &marks, &[first]).expect("there is room");
        assert!(are_apart(first, second), "{first:?} and {second:?}");
    }

    #[test]
    fn words_without_room_are_left_out() {
        let wide = Callout { lines: vec!["x".repeat(100)], ..words(150.0, 100.0) };
        assert_eq!(place(&wide, &WINDOW, &[], &[]), None);
    }
}
