//! The matrix for programs; the schema is documented in `docs/laws-schema.md`.

use std::collections::BTreeMap;

use kane_matrix::{Cell, Matrix, Property, Row, Witness, unmarked};
use serde::Serialize;

use super::{MatrixReport, word};
use crate::envelope::{Schema, enveloped};

/// The name of the schema.
pub const LAWS_SCHEMA_NAME: &str = "kane-laws";
/// The version of the schema.
pub const LAWS_SCHEMA_VERSION: u32 = 1;

/// What the report is, as a JSON Schema.
#[cfg(feature = "schema")]
pub(crate) fn schema() -> serde_json::Value {
    crate::envelope::schema_enveloped::<File<'static>>("kane laws")
}

/// The matrix as JSON, ended by a line feed.
#[must_use]
pub fn json(report: &MatrixReport<'_>) -> String {
    let matrix = report.matrix;
    let file = File {
        headline: report.headline(),
        properties: matrix.properties.iter().map(|p| Column::of(p)).collect(),
        laws: matrix.rows.iter().map(|row| Law::of(matrix, row)).collect(),
    };
    let schema = Schema { name: LAWS_SCHEMA_NAME, version: LAWS_SCHEMA_VERSION };
    enveloped(schema, &report.command, file)
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct File<'a> {
    headline: String,
    properties: Vec<Column>,
    laws: Vec<Law<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Column {
    id: &'static str,
    name: &'static str,
    domain: String,
    template: &'static str,
}

impl Column {
    fn of(property: &Property) -> Self {
        let Property { id, name, domain, template, .. } = *property;
        Self { id, name, domain: unmarked(domain), template }
    }
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Law<'a> {
    id: &'static str,
    people: &'static str,
    year: Option<u16>,
    form: &'static str,
    source: &'static str,
    known_by: &'static str,
    statement: &'static str,
    restitution: &'static str,
    lacks: Option<String>,
    caveat: Option<&'static str>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    parameters: BTreeMap<&'static str, String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    parameters_are: Vec<Parameter>,
    cells: BTreeMap<&'static str, Entry<'a>>,
}

impl<'a> Law<'a> {
    fn of(matrix: &Matrix, row: &'a Row) -> Self {
        let info = row.law.info;
        let parameters_are = info.parameters.iter().map(|own| Parameter {
            name: own.name,
            meaning: own.meaning,
            domain: own.domain(),
            default: own.default().to_string(),
        });
        let parameters = row.law.parameters().into_iter();
        let parameters = parameters.map(|(name, value)| (name, value.to_string()));
        let cells = matrix.properties.iter().zip(&row.cells);
        Self {
            id: info.id,
            people: info.people,
            year: info.year,
            form: info.form,
            source: info.source,
            known_by: info.known_by.name(),
            statement: info.statement,
            restitution: row.law.restitution(),
            lacks: info.lacks(),
            caveat: info.caveat,
            parameters: parameters.collect(),
            parameters_are: parameters_are.collect(),
            cells: cells.map(|(property, cell)| (property.id, Entry::of(cell))).collect(),
        }
    }
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Parameter {
    name: &'static str,
    meaning: &'static str,
    domain: String,
    default: String,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Entry<'a> {
    finding: &'static str,
    reason: String,
    certificates: usize,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    witness: Vec<Seen<'a>>,
}

impl<'a> Entry<'a> {
    fn of(cell: &'a Cell) -> Self {
        Self {
            finding: word(cell.finding),
            reason: unmarked(&cell.reason),
            certificates: cell.parts.len(),
            witness: cell.witness.iter().map(Seen::of).collect(),
        }
    }
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Seen<'a> {
    contact: String,
    regime: Option<&'static str>,
    outcome: BTreeMap<&'static str, &'a str>,
}

impl<'a> Seen<'a> {
    fn of(witness: &'a Witness) -> Self {
        let said = witness.outcome.as_ref();
        let values = said.map(|said| said.values.as_slice()).unwrap_or_default();
        Self {
            contact: witness.place(),
            regime: said.map(|said| said.regime),
            outcome: values.iter().map(|(name, value)| (*name, value.as_str())).collect(),
        }
    }
}
