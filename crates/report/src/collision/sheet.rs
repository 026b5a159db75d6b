//! A collision under all laws as a table, or under one law in depth.

use kane_scene::collide::{Answer, Collision, Energy, LawAnswer, Reading};

use super::{brief, full, headline, in_words, ulps};
use crate::scene::drawn_impulse;
use crate::sheet::{Column, Entry, Row, Sheet, Table, Tone, Words, row};

/// The least that the columns of regimes and of meanings are cut to.
const REGIME: usize = 15;
const MEANING: usize = 24;

/// The report as a sheet.
#[must_use]
pub fn sheet(collision: &Collision) -> Sheet<'_> {
    let command = &collision.command;
    let mut sheet = Sheet::new("Collision", &collision.title, headline(collision), command);
    sheet.columns = 120;
    let given: Vec<String> = collision.given.iter().map(in_words).collect();
    let mut entries = vec![Entry::new("given", unbroken(&given))];
    if !collision.in_depth {
        let before: Vec<String> = collision.before.iter().filter_map(measured).collect();
        entries.push(Entry::new("before", unbroken(&before)));
    }
    entries.extend(collision.notes.iter().map(|note| Entry::new("", note)));
    sheet.labelled(entries);
    match collision.laws.first() {
        Some(law) if collision.in_depth => depth(&mut sheet, law),
        _ => all(&mut sheet, collision),
    }
    if let Some(plane) = &collision.plane {
        sheet.figure("impulse", "Impulse", || {
            drawn_impulse(&collision.title, &collision.command, plane)
        });
    }
    sheet
}

/// A list whose items are not torn at the end of a line.
fn unbroken(items: &[String]) -> String {
    items.iter().map(|item| item.replace(' ', "\u{a0}")).collect::<Vec<_>>().join(", ")
}

/// `alpha = 0.87441`, `T- = 7.6050 J`; nothing where the quantity has no meaning.
fn measured(reading: &Reading) -> Option<String> {
    reading.exact.as_ref()?;
    let Some(value) = within(reading).map(brief) else {
        return Some(format!("{} {}", reading.symbol, shown(reading)));
    };
    let space = if reading.unit.is_empty() { "" } else { " " };
    Some(format!("{} = {value}{space}{}", reading.symbol, reading.unit))
}

/// The float, if it tells the number: not beyond the range, and no 0 in the place of what is less than any float.
fn within(reading: &Reading) -> Option<f64> {
    reading.float.filter(|float| *float != 0.0 || reading.exact.as_deref() == Some("0"))
}

/// What was there before, for those who look for its exact values; then all laws, a row each; then those that
/// have no outcome, with the reason.
fn all(sheet: &mut Sheet<'_>, collision: &Collision) {
    let columns = ["before", "value", "exact"].map(Column::left).into_iter();
    let columns = columns.chain([Column::long("meaning", MEANING)]).collect();
    let before = collision.before.iter().map(|reading| {
        let exact = reading.exact.as_deref().unwrap_or("-");
        row![name(reading), shown(reading), exact, reading.meaning].detail(true)
    });
    sheet.table(Table::new(columns, before.collect()));

    let outcomes: Vec<(&LawAnswer, &Answer)> = collision.outcomes().collect();
    if let Some((_, first)) = outcomes.first() {
        let readings: Vec<&Reading> = first.readings.iter().filter(|r| r.column).collect();
        let mut columns = vec![Column::left("law")];
        columns.extend(readings.iter().map(|r| Column::right(r.symbol).unit(r.unit)));
        columns.push(Column::long("regime", REGIME));
        let row = |(law, answer): &(&LawAnswer, &Answer)| {
            let mut cells = vec![Words::code(law.id)];
            for column in &readings {
                let found = answer.readings.iter().find(|r| r.symbol == column.symbol);
                cells.push(found.map_or_else(|| "-".to_owned(), shown).into());
            }
            cells.push(regime(answer));
            Row::new(cells).toned(tone(answer))
        };
        let rows: Vec<Row> = outcomes.iter().map(row).collect();
        let has_dash = rows.iter().any(|row| row.cells.iter().any(|cell| cell.plain() == "-"));
        sheet.table(Table::new(columns, rows));
        if has_dash {
            sheet.prose(NO_MEANING);
        }
    }
    sheet.labelled(vec![Entry::new("energy is created by", collision.creators().join(", "))]);
    let mut entries = Vec::new();
    for law in &collision.laws {
        if let Err(reason) = &law.answer {
            entries.push(Entry::new("no outcome", Words::code(law.id) + format!(": {reason}")));
        }
    }
    sheet.labelled(entries);
}

