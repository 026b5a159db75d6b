//! JSON Schemas of the reports, made from the types that are written.

use serde_json::Value;

use crate::{
    certificate, chart, collision, floats, growth, json, matrix, prices, records, scene, site,
    stability,
};

/// The schemas by the name of their report, JSON Schema 2020-12: of `kane-NAME`, and of certificates. A reader should let pass what a schema does not name,
/// since a report may tell more without a new version.
#[must_use]
pub fn schemas() -> Vec<(&'static str, Value)> {
    vec![
        ("audit", json::schema()),
        ("certificate", certificate::schema()),
        ("laws", matrix::schema()),
        ("collide", collision::schema()),
        ("scene", scene::schema()),
        ("stability", stability::schema()),
        ("floats", floats::schema()),
        ("chart", chart::schema()),
        ("prices", prices::schema()),
        ("growth", growth::schema()),
        ("check", records::report_schema()),
        ("check-baseline", records::baseline_schema()),
        ("site", site::schema()),
    ]
}
