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

#[cfg(test)]
mod tests {
    use kane_measure::chart::Time;
    use kane_measure::growth::{Batch, Bounce, Digits, Rows, Way};

    use super::*;
    use crate::picture::seen::Seen;

    const AT: Frame = Frame { at: (0.0, 0.0), size: PANEL, head: 30.0, beside: NAMES };

    fn bounce(n: usize) -> Bounce {
        Bounce { n, bits: None, digits: Vec::new(), times: Vec::new() }
    }

    fn growth() -> Growth {
        let rows = |rows, median| Rows {
            rows,
            time: Time { median, quartiles: (median, median), rounds: 3 },
        };
        let first = Bounce {
            bits: Some(700),
            times: vec![(System::F64, 4_000), (System::Rational, 123_456_000)],
            digits: vec![
                (System::F64, Digits { right: Some(1500), certain: None }),
                (System::Interval, Digits { right: Some(i64::MAX), certain: Some(1400) }),
            ],
            ..bounce(1)
        };
        let second = Bounce { bits: Some(1_400), ..bounce(2) };
        let last = Bounce {
            times: vec![(System::F64, 5_000)],
            digits: vec![(System::F64, Digits { right: Some(50), certain: None })],
            ..bounce(100)
        };
        let other =
            Bounce { times: vec![(System::F64, 9), (System::Rational, 7_000)], ..bounce(1) };
        let asked = |size, verdict, steps, time| Asked { size, verdict, link: None, steps, time };
        Growth {
            batches: vec![Batch {
                name: "kernel",
                way: Way::Columns,
                points: vec![rows(10, 2_500), rows(1_000_000, 750)],
            }],
            chains: vec![
                Chain { law: "first", bounces: vec![first, second, last], ended: Vec::new() },
                Chain { law: "second", bounces: vec![other], ended: Vec::new() },
            ],
            families: vec![Family {
                name: "sums",
                grows: "variables",
                asked: vec![
                    asked(2, Verdict::Proved, 30, Some(4_000_000)),
                    asked(8, Verdict::Undecided, 500, None),
                ],
            }],
        }
    }

