//! What all reports come to, in ten sentences that are counted from their data.

use kane_audit::Verdict;
use kane_matrix::{Finding, Row};

use super::{Fit, Site};
use crate::chart::{Reading, readings, timed};
use crate::figures::Content;
use crate::matrix::{breaking, conflicts};
use crate::sheet::Words;
use crate::stability::Strips;
use crate::{Report, Summary};

/// A finding: what it is about, in a word or two, and a sentence.
pub(super) type Told = (&'static str, Words);

/// The findings, those that there is something to say of.
pub(super) fn findings(site: &Site<'_>) -> Vec<Told> {
    let mut all: Vec<Told> = Vec::new();
    if let Some((stem, paper)) = site.audits.first() {
        let page = format!("derivations/{stem}.html");
        all.push(("The paper", Words::link("The paper", page) + claims(paper)));
        all.push(("As printed", printed(paper)));
    }
    all.push(("Derivations", others(site)));
    let matrix = site.matrix.matrix;
    all.push(("Laws", Words::link(breaking(matrix), "laws.html") + "."));
    all.push(("Conflicts", Words::from(conflicts(matrix).join("; ")) + "."));
    all.push(("Energy", energy(site)));
    let readings = readings(&timed(&site.chart));
    all.push(("Speed", speed(&readings)));
    all.push(("Rewriting", rewriting(&readings)));
    all.push((
        "Floats",
        Words::link(Strips::of(&site.stability).reading(), "stability.html") + ".",
    ));
    all.push(("Experiment", experiment(site.fits)));
    all.retain(|(_, words)| !words.plain().trim_end_matches('.').is_empty());
    all
}

/// `: of 179 claims 149 are proved, …; every verdict is as expected.`
fn claims(report: &Report<'_>) -> String {
    let summary = Summary::of(report);
    format!(
        ": of {} claims {}; {}.",
        summary.claims,
        fared(&summary.verdicts),
        summary.expectation()
    )
}

fn fared(verdicts: &[(Verdict, usize)]) -> String {
    let parts: Vec<String> = verdicts.iter().map(|(verdict, n)| format!("{n} {verdict}")).collect();
    listed(&parts)
}

/// `a, b and c`.
fn listed(parts: &[String]) -> String {
    match parts {
        [] => "none".to_owned(),
        [one] => one.clone(),
        [all @ .., last] => format!("{} and {last}", all.join(", ")),
    }
}

fn printed(paper: &Report<'_>) -> Words {
    let summary = Summary::of(paper);
    let wrong = &summary.refuted_as_printed;
    let equations = summary.equations;
    match wrong.len() {
        0 => Words::from(format!("None of its {equations} numbered equations is refuted.")),
        n => {
            let are = if n == 1 { "is" } else { "are" };
            Words::from(format!(
                "Of its {equations} numbered equations {n} {are} refuted as printed: "
            )) + listed(wrong)
                + "."
        }
    }
}

fn others(site: &Site<'_>) -> Words {
    let others = site.audits.get(1..).unwrap_or_default();
    if others.is_empty() {
        return Words::default();
    }
    let summaries: Vec<Summary> = others.iter().map(|(_, report)| Summary::of(report)).collect();
    let mut verdicts: Vec<(Verdict, usize)> = Vec::new();
    for (verdict, n) in summaries.iter().flat_map(|summary| &summary.verdicts) {
        match verdicts.iter_mut().find(|(known, _)| known == verdict) {
            Some((_, sum)) => *sum += n,
            None => verdicts.push((*verdict, *n)),
        }
    }
    let claims: usize = summaries.iter().map(|summary| summary.claims).sum();
    let surprises: usize = summaries.iter().map(|summary| summary.surprises.len()).sum();
    let expected = match surprises {
        0 => "every verdict is as expected".to_owned(),
        n => format!("{n} are NOT as expected"),
    };
    let documents = format!("{} other derivations", others.len());
    Words::link(documents, "index.html#derivations")
        + format!(" have {claims} claims: {}; {expected}.", fared(&verdicts))
}

/// Which laws create energy on some planar contact, in which friction alone does, and in how many Kane's pendulum gains
/// some.
fn energy(site: &Site<'_>) -> Words {
    let matrix = site.matrix.matrix;
    if !matrix.properties.iter().any(|property| property.group == "energy") {
        return Words::default();
    }
    let found = |row: &Row, id: &str| {
        let column = matrix.properties.iter().position(|property| property.id == id)?;
        row.cells.get(column).map(|cell| cell.finding)
    };
    let laws = |is_meant: &dyn Fn(&Row) -> bool| -> Vec<String> {
        let meant = matrix.rows.iter().filter(|row| is_meant(row));
        meant.map(|row| row.law.info.id.to_owned()).collect()
    };
    // a law that says nothing of contacts that couple is asked on a sphere alone, which is a planar contact, too
    let totals = ["energy-sphere", "energy"];
    let creators = laws(&|row| totals.iter().any(|id| found(row, id) == Some(Finding::Refuted)));
    let by_friction = laws(&|row| {
        found(row, "energy-tangential") == Some(Finding::Refuted)
            && totals.iter().all(|id| found(row, id) == Some(Finding::Proved))
    });
    let friction = match by_friction.is_empty() {
        true => String::new(),
        false => format!(
            "; in {} friction does, though the collision as a whole does not",
            listed(&by_friction)
        ),
    };
    let map = site.figures.iter().find_map(|figure| match &figure.content {
        Content::Map(panels) => Some(panels),
        Content::Curves { .. } => None,
    });
    let pendulum = map.map_or(0, |panels| {
        panels.iter().filter(|panel| panel.case[0] == "double pendulum").count()
    });
    let gains = match pendulum {
        0 => Words::from("."),
        n => {
            Words::from(format!("; in Kane's double pendulum {n} laws gain energy at "))
                + Words::link("some friction and restitution", "figures.html#energy-map")
                + "."
        }
    };
    let all = matrix.rows.len();
    Words::from(format!(
        "{} of {all} laws create energy on some planar contact: {}",
        creators.len(),
        listed(&creators)
    )) + friction
        + gains
}

/// What f64, double-double and exact fractions cost.
fn speed(readings: &[Reading]) -> Words {
    let told: Vec<String> =
        readings.iter().filter(|reading| !reading.is_wrong).map(Reading::sentence).collect();
    match told.is_empty() {
        true => Words::default(),
        false => Words::link("The price of a digit", "chart.html") + ": " + told.join("; ") + ".",
    }
}

/// What an equal formula loses.
fn rewriting(readings: &[Reading]) -> Words {
    let wrong = readings.iter().find(|reading| reading.is_wrong);
    wrong.map_or_else(Words::default, |reading| {
        Words::from(format!("The same k by another formula: {}.", reading.sentence()))
    })
}

/// Which law is nearest to what was measured, and how far the paper's is.
fn experiment(fits: &[Fit]) -> Words {
    let Some(best) = fits.first() else { return Words::default() };
    let names = |fit: &Fit| listed(&fit.laws.iter().map(|id| (*id).to_owned()).collect::<Vec<_>>());
    let paper = fits.iter().find(|fit| fit.laws.contains(&"wang-su-li"));
    let paper = match paper {
        Some(paper) if paper != best => format!("; the paper's law is {:.2} off", paper.median),
        _ => String::new(),
    };
    // by another measure another law may be nearest
    let off = format!(
        " {} is nearest by the median distance of k over all points, {:.2}{paper}. docs/verdict.md measures one series \
         of them by the root of the mean square.",
        names(best),
        best.median
    );
    Words::from("Of rigid laws with their default parameters beside ")
        + Words::link("measured spheres", "figures.html#slip-over-alpha")
        + off
}
