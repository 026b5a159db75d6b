//! Coq and z3 on every shipped document. Where one is not installed its test says so and checks
//! nothing; with `KANE_REQUIRE_JUDGES=1`, as in the gate, that is a failure.

use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::rc::Rc;
use std::sync::LazyLock;
use std::time::Duration;

use kane::audit::{Audit, Options, Verdict, audit, read};
use kane::judges::coq::{File, NotEmitted, file};
use kane::judges::{ALLOWED_AXIOMS, Answer, Claims, Judge, Limits, Theory, ask_coq, ask_z3};
use kane::kernel::{Conclusion, Evidence, Expr, Fuel, Link, SideProof, check};

use crate::many;
use crate::support::installed;

/// The shipped documents. Every link with a verdict is emitted for Coq.
const DOCUMENTS: [&str; 13] = [
    "answers-to-the-conditions.md",
    "billiard-ball.md",
    "collision-chain.md",
    "coupled-collision.md",
    "equal-forms.md",
    "free-top.md",
    "hertz.md",
    "oblique-collision.md",
    "rolling-disc.md",
    "routh-diagram.md",
    "sliding-to-rolling.md",
    "spatial-sphere.md",
    "two-body-collision.md",
];

/// The ones with derivatives of derivatives by several symbols, which are not emitted for Coq.
const MOTIONS: [&str; 4] =
    ["double-pendulum.md", "kepler.md", "painleve-rod.md", "physical-pendulum.md"];

/// The one with inductions: base and step are lemmas, from which no theorem is derived there.
const WITH_INDUCTIONS: &str = "bouncing-ball.md";

/// Those with a witness at an algebraic number, which exists by the completeness of the reals.
const WITH_A_ROOT: [&str; 2] = ["coupled-collision.md", "hertz.md"];

const LIMITS: Limits = Limits { file: Duration::from_secs(300), question: Duration::from_secs(2) };

/// Asks Coq about a file beside the theory, which is compiled once for all tests.
pub(crate) fn coq(file: &File) -> Judge {
    static THEORY: LazyLock<Theory> = LazyLock::new(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("theory");
        Theory::within(folder, &LIMITS).expect("coqc runs")
    });
    THEORY.ask(file, &LIMITS).expect("coqc runs")
}

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
    assert_eq!(files, DOCUMENTS.len() + MOTIONS.len() + 1);
}

/// The document that Coq is asked about where someone waits for the answer.
const THE_PAPER: &str = "oblique-collision.md";

/// All of the documents in the gate, and else the paper alone. Where one needs more or less of the theory than those
/// before it, its file is put to Coq as it is handed out, with its own theory.
#[test]
fn coq_accepts_every_lemma_of_the_shipped_documents() {
    if !installed("coqc") {
        return;
    }
    let mut theories = BTreeSet::new();
    for name in DOCUMENTS.into_iter().filter(|name| many::all() || *name == THE_PAPER) {
        let audit = judged(name);
        let file = file(&Claims::of(&audit));
        let judge = match theories.insert(file.theory()) {
            true => ask_coq(&file, &LIMITS).expect("coqc runs"),
            false => coq(&file),
        };
        // what rests on a claim that is not proved has a lemma, but no theorem from the givens
        let fits = |((statement, _), answer): &(&(usize, usize), &Answer)| match audit.judgements
            [*statement]
            .verdict
        {
            Verdict::Unsupported => matches!(answer, Answer::Partly(_)),
            _ => matches!(answer, Answer::Agrees),
        };
        let others: Vec<_> = judge.answers.iter().filter(|entry| !fits(entry)).collect();
        assert!(others.is_empty(), "{name}: {others:?}");
        let [reals, extensionality, completeness] = ALLOWED_AXIOMS;
        let mut axioms = vec![reals, extensionality];
        if WITH_A_ROOT.contains(&name) {
            axioms.insert(1, completeness);
        }
        assert_eq!(judge.axioms, axioms, "{name}: what the lemmas rest on");
    }
}

#[test]
fn coq_accepts_what_is_emitted_of_motions() {
    if !installed("coqc") {
        return;
    }
    for name in MOTIONS {
        let audit = judged(name);
        let judge = coq(&file(&Claims::of(&audit)));
        let agrees = judge.answers.values().filter(|a| matches!(a, Answer::Agrees)).count();
        let open = judge.answers.values().filter(|a| matches!(a, Answer::NotAsked(_))).count();
        assert_eq!(agrees + open, judge.answers.len(), "{name}: {:?}", judge.answers);
        assert!(agrees > 2 * open, "{name}: {agrees} agree, {open} are not asked");
    }
}

