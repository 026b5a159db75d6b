//! Coq and z3 on every shipped document. Where one is not installed its test says so and checks
//! nothing; with `KANE_REQUIRE_JUDGES=1`, as in the gate, that is a failure.

use std::fs;
use std::path::Path;
use std::rc::Rc;
use std::time::Duration;

use kane::audit::{Audit, Options, audit, read};
use kane::judges::{ALLOWED_AXIOMS, Limits, coq, coq_file, z3};
use kane::kernel::{Conclusion, Expr, Link};
use kane::report::Report;
use kane::report::judges::Answer;

use crate::support::installed;

/// The shipped documents. Every link with a verdict is emitted for Coq.
const DOCUMENTS: [&str; 8] = [
    "answers-to-the-conditions.md",
    "bouncing-ball.md",
    "coupled-collision.md",
    "equal-forms.md",
    "oblique-collision.md",
    "sliding-to-rolling.md",
    "spatial-sphere.md",
    "two-body-collision.md",
];

/// The one with a witness at an algebraic number, which exists by the completeness of the reals.
const WITH_A_ROOT: &str = "coupled-collision.md";

const LIMITS: Limits = Limits { file: Duration::from_secs(300), question: Duration::from_secs(2) };

fn judged(name: &str) -> Audit {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/derivations").join(name);
    let bytes = fs::read(path).expect("the document is there");
    let document = read(name, &bytes).expect("the document is well formed");
    audit(document, &Options::default(), &mut |_, _| {})
}

#[test]
fn every_shipped_document_has_its_row() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/derivations");
    let files = fs::read_dir(folder).expect("the folder is there").count();
    assert_eq!(files, DOCUMENTS.len());
}

#[test]
fn coq_accepts_every_lemma_of_the_shipped_documents() {
    if !installed("coqc") {
        return;
    }
    for name in DOCUMENTS {
        let audit = judged(name);
        let judge = coq(&Report::new(&audit, "kane audit"), &LIMITS).expect("coqc runs");
        let others: Vec<_> =
            judge.answers.iter().filter(|(_, a)| !matches!(a, Answer::Agrees)).collect();
        assert!(others.is_empty(), "{name}: {others:?}");
        let [reals, extensionality, completeness] = ALLOWED_AXIOMS;
        let mut axioms = vec![reals, extensionality];
        if name == WITH_A_ROOT {
            axioms.insert(1, completeness);
        }
        assert_eq!(judge.axioms, axioms, "{name}: what the lemmas rest on");
    }
}

#[test]
fn z3_disagrees_on_no_claim_of_the_shipped_documents() {
    if !installed("z3") {
        return;
    }
    for name in DOCUMENTS {
        let audit = judged(name);
        let judge = z3(&Report::new(&audit, "kane audit"), &LIMITS, &|_, _| {}).expect("z3 runs");
        assert!(judge.agrees(), "{name}: {:?}", judge.answers);
        let undecided = judge.answers.values().filter(|a| matches!(a, Answer::Undecided(_)));
        println!("{name}: {} undecided by z3 in 2 s", undecided.count());
    }
}

/// A false neighbour of a true claim, with the proof of the true one.
#[test]
fn a_transplanted_proof_is_rejected() {
    let mut audit = judged("sliding-to-rolling.md");
    let statement = audit.document.statements.iter().position(|s| s.label == "(9r)");
    let statement = statement.expect("the claim is there");
    if installed("coqc") {
        let mut file = kane::report::coq::coq(&Report::new(&audit, "kane audit"));
        let lemma = file.lemmas.iter_mut().find(|l| l.statement == statement);
        let lemma = lemma.expect("it is emitted");
        let neighbour = lemma.text.replace("(Num 14 1)", "(Num 13 1)").replace("/ 14", "/ 13");
        assert_ne!(lemma.text, neighbour);
        lemma.text = neighbour;
        let judge = coq_file(&file, &LIMITS).expect("coqc runs");
        for ((i, _), answer) in &judge.answers {
            let rejected = matches!(answer, Answer::Disagrees(_));
            assert_eq!(rejected, *i == statement, "{answer:?}");
        }
    }
    if installed("z3") {
        let link = &mut audit.judgements[statement].links[0];
        let mut accepted = (**link.accepted.as_ref().expect("it is proved")).clone();
        let Conclusion::Link(Link::Relation(relation)) = &mut accepted.goal.conclusion else {
            panic!("an equation");
        };
        relation.rhs = Expr::Mul(relation.rhs.clone().into(), Expr::int(2).into());
        link.accepted = Some(Rc::new(accepted));
        let judge = z3(&Report::new(&audit, "kane audit"), &LIMITS, &|_, _| {}).expect("z3 runs");
        assert!(matches!(judge.answers[&(statement, 0)], Answer::Disagrees(_)));
    }
}

/// The statement of a lemma is compared with the data, so that neither can be changed alone.
#[test]
fn a_lemma_that_says_something_else_is_rejected() {
    if !installed("coqc") {
        return;
    }
    let audit = judged("sliding-to-rolling.md");
    let mut file = kane::report::coq::coq(&Report::new(&audit, "kane audit"));
    let changed = file.lemmas.iter_mut().find(|l| l.text.contains("= 5 / 14 * m * v_0 ^ 2.\n"));
    let changed = changed.expect("(9r) is emitted");
    changed.text = changed.text.replace("= 5 / 14 * m * v_0 ^ 2.\n", "= 5 / 13 * m * v_0 ^ 2.\n");
    let statement = changed.statement;
    let judge = coq_file(&file, &LIMITS).expect("coqc runs");
    assert!(matches!(judge.answers[&(statement, 0)], Answer::Disagrees(_)));
}
