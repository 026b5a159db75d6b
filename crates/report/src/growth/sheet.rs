//! The curves as tables.

use std::fmt::Write as _;

use kane_measure::growth::{Batch, Bounce, Chain, Family};
use kane_number::System;

use super::{
    FLOATING, GrowthReport, Question, chain_reading, family_reading, picture, power_of_ten, shown,
};
use crate::chart::{digits, nanoseconds};
use crate::markdown::capitalised;
use crate::sheet::{Column, Row, Sheet, Table, Words, row};

const SPHERE: &str = "A solid sphere, m = 5/2 kg, r = 1 m, mu = 1/2, e = 7/8, begins with v_x = v_y = 1 m/s and \
omega = 1/4 rad/s, falls back, and bounces again. Digits of the slip that are right after n bounces; certain ones by \
the width of the interval.";

/// The report as a sheet: a table a curve, each with a sentence that says what it shows.
#[must_use]
pub fn sheet<'a>(report: &'a GrowthReport<'a>) -> Sheet<'a> {
    let growth = report.growth;
    let mut sheet = Sheet::new("Growth", "How does cost grow with size?", "", &report.command);
    sheet.machine = Some(report.machine.clone());
    for (name, question) in
        [("batch", Question::Batch), ("chain", Question::Chain), ("audit", Question::Audit)]
    {
        if question.is_answered(growth) {
            sheet.figure(name, question.text(), move || {
                picture(report, question).unwrap_or_default()
            });
        }
    }
    if let Some(reading) = report.rows_reading() {
        sheet.heading("rows", "Rows in a batch");
        sheet.prose(reading);
        sheet.table(batches(&growth.batches));
    }
    for (index, chain) in growth.chains.iter().enumerate() {
        if index == 0 {
            sheet.prose(SPHERE);
        }
        sheet.heading(format!("chain-{}", chain.law), format!("Bounces in a chain: {}", chain.law));
        let mut reading = capitalised(&chain_reading(chain));
        for (system, end) in &chain.ended {
            let _ = write!(reading, " The {system} chain ends: {end}.");
        }
        sheet.prose(reading);
        sheet.table(bounces(chain));
    }
    for (index, family) in growth.families.iter().enumerate() {
        let title = format!("{} in the audit: {}", capitalised(family.grows), family.name);
        sheet.heading(format!("family-{index}"), title);
        sheet.prose(format!("{}.", capitalised(&family_reading(family))));
        sheet.table(asked(family));
    }
    sheet
}

fn batches(batches: &[Batch]) -> Table {
    let mut columns = vec![Column::left("time of a row").unit("ns")];
    let sizes = batches.iter().take(1).flat_map(|batch| &batch.points);
    columns.extend(sizes.map(|point| Column::right(power_of_ten(point.rows))));
    let row = |batch: &Batch| {
        let times = batch.points.iter().map(|point| nanoseconds(point.time.median).into());
        Row::new(std::iter::once(batch.name.into()).chain(times).collect())
    };
    Table::new(columns, batches.iter().map(row).collect())
}

fn bounces(chain: &Chain) -> Table {
    let right = |system: System| Column::right(format!("{} right", short(system)));
    let time = |system: System| Column::right(short(system)).unit("ns");
    let mut columns = vec![Column::right("n"), Column::right("bits")];
    columns.push(Column::right("exact").unit("ns"));
    columns.extend(FLOATING.map(time));
    columns.extend(FLOATING.map(right));
    columns.push(Column::right("certain"));
    let row = |bounce: &Bounce| {
        let time = |system: System| {
            let found = bounce.times.iter().find(|(known, _)| *known == system);
            Words::from(found.map_or_else(String::new, |(_, time)| nanoseconds(*time)))
        };
        let of = |system: System| bounce.digits.iter().find(|(known, _)| *known == system);
        let shown =
            |digits: Option<i64>| Words::from(digits.map_or_else(String::new, self::digits));
        let bits = bounce.bits.map_or_else(String::new, |bits| bits.to_string());
        let mut row = row![bounce.n.to_string(), bits];
        row.cells.push(time(System::Rational));
        row.cells.extend(FLOATING.map(time));
        row.cells.extend(FLOATING.map(|system| shown(of(system).and_then(|(_, d)| d.right))));
        row.cells.push(shown(of(System::Interval).and_then(|(_, digits)| digits.certain)));
        row
    };
    Table::new(columns, shown(chain).into_iter().map(row).collect()).without_empty_columns()
}

fn short(system: System) -> String {
    match system {
        System::DoubleDouble => "dd".to_owned(),
        other => other.to_string(),
    }
}

fn asked(family: &Family) -> Table {
    let columns = vec![
        Column::right(family.grows),
        Column::right("steps"),
        Column::right("time").unit("us"),
        Column::left("verdict"),
    ];
    let row = |asked: &kane_measure::growth::Asked| {
        row![
            asked.size.to_string(),
            asked.steps.to_string(),
            asked.time.map_or_else(String::new, |time| nanoseconds(time / 1000)),
            asked.verdict.to_string(),
        ]
    };
    Table::new(columns, family.asked.iter().map(row).collect()).without_empty_columns()
}
