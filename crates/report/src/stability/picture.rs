//! A picture: where formulas of one input fail, a strip each; formulas of two inputs as planes.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use std::collections::BTreeSet;

use kane_measure::{Examined, Fault, Plane};

use super::{Entry, StabilityReport};
use crate::picture::{
    Axis, Bar, Canvas, Frame, Ink, Key, Panel, Point, Strip, count, height_of, legend, strips,
};
use crate::shorten::shorten;

/// The width of the picture, where the axis of the strips begins, and a panel of a plane.
const WIDTH: f64 = 960.0;
const SPLIT: f64 = 400.0;
const PANEL: Point = (316.0, 240.0);
const COLUMNS: usize = 3;
const LEGEND: f64 = 30.0;

/// Whether a formula that fails has one or two inputs: of more the picture shows nothing.
pub(super) fn shows_something(report: &StabilityReport<'_>) -> bool {
    let entries = report.entries();
    let mut failing = entries.iter().filter(|entry| entry.fails());
    failing.any(|entry| !rows(entry).is_empty() || plane(entry).is_some())
}

/// What is drawn of a formula of two inputs.
fn plane<'a>(entry: &Entry<'a>) -> Option<&'a Plane> {
    entry.planes.iter().find(|plane| plane.format == "f64").copied()
}

/// Every formula that fails and has at most two inputs, as SVG.
#[must_use]
pub fn picture(report: &StabilityReport<'_>) -> String {
    let entries = report.entries();
    let failing = || entries.iter().filter(|entry| entry.fails());
    let rows: Vec<Strip> = failing().flat_map(rows).collect();
    let planes: Vec<(&Entry<'_>, &Plane)> =
        failing().filter_map(|entry| Some((entry, plane(entry)?))).collect();
    let title = report.stability.title.as_deref().unwrap_or(&report.stability.name);
    let notes = [
        "A strip is a formula over its input, f32 above f64; inputs below 0 have a strip of their own. Far from 1 the \
         axis is squeezed; the grey band is from 1/1000 to 1000. Narrow ranges are drawn wider than they are. Planes: \
         two inputs >= 0 in f64."
            .to_owned(),
        format!("kane {}: {}", env!("CARGO_PKG_VERSION"), report.command),
    ];
    let top = if rows.is_empty() { LEGEND } else { LEGEND + height_of(&rows) + 8.0 };
    let lines = planes.len().div_ceil(COLUMNS);
    let size = (WIDTH, top + PANEL.1 * count(lines));
    let mut canvas = Canvas::new(size, &format!("{title}: where formulas fail"), &notes);
    let named = FAULTS.map(|fault| (fault, fault.to_string()));
    let keys: Vec<(Key, &str)> =
        named.iter().map(|(fault, name)| (Key::Area(ink(Some(*fault))), name.as_str())).collect();
    legend(&mut canvas, (12.0, 2.0), WIDTH - 24.0, &keys);
    if !rows.is_empty() {
        let powers = [-300_i32, -30, -3, 0, 3, 30, 300];
        let tick = |power: &i32| (along(f64::from(*power)), format!("1e{power}"));
        let ticks: Vec<(f64, String)> = powers.iter().map(tick).collect();
        let band = (along(-3.0), along(3.0));
        strips(
            &mut canvas,
            (LEGEND, SPLIT, WIDTH - 24.0),
            &rows,
            ("size of the input; 0 at the left end", &ticks, band),
        );
    }
    for (index, (entry, plane)) in planes.iter().enumerate() {
        let (column, line) = (index % COLUMNS, index / COLUMNS);
        let at = (PANEL.0 * count(column), top + PANEL.1 * count(line));
        draw_plane(&mut canvas, at, entry, plane);
    }
    canvas.finish()
}

/// What can be wrong, the worst first.
pub(super) const FAULTS: [Fault; 5] =
    [Fault::Nan, Fault::Infinite, Fault::WrongSign, Fault::Vanishes, Fault::Lost];

pub(super) const fn ink(fault: Option<Fault>) -> Ink {
    match fault {
        None => Ink::Grid,
        Some(Fault::Lost) => Ink::ORANGE,
        Some(Fault::Vanishes) => Ink::SKY,
        Some(Fault::WrongSign) => Ink::VERMILION,
        Some(Fault::Infinite) => Ink::PURPLE,
        Some(Fault::Nan) => Ink::Text,
    }
}

/// How far along the axis a power of ten is: the middle is 1, and the logarithm of the power counts.
pub(super) fn along(power: f64) -> f64 {
    0.5 + 0.5 * power.signum() * power.abs().ln_1p() / 324.0_f64.ln_1p()
}

/// The rows of a formula of one input, one for each sign of it.
fn rows(entry: &Entry<'_>) -> Vec<Strip> {
    let mut rows = Vec::new();
    for negative in [false, true] {
        let of = |format: &str| {
            entry.lines.iter().find(|line| line.negative == negative && line.format == format)
        };
        let lines: Vec<&Examined> = ["f32", "f64"].into_iter().filter_map(of).copied().collect();
        if lines.iter().all(|line| line.ranges.is_empty()) {
            continue;
        }
        let input = entry.formula.inputs.first().map_or("", |input| input.name.as_str());
        let below = if negative { format!(", {input} < 0") } else { String::new() };
        let with = entry.formula.by.join(", ");
        let with = if with.is_empty() { with } else { format!(" with {with}") };
        let name = super::title(entry.formula) + &with;
        let name = shorten(&name, 54 - below.chars().count()) + &below;
        rows.push(Strip { name, bars: lines.into_iter().map(bar).collect() });
    }
    rows
}

pub(super) fn bar(line: &Examined) -> Bar {
    let place = |point: &kane_measure::Point| match point.value {
        0.0 => 0.0,
        value => along(value.abs().log10()),
    };
    let both = |a: &kane_measure::Point, b: &kane_measure::Point| {
        let (a, b) = (place(a), place(b));
        (a.min(b), a.max(b))
    };
    let part = |range: &kane_measure::Range| (both(&range.from, &range.to), ink(Some(range.fault)));
    Bar {
        domain: both(&line.domain.0, &line.domain.1),
        parts: line.ranges.iter().map(part).collect(),
    }
}

fn draw_plane(canvas: &mut Canvas, at: Point, entry: &Entry<'_>, plane: &Plane) {
    let float = |n: i64| f64::from(i32::try_from(n).unwrap_or(0));
    let cells: Vec<((f64, f64), Option<Fault>)> = plane
        .cells
        .iter()
        .map(|cell| ((float(cell.binades.0), float(cell.binades.1)), cell.sample.fault))
        .collect();
    let name =
        |index: usize| entry.formula.inputs.get(index).map_or("", |input| input.name.as_str());
    // from where to where, and the widest gap between neighbours of the grid, so that no gap shows
    let side = |binades: BTreeSet<i64>| {
        let gaps = binades.iter().zip(binades.iter().skip(1)).map(|(a, b)| b - a);
        let end = |end: Option<&i64>| float(end.copied().unwrap_or(0));
        (end(binades.first()), end(binades.last()), float(gaps.max().unwrap_or(1)))
    };
    let x = side(plane.cells.iter().map(|cell| cell.binades.0).collect());
    let y = side(plane.cells.iter().map(|cell| cell.binades.1).collect());
    let axis = |index: usize, (from, to, step): (f64, f64, f64)| {
        Axis::linear(format!("log2 {}", name(index)), (from, to + step), |n| n.to_string())
    };
    let frame = Frame { at, size: PANEL, head: 26.0, beside: 12.0 };
    let caption = shorten(&super::title(entry.formula), 36);
    let panel = Panel::new(canvas, frame, (axis(0, x), axis(1, y)), &caption);
    for fault in std::iter::once(None).chain(FAULTS.map(Some)) {
        // runs of one fault along a row are one box
        let mut boxes: Vec<(Point, Point)> = Vec::new();
        let mut row: Vec<Point> =
            cells.iter().filter(|(_, f)| *f == fault).map(|(at, _)| *at).collect();
        row.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.total_cmp(&b.0)));
        for (left, below) in row {
            let corners = panel.at((left, below + y.2)).zip(panel.at((left + x.2, below)));
            let Some((first, second)) = corners else { continue };
            match boxes.last_mut() {
                Some((known, end)) if known.1 == first.1 && end.0 >= first.0 - 0.01 => {
                    end.0 = second.0;
                }
                _ => boxes.push((first, second)),
            }
        }
        let strength = if fault.is_none() { 0.6 } else { 1.0 };
        canvas.boxes(&boxes, ink(fault), strength);
    }
}

