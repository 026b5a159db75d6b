//! The report as a page.

use maud::{Markup, PreEscaped, html};

use super::{
    COST, SceneReport, brief, cost, error, ledger_picture, moved, number, picture, verdict, who,
};
use crate::html::Frame;
use crate::stability::PictureError;

/// Rows of the table of impacts; the rest is in the CSV file.
const MOST_ROWS: usize = 200;

/// The report as one HTML file, which loads nothing: the answer, why, the motion and the ledger as
/// pictures, the models, and up to two hundred impacts. Equal reports give equal bytes.
///
/// # Errors
/// [`PictureError`], which drawing into a string does not give in practice.
pub fn html(report: &SceneReport<'_>) -> Result<String, PictureError> {
    let drawn = picture(report)?;
    let ledger = ledger_picture(report)?;
    let has_impacts = !report.answer.bounces.is_empty();
    let mut contents = vec![("why", "Why this model")];
    contents.extend(drawn.as_ref().map(|drawn| (drawn.name, drawn.heading)));
    contents.extend(ledger.is_some().then_some(("ledger", "Energy")));
    contents.push(("models", "Models"));
    contents.extend(has_impacts.then_some(("impacts", "Impacts")));
    let content = html! {
        (answers(report))
        h2 id="why" { "Why this model" }
        @for reason in &report.answer.reasons { p { (reason) } }
        @if let Some(drawn) = &drawn { (figure(drawn.name, drawn.heading, &drawn.svg)) }
        @if let Some(picture) = &ledger { (figure("ledger", "Energy", picture)) }
        (models(report))
        @if has_impacts { (impacts(report)) }
    };
    let page = Frame {
        title: &report.title,
        kind: "Scene",
        news: html! { p { (report.headline()) "." } },
        contents: contents
            .iter()
            .map(|(id, words)| ((*id).to_owned(), html! { (words) }))
            .collect(),
        style: include_str!("scene.css"),
        script: "",
        provenance: vec![
            ("Program", html! { "kane " (env!("CARGO_PKG_VERSION")) }),
            ("Command", html! { code { (report.command) } }),
            ("SHA-256 of the scene", html! { code { (report.answer.sha256) } }),
            ("Seed", html! { "none: nothing here is drawn at random" }),
        ],
    };
    Ok(page.page(&content))
}

fn figure(id: &str, heading: &str, picture: &str) -> Markup {
    html! {
        h2 id=(id) { (heading) }
        figure.picture role="img" aria-label=(heading) { (PreEscaped(picture)) }
    }
}

fn answers(report: &SceneReport<'_>) -> Markup {
    html! {
        table {
            thead { tr {
                @for head in
                    ["asked", "answer", "unit", "error", "tolerance", "inputs move it by"]
                { th scope="col" { (head) } }
            } }
            tbody {
                @for line in &report.answer.lines {
                    tr {
                        th scope="row" { code { (line.quantity) } }
                        td.number { (line.exact.clone().unwrap_or_else(|| number(line.value))) }
                        td { (line.quantity.unit()) }
                        td.number { (error(line.error, report.answer.known)) }
                        td.number { (brief(line.tolerance)) }
                        td.number { (moved(line.spread)) }
                    }
                }
            }
        }
    }
}

fn models(report: &SceneReport<'_>) -> Markup {
    html! {
        h2 id="models" { "Models" }
        p { (COST) }
        table {
            thead { tr {
                @for head in ["model", "cost", "error by tolerance", "verdict"] {
                    th scope="col" { (head) }
                }
            } }
            tbody {
                @for judged in &report.answer.judged {
                    tr {
                        th scope="row" { code { (judged.model) } }
                        td.number { (cost(judged)) }
                        td.number { (judged.ratio.map_or_else(|| "-".to_owned(), brief)) }
                        td.verdict { (verdict(&judged.verdict, report.answer.known)) }
                    }
                }
            }
        }
    }
}

fn impacts(report: &SceneReport<'_>) -> Markup {
    let bounces = &report.answer.bounces;
    let bodies = report.answer.end.as_ref().map_or(1, |end| end.bodies.len());
    html! {
        h2 id="impacts" { "Impacts" }
        @if bounces.len() > MOST_ROWS {
            p { "The first " (MOST_ROWS) " of " (bounces.len()) "." }
        }
        table {
            thead { tr {
                @for head in [
                    "t, s", "who", "what", "normal, J", "tangential, J", "rotational, J", "gravity, J",
                ] { th scope="col" { (head) } }
            } }
            tbody {
                @for bounce in bounces.iter().take(MOST_ROWS) {
                    tr {
                        td.number { (number(bounce.time.value)) }
                        td { (who(bounce.encounter, bodies)) }
                        td { (bounce.regime) }
                        @for part in [
                            &bounce.ledger.normal,
                            &bounce.ledger.tangential,
                            &bounce.ledger.rotational,
                            &bounce.gravity,
                        ] { td.number { (number(part.value)) } }
                    }
                }
            }
        }
    }
}
