//! Two logs against each other.

use std::fmt::Write as _;

use kane_records::comparison::{self, Comparison};
use kane_records::friction::FrictionLaw;
use kane_records::restitution::NormalLaw;
use kane_records::statistics::percent;
use serde::Serialize;

use super::wording::{asks, brief, friction_name};
use crate::envelope::{Program, Schema, written};

/// What changed, for people; the names are those of the older and the newer log.
#[must_use]
pub fn compared_text(comparison: &Comparison, [old, new]: &[String; 2]) -> String {
    let mut out = format!("{new}, against {old}\n{}\n\n", news(comparison));
    for change in &comparison.changes {
        let mark = if change.worse { "WORSE" } else { "  -  " };
        let [before, now] = change.failing.map(|share| format!("{} %", brief(percent(share))));
        let [worst, worst_now] = change.worst.map(brief);
        let _ = writeln!(
            out,
            "{mark}  {}: fails in {before} before, {now} now; worst {worst} before, {worst_now} now",
            asks(change.check)
        );
    }
    let laws =
        comparison.friction.map(|law| law.map_or_else(|| "not asked".to_owned(), friction_name));
    let [before, now] = comparison.friction_close.map(|share| brief(percent(share)));
    let mark = if comparison.friction_is_worse() { "WORSE" } else { "  -  " };
    let _ = writeln!(
        out,
        "{mark}  friction: {} in {before} % before, {} in {now} % now",
        laws[0], laws[1]
    );
    let [before, now] = comparison.normal_close.map(|share| brief(percent(share)));
    let mark = if comparison.normal_is_worse() { "WORSE" } else { "  -  " };
    let _ = writeln!(out, "{mark}  restitution as stated in {before} % before, {now} % now");
    let [before, now] = comparison.rejected;
    let _ = writeln!(out, "       rows rejected: {before} before, {now} now");
    if comparison.normal_moved() {
        let [before, now] = comparison.normal_offset.map(brief);
        let _ = writeln!(
            out,
            "MOVED  e is off what is stated by {before} on the whole before, {now} now"
        );
    }
    if comparison.arm_moved() {
        let [before, now] = comparison.arm.map(|arm| brief(percent(arm.unwrap_or(0.0))));
        let _ = writeln!(
            out,
            "MOVED  the stated arm is too long by {before} % in the median before, {now} % now"
        );
    }
    out
}

/// What came of it, in a sentence.
pub(super) fn news(comparison: &Comparison) -> &'static str {
    if comparison.is_worse() {
        "Worse than before."
    } else if comparison.normal_moved() || comparison.arm_moved() {
        "Nothing is worse, but e or the arm is off by another amount."
    } else {
        "Nothing is worse."
    }
}

/// What changed, for programs.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct File<'a> {
    schema: Schema,
    program: Program,
    old: &'a str,
    new: &'a str,
    worse: bool,
    checks: Vec<Change>,
    friction: [Option<&'static str>; 2],
    friction_close: [f64; 2],
    restitution: [Option<&'static str>; 2],
    restitution_close: [f64; 2],
    restitution_off: [f64; 2],
    restitution_moved: bool,
    arm_off: [Option<f64>; 2],
    arm_moved: bool,
    rejected: [u64; 2],
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Change {
    check: &'static str,
    failing: [f64; 2],
    worst: [f64; 2],
    worse: bool,
}

/// What the report is, as a JSON Schema.
#[cfg(feature = "schema")]
pub(crate) fn baseline_schema() -> serde_json::Value {
    crate::envelope::schema_of::<File<'static>>("kane check --baseline")
}

/// What changed as JSON, ended by a line feed; what was before comes first in every pair.
#[must_use]
pub fn compared_json(comparison: &Comparison, [old, new]: &[String; 2]) -> String {
    let change = |change: &comparison::Change| Change {
        check: change.check.id(),
        failing: change.failing,
        worst: change.worst,
        worse: change.worse,
    };
    written(&File {
        schema: Schema { name: "kane-check-baseline", version: 1 },
        program: Program::THIS,
        old,
        new,
        worse: comparison.is_worse(),
        checks: comparison.changes.iter().map(change).collect(),
        friction: comparison.friction.map(|law| law.map(FrictionLaw::id)),
        friction_close: comparison.friction_close,
        restitution: [0, 1].map(|i| comparison.normal[i].as_ref().map(NormalLaw::id)),
        restitution_close: comparison.normal_close,
        restitution_off: comparison.normal_offset,
        restitution_moved: comparison.normal_moved(),
        arm_off: comparison.arm,
        arm_moved: comparison.arm_moved(),
        rejected: comparison.rejected,
    })
}
