//! What is said of accounts that are made up.
#![allow(clippy::float_arithmetic, reason = "numbers are made up")]

use kane_floats::decision;
use kane_floats::fpcore;
use kane_floats::rigor::{Cell, FaultKind};
use kane_kernel::Rel;
use serde_json::{Value, json};

use super::*;
use crate::sheet::Page;

fn core(text: &str) -> Core {
    fpcore::read("made-up.fpcore", text).expect("it is well formed").remove(0)
}

/// x − y over a closed and an open range.
fn gap() -> Core {
    core("(FPCore (x y) :name \"gap\" :pre (and (<= 1 x 2) (< 0 y 4)) (- x y))")
}

fn bounded(bound: f64) -> Bounded {
    Bounded { bound, least: 0.0, worst: Vec::new(), pole: None, cells: 1 }
}

fn failing(core: &Core, kind: FaultKind, certain: bool) -> Bounded {
    let cell = Cell { ends: vec![(1.0, 1.0), (0.0, 4.0)] };
    let pole = Some(Pole { operation: core.root, kind, cell, certain });
    Bounded { bound: f64::INFINITY, pole, ..bounded(0.0) }
}

fn found(at: [&str; 2], error: f64) -> Option<Found> {
    let at = at.map(str::to_owned).to_vec();
    Some(Found {
        at,
        computed: "5e-1".to_owned(),
        exact: "2.5e-1".to_owned(),
        error,
        error_at_most: error,
    })
}

/// Absolute errors up to 3 and found up to 2, and up to 8 and 2 ulps.
fn certified(precision: Precision) -> Certified {
    Certified {
        precision,
        absolute: bounded(3.0),
        ulps: bounded(8.0),
        worst: found(["1e0", "3e0"], 2.0),
        worst_in_ulps: found(["2e0", "3.5e0"], 2.0),
        half_lost: Vec::new(),
        decided: Vec::new(),
        repairs: Vec::new(),
        unproved: 0,
    }
}

fn account(core: Core, formats: Vec<Result<Certified, String>>) -> Account {
    Account { label: "a gap".to_owned(), core, formats }
}

fn cells(row: &Row) -> Vec<String> {
    row.cells.iter().map(Words::plain).collect()
}

fn text(accounts: &[Account]) -> String {
    let report = FloatsReport { name: "made up".to_owned(), accounts, command: "kane".to_owned() };
    sheet(&report).text(Page::default())
}

#[test]
fn a_range_has_the_brackets_of_its_ends() {
    assert_eq!(ranges(&gap()), "x in [1, 2], y in (0, 4)");
    let half_open = "(FPCore (x y) :pre (and (<= 1/4 x) (< x 2) (<= y -3)) (- x y))";
    assert_eq!(ranges(&core(half_open)), "x in [0.25, 2), y in [least float, -3]");
    assert_eq!(ranges(&core("(FPCore (x) (+ x 1))")), "x in [least float, greatest float]");
}

#[test]
fn an_error_is_told_with_its_bound_what_was_found_and_where() {
    let rows = rows(&gap(), &certified(Precision::F32));
    assert_eq!(
        cells(&rows[0]),
        ["f32", "absolute", "3.00e0", "2.00e0", "1.50", "x = 1e0, y = 3e0"]
    );
    // logarithms of 8 and 2, upwards and downwards
    assert_eq!(cells(&rows[1]), ["f32", "bits lost", "3.1", "0.9", "2.0", "x = 2e0, y = 3.5e0"]);
    assert_eq!([rows[0].tone, rows[1].tone], [Tone::Plain; 2]);
}

#[test]
fn where_nothing_was_found_the_error_is_zero_and_has_no_place() {
    let nothing = Certified { worst: None, worst_in_ulps: None, ..certified(Precision::F64) };
    let rows = rows(&gap(), &nothing);
    assert_eq!(cells(&rows[0]), ["f64", "absolute", "3.00e0", "0", "found 0", ""]);
    assert_eq!(cells(&rows[1]), ["f64", "bits lost", "3.1", "0.0", "3.0", ""]);
}

