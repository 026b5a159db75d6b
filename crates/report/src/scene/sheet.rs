//! What was asked, why by this model, the models, and every impact.

use kane_scene::simulate::{Bounce, End, Ending};
use kane_scene::{Line, Shown, Verdict};

use super::json::stated_rows;
use super::{
    SceneReport, brief, compare_picture, cost, drawn, error, in_full, ledger_picture, moved,
    number, verdict, who,
};
use crate::sheet::{Column, Entry, Row, Sheet, Table, Tone, Words, row};

/// Impacts that text and a page show; Markdown and the files have all.
const IN_TEXT: usize = 16;
const ON_PAGE: usize = 200;

/// What the column of costs is.
const COST: &str = "Cost: weighted operations of one impact, in additions of f64; \"about\" where a process or a chain takes steps, whose operations are estimated. Error/tol.: the greatest error by its tolerance; - where one is not known, or is more than a tolerance of 0.";

/// That answers have fewer digits here than the bounds beside them are of.
const ROUNDED: &str = "Answers are rounded here, to at most eight digits; the JSON has more. An error is that of the answer as it was computed.";

/// The report as a sheet.
#[must_use]
pub fn sheet<'a>(report: &'a SceneReport<'a>) -> Sheet<'a> {
    let answer = report.answer;
    let mut sheet = Sheet::new("Scene", &report.title, report.headline(), &report.command);
    sheet.table(asked(report));
    if answer.lines.iter().any(|line| told(line).1) {
        sheet.prose(ROUNDED);
    }
    sheet.heading("why", "Why this model");
    sheet.prose(answer.reasons.join(" "));
    if let Some((name, heading)) = drawn(report) {
        sheet.figure(name, heading, || {
            super::picture(report).map_or_else(String::new, |drawn| drawn.svg)
        });
    }
    if answer.sums.last().is_some_and(|last| last.time > 0.0) {
        sheet.figure("ledger", "Energy", || ledger_picture(report).unwrap_or_default());
    }
    sheet.heading("models", "Models");
    sheet.prose(COST);
    sheet.table(models(report));
    if report.is_compared {
        sheet.figure("compare", "Error against cost", || compare_picture(report));
    }
    if !answer.bounces.is_empty() {
        sheet.heading("impacts", "Impacts, with their energy by part");
        sheet.table(impacts(report));
        sheet.prose(answer.end.as_ref().map(ending).unwrap_or_default());
    }
    sheet.table(stated(report));
    let digest = Words::code(&answer.sha256);
    sheet.labelled(vec![Entry::new("SHA-256 of the scene", digest)]);
    sheet
}

/// Suffixes of names in files, and the units that they are.
const UNITS: [(&str, &str); 8] = [
    ("_kg_m2", "kg·m²"),
    ("_kg_m3", "kg/m³"),
    ("_m_s2", "m/s²"),
    ("_rad_s", "rad/s"),
    ("_m_s", "m/s"),
    ("_rad", "rad"),
    ("_kg", "kg"),
    ("_m", "m"),
];

/// The scene itself, at its stated values. Text leaves it out: there the file is at hand.
fn stated(report: &SceneReport<'_>) -> Table {
    let columns = vec![
        Column::left("the scene"),
        Column::left("states"),
        Column::right("value"),
        Column::left("unit"),
    ];
    let row = |(of, name, value): (String, &'static str, f64)| -> Row {
        let unit = UNITS.iter().find_map(|(end, unit)| Some((name.strip_suffix(end)?, *unit)));
        let (name, unit) = unit.unwrap_or((name, ""));
        row![of, name.replace('_', " "), number(value), unit].detail(true)
    };
    let rows = stated_rows(report.answer).into_iter().map(row).collect();
    let mut table = Table::new(columns, rows).without_empty_columns();
    table.most = ON_PAGE;
    table.counted = Some("values");
    table
}

/// An answer as it is printed, and whether that is a rounded one.
fn told(line: &Line) -> (String, bool) {
    // long fractions are for JSON
    if let Some(exact) = line.exact.as_ref().filter(|exact| exact.len() <= 24) {
        return (exact.clone(), false);
    }
    let text = number(line.value);
    let is_all = match (kane_number::parse(&text), kane_number::decode(line.value)) {
        (Ok(text), Ok(value)) => line.exact.is_none() && text == value,
        _ => false,
    };
    (text, !is_all)
}

fn asked(report: &SceneReport<'_>) -> Table {
    let answer = report.answer;
    let columns = vec![
        Column::left("asked"),
        Column::right("answer"),
        Column::left("unit"),
        Column::left("error"),
        Column::right("tolerance"),
        Column::left("inputs move it by"),
    ];
    let rows = answer.lines.iter().map(|line| {
        row![
            Words::code(line.quantity.to_string()),
            told(line).0,
            line.quantity.unit(),
            error(line.error, answer.known),
            in_full(line.tolerance),
            moved(line.spread),
        ]
    });
    Table::new(columns, rows.collect()).without_empty_columns()
}

fn models(report: &SceneReport<'_>) -> Table {
    let answer = report.answer;
    let columns = vec![
        Column::left("model"),
        Column::right("cost"),
        Column::right("error/tol."),
        Column::long("verdict", 24),
    ];
    let rows = answer.judged.iter().map(|judged| {
        let good = judged.verdict == Verdict::Meets;
        row![
            Words::code(judged.model.to_string()),
            cost(judged),
            judged.ratio.map_or_else(|| "-".to_owned(), brief),
            verdict(&judged.verdict, answer.known),
        ]
        .toned(if good { Tone::Good } else { Tone::Plain })
    });
    Table::new(columns, rows.collect())
}

fn impacts(report: &SceneReport<'_>) -> Table {
    let answer = report.answer;
    let energy = |part: &str| Column::right(part).unit("J");
    let mut columns = vec![Column::right("t").unit("s"), Column::left("who"), Column::left("what")];
    columns.extend(["normal", "tangential", "rotational", "gravity", "air"].map(energy));
    let bodies = answer.end.as_ref().map_or(1, |end| end.bodies.len());
    let row = |(index, bounce): (usize, &Bounce<Shown>)| -> Row {
        row![
            number(bounce.time.value),
            who(bounce.encounter, bodies),
            bounce.regime,
            number(bounce.ledger.normal.value),
            number(bounce.ledger.tangential.value),
            number(bounce.ledger.rotational.value),
            number(bounce.gravity.value),
            bounce.air.as_ref().map(|air| number(air.value)).unwrap_or_default(),
        ]
        .detail(index >= IN_TEXT)
    };
    let rows = answer.bounces.iter().enumerate().map(row).collect();
    let mut table = Table::new(columns, rows).without_empty_columns();
    table.most = ON_PAGE;
    table.counted = Some("impacts");
    table
}

/// How the motion ends.
fn ending(end: &End<Shown>) -> String {
    let how = match end.ending {
        Ending::Impacts => "after the impacts asked for",
        Ending::Duration => "at the end of the time asked for",
        Ending::Rest => "at rest, after infinitely many more impacts",
        Ending::Quiet => "nothing meets any more",
    };
    format!("t = {} s: {how}. Impacts: {}.", number(end.time.value), end.impacts)
}
