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
    for part in ["wang-su-li  k", "rational", "rustc", "\n*  "] {
        assert!(run.stdout.contains(part), "{part} is missing from\n{}", run.stdout);
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
    for ending in ["md", "json", "csv", "svg"] {
        assert!(dir.join(format!("growth.{ending}")).is_file());
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
