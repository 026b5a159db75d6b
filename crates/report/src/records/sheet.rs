//! What was found in a log, as a sheet: the sentence, the checks, the laws, the coefficients, the worst rows.

use kane_records::study::Study;

use super::RecordsReport;
use super::pictures;
use super::sentence::headline;
use super::wording::{
    alias, asks, asks_briefly, at_line, brief, friction_name, interval, law, log_facts, name, pair,
    rejected, replayed, residual, suspicion, untold, untold_label, verdict,
};
use crate::sheet::{Column, Entry, Row, Sheet, Table, Tone, Words, row};
use crate::wording::number_of;

/// Laws that are listed though they do not give every row.
const OTHERS: usize = 5;
/// Pairs of materials that are listed.
const PAIRS: usize = 20;

/// The study as a sheet.
#[must_use]
pub fn sheet<'a>(report: &RecordsReport<'a>) -> Sheet<'a> {
    let study = report.study;
    let news = headline(study);
    let mut sheet =
        Sheet::new("Impacts", report.log, news.strip_suffix('.').unwrap_or(&news), report.command);
    let mut facts = vec![Entry::new("log", log_facts(report))];
    facts.extend(rejected(study).into_iter().map(|line| said("rejected", line, Tone::Bad)));
    let suspected = |found| said("suspected", suspicion(found), Tone::Doubtful);
    facts.extend(study.suspicions.iter().map(suspected));
    facts.push(Entry::new("not read", study.header.unread.join(", ")));
    facts.push(Entry::new("SI assumed", study.header.unitless.join(", ")));
    sheet.labelled(facts);
    // tables of nothing would read as if something had been asked
    if study.rows == 0 {
        return sheet;
    }
    sheet.heading("checks", "Checks, with the worst residual and what is allowed");
    sheet.table(checks(report));
    if !study.friction.is_empty() {
        sheet.heading("friction", "Friction, given the measured normal impulse: misses of k");
        sheet.table(friction(report));
    }
    laws(&mut sheet, report);
    if !study.fits.is_empty() {
        sheet.heading("coefficients", "Coefficients, as measured");
        sheet.table(coefficients(report));
        if let Some(more @ 1..) = study.fits.len().checked_sub(PAIRS) {
            sheet.prose(format!("{more} pairs more are in the JSON."));
        }
    }
    if !study.untold.is_empty() {
        let which = "What these rows cannot tell (kane check --generate prints impacts that would)";
        sheet.heading("untold", which);
        sheet.labelled(
            study.untold.iter().map(|open| Entry::new(untold_label(open), untold(open))).collect(),
        );
    }
    drawn(&mut sheet, report);
    if !study.worst.is_empty() {
        sheet.heading("worst", "The worst rows");
        let line = |worst: &kane_records::worst::Worst| {
            let left = residual(worst.check, &worst.finding);
            let what = format!("{}: {} - left {left}", name(worst), asks(worst.check));
            [Entry::new("row", what), Entry::new("", Words::code(replayed(worst, report)))]
        };
        sheet.labelled(study.worst.iter().flat_map(line).collect());
    }
    sheet
}

/// The pictures of which there is something to see.
fn drawn<'a>(sheet: &mut Sheet<'a>, report: &RecordsReport<'a>) {
    type Draw = fn(&Study) -> Option<String>;
    let study = report.study;
    let all: [(&'static str, &'static str, Draw); 3] = [
        ("k-over-alpha", "k over alpha, on the curves of laws", pictures::ratio),
        ("e-over-phase", "Restitution over the phase within the step", pictures::phase),
        ("energy", "Where energy is created", pictures::energy),
    ];
    for (name, heading, draw) in all {
        if draw(study).is_some() {
            sheet.figure(name, heading, move || draw(study).unwrap_or_default());
        }
    }
}

fn said(label: &'static str, words: String, tone: Tone) -> Entry {
    Entry::new(label, Words::from(words).toned(tone))
}

fn checks(report: &RecordsReport<'_>) -> Table {
    let columns = vec![
        Column::left("check"),
        Column::left("verdict"),
        Column::right("rows"),
        Column::right("near"),
        Column::long("worst", 20),
    ];
    let asked = report.study.checks.iter().filter(|checked| checked.rows > 0);
    let row = |checked: &kane_records::tally::Checked| {
        let worst = checked.worst.map_or_else(String::new, |(line, finding)| {
            residual(checked.check, &finding) + &at_line(line)
        });
        let verdict = verdict(checked);
        let tone = if checked.as_expected() { Tone::Plain } else { Tone::Bad };
        row![
            asks_briefly(checked.check),
            verdict,
            checked.rows.to_string(),
            checked.near.to_string(),
            worst
        ]
        .toned(tone)
    };
    Table::new(columns, asked.map(row).collect())
}

fn friction(report: &RecordsReport<'_>) -> Table {
    let columns = vec![
        Column::left("law"),
        Column::right("within tolerance"),
        Column::right("or within 0.01"),
        Column::right("median"),
        Column::right("worst"),
    ];
    let row = |fit: &kane_records::friction::FrictionFit| {
        row![
            friction_name(fit.law),
            format!("{} of {}", fit.consistent, fit.rows),
            fit.close.to_string(),
            brief(fit.median),
            brief(fit.worst) + &at_line(fit.worst_line)
        ]
    };
    Table::new(columns, report.study.friction.iter().map(row).collect())
}

/// The laws that give every row, and the nearest of the others.
fn laws(sheet: &mut Sheet<'_>, report: &RecordsReport<'_>) {
    let study = report.study;
    let giving = study.consistent_laws().count();
    let shown: Vec<_> = study.laws.iter().take(giving.max(OTHERS)).collect();
    if shown.is_empty() {
        return;
    }
    sheet.heading("laws", "Rigid laws, with mu and e as stated: misses of the velocity afterwards, by the speed before");
    let columns = vec![
        Column::left("law"),
        Column::right("gives"),
        Column::right("median"),
        Column::right("worst"),
    ];
    let row = |fit: &&kane_records::rigid::LawFit| -> Row {
        row![
            law(fit),
            format!("{} of {}", fit.consistent, fit.rows),
            brief(fit.median),
            brief(fit.worst) + &at_line(fit.worst_line)
        ]
    };
    sheet.table(Table::new(columns, shown.iter().map(row).collect()));
    let known = shown.iter().filter(|fit| fit.gives_all() && !alias(fit).is_empty());
    let line = |fit: &&kane_records::rigid::LawFit| {
        Entry::new("", Words::code(fit.law.info.id) + format!(": {}.", alias(fit)))
    };
    sheet.labelled(known.map(line).collect());
}

fn coefficients(report: &RecordsReport<'_>) -> Table {
    let study = report.study;
    let heads = ["stated", "e", "mu", "beta0"];
    let row = |fit: &kane_records::fit::PairFit| {
        let cell = |fitted: &Option<kane_records::fit::Fitted>| {
            fitted.as_ref().map_or_else(String::new, |fitted| {
                format!("{} ({})", interval(fitted), number_of(fitted.rows, "row"))
            })
        };
        row![pair(fit, study), cell(&fit.restitution), cell(&fit.friction), cell(&fit.rebound)]
    };
    let rows = study.fits.iter().take(PAIRS).map(row).collect();
    Table::new(heads.map(Column::left).to_vec(), rows).without_empty_columns()
}
