//! Speed against accuracy at a glance: one panel for all methods of the paper's law.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_measure::chart::Measured;
use kane_number::System;

use super::picture::{digits_axis, ink, place, shape};
use super::{ChartReport, digits, nanoseconds};
use crate::picture::{
    Axis, Callout, Canvas, Frame, Ink, Key, Panel, Pen, Point, callouts, legend, mark, staircase,
};
use crate::shorten::in_print;

/// The plot with its axes, and the height of the legend.
const SIZE: Point = (760.0, 500.0);
const LEGEND: f64 = 30.0;
/// What nothing beats.
const STAIRS: Pen = Pen::new(Ink::GREY, 2.0);
/// Digits from which a float and a double-double count as right, and below which nothing is left.
const DOUBLE: f64 = 15.0;
const WIDE: f64 = 30.0;
const WRONG: f64 = 0.5;

/// A method that was timed.
pub(crate) struct Timed<'a> {
    pub(crate) measured: &'a Measured,
    /// picoseconds and digits
    pub(crate) at: Point,
    /// quantities that it gives at once
    pub(crate) quantities: usize,
}

/// The timed methods of the law that comes first, the paper's. A kernel over columns gives several quantities for
/// one price, so that it is one method, as good as at the worst of them.
pub(crate) fn timed<'a>(report: &ChartReport<'a>) -> Vec<Timed<'a>> {
    let all = report.all;
    let law = all.first().map(|measured| measured.method.law);
    let mut methods: Vec<Timed<'_>> = Vec::new();
    let own = all.iter().filter(|m| Some(m.method.law) == law && m.time.is_some());
    for measured in own {
        let at = place(measured);
        let kernel = methods.iter_mut().find(|known| {
            let (a, b) = (&known.measured.method, &measured.method);
            a.name == "columns" && (a.name, a.system) == (b.name, b.system)
        });
        match kernel {
            Some(known) => {
                known.quantities += 1;
                if at.1 < known.at.1 {
                    (known.measured, known.at.1) = (measured, at.1);
                }
            }
            None => methods.push(Timed { measured, at, quantities: 1 }),
        }
    }
    methods
}

/// What the picture says at a point.
pub(crate) struct Reading {
    at: Point,
    system: System,
    /// the method, and what it comes to
    lines: [String; 2],
    /// whether no digit is right
    pub(crate) is_wrong: bool,
}

impl Reading {
    /// Both lines as one sentence, without its full stop.
    pub(crate) fn sentence(&self) -> String {
        self.lines.join(" ")
    }
}

/// What the picture says at four of its points: of the cheapest `f64` that is right, of the cheapest double-double, of
/// exact fractions, and of the cheapest `f64` that is wrong.
pub(crate) fn readings(methods: &[Timed<'_>]) -> Vec<Reading> {
    let cheapest = |system: System, is_meant: &dyn Fn(f64) -> bool| {
        let meant = methods.iter().filter(|timed| timed.measured.method.system == system);
        let meant = meant.filter(|timed| is_meant(timed.at.1));
        meant.min_by(|a, b| a.at.0.total_cmp(&b.at.0))
    };
    let price = |timed: &Timed<'_>| {
        format!("{} ns", nanoseconds(timed.measured.time.as_ref().map_or(0, |time| time.median)))
    };
    let right = |timed: &Timed<'_>| digits(timed.measured.accuracy.worst);
    let reading = |timed: &Timed<'_>, head: String, line: String| Reading {
        at: timed.at,
        system: timed.measured.method.system,
        lines: [head, line],
        is_wrong: timed.at.1 < WRONG,
    };
    let double = cheapest(System::F64, &|digits| digits > DOUBLE);
    let mut readings = Vec::new();
    if let Some(timed) = double {
        let all = match timed.quantities {
            1 => String::new(),
            n => format!(" for all {n} quantities"),
        };
        let line = format!("{} digits in {}{all}", right(timed), price(timed));
        readings.push(reading(timed, format!("f64, {}:", name(timed)), line));
    }
    if let Some(timed) = cheapest(System::DoubleDouble, &|digits| digits > WIDE) {
        let times = double.map(|double| timed.at.0 / double.at.0);
        let times = times.map_or_else(String::new, |n| format!(", {n:.0} times the price"));
        let line = format!("{} digits in {}{times}", right(timed), price(timed));
        readings.push(reading(timed, format!("double-double, {}:", name(timed)), line));
    }
    if let Some(timed) = cheapest(System::Rational, &|_| true) {
        let line = format!("all digits from {} on", price(timed));
        readings.push(reading(timed, "exact fractions:".to_owned(), line));
    }
    if let Some(timed) = cheapest(System::F64, &|digits| digits < WRONG) {
        let line = format!("no digit is right, in {}", price(timed));
        readings.push(reading(timed, format!("f64, rewritten, {}:", name(timed)), line));
    }
    readings
}

