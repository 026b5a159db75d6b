//! The methods as rows, for spreadsheets and programs.

use kane_measure::chart::{DOMAIN, Measured, front};
use serde::Serialize;

use super::{ChartReport, bound, digits, form_of, nanoseconds, reach};
use crate::envelope::{Schema, enveloped};

/// The table as CSV; times, where there are any, in nanoseconds.
#[must_use]
pub fn csv(report: &ChartReport<'_>) -> String {
    let front = front(report.all);
    let row = |(index, measured): (usize, &Measured)| {
        let method = &measured.method;
        let time = |of: &dyn Fn(&kane_measure::chart::Time) -> u64| {
            measured.time.as_ref().map_or_else(String::new, |time| nanoseconds(of(time)))
        };
        let hundredths = |h: i64| format!("{}.{:02}", h.max(0) / 100, h.max(0) % 100);
        let exact = measured.accuracy.worst == i64::MAX;
        let (first, last) = DOMAIN;
        vec![
            method.law.to_owned(),
            method.quantity.to_owned(),
            method.name.to_owned(),
            form_of(method).to_owned(),
            method.k.to_owned(),
            method.system.to_string(),
            format!("2^{}", method.least.max(first)),
            format!("2^{last}"),
            digits(measured.accuracy.worst),
            digits(measured.accuracy.median),
            measured.accuracy.ulps.filter(|_| !exact).map_or_else(String::new, hundredths),
            bound(measured),
            measured.proved.as_ref().map_or_else(String::new, reach),
            measured.proved.as_ref().and_then(|p| p.measured).map_or_else(String::new, hundredths),
            if exact { String::new() } else { format!("{:e}", measured.accuracy.at) },
            measured.cost.map_or_else(String::new, |cost| cost.to_string()),
            time(&|time| time.median),
            time(&|time| time.quartiles.0),
            time(&|time| time.quartiles.1),
            front.get(index).copied().unwrap_or(false).to_string(),
        ]
    };
    let names = "law,quantity,name,form,k,system,alpha_from,alpha_to,digits_worst,digits_median,log2_ulps_worst,ulps_proved,proved_to,log2_ulps_worst_up_to_there,worst_alpha,counted_cost,ns,ns_first_quartile,ns_third_quartile,pareto";
    crate::sheet::csv(names, report.all.iter().enumerate().map(row))
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct File<'a> {
    machine: &'a str,
    warnings: Vec<String>,
    methods: Vec<Row<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Row<'a> {
    law: &'a str,
    quantity: &'a str,
    name: &'a str,
    form: &'a str,
    k: &'a str,
    own_code: bool,
    system: String,
    digits_worst: String,
    digits_median: String,
    log2_ulps_worst: Option<i64>,
    proved: Option<Bound>,
    worst_alpha: f64,
    inputs: usize,
    counted_cost: Option<u64>,
    picoseconds: Option<[u64; 3]>,
    rounds: Option<usize>,
    pareto: bool,
}

/// A proved bound: in ulps, exactly; where it ends; and the worst error measured up to there, in
/// hundredths of log2 ulps.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Bound {
    ulps: String,
    to: String,
    log2_ulps_worst: Option<i64>,
}

/// What the report is, as a JSON Schema.
#[cfg(feature = "schema")]
pub(crate) fn schema() -> serde_json::Value {
    crate::envelope::schema_enveloped::<File<'static>>("kane chart")
}

/// The table for programs, ended by a line feed; times as first quartile, median, third quartile.
#[must_use]
pub fn json(report: &ChartReport<'_>) -> String {
    let front = front(report.all);
    let row = |(index, measured): (usize, &'_ Measured)| {
        let method = &measured.method;
        Row {
            law: method.law,
            quantity: method.quantity,
            name: method.name,
            form: method.text,
            k: method.k,
            own_code: method.is_law,
            system: method.system.to_string(),
            digits_worst: digits(measured.accuracy.worst),
            digits_median: digits(measured.accuracy.median),
            log2_ulps_worst: measured.accuracy.ulps,
            proved: measured.proved.as_ref().map(|proved| Bound {
                ulps: proved.ulps.to_string(),
                to: reach(proved),
                log2_ulps_worst: proved.measured,
            }),
            worst_alpha: measured.accuracy.at,
            inputs: measured.accuracy.tried,
            counted_cost: measured.cost,
            picoseconds: measured
                .time
                .as_ref()
                .map(|time| [time.quartiles.0, time.median, time.quartiles.1]),
            rounds: measured.time.as_ref().map(|time| time.rounds),
            pareto: front.get(index).copied().unwrap_or(false),
        }
    };
    let file = File {
        machine: &report.machine,
        warnings: report.warnings(),
        methods: report.all.iter().enumerate().map(row).collect(),
    };
    enveloped(Schema { name: "kane-chart", version: 1 }, &report.command, file)
}

/// The times as CSV with the machine in a comment, for a figure that is the same in every run.
#[must_use]
pub fn times(report: &ChartReport<'_>) -> String {
    let row = |measured: &Measured| {
        let (method, time) = (&measured.method, measured.time.as_ref()?);
        Some(vec![
            method.law.to_owned(),
            method.quantity.to_owned(),
            method.name.to_owned(),
            method.system.to_string(),
            time.quartiles.0.to_string(),
            time.median.to_string(),
            time.quartiles.1.to_string(),
            time.rounds.to_string(),
        ])
    };
    let names = "law,quantity,name,system,ps_first_quartile,ps,ps_third_quartile,rounds";
    let rows = report.all.iter().filter_map(row);
    format!("# {}\n{}", report.machine, crate::sheet::csv(names, rows))
}

/// The table that is committed: the errors and the counted costs, and how they were made. No times.
#[must_use]
pub fn committed(all: &[Measured]) -> String {
    let row = |measured: &Measured| {
        let method = &measured.method;
        let same = |other: &&Measured| {
            (other.method.law, other.method.quantity) == (method.law, method.quantity)
        };
        let cheaper = |cost: u64| {
            all.iter().filter(same).filter(|other| other.cost.is_some_and(|c| c < cost)).count()
        };
        let exact = measured.accuracy.worst == i64::MAX;
        let (first, last) = DOMAIN;
        let tenths = |h: i64| format!("{}.{}", h.max(0) / 100, h.max(0) % 100 / 10);
        vec![
            method.law.to_owned(),
            method.quantity.to_owned(),
            method.name.to_owned(),
            method.system.to_string(),
            format!("2^{}", method.least.max(first)),
            format!("2^{last}"),
            measured.accuracy.tried.to_string(),
            digits(measured.accuracy.worst),
            digits(measured.accuracy.median),
            measured.accuracy.ulps.filter(|_| !exact).map_or_else(String::new, tenths),
            if exact { String::new() } else { format!("{:e}", measured.accuracy.at) },
            measured.cost.map_or_else(String::new, |cost| cost.to_string()),
            measured.cost.map_or_else(String::new, |cost| (cheaper(cost) + 1).to_string()),
        ]
    };
    let names = "law,quantity,name,system,alpha_from,alpha_to,inputs,digits_worst,digits_median,log2_ulps_worst,worst_alpha,counted_cost,rank";
    crate::sheet::csv(names, all.iter().map(row))
}
