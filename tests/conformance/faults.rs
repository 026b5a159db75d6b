//! The faults that are planted in the kernel, and the table of the tests that catch them.
//!
//! `scripts/faults/run` plants them, which takes its time; here the list and the table are held
//! against the sources.

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

/// The rows of the table: file, fault, and the tests that catch it.
fn table() -> Vec<(String, String, Vec<String>)> {
    let text =
        read_to_string(root().join("docs/data/kernel-faults.csv")).expect("the table is there");
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("file,fault,caught by"));
    let row = |line: &str| {
        let (file, rest) = line.split_once(',').expect("three columns");
        let (says, tests) = rest.rsplit_once(',').expect("three columns");
        let tests = tests.split(' ').map(str::to_string).collect();
        (file.to_string(), says.trim_matches('"').to_string(), tests)
    };
    lines.map(row).collect()
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

#[test]
fn every_planted_fault_is_caught_by_a_test_that_exists() {
    let (faults, table) = (faults(), table());
    let listed: Vec<_> = faults.iter().map(|f| (&f.file, &f.says)).collect();
    let caught: Vec<_> = table.iter().map(|(file, says, _)| (file, says)).collect();
    assert_eq!(caught, listed, "scripts/faults/run --only TEXT adds rows");
    for (file, says, tests) in &table {
        for test in tests {
            let (module, name) = test.split_once("::").expect("module::test");
            let path = root().join(format!("crates/kernel/tests/rules/{module}.rs"));
            let source = read_to_string(path).expect("a module of the kernel's tests");
            assert!(source.contains(&format!("#[test]\nfn {name}()")), "{file}: {says}: {test}");
        }
    }
}
