//! Bounds on round-off, worst inputs and repairs: blocks of a sheet, JSON, and source code.
#![allow(clippy::float_arithmetic, reason = "numbers are rounded for display, bounds upward")]

mod figures;
mod json;
mod source;
#[cfg(test)]
mod tests;

use kane_floats::rigor::{Bounded, Pole};
use kane_floats::text::{decimal, infix};
use kane_floats::{Core, Precision};
use kane_measure::certify::{Account, Certified, Decided, Found, Repair, price};

use crate::sheet::{Column, Entry, Row, Sheet, Table, Tone, Words, row};
use figures::{at_least, at_most, bits_at_least, ratio, shortest};

pub(crate) use figures::bits_at_most;
pub use json::json;
#[cfg(feature = "schema")]
pub(crate) use json::schema;
pub(crate) use json::{AccountJson, accounts_json};
pub use source::{questions, sources};

/// What was found of some formulas, and the command that shows it again.
#[derive(Clone, Debug)]
pub struct FloatsReport<'a> {
    /// what they are from
    pub name: String,
    /// the formulas
    pub accounts: &'a [Account],
    /// a command that prints this report
    pub command: String,
}

const READING: &str = "No float of the ranges has a larger error than the bound; the error found is exact, \
at the input beside it. An ulp is that of the exact value. Repairs are proved equal by the auditor.";

/// The report of FPCore files as a sheet.
#[must_use]
pub fn sheet<'a>(report: &'a FloatsReport<'a>) -> Sheet<'a> {
    let count = report.accounts.len();
    let formats = report.accounts.iter().flat_map(|account| &account.formats);
    let bounded = formats.clone().flatten().filter(|found| found.absolute.pole.is_none()).count();
    let all = formats.count();
    let headline = format!(
        "{count} {}: {bounded} of {all} bounds on round-off",
        if count == 1 { "formula" } else { "formulas" }
    );
    let mut sheet = Sheet::new("Floats", report.name.clone(), headline, &report.command);
    sheet.prose(READING);
    blocks(&mut sheet, report.accounts);
    sheet
}

/// The blocks that tell of formulas, one heading each.
pub(crate) fn blocks(sheet: &mut Sheet<'_>, accounts: &[Account]) {
    for (index, account) in accounts.iter().enumerate() {
        sheet.heading(
            format!("floats-{}", index + 1),
            Words::from(format!("{}  ", account.label)) + Words::code(account.core.text()),
        );
        let ranges = ranges(&account.core);
        sheet.labelled(vec![Entry::new("over", Words::code(ranges))]);
        let rows: Vec<Row> =
            account.formats.iter().flatten().flat_map(|found| rows(&account.core, found)).collect();
        let columns = vec![
            Column::left(""),
            Column::left("error"),
            Column::right("at most"),
            Column::right("found"),
            Column::right("apart"),
            Column::long("at", 20),
        ];
        sheet.table(Table::new(columns, rows));
        let mut notes = Vec::new();
        for found in &account.formats {
            match found {
                Err(name) => {
                    notes.push(Entry::new("empty", format!("no float is in the range of {name}")));
                }
                Ok(found) => {
                    notes.extend(poles(&account.core, found));
                    notes.push(half_lost(&account.core, found));
                }
            }
        }
        sheet.labelled(notes);
        sheet.table(decisions(account));
        let repairs: Vec<Row> =
            account.formats.iter().flatten().flat_map(|found| repairs(account, found)).collect();
        let columns = vec![
            Column::left(""),
            Column::right("bits lost"),
            Column::right("found"),
            Column::right("error"),
            Column::right("+ - * fma"),
            Column::right("/ sqrt"),
            Column::long("form", 30),
        ];
        sheet.table(Table::new(columns, repairs));
        let dropped = account.formats.iter().flatten().map(|found| found.unproved).max();
        if let Some(dropped) = dropped.filter(|dropped| *dropped > 0) {
            let forms = if dropped == 1 { "form was" } else { "forms were" };
            let note = format!("{dropped} {forms} not proved equal, and left out");
            sheet.labelled(vec![Entry::new("unproved", note)]);
        }
    }
}

