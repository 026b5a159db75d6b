//! The faults that are planted in the kernel.
//!
//! `scripts/faults/run` plants them and says which test catches each, which takes its time; here the
//! list is held against the sources.

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