#[cfg(test)]
mod tests {
    use kane_measure::{Point, Range};

    use super::*;

    fn line(format: &'static str, negative: bool, from: f64, to: f64) -> Examined {
        let point = |value: f64| Point { place: 0, value, text: String::new() };
        let range = Range {
            fault: Fault::Lost,
            from: point(from),
            to: point(to),
            open: (false, false),
            worst: point(from),
            lost: 0,
            computed: String::new(),
            exact: String::new(),
            cause: String::new(),
            better: None,
        };
        Examined {
            formula: 0,
            format,
            precision: 53,
            negative,
            domain: (point(from), point(to)),
            ranges: vec![range],
            worst: (point(from), 0),
            profile: Vec::new(),
            tried: 1,
        }
    }

    #[test]
    fn a_strip_has_the_bars_of_its_own_formats_and_sign() {
        let document = "```kane\nvar x\nlet w := x + 1\n```\n";
        let document =
            kane_audit::read("made-up.md", document.as_bytes()).expect("it is well formed");
        let formula = kane_measure::formulas(&document).formulas.remove(0);
        // in another order than they are drawn in
        let lines = [
            line("f64", true, -1e3, -1.0),
            line("f32", true, -1e-3, 0.0),
            line("f64", false, 1.0, 1e30),
            line("f32", false, 1e-30, 1.0),
        ];
        let entry = |lines: &[Examined]| {
            let lines: Vec<&Examined> = lines.iter().collect();
            let entry =
                Entry { formula: &formula, is_own: true, lines, planes: vec![], searches: vec![] };
            let told = |strip: Strip| {
                let parts = strip.bars.iter().map(|bar| bar.parts[0].0);
                (strip.name, parts.collect::<Vec<_>>())
            };
            rows(&entry).into_iter().map(told).collect::<Vec<_>>()
        };
        let (one, name) = (along(0.0), "w = x + 1");
        assert_eq!(
            entry(&lines),
            [
                (name.to_owned(), vec![(along(-30.0), one), (one, along(30.0))]),
                (format!("{name}, x < 0"), vec![(0.0, along(-3.0)), (one, along(3.0))]),
            ]
        );
        let mut sound = lines;
        sound[0].ranges.clear();
        sound[1].ranges.clear();
        assert_eq!(entry(&sound).len(), 1);
    }
}
