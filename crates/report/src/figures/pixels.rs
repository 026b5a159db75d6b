//! Lines in pixels: cut to a window, made dense, measured. Integers alone.

/// A pixel.
pub(super) type Pixel = (i32, i32);

/// A window in pixels, its border included.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    pub(super) left: i32,
    pub(super) right: i32,
    pub(super) top: i32,
    pub(super) bottom: i32,
}

impl Window {
    pub(super) const fn holds(&self, (x, y): Pixel) -> bool {
        self.left <= x && x <= self.right && self.top <= y && y <= self.bottom
    }

    /// The same, smaller on all sides.
    pub(super) const fn inset(&self, by: i32) -> Self {
        Self {
            left: self.left + by,
            right: self.right - by,
            top: self.top + by,
            bottom: self.bottom - by,
        }
    }

    /// The parts of a line, from left to right, that are inside.
    pub(super) fn cut(&self, line: &[Pixel]) -> Vec<Vec<Pixel>> {
        let mut parts: Vec<Vec<Pixel>> = Vec::new();
        let mut part: Vec<Pixel> = Vec::new();
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
    fn within(&self, from: Pixel, to: Pixel) -> Option<[Pixel; 2]> {
        let turn = |(x, y): Pixel| (y, x);
        let [from, to] = between(from, to, self.left, self.right)?;
        let [from, to] = between(turn(from), turn(to), self.top, self.bottom)?;
        Some([turn(from), turn(to)])
    }
}

/// The part of a segment whose first coordinate is from `least` to `most`.
fn between(from: Pixel, to: Pixel, least: i32, most: i32) -> Option<[Pixel; 2]> {
    if from.0.max(to.0) < least || from.0.min(to.0) > most {
        return None;
    }
    let clamped = |end: Pixel| {
        let at = end.0.clamp(least, most);
        if at == end.0 { end } else { (at, along(from, to, at)) }
    };
    Some([clamped(from), clamped(to)])
}

/// The second coordinate of a segment, which has an extent, where the first is `at`.
fn along(from: Pixel, to: Pixel, at: i32) -> i32 {
    let [x0, y0, x1, y1, x] = [from.0, from.1, to.0, to.1, at].map(i64::from);
    let value = if x1 == x0 { y0 } else { y0 + (y1 - y0) * (x - x0) / (x1 - x0) };
    i32::try_from(value).unwrap_or(i32::MAX)
}

/// y of a line, from left to right, at x; `None` beside it.
pub(super) fn height(line: &[Pixel], x: i32) -> Option<i32> {
    let mut segments = line.iter().zip(line.iter().skip(1));
    let (from, to) = segments.find(|(from, to)| from.0 <= x && x <= to.0)?;
    Some(along(*from, *to, x))
}

/// The line with more points, at most `step` apart in either direction.
pub(super) fn dense(line: &[Pixel], step: i32) -> Vec<Pixel> {
    let mut points: Vec<Pixel> = line.first().copied().into_iter().collect();
    for (from, to) in line.iter().zip(line.iter().skip(1)) {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let parts = dx.abs().max(dy.abs()) / step + 1;
        points.extend((1..=parts).map(|n| (from.0 + dx * n / parts, from.1 + dy * n / parts)));
    }
    points
}

/// The square of the distance.
pub(super) const fn square(a: Pixel, b: Pixel) -> i32 {
    let (dx, dy) = (a.0 - b.0, a.1 - b.1);
    dx * dx + dy * dy
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: Window = Window { left: 0, right: 100, top: 0, bottom: 50 };

    #[test]
    fn a_line_that_leaves_and_comes_back_is_two_lines_that_end_at_the_border() {
        let line = [(0, 40), (20, 20), (40, -20), (60, -20), (80, 20), (120, 20)];
        let parts = vec![vec![(0, 40), (20, 20), (30, 0)], vec![(70, 0), (80, 20), (100, 20)]];
        assert_eq!(WINDOW.cut(&line), parts);
        assert_eq!(WINDOW.cut(&[(0, -10), (100, -1)]), Vec::<Vec<Pixel>>::new());
        assert_eq!(WINDOW.cut(&[(10, -2_000_000), (10, 2_000_000)]), [[(10, 0), (10, 50)]]);
    }

    #[test]
    fn a_dense_line_keeps_its_points_and_has_no_long_step() {
        let points = dense(&[(0, 0), (10, 40), (11, 40)], 6);
        assert!(points.contains(&(10, 40)) && points.last() == Some(&(11, 40)));
        let steps = points.iter().zip(points.iter().skip(1));
        assert!(steps.clone().count() > 7);
        assert!(steps.into_iter().all(|(a, b)| (a.0 - b.0).abs() <= 6 && (a.1 - b.1).abs() <= 6));
    }

    #[test]
    fn the_height_of_a_line_is_known_along_it_alone() {
        let line = [(0, 0), (10, 100)];
        assert_eq!([5, 10, 11].map(|x| height(&line, x)), [Some(50), Some(100), None]);
    }
}
