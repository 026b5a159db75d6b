//! The report for programs. The schema is documented in `docs/report-schema.md`.

use serde::Serialize;

use kane_floats::rigor::{Bounded, Cell};
use kane_floats::text::sign;
use kane_floats::{Argument, Core, Language, Precision, emit, fpcore};
use kane_measure::certify::{Account, Certified, Decided, Found, price};

use super::figures::shortest;
use super::source::function;
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
    /// outside of these boxes no input loses more than half of the bits
    half_lost: Vec<Vec<RangeJson<'a>>>,
    /// the comparisons on which the value depends
    decisions: Vec<DecisionJson<'a>>,
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

/// Floats from the first to the last, both included, by their shortest decimals.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct RangeJson<'a> {
    argument: &'a str,
    from: String,
    to: String,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct PoleJson {
    operation: String,
    what: String,
    certain: bool,
}

/// A comparison. Inputs were drawn next to where it turns, and over the domain.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct DecisionJson<'a> {
    text: String,
    /// both sides, as FPCore
    left: String,
    relation: &'static str,
    right: String,
    /// what the certified version is called in the sources, if there is one
    function: Option<String>,
    drawn: usize,
    wrong: usize,
    drawn_near_ties: usize,
    wrong_near_ties: usize,
    example: Option<ExampleJson<'a>>,
}

/// Inputs at which plain floats decide wrongly.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct ExampleJson<'a> {
    at: &'a [String],
    /// whether the comparison of exact values holds
    holds: bool,
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
    accounts.iter().enumerate().map(|(index, one)| account(index, one)).collect()
}

fn account(index: usize, account: &Account) -> AccountJson<'_> {
    let (form, precision) = best(account);
    let source = |language: Language| SourceJson {
        language: language.name(),
        code: emit(form, precision, language),
    };
    AccountJson {
        label: &account.label,
        text: account.core.text(),
        fpcore: fpcore::write(&account.core),
        formats: account.formats.iter().flatten().map(|f| format(account, index, f)).collect(),
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

/// A box, an argument at a time.
fn ranges<'a>(core: &'a Core, precision: Precision, cell: &Cell) -> Vec<RangeJson<'a>> {
    let arguments = core.arguments.iter().zip(&cell.ends);
    let range = |(argument, (from, to)): (&'a Argument, &(f64, f64))| RangeJson {
        argument: &argument.name,
        from: shortest(*from, precision),
        to: shortest(*to, precision),
    };
    arguments.map(range).collect()
}

/// A comparison, of the formula of this index.
fn decision<'a>(
    account: &Account,
    index: usize,
    number: usize,
    of: &'a Decided,
) -> DecisionJson<'a> {
    let core = &account.core;
    let side = |root: usize| {
        fpcore::write(&Core {
            root,
            name: None,
            assumed: vec![],
            properties: vec![],
            ..core.clone()
        })
    };
    let (left, right) = of.decision.operands;
    DecisionJson {
        text: of.decision.text(core),
        left: side(left),
        relation: sign(of.decision.rel),
        right: side(right),
        function: of.decision.is_certifiable(core).then(|| function(account, index, number)),
        drawn: of.drawn,
        wrong: of.wrong,
        drawn_near_ties: of.near,
        wrong_near_ties: of.wrong_near,
        example: of.example.as_ref().map(|(at, holds)| ExampleJson { at, holds: *holds }),
    }
}

fn format<'a>(account: &'a Account, index: usize, certified: &'a Certified) -> FormatJson<'a> {
    let core = &account.core;
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
        half_lost: certified
            .half_lost
            .iter()
            .map(|cell| ranges(core, certified.precision, cell))
            .collect(),
        decisions: certified
            .decided
            .iter()
            .enumerate()
            .map(|(number, of)| decision(account, index, number, of))
            .collect(),
        repairs: certified.repairs.iter().map(repair).collect(),
        unproved: certified.unproved,
    }
}
