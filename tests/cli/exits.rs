//! Exit codes: 0 as expected, 1 not, 2 bad input or usage, 3 nothing to check.

use crate::{command, document, finish, kane, scratch};

#[test]
fn the_paper_is_as_expected() {
    let run = kane(&["audit"]);
    assert_eq!(run.code, 0, "{}", run.stdout);
    assert!(run.stderr.is_empty(), "{}", run.stderr);
}

#[test]
fn a_true_claim_exits_0_and_a_false_one_1() {
    let dir = scratch("exits");
    let good = document(&dir, "true.md", "var x > 0\nclaim pos: x + 1 > 1");
    let bad = document(&dir, "false.md", "var x > 0\nclaim neg: x < 0");
    assert_eq!(kane(&["audit", &good]).code, 0);
    assert_eq!(kane(&["audit", &bad]).code, 1);
    assert_eq!(kane(&["audit", &good, &bad]).code, 1);
}

#[test]
fn an_expected_refutation_exits_0_and_a_proof_against_expectation_1() {
    let dir = scratch("expectations");
    let refuted = document(&dir, "refuted.md", "var x > 0\nclaim neg: x < 0  expect refuted");
    let proved = document(&dir, "proved.md", "var x > 0\nclaim pos: x > 0  expect refuted");
    let run = kane(&["audit", &refuted]);
    assert_eq!(run.code, 0);
    assert!(run.stdout.contains("expected"), "{}", run.stdout);
    let run = kane(&["audit", &proved]);
    assert_eq!(run.code, 1);
    assert!(run.stdout.contains("NOT EXPECTED (should be refuted)"), "{}", run.stdout);
}

#[test]
fn a_document_without_claims_exits_3() {
    let dir = scratch("nothing");
    let empty = document(&dir, "empty.md", "var x > 0\ngiven one: x = 1");
    let prose = dir.join("prose.md");
    std::fs::write(&prose, "Nothing but words.\n").expect("the scratch directory is writable");
    assert_eq!(kane(&["audit", &empty]).code, 3);
    assert_eq!(kane(&["audit", prose.to_str().expect("UTF-8")]).code, 3);
}

#[test]
fn a_file_without_a_formula_exits_3_whatever_its_form() {
    let dir = scratch("no-formula");
    for (name, text) in [("words.md", "Nothing but words.\n"), ("none.fpcore", "; none\n")] {
        let path = dir.join(name);
        std::fs::write(&path, text).expect("the scratch directory is writable");
        let path = path.to_str().expect("UTF-8");
        for verb in ["stability", "chart"] {
            let run = kane(&[verb, path]);
            let said = run.stdout + &run.stderr;
            assert_eq!(run.code, 3, "{verb} {name}: {said}");
            assert!(said.contains("no formula") || said.contains("no FPCore"), "{said}");
            assert!(!said.contains("0 fail"), "{said}");
        }
    }
}

#[test]
fn bad_usage_exits_2_and_says_how_it_goes() {
    for arguments in [
        &[][..],
        &["collide", "--colour", "red"],
        &["audit", "--format", "html"],
        &["audit", "--explain", "9", "--only", "9"],
    ] {
        let run = kane(arguments);
        assert_eq!(run.code, 2, "{arguments:?}");
        assert!(
            run.stderr.contains("--help") || run.stderr.contains("Usage: kane"),
            "{}",
            run.stderr
        );
    }
}

#[test]
fn help_shows_examples_and_exit_codes() {
    let run = kane(&["audit", "--help"]);
    assert_eq!(run.code, 0);
    for part in ["--only 9", "--explain 16", "--out reports", "Exit codes:"] {
        assert!(run.stdout.contains(part), "{part} is missing from\n{}", run.stdout);
    }
}

#[test]
fn a_reader_that_leaves_early_is_no_error() {
    use std::process::Stdio;
    let mut child = command()
        .args(["audit", "--format", "json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let run = finish(child.wait_with_output().expect("the program ends"));
    assert_eq!(run.code, 0);
    assert!(run.stderr.is_empty(), "{}", run.stderr);
}

#[test]
fn a_judge_that_is_not_installed_is_no_judge() {
    let dir = crate::scratch("judges");
    let file = crate::document(&dir, "file.md", "var x > 0\nclaim a: x > 0");
    let without = |more: &[&str]| {
        let arguments = [&["audit", &file, "--judges", "coq,z3"], more].concat();
        crate::finish(
            crate::command().env("PATH", "").args(arguments).output().expect("the program starts"),
        )
    };
    let run = without(&[]);
    assert_eq!(run.code, 3, "{}", run.stderr);
    assert!(run.stderr.contains("coqc is not installed"), "{}", run.stderr);
    let run = without(&["--optional"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("Coq: NOT CHECKED"), "{}", run.stdout);
    assert!(run.stdout.contains("z3: NOT CHECKED"), "{}", run.stdout);
}

#[test]
fn what_a_budget_does_not_reach_is_undecided_and_the_report_names_the_budget() {
    let dir = scratch("budget");
    let text = "var x\nclaim a: x^8 + 1 >= 2*x^4\nclaim b: x^2 >= 0";
    let path = document(&dir, "budget.md", text);
    let whole = kane(&["audit", &path]);
    assert_eq!(whole.code, 0, "{}", whole.stdout);
    let little = kane(&["audit", &path, "--budget", "1"]);
    assert_eq!(little.code, 1, "{}", little.stdout);
    assert!(little.stdout.contains("undecided"), "{}", little.stdout);
    assert!(little.stdout.contains("--budget 1"), "{}", little.stdout);
    let nothing = kane(&["audit", &path, "--budget", "much"]);
    assert_eq!(nothing.code, 2, "{}", nothing.stderr);
    // a number below 0 is a wrong value, no flag that might have been meant
    for flag in ["--budget", "--effort"] {
        let below = kane(&["audit", &path, flag, "-1"]);
        assert_eq!(below.code, 2, "{}", below.stderr);
        let said = format!("invalid value '-1' for '{flag}");
        assert!(below.stderr.contains(&said) && !below.stderr.contains("tip"), "{}", below.stderr);
    }
}
