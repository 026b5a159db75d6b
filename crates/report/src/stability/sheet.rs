//! The formulas that fail, each with its ranges, then those that do not.

use kane_measure::{Fault, Point};

use super::picture::shows_something;
use super::{Entry, StabilityReport, bits, interval, named, picture, short, strips_picture};
use crate::sheet::{Column, Entry as Line, Row, Sheet, Table, Tone, Words, row};

const READING: &str = "A range runs from the first to the last failing input that was found; bits are lost at its worst input. \
Cells are of a plane of two inputs >= 0; points are a search over more inputs or other signs. Inputs are told to four digits, \
and in the JSON in full.";

/// Which formulas a document has, told where there are none.
pub(crate) const WHICH_FORMULAS: &str = "The formulas of a document are the bodies of its definitions, `let`, and what \
its statements say that a symbol is equal to, in blocks tagged kane, as far as symbols stand in them.";

const BOUNDS: &str = "No float of the ranges has a larger error than the bound; the error found is exact. \
Repairs are proved equal by the auditor.";

/// The report as a sheet.
#[must_use]
pub fn sheet<'a>(report: &'a StabilityReport<'a>) -> Sheet<'a> {
    let stability = report.stability;
    let title = match &stability.title {
        Some(title) => format!("{title} ({})", stability.name),
        None => stability.name.clone(),
    };
    let mut sheet = Sheet::new("Stability", title, report.headline(), &report.command);
    let entries = report.entries();
    sheet.prose(if entries.is_empty() { WHICH_FORMULAS } else { READING });
    if entries.iter().any(|e| e.lines.iter().any(|line| !line.ranges.is_empty())) {
        sheet.figure("strips", "At a glance", || strips_picture(report));
    }
    if shows_something(report) {
        sheet.figure("stability", "Bits lost by the input", || picture(report));
    }
    for (index, entry) in entries.iter().enumerate().filter(|(_, entry)| entry.fails()) {
        sheet.heading(format!("formula-{}", index + 1), equation(entry) + notes(entry));
        let betters = betters(report, entry);
        sheet.table(ranges(report, entry, &betters));
        let planes = entry.planes.iter().flat_map(|plane| {
            let (format, all) = (plane.format, plane.cells.len());
            let row = move |(fault, count, (a, b)): &(Fault, usize, (Point, Point))| {
                let example = named_all(entry, &[a.clone(), b.clone()]);
                counted(format, *fault, (*count, all), example)
            };
            plane.faults.iter().map(row)
        });
        sheet.table(examples("cells", planes.collect()));
        let searches = entry.searches.iter().flat_map(|search| {
            let (format, all) = (search.format, search.tried);
            let row = move |(fault, count, example): &(Fault, usize, Vec<Point>)| {
                counted(format, *fault, (*count, all), named_all(entry, example))
            };
            search.faults.iter().map(row)
        });
        sheet.table(examples("points", searches.collect()));
        let several = betters.len() > 1;
        let better = |(index, better): (usize, &String)| {
            let letter = if several { format!("{} ", letter(index)) } else { String::new() };
            Line::new("better", Words::from(letter) + Words::formula(better))
        };
        sheet.labelled(betters.iter().enumerate().map(better).collect());
    }
    let sound: Vec<&Entry<'_>> = entries.iter().filter(|entry| !entry.fails()).collect();
    if !sound.is_empty() {
        sheet.heading("sound", "No failure, and the most bits lost");
        let columns = vec![Column::left("f32"), Column::left("f64"), Column::long("formula", 30)];
        sheet.table(Table::new(columns, sound.into_iter().map(losses).collect()));
    }
    if !report.accounts.is_empty() {
        sheet.heading("bounds", "Bounds on round-off, and repairs");
        sheet.prose(BOUNDS);
        crate::floats::blocks(&mut sheet, report.accounts);
    }
    if !stability.subject.left_out.is_empty() {
        sheet.heading("left-out", "Left out");
        let line = |(label, why): &(String, String)| Line::new("", format!("{label}: {why}"));
        sheet.labelled(stability.subject.left_out.iter().map(line).collect());
    }
    sheet
}

