//! What is said of methods whose numbers are made up.
#![allow(clippy::float_arithmetic, reason = "numbers are made up")]

use kane_measure::chart::{Accuracy, registry};
use kane_number::System;
use serde_json::{Value, json};

use super::*;
use crate::sheet::Page;

fn rational(text: &str) -> Rational {
    kane_number::parse(text).expect("a number")
}

/// A form (1) of the quantity k of a law in a system, with so many hundredths of digits at its worst input.
fn form(system: System, worst: i64) -> Measured {
    let mut method = registry().remove(0);
    (method.law, method.quantity, method.name) = ("first", "k", "(1)");
    (method.text, method.k, method.is_law, method.least) = ("1 - alpha", "", false, -4);
    method.system = system;
    let accuracy =
        Accuracy { worst, median: worst, at: 0.5, ulps: None, greatest: 8.0, tried: 1000 };
    Measured { method, accuracy, cost: None, proved: None, time: None }
}

fn timed_at(picoseconds: u64, measured: Measured) -> Measured {
    let quartiles = (picoseconds - 100, picoseconds + 300);
    let time = Some(Time { median: picoseconds, quartiles, rounds: 7 });
    Measured { time, ..measured }
}

fn proved(ulps: &str, to: &str, measured: Option<i64>) -> Option<Proved> {
    Some(Proved { ulps: rational(ulps), to: rational(to), measured })
}

fn report(all: &[Measured]) -> ChartReport<'_> {
    ChartReport { all, machine: "a machine".to_owned(), command: "kane chart".to_owned() }
}

#[test]
fn times_are_told_in_nanoseconds_and_digits_to_a_tenth() {
    let told = [0, 7, 10, 999, 1000, 1234, 9_999, 10_000, 12_345, 99_999, 100_000, 1_234_567];
    let expected = [
        "0.00", "0.00", "0.01", "0.99", "1.00", "1.23", "9.99", "10.0", "12.3", "99.9", "100",
        "1234",
    ];
    assert_eq!(told.map(nanoseconds), expected);
    let time = Time { median: 5, quartiles: (1230, 45_600), rounds: 3 };
    assert_eq!(quartiles(&time), "1.23 .. 45.6");
    assert_eq!([0, 9, 10, 1595, i64::MAX].map(digits), ["0.0", "0.0", "0.1", "15.9", "exact"]);
}

#[test]
fn an_error_of_at_most_an_ulp_is_told_as_such() {
    let told =
        [None, Some(-5), Some(0), Some(1), Some(9), Some(10), Some(170), Some(2690)].map(ulps);
    assert_eq!(told, ["", "<= 1", "<= 1", "2^0.0", "2^0.0", "2^0.1", "2^1.7", "2^26.9"]);
}

#[test]
fn a_bound_is_told_where_it_is_proved_and_missed_where_ulps_are_measured() {
    let mut of = form(System::F64, 1590);
    assert_eq!(bound(&of), "");
    of.accuracy.ulps = Some(10);
    assert_eq!([bound(&of), daggered(&of)], ["none", "none"]);
    // an exact method needs none
    of.accuracy.worst = i64::MAX;
    assert_eq!(bound(&of), "");
    of.proved = proved("7/2", "1073741824", None);
    assert_eq!([bound(&of), daggered(&of)], ["7/2", "7/2"]);
    of.proved = proved("7/2", "512", None);
    assert_eq!(daggered(&of), "7/2†");
    let ends = ["1", "2", "512", "1073741824", "3", "1/2", "0"];
    let told = ends.map(|to| reach(&proved("1", to, None).expect("it is proved")));
    assert_eq!(told, ["2^0", "2^1", "2^9", "2^30", "3", "1/2", "0"]);
}

#[test]
fn a_bound_that_ends_early_has_a_note_with_what_was_measured_there() {
    let whole = Measured { proved: proved("2", "1073741824", Some(90)), ..form(System::F64, 1590) };
    let early = Measured { proved: proved("3", "512", Some(150)), ..form(System::F32, 700) };
    let all = [whole, form(System::F64, 1500), early];
    assert_eq!(
        report(&all).notes(),
        [
            "proved: no error for alpha from 0 to 2^30 is larger, in ulps (docs/rounding)",
            "† proved to alpha = 2^9 only, and up to there at most 2^1.5 measured: first k (1) in f32",
        ]
    );
}

