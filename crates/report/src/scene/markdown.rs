//! The report for the web.

use std::fmt::Write as _;

use super::{COST, SceneReport, brief, cost, error, moved, number, verdict, who};

/// The report as Markdown: the answer, why, the models, every impact that is kept.
#[must_use]
pub fn markdown(report: &SceneReport<'_>) -> String {
    let answer = report.answer;
    let mut out = format!("# {}\n\n{}.\n\n", report.title, report.headline());
    out.push_str("| asked | answer | unit | error | tolerance | inputs move it by |\n");
    out.push_str("|---|---|---|---|---|---|\n");
    for line in &answer.lines {
        let value = line.exact.clone().unwrap_or_else(|| number(line.value));
        let _ = writeln!(
            out,
            "| {} | {value} | {} | {} | {} | {} |",
            line.quantity,
            line.quantity.unit(),
            error(line.error, answer.known),
            brief(line.tolerance),
            moved(line.spread),
        );
    }
    let _ = writeln!(out, "\n{}\n", answer.reasons.join(" "));
    out.push_str("| model | cost | error by tolerance | verdict |\n|---|---|---|---|\n");
    for judged in &answer.judged {
        let ratio = judged.ratio.map_or_else(|| "-".to_owned(), brief);
        let verdict = verdict(&judged.verdict, answer.known);
        let _ = writeln!(out, "| {} | {} | {ratio} | {verdict} |", judged.model, cost(judged));
    }
    let _ = writeln!(out, "\n{COST}");
    if !answer.bounces.is_empty() {
        let bodies = answer.end.as_ref().map_or(1, |end| end.bodies.len());
        out.push_str(
            "\n| t, s | who | what | normal, J | tangential, J | rotational, J | gravity, J |\n",
        );
        out.push_str("|---|---|---|---|---|---|---|\n");
        for bounce in &answer.bounces {
            let _ = writeln!(
                out,
                "| {} | {} | {} | {} | {} | {} | {} |",
                number(bounce.time.value),
                who(bounce.encounter, bodies),
                bounce.regime,
                number(bounce.ledger.normal.value),
                number(bounce.ledger.tangential.value),
                number(bounce.ledger.rotational.value),
                number(bounce.gravity.value),
            );
        }
    }
    let _ = writeln!(out, "\nSHA-256 of the scene: `{}`", answer.sha256);
    let _ = writeln!(out, "\n`kane {}: {}`", env!("CARGO_PKG_VERSION"), report.command);
    out
}
