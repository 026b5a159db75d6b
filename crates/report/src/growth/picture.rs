//! The curves as a picture: batches, exact states, digits under each law, and the audit.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_audit::Verdict;
use kane_measure::growth::{Asked, Chain, Family};
use kane_number::System;

use super::{FLOATING, GrowthReport};
use crate::chart::ink;
use crate::picture::{Axis, Canvas, Frame, Ink, Panel, Pen, Point, count};
use crate::shorten::shorten;

/// Size of a panel; panels in a row; room for names at the ends of lines, and their letters.
const PANEL: Point = (640.0, 330.0);
const COLUMNS: usize = 2;
const NAMES: f64 = 230.0;
const LETTERS: usize = 30;
/// Where an answer without an error is drawn, in digits.
const EXACT: f64 = 38.0;

/// A curve, with a mark where it ends undecided.
struct Curve {
    name: String,
    points: Vec<Point>,
    pen: Pen,
    undecided: Option<Point>,
}

/// A panel: its caption, what it shows over what, and the curves.
struct Plot {
    caption: String,
    x: &'static str,
    y: &'static str,
    curves: Vec<Curve>,
}

/// All curves, as SVG.
#[must_use]
pub fn picture(report: &GrowthReport<'_>) -> String {
    let growth = report.growth;
    let plots: Vec<Plot> =
        costs(report).into_iter().filter(|plot| !plot.curves.is_empty()).collect();
    let rows = (plots.len() + growth.chains.len()).div_ceil(COLUMNS);
    let size = (PANEL.0 * count(COLUMNS), PANEL.1 * count(rows));
    let notes = [
        "A cross is undecided. Digits: a full line is what is right, a dashed one what the width of the interval is \
         certain of."
            .to_owned(),
        report.machine.clone(),
        format!("kane {}: {}", env!("CARGO_PKG_VERSION"), report.command),
    ];
    let mut canvas = Canvas::new(size, "How does cost grow with size?", &notes);
    let frame = |index: usize| {
        let at = (PANEL.0 * count(index % COLUMNS), PANEL.1 * count(index / COLUMNS));
        Frame { at, size: PANEL, head: 30.0, beside: NAMES }
    };
    for (index, plot) in plots.iter().enumerate() {
        log_log(&mut canvas, frame(index), plot);
    }
    for (index, chain) in growth.chains.iter().enumerate() {
        digits(&mut canvas, frame(plots.len() + index), chain);
    }
    canvas.finish()
}

fn float(n: u64) -> f64 {
    f64::from(u32::try_from(n / 1000).unwrap_or(u32::MAX)) * 1000.0
        + f64::from(u32::try_from(n % 1000).unwrap_or(0))
}

fn curve(index: usize, name: impl Into<String>, points: Vec<Point>) -> Curve {
    let ink = if index == 0 { Ink::Text } else { Ink::Series(index - 1) };
    Curve { name: name.into(), points, pen: Pen::new(ink, 2.0), undecided: None }
}

