//! A panel: a plot with its axes, and what is drawn in it.

use super::{Anchor, Axis, Canvas, Ink, NUMBERS, Pen, Point, WORDS, Window, length};

/// Where a panel stands: its corner and its size, the room of its axes included.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) at: Point,
    pub(crate) size: Point,
    /// above the plot, for a caption
    pub(crate) head: f64,
    /// beside the plot, for names at the ends of lines
    pub(crate) beside: f64,
}

/// The room of numbers and words at the left and below.
const LEFT: f64 = 66.0;
const BELOW: f64 = 44.0;

/// Points up to which each is marked.
const FEW: usize = 40;

/// A plot with its axes.
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    x: Axis,
    y: Axis,
    pub(crate) window: Window,
}

impl Panel {
    /// Draws the axes, with a line through the plot at each number, and a caption above.
    pub(crate) fn new(
        canvas: &mut Canvas,
        frame: Frame,
        (x, y): (Axis, Axis),
        caption: &str,
    ) -> Self {
        let (left, top) = (frame.at.0 + LEFT, frame.at.1 + frame.head);
        let window = Window {
            left,
            right: frame.at.0 + frame.size.0 - frame.beside,
            top,
            bottom: frame.at.1 + frame.size.1 - BELOW,
        };
        let panel = Self { x, y, window };
        let Window { left, right, top, bottom } = window;
        canvas.bold((left, frame.at.1 + frame.head / 2.0), caption, WORDS);
        let inside = |share: &f64| (-0.001..=1.001).contains(share);
        let mut grid: Vec<Vec<Point>> = Vec::new();
        let mut taken = f64::NEG_INFINITY;
        for (at, name) in &panel.x.ticks {
            let Some(share) = panel.x.share(*at).filter(inside) else { continue };
            let x = left + share * (right - left);
            grid.push(vec![(x, top), (x, bottom)]);
            // a number that would run into the one before is left out
            let half = length(name, NUMBERS) / 2.0;
            if x - half > taken {
                taken = x + half + 4.0;
                canvas.words((x, bottom + 12.0), name, NUMBERS, Anchor::Middle);
            }
        }
        for (at, name) in &panel.y.ticks {
            let Some(share) = panel.y.share(*at).filter(inside) else { continue };
            let y = bottom - share * (bottom - top);
            grid.push(vec![(left, y), (right, y)]);
            canvas.words((left - 6.0, y), name, NUMBERS, Anchor::End);
        }
        canvas.lines(grid.iter().map(Vec::as_slice), Pen::new(Ink::Grid, 1.0));
        let axes = [(left, top), (left, bottom), (right, bottom)];
        canvas.line(&axes, Pen::new(Ink::Text, 1.0));
        let middle = ((left + right) / 2.0, bottom + 32.0);
        canvas.words(middle, &panel.x.label, WORDS, Anchor::Middle);
        let middle = (frame.at.0 + 12.0, (top + bottom) / 2.0);
        canvas.upright(middle, &panel.y.label, WORDS, Anchor::Middle);
        panel
    }

    /// Where a point is; `None` for what has no place on an axis.
    pub(crate) fn at(&self, (x, y): Point) -> Option<Point> {
        let Window { left, right, top, bottom } = self.window;
        let (x, y) = (self.x.share(x)?, self.y.share(y)?);
        Some((left + x * (right - left), bottom - y * (bottom - top)))
    }

    /// The places of a line's points.
    pub(crate) fn places(&self, points: impl IntoIterator<Item = Point>) -> Vec<Point> {
        points.into_iter().filter_map(|point| self.at(point)).collect()
    }

    /// A line, as far as it is inside.
    pub(crate) fn line(
        &self,
        canvas: &mut Canvas,
        points: impl IntoIterator<Item = Point>,
        pen: Pen,
    ) {
        let parts = self.window.cut(&self.places(points));
        canvas.lines(parts.iter().map(Vec::as_slice), pen);
    }

    /// Lines with their names, and a dot at each point where they are few.
    pub(crate) fn named(&self, canvas: &mut Canvas, lines: &[(String, Vec<Point>, Pen)]) {
        for (_, points, pen) in lines.iter().filter(|(_, points, _)| points.len() <= FEW) {
            let places = self.places(points.iter().copied());
            for place in places.iter().filter(|at| self.window.holds(**at)) {
                canvas.dot(*place, 2.5, pen.ink);
            }
        }
        self.ended(canvas, lines);
    }

    /// Lines with their names beside their last points, which give way to each other.
    pub(crate) fn ended(&self, canvas: &mut Canvas, lines: &[(String, Vec<Point>, Pen)]) {
        let mut ends: Vec<(f64, f64, &str, Pen)> = Vec::new();
        for (name, points, pen) in lines {
            self.line(canvas, points.iter().copied(), *pen);
            let places = self.places(points.iter().copied());
            let Some(end) = places.last() else { continue };
            ends.push((end.1.clamp(self.window.top, self.window.bottom), end.0, name, *pen));
        }
        ends.sort_by(|a, b| a.0.total_cmp(&b.0));
        // from above, each below the one before; then back up, as far as they would leave the plot
        let step = NUMBERS + 2.0;
        let mut places: Vec<f64> = Vec::new();
        for end in &ends {
            let least = places.last().map_or(f64::NEG_INFINITY, |last| last + step);
            places.push(end.0.max(least));
        }
        let mut most = self.window.bottom;
        for place in places.iter_mut().rev() {
            *place = place.min(most);
            most = *place - step;
        }
        let x = self.window.right + 8.0;
        for ((y, from, name, pen), place) in ends.into_iter().zip(places) {
            let way = [(from, y), (x, place), (x + 10.0, place)];
            canvas.line(&way, Pen::new(pen.ink, 1.0).faint(0.6));
            canvas.words((x + 14.0, place), name, NUMBERS, Anchor::Start);
        }
    }
}

/// The corners of a staircase that keeps each y until the next x.
pub(crate) fn staircase(points: &[Point]) -> Vec<Point> {
    let mut corners: Vec<Point> = Vec::new();
    for (x, y) in points {
        corners.extend(corners.last().map(|last| (*x, last.1)));
        corners.push((*x, *y));
    }
    corners
}

#[cfg(test)]
mod tests {
    use super::staircase;

    #[test]
    fn a_staircase_keeps_its_height_until_the_next_step() {
        let steps = staircase(&[(0., 1.), (2., 3.), (5., 0.)]);
        assert_eq!(steps, [(0., 1.), (2., 1.), (2., 3.), (5., 3.), (5., 0.)]);
    }
}
