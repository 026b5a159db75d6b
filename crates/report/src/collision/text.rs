//! A collision for a terminal.

use std::fmt::Write as _;

use anstyle::{AnsiColor, Style};
use kane_scene::collide::{Answer, Collision, Energy, LawAnswer, Reading};

use super::{brief, full, headline, in_words, ulps};
use crate::Page;
use crate::columns::{Column, lines, wrapped};
use crate::shorten::padded;

/// Columns of a page that has no width of its own, as in a file.
const WIDTH: usize = 100;
/// The least that the column of regimes is cut to.
const REGIME: usize = 15;
/// The least that the column of meanings is cut to.
const MEANING: usize = 24;
/// Columns of the words at the margin, over a table and in depth.
const TABLE_LABEL: usize = 8;
const DEPTH_LABEL: usize = 13;

/// The collision as text.
#[must_use]
pub fn text(collision: &Collision, page: Page) -> String {
    // words run on in a file, as they do in the report of an audit
    let (width, cut) = (page.width.unwrap_or(WIDTH), page.width.is_some());
    let ink = |style| if page.colour { style } else { Style::new() };
    let mut out = String::new();
    let _ = writeln!(out, "{}", collision.title);
    let bold = ink(Style::new().bold());
    let _ = writeln!(out, "{bold}{}{bold:#}\n", headline(collision));
    let label = |word: &str| label(collision, word);
    let given: Vec<String> = collision.given.iter().map(in_words).collect();
    paragraph(&mut out, &label("given"), &unbroken(&given), width);
    if !collision.in_depth {
        let before: Vec<String> = collision.before.iter().filter_map(measured).collect();
        paragraph(&mut out, &label("before"), &unbroken(&before), width);
    }
    for note in &collision.notes {
        paragraph(&mut out, &label(""), note, width);
    }
    match collision.laws.first() {
        Some(law) if collision.in_depth => depth(&mut out, law, (width, cut), ink(alarm())),
        _ => table(&mut out, collision, (width, cut), ink(alarm())),
    }
    let _ = writeln!(out, "\nkane {}: {}", env!("CARGO_PKG_VERSION"), collision.command);
    out.replace('\u{a0}', " ")
}

/// The words at the margin stand in one column.
fn label(collision: &Collision, word: &str) -> String {
    padded(word, if collision.in_depth { DEPTH_LABEL } else { TABLE_LABEL })
}

/// A list whose items are not torn at the end of a line.
fn unbroken(items: &[String]) -> String {
    items.iter().map(|item| item.replace(' ', "\u{a0}")).collect::<Vec<_>>().join(", ")
}

/// `alpha = 0.87441`, `T- = 7.6050 J`.
fn measured(reading: &Reading) -> Option<String> {
    let value = brief(reading.float?);
    let space = if reading.unit.is_empty() { "" } else { " " };
    Some(format!("{} = {value}{space}{}", reading.symbol, reading.unit))
}

fn paragraph(out: &mut String, head: &str, text: &str, width: usize) {
    if text.is_empty() {
        return;
    }
    for line in wrapped(head, text, width) {
        let _ = writeln!(out, "{line}");
    }
}

/// All laws, one line each; then those that have no outcome, with the reason.
fn table(out: &mut String, collision: &Collision, (width, cut): (usize, bool), alarm: Style) {
    let outcomes: Vec<(&LawAnswer, &Answer)> = collision.outcomes().collect();
    if let Some((_, first)) = outcomes.first() {
        let names = outcomes.iter().map(|(law, _)| law.id.to_owned()).collect();
        let mut columns = vec![Column::left("law", names)];
        for shown in first.readings.iter().filter(|reading| reading.column) {
            columns.push(Column::right(head(shown), cells(&outcomes, shown.symbol)));
        }
        let regimes = outcomes.iter().map(|(_, answer)| regime(answer)).collect();
        columns.push(Column::words("regime", regimes, REGIME));
        for block in lines(&columns, width, cut) {
            out.push('\n');
            for (index, line) in block.iter().enumerate() {
                let answer = index.checked_sub(1).and_then(|row| outcomes.get(row));
                let created = answer.is_some_and(|(_, answer)| answer.energy == Energy::Created);
                let style = if created { alarm } else { Style::new() };
                let _ = writeln!(out, "{style}{line}{style:#}");
            }
        }
    }
    let creators = collision.creators();
    if !creators.is_empty() {
        out.push('\n');
        paragraph(out, "energy is created by: ", &creators.join(", "), width);
    }
    let without =
        collision.laws.iter().filter_map(|law| law.answer.as_ref().err().map(|e| (law, e)));
    for (index, (law, reason)) in without.enumerate() {
        if index == 0 {
            out.push('\n');
        }
        paragraph(out, &format!("no outcome: {}: ", law.id), reason, width);
    }
}

fn head(reading: &Reading) -> String {
    reading.symbol.to_owned()
}

