//! What is said of findings that are made up.
#![allow(clippy::float_arithmetic, reason = "numbers are made up")]

use kane_measure::{Input, Sample, Subject, formulas};
use serde_json::{Value, json};

use super::picture::{along, bar, ink};
use super::*;
use crate::picture::Ink;
use crate::sheet::Page;

/// A formula with these words; its operations are not looked at.
fn formula(label: &str, text: &str, inputs: &[&str]) -> Formula {
    let document = "```kane\nvar x > 0\nlet w := x + 1\n```\n";
    let document = kane_audit::read("made-up.md", document.as_bytes()).expect("it is well formed");
    let any = formulas(&document).formulas.remove(0);
    let input = |name: &&str| Input { name: (*name).to_owned(), lower: None, upper: None };
    Formula {
        label: label.to_owned(),
        also: Vec::new(),
        quantity: "d".to_owned(),
        text: text.to_owned(),
        by: Vec::new(),
        inputs: inputs.iter().map(input).collect(),
        conditions: Vec::new(),
        ..any
    }
}

fn point(value: f64) -> Point {
    Point { place: 0, value, text: format!("{value:e}") }
}

fn range(fault: Fault, from: f64, to: f64, lost: i64) -> Range {
    Range {
        fault,
        from: point(from),
        to: point(to),
        open: (false, true),
        worst: point(from),
        lost,
        computed: "3e0".to_owned(),
        exact: "4e0".to_owned(),
        cause: "x + 1 cancels".to_owned(),
        better: None,
    }
}

fn line(formula: usize, format: &'static str, worst: f64, lost: i64) -> Examined {
    Examined {
        formula,
        format,
        precision: if format == "f32" { 24 } else { 53 },
        negative: false,
        domain: (point(0.25), point(4096.0)),
        ranges: Vec::new(),
        worst: (point(worst), lost),
        profile: vec![(-2, 123, None), (5, 4567, Some(Fault::Nan))],
        tried: 77,
    }
}

fn cell(x: i64, y: i64, fault: Option<Fault>) -> kane_measure::Cell {
    kane_measure::Cell { binades: (x, y), sample: Sample { lost: 0, fault } }
}

fn plane(formula: usize, faults: Vec<(Fault, usize, (Point, Point))>) -> Plane {
    Plane {
        formula,
        format: "f64",
        precision: 53,
        cells: vec![cell(0, 0, None), cell(0, 4, None), cell(8, 4, Some(Fault::Lost))],
        faults,
        worst: ((point(2.0), point(8.0)), 1290),
    }
}

fn searched(formula: usize, faults: Vec<(Fault, usize, Vec<Point>)>) -> Searched {
    Searched {
        formula,
        format: "f32",
        precision: 24,
        tried: 900,
        faults,
        worst: (vec![point(1.0), point(2.0), point(4.0)], 999),
    }
}

/// Of five formulas four are examined, of which three are the document's own: the first fails on ranges, the second in
/// cells, the third at points, and the fourth nowhere.
fn made_up() -> Stability {
    let mut first = formula("(1)", "x + 1", &["x"]);
    first.also = vec!["(7)".to_owned()];
    first.by = vec!["(2)".to_owned(), "(3)".to_owned()];
    let formulas = vec![
        first,
        formula("d", "x - y", &["x", "y"]),
        formula("(4)", "x - y - z", &["x", "y", "z"]),
        formula("(5)", "1 + x", &["x"]),
        formula("(6)", "1*x", &["x"]),
    ];
    let mut narrow = line(0, "f32", 0.5, 1234);
    let mut lost = range(Fault::Lost, 0.5, 1024.0, 1234);
    lost.better = Some(Better { formula: 4, lost: 56 });
    let mut sign = range(Fault::WrongSign, 2048.0, 4096.0, 2400);
    sign.better = Some(Better { formula: 3, lost: 78 });
    narrow.ranges = vec![lost, sign];
    let mut wide = line(0, "f64", 8.0, 5300);
    wide.ranges = vec![range(Fault::Infinite, 1e300, 1e300, 5300)];
    let of_plane = (Fault::Lost, 1, (point(256.0), point(16.0)));
    let of_search = (Fault::Nan, 12, vec![point(1.0), point(-2.0), point(0.1)]);
    Stability {
        name: "made-up.md".to_owned(),
        title: Some("Made up".to_owned()),
        subject: Subject {
            formulas,
            examined: 4,
            own: 3,
            left_out: vec![("(9)".to_owned(), "a derivative".to_owned())],
            equal: vec![vec![3, 4], vec![], vec![], vec![0, 4]],
        },
        lines: vec![narrow, wide, line(3, "f32", 2.0, 40), line(3, "f64", 4.0, 199)],
        planes: vec![plane(1, vec![of_plane])],
        searches: vec![searched(2, vec![of_search])],
    }
}