/// What a method is called.
fn name(timed: &Timed<'_>) -> String {
    match timed.measured.method.name {
        "law" => "the law's code".to_owned(),
        "columns" => "in columns".to_owned(),
        name => format!("{name} {}", in_print(timed.measured.method.text)),
    }
}

/// Every timed method of the paper's law in one panel, as SVG: the digits that are right at its worst input, over the
/// time of one evaluation; a staircase of what nothing beats; and at four points what they say.
#[must_use]
pub fn speed_accuracy(report: &ChartReport<'_>) -> String {
    let methods = timed(report);
    let law = methods.first().map_or("", |timed| timed.measured.method.law);
    let notes = [
        format!(
            "Each mark is a way to compute k, i_x or Δe of {law}: up, the decimal digits that are right at the worst \
             of about a thousand α from 2^-30 to 2^30; to the right, its time. A kernel over columns gives all \
             quantities of a row at once, and is drawn once, with the price of the whole row and the digits of the \
             worst. Nothing beats the grey line."
        ),
        report.machine.clone(),
        format!("kane {}: {}", env!("CARGO_PKG_VERSION"), report.command),
    ];
    let size = (SIZE.0, SIZE.1 + LEGEND);
    let mut canvas = Canvas::new(size, "How fast, and how many digits are right?", &notes);
    let names = System::ALL.map(|system| (system, system.to_string()));
    let mut keys: Vec<(Key, &str)> = names
        .iter()
        .map(|(system, name)| (Key::Mark(shape(*system), ink(*system)), name.as_str()))
        .collect();
    keys.push((Key::Line(STAIRS), "nothing is faster and better"));
    legend(&mut canvas, (12.0, 2.0), SIZE.0 - 24.0, &keys);
    let times = || methods.iter().map(|timed| timed.at.0);
    let least = times().fold(f64::INFINITY, f64::min).min(1000.0) / 1.6;
    let most = times().fold(least * 10.0, f64::max) * 1.6;
    let time = Axis::logarithmic("time of one evaluation", (least, most), in_words);
    let frame = Frame { at: (0.0, LEGEND), size: SIZE, head: 10.0, beside: 16.0 };
    let panel = Panel::new(&mut canvas, frame, (time, digits_axis()), "");
    let mut steps: Vec<Point> = Vec::new();
    let mut sorted: Vec<Point> = methods.iter().map(|timed| timed.at).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.total_cmp(&a.1)));
    for at in sorted {
        if steps.last().is_none_or(|last| at.1 > last.1) {
            steps.push(at);
        }
    }
    steps.extend(steps.last().map(|last| (most, last.1)));
    let stairs = panel.places(staircase(&steps));
    // nothing is above the line
    let window = panel.window;
    if let (Some(first), Some(last)) = (stairs.first(), stairs.last()) {
        let above = [(last.0, window.top), (first.0, window.top)];
        let area: Vec<Point> = stairs.iter().copied().chain(above).collect();
        canvas.area(&area, Ink::Grid, 0.45);
    }
    canvas.line(&stairs, STAIRS);
    let mut marks: Vec<Point> = Vec::new();
    for timed in &methods {
        let Some(at) = panel.at(timed.at) else { continue };
        let system = timed.measured.method.system;
        mark(&mut canvas, at, shape(system), ink(system));
        if timed.quantities > 1 {
            canvas.ring(at, 10.0, Pen::new(ink(system), 1.5));
        }
        marks.push(at);
    }
    let words: Vec<Callout> = readings(&methods)
        .into_iter()
        .filter_map(|reading| {
            let (at, ink) = (panel.at(reading.at)?, ink(reading.system));
            Some(Callout { at, lines: reading.lines.to_vec(), ink })
        })
        .collect();
    callouts(&mut canvas, &window, (&marks, &[stairs]), &words);
    canvas.finish()
}

/// Picoseconds on an axis: `10 ns`, `1 µs`.
fn in_words(picoseconds: f64) -> String {
    match picoseconds {
        ps if ps < 1e3 => format!("{ps} ps"),
        ps if ps < 1e6 => format!("{} ns", ps / 1e3),
        ps if ps < 1e9 => format!("{} µs", ps / 1e6),
        ps => format!("{} ms", ps / 1e9),
    }
}