/// The comparisons, and on how many of the inputs that were drawn plain floats decide them wrongly.
fn decisions(account: &Account) -> Table {
    let columns = vec![
        Column::left(""),
        Column::long("comparison", 20),
        Column::left("wrong near ties"),
        Column::left("wrong elsewhere"),
        Column::left("exact"),
        Column::long("wrong at", 20),
    ];
    let one = |found: &Certified, of: &Decided| {
        let example = of.example.as_ref().map(|(at, holds)| {
            let named = account.core.arguments.iter().zip(at);
            let named: Vec<String> =
                named.map(|(argument, at)| format!("{} = {at}", argument.name)).collect();
            format!("{}, where it {}", named.join(", "), if *holds { "holds" } else { "fails" })
        });
        row![
            found.precision.name(),
            Words::code(of.decision.text(&account.core)),
            format!("{} of {}", of.wrong_near, of.near),
            format!("{} of {}", of.wrong, of.drawn),
            if of.decision.is_certifiable(&account.core) { "emitted" } else { "too large" },
            example.unwrap_or_default(),
        ]
        .toned(if of.wrong_near + of.wrong > 0 { Tone::Bad } else { Tone::Plain })
    };
    let formats = account.formats.iter().flatten();
    let rows = formats.flat_map(|found| found.decided.iter().map(move |of| one(found, of)));
    Table::new(columns, rows.collect())
}

/// Every argument with its range.
fn ranges(core: &Core) -> String {
    let one = |argument: &kane_floats::Argument| {
        let (lower, upper) = (argument.lower.as_ref(), argument.upper.as_ref());
        let open = lower.map_or("[", |bound| if bound.strict { "(" } else { "[" });
        let close = upper.map_or("]", |bound| if bound.strict { ")" } else { "]" });
        let lower = lower.map_or_else(|| "least float".to_owned(), |bound| decimal(&bound.value));
        let upper =
            upper.map_or_else(|| "greatest float".to_owned(), |bound| decimal(&bound.value));
        format!("{} in {open}{lower}, {upper}{close}", argument.name)
    };
    let ranges: Vec<String> = core.arguments.iter().map(one).collect();
    ranges.join(", ")
}

/// The absolute error and the bits lost in one format.
fn rows(core: &Core, found: &Certified) -> Vec<Row> {
    let format = found.precision.name();
    let at = |found: &Option<Found>| found.as_ref().map_or_else(String::new, |f| point(core, f));
    let witness = |found: &Option<Found>| found.as_ref().map_or(0.0, |found| found.error);
    // an error below the least double is rounded down to 0, and is not 0
    let worst =
        found.worst.as_ref().filter(|worst| worst.error == 0.0 && worst.error_at_most > 0.0);
    let deep = worst.map(|worst| format!("below {}", at_most(worst.error_at_most)));
    let absolute = row![
        format,
        "absolute",
        bound(&found.absolute),
        deep.clone().unwrap_or_else(|| at_least(witness(&found.worst))),
        if deep.is_some() {
            String::new()
        } else {
            ratio(found.absolute.bound, witness(&found.worst))
        },
        at(&found.worst),
    ];
    let (most, least) = (found.ulps.bound, witness(&found.worst_in_ulps));
    let bits = row![
        format,
        "bits lost",
        if found.ulps.pole.is_some() {
            "none".to_owned()
        } else {
            bits_at_most(most, found.precision)
        },
        bits_at_least(least, found.precision),
        figures::bits_apart(most, least, found.precision),
        at(&found.worst_in_ulps),
    ];
    let tone = |bad: bool| if bad { Tone::Bad } else { Tone::Plain };
    let half = f64::from(found.precision.bits()) / 2.0;
    vec![absolute.toned(tone(found.absolute.pole.is_some())), bits.toned(tone(least > half.exp2()))]
}

fn bound(bounded: &Bounded) -> String {
    if bounded.pole.is_some() { "none".to_owned() } else { at_most(bounded.bound) }
}

