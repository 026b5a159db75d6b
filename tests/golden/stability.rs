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
    let command = "kane stability --full-line".to_owned();
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

/// A formula of three inputs is searched at points, which are in the table alone.
#[test]
fn where_no_formula_that_fails_can_be_drawn_there_is_no_picture() {
    let drawings = |text: &str| {
        let document = kane::audit::read("d.md", text.as_bytes()).expect("it is well formed");
        let stability = examine(&document, false, &mut |_, _| {});
        let command = "kane stability d.md".to_owned();
        let report = StabilityReport { stability: &stability, accounts: &[], command };
        let sheet = sheet(&report);
        assert!(sheet.headline().contains("1 fails somewhere"), "{}", sheet.headline());
        sheet.drawings().len()
    };
    let several = "# D\n\n```kane\nvar a > 0, b > 0, c > 0\nlet f := (a + b)*c - a*c\n```\n";
    assert_eq!(drawings(several), 0);
    assert_eq!(drawings(&several.replace("*c", "*a")), 1, "of two inputs there is one");
}
