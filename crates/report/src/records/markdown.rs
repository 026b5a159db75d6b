//! A study in Markdown.

use std::fmt::Write as _;

use super::RecordsReport;
use super::sentence::headline;
use super::wording::{
    asks, friction_name, interval, law, log_facts, pair, rejected, replayed, residual, suspicion,
    untold, verdict,
};

/// The study as Markdown.
#[must_use]
pub fn markdown(report: &RecordsReport<'_>) -> String {
    let study = report.study;
    let mut out =
        format!("# `{}`\n\n**{}**\n\n{}.\n", report.log, headline(study), log_facts(report));
    for line in rejected(study) {
        let _ = writeln!(out, "\n- {line}");
    }
    for found in &study.suspicions {
        let _ = writeln!(out, "\n- Suspected: {}", suspicion(found));
    }
    out.push_str("\n## Checks\n\n| check | verdict | rows | near | worst | line |\n|---|---|---|---|---|---|\n");
    for checked in &study.checks {
        let (line, worst) = checked.worst.map_or_else(Default::default, |(line, finding)| {
            (line.to_string(), residual(checked.check, &finding))
        });
        let _ = writeln!(
            out,
            "| {} | {} | {} | {} | {worst} | {line} |",
            asks(checked.check).replace('|', "\\|"),
            verdict(checked),
            checked.rows,
            checked.near
        );
    }
    out.push_str("\n## Friction, given the measured normal impulse\n\n| law | within tolerance | within 0.01 | median miss of k | worst | line |\n|---|---|---|---|---|---|\n");
    for fit in &study.friction {
        let _ = writeln!(
            out,
            "| {} | {} of {} | {} | {:.1e} | {:.1e} | {} |",
            friction_name(fit.law),
            fit.consistent,
            fit.rows,
            fit.close,
            fit.median,
            fit.worst,
            fit.worst_line
        );
    }
    out.push_str("\n## Rigid laws\n\n| law | gives | silent | median miss | worst | line |\n|---|---|---|---|---|---|\n");
    for fit in &study.laws {
        let _ = writeln!(
            out,
            "| {} | {} of {} | {} | {:.1e} | {:.1e} | {} |",
            law(fit),
            fit.consistent,
            fit.rows,
            fit.silent,
            fit.median,
            fit.worst,
            fit.worst_line
        );
    }
    out.push_str("\n## Coefficients\n\n| stated | e | mu | beta0 |\n|---|---|---|---|\n");
    for fit in &study.fits {
        let cells = [&fit.restitution, &fit.friction, &fit.rebound]
            .map(|fitted| fitted.as_ref().map_or_else(String::new, interval));
        let _ = writeln!(out, "| {} | {} |", pair(fit, study), cells.join(" | "));
    }
    if !study.untold.is_empty() {
        out.push_str("\n## What these rows cannot tell\n\n");
        for open in &study.untold {
            let _ = writeln!(out, "- {}", untold(open));
        }
    }
    if !study.worst.is_empty() {
        out.push_str("\n## The worst rows\n\n");
        for worst in &study.worst {
            let _ = writeln!(
                out,
                "- line {}: {}, left {}: `{}`",
                worst.line,
                asks(worst.check),
                residual(worst.check, &worst.finding),
                replayed(worst, report.log)
            );
        }
    }
    let _ = writeln!(out, "\nkane {}: `{}`", env!("CARGO_PKG_VERSION"), report.command);
    out
}