#[test]
fn an_error_below_the_least_double_is_not_told_as_none() {
    let least = f64::from_bits(1);
    let worst = found(["1e0", "1e0"], 0.0).map(|found| Found { error_at_most: least, ..found });
    let rows = rows(&gap(), &Certified { worst, ..certified(Precision::F64) });
    assert_eq!(
        cells(&rows[0]),
        ["f64", "absolute", "3.00e0", "below 4.95e-324", "", "x = 1e0, y = 1e0"]
    );
}

#[test]
fn more_than_half_of_the_bits_is_marked() {
    for (precision, half) in [(Precision::F32, 4096.0), (Precision::F64, 94_906_265.0)] {
        let tone = |error| {
            let worst_in_ulps = found(["1e0", "1e0"], error);
            rows(&gap(), &Certified { worst_in_ulps, ..certified(precision) })[1].tone
        };
        assert_eq!([tone(half), tone(half + 1.0)], [Tone::Plain, Tone::Bad], "{precision:?}");
    }
}

#[test]
fn where_an_operation_fails_no_bound_is_told() {
    let core = gap();
    let pole = |kind, certain| {
        let (absolute, ulps) = (failing(&core, kind, certain), failing(&core, kind, certain));
        Certified { absolute, ulps, ..certified(Precision::F64) }
    };
    let of = pole(FaultKind::DivisionByZero, false);
    let rows = rows(&core, &of);
    assert_eq!(cells(&rows[0])[2..5], ["none", "2.00e0", ""]);
    assert_eq!(cells(&rows[1])[2], "none");
    assert_eq!(rows[0].tone, Tone::Bad);
    let told = |of: &Certified| poles(&core, of).map(|entry| entry.words.plain());
    let at = "at x = 1e0, y in [0e0, 4e0]";
    let cases = [
        (FaultKind::DivisionByZero, "may divide by 0", "divides by 0"),
        (FaultKind::Overflow, "may overflow", "overflows"),
        (
            FaultKind::NegativeRoot,
            "may be the root of a negative number",
            "is the root of a negative number",
        ),
    ];
    for (kind, open, certain) in cases {
        let expected = |how| Some(format!("no bound in f64: x - y {how} {at}"));
        assert_eq!(told(&pole(kind, false)), expected(open));
        assert_eq!(told(&pole(kind, true)), expected(certain));
    }
    assert_eq!(told(&certified(Precision::F64)), None);
}

#[test]
fn where_half_of_the_bits_may_be_lost_is_told_box_by_box() {
    let core = gap();
    let told = |half_lost: Vec<Cell>| {
        let of = Certified { half_lost, ..certified(Precision::F32) };
        half_lost_of(&core, &of)
    };
    assert_eq!(told(vec![]), "in f32 no input loses more than half of the bits");
    let boxes = [vec![(1.0, 1.0), (0.5, 3.0)], vec![(1.0, 2.0), (0.0, 0.0)]];
    let boxes = boxes.map(|ends| Cell { ends }).to_vec();
    assert_eq!(
        told(boxes),
        "in f32 more than half of the bits may be lost for x = 1e0, y in [5e-1, 3e0] or \
         x in [1e0, 2e0], y = 0, and nowhere else"
    );
}

fn half_lost_of(core: &Core, found: &Certified) -> String {
    half_lost(core, found).words.plain()
}

fn jump() -> Account {
    let text = "(FPCore (x) :name \"jump\" :cite (someone) :pre (and (<= 0 x 1) (< (* x x) 2)) \
                (if (< (* 1/8 x) 1/16) 0 1))";
    let core = core(text);
    let decision = decision::decisions(&core).remove(0);
    assert_eq!(decision.rel, Rel::Lt);
    let of = |wrong, wrong_near, holds| Decided {
        decision: decision.clone(),
        drawn: 500,
        wrong,
        near: 40,
        wrong_near,
        example: Some((vec!["4.9e-1".to_owned()], holds)),
    };
    let decided = vec![
        of(7, 3, true),
        of(0, 1, false),
        of(1, 0, false),
        Decided { example: None, ..of(0, 0, true) },
    ];
    account(core, vec![Ok(Certified { decided, ..certified(Precision::F64) })])
}

