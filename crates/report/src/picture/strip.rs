//! Strips: for each of many cases one row along a common axis, with what holds where.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use super::{Anchor, Canvas, Ink, NUMBERS, Pen, Point, WORDS, count};

/// A row: its name, and bars that share its height from above to below.
pub(crate) struct Strip {
    pub(crate) name: String,
    pub(crate) bars: Vec<Bar>,
}

/// A bar: where it is defined, and where something holds; shares of the axis.
pub(crate) struct Bar {
    pub(crate) domain: Point,
    pub(crate) parts: Vec<(Point, Ink)>,
}

/// From one row to the next, and the height of what is below the last.
const ROW: f64 = 25.0;
const BELOW: f64 = 46.0;
/// What is narrower would not be seen.
const LEAST: f64 = 2.0;

/// How high strips are.
pub(crate) fn height_of(strips: &[Strip]) -> f64 {
    ROW * count(strips.len()) + BELOW
}

/// Draws strips with names up to `split` and the axis from there to `right`. `ticks` are shares of the axis with their
/// numbers, and `band` is the part of it that matters most.
pub(crate) fn strips(
    canvas: &mut Canvas,
    (top, split, right): (f64, f64, f64),
    strips: &[Strip],
    (label, ticks, band): (&str, &[(f64, String)], Point),
) {
    let x = |share: f64| split + share.clamp(0.0, 1.0) * (right - split);
    let bottom = top + ROW * count(strips.len());
    canvas.boxes(&[((x(band.0), top), (x(band.1), bottom))], Ink::Grid, 0.5);
    let grid: Vec<Vec<Point>> =
        ticks.iter().map(|(share, _)| vec![(x(*share), top), (x(*share), bottom)]).collect();
    canvas.lines(grid.iter().map(Vec::as_slice), Pen::new(Ink::Grid, 1.0));
    for (share, name) in ticks {
        canvas.words((x(*share), bottom + 12.0), name, NUMBERS, Anchor::Middle);
    }
    canvas.words(((split + right) / 2.0, bottom + 31.0), label, WORDS, Anchor::Middle);
    for (index, strip) in strips.iter().enumerate() {
        let y = top + ROW * count(index);
        canvas.words((split - 10.0, y + ROW / 2.0), &strip.name, NUMBERS, Anchor::End);
        let thick = (ROW - 7.0) / count(strip.bars.len().max(1));
        for (index, bar) in strip.bars.iter().enumerate() {
            let (above, below) =
                (y + 3.0 + thick * count(index), y + 2.0 + thick * count(index + 1));
            let middle = f64::midpoint(above, below);
            let domain = [(x(bar.domain.0), middle), (x(bar.domain.1), middle)];
            canvas.line(&domain, Pen::new(Ink::Quiet, 1.0).faint(0.5));
            for ((from, to), ink) in &bar.parts {
                let (from, to) = (x(*from), x(*to));
                let more = ((LEAST - (to - from)) / 2.0).max(0.0);
                canvas.boxes(&[((from - more, above), (to + more, below))], *ink, 1.0);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::seen::Seen;
    use super::*;

    #[test]
    fn a_bar_lies_beside_its_name_over_its_part_of_the_axis() {
        let bar = |domain, parts| Bar { domain, parts };
        let all = [
            Strip {
                name: "first".to_owned(),
                bars: vec![
                    bar((0.0, 0.5), vec![((0.25, 0.5), Ink::BLUE)]),
                    bar((0.5, 1.0), vec![((0.5, 0.75), Ink::GREEN), ((2.0, 3.0), Ink::BLUE)]),
                ],
            },
            Strip {
                name: "second".to_owned(),
                bars: vec![bar((-1.0, 1.0), vec![((0.1, 0.1), Ink::BLUE)])],
            },
        ];
        let ticks = [(0.0, "0".to_owned()), (0.5, "1/2".to_owned())];
        let mut canvas = Canvas::new((300.0, 200.0), "", &[]);
        strips(&mut canvas, (40.0, 100.0, 200.0), &all, ("size", &ticks, (0.25, 0.75)));
        let seen = Seen::of(&canvas.finish());
        let corners: Vec<(f64, f64, f64, f64)> = seen
            .lines()
            .iter()
            .filter(|line| line.points.len() == 4)
            .map(|line| (line.points[0].0, line.points[0].1, line.points[2].0, line.points[2].1))
            .collect();
        // the band over both rows of 25 pixels; a row of two bars of 9 pixels each, with one between them
        let expected = [
            (125.0, 40.0, 175.0, 90.0),
            (125.0, 43.0, 150.0, 51.0),
            (150.0, 52.0, 175.0, 60.0),
            // beyond the axis at its end, and what has no width as narrow as can be seen
            (199.0, 52.0, 201.0, 60.0),
            (109.0, 68.0, 111.0, 85.0),
        ];
        assert_eq!(corners, expected);
        let flat: Vec<(f64, f64, f64)> = seen
            .lines()
            .iter()
            .filter(|line| line.class == "q line")
            .map(|line| (line.points[0].0, line.points[1].0, line.points[0].1))
            .collect();
        assert_eq!(flat, [(100.0, 150.0, 47.0), (150.0, 200.0, 56.0), (100.0, 200.0, 76.5)]);
        let at = |words: &str| seen.place(words).map(|(x, y)| (x, (y - 0.36 * NUMBERS).round()));
        assert_eq!([at("first"), at("second")], [Some((90.0, 53.0)), Some((90.0, 78.0))]);
        assert_eq!([at("0"), at("1/2")], [Some((100.0, 102.0)), Some((150.0, 102.0))]);
        assert_eq!(seen.place("size").map(|(x, _)| x), Some(150.0));
        assert_eq!(height_of(&all), 96.0);
    }
}