    fn report(growth: &Growth) -> GrowthReport<'_> {
        GrowthReport { growth, machine: "a machine".to_owned(), command: "kane growth".to_owned() }
    }

    fn told(plot: &Plot) -> Vec<(&str, &[Point])> {
        plot.curves.iter().map(|curve| (curve.name.as_str(), curve.points.as_slice())).collect()
    }

    #[test]
    fn times_of_a_row_are_in_nanoseconds_and_those_of_a_claim_in_microseconds() {
        let growth = growth();
        let report = report(&growth);
        assert_eq!(told(&batches(&report)), [("kernel", &[(10.0, 2.5), (1e6, 0.75)][..])]);
        let [size, time] = chains(&report);
        assert_eq!((size.y, time.y), ("bits", "ns"));
        assert_eq!(told(&size), [("first", &[(1.0, 700.0), (2.0, 1400.0)][..])]);
        // all systems of the first law, and the exact one of the others
        assert_eq!(
            told(&time),
            [
                ("first, rational", &[(1.0, 123_456.0)][..]),
                ("first, f64", &[(1.0, 4.0), (100.0, 5.0)][..]),
                ("second, rational", &[(1.0, 7.0)][..]),
            ]
        );
        let [steps, time] = audits(&report);
        assert_eq!((steps.y, time.y), ("steps", "us"));
        assert_eq!(told(&steps), [("sums", &[(2.0, 30.0), (8.0, 500.0)][..])]);
        assert_eq!(told(&time), [("sums", &[(2.0, 4.0)][..])]);
        assert_eq!(steps.curves[0].undecided, Some((8.0, 500.0)));
        assert_eq!(time.curves[0].undecided, None);
    }

    #[test]
    fn a_large_number_is_the_same_as_a_float() {
        let told = [0, 7, 999, 1_000, 1_001, 4_294_967_295_999, 123_456_789_012].map(float);
        let expected = [0.0, 7.0, 999.0, 1_000.0, 1_001.0, 4_294_967_295_999.0, 123_456_789_012.0];
        assert_eq!(told, expected);
    }

    /// What the dots say: places of them by the numbers at the axes.
    fn dots(canvas: Canvas, logarithmic: [bool; 2]) -> Vec<(String, String)> {
        let seen = Seen::of(&canvas.finish());
        let scales = seen.scales(logarithmic);
        seen.circles().iter().map(|dot| scales.told(dot.at)).collect()
    }

    fn pair(x: &str, y: &str) -> (String, String) {
        (x.to_owned(), y.to_owned())
    }

    #[test]
    fn a_curve_goes_through_its_points_and_a_cross_is_where_it_is_undecided() {
        let mut canvas = Canvas::new(PANEL, "", &[]);
        let points = vec![(2.0, 30.0), (20.0, 500.0), (200.0, 50.0)];
        let mut of = curve(0, "a curve", points);
        of.undecided = Some((20.0, 500.0));
        let plot = plot("A plot", "size", "steps", [of].into_iter());
        log_log(&mut canvas, AT, &plot);
        let seen = Seen::of(&canvas.finish());
        let scales = seen.scales([true, true]);
        let dots: Vec<_> = seen.circles().iter().map(|dot| scales.told(dot.at)).collect();
        assert_eq!(dots, [pair("2", "30"), pair("20", "500"), pair("200", "50")]);
        let centre = seen.circles()[1].at;
        let crossing: Vec<[Point; 2]> = seen
            .lines()
            .iter()
            .rev()
            .take(2)
            .map(|line| {
                [0, 1].map(|end| (line.points[end].0 - centre.0, line.points[end].1 - centre.1))
            })
            .map(|ends| ends.map(|(x, y)| ((x * 10.0).round() / 10.0, (y * 10.0).round() / 10.0)))
            .collect();
        assert_eq!(crossing, [[(-6.0, 6.0), (6.0, -6.0)], [(-6.0, -6.0), (6.0, 6.0)]]);
        assert!(seen.place("a curve").is_some() && seen.place("A plot").is_some());
    }

    #[test]
    fn digits_of_a_chain_stand_at_their_bounce() {
        let growth = growth();
        let mut canvas = Canvas::new(PANEL, "", &[]);
        digits(&mut canvas, AT, &growth.chains[0]);
        // f64, then what is right and what is certain of the interval; what has no error is drawn at 38
        let expected = [pair("1", "15"), pair("100", "0.5"), pair("1", "38"), pair("1", "14")];
        assert_eq!(dots(canvas, [true, false]), expected);
    }

    #[test]
    fn a_picture_has_a_panel_for_each_curve_that_was_measured() {
        let growth = growth();
        let captions = |question| {
            let svg = picture(&report(&growth), question).expect("a picture");
            let seen = Seen::of(&svg);
            let all = [
                "Rows in a batch",
                "An exact chain of bounces: its size",
                "A chain of bounces: time of one",
                "first: digits of the slip",
                "second: digits of the slip",
                "The audit: steps of search",
                "The audit: time",
            ];
            let found = all.into_iter().filter_map(|caption| Some((caption, seen.place(caption)?)));
            found.map(|(caption, (x, y))| (caption, x > PANEL.0, y > PANEL.1)).collect::<Vec<_>>()
        };
        assert_eq!(captions(Question::Batch), [("Rows in a batch", false, false)]);
        assert_eq!(
            captions(Question::Chain),
            [
                ("An exact chain of bounces: its size", false, false),
                ("A chain of bounces: time of one", true, false),
                ("first: digits of the slip", false, true),
                ("second: digits of the slip", true, true),
            ]
        );
        let audit =
            [("The audit: steps of search", false, false), ("The audit: time", true, false)];
        assert_eq!(captions(Question::Audit), audit);
        let nothing = Growth { batches: vec![], chains: vec![], families: vec![] };
        for question in [Question::Batch, Question::Chain, Question::Audit] {
            assert!(picture(&report(&nothing), question).is_none());
            assert!(question.text().ends_with('?'));
        }
        let unasked = Growth {
            batches: vec![Batch { points: vec![], ..growth.batches[0].clone() }],
            families: vec![Family { asked: vec![], ..growth.families[0].clone() }],
            chains: vec![],
        };
        assert!(picture(&report(&unasked), Question::Batch).is_none());
        assert!(picture(&report(&unasked), Question::Audit).is_none());
    }
}
