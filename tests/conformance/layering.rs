//! The order of the crates, and what the trusted one links.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;

use cargo_metadata::{Metadata, MetadataCommand};

/// Each crate with its level. An edge goes down by at least one level.
const LEVELS: [(&str, u32); 21] = [
    ("kane-number", 0),
    ("kane-kernel", 0),
    ("kane-semidefinite", 0),
    ("kane-algebra", 1),
    ("kane-latex", 2),
    ("kane-impact", 2),
    ("kane-floats", 2),
    ("kane-audit", 3),
    ("kane-matrix", 4),
    ("kane-judges", 4),
    ("kane-measure", 4),
    ("kane-scene", 4),
    ("kane-records", 4),
    ("kane-report", 5),
    ("kane-editor", 6),
    ("kane", 7),
    ("kane-pages", 8),
    ("kane-lake", 6),
    ("kane-python", 6),
    // examples of other projects
    ("as-a-test", 8),
    ("in-an-engine", 8),
];

/// All that the kernel may stand on.
const GROUND: [&str; 4] = ["num-bigint", "num-integer", "num-rational", "num-traits"];

/// Lines of code in the kernel: it must stay small enough to be read in an evening. The aim is 1,500;
/// see docs/decisions/0007 for what is between.
const KERNEL_LINES: usize = 2_350;

fn metadata() -> Metadata {
    MetadataCommand::new()
        .manifest_path(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml"))
        .exec()
        .expect("cargo describes its own workspace")
}

#[test]
fn a_lower_crate_never_knows_a_higher_one() {
    let levels = BTreeMap::from(LEVELS);
    let metadata = metadata();
    let members = metadata.workspace_packages();
    let names: BTreeSet<&str> = members.iter().map(|package| package.name.as_str()).collect();
    assert_eq!(
        names,
        levels.keys().copied().collect(),
        "every member of the workspace has a level"
    );
    for package in members {
        // a crate may ask itself, in its tests, for features that are off by default
        let others =
            package.dependencies.iter().filter(|dependency| dependency.name != *package.name);
        for dependency in others {
            let (Some(from), Some(to)) =
                (levels.get(package.name.as_str()), levels.get(dependency.name.as_str()))
            else {
                continue;
            };
            assert!(from > to, "{} must not know {}", package.name, dependency.name);
        }
    }
}

/// What is linked with the kernel: normal dependencies, and theirs; build scripts only look at the
/// compiler. Its features are its own: in the metadata of the workspace they are those that anybody asks
/// for, and the query engine of `kane-lake` asks for many.
#[test]
fn the_kernel_links_the_num_family_alone() {
    let mut tree = Command::new(env!("CARGO"));
    tree.args(["tree", "-p", "kane-kernel", "-e", "normal", "--prefix", "none", "--format", "{p}"]);
    let output = tree.current_dir(env!("CARGO_MANIFEST_DIR")).output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).expect("it is text");
    let mut names: BTreeSet<&str> =
        text.lines().filter_map(|line| line.split_whitespace().next()).collect();
    assert!(names.remove("kane-kernel"), "{text}");
    assert_eq!(names, BTreeSet::from(GROUND));
}

#[test]
fn the_kernel_can_be_read_in_an_evening() {
    let mut files: Vec<_> = Vec::new();
    collect(&Path::new(env!("CARGO_MANIFEST_DIR")).join("crates/kernel/src"), &mut files);
    let lines: usize = files.iter().map(|file| code_lines(file)).sum();
    println!("the kernel has {lines} lines of code");
    assert!(lines > 0 && lines < KERNEL_LINES, "the kernel has {lines} lines of code");
}

/// All Rust files under `dir`.
fn collect(dir: &Path, files: &mut Vec<String>) {
    for entry in std::fs::read_dir(dir).expect("the source is there") {
        let path = entry.expect("the source is readable").path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(std::fs::read_to_string(&path).expect("the source is UTF-8"));
        }
    }
}

/// Lines that are neither blank nor comment, up to the tests at a file's end.
fn code_lines(source: &str) -> usize {
    let code = source.split("#[cfg(test)]").next().unwrap_or_default();
    let counts = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with("//");
    code.lines().filter(counts).count()
}