#[test]
fn coq_accepts_every_base_and_every_step_of_an_induction() {
    if !installed("coqc") {
        return;
    }
    let audit = judged(WITH_INDUCTIONS);
    let judge = coq(&file(&Claims::of(&audit)));
    let mut accepted = 0;
    for ((statement, link), answer) in &judge.answers {
        match answer {
            Answer::Agrees | Answer::Partly(_) => accepted += 1,
            answer => {
                let verdict = audit.judgements[*statement].links[*link].verdict;
                assert_eq!(verdict, Verdict::Undecided, "{answer:?}");
            }
        }
    }
    let proved = audit
        .judgements
        .iter()
        .flat_map(|j| &j.links)
        .filter(|link| matches!(link.verdict, Verdict::Proved | Verdict::Refuted));
    assert_eq!(accepted, proved.count(), "{:?}", judge.answers);
}

#[test]
fn z3_disagrees_on_no_claim_of_the_shipped_documents() {
    if !installed("z3") {
        return;
    }
    for name in many::share(DOCUMENTS.into_iter().chain(MOTIONS).chain([WITH_INDUCTIONS])) {
        let audit = judged(name);
        let judge = ask_z3(&Claims::of(&audit), &LIMITS, &|_, _| {}).expect("z3 runs");
        assert!(judge.agrees(), "{name}: {:?}", judge.answers);
        let undecided = judge.answers.values().filter(|a| matches!(a, Answer::Undecided(_)));
        println!("{name}: {} undecided by z3 in 2 s", undecided.count());
    }
}

/// The document's `given`s of exponentials, and of angles beside their sines, are theorems of Coq's library
/// about its own.
#[test]
fn coq_knows_what_is_assumed_of_exponentials_and_arcs() {
    if !installed("coqc") {
        return;
    }
    for name in ["exponentials.v", "arcs.v"] {
        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/conformance/data");
        let copy = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        fs::copy(data.join(name), &copy).expect("the file is there");
        let run = std::process::Command::new("coqc").arg(&copy).output().expect("coqc runs");
        assert!(run.status.success(), "{name}: {}", String::from_utf8_lossy(&run.stderr));
    }
}

/// A false neighbour of a true claim, with the proof of the true one.
#[test]
fn a_transplanted_proof_is_rejected() {
    let mut audit = judged("sliding-to-rolling.md");
    let statement = audit.document.statements.iter().position(|s| s.label == "(9r)");
    let statement = statement.expect("the claim is there");
    if installed("coqc") {
        let mut file = file(&Claims::of(&audit));
        let lemma = file.lemmas.iter_mut().find(|l| l.statement == statement);
        let lemma = lemma.expect("it is emitted");
        let neighbour = lemma.text.replace("(Num 14 1)", "(Num 13 1)").replace("/ 14", "/ 13");
        assert_ne!(lemma.text, neighbour);
        lemma.text = neighbour;
        let judge = coq(&file);
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
        let judge = ask_z3(&Claims::of(&audit), &LIMITS, &|_, _| {}).expect("z3 runs");
        assert!(matches!(judge.answers[&(statement, 0)], Answer::Disagrees(_)));
    }
}

/// What is equal to a polynomial lies between it and itself: the proof of the one shows the other.
#[test]
fn a_limit_between_two_bounds_needs_both() {
    let labels = ["both", "swapped", "lower", "upper", "twice"];
    let claims = labels.map(|label| format!("claim {label}: x -> 0 as x -> 0+\n"));
    let text = format!("```kane\nvar x\n{}```\n", claims.concat());
    let document = read("bounds.md", text.as_bytes()).expect("the document is well formed");
    let mut audit = audit(document, &Options::default(), &mut |_, _| {});
    let place = |audit: &Audit, label: &str| {
        let found = audit.document.statements.iter().position(|s| s.label.contains(label));
        found.expect("the claim is there")
    };
    for label in labels {
        let statement = place(&audit, label);
        let link = &mut audit.judgements[statement].links[0];
        let mut accepted = (**link.accepted.as_ref().expect("it is proved")).clone();
        let Evidence::Limit(sides) = &mut accepted.certificate.evidence else {
            panic!("a limit");
        };
        let bound = |sense| SideProof { sense, ..sides[0].clone() };
        let (lower, upper) = (bound(Ordering::Greater), bound(Ordering::Less));
        let between = |a: SideProof, b: SideProof| SideProof { upper: Some(b.into()), ..a };
        sides[0] = match label {
            "both" => between(lower, upper),
            "swapped" => between(upper, lower),
            "lower" => lower,
            "upper" => upper,
            _ => between(lower.clone(), lower),
        };
        let verdict = check(&accepted.goal, &accepted.certificate, Fuel::new(1_000_000));
        assert_eq!(verdict.is_ok(), label == "both", "{label}: {verdict:?}");
        link.accepted = Some(Rc::new(accepted));
    }
    if !installed("coqc") {
        return;
    }
    // Each lemma that is rejected costs a run.
    let asked = ["both", "lower"].map(|label| place(&audit, label));
    let judge = coq(&file(&Claims::of(&audit).only(&asked)));
    let [both, lower] = asked.map(|statement| &judge.answers[&(statement, 0)]);
    assert!(matches!(both, Answer::Agrees), "{both:?}");
    assert!(matches!(lower, Answer::Disagrees(_)), "{lower:?}");
}

