//! Where a line bears its number: as far as it can be from all other lines.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use crate::picture::{Point, Window, dense};

/// Numbers keep this far from each other and from points, and a second one of the same line from the
/// first.
const APART: f64 = 23.0;
const NEAR: f64 = 15.0;
const AGAIN: f64 = 150.0;
/// Beyond this a greater distance from other lines is no gain; below this a second number is none.
const CLEAR: f64 = 36.0;
const LEAST: f64 = 14.0;

/// One or two places for each line, and none for a line that has no place left.
pub(super) fn places(
    lines: &[Vec<Vec<Point>>],
    points: &[Point],
    window: &Window,
) -> Vec<Vec<Point>> {
    let lines: Vec<Vec<Point>> = lines
        .iter()
        .map(|parts| parts.iter().flat_map(|part| dense(part, 6.0)).collect())
        .collect();
    let inner = window.inset(13.0);
    let mut taken: Vec<Point> = Vec::new();
    let mut places = Vec::new();
    for (index, line) in lines.iter().enumerate() {
        let others = || lines.iter().enumerate().filter(|(other, _)| *other != index);
        let clearance = |at: Point| {
            let all = others().flat_map(|(_, line)| line);
            all.map(|other| distance(at, *other)).fold(CLEAR, f64::min)
        };
        let candidates: Vec<(f64, Point)> = line
            .iter()
            .filter(|at| inner.holds(**at))
            .filter(|at| points.iter().all(|point| distance(**at, *point) >= NEAR))
            .map(|at| (clearance(*at), *at))
            .collect();
        let mut own: Vec<Point> = Vec::new();
        for least in [0.0, LEAST] {
            let free = |(clear, at): &&(f64, Point)| {
                *clear >= least
                    && taken.iter().all(|other| distance(*at, *other) >= APART)
                    && own.iter().all(|other| distance(*at, *other) >= AGAIN)
            };
            let found = candidates.iter().filter(free).max_by(|a, b| a.0.total_cmp(&b.0));
            if let Some((_, at)) = found {
                own.push(*at);
                taken.push(*at);
            }
        }
        places.push(own);
    }
    places
}

fn distance(a: Point, b: Point) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}
