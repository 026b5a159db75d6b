//! How cost grows with size, as far as no clock is read.

use kane::measure::chart::Effort;
use kane::measure::growth::{Growth, counted};
use kane::report::Page;
use kane::report::growth::{GrowthReport, Question, csv, json, picture, sheet};

use crate::schemas::assert_valid;
use crate::settings;

fn report(growth: &Growth) -> GrowthReport<'_> {
    let command = "kane chart --growth --quick".to_owned();
    GrowthReport { growth, machine: "no machine".to_owned(), command }
}

#[test]
fn the_curves_without_a_clock() {
    let growth = counted(Effort::Quick);
    let report = report(&growth);
    let table = csv(&report);
    let shown = sheet(&report).text(Page::default());
    settings().bind(|| {
        insta::assert_snapshot!("counted", table);
        insta::assert_snapshot!("text", shown);
    });
    for line in shown.lines() {
        assert!(line.chars().count() <= 100, "more than 100 columns: {line}");
    }

    // the other forms tell the same
    assert_valid("growth", &json(&report));
    let value: serde_json::Value = serde_json::from_str(&json(&report)).expect("it is JSON");
    let points = value["points"].as_array().expect("a list");
    assert_eq!(points.len() + 1, table.lines().count());
    assert_eq!(value["readings"].as_array().map(Vec::len), Some(8));
    assert!(!table.contains(",ns,") && !json(&report).contains("\"ns\""), "no time is in it");
    assert!(sheet(&report).markdown().contains("## Bounces in a chain: wang-su-li"));
    let drawn = |question| picture(&report, question);
    let chain = drawn(Question::Chain).expect("there are chains");
    assert!(chain.starts_with("<svg") && chain.contains("wang-su-li: digits of the slip"));
    assert!(drawn(Question::Audit).is_some_and(|svg| svg.contains("steps of search")));
    assert_eq!(drawn(Question::Batch), None, "no clock was read");
    assert_eq!(csv(&self::report(&counted(Effort::Quick))), table, "the same in every run");
}

/// What the curves are for: where exactness ends, and what the others keep until then.
#[test]
fn exactness_doubles_under_the_paper_s_law_and_stays_affordable_under_walton_s() {
    let growth = counted(Effort::Quick);
    let [paper, walton, smith] = growth.chains.as_slice() else { panic!("three laws") };
    assert!(paper.doubles() && !walton.doubles());
    assert_eq!(paper.last_exact().map(|(n, _)| n), Some(9));
    assert_eq!(walton.last_exact().map(|(n, _)| n), Some(200));
    assert_eq!(smith.last_exact(), None, "a root leaves the fractions");
}
