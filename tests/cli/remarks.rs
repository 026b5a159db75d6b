//! Verdicts beside the lines of files: SARIF, and the commands of a workflow.

use std::fs;

use serde_json::Value;

use crate::{document, kane, scratch};

const MIXED: &str = "var x > 0, y
given same: y = x
claim holds: y > 0 from same
claim (2): y > 1 from same
claim known: y > 2 from same expect refuted";

#[test]
fn sarif_has_every_claim_on_its_line() {
    let path = document(&scratch("sarif"), "a b.md", MIXED);
    let run = kane(&["audit", &path, "--format", "sarif"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let log: Value = serde_json::from_str(&run.stdout).expect("it is JSON");
    assert_eq!(log["version"], "2.1.0");
    let driver = &log["runs"][0]["tool"]["driver"];
    let rules: Vec<&Value> =
        driver["rules"].as_array().expect("a list").iter().map(|rule| &rule["id"]).collect();
    let results = log["runs"][0]["results"].as_array().expect("a list");
    let told: Vec<(&str, &str, &str, u64)> = results
        .iter()
        .map(|result| {
            assert!(rules.contains(&&result["ruleId"]), "{result}");
            let place = &result["locations"][0]["physicalLocation"];
            let uri = place["artifactLocation"]["uri"].as_str().expect("text");
            assert!(uri.ends_with("a%20b.md"), "{uri}");
            (
                result["ruleId"].as_str().expect("text"),
                result["kind"].as_str().expect("text"),
                result["level"].as_str().expect("text"),
                place["region"]["startLine"].as_u64().expect("a line"),
            )
        })
        .collect();
    assert_eq!(
        told,
        [
            ("proved", "pass", "none", 6),
            ("refuted", "fail", "error", 7),
            ("refuted", "informational", "none", 8),
        ]
    );
    let message = results[1]["message"]["text"].as_str().expect("text");
    let wanted = "claim (2): refuted: y > 1\nfalse under all that was assumed, at y = ";
    assert!(message.contains(wanted), "{message}");
}

#[test]
fn a_workflow_is_told_what_is_not_proved() {
    let path = document(&scratch("workflow"), "notes.md", MIXED);
    let run = kane(&["audit", &path, "--format", "github"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert_eq!(lines.len(), 2, "{}", run.stdout);
    assert!(lines[0].starts_with("::error file="), "{}", lines[0]);
    assert!(
        lines[0].contains("notes.md,line=7,title=claim (2)::refuted: y > 1%0A"),
        "{}",
        lines[0]
    );
    assert!(
        lines[1].starts_with("::notice file=") && lines[1].contains(",line=8,"),
        "{}",
        lines[1]
    );
}

#[test]
fn a_claim_that_rests_on_what_is_not_proved_says_on_what() {
    let text = "var x\nclaim a: x > 0\nclaim b: x > -1 from a";
    let path = document(&scratch("unsupported"), "notes.md", text);
    let run = kane(&["audit", &path, "--format", "github"]);
    let last = run.stdout.lines().last().unwrap_or_default();
    assert!(last.ends_with("::unsupported: x > -1%0Acites a, not proved; else proved"), "{last}");
}

#[test]
fn a_document_without_a_claim_is_told_and_not_passed_over() {
    let path = document(&scratch("nothing"), "empty.md", "var x > 0");
    let run = kane(&["audit", &path, "--format", "github"]);
    assert_eq!(run.code, 3, "{}", run.stderr);
    assert!(
        run.stdout.starts_with("::error file=") && run.stdout.contains("empty.md,title=no claim::")
    );
    let sarif = kane(&["audit", &path, "--format", "sarif"]);
    assert_eq!(sarif.code, 3);
    assert!(sarif.stdout.contains("\"kind\": \"fail\""), "{}", sarif.stdout);
}

#[test]
fn what_cannot_be_read_is_told_beside_its_line() {
    let dir = scratch("unread");
    let path = document(&dir, "notes.md", "var x > 0\nclaim a: x == 1\nclaim b: y > 0");
    let run = kane(&["audit", &path, "--format", "github"]);
    assert_eq!(run.code, 2);
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert_eq!(lines.len(), 2, "{}", run.stdout);
    assert!(lines[0].starts_with("::error file=") && lines[0].contains("notes.md,line=5,"));
    assert!(lines[1].contains("::unknown symbol `y`%0Aa symbol is declared"), "{}", lines[1]);
    assert_eq!(run.stderr.matches("error: ").count(), 2, "people are told as ever");
    let sarif: Value = serde_json::from_str(&kane(&["audit", &path, "--format", "sarif"]).stdout)
        .expect("it is JSON");
    assert_eq!(sarif["runs"][0]["results"].as_array().map(Vec::len), Some(2));
    assert_eq!(kane(&["audit", &path]).stdout, "", "a report is not begun");

    let gone = dir.join("gone.md");
    let run = kane(&["audit", &path, gone.to_str().expect("UTF-8"), "--format", "github"]);
    assert_eq!(run.code, 2);
    let missing = run.stdout.lines().find(|line| line.contains("gone.md"));
    assert!(missing.is_some_and(|l| l.starts_with("::error file=") && l.contains("cannot read")));

    let log = dir.join("log.csv");
    fs::write(&log, "time,speed\n1,2\n").expect("writable");
    let log = log.to_str().expect("UTF-8");
    let run = kane(&["check", log, "--format", "github"]);
    assert_eq!(run.code, 2);
    assert!(run.stdout.starts_with("::error file=") && run.stdout.contains("columns are missing"));
    assert!(run.stderr.contains("columns are missing"), "{}", run.stderr);
}

#[test]
fn a_row_that_fails_is_told_beside_its_line() {
    let path = scratch("rows").join("log.csv");
    let log = "mass,radius,inertia,mu,e,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n\
               1,1,0.4,0.25,0.5,2,-1,0,1.625,0.5,-0.9375\n\
               1,1,0.4,0.25,0.5,2,-1,0,1.625,0.5,-0.9\n\
               1,1,0.4,0.25,0.5,fast,-1,0,1.625,0.5,-0.9375\n";
    fs::write(&path, log).expect("writable");
    let path = path.to_str().expect("UTF-8");
    let run = kane(&["check", path, "--format", "github"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    assert!(
        run.stdout.lines().any(|l| l.contains("log.csv,line=3,title=the impulse acts")),
        "{}",
        run.stdout
    );
    assert!(run.stdout.lines().any(|l| l.contains("log.csv,line=4,title=")), "{}", run.stdout);
    let sarif = kane(&["check", path, "--format", "sarif"]);
    let sarif: Value = serde_json::from_str(&sarif.stdout).expect("it is JSON");
    let results = sarif["runs"][0]["results"].as_array().expect("a list");
    let failing = results.iter().filter(|result| result["kind"] == "fail");
    let lines: Vec<_> = failing
        .map(|result| &result["locations"][0]["physicalLocation"]["region"]["startLine"])
        .collect();
    assert!(lines.iter().any(|line| **line == 3) && lines.iter().any(|line| **line == 4));
    let compared = kane(&["check", path, "--baseline", path, "--format", "sarif"]);
    assert_eq!(compared.code, 2);
}

/// The step of `action.yml`, with these lists.
#[cfg(unix)]
fn step(dir: &std::path::Path, documents: &str, logs: &str) -> crate::Run {
    let script = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scripts/annotate");
    let mut bash = std::process::Command::new("bash");
    bash.arg(script).current_dir(dir).env("KANE", env!("CARGO_BIN_EXE_kane"));
    bash.env("DOCUMENTS", documents).env("LOGS", logs).env("SARIF", dir.join("sarif"));
    crate::finish(bash.output().expect("bash starts"))
}

#[test]
#[cfg(unix)]
fn a_step_of_a_workflow_reads_all_lines_and_patterns_of_its_lists() {
    let dir = scratch("step");
    fs::create_dir(dir.join("more")).expect("writable");
    document(&dir, "good.md", "var x > 0\nclaim holds: x > 0");
    document(&dir.join("more"), "bad.md", "var x > 0\nclaim false: x > 1");
    let run = step(&dir, "good.md\nmore/*.md\n", "");
    assert_eq!(run.code, 1, "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("::error file=more/bad.md,line=5,"), "{}", run.stdout);
    let sarif = fs::read_to_string(dir.join("sarif/documents.sarif")).expect("it was written");
    let sarif: Value = serde_json::from_str(&sarif).expect("it is JSON");
    assert_eq!(sarif["runs"][0]["results"].as_array().map(Vec::len), Some(2));
    assert_eq!(step(&dir, "good.md", "").code, 0);
    assert_eq!(step(&dir, "good.md none/*.md", "").code, 2, "a pattern without a file");
    assert_eq!(step(&dir, " \n", "").code, 3, "nothing is checked");
}

/// A pull request may bring files of any name.
#[test]
#[cfg(unix)]
fn a_file_that_is_called_as_a_flag_is_a_file_to_a_step_of_a_workflow() {
    let dir = scratch("step-flag");
    for name in ["--only=other.md", "--out=x.md", "good.md"] {
        document(&dir, name, "var x > 0\nclaim other: x > 0\nclaim false: x > 1");
    }
    fs::write(dir.join("--schema"), "mass\n").expect("writable");
    let run = step(&dir, "*.md", "--s*");
    for name in ["--only=other.md", "--out=x.md", "good.md"] {
        assert!(run.stdout.contains(&format!("::error file={name},line=6,")), "{}", run.stdout);
    }
    assert!(run.stderr.contains("--schema: "), "{}", run.stderr);
    assert_eq!(run.code, 2, "{}", run.stderr);
    assert!(!dir.join("x.md").exists());
}
