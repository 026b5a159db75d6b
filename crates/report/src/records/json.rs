//! A study for programs; the schema is documented in `docs/records.md`.

use serde_json::{Value, json};

use kane_records::fit::Fitted;
use kane_records::replay::Replay;
use kane_records::rigid::parameters;
use kane_records::schema::SCHEMA_VERSION;

use super::RecordsReport;
use super::sentence::headline;
use super::wording::{asks, replayed, suspicion, untold};
use crate::envelope::written;

/// The name of the schema.
pub const RECORDS_SCHEMA_NAME: &str = "kane-check";
/// The version of the schema.
pub const RECORDS_SCHEMA_VERSION: u32 = 1;

/// What the report is, as a JSON Schema. It is written by hand, since the study is told value by value.
#[cfg(feature = "schema")]
pub(crate) fn report_schema() -> Value {
    serde_json::from_str(include_str!("schema.json")).expect("the schema is JSON")
}

/// The study as JSON, ended by a line feed. A number that is not finite is null.
#[must_use]
pub fn json(report: &RecordsReport<'_>) -> String {
    let study = report.study;
    let checks: Vec<Value> = study
        .checks
        .iter()
        .map(|checked| {
            json!({
                "check": checked.check.id(),
                "asks": asks(checked.check),
                "unit": checked.check.unit(),
                "rows": checked.rows,
                "failed": checked.failed,
                "undecided": checked.undecided,
                "near": checked.near,
                "excused_by": checked.excused,
                "as_expected": checked.as_expected(),
                "worst": checked.worst.map(|(line, finding)| json!({
                    "line": known(line),
                    "residual": finding.residual,
                    "tolerance": finding.tolerance,
                    "size": finding.size(),
                })),
            })
        })
        .collect();
    let friction: Vec<Value> = study
        .friction
        .iter()
        .map(|fit| {
            json!({
                "law": fit.law.id(),
                "parameter": fit.law.parameter(),
                "rows": fit.rows,
                "consistent": fit.consistent,
                "close": fit.close,
                "rough": fit.rough,
                "median": fit.median,
                "worst": fit.worst,
                "worst_line": known(fit.worst_line),
                "tied": fit.tied,
            })
        })
        .collect();
    let laws: Vec<Value> = study
        .laws
        .iter()
        .map(|fit| {
            let own: serde_json::Map<String, Value> = parameters(&fit.law)
                .into_iter()
                .map(|(name, value)| (name.to_owned(), json!(value)))
                .collect();
            json!({
                "law": fit.law.info.id,
                "fitted": fit.fitted,
                "parameters": own,
                "rows": fit.rows,
                "silent": fit.silent,
                "consistent": fit.consistent,
                "gives_all": fit.gives_all(),
                "median": fit.median,
                "worst": fit.worst,
                "worst_line": known(fit.worst_line),
            })
        })
        .collect();
    let fits: Vec<Value> = study
        .fits
        .iter()
        .map(|fit| {
            let pair = usize::try_from(fit.pair).ok().and_then(|pair| study.pairs.get(pair));
            json!({
                "pair": pair,
                "stated_mu": fit.stated[0],
                "stated_e": fit.stated[1],
                "rows": fit.rows,
                "e": fit.restitution.as_ref().map(interval),
                "mu": fit.friction.as_ref().map(interval),
                "beta0": fit.rebound.as_ref().map(interval),
            })
        })
        .collect();
    let rejected: Vec<Value> = study
        .rejections
        .kinds()
        .map(|(kind, count, rows)| {
            let first: Vec<Value> =
                rows.iter().map(|row| json!({ "line": known(row.line), "why": row.why })).collect();
            json!({ "kind": kind, "rows": count, "first": first })
        })
        .collect();
    let worst: Vec<Value> = study
        .worst
        .iter()
        .map(|worst| {
            let file = match &worst.replay {
                Replay::File(text) => Some(text),
                Replay::Flags(_) => None,
            };
            json!({
                "line": known(worst.line),
                "id": worst.id,
                "check": worst.check.id(),
                "residual": worst.finding.residual,
                "tolerance": worst.finding.tolerance,
                "replay": replayed(worst, report),
                "file": file,
            })
        })
        .collect();
    let restitution = study.restitution.as_ref().map(|found| {
        let depends: Vec<Value> = found
            .depends
            .iter()
            .map(|(factor, share)| json!({ "on": factor.id(), "share": share }))
            .collect();
        json!({
            "law": found.law.id(),
            "rows": found.rows,
            "stated": found.stated,
            "consistent": found.consistent,
            "close": found.close,
            "least": found.observed[0],
            "median": found.observed[1],
            "greatest": found.observed[2],
            "above_one": found.above_one,
            "depends": depends,
        })
    });
    written(&json!({
        "schema": { "name": RECORDS_SCHEMA_NAME, "version": RECORDS_SCHEMA_VERSION },
        "program": { "name": "kane", "version": env!("CARGO_PKG_VERSION") },
        "records_version": SCHEMA_VERSION,
        "command": report.command,
        "log": report.log,
        "headline": headline(study),
        "as_expected": study.as_expected(),
        "rows": study.rows,
        "rejected": rejected,
        "suspected": study.suspicions.iter().map(suspicion).collect::<Vec<_>>(),
        "not_read": study.header.unread,
        "si_assumed": study.header.unitless,
        "format": study.precision.told.format.name(),
        "format_in_doubt": study.precision.told.or.is_some(),
        "column_formats": study.precision.told.columns().map(|(column, format)| json!({
            "column": column.name(),
            "format": format.name(),
        })).collect::<Vec<Value>>(),
        "checks": checks,
        "energy": {
            "before": study.energy.before,
            "change_normal": study.energy.change[0],
            "change_tangential": study.energy.change[1],
            "change_rotational": study.energy.change[2],
            "rows_gaining_by_friction": study.energy.friction_gains,
            "rows_with_e_above_one_and_no_gain": study.energy.bouncy,
            "rows_sliding_without_friction": study.energy.frictionless,
        },
        "sampled": study.sampled,
        "restitution": restitution,
        "friction": friction,
        "laws": laws,
        "coefficients": fits,
        "untold": study.untold.iter().map(untold).collect::<Vec<_>>(),
        "worst": worst,
    }))
}

/// A line that is known.
fn known(line: u64) -> Option<u64> {
    (line > 0).then_some(line)
}

fn interval(fitted: &Fitted) -> Value {
    json!({
        "low": fitted.low,
        "high": fitted.high,
        "rows": fitted.rows,
        "one_value": fitted.one_value,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_that_is_not_known_is_none_and_an_interval_has_its_ends() {
        assert_eq!([known(0), known(1), known(7)], [None, Some(1), Some(7)]);
        let fitted = Fitted { low: 0.25, high: 0.5, rows: 3, one_value: false };
        let expected = json!({ "low": 0.25, "high": 0.5, "rows": 3, "one_value": false });
        assert_eq!(interval(&fitted), expected);
    }
}
