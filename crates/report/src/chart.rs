//! Speed against accuracy: text, Markdown, JSON and CSV. The picture is in `chart_picture`.

use std::fmt::Write as _;

use anstyle::{AnsiColor, Style};
use kane_measure::chart::{Measured, Method, Proved, contradictions, front};
use kane_number::Rational;
use num_bigint::BigInt;
use serde::Serialize;

use crate::envelope::{Program, Schema, written};

use crate::Page;
use crate::shorten::{padded, shorten};
use crate::stability::quoted;

/// Columns where the page has no width.
const WIDTH: usize = 110;

/// The methods with their errors, their times if they were taken, and where that was.
#[derive(Clone, Debug)]
pub struct ChartReport<'a> {
    /// the methods, by law and quantity
    pub all: &'a [Measured],
    /// machine and compiler, for the footer
    pub machine: String,
    /// a command that prints this report
    pub command: String,
}

/// Hundredths of digits as digits with one decimal.
pub(crate) fn digits(hundredths: i64) -> String {
    if hundredths == i64::MAX {
        return "exact".to_owned();
    }
    format!("{}.{}", hundredths / 100, hundredths % 100 / 10)
}

/// Picoseconds as nanoseconds to three digits or so.
pub(crate) fn nanoseconds(picoseconds: u64) -> String {
    match picoseconds {
        0..10_000 => format!("{}.{:02}", picoseconds / 1000, picoseconds % 1000 / 10),
        10_000..100_000 => format!("{}.{}", picoseconds / 1000, picoseconds % 1000 / 100),
        _ => (picoseconds / 1000).to_string(),
    }
}

/// An error in hundredths of log₂ ulps, as ulps.
fn ulps(hundredths: Option<i64>) -> String {
    match hundredths {
        None => String::new(),
        Some(h) if h <= 0 => "<= 1".to_owned(),
        Some(h) => format!("2^{}.{}", h / 100, h % 100 / 10),
    }
}

/// The bound that is proved, in ulps; that none is, where an error is measured in them.
fn bound(measured: &Measured) -> String {
    match &measured.proved {
        Some(proved) => proved.ulps.to_string(),
        None if measured.accuracy.ulps.is_some() && measured.accuracy.worst != i64::MAX => {
            "none".to_owned()
        }
        None => String::new(),
    }
}

/// The same with a dagger where the bound ends before the domain does.
fn daggered(measured: &Measured) -> String {
    let (_, last) = kane_measure::chart::DOMAIN;
    let is_partial = measured.proved.as_ref().is_some_and(|p| reach(p) != format!("2^{last}"));
    bound(measured) + if is_partial { "†" } else { "" }
}

/// Where a proved bound ends, as a power of two.
pub(crate) fn reach(proved: &Proved) -> String {
    match proved.to.numer().bits() {
        bits @ 1.. if proved.to == Rational::from_integer(BigInt::from(1) << (bits - 1)) => {
            format!("2^{}", bits - 1)
        }
        _ => proved.to.to_string(),
    }
}

/// The form as written, or that it is the law's own code.
const fn form_of(method: &Method) -> &'static str {
    if method.is_law { "the program's own" } else { method.text }
}