fn report(stability: &Stability) -> StabilityReport<'_> {
    StabilityReport { stability, accounts: &[], command: "kane stability".to_owned() }
}

#[test]
fn formulas_that_fail_are_counted_however_they_were_examined() {
    let mut all = made_up();
    let expected = "4 formulas in f32 and f64: 3 fail somewhere; 1 left out";
    assert_eq!(report(&all).headline(), expected);
    all.planes[0].faults.clear();
    all.searches[0].faults.clear();
    all.subject.left_out.clear();
    assert_eq!(report(&all).headline(), "4 formulas in f32 and f64: 1 fails somewhere");
    for line in &mut all.lines {
        line.ranges.clear();
    }
    assert_eq!(report(&all).headline(), "4 formulas in f32 and f64: 0 fail somewhere");
    all.subject.examined = 1;
    assert_eq!(report(&all).headline(), "1 formula in f32 and f64: 0 fail somewhere");
    all.subject.examined = 0;
    assert_eq!(
        report(&all).headline(),
        "no formula was examined",
        "of none it is not said that it holds"
    );
}

#[test]
fn what_was_found_stands_with_its_own_formula() {
    let all = made_up();
    let report = report(&all);
    let entries = report.entries();
    let counts: Vec<(bool, usize, usize, usize)> = entries
        .iter()
        .map(|e| (e.is_own, e.lines.len(), e.planes.len(), e.searches.len()))
        .collect();
    assert_eq!(counts, [(true, 2, 0, 0), (true, 0, 1, 0), (true, 0, 0, 1), (false, 2, 0, 0)]);
    let notes: Vec<String> = entries.iter().map(Entry::notes).collect();
    assert_eq!(notes, ["with (2), (3); also (7)", "", "", "an equal form"]);
    let titles: Vec<String> = entries.iter().map(|entry| title(entry.formula)).collect();
    assert_eq!(titles, ["(1)  d = x + 1", "d = x - y", "(4)  d = x - y - z", "(5)  d = 1 + x"]);
    assert_eq!(named(entries[0].formula), "x + 1  (1) with (2), (3)");
    assert_eq!(named(entries[2].formula), "x - y - z  (4)");
}

#[test]
fn the_most_bits_are_told_in_each_format_and_where_there_is_one_input() {
    let mut all = made_up();
    let mut below = line(0, "f32", -2.0, 1300);
    below.negative = true;
    all.lines.push(below);
    let mut less = line(0, "f64", -4.0, 5299);
    less.negative = true;
    all.lines.push(less);
    let report = report(&all);
    let entries = report.entries();
    let (most, wide) = (point(-2.0), point(8.0));
    assert_eq!(entries[0].losses(), [("f32", 1300, Some(&most)), ("f64", 5300, Some(&wide))]);
    assert_eq!(entries[1].losses(), [("f64", 1290, None)]);
    assert_eq!(entries[2].losses(), [("f32", 999, None)]);
}

