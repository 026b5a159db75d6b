//! What is said of prices that are made up.

use kane_floats::fpcore;
use kane_floats::rigor::Bounded;
use kane_measure::chart::Time;
use kane_measure::prices::Form;
use kane_number::System;
use serde_json::{Value, json};

use super::*;
use crate::picture::seen::Seen;
use crate::sheet::Page;

fn made_up() -> Prices {
    let form = |name: &str, text: &str, narrow: Option<f64>, wide: Option<f64>| {
        let bounded =
            |bound| Bounded { bound, least: 0.0, worst: Vec::new(), pole: None, cells: 1 };
        Form {
            name: name.to_owned(),
            core: fpcore::read("made-up", text).expect("it is well formed").remove(0),
            bounds: [narrow.map(bounded), wide.map(bounded)],
        }
    };
    let way = |form, system, worst, median, picoseconds, on_front| Way {
        form,
        system,
        worst,
        median,
        at: vec![0.5, 3.0],
        tried: 400,
        time: Time {
            median: picoseconds,
            quartiles: (picoseconds - 100, picoseconds + 200),
            rounds: 7,
        },
        on_front,
    };
    Prices {
        label: "gap".to_owned(),
        forms: vec![
            form("given", "(FPCore (x y) (- x y))", Some(8.0), None),
            form("repair 1", "(FPCore (x y) (+ x (- y)))", Some(64.0), Some(4.0)),
        ],
        ways: vec![
            way(0, System::F64, 1210, 1590, 2_000, true),
            way(1, System::F64, 1100, 1200, 3_000, false),
            way(0, System::F32, 500, 700, 1_000, true),
            way(1, System::Rational, i64::MAX, i64::MAX, 900_000, true),
        ],
    }
}

fn report(all: &[Prices]) -> PricesReport<'_> {
    PricesReport {
        name: "made-up.fpcore".to_owned(),
        all,
        left_out: vec![("pole".to_owned(), "no float".to_owned())],
        machine: "a machine".to_owned(),
        command: "kane chart made-up.fpcore".to_owned(),
    }
}

#[test]
fn each_way_is_a_row_and_the_fastest_comes_first() {
    let all = [made_up()];
    assert_eq!(
        csv(&report(&all)),
        "formula,form,text,system,digits_worst,digits_median,bits_lost_at_most,worst_at,inputs,ns,ns_first_quartile,\
         ns_third_quartile,pareto\n\
         gap,given,x - y,f32,5.0,7.0,3.1,\"x = 5e-1, y = 3e0\",400,1.00,0.90,1.20,true\n\
         gap,given,x - y,f64,12.1,15.9,,\"x = 5e-1, y = 3e0\",400,2.00,1.90,2.20,true\n\
         gap,repair 1,x + -y,f64,11.0,12.0,2.1,\"x = 5e-1, y = 3e0\",400,3.00,2.90,3.20,false\n\
         gap,repair 1,x + -y,rational,exact,exact,,\"x = 5e-1, y = 3e0\",400,900,899,900,true\n"
    );
}

#[test]
fn a_table_marks_what_nothing_beats_and_bounds_what_is_bounded() {
    let all = [made_up()];
    let text = sheet(&report(&all)).text(Page::default());
    let lines: Vec<String> =
        text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
    let told = |expected: &str| assert!(lines.iter().any(|line| line == expected), "{lines:#?}");
    told("1 formula: what the next digit costs");
    told("gap x - y");
    told("given in f32 • 1.00 0.90 .. 1.20 5.0 7.0 3.1 x = 5e-1, y = 3e0");
    told("given in f64 • 2.00 1.90 .. 2.20 12.1 15.9 x = 5e-1, y = 3e0");
    told("repair 1 in f64 3.00 2.90 .. 3.20 11.0 12.0 2.1 x = 5e-1, y = 3e0");
    told("repair 1 in rational • 900 899 .. 900 exact exact");
    told("pole no float");
    let two = [made_up(), made_up()];
    assert_eq!(sheet(&report(&two)).headline(), "2 formulas: what the next digit costs");
}

#[test]
fn each_way_is_told_for_programs() {
    let all = [made_up()];
    let told: Value = serde_json::from_str(&super::json(&report(&all))).expect("JSON");
    assert_eq!([&told["file"], &told["machine"]], ["made-up.fpcore", "a machine"]);
    assert_eq!(told["left_out"], json!([{ "label": "pole", "because": "no float" }]));
    let formula = &told["formulas"][0];
    assert_eq!(formula["forms"][1]["text"], "x + -y");
    let way = |form: &str,
               system: &str,
               digits: [&str; 2],
               bits: Value,
               times: [u64; 3],
               pareto: bool| {
        json!({
            "form": form, "system": system, "digits_worst": digits[0], "digits_median": digits[1],
            "bits_lost_at_most": bits, "worst_at": [0.5, 3.0], "inputs": 400, "picoseconds": times,
            "pareto": pareto,
        })
    };
    let expected = [
        way("given", "f32", ["5.0", "7.0"], json!("3.1"), [900, 1_000, 1_200], true),
        way("given", "f64", ["12.1", "15.9"], Value::Null, [1_900, 2_000, 2_200], true),
        way("repair 1", "f64", ["11.0", "12.0"], json!("2.1"), [2_900, 3_000, 3_200], false),
        way(
            "repair 1",
            "rational",
            ["exact", "exact"],
            Value::Null,
            [899_900, 900_000, 900_200],
            true,
        ),
    ];
    assert_eq!(formula["ways"], Value::from(expected.to_vec()));
}

#[test]
fn the_picture_has_a_mark_for_each_way() {
    let all = [made_up()];
    let seen = Seen::of(&picture(&report(&all)));
    // of f64 two, and a ring for what is exact; one of each is in the legend
    assert_eq!(seen.circles().len(), 2 + 3);
    assert!(seen.place("gap: x - y").is_some() && seen.place("repair 1").is_some());
}

#[test]
fn of_no_formula_it_is_said_that_none_was_measured_and_which_there_might_be() {
    let report = report(&[]);
    let text = sheet(&report).text(Page::default());
    assert!(text.contains("no formula was measured; 1 left out"), "{text}");
    assert!(text.contains("the bodies of its definitions"), "{text}");
    assert!(!text.contains("fastest"), "{text}");
}
