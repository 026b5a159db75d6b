//! The index of a site: what everything comes to, four pictures, and a line for each page.

use serde::Serialize;

use super::findings::findings;
use super::{Listed, Site};
use crate::chart::speed_accuracy;
use crate::envelope::{Schema, enveloped};
use crate::figures::svg;
use crate::matrix::picture;
use crate::sheet::{Column, Entry, Sheet, Table, Words, row};
use crate::stability::strips_picture;

/// The figure with measured points.
const MEASURED: &str = "slip-over-alpha";

/// The index as a sheet.
#[must_use]
pub fn index<'a>(site: &'a Site<'_>) -> Sheet<'a> {
    let title = "Collision laws: what is proved, what is refuted, what it costs";
    let mut sheet = Sheet::new("Site", title, "", &site.command);
    sheet.machine = Some(site.chart.machine.clone()).filter(|machine| !machine.is_empty());
    let told = findings(site).into_iter().map(|(label, words)| Entry::new(label, words));
    sheet.heading("findings", "Findings");
    sheet.labelled(told.collect());
    sheet.figure("speed-accuracy", "Speed against accuracy", || speed_accuracy(&site.chart));
    sheet.prose(Words::link("Every law and quantity, with its times", "chart.html"));
    sheet.figure("strips", "Where formulas fail", || strips_picture(&site.stability));
    sheet.prose(Words::link("Every range, its cause and a better formula", "stability.html"));
    sheet.figure("matrix", "What each law breaks", || picture(&site.matrix));
    sheet.prose(Words::link("Every cell with its proof or its counterexample", "laws.html"));
    if let Some(figure) = site.figures.iter().find(|figure| figure.stem == MEASURED) {
        sheet.figure(MEASURED, "Laws and measurements", || svg(figure));
        sheet.prose(Words::link("Friction, energy and the elastic half-space", "figures.html"));
    }
    sheet.heading("pages", "Pages");
    let all = site.listed();
    for group in all.chunk_by(|a, b| a.group == b.group) {
        let Some(first) = group.first() else { continue };
        sheet.heading(first.group.to_lowercase(), first.group);
        let columns = vec![Column::left("page"), Column::long("what it comes to", 40)];
        let line = |page: &Listed| {
            row![Words::link(page.title.as_str(), page.to.as_str()), page.line.as_str()]
        };
        sheet.table(Table::new(columns, group.iter().map(line).collect()));
    }
    sheet
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Told {
    about: &'static str,
    says: String,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Contents {
    findings: Vec<Told>,
    pages: Vec<Listed>,
}

/// What the report is, as a JSON Schema.
#[cfg(feature = "schema")]
pub(crate) fn schema() -> serde_json::Value {
    crate::envelope::schema_enveloped::<Contents>("kane site")
}

/// The findings and the pages for programs.
pub(super) fn json(site: &Site<'_>) -> String {
    let told = findings(site).into_iter();
    let contents = Contents {
        findings: told.map(|(about, words)| Told { about, says: words.plain() }).collect(),
        pages: site.listed(),
    };
    enveloped(Schema { name: "kane-site", version: 1 }, &site.command, contents)
}
