//! The documents that are shipped: they audit as their authors expect, and no page leads nowhere.

use std::fs;
use std::path::{Path, PathBuf};

use kane::audit::{Options, Verdict, audit, read};
use kane::report::{Report, Summary, html};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

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
    let mut surprises = Vec::new();
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
            if judgement.verdict == Verdict::Undecided {
                surprises.push(format!("{name}: {} is undecided", statement.label));
            }
        }
    }
    assert!(surprises.is_empty(), "not as expected:\n{}", surprises.join("\n"));
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
