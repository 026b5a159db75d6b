//! The report for programs. The schema is documented in `docs/report-schema.md`.

use serde::Serialize;

use kane_floats::rigor::Bounded;
use kane_floats::{Core, Language, emit, fpcore};
use kane_measure::certify::{Account, Certified, Found, price};

use super::{FloatsReport, best, told};
use crate::envelope::{Schema, enveloped};

const SCHEMA_NAME: &str = "kane-floats";
const SCHEMA_VERSION: u32 = 1;

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct File<'a> {
    file: &'a str,
    formulas: Vec<AccountJson<'a>>,
}

/// A formula.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct AccountJson<'a> {
    label: &'a str,
    text: String,
    fpcore: String,
    formats: Vec<FormatJson<'a>>,
    /// the best form, by language
    source: Vec<SourceJson>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct FormatJson<'a> {
    format: &'static str,
    /// where no bound is rigorous there is none
    error_at_most: Option<f64>,
    error_found: Option<FoundJson<'a>>,
    ulps_at_most: Option<f64>,
    ulps_found: Option<FoundJson<'a>>,
    pole: Option<PoleJson>,
    repairs: Vec<RepairJson<'a>>,
    unproved: usize,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct FoundJson<'a> {
    error: Option<f64>,
    at: &'a [String],
    returns: &'a str,
    exact: &'a str,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct PoleJson {
    operation: String,
    what: String,
    certain: bool,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct RepairJson<'a> {
    text: String,
    fpcore: String,
    error_at_most: Option<f64>,
    ulps_at_most: Option<f64>,
    ulps_found: Option<FoundJson<'a>>,
    light_operations: usize,
    heavy_operations: usize,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct SourceJson {
    language: &'static str,
    code: String,
}

/// What the report is, as a JSON Schema.
#[cfg(feature = "schema")]
pub(crate) fn schema() -> serde_json::Value {
    crate::envelope::schema_enveloped::<File<'static>>("kane stability FILE.fpcore")
}

/// The report as JSON, ended by a line feed.
#[must_use]
pub fn json(report: &FloatsReport<'_>) -> String {
    let file = File { file: &report.name, formulas: accounts_json(report.accounts) };
    enveloped(Schema { name: SCHEMA_NAME, version: SCHEMA_VERSION }, &report.command, file)
}

/// The formulas for programs.
pub(crate) fn accounts_json(accounts: &[Account]) -> Vec<AccountJson<'_>> {
    accounts.iter().map(account).collect()
}

fn account(account: &Account) -> AccountJson<'_> {
    let (form, precision) = best(account);
    let source = |language: Language| SourceJson {
        language: language.name(),
        code: emit(form, precision, language),
    };
    AccountJson {
        label: &account.label,
        text: account.core.text(),
        fpcore: fpcore::write(&account.core),
        formats: account.formats.iter().flatten().map(|f| format(&account.core, f)).collect(),
        source: Language::ALL.into_iter().map(source).collect(),
    }
}

/// A number if it is finite: JSON has no others.
fn finite(x: f64) -> Option<f64> {
    x.is_finite().then_some(x)
}

fn bound(bounded: &Bounded) -> Option<f64> {
    bounded.pole.is_none().then_some(bounded.bound).and_then(finite)
}

fn found(found: Option<&Found>) -> Option<FoundJson<'_>> {
    found.map(|found| FoundJson {
        error: finite(found.error),
        at: &found.at,
        returns: &found.computed,
        exact: &found.exact,
    })
}

fn format<'a>(core: &Core, certified: &'a Certified) -> FormatJson<'a> {
    let pole = certified.absolute.pole.as_ref().map(|pole| PoleJson {
        operation: kane_floats::text::infix(core, pole.operation),
        what: told(core, pole),
        certain: pole.certain,
    });
    let repair = |repair: &'a kane_measure::certify::Repair| {
        let price = price(&repair.core);
        RepairJson {
            text: repair.core.text(),
            fpcore: fpcore::write(&repair.core),
            error_at_most: bound(&repair.absolute),
            ulps_at_most: bound(&repair.ulps),
            ulps_found: found(repair.worst_in_ulps.as_ref()),
            light_operations: price.light,
            heavy_operations: price.heavy,
        }
    };
    FormatJson {
        format: certified.precision.name(),
        error_at_most: bound(&certified.absolute),
        error_found: found(certified.worst.as_ref()),
        ulps_at_most: bound(&certified.ulps),
        ulps_found: found(certified.worst_in_ulps.as_ref()),
        pole,
        repairs: certified.repairs.iter().map(repair).collect(),
        unproved: certified.unproved,
    }
}
