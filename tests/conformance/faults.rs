//! The faults that are planted in the kernel.
//!
//! `scripts/faults/run` plants them and says which test catches each, which takes its time; here the
//! list is held against the sources, and what was said against the list and the tests.

use std::fs::read_to_string;
use std::path::{Path, PathBuf};

/// A fault of the list.
struct Fault {
    file: String,
    says: String,
    old: String,
    new: String,
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn faults() -> Vec<Fault> {
    let path = root().join("scripts/faults/kernel.toml");
    let list: toml::Table =
        read_to_string(path).expect("the list").parse().expect("the list is TOML");
    let entries = list["fault"].as_array().expect("an array of faults");
    let text = |entry: &toml::Value, key: &str| {
        entry[key].as_str().expect("each part of a fault is a text").to_string()
    };
    let fault = |e: &toml::Value| Fault {
        file: text(e, "file"),
        says: text(e, "says"),
        old: text(e, "old"),
        new: text(e, "new"),
    };
    entries.iter().map(fault).collect()
}

fn sources() -> PathBuf {
    root().join("crates/kernel/src")
}

#[test]
fn every_planted_fault_still_applies() {
    for Fault { file, says, old, new } in faults() {
        let source = read_to_string(sources().join(&file)).expect("a file of the kernel");
        assert_eq!(source.matches(&old).count(), 1, "{file}: {says}: {old}");
        assert_ne!(old, new, "{file}: {says}");
    }
}

/// A cell of a table as it is written there.
fn cell(text: &str) -> String {
    match text.contains([',', '"']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_string(),
    }
}

/// Whether the kernel has a test of this name, with its module.
fn is_test(name: &str) -> bool {
    let Some((module, name)) = name.split_once("::") else {
        return false;
    };
    let path = root().join("crates/kernel/tests/rules").join(module).with_extension("rs");
    let test = format!("#[test]\nfn {name}() {{");
    read_to_string(path).is_ok_and(|text| text.replace("\r\n", "\n").contains(&test))
}

#[test]
fn every_planted_fault_was_caught_by_a_test_that_there_is() {
    let path = root().join("docs/data/kernel-faults.csv");
    let table = read_to_string(path).expect("what the last run said");
    let (faults, rows): (_, Vec<&str>) = (faults(), table.lines().skip(1).collect());
    // In the order of the list, one row a fault.
    for (Fault { file, says, .. }, row) in faults.iter().zip(&rows) {
        let tests = row.strip_prefix(&format!("{},{},", cell(file), cell(says)));
        let tests: Vec<&str> = tests.unwrap_or_default().split_whitespace().collect();
        assert!(!tests.is_empty(), "{file}: {says}: not caught, or not tried: {row}");
        for test in tests {
            assert!(is_test(test), "{file}: {says}: there is no test {test}");
        }
    }
    assert_eq!(rows.len(), faults.len(), "scripts/faults/run --missing completes the table");
}

#[test]
fn every_file_of_the_kernel_with_a_rule_in_it_has_planted_faults() {
    // What only names things: the modules, and the reasons of a rejection, and the data of a proof.
    let plain = ["lib.rs", "proof.rs", "rejection.rs"];
    let faults = faults();
    assert!(faults.len() >= 60);
    for entry in std::fs::read_dir(sources()).expect("the sources") {
        let name = entry.expect("an entry").file_name().into_string().expect("a name");
        let planted = faults.iter().filter(|f| f.file == name).count();
        assert!(plain.contains(&name.as_str()) || planted >= 5, "{name}: {planted}");
    }
}
