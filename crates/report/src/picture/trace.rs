//! Lines as paths of SVG, in as few characters as show them.
//!
//! A point that is nearer than a twentieth of a pixel to the line between its neighbours is left out: nobody sees it. The
//! others are written to a hundredth of a pixel, each from the one before.

use std::fmt::Write as _;

use super::Point;

/// How far a line may be from a point that is left out, in pixels.
const UNSEEN: f64 = 0.05;

/// A path through the points, `M0 0l1 1`.
pub(super) fn trace(points: &[Point]) -> String {
    let mut d = String::new();
    let mut last = (0, 0);
    for (index, point) in thinned(points).into_iter().map(hundredths).enumerate() {
        d.push(if index == 0 { 'M' } else { 'l' });
        let (x, y) = (number(point.0 - last.0), number(point.1 - last.1));
        let space = if y.starts_with('-') { "" } else { " " };
        let _ = write!(d, "{x}{space}{y}");
        last = point;
    }
    d
}

/// The points that are needed, in their order; the first and the last always are.
fn thinned(points: &[Point]) -> Vec<Point> {
    let Some(last) = points.len().checked_sub(1) else { return Vec::new() };
    let mut is_needed = vec![false; points.len()];
    is_needed[0] = true;
    is_needed[last] = true;
    // between two needed points, the one that is farthest from the line between them
    let mut stretches = vec![(0, last)];
    while let Some((from, to)) = stretches.pop() {
        let far = (from + 1..to)
            .map(|at| (distance(points[at], points[from], points[to]), at))
            .max_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((_, at)) = far.filter(|(far, _)| *far >= UNSEEN || far.is_nan()) {
            is_needed[at] = true;
            stretches.extend([(from, at), (at, to)]);
        }
    }
    points.iter().zip(is_needed).filter_map(|(point, needed)| needed.then_some(*point)).collect()
}

/// How far a point is from the stretch between two.
fn distance((x, y): Point, (x1, y1): Point, (x2, y2): Point) -> f64 {
    let (along_x, along_y) = (x2 - x1, y2 - y1);
    let squared = along_x * along_x + along_y * along_y;
    let share = ((x - x1) * along_x + (y - y1) * along_y) / squared;
    let share = if squared > 0.0 { share.clamp(0.0, 1.0) } else { 0.0 };
    (x - x1 - share * along_x).hypot(y - y1 - share * along_y)
}

#[allow(clippy::cast_possible_truncation, reason = "it saturates, beyond every canvas")]
fn hundredths((x, y): Point) -> (i64, i64) {
    ((100.0 * x).round() as i64, (100.0 * y).round() as i64)
}

/// So many hundredths as `-1.5`, `.07` or `3`.
fn number(hundredths: i64) -> String {
    let sign = if hundredths < 0 { "-" } else { "" };
    let (whole, rest) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
    let whole = if whole == 0 && rest > 0 { String::new() } else { whole.to_string() };
    let rest = if rest == 0 { String::new() } else { format!(".{rest:02}") };
    format!("{sign}{whole}{}", rest.trim_end_matches('0'))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn numbers_are_written_short() {
        let written = [0, 7, -7, 50, 100, -150, 12_345, -30].map(number);
        assert_eq!(written, ["0", ".07", "-.07", ".5", "1", "-1.5", "123.45", "-.3"]);
    }

    #[test]
    fn points_on_a_straight_line_are_left_out() {
        assert_eq!(trace(&[(0.0, 0.0), (1.0, 1.01), (2.0, 2.0), (2.0, 1.0)]), "M0 0l2 2l0-1");
        assert_eq!(trace(&[(0.0, 0.0), (1.0, 1.2), (2.0, 2.0)]), "M0 0l1 1.2l1 .8");
        // there and back again
        assert_eq!(trace(&[(0.0, 0.0), (5.0, 0.0), (0.0, 0.0)]), "M0 0l5 0l-5 0");
        assert_eq!(trace(&[]), "");
    }

    proptest! {
        #[test]
        fn no_point_is_farther_from_the_line_than_nobody_sees(
            points in prop::collection::vec((0.0..900.0_f64, 0.0..500.0_f64), 2..40),
            bend in 0.0..2.0_f64,
        ) {
            // from a straight line to a wild one
            let points: Vec<Point> = points
                .iter()
                .enumerate()
                .map(|(i, (x, y))| (10.0 * super::super::count(i) + bend * x, bend * y))
                .collect();
            let kept = thinned(&points);
            prop_assert_eq!(kept.first(), points.first());
            prop_assert_eq!(kept.last(), points.last());
            for point in &points {
                let near = kept.windows(2).map(|two| distance(*point, two[0], two[1]));
                prop_assert!(near.fold(f64::INFINITY, f64::min) < UNSEEN);
            }
        }
    }
}