impl ChartReport<'_> {
    /// Groups of methods for one quantity of one law, in the order of the registry, each with the
    /// cheaper method first.
    pub(crate) fn groups(&self) -> Vec<((&'static str, &'static str), Vec<usize>)> {
        let mut groups: Vec<((&str, &str), Vec<usize>)> = Vec::new();
        for (index, measured) in self.all.iter().enumerate() {
            let key = (measured.method.law, measured.method.quantity);
            match groups.iter_mut().find(|(known, _)| *known == key) {
                Some((_, group)) => group.push(index),
                None => groups.push((key, vec![index])),
            }
        }
        let price = |index: &usize| {
            let measured = self.all.get(*index);
            let time = measured.and_then(|m| m.time.as_ref()).map(|time| time.median);
            let cost = measured.and_then(|m| m.cost);
            (time, cost.unwrap_or(u64::MAX), measured.map(|m| m.method.system))
        };
        for (_, group) in &mut groups {
            group.sort_by_key(price);
        }
        groups
    }

    /// What the proved bounds are about, and where one ends before the domain does.
    pub(crate) fn notes(&self) -> Vec<String> {
        let (_, last) = kane_measure::chart::DOMAIN;
        let mut notes = vec![format!(
            "proved: no error for alpha from 0 to 2^{last} is larger, in ulps (docs/rounding)"
        )];
        for measured in self.all {
            let Some(proved) = &measured.proved else { continue };
            if reach(proved) == format!("2^{last}") {
                continue;
            }
            let Method { law, quantity, name, system, .. } = measured.method;
            notes.push(format!(
                "† proved to alpha = {} only, and up to there at most {} measured: {law} {quantity} {name} in {system}",
                reach(proved),
                ulps(proved.measured),
            ));
        }
        notes
    }

    /// What the clock says against the counted costs, one line a pair, at most some.
    fn warnings(&self) -> Vec<String> {
        let name = |index: usize| {
            self.all.get(index).map_or_else(String::new, |m| {
                format!(
                    "{} {} {} in {}",
                    m.method.law, m.method.quantity, m.method.name, m.method.system
                )
            })
        };
        contradictions(self.all)
            .into_iter()
            .map(|(a, b)| {
                format!("warning: counted as cheaper, but slower: {} than {}", name(a), name(b))
            })
            .collect()
    }
}

/// The table for a terminal. Stars mark the Pareto front: nothing else is both cheaper and better.
#[must_use]
pub fn text(report: &ChartReport<'_>, page: Page) -> String {
    let width = page.width.unwrap_or(WIDTH);
    let ink = |style: Style| if page.colour { style } else { Style::new() };
    let bold = ink(Style::new().bold());
    let green = ink(Style::new().fg_color(Some(AnsiColor::Green.into())));
    let front = front(report.all);
    let mut out = String::from(
        "What does the next digit cost? Per group the cheapest comes first; * nothing else is both\n\
         cheaper and better. Digits that are right, at the worst and at the median input.\n",
    );
    for ((law, quantity), group) in report.groups() {
        let _ = writeln!(out, "\n{bold}{law}  {quantity}{bold:#}");
        let _ = writeln!(
            out,
            "    {:>7} {:>15}  {:>5} {:>6}  {:>6} {:>6}  {:>10}  {:13}  form",
            "ns", "quartiles", "worst", "median", "ulps", "proved", "at alpha", "system"
        );
        for index in group {
            let Some(measured) = report.all.get(index) else { continue };
            let on_front = front.get(index).copied().unwrap_or(false);
            let (time, quartiles) = match &measured.time {
                Some(time) => {
                    let (low, high) = time.quartiles;
                    (
                        nanoseconds(time.median),
                        format!("{} .. {}", nanoseconds(low), nanoseconds(high)),
                    )
                }
                None => (String::new(), String::new()),
            };
            let accuracy = &measured.accuracy;
            let exact = accuracy.worst == i64::MAX;
            let at = if exact { String::new() } else { format!("{:.3e}", accuracy.at) };
            let row = format!(
                "  {} {time:>7} {quartiles:>15}  {:>5} {:>6}  {:>6} {:>6}  {at:>10}  {}  {}  {}",
                if on_front { "*" } else { " " },
                digits(accuracy.worst),
                digits(accuracy.median),
                if exact { String::new() } else { ulps(accuracy.ulps) },
                daggered(measured),
                padded(&measured.method.system.to_string(), 13),
                padded(measured.method.name, 7),
                form_of(&measured.method),
            );
            let ink = if on_front { green } else { Style::new() };
            let _ = writeln!(out, "{ink}{}{ink:#}", shorten(&row, width));
        }
    }
    out.push('\n');
    for note in report.notes() {
        let _ = writeln!(out, "{}", shorten(&note, width));
    }
    let warnings = report.warnings();
    for warning in warnings.iter().take(5) {
        let _ = writeln!(out, "{}", shorten(warning, width));
    }
    if warnings.len() > 5 {
        let _ = writeln!(out, "warning: and {} more pairs", warnings.len() - 5);
    }
    let _ = writeln!(
        out,
        "\n{}\nkane {}: {}",
        report.machine,
        env!("CARGO_PKG_VERSION"),
        report.command
    );
    out
}

