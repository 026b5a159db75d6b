//! Two logs against each other.

use std::fmt::Write as _;

use kane_records::comparison::Comparison;
use kane_records::restitution::NormalLaw;
use kane_records::statistics::percent;
use serde_json::{Value, json};

use super::wording::{asks, brief, friction_name};
use crate::envelope::written;

/// What changed, for people; the names are those of the older and the newer log.
#[must_use]
pub fn compared_text(comparison: &Comparison, [old, new]: &[String; 2]) -> String {
    let headline = if comparison.is_worse() { "Worse than before." } else { "Nothing is worse." };
    let mut out = format!("{new}, against {old}\n{headline}\n\n");
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
    let _ = writeln!(out, "       restitution as stated in {before} % before, {now} % now");
    let [before, now] = comparison.rejected;
    let _ = writeln!(out, "       rows rejected: {before} before, {now} now");
    out
}

/// What changed, for programs.
#[must_use]
pub fn compared_json(comparison: &Comparison, [old, new]: &[String; 2]) -> String {
    let changes: Vec<Value> = comparison
        .changes
        .iter()
        .map(|change| {
            json!({
                "check": change.check.id(),
                "failing": change.failing,
                "worst": change.worst,
                "worse": change.worse,
            })
        })
        .collect();
    written(&json!({
        "schema": { "name": "kane-check-baseline", "version": 1 },
        "program": { "name": "kane", "version": env!("CARGO_PKG_VERSION") },
        "old": old,
        "new": new,
        "worse": comparison.is_worse(),
        "checks": changes,
        "friction": comparison.friction.map(|law| law.map(|law| law.id())),
        "friction_close": comparison.friction_close,
        "restitution": comparison.normal.map(|law| law.as_ref().map(NormalLaw::id)),
        "restitution_close": comparison.normal_close,
        "rejected": comparison.rejected,
    }))
}