/// The statement of a lemma is compared with the data, so that neither can be changed alone.
#[test]
fn a_lemma_that_says_something_else_is_rejected() {
    if !installed("coqc") {
        return;
    }
    let audit = judged("sliding-to-rolling.md");
    let mut file = file(&Claims::of(&audit));
    let changed = file.lemmas.iter_mut().find(|l| l.text.contains("= 5 / 14 * m * v_0 ^ 2.\n"));
    let changed = changed.expect("(9r) is emitted");
    changed.text = changed.text.replace("= 5 / 14 * m * v_0 ^ 2.\n", "= 5 / 13 * m * v_0 ^ 2.\n");
    let statement = changed.statement;
    let judge = coq(&file);
    assert!(matches!(judge.answers[&(statement, 0)], Answer::Disagrees(_)));
}

/// Every rule of the language has a document of its own there; what is not emitted says why.
///
/// `cargo test --release --test conformance coq_on_the_semantics -- --ignored` takes four minutes.
#[test]
#[ignore = "one run of coqc for each of thirty documents"]
fn coq_on_the_semantics_suite() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/conformance/semantics");
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("readable").path();
        let name = path.file_name().and_then(|n| n.to_str()).expect("UTF-8");
        // Some are there because they cannot be read.
        let Ok(document) = read(name, &fs::read(&path).expect("readable")) else {
            continue;
        };
        let audit = audit(document, &Options::default(), &mut |_, _| {});
        let judge = coq(&file(&Claims::of(&audit)));
        assert!(judge.agrees(), "{name}: {:?}", judge.answers);
    }
}

/// Near a true limit lie false ones, and near functions that meet the premises some that do not:
/// one change or two to a lemma and its data. `Fail` passes only where Coq rejects what follows.
#[test]
fn a_limit_that_is_not_and_functions_that_do_not_fit_are_rejected() {
    if !installed("coqc") {
        return;
    }
    let changes: [(&str, &[(&str, &str)]); 5] = [
        // Another limit in words, with the data of the true one.
        ("(29-inf)", &[("- 0) < epsilon", "- 1) < epsilon")]),
        // Another limit in words and as data.
        (
            "(29-zero)",
            &[("- mu) < epsilon", "- 2) < epsilon"), ("(Finite (Var 0))", "(Finite (Num 2 1))")],
        ),
        // Along the germ 12·f is 16·t.
        ("(26-left)", &[("[m_ [1]%nat 16] [m_ [] 12]", "[m_ [1]%nat 15] [m_ [] 12]")]),
        // Functions that miss (9).
        (
            "(11n)",
            &[
                (
                    "(Sub (Num 1 1) (Mul (Num 2 1) (Var 0)))",
                    "(Sub (Num 1 1) (Mul (Num 3 1) (Var 0)))",
                ),
                ("1 - 2 * alpha)", "1 - 3 * alpha)"),
            ],
        ),
        // What is denied is the limit that was found, 1/3.
        (
            "(27-right)",
            &[
                ("- 2 / 3) < epsilon", "- 1 / 3) < epsilon"),
                ("(Finite (Div (Num 2 1) (Num 3 1)))", "(Finite (Div (Num 1 1) (Num 3 1)))"),
            ],
        ),
    ];
    let labels: Vec<&str> = changes.iter().map(|c| c.0).chain(["ab-inf"]).collect();
    let (statements, mut file) = lemmas(&labels);
    for ((label, replace), statement) in changes.iter().zip(&statements) {
        let lemma = file.lemmas.iter_mut().find(|l| l.statement == *statement);
        let lemma = lemma.expect("it is emitted");
        for (from, to) in *replace {
            assert!(lemma.text.contains(from), "{label}: {from} in {}", lemma.text);
            lemma.text = lemma.text.replace(from, to);
        }
        lemma.text = lemma.text.replace(" exact (", " Fail exact (").replace(" Qed.", " Abort.");
        lemma.name = Err(NotEmitted::Step("a planted error"));
    }
    let judge = coq(&file);
    assert_eq!(judge.answers[&(statements[changes.len()], 0)], Answer::Agrees);
}

/// Some claims of the paper, and their lemmas.
fn lemmas(labels: &[&str]) -> (Vec<usize>, File) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/derivations/oblique-collision.md");
    let bytes = fs::read(path).expect("the document is there");
    let document = read("oblique-collision.md", &bytes).expect("the document is well formed");
    let index = |label: &&str| document.statements.iter().position(|s| s.label == **label);
    let only: Vec<usize> = labels.iter().map(|l| index(l).expect("the claim is there")).collect();
    let options = Options { only: Some(only.clone()), ..Options::default() };
    let audit = audit(document, &options, &mut |_, _| {});
    let file = file(&Claims::of(&audit).only(&only));
    (only, file)
}