fn cells(outcomes: &[(&LawAnswer, &Answer)], symbol: &str) -> Vec<String> {
    let value = |answer: &Answer| {
        let reading = answer.readings.iter().find(|reading| reading.symbol == symbol)?;
        Some(shown(reading))
    };
    outcomes.iter().map(|(_, answer)| value(answer).unwrap_or_else(|| "-".to_owned())).collect()
}

/// The value in a table; a dash where the quantity has no meaning.
fn shown(reading: &Reading) -> String {
    match (reading.float, &reading.exact) {
        (Some(float), _) => brief(float),
        (None, Some(_)) => "beyond f64".to_owned(),
        (None, None) => "-".to_owned(),
    }
}

fn regime(answer: &Answer) -> String {
    match answer.energy {
        Energy::Created => format!("creates energy: {}", answer.regime),
        Energy::Lost | Energy::Kept => answer.regime.to_owned(),
    }
}

/// One law: what it says, every quantity in every number system, the checks.
fn depth(out: &mut String, law: &LawAnswer, (width, cut): (usize, bool), alarm: Style) {
    out.push('\n');
    let mut says = law.statement.lines();
    paragraph(out, &padded("law", DEPTH_LABEL), law.id, width);
    paragraph(out, &padded("says", DEPTH_LABEL), says.next().unwrap_or_default(), width);
    for line in says {
        paragraph(out, &padded("", DEPTH_LABEL), line, width);
    }
    paragraph(out, &padded("restitution", DEPTH_LABEL), law.restitution, width);
    let parameters: Vec<String> =
        law.parameters.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    paragraph(out, &padded("with", DEPTH_LABEL), &parameters.join(", "), width);
    paragraph(out, &padded("source", DEPTH_LABEL), law.source, width);
    let answer = match &law.answer {
        Ok(answer) => answer,
        Err(reason) => {
            out.push('\n');
            paragraph(out, "no outcome: ", reason, width);
            return;
        }
    };
    paragraph(out, &padded("regime", DEPTH_LABEL), &regime(answer), width);

    let readings: Vec<&Reading> =
        answer.readings.iter().filter(|reading| reading.exact.is_some()).collect();
    let column = |cell: &dyn Fn(&Reading) -> String| {
        readings.iter().map(|reading| cell(reading)).collect::<Vec<_>>()
    };
    let float = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), full);
    let error = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), ulps);
    let errors = |reading: &Reading| reading.errors.unwrap_or_default();
    let mut columns = vec![
        Column::left("quantity", column(&name)),
        Column::right("exact", column(&|r| r.exact.clone().unwrap_or_default())),
        Column::right("f64", column(&|r| float(r.float))),
        Column::right("inputs", column(&|r| error(errors(r).inputs))),
        Column::right("plain", column(&|r| error(errors(r).plain))),
        Column::right("wide", column(&|r| error(errors(r).wide))),
    ];
    if readings.iter().any(|reading| reading.enclosure.is_some()) {
        columns.push(Column::left("enclosure of the exact value", column(&enclosure)));
    }
    columns.push(Column::words("meaning", column(&|r| r.meaning.to_owned()), MEANING));
    for block in lines(&columns, width, cut) {
        out.push('\n');
        for line in block {
            let _ = writeln!(out, "{line}");
        }
    }
    out.push('\n');
    paragraph(out, "", ERRORS, width);
    for remark in &answer.remarks {
        paragraph(out, "note: ", remark, width);
    }
    out.push('\n');
    for check in &answer.checks {
        if check.holds {
            paragraph(out, "holds exactly  ", &check.claim, width);
        } else {
            let _ = write!(out, "{alarm}");
            paragraph(out, "DOES NOT HOLD  ", &check.claim, width);
            let _ = write!(out, "{alarm:#}");
        }
    }
}

/// What the columns of errors are.
pub(super) const ERRORS: &str = "Errors are in ulps. inputs: what rounding the inputs to floats does to the exact value. plain: what the law in f64 adds to that, from a contact with entries rounded once. wide: what the way by double-double adds; f64 is its result.";

/// The symbol with its unit.
fn name(reading: &Reading) -> String {
    match reading.unit {
        "" => reading.symbol.to_owned(),
        unit => format!("{} ({unit})", reading.symbol),
    }
}

/// The ends of the enclosure, which need not be finite.
pub(super) fn enclosure(reading: &Reading) -> String {
    let end = |float: f64| match float {
        f64::INFINITY => "oo".to_owned(),
        f64::NEG_INFINITY => "-oo".to_owned(),
        float => full(float),
    };
    match reading.enclosure {
        Some([lower, upper]) if lower == upper => format!("[{}]", end(lower)),
        Some([lower, upper]) => format!("[{}, {}]", end(lower), end(upper)),
        None => "-".to_owned(),
    }
}

/// The ink of what should not be.
fn alarm() -> Style {
    Style::new().bold().fg_color(Some(AnsiColor::Red.into()))
}
