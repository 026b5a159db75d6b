//! The ways as rows, for spreadsheets and programs.

use kane_floats::fpcore;
use kane_measure::prices::{Form, Prices, Way};
use serde::Serialize;

use super::{PricesReport, at, by_time, form_of};
use crate::chart::{digits, nanoseconds};
use crate::envelope::{Schema, enveloped};
use crate::floats::bits_at_most;

/// The table as CSV; times in nanoseconds.
#[must_use]
pub fn csv(report: &PricesReport<'_>) -> String {
    let rows = report.all.iter().flat_map(|prices| {
        by_time(prices).into_iter().map(move |way| {
            let text = prices.forms.get(way.form).map_or_else(String::new, |form| form.core.text());
            vec![
                prices.label.clone(),
                form_of(prices, way),
                text,
                way.system.to_string(),
                digits(way.worst),
                digits(way.median),
                bits(prices, way).unwrap_or_default(),
                at(prices, way),
                way.tried.to_string(),
                nanoseconds(way.time.median),
                nanoseconds(way.time.quartiles.0),
                nanoseconds(way.time.quartiles.1),
                way.on_front.to_string(),
            ]
        })
    });
    let names = "formula,form,text,system,digits_worst,digits_median,bits_lost_at_most,worst_at,inputs,ns,ns_first_quartile,ns_third_quartile,pareto";
    crate::sheet::csv(names, rows)
}

/// Bits that are lost at most, proved.
fn bits(prices: &Prices, way: &Way) -> Option<String> {
    way.bound(prices).map(|(bound, format)| bits_at_most(bound.bound, format))
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct File<'a> {
    file: &'a str,
    machine: &'a str,
    formulas: Vec<FormulaJson<'a>>,
    left_out: Vec<LeftOutJson<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct FormulaJson<'a> {
    label: &'a str,
    forms: Vec<FormJson<'a>>,
    ways: Vec<WayJson>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct FormJson<'a> {
    name: &'a str,
    text: String,
    fpcore: String,
}

/// A form in a number system; the fastest comes first.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct WayJson {
    form: String,
    system: String,
    digits_worst: String,
    digits_median: String,
    /// proved, over the whole range
    bits_lost_at_most: Option<String>,
    worst_at: Vec<f64>,
    inputs: usize,
    /// first quartile, median, third quartile
    picoseconds: [u64; 3],
    pareto: bool,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct LeftOutJson<'a> {
    label: &'a str,
    because: &'a str,
}

/// What the report is, as a JSON Schema.
#[cfg(feature = "schema")]
pub(crate) fn schema() -> serde_json::Value {
    crate::envelope::schema_enveloped::<File<'static>>("kane chart FILE")
}

/// The table for programs, ended by a line feed.
#[must_use]
pub fn json(report: &PricesReport<'_>) -> String {
    let file = File {
        file: &report.name,
        machine: &report.machine,
        formulas: report.all.iter().map(formula).collect(),
        left_out: report
            .left_out
            .iter()
            .map(|(label, because)| LeftOutJson { label, because })
            .collect(),
    };
    enveloped(Schema { name: "kane-prices", version: 1 }, &report.command, file)
}

fn form(form: &Form) -> FormJson<'_> {
    FormJson { name: &form.name, text: form.core.text(), fpcore: fpcore::write(&form.core) }
}

fn formula(prices: &Prices) -> FormulaJson<'_> {
    let way = |way: &Way| WayJson {
        form: form_of(prices, way),
        system: way.system.to_string(),
        digits_worst: digits(way.worst),
        digits_median: digits(way.median),
        bits_lost_at_most: bits(prices, way),
        worst_at: way.at.clone(),
        inputs: way.tried,
        picoseconds: [way.time.quartiles.0, way.time.median, way.time.quartiles.1],
        pareto: way.on_front,
    };
    FormulaJson {
        label: &prices.label,
        forms: prices.forms.iter().map(form).collect(),
        ways: by_time(prices).into_iter().map(way).collect(),
    }
}
