//! The documents that are shipped: they audit as their authors expect, and no page leads nowhere.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use kane::audit::{Judgement, Options, Verdict, audit, read};
use kane::report::{Report, Summary, html};

use crate::support::{assert_snapshot, root};

/// Coefficient operations from which a claim stands in the table of slow ones; they are the same on every machine.
const LONG: u64 = 10_000_000;

/// The Markdown files right under `folder`, sorted.
fn pages(folder: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join(folder)).expect("the folder is there");
    let mut pages: Vec<PathBuf> = entries
        .map(|entry| entry.expect("the folder is readable").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "md"))
        .collect();
    pages.sort();
    pages
}

#[test]
fn every_shipped_document_audits_as_expected() {
    let documents = pages("docs/derivations");
    assert!(documents.len() >= 7, "the paper, three questions that it raises and three small ones");
    let (mut surprises, mut slow) = (Vec::new(), String::new());
    for path in documents {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let bytes = fs::read(&path).expect("the document is readable");
        let document = match read(&name, &bytes) {
            Ok(document) => document,
            Err(faults) => panic!("{}", faults.iter().map(ToString::to_string).collect::<String>()),
        };
        let audit = audit(document, &Options::default(), &mut |_, _| {});
        let summary = Summary::of(&Report::new(&audit, "kane audit"));
        println!("{name}: {}", summary.headline());
        let page = html(&Report::new(&audit, "kane audit")).len();
        // formulas of proofs are MathML, twice the bytes of slanted letters (decision 0017)
        assert!(page < 1_400_000, "the page of {name} has {page} bytes");
        surprises.extend(summary.surprises.iter().map(|label| format!("{name}: {label}")));
        for (statement, judgement) in audit.document.statements.iter().zip(&audit.judgements) {
            // what is shipped as an example of an open claim says so
            let is_open = judgement.verdict == Verdict::Undecided;
            if is_open && judgement.expect != Some(Verdict::Undecided) {
                surprises.push(format!("{name}: {} is undecided", statement.label));
            }
            if let Some(row) = slow_row(judgement) {
                let _ = writeln!(slow, "{name} | {} | {row}", statement.label);
            }
        }
    }
    assert!(surprises.is_empty(), "not as expected:\n{}", surprises.join("\n"));
    assert_snapshot("slow_claims", &slow);
}

/// The verdict on a claim that takes long and what of it does; `None` where none of its links takes long.
fn slow_row(judgement: &Judgement) -> Option<String> {
    let longest = judgement.links.iter().max_by_key(|link| link.work)?;
    let row = || format!("{} | {}", judgement.verdict, longest.burden());
    (longest.work >= LONG).then(row)
}

#[test]
fn the_paper_needs_no_groebner_basis() {
    let path = root().join("docs/derivations/oblique-collision.md");
    let bytes = fs::read(&path).expect("the paper is readable");
    let document = read("oblique-collision.md", &bytes).expect("the paper is well formed");
    let mut options = Options::default();
    options.budget.ideals = false;
    let audit = audit(document, &options, &mut |_, _| {});
    let undecided = audit.judgements.iter().filter(|j| j.conditional == Verdict::Undecided).count();
    assert_eq!(undecided, 0, "claims that are undecided without ideals");
    assert!(audit.as_expected(), "without ideals the verdicts stay as expected");
}

/// Links of the form `](target)` to files of this repository.
#[test]
fn no_page_links_to_nowhere() {
    let mut dead = Vec::new();
    for page in ["", "docs", "docs/derivations", "docs/decisions"].into_iter().flat_map(pages) {
        let text = fs::read_to_string(&page).expect("the page is UTF-8");
        for rest in text.split("](").skip(1) {
            let target = rest.split([')', '#']).next().unwrap_or_default();
            // a formula may contain `](` too; what follows is then no name of a file
            let is_file =
                !target.contains(':') && target.contains(['.', '/']) && !target.contains(' ');
            let folder = page.parent().expect("a page is in a folder");
            if is_file && !folder.join(target).exists() {
                dead.push(format!("{}: {target}", page.display()));
            }
        }
    }
    assert!(dead.is_empty(), "links to nowhere:\n{}", dead.join("\n"));
}

/// `crates/measure` builds from its package alone, which takes nothing from outside of it.
#[test]
fn the_equal_forms_that_a_crate_carries_are_those_that_are_shipped() {
    let shipped = fs::read(root().join("docs/derivations/equal-forms.md")).expect("it is there");
    let carried = root().join("crates/measure/src/stability/equal-forms.md");
    assert_eq!(fs::read(carried).expect("it is there"), shipped);
}

/// What a package does not hold cannot be included: of a crate's sources, only files beside them; of the
/// program's, only what its list has.
#[test]
fn what_is_included_is_packaged() {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).expect("it is there");
    let folders = ["collisions", "data", "derivations", "figures", "scenes", "laws.md"];
    for folder in folders {
        assert!(manifest.contains(&format!("    \"/docs/{folder}")), "{folder} is not packaged");
    }
    let crates = fs::read_dir(root().join("crates")).expect("the folder is there");
    let mut seen = 0;
    for src in crates.map(|entry| entry.expect("readable").path().join("src")) {
        let mut sources = Vec::new();
        rust_files(&src, &mut sources);
        for path in sources {
            let text = fs::read_to_string(&path).expect("the source is UTF-8");
            let below = path.strip_prefix(&src).expect("it is in src");
            let outside = format!("include_str!(\"{}", "../".repeat(below.components().count()));
            assert!(!text.contains(&outside), "{} includes a file outside of src", path.display());
            seen += 1;
        }
    }
    assert!(seen > 300, "the sources are found");
}

/// All Rust files under `dir`.
fn rust_files(dir: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(dir).expect("the source is there") {
        let path = entry.expect("the source is readable").path();
        if path.is_dir() {
            rust_files(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}
