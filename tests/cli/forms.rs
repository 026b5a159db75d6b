//! What is printed: formats, selections, explanations; the same bytes every time.

use std::path::Path;

use serde_json::Value;

use crate::{command, document, finish, kane, scratch};

#[test]
fn the_news_come_first() {
    let run = kane(&["audit"]);
    let news = run.stdout.lines().nth(1).expect("there is a second line");
    assert!(news.starts_with("29 equations, "), "{news}");
    assert!(news.contains("; refuted as printed: (1)"), "{news}");
}

#[test]
fn the_paper_ends_with_where_its_question_is_answered() {
    let pointer = |output: &str| {
        let line = output.lines().rev().nth(1).unwrap_or_default();
        line.split_once(" answers ").map(|(page, _)| page.to_owned())
    };
    let page = pointer(&kane(&["audit"]).stdout).expect("a line before the last");
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join(page);
    assert!(std::fs::read_to_string(page).is_ok_and(|text| text.contains("# Kane's puzzle")));
    let other = kane(&["audit", "docs/derivations/bouncing-ball.md"]);
    assert_eq!(pointer(&other.stdout), None);
}

#[test]
fn there_is_no_colour_in_a_pipe() {
    for arguments in [&["audit"][..], &["audit", "--explain", "16"], &["audit", "--help"]] {
        for (name, value) in [("CLICOLOR", "1"), ("CLICOLOR_FORCE", "0")] {
            let output = command().args(arguments).env(name, value).output();
            let run = finish(output.expect("the program starts"));
            assert!(!run.stdout.contains('\u{1b}'), "{arguments:?} with {name}={value}");
        }
    }
}

#[test]
fn json_follows_its_documented_schema() {
    let run = kane(&["audit", "--format", "json"]);
    crate::schemas::assert_valid("audit", &run.stdout);
    let report: Value = serde_json::from_str(&run.stdout).expect("it is JSON");
    assert_eq!(report["schema"]["name"], "kane-audit");
    assert_eq!(report["schema"]["version"], 1);
    assert_eq!(report["documents"][0]["command"], "kane audit");

    let schema = include_str!("../../docs/report-schema.md");
    let mut undocumented = Vec::new();
    fields(&report, &mut |field| {
        if !schema.contains(&format!("`{field}`")) {
            undocumented.push(field.to_owned());
        }
    });
    assert!(undocumented.is_empty(), "not in docs/report-schema.md: {undocumented:?}");
}

/// Calls `see` with the name of every field, at any depth.
fn fields(value: &Value, see: &mut impl FnMut(&str)) {
    match value {
        Value::Object(object) => object.iter().for_each(|(name, value)| {
            see(name);
            // the counts by verdict are a table: its keys are verdicts, not fields
            if name != "verdicts" {
                fields(value, see);
            }
        }),
        Value::Array(array) => array.iter().for_each(|value| fields(value, see)),
        _ => {}
    }
}

#[test]
fn several_documents_are_one_json_value() {
    let dir = scratch("json");
    let one = document(&dir, "one.md", "var x > 0\nclaim a: x > 0");
    let two = document(&dir, "two.md", "var x > 0\nclaim b: x < 0");
    let run = kane(&["audit", &one, &two, "--format", "json"]);
    let report: Value = serde_json::from_str(&run.stdout).expect("it is JSON");
    assert_eq!(report["documents"].as_array().map(Vec::len), Some(2));
    assert_eq!(report["as_expected"], false);
    assert_eq!(report["documents"][0]["as_expected"], true);
}

#[test]
fn a_number_finds_its_equation() {
    let bare = kane(&["audit", "--only", "9", "--format", "json"]);
    let full = kane(&["audit", "--only", "(9)", "--format", "json"]);
    let label = |text: &str| {
        let report: Value = serde_json::from_str(text).expect("it is JSON");
        let statements =
            report["documents"][0]["statements"].as_array().cloned().unwrap_or_default();
        statements
            .iter()
            .map(|s| s["label"].as_str().unwrap_or_default().to_owned())
            .collect::<Vec<_>>()
    };
    assert_eq!(bare.code, 0);
    assert_eq!(label(&bare.stdout), ["(9)"]);
    assert_eq!(label(&full.stdout), ["(9)"]);
}