/// The table for the web.
#[must_use]
pub fn markdown(report: &ChartReport<'_>) -> String {
    let front = front(report.all);
    let mut out = String::from(
        "# Speed against accuracy\n\nBold: nothing else is both cheaper and better.\n",
    );
    for ((law, quantity), group) in report.groups() {
        let _ = writeln!(out, "\n## {law}: {quantity}\n");
        out.push_str("| ns | quartiles | digits, worst | digits, median | ulps, worst | ulps, proved | worst alpha | system | form |\n|---|---|---|---|---|---|---|---|---|\n");
        for index in group {
            let Some(measured) = report.all.get(index) else { continue };
            let (time, quartiles) = measured.time.as_ref().map_or_else(Default::default, |time| {
                let (low, high) = time.quartiles;
                (nanoseconds(time.median), format!("{}–{}", nanoseconds(low), nanoseconds(high)))
            });
            let worst = digits(measured.accuracy.worst);
            let on_front = front.get(index).copied().unwrap_or(false);
            let worst = if on_front { format!("**{worst}**") } else { worst };
            let method = &measured.method;
            let form = form_of(method);
            let _ = writeln!(
                out,
                "| {time} | {quartiles} | {worst} | {} | {} | {} | {:e} | {} | {} `{form}` |",
                digits(measured.accuracy.median),
                ulps(measured.accuracy.ulps.filter(|_| measured.accuracy.worst != i64::MAX)),
                daggered(measured),
                measured.accuracy.at,
                method.system,
                method.name,
            );
        }
    }
    for line in report.notes().into_iter().chain(report.warnings()) {
        let _ = writeln!(out, "\n{line}");
    }
    let _ = writeln!(
        out,
        "\n{}\n\nkane {}: `{}`",
        report.machine,
        env!("CARGO_PKG_VERSION"),
        report.command
    );
    out
}

/// The table as CSV; times, where there are any, in nanoseconds.
#[must_use]
pub fn csv(report: &ChartReport<'_>) -> String {
    let front = front(report.all);
    let mut out = String::from(
        "law,quantity,name,form,k,system,alpha_from,alpha_to,digits_worst,digits_median,log2_ulps_worst,ulps_proved,proved_to,log2_ulps_worst_up_to_there,worst_alpha,counted_cost,ns,ns_first_quartile,ns_third_quartile,pareto\n",
    );
    for (index, measured) in report.all.iter().enumerate() {
        let method = &measured.method;
        let time = |of: &dyn Fn(&kane_measure::chart::Time) -> u64| {
            measured.time.as_ref().map_or_else(String::new, |time| nanoseconds(of(time)))
        };
        let hundredths = |h: i64| format!("{}.{:02}", h / 100, h % 100);
        let exact = measured.accuracy.worst == i64::MAX;
        let (first, last) = kane_measure::chart::DOMAIN;
        let cells = [
            method.law.to_owned(),
            method.quantity.to_owned(),
            method.name.to_owned(),
            form_of(method).to_owned(),
            method.k.to_owned(),
            method.system.to_string(),
            format!("2^{}", method.least.max(first)),
            format!("2^{last}"),
            digits(measured.accuracy.worst),
            digits(measured.accuracy.median),
            measured
                .accuracy
                .ulps
                .filter(|_| !exact)
                .map_or_else(String::new, |h| hundredths(h.max(0))),
            bound(measured),
            measured.proved.as_ref().map_or_else(String::new, reach),
            measured
                .proved
                .as_ref()
                .and_then(|proved| proved.measured)
                .map_or_else(String::new, |h| hundredths(h.max(0))),
            if exact { String::new() } else { format!("{:e}", measured.accuracy.at) },
            measured.cost.map_or_else(String::new, |cost| cost.to_string()),
            time(&|time| time.median),
            time(&|time| time.quartiles.0),
            time(&|time| time.quartiles.1),
            front.get(index).copied().unwrap_or(false).to_string(),
        ];
        let cells: Vec<String> = cells.iter().map(|cell| quoted(cell)).collect();
        let _ = writeln!(out, "{}", cells.join(","));
    }
    out
}

