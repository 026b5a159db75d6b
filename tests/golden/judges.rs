//! What other judges are handed: lemmas of Coq and questions in SMT-LIB.

use std::fs;
use std::path::Path;

use kane::audit::{Options, audit, read};
use kane::judges::Claims;
use kane::judges::coq::file;
use kane::judges::smt::questions;

use crate::settings;

/// The lemmas and the questions of some claims of a shipped document; of all, if none is named.
fn handed(name: &str, labels: &[&str]) -> (String, String) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/derivations").join(name);
    let bytes = fs::read(path).expect("the document is there");
    let document = read(name, &bytes).expect("the document is well formed");
    let index = |label: &&str| document.statements.iter().position(|s| s.label == **label);
    let chosen: Option<Vec<usize>> = labels.iter().map(index).collect();
    let only = chosen.filter(|c| !c.is_empty());
    let options = Options { only: only.clone(), ..Options::default() };
    let audit = audit(document, &options, &mut |_, _| {});
    let claims = match only {
        Some(only) => Claims::of(&audit).only(&only),
        None => Claims::of(&audit),
    };
    let file = file(&claims);
    let text = file.text();
    let lemmas = text.strip_prefix(&file.theory()).expect("every file begins with the theory");
    let asked = questions(&claims).into_iter().map(|(name, q)| format!("; {name}\n{}", q.text));
    (lemmas.to_owned(), asked.collect::<Vec<_>>().join("\n"))
}

fn assert_handed(name: &str, shown: &str) {
    settings().bind(|| insta::assert_snapshot!(name, shown));
}

#[test]
fn a_small_document_for_coq_and_z3() {
    let (lemmas, questions) = handed("sliding-to-rolling.md", &[]);
    assert_handed("sliding-to-rolling.v", &lemmas);
    assert_handed("sliding-to-rolling.smt2", &questions);
}

#[test]
fn claims_of_the_paper_for_coq_and_z3() {
    let labels = ["(1)", "(9)", "(9-at-0)", "(16)", "k-range", "(25)", "mirror-loss", "(29-falls)"];
    let (lemmas, questions) = handed("oblique-collision.md", &labels);
    assert_handed("paper.v", &lemmas);
    assert_handed("paper.smt2", &questions);
}

/// A limit, one from limits, what does not follow from limits, and one that is another.
#[test]
fn limits_of_the_paper_for_coq() {
    let labels = ["(11d)", "(10n)", "ab-inf", "(12v)", "(16n)", "(27-right)", "back-left"];
    assert_handed("limits.v", &handed("oblique-collision.md", &labels).0);
}

#[test]
fn an_algebraic_witness_for_coq() {
    assert_handed("algebraic.v", &handed("coupled-collision.md", &["kane-solution"]).0);
}
