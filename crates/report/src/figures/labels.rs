//! Where a line bears its number: as far as it can be from all other lines.

use super::pixels::{Pixel, Window, dense, square};
use super::sheet::px;

/// Numbers keep this far from each other and from points, and a second one of the same line from the
/// first.
const APART: i32 = px(23);
const NEAR: i32 = px(15);
const AGAIN: i32 = px(150);
/// Beyond this a greater distance from other lines is no gain; below this a second number is none.
const CLEAR: i32 = px(36);
const LEAST: i32 = px(14);

/// One or two places for each line, and none for a line that has no place left.
pub(super) fn places(
    lines: &[Vec<Vec<Pixel>>],
    points: &[Pixel],
    window: &Window,
) -> Vec<Vec<Pixel>> {
    let lines: Vec<Vec<Pixel>> = lines
        .iter()
        .map(|parts| parts.iter().flat_map(|part| dense(part, px(6))).collect())
        .collect();
    let inner = window.inset(px(13));
    let mut taken: Vec<Pixel> = Vec::new();
    let mut places = Vec::new();
    for (index, line) in lines.iter().enumerate() {
        let others = || lines.iter().enumerate().filter(|(other, _)| *other != index);
        let clearance = |at: Pixel| {
            let all = others().flat_map(|(_, line)| line);
            all.map(|other| square(at, *other)).min().unwrap_or(i32::MAX).min(CLEAR * CLEAR)
        };
        let candidates: Vec<(i32, Pixel)> = line
            .iter()
            .filter(|at| inner.holds(**at))
            .filter(|at| points.iter().all(|point| square(**at, *point) >= NEAR * NEAR))
            .map(|at| (clearance(*at), *at))
            .collect();
        let mut own: Vec<Pixel> = Vec::new();
        for least in [0, LEAST * LEAST] {
            let free = |(clear, at): &&(i32, Pixel)| {
                *clear >= least
                    && taken.iter().all(|other| square(*at, *other) >= APART * APART)
                    && own.iter().all(|other| square(*at, *other) >= AGAIN * AGAIN)
            };
            if let Some((_, at)) = candidates.iter().filter(free).max_by_key(|(clear, _)| *clear) {
                own.push(*at);
                taken.push(*at);
            }
        }
        places.push(own);
    }
    places
}
