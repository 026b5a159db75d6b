//! The curves for programs: one row a point.

use kane_number::System;
use serde::Serialize;

use super::{GrowthReport, chain_reading, family_reading};
use crate::chart::{digits, nanoseconds};
use crate::envelope::{Schema, enveloped};

/// One point of a curve.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Point {
    part: &'static str,
    series: String,
    system: String,
    grows: &'static str,
    size: usize,
    quantity: &'static str,
    value: String,
}

impl GrowthReport<'_> {
    fn points(&self) -> Vec<Point> {
        let mut points = Vec::new();
        for batch in &self.growth.batches {
            for rows in &batch.points {
                let quartiles = [
                    ("ns", rows.time.median),
                    ("ns_first_quartile", rows.time.quartiles.0),
                    ("ns_third_quartile", rows.time.quartiles.1),
                ];
                points.extend(quartiles.map(|(quantity, time)| Point {
                    part: "batch",
                    series: batch.name.to_owned(),
                    system: System::F64.to_string(),
                    grows: "rows",
                    size: rows.rows,
                    quantity,
                    value: nanoseconds(time),
                }));
            }
        }
        for chain in &self.growth.chains {
            for bounce in &chain.bounces {
                let mut add = |system: System, quantity, value| {
                    points.push(Point {
                        part: "chain",
                        series: chain.law.to_owned(),
                        system: system.to_string(),
                        grows: "bounces",
                        size: bounce.n,
                        quantity,
                        value,
                    });
                };
                if let Some(bits) = bounce.bits {
                    add(System::Rational, "bits", bits.to_string());
                }
                for (system, found) in &bounce.digits {
                    if let Some(right) = found.right {
                        add(*system, "digits_right", digits(right));
                    }
                    if let Some(certain) = found.certain {
                        add(*system, "digits_certain", digits(certain));
                    }
                }
                for (system, time) in &bounce.times {
                    add(*system, "ns", nanoseconds(*time));
                }
            }
        }
        for family in &self.growth.families {
            for asked in &family.asked {
                let mut add = |quantity, value| {
                    points.push(Point {
                        part: "audit",
                        series: family.name.to_owned(),
                        system: String::new(),
                        grows: family.grows,
                        size: asked.size,
                        quantity,
                        value,
                    });
                };
                add("verdict", asked.verdict.to_string());
                add("steps", asked.steps.to_string());
                if let Some(time) = asked.time {
                    add("ns", nanoseconds(time));
                }
            }
        }
        points
    }
}

/// Every point as CSV. Without a clock, the same in every run.
#[must_use]
pub fn csv(report: &GrowthReport<'_>) -> String {
    let row = |p: Point| {
        let (part, grows, quantity) =
            (p.part.to_owned(), p.grows.to_owned(), p.quantity.to_owned());
        vec![part, p.series, p.system, grows, p.size.to_string(), quantity, p.value]
    };
    let rows = report.points().into_iter().map(row);
    crate::sheet::csv("part,series,system,grows,size,quantity,value", rows)
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct File<'a> {
    machine: &'a str,
    readings: Vec<Reading>,
    points: Vec<Point>,
}

/// What a curve comes to, in words.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Reading {
    series: String,
    reading: String,
    ended: Vec<String>,
}

/// What the report is, as a JSON Schema.
#[cfg(feature = "schema")]
pub(crate) fn schema() -> serde_json::Value {
    crate::envelope::schema_enveloped::<File<'static>>("kane chart --growth")
}

/// Every point for programs, ended by a line feed.
#[must_use]
pub fn json(report: &GrowthReport<'_>) -> String {
    let growth = report.growth;
    let batches = report.rows_reading().map(|reading| Reading {
        series: "rows in a batch".to_owned(),
        reading,
        ended: Vec::new(),
    });
    let chains = growth.chains.iter().map(|chain| Reading {
        series: chain.law.to_owned(),
        reading: chain_reading(chain),
        ended: chain.ended.iter().map(|(system, end)| format!("{system}: {end}")).collect(),
    });
    let families = growth.families.iter().map(|family| Reading {
        series: family.name.to_owned(),
        reading: family_reading(family),
        ended: Vec::new(),
    });
    let file = File {
        machine: &report.machine,
        readings: batches.into_iter().chain(chains).chain(families).collect(),
        points: report.points(),
    };
    enveloped(Schema { name: "kane-growth", version: 1 }, &report.command, file)
}