/// The curves of cost.
fn costs(report: &GrowthReport<'_>) -> [Plot; 5] {
    let growth = report.growth;
    let batches = growth.batches.iter().enumerate().map(|(index, batch)| {
        let points = batch.points.iter().map(|p| (count(p.rows), float(p.time.median) / 1000.0));
        curve(index, batch.name, points.collect())
    });
    let bits = growth.chains.iter().enumerate().map(|(index, chain)| {
        let point = |b: &kane_measure::growth::Bounce| Some((count(b.n), float(b.bits?)));
        curve(index, chain.law, chain.bounces.iter().filter_map(point).collect())
    });
    // floats take the same time at every bounce: one law stands for all
    let systems = [System::Rational, System::F64, System::DoubleDouble, System::Interval];
    let times = growth.chains.iter().enumerate().flat_map(|(index, chain)| {
        let shown = if index == 0 { systems.len() } else { 1 };
        systems.into_iter().take(shown).map(move |system| {
            let points = chain.bounces.iter().filter_map(|bounce| {
                let time = bounce.times.iter().find(|(known, _)| *known == system)?.1;
                Some((count(bounce.n), float(time) / 1000.0))
            });
            (format!("{}, {system}", chain.law), points.collect::<Vec<Point>>())
        })
    });
    let times = times.filter(|(_, points)| !points.is_empty()).enumerate();
    let times = times.map(|(index, (name, points))| curve(index, name, points));
    let audit = |cost: fn(&Asked) -> Option<u64>| -> Vec<Curve> {
        let of = |(index, family): (usize, &Family)| {
            let at = |asked: &Asked| Some((count(asked.size), float(cost(asked)?).max(1.0)));
            let points: Vec<Point> = family.asked.iter().filter_map(at).collect();
            let open = family.asked.iter().find(|a| a.verdict == Verdict::Undecided);
            Curve { undecided: open.and_then(at), ..curve(index, family.name, points) }
        };
        let drawn = growth.families.iter().enumerate().map(of);
        drawn.filter(|curve| !curve.points.is_empty()).collect()
    };
    let size = "variables or degree";
    let plot = |caption: &str, x, y, curves: Vec<Curve>| {
        let curves = curves.into_iter().filter(|curve| !curve.points.is_empty()).collect();
        Plot { caption: caption.to_owned(), x, y, curves }
    };
    [
        plot("Rows in a batch", "rows", "ns a row", batches.collect()),
        plot("An exact chain of bounces: its size", "bounces", "bits", bits.collect()),
        plot("A chain of bounces: time of one", "bounces", "ns", times.collect()),
        plot("The audit: steps of search", size, "steps", audit(|asked| Some(asked.steps))),
        plot("The audit: time", size, "us", audit(|a| a.time.map(|time| time / 1_000_000))),
    ]
}

fn log_log(canvas: &mut Canvas, frame: Frame, plot: &Plot) {
    let all = || plot.curves.iter().flat_map(|curve| &curve.points);
    let ends = |of: fn(&Point) -> f64| {
        let least = all().map(of).fold(f64::INFINITY, f64::min).max(1e-3);
        (least, all().map(of).fold(least * 2.0, f64::max))
    };
    let (x, y) = (ends(|point| point.0), ends(|point| point.1));
    let name = |n: f64| if n < 1e4 { n.to_string() } else { format!("{n:e}") };
    let axes = (
        Axis::logarithmic(plot.x, (x.0, x.1 * 1.05), name),
        Axis::logarithmic(plot.y, (y.0 * 0.7, y.1 * 1.4), name),
    );
    let panel = Panel::new(canvas, frame, axes, &plot.caption);
    let line = |curve: &Curve| (shorten(&curve.name, LETTERS), curve.points.clone(), curve.pen);
    panel.named(canvas, &plot.curves.iter().map(line).collect::<Vec<_>>());
    for curve in &plot.curves {
        let Some((x, y)) = curve.undecided.and_then(|at| panel.at(at)) else { continue };
        let pen = Pen::new(curve.pen.ink, 3.0);
        canvas.line(&[(x - 6.0, y - 6.0), (x + 6.0, y + 6.0)], pen);
        canvas.line(&[(x - 6.0, y + 6.0), (x + 6.0, y - 6.0)], pen);
    }
}

/// The digits of the slip that each system keeps under one law.
fn digits(canvas: &mut Canvas, frame: Frame, chain: &Chain) {
    let last = chain.bounces.last().map_or(2.0, |bounce| count(bounce.n)).max(2.0);
    let axes = (
        Axis::logarithmic("bounces", (1.0, last), |n| n.to_string()),
        Axis::linear("decimal digits", (-1.0, 40.0), |n| n.to_string()),
    );
    let caption = format!("{}: digits of the slip", chain.law);
    let panel = Panel::new(canvas, frame, axes, &caption);
    let mut lines = Vec::new();
    for system in FLOATING {
        for (certain, word, dashes) in [(false, "right", ""), (true, "certain", "6 4")] {
            let points = chain.bounces.iter().filter_map(|bounce| {
                let digits = bounce.digits.iter().find(|(known, _)| *known == system)?.1;
                let digits = if certain { digits.certain } else { digits.right }?;
                let digits = f64::from(i32::try_from(digits).unwrap_or(i32::MAX)) / 100.0;
                Some((count(bounce.n), digits.min(EXACT)))
            });
            let points: Vec<Point> = points.collect();
            if !points.is_empty() {
                let pen = Pen::new(ink(system), 2.0).dashed(dashes);
                lines.push((format!("{system}, {word}"), points, pen));
            }
        }
    }
    panel.named(canvas, &lines);
}
