//! Lines in a window: cut, made dense, measured.

use super::Point;

/// A window, its border included.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Window {
    pub(crate) left: f64,
    pub(crate) right: f64,
    pub(crate) top: f64,
    pub(crate) bottom: f64,
}

impl Window {
    pub(crate) fn holds(&self, (x, y): Point) -> bool {
        self.left <= x && x <= self.right && self.top <= y && y <= self.bottom
    }

    /// The same, smaller on all sides.
    pub(crate) fn inset(&self, by: f64) -> Self {
        let Self { left, right, top, bottom } = *self;
        Self { left: left + by, right: right - by, top: top + by, bottom: bottom - by }
    }

    /// The parts of a line that are inside.
    pub(crate) fn cut(&self, line: &[Point]) -> Vec<Vec<Point>> {
        let mut parts: Vec<Vec<Point>> = Vec::new();
        let mut part: Vec<Point> = Vec::new();
        for (from, to) in line.iter().zip(line.iter().skip(1)) {
            match self.within(*from, *to) {
                Some([start, end]) => {
                    if part.last() != Some(&start) {
                        parts.push(std::mem::take(&mut part));
                        part.push(start);
                    }
                    part.push(end);
                }
                None => parts.push(std::mem::take(&mut part)),
            }
        }
        parts.push(part);
        for part in &mut parts {
            part.dedup();
        }
        parts.retain(|part| part.len() > 1);
        parts
    }

    /// The part of a segment that is inside, first by x, then by y.
    fn within(&self, from: Point, to: Point) -> Option<[Point; 2]> {
        let turn = |(x, y): Point| (y, x);
        let [from, to] = between(from, to, self.left, self.right)?;
        let [from, to] = between(turn(from), turn(to), self.top, self.bottom)?;
        Some([turn(from), turn(to)])
    }

    /// Diagonal lines over the part of the window where `is_inside` holds: what tells zones apart without colour.
    pub(crate) fn hatch(
        &self,
        rises: bool,
        spacing: f64,
        is_inside: impl Fn(Point) -> bool,
    ) -> Vec<Vec<Point>> {
        let (width, height) = (self.right - self.left, self.bottom - self.top);
        let mut lines = Vec::new();
        let mut start = -height;
        while start < width {
            let mut run: Vec<Point> = Vec::new();
            let mut t = 0.0;
            while t <= height {
                let y = if rises { self.bottom - t } else { self.top + t };
                let at = (self.left + start + t, y);
                if self.holds(at) && is_inside(at) {
                    run.truncate(1);
                    run.push(at);
                } else {
                    lines.push(std::mem::take(&mut run));
                }
                t += 0.5;
            }
            lines.push(run);
            start += spacing;
        }
        lines.retain(|line| line.len() > 1);
        lines
    }
}

/// The part of a segment whose first coordinate is from `least` to `most`.
fn between(from: Point, to: Point, least: f64, most: f64) -> Option<[Point; 2]> {
    if from.0.max(to.0) < least || from.0.min(to.0) > most {
        return None;
    }
    let clamped = |end: Point| {
        let at = end.0.clamp(least, most);
        if at == end.0 { end } else { (at, along(from, to, at)) }
    };
    Some([clamped(from), clamped(to)])
}

/// The second coordinate of a segment where the first is `at`.
fn along(from: Point, to: Point, at: f64) -> f64 {
    if to.0 == from.0 { from.1 } else { from.1 + (to.1 - from.1) * (at - from.0) / (to.0 - from.0) }
}

/// y of a line, from left to right, at x; `None` beside it.
pub(crate) fn height(line: &[Point], x: f64) -> Option<f64> {
    let mut segments = line.iter().zip(line.iter().skip(1));
    let (from, to) = segments.find(|(from, to)| from.0 <= x && x <= to.0)?;
    Some(along(*from, *to, x))
}

/// The line with more points, at most `step` apart in either direction.
pub(crate) fn dense(line: &[Point], step: f64) -> Vec<Point> {
    let mut points: Vec<Point> = line.first().copied().into_iter().collect();
    for (from, to) in line.iter().zip(line.iter().skip(1)) {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let parts = (dx.abs().max(dy.abs()) / step).floor() + 1.0;
        let steps = std::iter::successors(Some(1.0), |n| Some(n + 1.0));
        let steps = steps.take_while(|n| *n <= parts).take(10_000);
        points.extend(steps.map(|n| (from.0 + dx * n / parts, from.1 + dy * n / parts)));
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: Window = Window { left: 0.0, right: 100.0, top: 0.0, bottom: 50.0 };

    #[test]
    fn a_line_that_leaves_and_comes_back_is_two_lines_that_end_at_the_border() {
        let line = [(0., 40.), (20., 20.), (40., -20.), (60., -20.), (80., 20.), (120., 20.)];
        let first = vec![(0., 40.), (20., 20.), (30., 0.)];
        assert_eq!(WINDOW.cut(&line), [first, vec![(70., 0.), (80., 20.), (100., 20.)]]);
        assert_eq!(WINDOW.cut(&[(0., -10.), (100., -1.)]), Vec::<Vec<Point>>::new());
        assert_eq!(WINDOW.cut(&[(10., -2e6), (10., 2e6)]), [[(10., 0.), (10., 50.)]]);
    }

    #[test]
    fn a_dense_line_keeps_its_points_and_has_no_long_step() {
        let points = dense(&[(0., 0.), (10., 40.), (11., 40.)], 6.0);
        assert!(points.contains(&(10., 40.)) && points.last() == Some(&(11., 40.)));
        let mut steps = points.iter().zip(points.iter().skip(1));
        assert!(points.len() > 7);
        assert!(steps.all(|(a, b)| (a.0 - b.0).abs() <= 6.0 && (a.1 - b.1).abs() <= 6.0));
    }

    #[test]
    fn the_height_of_a_line_is_known_along_it_alone() {
        let line = [(0., 0.), (10., 100.)];
        assert_eq!([5., 10., 11.].map(|x| height(&line, x)), [Some(50.), Some(100.), None]);
    }

    #[test]
    fn hatching_stays_inside_of_its_zone() {
        let lines = WINDOW.hatch(true, 10.0, |(x, _)| x < 30.0);
        assert!(
            lines.len() > 5 && lines.iter().flatten().all(|at| WINDOW.holds(*at) && at.0 < 30.0)
        );
    }
}
