//! The curves as three pictures, one for each question: batches, chains of bounces with their digits, and the audit.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_audit::Verdict;
use kane_measure::growth::{Asked, Chain, Family, Growth};
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

/// What a picture asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    /// What a row costs in batches of many sizes.
    Batch,
    /// How large exact states become, what a bounce costs, and which digits are kept.
    Chain,
    /// What the audit spends on claims of more variables or a higher degree.
    Audit,
}

impl Question {
    /// In words.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::Batch => "What does a row cost in a batch?",
            Self::Chain => "What does a chain of bounces cost, and what does it keep?",
            Self::Audit => "What does the audit of a larger claim cost?",
        }
    }

    /// Whether something was measured that answers it.
    pub(super) fn is_answered(self, growth: &Growth) -> bool {
        match self {
            Self::Batch => growth.batches.iter().any(|batch| !batch.points.is_empty()),
            Self::Chain => !growth.chains.is_empty(),
            Self::Audit => growth.families.iter().any(|family| !family.asked.is_empty()),
        }
    }
}

/// The curves that answer a question, as SVG; `None` where nothing was measured of it.
#[must_use]
pub fn picture(report: &GrowthReport<'_>, question: Question) -> Option<String> {
    if !question.is_answered(report.growth) {
        return None;
    }
    let mut plots = match question {
        Question::Batch => vec![batches(report)],
        Question::Chain => chains(report).into(),
        Question::Audit => audits(report).into(),
    };
    plots.retain(|plot| !plot.curves.is_empty());
    let chains: &[Chain] = if question == Question::Chain { &report.growth.chains } else { &[] };
    let panels = plots.len() + chains.len();
    let columns = COLUMNS.min(panels);
    let size = (PANEL.0 * count(columns), PANEL.1 * count(panels.div_ceil(columns)));
    let mut notes = match question {
        Question::Batch => vec![],
        Question::Chain => vec![
            "Digits of the slip: a full line is what is right, a dashed one what the width of the interval is certain of."
                .to_owned(),
        ],
        Question::Audit => vec!["A cross is undecided.".to_owned()],
    };
    notes.push(report.machine.clone());
    notes.push(format!("kane {}: {}", env!("CARGO_PKG_VERSION"), report.command));
    let mut canvas = Canvas::new(size, question.text(), &notes);
    let frame = |index: usize| {
        let at = (PANEL.0 * count(index % columns), PANEL.1 * count(index / columns));
        Frame { at, size: PANEL, head: 30.0, beside: NAMES }
    };
    for (index, plot) in plots.iter().enumerate() {
        log_log(&mut canvas, frame(index), plot);
    }
    for (index, chain) in chains.iter().enumerate() {
        digits(&mut canvas, frame(plots.len() + index), chain);
    }
    Some(canvas.finish())
}

fn float(n: u64) -> f64 {
    f64::from(u32::try_from(n / 1000).unwrap_or(u32::MAX)) * 1000.0
        + f64::from(u32::try_from(n % 1000).unwrap_or(0))
}

fn curve(index: usize, name: impl Into<String>, points: Vec<Point>) -> Curve {
    let ink = if index == 0 { Ink::Text } else { Ink::Series(index - 1) };
    Curve { name: name.into(), points, pen: Pen::new(ink, 2.0), undecided: None }
}

fn plot(
    caption: &str,
    x: &'static str,
    y: &'static str,
    curves: impl Iterator<Item = Curve>,
) -> Plot {
    let curves = curves.filter(|curve| !curve.points.is_empty()).collect();
    Plot { caption: caption.to_owned(), x, y, curves }
}

/// The time of a row, over rows.
fn batches(report: &GrowthReport<'_>) -> Plot {
    let batches = report.growth.batches.iter().enumerate().map(|(index, batch)| {
        let points = batch.points.iter().map(|p| (count(p.rows), float(p.time.median) / 1000.0));
        curve(index, batch.name, points.collect())
    });
    plot("Rows in a batch", "rows", "ns a row", batches)
}

/// Size and time of a bounce, over bounces.
fn chains(report: &GrowthReport<'_>) -> [Plot; 2] {
    let chains = &report.growth.chains;
    let bits = chains.iter().enumerate().map(|(index, chain)| {
        let point = |b: &kane_measure::growth::Bounce| Some((count(b.n), float(b.bits?)));
        curve(index, chain.law, chain.bounces.iter().filter_map(point).collect())
    });
    // floats take the same time at every bounce: one law stands for all
    let systems = [System::Rational, System::F64, System::DoubleDouble, System::Interval];
    let times = chains.iter().enumerate().flat_map(|(index, chain)| {
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
    [
        plot("An exact chain of bounces: its size", "bounces", "bits", bits),
        plot("A chain of bounces: time of one", "bounces", "ns", times),
    ]
}

/// Steps and time of a claim, over its size.
fn audits(report: &GrowthReport<'_>) -> [Plot; 2] {
    let audit = |caption: &str, y, cost: fn(&Asked) -> Option<u64>| {
        let of = |(index, family): (usize, &Family)| {
            let at = |asked: &Asked| Some((count(asked.size), float(cost(asked)?).max(1.0)));
            let points: Vec<Point> = family.asked.iter().filter_map(at).collect();
            let open = family.asked.iter().find(|a| a.verdict == Verdict::Undecided);
            Curve { undecided: open.and_then(at), ..curve(index, family.name, points) }
        };
        plot(caption, "variables or degree", y, report.growth.families.iter().enumerate().map(of))
    };
    [
        audit("The audit: steps of search", "steps", |asked| Some(asked.steps)),
        audit("The audit: time", "us", |asked| asked.time.map(|time| time / 1_000_000)),
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
