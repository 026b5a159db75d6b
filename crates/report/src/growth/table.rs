//! The curves as tables, for the terminal and for the web.

use std::fmt::Write as _;

use anstyle::Style;
use kane_measure::growth::{Bounce, Chain, Digits, Family};
use kane_number::System;

use super::{FLOATING, GrowthReport, chain_reading, family_reading, power_of_ten, shown};
use crate::Page;
use crate::chart::{digits, nanoseconds};
use crate::columns::{Column, lines, wrapped};
use crate::shorten::shorten;

/// Columns where the page has no width.
const WIDTH: usize = 100;

const SPHERE: &str = "A solid sphere, m = 5/2 kg, r = 1 m, mu = 1/2, e = 7/8, begins with v_x = v_y = 1 m/s and \
omega = 1/4 rad/s, falls back, and bounces again. Digits of the slip that are right after n bounces; certain ones by \
the width of the interval.";

/// A table: what it is about, a sentence on it, its head and its rows.
struct Table {
    title: String,
    /// whether the first column holds names
    named: bool,
    reading: String,
    head: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// For a terminal: the first column is what grows, or the names of the batches.
    fn columns(&self) -> Vec<Column> {
        let cells = |column: usize| -> Vec<String> {
            self.rows.iter().map(|row| row.get(column).cloned().unwrap_or_default()).collect()
        };
        let column = |(index, head): (usize, &String)| match index {
            0 if self.named => Column::left(head, cells(index)),
            _ => Column::right(head, cells(index)),
        };
        self.head.iter().enumerate().map(column).collect()
    }
}

impl GrowthReport<'_> {
    fn rows(&self) -> Option<Table> {
        let batches = &self.growth.batches;
        let mut head = vec!["ns a row".to_owned()];
        head.extend(batches.first()?.points.iter().map(|point| power_of_ten(point.rows)));
        let row = |batch: &kane_measure::growth::Batch| {
            let times = batch.points.iter().map(|point| nanoseconds(point.time.median));
            std::iter::once(batch.name.to_owned()).chain(times).collect()
        };
        Some(Table {
            title: "Rows in a batch".to_owned(),
            named: true,
            reading: self.rows_reading()?,
            head,
            rows: batches.iter().map(row).collect(),
        })
    }

    fn tables(&self) -> Vec<Table> {
        let growth = self.growth;
        let chains = growth.chains.iter().map(chain);
        let families = growth.families.iter().map(family);
        self.rows().into_iter().chain(chains).chain(families).collect()
    }
}

fn chain(chain: &Chain) -> Table {
    let head = ["n", "bits", "exact, ns", "f64, ns", "dd, ns", "interval, ns"];
    let digits = ["f64 right", "dd right", "interval right", "certain"];
    let time = |bounce: &Bounce, system: System| {
        let found = bounce.times.iter().find(|(known, _)| *known == system);
        found.map_or_else(String::new, |(_, time)| nanoseconds(*time))
    };
    let row = |bounce: &Bounce| {
        let mut row = vec![bounce.n.to_string()];
        row.push(bounce.bits.map_or_else(String::new, |bits| bits.to_string()));
        row.push(time(bounce, System::Rational));
        row.extend(FLOATING.map(|system| time(bounce, system)));
        let of = |system: System| bounce.digits.iter().find(|(known, _)| *known == system);
        let shown = |digits: Option<i64>| digits.map_or_else(String::new, self::digits);
        row.extend(FLOATING.map(|system| shown(of(system).and_then(|(_, d)| d.right))));
        let certain = |digits: &Digits| digits.certain;
        row.push(shown(of(System::Interval).and_then(|(_, digits)| certain(digits))));
        row
    };
    let mut rows: Vec<Vec<String>> = shown(chain).into_iter().map(row).collect();
    if rows.iter().all(|row| row.get(2).is_none_or(String::is_empty))
        && chain.last_exact().is_some()
    {
        // nothing was timed
        for row in &mut rows {
            row.drain(2..6);
        }
        let head = head.iter().take(2).chain(&digits).map(|&cell| cell.to_owned()).collect();
        return table(chain, head, rows);
    }
    let head = head.iter().chain(&digits).map(|&cell| cell.to_owned()).collect();
    table(chain, head, rows)
}

fn table(chain: &Chain, head: Vec<String>, rows: Vec<Vec<String>>) -> Table {
    let mut reading = capital(&chain_reading(chain));
    for (system, end) in &chain.ended {
        let _ = write!(reading, " The {system} chain ends: {end}.");
    }
    Table { title: format!("Bounces in a chain: {}", chain.law), named: false, reading, head, rows }
}

fn family(family: &Family) -> Table {
    let row = |asked: &kane_measure::growth::Asked| {
        vec![
            asked.size.to_string(),
            asked.steps.to_string(),
            asked.time.map_or_else(String::new, |time| nanoseconds(time / 1000)),
            asked.verdict.to_string(),
        ]
    };
    let head = [family.grows, "steps", "us", "verdict"].map(str::to_owned).to_vec();
    Table {
        title: format!("{} in the audit: {}", capital(family.grows), family.name),
        named: false,
        reading: format!("{}.", capital(&family_reading(family))),
        head,
        rows: family.asked.iter().map(row).collect(),
    }
}

fn capital(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().collect::<String>() + letters.as_str()
    })
}

const TITLE: &str = "How does cost grow with size?";

/// The tables for a terminal, each with a sentence that says what it shows.
#[must_use]
pub fn text(report: &GrowthReport<'_>, page: Page) -> String {
    let width = page.width.unwrap_or(WIDTH);
    let bold = if page.colour { Style::new().bold() } else { Style::new() };
    let mut out = format!("{TITLE}\n");
    let mut told = false;
    for table in report.tables() {
        if table.title.starts_with("Bounces") && !std::mem::replace(&mut told, true) {
            let _ = writeln!(out, "\n{}", wrapped("", SPHERE, width).join("\n"));
        }
        let _ = writeln!(out, "\n{bold}{}{bold:#}", shorten(&table.title, width));
        let _ = writeln!(out, "{}", wrapped("", &table.reading, width).join("\n"));
        for line in lines(&table.columns(), width, page.width.is_some()).concat() {
            let _ = writeln!(out, "  {line}");
        }
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

/// The tables for the web.
#[must_use]
pub fn markdown(report: &GrowthReport<'_>) -> String {
    let mut out = format!("# {TITLE}\n\n{SPHERE}\n");
    for table in report.tables() {
        let _ = write!(out, "\n## {}\n\n{}\n\n", table.title, table.reading);
        let _ = writeln!(out, "| {} |", table.head.join(" | "));
        let _ = writeln!(out, "|{}", "---|".repeat(table.head.len()));
        for row in table.rows {
            let _ = writeln!(out, "| {} |", row.join(" | "));
        }
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
