//! A collision for programs; the schema is documented in `docs/collide-format.md`.

use serde::Serialize;

use crate::envelope::{Schema, enveloped};

use kane_scene::collide::{self, Collision};

/// The name of the schema.
pub const COLLISION_SCHEMA_NAME: &str = "kane-collide";
/// The version of the schema.
pub const COLLISION_SCHEMA_VERSION: u32 = 3;

/// What the report is, as a JSON Schema.
#[cfg(feature = "schema")]
pub(crate) fn schema() -> serde_json::Value {
    crate::envelope::schema_enveloped::<File<'static>>("kane collide")
}

/// The collision as JSON, ended by a line feed. Floats are finite or null.
#[must_use]
pub fn json(collision: &Collision) -> String {
    let file = File {
        title: &collision.title,
        headline: super::headline(collision),
        as_expected: collision.as_expected(),
        given: collision
            .given
            .iter()
            .map(|given| Given {
                symbol: &given.symbol,
                value: &given.value,
                unit: given.unit,
                assumed: given.assumed,
            })
            .collect(),
        notes: &collision.notes,
        before: collision.before.iter().map(Reading::of).collect(),
        laws: collision.laws.iter().map(Law::of).collect(),
    };
    let schema = Schema { name: COLLISION_SCHEMA_NAME, version: COLLISION_SCHEMA_VERSION };
    enveloped(schema, &collision.command, file)
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct File<'a> {
    title: &'a str,
    headline: String,
    as_expected: bool,
    given: Vec<Given<'a>>,
    notes: &'a [String],
    before: Vec<Reading<'a>>,
    laws: Vec<Law<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Given<'a> {
    symbol: &'a str,
    value: &'a str,
    unit: &'a str,
    assumed: bool,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Law<'a> {
    id: &'a str,
    statement: &'a str,
    source: &'a str,
    restitution: &'a str,
    parameters: Vec<Parameter<'a>>,
    reason: Option<&'a str>,
    outcome: Option<Outcome<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Parameter<'a> {
    name: &'a str,
    value: &'a str,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Outcome<'a> {
    regime: &'a str,
    energy: &'a str,
    quantities: Vec<Reading<'a>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    checks: Vec<Check<'a>>,
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    remarks: &'a [String],
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Check<'a> {
    claim: &'a str,
    holds: bool,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Reading<'a> {
    symbol: &'a str,
    unit: &'a str,
    exact: Option<&'a str>,
    digits: Option<&'a str>,
    float: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    lanes: Option<Lanes>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Lanes {
    plain: Option<f64>,
    error_of_inputs: Option<f64>,
    error_of_plain: Option<f64>,
    error_of_wide: Option<f64>,
    enclosure: Option<[Option<f64>; 2]>,
}

impl<'a> Reading<'a> {
    fn of(reading: &'a collide::Reading) -> Self {
        // zero has no sign here
        let positive = |float: f64| if float == 0.0 { 0.0 } else { float };
        let finite = |float: f64| Some(float).filter(|float| float.is_finite()).map(positive);
        let lanes = reading.errors.map(|errors| Lanes {
            plain: reading.plain.and_then(finite),
            error_of_inputs: errors.inputs.and_then(finite),
            error_of_plain: errors.plain.and_then(finite),
            error_of_wide: errors.wide.and_then(finite),
            enclosure: reading.enclosure.map(|ends| ends.map(finite)),
        });
        Self {
            symbol: reading.symbol,
            unit: reading.unit,
            exact: reading.fraction.as_deref(),
            digits: reading.exact.as_deref(),
            float: reading.float.and_then(finite),
            lanes,
        }
    }
}

impl<'a> Law<'a> {
    fn of(law: &'a collide::LawAnswer) -> Self {
        Self {
            id: law.id,
            statement: law.statement,
            source: law.source,
            restitution: law.restitution,
            parameters: law
                .parameters
                .iter()
                .map(|(name, value)| Parameter { name, value })
                .collect(),
            reason: law.answer.as_ref().err().map(String::as_str),
            outcome: law.answer.as_ref().ok().map(|answer| Outcome {
                regime: answer.regime,
                energy: answer.energy.word(),
                quantities: answer.readings.iter().map(Reading::of).collect(),
                checks: answer
                    .checks
                    .iter()
                    .map(|check| Check { claim: &check.claim, holds: check.holds })
                    .collect(),
                remarks: &answer.remarks,
            }),
        }
    }
}