/// Two quantities of one law, and one of another; the cheaper is not the first.
fn all() -> Vec<Measured> {
    let mut slow = timed_at(20_000, form(System::F64, 1590));
    slow.cost = Some(12);
    slow.accuracy.ulps = Some(45);
    slow.proved = proved("3", "512", Some(-20));
    let mut fast = timed_at(2_000, form(System::F64, 1210));
    (fast.method.name, fast.method.is_law) = ("law", true);
    let mut exact = timed_at(900_000, form(System::Rational, i64::MAX));
    exact.cost = Some(80);
    exact.accuracy.ulps = Some(0);
    let mut worse = timed_at(950_000, form(System::DoubleDouble, 0));
    worse.method.least = -40;
    worse.cost = Some(3);
    let mut other = form(System::F32, 700);
    other.method.law = "second";
    other.method.quantity = "i_x";
    vec![slow, exact, fast, other, worse]
}

#[test]
fn of_each_quantity_the_cheapest_comes_first() {
    let all = all();
    let groups = report(&all).groups();
    assert_eq!(groups, [(("first", "k"), vec![2, 0, 1, 4]), (("second", "i_x"), vec![3])]);
    // without a clock by the counted cost, and what is not counted last
    let all: Vec<Measured> =
        all.into_iter().map(|measured| Measured { time: None, ..measured }).collect();
    assert_eq!(report(&all).groups()[0].1, [4, 0, 1, 2]);
}

#[test]
fn a_clock_that_contradicts_the_count_is_warned_of() {
    let all = all();
    assert_eq!(
        report(&all).warnings(),
        [
            "warning: counted as cheaper, but slower: first k (1) in double-double than first k (1) in f64",
            "warning: counted as cheaper, but slower: first k (1) in double-double than first k (1) in rational",
        ]
    );
}

#[test]
fn each_method_is_a_row() {
    let all = all();
    let rows = csv(&report(&all));
    assert_eq!(
        rows,
        "law,quantity,name,form,k,system,alpha_from,alpha_to,digits_worst,digits_median,log2_ulps_worst,\
         ulps_proved,proved_to,log2_ulps_worst_up_to_there,worst_alpha,counted_cost,ns,ns_first_quartile,\
         ns_third_quartile,pareto\n\
         first,k,(1),1 - alpha,,f64,2^-4,2^30,15.9,15.9,0.45,3,2^9,0.00,5e-1,12,20.0,19.9,20.3,true\n\
         first,k,(1),1 - alpha,,rational,2^-4,2^30,exact,exact,,,,,,80,900,899,900,true\n\
         first,k,law,the program's own,,f64,2^-4,2^30,12.1,12.1,,,,,5e-1,,2.00,1.90,2.30,true\n\
         second,i_x,(1),1 - alpha,,f32,2^-4,2^30,7.0,7.0,,,,,5e-1,,,,,false\n\
         first,k,(1),1 - alpha,,double-double,2^-30,2^30,0.0,0.0,,,,,5e-1,3,950,949,950,false\n"
    );
    assert_eq!(
        committed(&all),
        "law,quantity,name,system,alpha_from,alpha_to,inputs,digits_worst,digits_median,log2_ulps_worst,\
         worst_alpha,counted_cost,rank\n\
         first,k,(1),f64,2^-4,2^30,1000,15.9,15.9,0.4,5e-1,12,2\n\
         first,k,(1),rational,2^-4,2^30,1000,exact,exact,,,80,3\n\
         first,k,law,f64,2^-4,2^30,1000,12.1,12.1,,5e-1,,\n\
         second,i_x,(1),f32,2^-4,2^30,1000,7.0,7.0,,5e-1,,\n\
         first,k,(1),double-double,2^-30,2^30,1000,0.0,0.0,,5e-1,3,1\n"
    );
    assert_eq!(
        times(&report(&all)),
        "# a machine\n\
         law,quantity,name,system,ps_first_quartile,ps,ps_third_quartile,rounds\n\
         first,k,(1),f64,19900,20000,20300,7\n\
         first,k,(1),rational,899900,900000,900300,7\n\
         first,k,law,f64,1900,2000,2300,7\n\
         first,k,(1),double-double,949900,950000,950300,7\n"
    );
}

