//! A collision for the web.

use std::fmt::Write as _;

use kane_scene::collide::{Answer, Collision, Energy, LawAnswer, Reading};

use super::text::{ERRORS, enclosure};
use super::{brief, full, headline, in_words, ulps};
use crate::markdown::{code, escape};

/// The collision as Markdown.
#[must_use]
pub fn markdown(collision: &Collision) -> String {
    let mut out = String::new();
    let _ = writeln!(out, "# Collision: {}\n", escape(&collision.title));
    let _ = writeln!(out, "**{}**\n", escape(&headline(collision)));
    for given in &collision.given {
        let _ = writeln!(out, "- {}", escape(&in_words(given)));
    }
    out.push('\n');
    for note in &collision.notes {
        let _ = writeln!(out, "{}\n", escape(note));
    }
    if !collision.in_depth {
        row(&mut out, &["before", "value", "exact", "meaning"].map(str::to_owned));
        rule(&mut out, 4);
        for reading in &collision.before {
            let float = reading.float.map_or_else(|| "–".to_owned(), brief);
            row(&mut out, &[name(reading), float, exact(reading), escape(reading.meaning)]);
        }
        out.push('\n');
    }
    match collision.laws.first() {
        Some(law) if collision.in_depth => depth(&mut out, law),
        _ => table(&mut out, collision),
    }
    let _ =
        writeln!(out, "---\n\nkane {}, {}", env!("CARGO_PKG_VERSION"), code(&collision.command));
    out
}

fn row(out: &mut String, cells: &[String]) {
    let _ = writeln!(out, "| {} |", cells.join(" | "));
}

fn rule(out: &mut String, columns: usize) {
    let _ = writeln!(out, "|{}", "---|".repeat(columns));
}

fn name(reading: &Reading) -> String {
    let unit = if reading.unit.is_empty() { String::new() } else { format!(" ({})", reading.unit) };
    format!("{}{unit}", code(reading.symbol))
}

fn exact(reading: &Reading) -> String {
    reading.exact.as_deref().map_or_else(|| "–".to_owned(), escape)
}

fn table(out: &mut String, collision: &Collision) {
    let outcomes: Vec<(&LawAnswer, &Answer)> = collision.outcomes().collect();
    if let Some((_, first)) = outcomes.first() {
        let shown: Vec<&Reading> = first.readings.iter().filter(|r| r.column).collect();
        let heads = shown.iter().map(|reading| name(reading));
        let heads: Vec<String> =
            ["law".to_owned(), "regime".to_owned()].into_iter().chain(heads).collect();
        row(out, &heads);
        rule(out, heads.len());
        for (law, answer) in &outcomes {
            let mark = match answer.energy {
                Energy::Created => ", **creates energy**",
                Energy::Lost | Energy::Kept => "",
            };
            let mut cells = vec![code(law.id), format!("{}{mark}", escape(answer.regime))];
            for column in &shown {
                let found = answer.readings.iter().find(|r| r.symbol == column.symbol);
                let float = found.and_then(|reading| reading.float);
                cells.push(float.map_or_else(|| "–".to_owned(), brief));
            }
            row(out, &cells);
        }
        out.push('\n');
    }
    for law in &collision.laws {
        if let Err(reason) = &law.answer {
            let _ = writeln!(out, "- {}: no outcome; {}", code(law.id), escape(reason));
        }
    }
    out.push('\n');
}

fn depth(out: &mut String, law: &LawAnswer) {
    let statement: Vec<String> = law.statement.lines().map(code).collect();
    let _ = writeln!(out, "## {}\n", escape(law.id));
    let _ = writeln!(out, "- says: {}", statement.join("; "));
    let _ = writeln!(out, "- restitution: {}", escape(law.restitution));
    for (name, value) in &law.parameters {
        let _ = writeln!(out, "- with {}", code(&format!("{name} = {value}")));
    }
    let _ = writeln!(out, "- source: {}", escape(law.source));
    let answer = match &law.answer {
        Ok(answer) => answer,
        Err(reason) => {
            let _ = writeln!(out, "\nNo outcome: {}.\n", escape(reason));
            return;
        }
    };
    let _ = writeln!(out, "- regime: {}\n", escape(answer.regime));
    let heads = ["quantity", "exact", "f64", "inputs", "plain", "wide", "enclosure", "meaning"];
    row(out, &heads.map(str::to_owned));
    rule(out, heads.len());
    for reading in answer.readings.iter().filter(|reading| reading.exact.is_some()) {
        let errors = reading.errors.unwrap_or_default();
        let float = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), full);
        let error = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), ulps);
        row(
            out,
            &[
                name(reading),
                exact(reading),
                float(reading.float),
                escape(&error(errors.inputs)),
                escape(&error(errors.plain)),
                escape(&error(errors.wide)),
                escape(&enclosure(reading)),
                escape(reading.meaning),
            ],
        );
    }
    let _ = writeln!(out, "\n{}\n", escape(ERRORS));
    for remark in &answer.remarks {
        let _ = writeln!(out, "Note: {}.\n", escape(remark));
    }
    for check in &answer.checks {
        let verdict = if check.holds { "holds exactly" } else { "**does not hold**" };
        let _ = writeln!(out, "- {verdict}: {}", escape(&check.claim));
    }
    out.push('\n');
}
