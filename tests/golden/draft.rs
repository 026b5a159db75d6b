//! Papers of the field in LaTeX, written for this test, as drafts: what is read, what is guessed, and what
//! is left to the author.

use std::path::{Path, PathBuf};
use std::process::Command;

use kane::audit::{Options, audit, read};

use crate::settings;

fn papers() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/drafts");
    let entries = std::fs::read_dir(folder).expect("the papers are there");
    let mut papers: Vec<PathBuf> =
        entries.map(|entry| entry.expect("the folder is readable").path()).collect();
    papers.sort();
    papers
}

/// What the program prints of a paper, and on standard error.
fn drafted(paper: &Path) -> (String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_kane"));
    let name = Path::new("tests/drafts").join(paper.file_name().expect("it is a file"));
    let output = command
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .arg("draft")
        .arg(name)
        .output()
        .expect("the program starts");
    assert!(matches!(output.status.code(), Some(0 | 1)), "{}", paper.display());
    let text = |bytes| String::from_utf8(bytes).expect("what is printed is UTF-8");
    (text(output.stdout), text(output.stderr))
}

#[test]
fn papers_become_drafts() {
    for paper in papers() {
        let name = paper.file_stem().expect("it has a name").to_string_lossy().into_owned();
        let (document, notes) = drafted(&paper);
        settings().bind(|| insta::assert_snapshot!(name, format!("{document}\n---\n{notes}")));
    }
}

/// A draft is a document: the reader takes it as it is, and every statement of it gets a verdict.
#[test]
fn a_draft_can_be_audited() {
    for paper in papers() {
        let (document, _) = drafted(&paper);
        let read = read("draft.md", document.as_bytes());
        let document = read.unwrap_or_else(|faults| panic!("{}: {}", paper.display(), faults[0]));
        assert!(!document.statements.is_empty(), "{}", paper.display());
        let judged = audit(document, &Options::default(), &mut |_, _| {});
        assert_eq!(judged.judgements.len(), judged.document.statements.len());
    }
}