#[test]
fn each_method_is_told_for_programs() {
    let all = all();
    let told: Value = serde_json::from_str(&super::json(&report(&all))).expect("JSON");
    assert_eq!(told["machine"], "a machine");
    assert_eq!(told["warnings"].as_array().map(Vec::len), Some(2));
    assert_eq!(
        told["methods"][0],
        json!({
            "law": "first", "quantity": "k", "name": "(1)", "form": "1 - alpha", "k": "",
            "own_code": false, "system": "f64", "digits_worst": "15.9", "digits_median": "15.9",
            "log2_ulps_worst": 45,
            "proved": { "ulps": "3", "to": "2^9", "log2_ulps_worst": -20 },
            "worst_alpha": 0.5, "inputs": 1000, "counted_cost": 12,
            "picoseconds": [19_900, 20_000, 20_300], "rounds": 7, "pareto": true,
        })
    );
    let none = json!([null, null, null, null, false]);
    let of = &told["methods"][3];
    let names = ["proved", "counted_cost", "picoseconds", "rounds", "pareto"];
    assert_eq!(Value::from(names.map(|name| of[name].clone()).to_vec()), none);
}

#[test]
fn a_table_marks_what_nothing_beats() {
    let all = all();
    let text = sheet(&report(&all)).text(Page::default());
    let lines: Vec<String> =
        text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
    let told = |expected: &str| assert!(lines.iter().any(|line| line == expected), "{lines:#?}");
    told("(1) in f64 • 20.0 19.9 .. 20.3 15.9 15.9 2^0.4 3† 5.000e-1 1 - alpha");
    told("law in f64 • 2.00 1.90 .. 2.30 12.1 12.1 5.000e-1 the program's own");
    told("(1) in rational • 900 899 .. 900 exact exact 1 - alpha");
    told("(1) in double-double 950 949 .. 950 0.0 0.0 5.000e-1 1 - alpha");
    // columns without a number are left out
    told("(1) in f32 7.0 7.0 5.000e-1 1 - alpha");
    assert!(!lines.iter().any(|line| line.starts_with("… and")), "{lines:#?}");
}

/// What is said at the points of the picture.
fn said(all: &[Measured]) -> Vec<(String, bool)> {
    let report = report(all);
    readings(&timed(&report)).iter().map(|r| (r.sentence(), r.is_wrong)).collect()
}

#[test]
fn the_picture_says_what_the_cheapest_right_methods_cost() {
    let right = |name, at, digits| {
        let mut of = timed_at(at, form(System::F64, digits));
        of.method.name = name;
        of
    };
    let mut wide = timed_at(30_000, form(System::DoubleDouble, 3110));
    wide.method.name = "law";
    let all = [
        right("(1)", 4_000, 1550),
        right("(2)", 3_000, 1590),
        // 15 digits are not more than 15, and neither are 30 more than 30
        right("(3)", 1_000, 1500),
        timed_at(2_000, form(System::DoubleDouble, 3000)),
        wide,
        timed_at(700_000, form(System::Rational, i64::MAX)),
        timed_at(600_000, form(System::Rational, i64::MAX)),
        // half a digit is one that is left
        right("(4)", 500, 50),
        right("(5)", 900, 49),
    ];
    let told = |text: &str, is_wrong| (text.to_owned(), is_wrong);
    assert_eq!(
        said(&all),
        [
            told("f64, (2) 1 − α: 15.9 digits in 3.00 ns", false),
            told(
                "double-double, the law's code: 31.1 digits in 30.0 ns, 10 times the price",
                false
            ),
            told("exact fractions: all digits from 600 ns on", false),
            told("f64, rewritten, (5) 1 − α: no digit is right, in 0.90 ns", true),
        ]
    );
    // without a float that is right there is nothing to compare with
    let told = said(&all[4..5]);
    assert_eq!(told[0].0, "double-double, the law's code: 31.1 digits in 30.0 ns");
    assert!(said(&[]).is_empty());
}

