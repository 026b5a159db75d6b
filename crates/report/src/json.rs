//! The report for programs. The schema is documented in `docs/report-schema.md`; a change that can break a
//! reader raises [`SCHEMA_VERSION`].

use std::collections::BTreeMap;

use kane_audit::{LinkJudgement, Standing};
use serde::Serialize;

use crate::envelope::{Program, Schema, written};

use crate::judges;
use crate::report::Entry;
use crate::words::{Form, Line, example};
use crate::{Report, Summary};

/// The name of the schema.
pub const SCHEMA_NAME: &str = "kane-audit";
/// The version of the schema.
pub const SCHEMA_VERSION: u32 = 1;

/// What the report is, as a JSON Schema.
#[cfg(feature = "schema")]
pub(crate) fn schema() -> serde_json::Value {
    crate::envelope::schema_of::<File<'static>>("kane audit")
}

/// The reports as JSON, ended by a line feed.
#[must_use]
pub fn json(reports: &[Report<'_>]) -> String {
    let asked = reports.iter().any(|report| !report.judges.is_empty());
    let told = || reports.iter().map(|report| judges::answers(report.audit, report.judges));
    let file = File {
        judges: asked.then(|| told().collect()),
        schema: Schema { name: SCHEMA_NAME, version: SCHEMA_VERSION },
        program: Program::THIS,
        as_expected: reports.iter().all(Report::as_expected),
        documents: reports.iter().map(Document::of).collect(),
    };
    written(&file)
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct File<'a> {
    schema: Schema,
    program: Program,
    as_expected: bool,
    documents: Vec<Document<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    judges: Option<Vec<judges::Answers<'a>>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Document<'a> {
    name: &'a str,
    title: Option<&'a str>,
    bytes: usize,
    sha256: String,
    command: &'a str,
    as_expected: bool,
    summary: Counts,
    statements: Vec<Statement<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Counts {
    headline: String,
    equations: usize,
    claims: usize,
    verdicts: BTreeMap<String, usize>,
    refuted_as_printed: Vec<String>,
    not_as_expected: Vec<String>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Statement<'a> {
    label: &'a str,
    kind: &'static str,
    line: usize,
    source: &'a str,
    verdict: String,
    conditional: String,
    expect: Option<String>,
    as_expected: bool,
    unproved: Vec<&'a str>,
    rests_on: Vec<&'a str>,
    model: Option<Vec<Value>>,
    links: Vec<Link<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Value {
    name: String,
    value: String,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Link<'a> {
    text: String,
    latex: String,
    verdict: String,
    reason: String,
    certificate: Option<&'a str>,
    used: Vec<&'a str>,
    standing: Option<&'static str>,
    unmet: Vec<&'a str>,
    would_do: Option<&'a str>,
    cost: u64,
    steps: Vec<Step>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Step {
    depth: usize,
    text: String,
}

impl<'a> Document<'a> {
    fn of(report: &'a Report<'_>) -> Self {
        let document = &report.audit.document;
        Self {
            name: &document.name,
            title: document.title.as_deref(),
            bytes: document.text.len(),
            sha256: document.sha256(),
            command: &report.command,
            as_expected: report.as_expected(),
            summary: Counts::of(report),
            statements: report.entries().map(|entry| Statement::of(report, &entry)).collect(),
        }
    }
}

impl Counts {
    fn of(report: &Report<'_>) -> Self {
        let summary = Summary::of(report);
        Self {
            headline: summary.headline(),
            equations: summary.equations,
            claims: summary.claims,
            verdicts: summary
                .verdicts
                .iter()
                .map(|(verdict, n)| (verdict.to_string(), *n))
                .collect(),
            refuted_as_printed: summary.refuted_as_printed,
            not_as_expected: summary.surprises,
        }
    }
}

impl<'a> Statement<'a> {
    fn of(report: &Report<'a>, entry: &Entry<'a>) -> Self {
        let judgement = entry.judgement;
        Self {
            label: &entry.statement.label,
            kind: entry.kind(),
            line: entry.statement.line,
            source: report.audit.document.source(entry.statement),
            verdict: judgement.verdict.to_string(),
            conditional: judgement.conditional.to_string(),
            expect: judgement.expect.map(|verdict| verdict.to_string()),
            as_expected: judgement.as_expected(),
            unproved: entry.labels(&judgement.unproved),
            rests_on: entry.labels(&judgement.rests_on),
            model: example(judgement, Form::Plain).map(|example| {
                example.into_iter().map(|(name, value)| Value { name, value }).collect()
            }),
            links: judgement.links.iter().enumerate().map(|link| Link::of(entry, link)).collect(),
        }
    }
}

impl<'a> Link<'a> {
    fn of(entry: &Entry<'a>, (number, link): (usize, &'a LinkJudgement)) -> Self {
        let steps = entry.steps(link, Form::Plain).into_iter();
        Self {
            text: entry.link_text(number),
            latex: entry.link_latex(number),
            verdict: link.verdict.to_string(),
            reason: entry.reason(link, Form::Plain),
            certificate: link.certificate.as_deref(),
            used: entry.labels(&link.used),
            standing: link.standing.as_ref().map(|standing| match standing {
                Standing::AllMet => "false",
                Standing::Unmet(_) | Standing::NotShown => "does not follow",
            }),
            unmet: match &link.standing {
                Some(Standing::Unmet(failing)) => entry.labels(failing),
                Some(Standing::AllMet | Standing::NotShown) | None => Vec::new(),
            },
            would_do: entry.labels(link.would_do.as_slice()).first().copied(),
            cost: link.cost,
            steps: steps.map(|Line { depth, text, .. }| Step { depth, text }).collect(),
        }
    }
}
