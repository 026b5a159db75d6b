//! The checker in Python accepts every certificate, with the verdict that the report shows.
//!
//! It shares nothing with the kernel but the two pages that it was written from. Where Python is not
//! installed these tests say so and check nothing; with `KANE_REQUIRE_JUDGES=1`, as in the gate, that
//! is a failure.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;

use crate::many::{self, share};
use crate::support::{installed, pages, root};

/// What `kane audit` found of a document.
struct Audited {
    certificate: PathBuf,
    report: Value,
}

/// Audits a document of a folder; nothing is found of one that cannot be read.
fn audited(folder: &str, name: &str) -> Option<Audited> {
    let stem = name.strip_suffix(".md").expect("a page");
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("second_checker").join(stem);
    if out.exists() {
        fs::remove_dir_all(&out).expect("the last run's directory can be removed");
    }
    let output = Command::new(env!("CARGO_BIN_EXE_kane"))
        .current_dir(root())
        .args(["audit", &format!("{folder}/{name}"), "--format", "json", "--certificates"])
        .arg(&out)
        .stdin(Stdio::null())
        .output()
        .expect("kane starts");
    if output.status.code() == Some(2) {
        return None;
    }
    let certificate = out.join(format!("{stem}.cert.json"));
    assert!(certificate.exists(), "{name}: {}", said(&output));
    Some(Audited { certificate, report: json(&output.stdout) })
}

/// Python with these arguments, in a folder of the checkout.
fn python(folder: &str, arguments: &[&str]) -> Output {
    Command::new("python3")
        .current_dir(root().join(folder))
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .expect("python3 starts")
}

fn said(output: &Output) -> String {
    let text = [&output.stdout[..], &output.stderr[..]].concat();
    String::from_utf8_lossy(&text).into_owned()
}

fn json(text: &[u8]) -> Value {
    serde_json::from_slice(text).expect("kane wrote JSON")
}

/// Labels and verdicts of the claims in a list of a report or certificate.
fn verdicts(report: &Value, list: &str) -> Vec<(String, String)> {
    let entries = report.pointer(list).and_then(Value::as_array).expect("the list is there");
    let word = |entry: &Value, key: &str| entry[key].as_str().unwrap_or_default().to_owned();
    let is_claim = |entry: &&Value| entry.get("kind").is_none_or(|kind| kind == "claim");
    let label = |entry: &Value| word(entry, "label").trim_matches(['(', ')']).trim().to_owned();
    entries.iter().filter(is_claim).map(|entry| (label(entry), word(entry, "verdict"))).collect()
}

/// Checks these documents of a folder; how many of them were read, and how many links they have.
fn checked(folder: &str, pages: impl IntoIterator<Item = (String, Vec<u8>)>) -> (usize, usize) {
    let mut audits = Vec::new();
    for (name, text) in pages {
        match audited(folder, &name) {
            Some(found) => audits.push((name, found)),
            None => assert!(text.starts_with(b"<!-- error: "), "{name} cannot be read"),
        }
    }
    let mut arguments = vec!["scripts/check_cert.py".to_owned()];
    for (name, found) in &audits {
        let path = found.certificate.to_str().expect("a UTF-8 name");
        arguments.extend([format!("{folder}/{name}"), path.to_owned()]);
        let certificate = json(&fs::read(path).expect("kane wrote it"));
        let shown = verdicts(&found.report, "/documents/0/statements");
        assert_eq!(verdicts(&certificate, "/claims"), shown, "{name}");
    }
    let output = python("", &arguments.iter().map(String::as_str).collect::<Vec<_>>());
    let answer = said(&output);
    let other: Vec<&str> = answer.lines().filter(|line| !line.starts_with("yes")).collect();
    assert!(output.status.success(), "the second checker does not accept:\n{}", other.join("\n"));
    let all = answer.lines().filter(|line| *line == "yes  all accepted").count();
    assert_eq!(all, audits.len(), "each document has its answer");
    let is_link = |line: &&str| line.starts_with("yes") && line.contains(" link ");
    (audits.len(), answer.lines().filter(is_link).count())
}

#[test]
fn the_second_checker_accepts_every_shipped_document() {
    if installed("python3") {
        let (documents, links) = checked("docs/derivations", pages("docs/derivations"));
        println!("second checker: {documents} shipped documents, {links} links");
        assert!(documents >= 8 && links >= 600, "{documents} documents with {links} links");
    }
}

#[test]
fn the_second_checker_accepts_every_rule_of_the_language() {
    if installed("python3") {
        let folder = "tests/conformance/semantics";
        let (documents, links) = checked(folder, share(pages(folder)));
        println!("second checker: {documents} documents of rules, {links} links");
        let least = if many::all() { (80, 800) } else { (15, 150) };
        assert!(documents >= least.0 && links >= least.1, "{documents} documents, {links} links");
    }
}

#[test]
fn the_second_checker_rejects_what_is_forged() {
    if installed("python3") {
        let tests = ["-m", "unittest", "discover", "-s", "check_cert/tests", "-t", "."];
        let output = python("scripts", &tests);
        assert!(output.status.success(), "{}", said(&output));
    }
}
