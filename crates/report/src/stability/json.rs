//! The report for programs. The schema is documented in `docs/report-schema.md`.

use serde::Serialize;

use crate::envelope::{Schema, enveloped};

use super::{Entry, StabilityReport, bits};

/// The name of the schema.
const SCHEMA_NAME: &str = "kane-stability";
/// The version of the schema.
const SCHEMA_VERSION: u32 = 2;

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct File<'a> {
    document: &'a str,
    title: Option<&'a str>,
    left_out: Vec<LeftOut<'a>>,
    formulas: Vec<Formula<'a>>,
    bounds: Vec<crate::floats::AccountJson<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Formula<'a> {
    label: &'a str,
    also: &'a [String],
    quantity: &'a str,
    text: &'a str,
    with: &'a [String],
    inputs: Vec<&'a str>,
    of_the_document: bool,
    equal: Vec<&'a str>,
    lines: Vec<Line<'a>>,
    planes: Vec<Plane<'a>>,
    searches: Vec<Search<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct LeftOut<'a> {
    label: &'a str,
    why: &'a str,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Search<'a> {
    format: &'a str,
    precision: u32,
    points: usize,
    worst: Vec<&'a str>,
    bits_lost: String,
    faults: Vec<Points<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Points<'a> {
    fault: &'static str,
    points: usize,
    example: Vec<&'a str>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Line<'a> {
    format: &'a str,
    precision: u32,
    from: &'a str,
    to: &'a str,
    tried: usize,
    worst: &'a str,
    bits_lost: String,
    ranges: Vec<Range<'a>>,
    /// binade, bits lost, fault; in between nothing changes by more than half a bit
    profile: Vec<(i64, String, Option<&'static str>)>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Range<'a> {
    fault: &'static str,
    from: &'a str,
    to: &'a str,
    from_is_end_of_domain: bool,
    to_is_end_of_domain: bool,
    worst: &'a str,
    bits_lost: String,
    returns: &'a str,
    exact: &'a str,
    cause: &'a str,
    better: Option<Better<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Better<'a> {
    label: &'a str,
    text: &'a str,
    with: &'a [String],
    bits_lost: String,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Plane<'a> {
    format: &'a str,
    precision: u32,
    cells: usize,
    worst: [&'a str; 2],
    bits_lost: String,
    faults: Vec<Cells<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Cells<'a> {
    fault: &'static str,
    cells: usize,
    example: [&'a str; 2],
}

/// What the report is, as a JSON Schema.
#[cfg(feature = "schema")]
pub(crate) fn schema() -> serde_json::Value {
    crate::envelope::schema_enveloped::<File<'static>>("kane stability")
}

/// The report as JSON, ended by a line feed. Inputs are the shortest decimals that name them.
#[must_use]
pub fn json(report: &StabilityReport<'_>) -> String {
    let stability = report.stability;
    let entries = report.entries();
    let file = File {
        document: &stability.name,
        title: stability.title.as_deref(),
        left_out: stability
            .subject
            .left_out
            .iter()
            .map(|(label, why)| LeftOut { label, why })
            .collect(),
        formulas: entries.iter().enumerate().map(|(i, e)| formula(report, i, e)).collect(),
        bounds: crate::floats::accounts_json(report.accounts),
    };
    enveloped(Schema { name: SCHEMA_NAME, version: SCHEMA_VERSION }, &report.command, file)
}

fn formula<'a>(report: &StabilityReport<'a>, index: usize, entry: &Entry<'a>) -> Formula<'a> {
    let subject = &report.stability.subject;
    let formula = entry.formula;
    let equal = subject.equal.get(index).into_iter().flatten();
    Formula {
        label: &formula.label,
        also: &formula.also,
        quantity: &formula.quantity,
        text: &formula.text,
        with: &formula.by,
        inputs: formula.inputs.iter().map(|input| input.name.as_str()).collect(),
        of_the_document: entry.is_own,
        equal: equal.filter_map(|i| subject.formulas.get(*i)).map(|f| f.text.as_str()).collect(),
        lines: entry.lines.iter().map(|line| self::line(report, line)).collect(),
        planes: entry.planes.iter().map(|plane| self::plane(plane)).collect(),
        searches: entry.searches.iter().map(|search| self::search(search)).collect(),
    }
}

fn line<'a>(report: &StabilityReport<'a>, line: &'a kane_measure::Examined) -> Line<'a> {
    let range = |range: &'a kane_measure::Range| Range {
        fault: range.fault.name(),
        from: &range.from.text,
        to: &range.to.text,
        from_is_end_of_domain: range.open.0,
        to_is_end_of_domain: range.open.1,
        worst: &range.worst.text,
        bits_lost: bits(range.lost),
        returns: &range.computed,
        exact: &range.exact,
        cause: &range.cause,
        better: range.better.as_ref().and_then(|better| {
            let formula = report.better(better)?;
            let (label, text, with) = (&formula.label, &formula.text, &formula.by);
            Some(Better { label, text, with, bits_lost: bits(better.lost) })
        }),
    };
    Line {
        format: line.format,
        precision: line.precision,
        from: &line.domain.0.text,
        to: &line.domain.1.text,
        tried: line.tried,
        worst: &line.worst.0.text,
        bits_lost: bits(line.worst.1),
        ranges: line.ranges.iter().map(range).collect(),
        profile: super::thinned(line)
            .into_iter()
            .map(|(binade, lost, fault)| (binade, bits(lost), fault.map(kane_measure::Fault::name)))
            .collect(),
    }
}

fn plane(plane: &kane_measure::Plane) -> Plane<'_> {
    let ((first, second), lost) = &plane.worst;
    Plane {
        format: plane.format,
        precision: plane.precision,
        cells: plane.cells.len(),
        worst: [&first.text, &second.text],
        bits_lost: bits(*lost),
        faults: plane
            .faults
            .iter()
            .map(|(fault, cells, (first, second))| Cells {
                fault: fault.name(),
                cells: *cells,
                example: [&first.text, &second.text],
            })
            .collect(),
    }
}

fn search(search: &kane_measure::Searched) -> Search<'_> {
    let (worst, lost) = &search.worst;
    Search {
        format: search.format,
        precision: search.precision,
        points: search.tried,
        worst: texts(worst),
        bits_lost: bits(*lost),
        faults: search
            .faults
            .iter()
            .map(|(fault, points, example)| Points {
                fault: fault.name(),
                points: *points,
                example: texts(example),
            })
            .collect(),
    }
}

fn texts(points: &[kane_measure::Point]) -> Vec<&str> {
    points.iter().map(|point| point.text.as_str()).collect()
}
