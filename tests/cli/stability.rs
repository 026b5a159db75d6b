//! `kane stability` and `kane chart`: exit codes and files.

use std::fs;

use crate::{document, kane, scratch};

#[test]
fn a_document_of_one_s_own_is_examined() {
    let dir = scratch("stability");
    let file = document(&dir, "two.md", "var x > 0\nlet f := 2/(1 + x) - 1\nlet g := x + 1");
    let target = dir.join("maps");
    let run = kane(&["stability", &file, "--out", target.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("2 formulas in f32 and f64: 1 fails"), "{}", run.stdout);
    for ending in ["txt", "md", "html", "tex", "json", "csv", "svg"] {
        let path = target.join(format!("two-stability.{ending}"));
        assert!(path.is_file(), "{} is missing", path.display());
    }
    let json = fs::read_to_string(target.join("two-stability.json")).expect("it was written");
    assert_eq!(json, kane(&["stability", &file, "--format", "json"]).stdout);
}

/// 1 - p^2 on (0, 1) loses half of its digits next to 1, on few floats: no all-clear.
#[test]
fn the_ends_of_a_domain_are_looked_at_to_the_float() {
    let dir = scratch("stability-ends");
    let file = document(&dir, "ends.md", "var 0 < p < 1\nlet i_p := 1 - p^2");
    let run = kane(&["stability", &file, "--format", "json"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let value: serde_json::Value = serde_json::from_str(&run.stdout).expect("it is JSON");
    let line = &value["formulas"][0]["lines"][1];
    assert_eq!(line["format"], "f64");
    let lost: f64 = line["bits_lost"].as_str().expect("a text").parse().expect("a number");
    assert!(lost > 24.0, "{line}");
    let bound = &value["bounds"][0]["formats"][1];
    let (least, most) = (&bound["ulps_found"]["error"], &bound["ulps_at_most"]);
    let (least, most) = (least.as_f64().expect("found"), most.as_f64().expect("bounded"));
    assert!(least > 2.0_f64.powi(23) && least <= most, "{bound}");
}

#[test]
fn fpcore_has_bounds_repairs_and_sources() {
    let dir = scratch("stability-fpcore");
    let file = dir.join("two.fpcore");
    let text =
        "(FPCore (x) :name \"f\" :precision binary64 :pre (<= 1 x) (- (sqrt (+ x 1)) (sqrt x)))";
    fs::write(&file, text).expect("it is writable");
    let file = file.to_str().expect("UTF-8");
    let target = dir.join("out");
    let out = target.to_str().expect("UTF-8");
    let run = kane(&["stability", file, "--range", "x=4..12", "--out", out]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("x in [4, 12]"), "{}", run.stdout);
    assert!(run.stdout.contains("1/(sqrt(x + 1) + sqrt(x))"), "{}", run.stdout);
    let rust = fs::read_to_string(target.join("two-floats.rs")).expect("it was written");
    assert!(rust.contains("pub fn f_1(x: f64) -> f64 {"), "{rust}");
    for ending in ["c", "py", "fpcore", "json", "html", "md"] {
        assert!(target.join(format!("two-floats.{ending}")).is_file(), "{ending}");
    }
    // what the program wrote it may write again
    assert_eq!(kane(&["stability", file, "--range", "x=4..12", "--out", out]).code, 0);
}

/// A choice that rounding can turn is named with an input at which it does, and written again without that fault.
#[test]
fn a_guard_has_a_certified_version_beside_the_formula() {
    let dir = scratch("stability-decides");
    let file = document(
        &dir,
        "guard.md",
        "var 0 < x < 2, 0 < y < 2\nlet f := cases { x*y < 1: x; else: y }",
    );
    let target = dir.join("out");
    let run = kane(&["stability", &file, "--out", target.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("x*y < 1"), "{}", run.stdout);
    assert!(run.stdout.contains("wrong near ties"), "{}", run.stdout);
    for (ending, head) in [
        ("rs", "pub fn f_1_decides_1(x: f64, y: f64) -> bool {"),
        ("c", "int f_1_decides_1(double x, double y) {"),
        ("py", "def f_1_decides_1(x, y):"),
    ] {
        let path = target.join(format!("guard-stability.{ending}"));
        let code = fs::read_to_string(path).expect("it was written");
        assert!(code.contains(head) && code.contains("f_1_certified"), "{code}");
    }
    let json = fs::read_to_string(target.join("guard-stability.json")).expect("it was written");
    let value: serde_json::Value = serde_json::from_str(&json).expect("it is JSON");
    let decision = &value["bounds"][0]["formats"][1]["decisions"][0];
    assert_eq!(decision["function"], "f_1_decides_1");
    assert!(decision["wrong_near_ties"].as_u64() > Some(0), "{decision}");
}

/// Digits over nanoseconds of formulas of one's own, of either kind of file.
#[test]
fn formulas_of_a_file_are_charted_in_every_system() {
    let dir = scratch("chart-file");
    let file = dir.join("two.fpcore");
    let text = "(FPCore (x) :name \"f\" :pre (<= 1 x 1000) (- (/ 1 x) (/ 1 (+ x 1))))";
    fs::write(&file, text).expect("it is writable");
    let file = file.to_str().expect("UTF-8");
    let target = dir.join("out");
    let run = kane(&["chart", file, "--quick", "--out", target.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    for system in ["f32", "f64", "double-double", "interval", "rational"] {
        assert!(run.stdout.contains(system), "{}", run.stdout);
    }
    assert!(run.stdout.contains("repair 1"), "{}", run.stdout);
    for ending in ["txt", "md", "html", "tex", "json", "csv", "svg"] {
        let path = target.join(format!("two-prices.{ending}"));
        assert!(path.is_file(), "{} is missing", path.display());
    }
    let document = document(&dir, "one.md", "var x > 0\nlet f := x + 1");
    let run = kane(&["chart", &document, "--quick", "--range", "x=1..2", "--format", "json"]);
    let value: serde_json::Value = serde_json::from_str(&run.stdout).expect("it is JSON");
    assert_eq!(value["schema"]["name"], "kane-prices");
    assert_eq!(value["formulas"][0]["ways"][0]["form"], "given");
    assert_eq!(kane(&["chart", &document, "--range", "y=1..2"]).code, 2);
    assert_eq!(kane(&["chart", "--range", "y=1..2"]).code, 2);
    let none = crate::document(&dir, "none.md", "var x > 0\nclaim pos: x > 0");
    assert_eq!(kane(&["chart", &none]).code, 3);
}

#[test]
fn ranges_and_fpcore_that_cannot_be_read_are_bad_input() {
    let dir = scratch("stability-bad-floats");
    let file = document(&dir, "one.md", "var x > 0\nlet f := x + 1");
    for (range, why) in
        [("x", "name=from..to"), ("y=1..2", "the inputs are: x"), ("x=2..1", "empty")]
    {
        let run = kane(&["stability", &file, "--range", range]);
        assert_eq!(run.code, 2, "{range}");
        assert!(run.stderr.contains(why), "{range}: {}", run.stderr);
    }
    let bad = dir.join("bad.fpcore");
    fs::write(&bad, "(FPCore (x)\n (sin x))").expect("it is writable");
    let run = kane(&["stability", bad.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("bad.fpcore:2:3") && run.stderr.contains('^'), "{}", run.stderr);
}

#[test]
fn without_formulas_there_is_nothing_to_examine() {
    let dir = scratch("stability-nothing");
    let file = document(&dir, "none.md", "var x > 0\nclaim pos: x > 0");
    assert_eq!(kane(&["stability", &file]).code, 3);
}

#[test]
fn what_cannot_be_read_is_bad_input() {
    let dir = scratch("stability-bad");
    let file = document(&dir, "bad.md", "let f := 1/");
    for name in [file.as_str(), "no-such-file.md"] {
        let run = kane(&["stability", name]);
        assert_eq!(run.code, 2);
        assert!(run.stdout.is_empty() && !run.stderr.is_empty());
    }
}

#[test]
fn help_shows_examples() {
    for (verb, example) in
        [("stability", "--out maps"), ("chart", "--quick"), ("chart", "--growth")]
    {
        let run = kane(&[verb, "--help"]);
        assert_eq!(run.code, 0);
        assert!(run.stdout.contains("Examples:") && run.stdout.contains(example));
    }
}

#[test]
fn a_quick_chart_has_all_its_parts() {
    let dir = scratch("chart");
    let run = kane(&["chart", "--quick", "--out", dir.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    for part in ["wang-su-li  k", "rational", "rustc", "\nmethod ", "\nlaw in rational  ", "  • "]
    {
        assert!(run.stdout.contains(part), "{part} is missing from\n{}", run.stdout);
    }
    // a row is read by its name, and marked by the sign that the text above it tells of
    let page = fs::read_to_string(dir.join("chart.html")).expect("it was written");
    for part in ["<th scope=\"row\">law in rational</th>", ">•</td>", "• nothing else is both"]
    {
        assert!(page.contains(part), "{part} is missing from the page");
    }
    for ending in ["md", "json", "csv", "svg"] {
        assert!(dir.join(format!("chart.{ending}")).is_file());
    }
}

#[test]
fn quick_growth_has_all_its_parts() {
    let dir = scratch("growth");
    let run = kane(&["chart", "--growth", "--quick", "--out", dir.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    for part in ["a row, ns", "Bounces in a chain: wang-su-li", "in the audit", "rustc"] {
        assert!(run.stdout.contains(part), "{part} is missing from\n{}", run.stdout);
    }
    for ending in [".md", ".json", ".csv", "-batch.svg", "-chain.svg", "-audit.svg"] {
        assert!(dir.join(format!("growth{ending}")).is_file(), "{ending}");
    }
}

#[test]
fn inputs_of_either_sign_and_three_of_them_are_shown() {
    let dir = scratch("stability-signs");
    let text = "var x, a, b, c\nlet f := x*x - 2\nlet h := b*b - 4*a*c\nlet g := d(x^2, x) + 1";
    let file = document(&dir, "signs.md", text);
    let run = kane(&["stability", &file]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("2 formulas in f32 and f64: 2 fail somewhere; 1 left out"));
    assert!(
        run.stdout.contains("[-1.41") && run.stdout.contains("points  as at"),
        "{}",
        run.stdout
    );
    assert!(run.stdout.contains("Left out\n  g: it has a derivative"), "{}", run.stdout);
}