/// The text of the sheet, one space between words.
fn text(stability: &Stability) -> Vec<String> {
    let text = sheet(&report(stability)).text(Page::default());
    text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

#[test]
fn a_range_is_told_with_its_fault_its_ends_and_what_is_better() {
    let lines = text(&made_up());
    let told = |expected: &str| assert!(lines.iter().any(|line| line == expected), "{lines:#?}");
    told("(1) d = x + 1 (with (2), (3); also (7))");
    told("f32 digits lost [2^-1, 2^10] 12.3 of 24 2^-1 [a] x + 1 cancels");
    told("f32 wrong sign [2^11, 2^12] 24.0 of 24 2^11 [b] x + 1 cancels");
    told("f64 infinite at 1.000e300 53.0 of 53 1.000e300 none x + 1 cancels");
    told("better [a] 1*x (6)");
    told("better [b] 1 + x (5)");
    told("d = x - y");
    told("f64 digits lost 1 of 3 x = 2^8, y = 2^4");
    told("f32 NaN 12 of 900 x = 2^0, y = -2^1, z = 1.000e-1");
    told("0.4 at 2^1 1.9 at 2^2 (5) d = 1 + x (an equal form)");
    told("(9): a derivative");
    assert_eq!(lines[0], "Made up (made-up.md)");
    // what does not fail has no heading of its own, and what fails is not among those that do not
    assert_eq!(lines.iter().filter(|line| line.contains("(5) d = 1 + x")).count(), 1);
    assert_eq!(lines.iter().filter(|line| line.contains("(1) d = x + 1")).count(), 1);
}

#[test]
fn one_better_formula_has_no_letter() {
    let mut all = made_up();
    all.lines[0].ranges[1].better = Some(Better { formula: 4, lost: 78 });
    all.lines[1].ranges.clear();
    let lines = text(&all);
    let told = |expected: &str| assert!(lines.iter().any(|line| line == expected), "{lines:#?}");
    told("f32 digits lost [2^-1, 2^10] 12.3 of 24 2^-1 x + 1 cancels");
    told("better 1*x (6)");
    for range in &mut all.lines[0].ranges {
        range.better = None;
    }
    let lines = text(&all);
    assert!(!lines.iter().any(|line| line.contains("none") || line.starts_with("better")));
}

#[test]
fn a_sheet_says_nothing_of_what_there_is_not() {
    let mut all = made_up();
    all.title = None;
    all.subject.left_out.clear();
    let heads = |all: &Stability| {
        let lines = text(all);
        let heads = ["No failure, and the most bits lost", "Left out"];
        (lines[0].clone(), heads.map(|head| lines.iter().any(|line| line == head)))
    };
    assert_eq!(heads(&all), ("made-up.md".to_owned(), [true, false]));
    all.subject.examined = 3;
    assert_eq!(heads(&all).1, [false, false]);
}

#[test]
fn a_picture_is_shown_where_something_of_one_or_two_inputs_fails() {
    let names = |all: &Stability| {
        let report = report(all);
        let names: Vec<&'static str> =
            sheet(&report).drawings().into_iter().map(|(name, _)| name).collect();
        names
    };
    let mut all = made_up();
    assert_eq!(names(&all), ["strips", "stability"]);
    for line in &mut all.lines {
        line.ranges.clear();
    }
    assert_eq!(names(&all), ["stability"]);
    all.planes.clear();
    assert!(names(&all).is_empty());
}

#[test]
fn each_range_is_a_row_with_exact_ends() {
    assert_eq!(
        csv(&report(&made_up())),
        "label,quantity,formula,with,format,fault,from,to,bits_lost,worst,returns,exact,cause,better\n\
         (1),d,x + 1,(2) (3),f32,digits-lost,5e-1,1.024e3,12.3,5e-1,3e0,4e0,x + 1 cancels,1*x\n\
         (1),d,x + 1,(2) (3),f32,wrong-sign,2.048e3,4.096e3,24.0,2.048e3,3e0,4e0,x + 1 cancels,1 + x\n\
         (1),d,x + 1,(2) (3),f64,infinite,1e300,1e300,53.0,1e300,3e0,4e0,x + 1 cancels,\n"
    );
}

#[test]
fn findings_are_numbers_for_programs() {
    let all = made_up();
    let told: Value = serde_json::from_str(&super::json(&report(&all))).expect("JSON");
    assert_eq!([&told["document"], &told["title"]], ["made-up.md", "Made up"]);
    assert_eq!(told["left_out"], json!([{ "label": "(9)", "why": "a derivative" }]));
    let formulas = told["formulas"].as_array().expect("a list");
    let heads: Vec<Value> = formulas
        .iter()
        .map(|f| json!([f["label"], f["text"], f["inputs"], f["of_the_document"], f["equal"]]))
        .collect();
    assert_eq!(
        heads,
        [
            json!(["(1)", "x + 1", ["x"], true, ["1 + x", "1*x"]]),
            json!(["d", "x - y", ["x", "y"], true, []]),
            json!(["(4)", "x - y - z", ["x", "y", "z"], true, []]),
            json!(["(5)", "1 + x", ["x"], false, ["x + 1", "1*x"]]),
        ]
    );
    assert_eq!(
        [&formulas[0]["also"], &formulas[0]["with"]],
        [&json!(["(7)"]), &json!(["(2)", "(3)"])]
    );
    assert_eq!(
        formulas[0]["lines"][0],
        json!({
            "format": "f32", "precision": 24, "from": "2.5e-1", "to": "4.096e3", "tried": 77,
            "worst": "5e-1", "bits_lost": "12.3",
            "ranges": [{
                "fault": "digits-lost", "from": "5e-1", "to": "1.024e3", "from_is_end_of_domain": false,
                "to_is_end_of_domain": true, "worst": "5e-1", "bits_lost": "12.3",
                "returns": "3e0", "exact": "4e0", "cause": "x + 1 cancels",
                "better": { "label": "(6)", "text": "1*x", "with": [], "bits_lost": "0.5" },
            }, {
                "fault": "wrong-sign", "from": "2.048e3", "to": "4.096e3",
                "from_is_end_of_domain": false, "to_is_end_of_domain": true, "worst": "2.048e3",
                "bits_lost": "24.0", "returns": "3e0", "exact": "4e0", "cause": "x + 1 cancels",
                "better": { "label": "(5)", "text": "1 + x", "with": [], "bits_lost": "0.7" },
            }],
            "profile": [[-2, "1.2", null], [5, "45.6", "nan"]],
        })
    );
    assert_eq!(
        formulas[1]["planes"],
        json!([{
            "format": "f64", "precision": 53, "cells": 3, "worst": ["2e0", "8e0"],
            "bits_lost": "12.9",
            "faults": [{ "fault": "digits-lost", "cells": 1, "example": ["2.56e2", "1.6e1"] }],
        }])
    );
    assert_eq!(
        formulas[2]["searches"],
        json!([{
            "format": "f32", "precision": 24, "points": 900, "worst": ["1e0", "2e0", "4e0"],
            "bits_lost": "9.9",
            "faults": [{ "fault": "nan", "points": 12, "example": ["1e0", "-2e0", "1e-1"] }],
        }])
    );
}

#[test]
fn a_formula_fails_near_one_if_a_range_meets_a_thousandth_to_a_thousand() {
    let near = |from: f64, to: f64| {
        let mut all = made_up();
        all.lines[0].ranges = vec![range(Fault::Lost, from, to, 100)];
        all.lines[1].ranges.clear();
        let strips = Strips::of(&report(&all));
        assert_eq!((strips.formulas, strips.near.len() + strips.far.len()), (2, 1));
        strips.near.len() == 1
    };
    for (from, to) in
        [(1e-9, 1e-3), (1e3, 1e9), (1.0, 2.0), (-1e9, -1e3), (-1e-3, 0.0), (1e-9, 1e9)]
    {
        assert!(near(from, to), "{from} to {to}");
    }
    for (from, to) in [(0.0, 0.9e-3), (1.1e3, 1e9), (-1e9, -1.1e3), (-0.9e-3, -1e-9)] {
        assert!(!near(from, to), "{from} to {to}");
    }
}

#[test]
fn formulas_of_one_input_are_counted_by_where_they_fail() {
    let mut all = made_up();
    let reading = |all: &Stability| Strips::of(&report(all)).reading();
    let told = |near, fail| {
        format!(
            "{fail} of 2 formulas of one input, evaluated as written, fail somewhere in f32 or f64; {near} of them \
             between 1/1000 and 1000"
        )
    };
    assert_eq!(reading(&all), told(1, 1));
    all.lines[3].ranges = vec![range(Fault::Lost, 1e100, 1e101, 100)];
    assert_eq!(reading(&all), told(1, 2));
    all.lines[0].ranges.clear();
    assert_eq!(reading(&all), told(0, 2));
}

#[test]
fn a_strip_says_of_which_inputs_it_is() {
    let named = |sides: &[bool]| {
        let mut all = made_up();
        for line in &mut all.lines {
            line.ranges.clear();
        }
        for negative in sides {
            let mut line = line(0, "f64", 1.0, 100);
            line.negative = *negative;
            line.ranges = vec![range(Fault::Lost, 1.0, 2.0, 100)];
            all.lines.push(line);
        }
        // those without a failure are found first
        all.lines.reverse();
        let strips = Strips::of(&report(&all));
        (strips.near[0].name.clone(), strips.near[0].bars.len())
    };
    assert_eq!(named(&[false]), ("(1)  x + 1".to_owned(), 2));
    assert_eq!(named(&[true]), ("(1)  x + 1, < 0".to_owned(), 1));
    assert_eq!(named(&[false, true]), ("(1)  x + 1, ≷ 0".to_owned(), 3));
}

#[test]
fn a_bar_is_as_long_as_its_range_and_has_the_colour_of_its_fault() {
    let mut all = line(0, "f64", 1.0, 100);
    all.domain = (point(-1e3), point(-1e-3));
    all.ranges = vec![range(Fault::WrongSign, -1e3, -1.0, 100), range(Fault::Nan, 0.0, 1.0, 100)];
    let drawn = bar(&all);
    assert_eq!(drawn.domain, (along(-3.0), along(3.0)));
    let one = 0.5;
    assert_eq!(drawn.parts[0], ((one, along(3.0)), Ink::VERMILION));
    assert_eq!(drawn.parts[1], ((0.0, one), ink(Some(Fault::Nan))));
}

#[test]
fn the_axis_is_squeezed_alike_on_both_sides_of_one() {
    assert_eq!([along(0.0), along(324.0), along(-324.0)], [0.5, 1.0, 0.0]);
    let beyond = |power: f64| along(power) - 0.5;
    assert_eq!(beyond(-7.0), -beyond(7.0));
    // logarithms of what is one more, and 5·5·13 is 325
    let sum = 2.0 * beyond(4.0) + beyond(12.0);
    assert!((sum - 0.5).abs() < 1e-15, "{sum}");
}

#[test]
fn a_plane_has_a_box_where_it_fails() {
    let mut all = made_up();
    all.lines.clear();
    all.planes[0].cells = vec![
        cell(0, 0, None),
        cell(0, 4, None),
        cell(8, 0, Some(Fault::Lost)),
        cell(8, 4, Some(Fault::Nan)),
        cell(16, 0, Some(Fault::Lost)),
        cell(16, 4, None),
    ];
    let svg = picture(&StabilityReport { command: String::new(), ..report(&all) });
    let seen = crate::picture::seen::Seen::of(&svg);
    let scales = seen.scales([false, false]);
    // boxes by their inks, as those of the legend have them
    let boxes = |ink: &str| -> Vec<[(String, String); 2]> {
        seen.lines()
            .iter()
            .filter(|line| line.points.len() == 4 && line.class == ink)
            .map(|line| [scales.told(line.points[0]), scales.told(line.points[2])])
            .filter(|[from, _]| from.1.parse::<f64>().is_ok_and(|y| (0.0..=8.0).contains(&y)))
            .collect()
    };
    let at = |x: &str, y: &str| (x.to_owned(), y.to_owned());
    // a cell reaches to the next: 8 of one input, 4 of the other; neighbours of one fault are one box
    assert_eq!(boxes("c4"), [[at("8", "4"), at("24", "0")]]);
    assert_eq!(boxes(""), [[at("8", "8"), at("16", "4")]]);
    assert_eq!(seen.place("log2 x").map(|(x, _)| x > 0.0), Some(true));
}

#[test]
fn strips_of_a_formula_are_named_by_what_it_is_and_the_sign_of_its_input() {
    let mut all = made_up();
    let mut below = line(0, "f64", -2.0, 1300);
    below.negative = true;
    below.ranges = vec![range(Fault::Lost, -4.0, -2.0, 100)];
    all.lines.push(below);
    let svg = picture(&report(&all));
    let seen = crate::picture::seen::Seen::of(&svg);
    let name = "(1)  d = x + 1 with (2), (3)";
    assert!(seen.place(name).is_some(), "{svg}");
    assert!(seen.place(&format!("{name}, x &lt; 0")).is_some(), "{svg}");
    // what does not fail has no strip
    assert!(!svg.contains("1 + x"), "{svg}");
}
