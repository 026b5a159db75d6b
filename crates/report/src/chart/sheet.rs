//! The methods as tables, one for each quantity of each law.

use kane_measure::chart::{Measured, front};

use super::{
    ChartReport, daggered, digits, form_of, nanoseconds, picture, quartiles, speed_accuracy, timed,
    ulps,
};
use crate::sheet::{Column, Row, Sheet, Table, Tone, Words, row};

const READING: &str = "Of each quantity the cheapest comes first; • nothing else is both cheaper and better. \
Digits that are right, at the worst and at the median input.";

/// Warnings that text shows.
const WARNINGS: usize = 5;

/// The report as a sheet.
#[must_use]
pub fn sheet<'a>(report: &'a ChartReport<'a>) -> Sheet<'a> {
    let mut sheet = Sheet::new("Chart", "What does the next digit cost?", "", &report.command);
    sheet.machine = Some(report.machine.clone());
    sheet.columns = 110;
    sheet.prose(READING);
    if !timed(report).is_empty() {
        sheet.figure("speed-accuracy", "The paper's law at a glance", || speed_accuracy(report));
    }
    sheet.figure("chart", "Digits by time", || picture(report));
    let front = front(report.all);
    for ((law, quantity), group) in report.groups() {
        sheet.heading(format!("{law}-{quantity}"), format!("{law}  {quantity}"));
        let member = |index: &usize| Some((report.all.get(*index)?, *front.get(*index)?));
        sheet.table(methods(&group.iter().filter_map(member).collect::<Vec<_>>()));
    }
    sheet.heading("bounds", "Bounds");
    for note in report.notes() {
        sheet.prose(note);
    }
    let warnings = report.warnings().into_iter().enumerate();
    let warnings = warnings.map(|(n, warning)| row![warning].detail(n >= WARNINGS)).collect();
    let mut table = Table::new(vec![Column::long("counted costs and the clock", 60)], warnings);
    table.counted = Some("pairs");
    sheet.table(table);
    sheet
}

fn methods(group: &[(&Measured, bool)]) -> Table {
    // what a row is called comes first: by it a page reads the row, and text repeats it where a line has no room for all
    let columns = vec![
        Column::left("method"),
        Column::left(""),
        Column::right("time").unit("ns"),
        Column::left("quartiles"),
        Column::right("worst"),
        Column::right("median"),
        Column::right("ulps"),
        Column::right("proved"),
        Column::right("at alpha"),
        Column::long("form", 20),
    ];
    let row = |(measured, on_front): &(&Measured, bool)| -> Row {
        let (time, spread) = measured
            .time
            .as_ref()
            .map_or_else(Default::default, |time| (nanoseconds(time.median), quartiles(time)));
        let accuracy = &measured.accuracy;
        let exact = accuracy.worst == i64::MAX;
        row![
            format!("{} in {}", measured.method.name, measured.method.system),
            if *on_front { "•" } else { "" },
            time,
            spread,
            digits(accuracy.worst),
            digits(accuracy.median),
            if exact { String::new() } else { ulps(accuracy.ulps) },
            daggered(measured),
            if exact { String::new() } else { format!("{:.3e}", accuracy.at) },
            match measured.method.is_law {
                true => Words::from(form_of(&measured.method)),
                false => Words::formula(form_of(&measured.method)),
            },
        ]
        .toned(if *on_front { Tone::Good } else { Tone::Plain })
    };
    Table::new(columns, group.iter().map(row).collect()).without_empty_columns()
}