#[test]
fn a_comparison_is_told_with_how_often_it_goes_wrong() {
    let table = decisions(&jump());
    let rows: Vec<Vec<String>> = table.rows.iter().map(cells).collect();
    let comparison = "0.125*x < 0.0625";
    let row = |near: &str, elsewhere: &str, at: &str| {
        ["f64", comparison, near, elsewhere, "emitted", at].map(str::to_owned).to_vec()
    };
    assert_eq!(
        rows,
        [
            row("3 of 40", "7 of 500", "x = 4.9e-1, where it holds"),
            row("1 of 40", "0 of 500", "x = 4.9e-1, where it fails"),
            row("0 of 40", "1 of 500", "x = 4.9e-1, where it fails"),
            row("0 of 40", "0 of 500", ""),
        ]
    );
    let tones: Vec<Tone> = table.rows.iter().map(|row| row.tone).collect();
    assert_eq!(tones, [Tone::Bad, Tone::Bad, Tone::Bad, Tone::Plain]);
}

/// With a repair in one format.
fn repaired() -> Account {
    let better = core("(FPCore (x y) :pre (and (<= 1 x 2) (< 0 y 4)) (/ (sqrt (- x y)) (+ x y)))");
    let repair = Repair {
        core: better,
        absolute: bounded(0.5),
        ulps: bounded(4.0),
        worst_in_ulps: found(["1e0", "1e0"], 1.0),
    };
    let narrow = certified(Precision::F32);
    let wide = Certified { repairs: vec![repair], unproved: 2, ..certified(Precision::F64) };
    account(gap(), vec![Ok(narrow), Ok(wide)])
}

#[test]
fn a_repair_stands_below_what_it_repairs_with_its_price() {
    let account = repaired();
    let of = |format: usize| {
        let found = account.formats[format].as_ref().expect("a float is in each range");
        repairs(&account, found)
    };
    assert!(of(0).is_empty());
    let rows = of(1);
    assert_eq!(
        rows.iter().map(cells).collect::<Vec<_>>(),
        [
            ["f64", "3.1", "0.9", "3.00e0", "1", "0", "x - y"],
            ["f64", "2.1", "0.0", "5.00e-1", "2", "2", "sqrt(x - y)/(x + y)"],
        ]
    );
    assert_eq!([rows[0].tone, rows[1].tone], [Tone::Plain, Tone::Good]);
    // the best form is that of the widest format
    let (form, precision) = best(&account);
    assert_eq!((form.text().as_str(), precision), ("sqrt(x - y)/(x + y)", Precision::F64));
    let narrow = self::account(gap(), vec![Ok(certified(Precision::F32)), Err("x".to_owned())]);
    let (form, precision) = best(&narrow);
    assert_eq!((form.text().as_str(), precision), ("x - y", Precision::F32));
}

#[test]
fn a_repair_without_a_bound_is_none() {
    let mut account = repaired();
    let Some(Ok(found)) = account.formats.last_mut() else { panic!("there are two formats") };
    let failing = failing(&gap(), FaultKind::Overflow, false);
    found.repairs[0].ulps = failing.clone();
    found.repairs[0].absolute = failing;
    found.repairs[0].worst_in_ulps = None;
    let found = found.clone();
    assert_eq!(cells(&repairs(&account, &found)[1])[..4], ["f64", "none", "0.0", "none"]);
}

#[test]
fn bounds_are_counted_and_what_was_not_proved_is_told() {
    let two = [
        account(
            gap(),
            vec![
                Ok(Certified {
                    absolute: failing(&gap(), FaultKind::Overflow, false),
                    ..certified(Precision::F32)
                }),
                Ok(certified(Precision::F64)),
            ],
        ),
        account(gap(), vec![Err("y".to_owned())]),
    ];
    let told = text(&two);
    assert!(told.contains("2 formulas: 1 of 3 bounds on round-off\n"), "{told}");
    assert!(told.contains("no float is in the range of y\n"), "{told}");
    assert!(!told.contains("not proved equal"), "{told}");
    let told = text(&[repaired()]);
    assert!(told.contains("1 formula: 2 of 2 bounds on round-off\n"), "{told}");
    assert!(told.contains("2 forms were not proved equal, and left out\n"), "{told}");
    let one = Certified { unproved: 1, ..certified(Precision::F64) };
    let told = text(&[account(gap(), vec![Ok(one)])]);
    assert!(told.contains("1 form was not proved equal, and left out\n"), "{told}");
}

fn told_json(accounts: &[Account]) -> Value {
    let report = FloatsReport { name: "made up".to_owned(), accounts, command: "kane".to_owned() };
    serde_json::from_str(&super::json(&report)).expect("JSON")
}