/// The label of a formula, unless that is what it is a formula of, and the equation.
fn equation(entry: &Entry<'_>) -> Words {
    let formula = entry.formula;
    let equation = Words::formula(format!("{} = {}", formula.quantity, formula.text));
    if formula.label == formula.quantity {
        equation
    } else {
        Words::from(format!("{}  ", formula.label)) + equation
    }
}

/// What is evaluated first, and where else the formula stands.
fn notes(entry: &Entry<'_>) -> String {
    let notes = entry.notes();
    if notes.is_empty() { notes } else { format!(" ({notes})") }
}

fn ranges(report: &StabilityReport<'_>, entry: &Entry<'_>, betters: &[String]) -> Table {
    let columns = vec![
        Column::left(""),
        Column::left("fault"),
        Column::left("range"),
        Column::right("bits lost"),
        Column::left("at"),
        Column::left("returns").detail(),
        Column::left("exact").detail(),
        Column::left("better"),
        Column::long("where", 16),
    ];
    let rows =
        entry.lines.iter().flat_map(|line| line.ranges.iter().map(move |range| (line, range)));
    let row = |(line, range): (&&kane_measure::Examined, &kane_measure::Range)| {
        row![
            line.format,
            range.fault.to_string(),
            interval(range),
            format!("{} of {}", bits(range.lost), line.precision),
            short(&range.worst),
            &range.computed,
            &range.exact,
            mark(report, betters, range.better.as_ref()),
            Words::code(&range.cause),
        ]
        .toned(tone(range.fault))
    };
    Table::new(columns, rows.map(row).collect()).without_empty_columns()
}

/// Cells of a plane or points of a search that fail, with one of them.
fn examples(what: &'static str, rows: Vec<Row>) -> Table {
    let columns = [Column::left(""), Column::left("fault"), Column::right(what)];
    Table::new(columns.into_iter().chain([Column::long("as at", 20)]).collect(), rows)
}

fn counted(format: &str, fault: Fault, (count, all): (usize, usize), example: String) -> Row {
    row![format, fault.to_string(), format!("{count} of {all}"), example].toned(tone(fault))
}

/// Several inputs, each with its name.
fn named_all(entry: &Entry<'_>, points: &[Point]) -> String {
    let inputs = entry.formula.inputs.iter().zip(points);
    let named: Vec<String> =
        inputs.map(|(input, point)| format!("{} = {}", input.name, short(point))).collect();
    named.join(", ")
}

/// The formulas that are better somewhere, in the order of their first mention.
fn betters(report: &StabilityReport<'_>, entry: &Entry<'_>) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for range in entry.lines.iter().flat_map(|line| &line.ranges) {
        if let Some(formula) = range.better.as_ref().and_then(|better| report.better(better)) {
            let name = named(formula);
            if !found.contains(&name) {
                found.push(name);
            }
        }
    }
    found
}

/// The letter that says which of several better formulas is meant; that there is none, if there is one elsewhere.
fn mark(
    report: &StabilityReport<'_>,
    betters: &[String],
    better: Option<&kane_measure::Better>,
) -> String {
    let Some(better) = better.and_then(|better| report.better(better)) else {
        return if betters.is_empty() { String::new() } else { "none".to_owned() };
    };
    let name = named(better);
    match betters.iter().position(|known| *known == name) {
        Some(index) if betters.len() > 1 => letter(index),
        _ => String::new(),
    }
}

fn letter(index: usize) -> String {
    let letters = "abcdefghijklmnopqrstuvwxyz";
    letters.chars().nth(index).map_or_else(String::new, |letter| format!("[{letter}]"))
}

/// The most bits that a formula without a failure loses in each format, and where.
fn losses(entry: &Entry<'_>) -> Row {
    let losses = entry.losses();
    let of = |format: &str| {
        let loss = losses.iter().find(|(known, ..)| *known == format);
        loss.map_or_else(String::new, |(_, lost, at)| {
            let at = at.map_or_else(String::new, |at| format!(" at {}", short(at)));
            format!("{:>4}{at}", bits(*lost))
        })
    };
    row![of("f32"), of("f64"), equation(entry) + notes(entry)]
}

const fn tone(fault: Fault) -> Tone {
    match fault {
        Fault::Lost => Tone::Doubtful,
        _ => Tone::Bad,
    }
}