/// The inputs by their names.
fn point(core: &Core, found: &Found) -> String {
    let named = core.arguments.iter().zip(&found.at);
    let named: Vec<String> =
        named.map(|(argument, at)| format!("{} = {at}", argument.name)).collect();
    named.join(", ")
}

/// Why there is no bound: the operation, how it fails, and where.
fn poles(core: &Core, found: &Certified) -> Option<Entry> {
    let pole = found.absolute.pole.as_ref()?;
    let words = Words::from(format!("no bound in {}: ", found.precision.name()))
        + Words::code(infix(core, pole.operation))
        + format!(" {}", told(core, pole));
    Some(Entry::new("pole", words))
}

/// Where more than half of the bits may be lost: what is said of the rest is proved.
fn half_lost(core: &Core, found: &Certified) -> Entry {
    let format = found.precision.name();
    let range = |(argument, (from, to)): (&kane_floats::Argument, &(f64, f64))| {
        let (from, to) = (shortest(*from, found.precision), shortest(*to, found.precision));
        if from == to {
            format!("{} = {from}", argument.name)
        } else {
            format!("{} in [{from}, {to}]", argument.name)
        }
    };
    let cells: Vec<String> = found
        .half_lost
        .iter()
        .map(|cell| {
            let ranges: Vec<String> = core.arguments.iter().zip(&cell.ends).map(range).collect();
            ranges.join(", ")
        })
        .collect();
    let words = match cells.as_slice() {
        [] => Words::from(format!("in {format} no input loses more than half of the bits")),
        cells => {
            Words::from(format!("in {format} more than half of the bits may be lost for "))
                + Words::code(cells.join(" or "))
                + ", and nowhere else"
        }
    };
    Entry::new("half", words)
}

pub(crate) fn told(core: &Core, pole: &Pole) -> String {
    let ends = core.arguments.iter().zip(&pole.cell.ends);
    let ends: Vec<String> = ends
        .map(|(argument, (lower, upper))| {
            if lower == upper {
                format!("{} = {lower:e}", argument.name)
            } else {
                format!("{} in [{lower:e}, {upper:e}]", argument.name)
            }
        })
        .collect();
    let kind = pole.kind.to_string();
    let kind = if pole.certain {
        kind.replace("may be", "is")
            .replace("may overflow", "overflows")
            .replace("may divide", "divides")
    } else {
        kind
    };
    format!("{kind} at {}", ends.join(", "))
}

/// The formula as given and its repairs, as rows of a table of speed against accuracy.
fn repairs(account: &Account, found: &Certified) -> Vec<Row> {
    if found.repairs.is_empty() {
        return vec![];
    }
    let one = |core: &Core, absolute: &Bounded, ulps: &Bounded, worst: Option<&Found>| {
        let price = price(core);
        let lost = worst.map_or(0.0, |worst| worst.error);
        row![
            found.precision.name(),
            if ulps.pole.is_some() {
                "none".to_owned()
            } else {
                bits_at_most(ulps.bound, found.precision)
            },
            bits_at_least(lost, found.precision),
            bound(absolute),
            price.light.to_string(),
            price.heavy.to_string(),
            Words::code(core.text()),
        ]
    };
    let given = one(&account.core, &found.absolute, &found.ulps, found.worst_in_ulps.as_ref());
    let better = |repair: &Repair| {
        one(&repair.core, &repair.absolute, &repair.ulps, repair.worst_in_ulps.as_ref())
            .toned(Tone::Good)
    };
    std::iter::once(given).chain(found.repairs.iter().map(better)).collect()
}

/// The best form of a formula in the widest format in which it was looked at: its first repair, or itself.
pub(crate) fn best(account: &Account) -> (&Core, Precision) {
    let found = account.formats.iter().flatten().next_back();
    match found {
        Some(found) => {
            let repair = found.repairs.first();
            (repair.map_or(&account.core, |repair| &repair.core), found.precision)
        }
        None => (&account.core, account.core.precision.unwrap_or(Precision::F64)),
    }
}
