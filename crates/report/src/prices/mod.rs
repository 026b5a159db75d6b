//! Speed against accuracy of anyone's formulas: a sheet, its data, and a picture.

mod data;
mod picture;
#[cfg(test)]
mod tests;

use kane_measure::prices::{Prices, Way};

use crate::chart::{digits, nanoseconds, quartiles};
use crate::floats::bits_at_most;
use crate::sheet::{Column, Row, Sheet, Table, Tone, Words, row};
use crate::stability::WHICH_FORMULAS;
use crate::wording::number_of;

#[cfg(feature = "schema")]
pub(crate) use data::schema;
pub use data::{csv, json};
use picture::picture;

/// What was measured of some formulas, where, and the command that measures it again.
#[derive(Clone, Debug)]
pub struct PricesReport<'a> {
    /// what they are from
    pub name: String,
    /// the formulas
    pub all: &'a [Prices],
    /// those of which nothing was measured, with the reason
    pub left_out: Vec<(String, String)>,
    /// machine and compiler
    pub machine: String,
    /// a command that prints this report
    pub command: String,
}

const READING: &str = "The fastest way comes first; • nothing else is both faster and better. Digits that are right, \
at the worst and at the median of the inputs tried, which are the same for all forms of a format; the time of one \
evaluation in a column of 128, one operation after another; bits lost at most are proved, over the whole range.";

/// The report as a sheet.
#[must_use]
pub fn sheet<'a>(report: &'a PricesReport<'a>) -> Sheet<'a> {
    let left_out = match report.left_out.len() {
        0 => String::new(),
        count => format!("; {count} left out"),
    };
    let headline = match report.all.len() {
        0 => format!("no formula was measured{left_out}"),
        count => format!("{}: what the next digit costs", number_of(count, "formula")),
    };
    let mut sheet = Sheet::new("Chart", report.name.clone(), headline, &report.command);
    sheet.machine = Some(report.machine.clone());
    sheet.columns = 110;
    if report.all.is_empty() {
        sheet.prose(WHICH_FORMULAS);
    } else {
        sheet.prose(READING);
        sheet.figure("prices", "Digits by time", || picture(report));
    }
    for (index, prices) in report.all.iter().enumerate() {
        let given = prices.forms.first().map_or_else(String::new, |form| form.core.text());
        sheet.heading(
            format!("prices-{}", index + 1),
            Words::from(format!("{}  ", prices.label)) + Words::code(given),
        );
        sheet.table(forms(prices));
        sheet.table(ways(prices));
    }
    let rows = report.left_out.iter().map(|(label, why)| row![label.clone(), why.clone()]);
    let columns = vec![Column::left("left out"), Column::long("because", 30)];
    sheet.table(Table::new(columns, rows.collect()));
    sheet
}

fn forms(prices: &Prices) -> Table {
    let columns = vec![Column::left("form"), Column::long("", 40)];
    let row =
        |form: &kane_measure::prices::Form| row![form.name.clone(), Words::code(form.core.text())];
    Table::new(columns, prices.forms.iter().map(row).collect())
}

fn ways(prices: &Prices) -> Table {
    // what a row is called comes first: by it a page reads the row
    let columns = vec![
        Column::left("way"),
        Column::left(""),
        Column::right("time").unit("ns"),
        Column::left("quartiles"),
        Column::right("worst"),
        Column::right("median"),
        Column::right("bits lost at most"),
        Column::long("worst at", 20),
    ];
    let row = |way: &Way| -> Row {
        let exact = way.worst == i64::MAX;
        row![
            format!("{} in {}", form_of(prices, way), way.system),
            if way.on_front { "•" } else { "" },
            nanoseconds(way.time.median),
            quartiles(&way.time),
            digits(way.worst),
            digits(way.median),
            way.bound(prices)
                .map_or_else(String::new, |(bound, format)| { bits_at_most(bound.bound, format) }),
            if exact { String::new() } else { at(prices, way) },
        ]
        .toned(if way.on_front { Tone::Good } else { Tone::Plain })
    };
    Table::new(columns, by_time(prices).into_iter().map(row).collect()).without_empty_columns()
}

/// The fastest first.
fn by_time(prices: &Prices) -> Vec<&Way> {
    let mut ways: Vec<&Way> = prices.ways.iter().collect();
    ways.sort_by_key(|way| (way.time.median, way.system, way.form));
    ways
}

fn form_of(prices: &Prices, way: &Way) -> String {
    prices.forms.get(way.form).map_or_else(String::new, |form| form.name.clone())
}

/// The worst input, by the names of the arguments.
fn at(prices: &Prices, way: &Way) -> String {
    let Some(form) = prices.forms.first() else { return String::new() };
    let named = form.core.arguments.iter().zip(&way.at);
    let named: Vec<String> =
        named.map(|(argument, at)| format!("{} = {at:e}", argument.name)).collect();
    named.join(", ")
}