#[test]
fn a_kernel_over_columns_is_one_method_as_good_as_at_its_worst() {
    let column = |quantity, digits| {
        let mut of = timed_at(5_000, form(System::F64, digits));
        (of.method.name, of.method.quantity) = ("columns", quantity);
        of
    };
    let mut other = column("k", 1560);
    other.method.system = System::F32;
    let mut foreign = timed_at(1_000, form(System::F64, 1600));
    foreign.method.law = "second";
    let all = [column("k", 1590), column("i_x", 1530), column("e", 1580), other, foreign];
    let chart = report(&all);
    let methods = timed(&chart);
    let told: Vec<(System, usize, i64)> = methods
        .iter()
        .map(|t| (t.measured.method.system, t.quantities, t.measured.accuracy.worst))
        .collect();
    assert_eq!(told, [(System::F64, 3, 1530), (System::F32, 1, 1560)]);
    assert_eq!(said(&all)[0].0, "f64, in columns: 15.3 digits in 5.00 ns for all 3 quantities");
}

#[test]
fn a_method_stands_at_its_time_and_its_digits_and_the_best_have_names() {
    let mut all = all();
    all.truncate(3);
    // worse than the first in both
    all.push(timed_at(40_000, form(System::DoubleDouble, 900)));
    let svg = picture(&report(&all));
    let seen = crate::picture::seen::Seen::of(&svg);
    // the numbers at the left are words; 0 is "wrong" and 38 is "exact"
    let y = |words: &str| seen.place(words).expect(words).1;
    let (zero, exact) = (y("wrong"), y("exact"));
    let x = |words: &str| seen.place(words).expect(words).0;
    let (one, thousand) = (x("1"), x("1000"));
    let of = |picoseconds: f64, digits: f64| {
        let along = one + (picoseconds / 1000.0).log10() / 3.0 * (thousand - one);
        (along, zero + digits / 38.0 * (exact - zero) - 0.36 * 12.0)
    };
    let is_at =
        |(x, y): (f64, f64), (a, b): (f64, f64)| (x - a).abs() < 0.03 && (y - b).abs() < 0.03;
    // after those of the legend: two discs, and a ring for the exact one
    let circles: Vec<_> = seen.circles().iter().skip(2).map(|circle| circle.at).collect();
    let expected = [of(2_000.0, 12.1), of(20_000.0, 15.9), of(900_000.0, 38.0)];
    assert_eq!(circles.len(), 3);
    for (seen, expected) in circles.iter().zip(expected) {
        assert!(is_at(*seen, expected), "{seen:?}, {expected:?}");
    }
    // the staircase of what nothing beats, on to the right end
    let stairs =
        seen.lines().iter().filter(|line| line.class == "c6 line" && line.points.len() > 4);
    let stairs = &{ stairs }.next_back().expect("a staircase").points;
    let steps = [
        of(2_000.0, 12.1),
        of(20_000.0, 12.1),
        of(20_000.0, 15.9),
        of(900_000.0, 15.9),
        of(900_000.0, 38.0),
        of(1_800_000.0, 38.0),
    ];
    assert_eq!(stairs.len(), steps.len(), "{stairs:?}");
    for (seen, expected) in stairs.iter().zip(steps) {
        assert!(is_at(*seen, expected), "{seen:?}, {expected:?}");
    }
    assert!(seen.place("the law's code").is_some());
    let named = "(1) 1 - alpha, proved: 3 ulp to 2^9";
    assert!(seen.place(named).is_some(), "{svg}");
    // a bar from the first to the third quartile
    let bar = seen.lines().iter().find(|line| {
        line.points.len() == 2
            && is_at(line.points[0], of(19_900.0, 15.9))
            && is_at(line.points[1], of(20_300.0, 15.9))
    });
    assert!(bar.is_some(), "{svg}");
}