#[derive(Serialize)]
struct File<'a> {
    schema: Schema,
    program: Program,
    command: &'a str,
    machine: &'a str,
    warnings: Vec<String>,
    methods: Vec<Row<'a>>,
}

#[derive(Serialize)]
struct Row<'a> {
    law: &'a str,
    quantity: &'a str,
    name: &'a str,
    form: &'a str,
    k: &'a str,
    own_code: bool,
    system: String,
    digits_worst: String,
    digits_median: String,
    log2_ulps_worst: Option<i64>,
    proved: Option<Bound>,
    worst_alpha: f64,
    inputs: usize,
    counted_cost: Option<u64>,
    picoseconds: Option<[u64; 3]>,
    rounds: Option<usize>,
    pareto: bool,
}

/// A proved bound: in ulps, exactly; where it ends; and the worst error measured up to there, in
/// hundredths of log2 ulps.
#[derive(Serialize)]
struct Bound {
    ulps: String,
    to: String,
    log2_ulps_worst: Option<i64>,
}

/// The table for programs, ended by a line feed; times as first quartile, median, third quartile.
#[must_use]
pub fn json(report: &ChartReport<'_>) -> String {
    let front = front(report.all);
    let row = |(index, measured): (usize, &'_ Measured)| {
        let method = &measured.method;
        Row {
            law: method.law,
            quantity: method.quantity,
            name: method.name,
            form: method.text,
            k: method.k,
            own_code: method.is_law,
            system: method.system.to_string(),
            digits_worst: digits(measured.accuracy.worst),
            digits_median: digits(measured.accuracy.median),
            log2_ulps_worst: measured.accuracy.ulps,
            proved: measured.proved.as_ref().map(|proved| Bound {
                ulps: proved.ulps.to_string(),
                to: reach(proved),
                log2_ulps_worst: proved.measured,
            }),
            worst_alpha: measured.accuracy.at,
            inputs: measured.accuracy.tried,
            counted_cost: measured.cost,
            picoseconds: measured
                .time
                .as_ref()
                .map(|time| [time.quartiles.0, time.median, time.quartiles.1]),
            rounds: measured.time.as_ref().map(|time| time.rounds),
            pareto: front.get(index).copied().unwrap_or(false),
        }
    };
    let file = File {
        schema: Schema { name: "kane-chart", version: 1 },
        program: Program::THIS,
        command: &report.command,
        machine: &report.machine,
        warnings: report.warnings(),
        methods: report.all.iter().enumerate().map(row).collect(),
    };
    written(&file)
}

/// The table that is committed: the errors and the counted costs, and how they were made. No times.
#[must_use]
pub fn committed(all: &[Measured]) -> String {
    let mut out = String::from(
        "law,quantity,name,system,alpha_from,alpha_to,inputs,digits_worst,digits_median,log2_ulps_worst,worst_alpha,counted_cost,rank\n",
    );
    for measured in all {
        let method = &measured.method;
        let same = |other: &&Measured| {
            (other.method.law, other.method.quantity) == (method.law, method.quantity)
        };
        let cheaper = |cost: u64| {
            all.iter().filter(same).filter(|other| other.cost.is_some_and(|c| c < cost)).count()
        };
        let exact = measured.accuracy.worst == i64::MAX;
        let (first, last) = kane_measure::chart::DOMAIN;
        let _ = writeln!(
            out,
            "{},{},{},{},2^{},2^{last},{},{},{},{},{},{},{}",
            method.law,
            method.quantity,
            method.name,
            method.system,
            method.least.max(first),
            measured.accuracy.tried,
            digits(measured.accuracy.worst),
            digits(measured.accuracy.median),
            measured.accuracy.ulps.filter(|_| !exact).map_or_else(String::new, |h| {
                let h = h.max(0);
                format!("{}.{}", h / 100, h % 100 / 10)
            }),
            if exact { String::new() } else { format!("{:e}", measured.accuracy.at) },
            measured.cost.map_or_else(String::new, |cost| cost.to_string()),
            measured.cost.map_or_else(String::new, |cost| (cheaper(cost) + 1).to_string()),
        );
    }
    out
}
