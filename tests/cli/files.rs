//! `--out` writes every form for every document.

use std::fs;

use crate::{document, kane, scratch};

#[test]
fn every_document_becomes_a_file_in_every_form() {
    let dir = scratch("out");
    let one = document(&dir, "one.md", "var x > 0\nclaim a: x > 0");
    let two = document(&dir, "two.md", "var x > 0\nclaim b: x + x = 2*x");
    let reports = dir.join("new/reports");
    let target = reports.to_str().expect("UTF-8");
    let run = kane(&["audit", &one, &two, "--out", target]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("1 claim"), "the report is printed as well: {}", run.stdout);

    let mut names: Vec<_> = fs::read_dir(&reports)
        .expect("the directory was made")
        .map(|entry| entry.expect("readable").file_name().into_string().expect("UTF-8"))
        .collect();
    names.sort();
    assert_eq!(
        names,
        [
            "one", "one.html", "one.json", "one.md", "one.tex", "one.v", "two", "two.html",
            "two.json", "two.md", "two.tex", "two.v"
        ],
        "and no temporary file is left"
    );

    let question = fs::read_to_string(reports.join("two/b.smt2")).expect("one file a claim");
    assert!(question.ends_with("(check-sat)\n"), "{question}");
    let proof = fs::read_to_string(reports.join("two.v")).expect("it was written");
    assert!(proof.contains("Lemma claim_b :"), "the claim is a lemma");

    let json = fs::read_to_string(reports.join("two.json")).expect("it was written");
    assert_eq!(json, kane(&["audit", &two, "--format", "json"]).stdout);
    let markdown = fs::read_to_string(reports.join("two.md")).expect("it was written");
    assert_eq!(markdown, kane(&["audit", &two, "--format", "markdown"]).stdout);
}

#[test]
fn the_paper_s_report_has_the_paper_s_name() {
    let dir = scratch("out-paper");
    kane(&["audit", "--out", dir.to_str().expect("UTF-8")]);
    for ending in ["html", "json", "md", "tex"] {
        assert!(dir.join(format!("oblique-collision.{ending}")).is_file(), "{ending}");
    }
    // Coq compiles no file with a hyphen in its name.
    assert!(dir.join("oblique_collision.v").is_file());
}

#[test]
fn two_documents_of_one_name_are_not_written_over_each_other() {
    let dir = scratch("twins");
    fs::create_dir(dir.join("sub")).expect("the scratch directory is writable");
    let one = document(&dir, "same.md", "var x > 0\nclaim a: x > 0");
    let two = document(&dir.join("sub"), "same.md", "var x > 0\nclaim a: x > 0");
    let run = kane(&["audit", &one, &two, "--out", dir.join("out").to_str().expect("UTF-8")]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("`same`"), "{}", run.stderr);
    assert!(!dir.join("out").exists());
}

#[test]
fn a_directory_that_cannot_be_made_is_an_error() {
    let dir = scratch("blocked");
    let file = document(&dir, "file.md", "var x > 0\nclaim a: x > 0");
    let run = kane(&["audit", &file, "--out", &file]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("cannot write"), "{}", run.stderr);
}
