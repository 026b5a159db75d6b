//! Where the paper's formulas fail, as the program prints it.

use kane::measure::{Stability, examine};
use kane::report::Page;
use kane::report::stability::{StabilityReport, csv, json, picture, sheet, strips_picture};

use crate::schemas::assert_valid;
use crate::{assert_kept, settings};

fn paper() -> Stability {
    let bytes = include_bytes!("../../docs/derivations/oblique-collision.md");
    let document = kane::audit::read("oblique-collision.md", bytes).expect("it is well formed");
    examine(&document, true, &mut |_, _| {})
}

#[test]
fn the_table_of_the_paper() {
    let stability = paper();
    let command = "kane stability".to_owned();
    let report = StabilityReport { stability: &stability, accounts: &[], command };
    let shown = sheet(&report).text(Page::default());
    for line in shown.lines() {
        assert!(line.chars().count() <= 100, "more than 100 columns: {line}");
    }
    settings().bind(|| insta::assert_snapshot!("paper", shown));

    // the other forms tell the same
    let ranges: usize = stability.lines.iter().map(|line| line.ranges.len()).sum();
    assert_eq!(csv(&report).lines().count(), ranges + 1);
    assert_valid("stability", &json(&report));
    let value: serde_json::Value = serde_json::from_str(&json(&report)).expect("it is JSON");
    let formulas = value["formulas"].as_array().expect("a list").len();
    assert_eq!(formulas, stability.subject.examined);
    assert!(sheet(&report).markdown().contains("| f64 | 0 instead |"));
    let svg = picture(&report);
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    assert!(
        svg.contains("f32 above f64") && svg.contains("log2 alpha") && svg.contains("digits lost")
    );
    assert_eq!(svg, picture(&report), "the same in every run");
    assert_kept("docs/figures/formula-failures.svg", &strips_picture(&report));
}