#[test]
fn bounds_and_errors_are_numbers_for_programs() {
    let json = told_json(&[repaired()]);
    assert_eq!([&json["file"], &json["schema"]["name"]], ["made up", "kane-floats"]);
    let formula = &json["formulas"][0];
    assert_eq!([&formula["label"], &formula["text"]], ["a gap", "x - y"]);
    let at = |at: [&str; 2], error: f64| json!({ "error": error, "at": at, "returns": "5e-1", "exact": "2.5e-1" });
    let fpcore = "(FPCore (x y) :pre (and (<= 1 x 2) (< 0 y 4)) (/ (sqrt (- x y)) (+ x y)))";
    let format = |format: &str| {
        json!({
            "format": format, "error_at_most": 3.0, "error_found": at(["1e0", "3e0"], 2.0),
            "ulps_at_most": 8.0, "ulps_found": at(["2e0", "3.5e0"], 2.0), "pole": null,
            "half_lost": [], "decisions": [], "repairs": [], "unproved": 0,
        })
    };
    let mut wide = format("f64");
    wide["unproved"] = json!(2);
    let mut told = formula["formats"][1].clone();
    let read = core(told["repairs"][0]["fpcore"].as_str().expect("a text"));
    assert_eq!(read.text(), core(fpcore).text());
    told["repairs"][0]["fpcore"].take();
    wide["repairs"] = json!([{
        "text": "sqrt(x - y)/(x + y)", "fpcore": null, "error_at_most": 0.5, "ulps_at_most": 4.0,
        "ulps_found": at(["1e0", "1e0"], 1.0), "light_operations": 2, "heavy_operations": 2,
    }]);
    assert_eq!(formula["formats"][0], format("f32"));
    assert_eq!(told, wide);
}

#[test]
fn what_is_not_bounded_has_no_number_for_programs() {
    let core = gap();
    let pole = Certified {
        absolute: failing(&core, FaultKind::DivisionByZero, true),
        ulps: bounded(f64::INFINITY),
        worst: found(["1e0", "1e0"], f64::INFINITY),
        half_lost: vec![Cell { ends: vec![(1.0, 2.0), (0.0, 0.1)] }],
        ..certified(Precision::F64)
    };
    let json = told_json(&[account(core, vec![Ok(pole), Err("y".to_owned())])]);
    let formats = json["formulas"][0]["formats"].as_array().expect("a list");
    assert_eq!(formats.len(), 1);
    let format = &formats[0];
    assert_eq!([&format["error_at_most"], &format["ulps_at_most"]], [&Value::Null; 2]);
    assert_eq!(format["error_found"]["error"], Value::Null);
    assert_eq!(
        format["pole"],
        json!({ "operation": "x - y", "what": "divides by 0 at x = 1e0, y in [0e0, 4e0]",
            "certain": true })
    );
    assert_eq!(
        format["half_lost"],
        json!([[
            { "argument": "x", "from": "1e0", "to": "2e0" },
            { "argument": "y", "from": "0", "to": "1e-1" },
        ]])
    );
}

#[test]
fn a_comparison_is_told_for_programs_with_both_its_sides() {
    let json = told_json(&[jump()]);
    let decisions = &json["formulas"][0]["formats"][0]["decisions"];
    let mut first = decisions[0].clone();
    let side = |text: &Value| core(text.as_str().expect("a text")).text();
    assert_eq!([side(&first["left"]), side(&first["right"])], ["0.125*x", "0.0625"]);
    // a side is no more than itself over its ranges
    let left = first["left"].as_str().unwrap_or_default();
    assert!(!["jump", "someone", "(* x x)"].iter().any(|more| left.contains(more)), "{left}");
    first["left"].take();
    first["right"].take();
    assert_eq!(
        first,
        json!({
            "text": "0.125*x < 0.0625", "left": null, "relation": "<", "right": null,
            "function": "jump_1_decides_1", "drawn": 500, "wrong": 7, "drawn_near_ties": 40,
            "wrong_near_ties": 3, "example": { "at": ["4.9e-1"], "holds": true },
        })
    );
    assert_eq!(decisions[1]["example"]["holds"], false);
    assert_eq!(decisions[3]["example"], Value::Null);
}