#[test]
fn several_statements_can_be_chosen() {
    let run = kane(&["audit", "--only", "1", "--only", "(1r)"]);
    assert_eq!(run.code, 0, "{}", run.stdout);
    assert!(run.stdout.contains("1 equation, 2 claims: 1 proved, 1 refuted"), "{}", run.stdout);
}

#[test]
fn an_explanation_ends_in_what_the_kernel_accepted() {
    let run = kane(&["audit", "--explain", "16"]);
    assert_eq!(run.code, 0, "{}", run.stdout);
    assert!(run.stdout.starts_with("claim (16): "), "{}", run.stdout);
    assert!(run.stdout.contains("the kernel accepted certificate"), "{}", run.stdout);
    assert!(run.stdout.contains("rests on"), "{}", run.stdout);
}

#[test]
fn explanations_of_several_statements_follow_each_other() {
    let run = kane(&["audit", "--explain", "16", "--explain", "(9)"]);
    assert_eq!(run.code, 0, "{}", run.stdout);
    let [first, second] = ["claim (9): ", "claim (16): "].map(|head| run.stdout.find(head));
    assert!(first.is_some() && second.is_some(), "{}", run.stdout);
}

#[test]
fn a_sum_of_hundreds_of_products_is_counted_and_not_written_out() {
    let limits = "tests/conformance/semantics/limits-of-formulas-of-mechanics.md";
    let run = kane(&["audit", limits, "--explain", "of-a-quotient"]);
    assert_eq!(run.code, 0, "{}", run.stdout);
    let counted = |line: &str| {
        let (_, after) = line.split_once("A sum of ")?;
        after.split_once(" products, which the certificate lists, is 0")?.0.parse::<usize>().ok()
    };
    let most = run.stdout.lines().filter_map(counted).max();
    assert!(most.is_some_and(|most| most > 100), "{most:?}");
}

#[test]
fn a_document_comes_from_standard_input_too() {
    let dir = scratch("stdin");
    let path = document(&dir, "a.md", "var x\nclaim a: |x|² >= 0");
    let out = dir.join("out");
    let piped = |arguments: &[&str]| {
        let file = std::fs::File::open(&path).expect("it was written just now");
        finish(command().args(arguments).stdin(file).output().expect("the program starts"))
    };
    let run = piped(&["audit", "-", "--out", &out.to_string_lossy()]);
    assert_eq!(run.code, 0, "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("1 claim"), "{}", run.stdout);
    assert!(out.join("stdin.html").exists());
    let twice = piped(&["audit", "-", "-"]);
    assert_eq!((twice.code, twice.stdout.as_str()), (2, ""), "{}", twice.stderr);
    assert!(twice.stderr.contains("can be read once"), "{}", twice.stderr);
    // `-` is no file, so a wrong document names where it came from
    let bad = document(&dir, "bad.md", "var x\nclaim a: x >");
    let file = std::fs::File::open(bad).expect("it was written just now");
    let run =
        finish(command().args(["audit", "-"]).stdin(file).output().expect("the program starts"));
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("--> standard input:"), "{}", run.stderr);
}

#[test]
fn two_runs_print_the_same_bytes() {
    for format in ["text", "json", "markdown"] {
        let [first, second] = [0, 1].map(|_| kane(&["audit", "--format", format]).stdout);
        assert!(first == second, "{format} differs between two runs");
    }
}

#[test]
fn an_explanation_calls_no_true_premise_undefined() {
    let dir = scratch("undefined");
    let statements = "var x, y, z\ngiven g: y = 5/2*z\nclaim a: y/x = 1 from g";
    let document = document(&dir, "undef.md", statements);
    let run = kane(&["audit", &document, "--explain", "a"]);
    assert!(run.stdout.contains("ill-defined"), "{}", run.stdout);
    assert!(
        run.stdout.contains("y/x = 1 is undefined (division by zero: x = 0)"),
        "{}",
        run.stdout
    );
    assert!(run.stdout.contains("g, y = 5/2*z: 1 = 1"), "{}", run.stdout);
    assert_eq!(
        run.stdout.matches("is undefined").count(),
        run.stdout.matches("y/x = 1 is undefined").count()
    );
}