/// What a dash says among the quantities of laws.
const NO_MEANING: &str =
    "-: the quantity has no meaning there, as k without slip and i_x without slip or friction.";

/// The value in a table; a dash where the quantity has no meaning.
fn shown(reading: &Reading) -> String {
    match (within(reading), &reading.exact, reading.float) {
        (_, None, _) => "-".to_owned(),
        (Some(float), ..) => brief(float),
        (None, Some(_), Some(_)) => "below f64".to_owned(),
        (None, Some(_), None) => "beyond f64".to_owned(),
    }
}

fn regime(answer: &Answer) -> Words {
    match answer.energy {
        Energy::Created => Words::strong("creates energy") + format!(": {}", answer.regime),
        Energy::Lost | Energy::Kept => answer.regime.into(),
    }
}

fn tone(answer: &Answer) -> Tone {
    if answer.energy == Energy::Created { Tone::Bad } else { Tone::Plain }
}

/// One law: what it says, every quantity in every number system, the checks.
fn depth(sheet: &mut Sheet<'_>, law: &LawAnswer) {
    let mut entries = vec![Entry::new("law", Words::code(law.id))];
    let labels = std::iter::once("says").chain(std::iter::repeat(""));
    let says = labels.zip(law.statement.lines());
    entries.extend(says.map(|(label, line)| Entry::new(label, Words::code(line))));
    entries.push(Entry::new("restitution", law.restitution));
    let with: Vec<String> =
        law.parameters.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    if !with.is_empty() {
        entries.push(Entry::new("with", with.join(", ")));
    }
    entries.push(Entry::new("source", law.source));
    let answer = match &law.answer {
        Ok(answer) => answer,
        Err(reason) => {
            entries.push(Entry::new("no outcome", reason));
            return sheet.labelled(entries);
        }
    };
    entries.push(Entry::new("regime", regime(answer)));
    sheet.labelled(entries);
    sheet.table(readings(answer));
    sheet.prose(ERRORS);
    let mut entries: Vec<Entry> =
        answer.remarks.iter().map(|remark| Entry::new("note", remark)).collect();
    entries.extend(answer.checks.iter().map(|check| match check.holds {
        true => Entry::new("holds exactly", &check.claim),
        false => Entry::new("DOES NOT HOLD", Words::strong(&check.claim).toned(Tone::Bad)),
    }));
    sheet.labelled(entries);
}

fn readings(answer: &Answer) -> Table {
    let columns = vec![
        Column::left("quantity"),
        Column::right("exact"),
        Column::right("f64"),
        Column::right("inputs"),
        Column::right("plain"),
        Column::right("wide"),
        Column::left("enclosure of the exact value"),
        Column::long("meaning", MEANING),
    ];
    let float = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), full);
    let error = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), ulps);
    let row = |reading: &Reading| {
        let errors = reading.errors.unwrap_or_default();
        row![
            name(reading),
            reading.exact.as_deref().unwrap_or_default(),
            float(reading.float),
            error(errors.inputs),
            error(errors.plain),
            error(errors.wide),
            enclosure(reading),
            reading.meaning,
        ]
    };
    let rows = answer.readings.iter().filter(|reading| reading.exact.is_some()).map(row);
    Table::new(columns, rows.collect()).without_empty_columns()
}

/// What the columns of errors are.
const ERRORS: &str = "Errors are in ulps. inputs: what rounding the inputs to floats does to the exact value. plain: what the law in f64 adds to that, from a contact with entries rounded once. wide: what the way by double-double adds; f64 is its result. -: there is no such number on that way.";

/// The symbol with its unit.
fn name(reading: &Reading) -> Words {
    match reading.unit {
        "" => Words::code(reading.symbol),
        unit => Words::code(reading.symbol) + format!(" ({unit})"),
    }
}

/// The ends of the enclosure, which need not be finite; empty without one.
fn enclosure(reading: &Reading) -> String {
    let end = |float: f64| match float {
        f64::INFINITY => "oo".to_owned(),
        f64::NEG_INFINITY => "-oo".to_owned(),
        float => full(float),
    };
    match reading.enclosure {
        Some([lower, upper]) if lower == upper => format!("[{}]", end(lower)),
        Some([lower, upper]) => format!("[{}, {}]", end(lower), end(upper)),
        None => String::new(),
    }
}
