//! The report of a small audit, in every format.

use kane::report::{Page, Report, explain, json, markdown, text};

use crate::fixture::audit;
use crate::settings;

/// Compares with `snapshots/reports/NAME.snap`.
fn assert_report(name: &str, shown: &str) {
    settings().bind(|| insta::assert_snapshot!(name, shown));
}

#[test]
fn text_in_a_file_lets_reasons_run_on() {
    let audit = audit();
    assert_report("text_file", &text(&Report::new(&audit, "kane audit wall.md"), Page::default()));
}

#[test]
fn text_on_a_terminal_fits_it_and_shows_surprises_in_red() {
    let audit = audit();
    let page = Page { width: Some(90), colour: true };
    let shown = text(&Report::new(&audit, "kane audit wall.md"), page);
    assert_report("text_terminal", &shown.replace('\u{1b}', "ESC"));
}

#[test]
fn a_narrow_page_is_never_overrun() {
    let audit = audit();
    let report = Report::new(&audit, "kane audit wall.md");
    for width in [0, 10, 20, 40, 60, 80, 120] {
        let shown = text(&report, Page { width: Some(width), colour: false });
        let table = shown.split("\n\n").nth(1).expect("a table follows the news");
        for line in table.lines() {
            // the verdict and the label are always shown in full
            assert!(line.chars().count() <= width.max(22), "{width} columns, but: {line}");
        }
    }
}

#[test]
fn one_statement_alone() {
    let audit = audit();
    let report = Report::new(&audit, "kane audit --only 16 wall.md").only(&[4]);
    assert_report("text_only", &text(&report, Page::default()));
}

#[test]
fn markdown_of_every_verdict() {
    let audit = audit();
    assert_report("markdown", &markdown(&Report::new(&audit, "kane audit wall.md")));
}

#[test]
fn json_of_every_verdict() {
    let audit = audit();
    assert_report("json", &json(&[Report::new(&audit, "kane audit wall.md")]));
}

#[test]
fn an_explanation_can_be_followed_on_paper() {
    let audit = audit();
    let all = (0..audit.document.statements.len()).filter_map(|index| explain(&audit, index));
    assert_report("explain", &all.collect::<Vec<_>>().join("\n----\n"));
}
