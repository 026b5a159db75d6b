//! The judges themselves, where they are installed: what they are asked, and what becomes of their answers.

use std::fs;
use std::path::Path;
use std::rc::Rc;
use std::sync::Mutex;
use std::time::Duration;

use kane_judges::coq::{THEORY, file};
use kane_judges::{
    ALLOWED_AXIOMS, Answer, Claims, Judge, Limits, NotAsked, Theory, ask_coq, ask_z3, is_installed,
};
use kane_kernel::Finding;

use crate::accepted::installed;
use crate::document::{found, goal, judged};

/// One claim of each kind, one of which z3 cannot be asked about.
const CLAIMS: &str = "var x, y\n\
    given g: y = x + 1\n\
    claim right: y > x from g\n\
    claim wrong: y > 2*x from g expect refuted\n\
    claim far: 1/x -> 0 as x -> oo\n\
    claim after: y + 1 > x from right";

#[test]
fn a_program_is_installed_if_it_stands_on_the_path() {
    assert!(is_installed("sh"));
    assert!(!is_installed("a-program-that-nobody-has"));
    // a folder is no program
    assert!(!is_installed("."));
}

#[test]
fn z3_is_asked_about_each_claim_and_each_answer_is_told() {
    if !installed("z3") {
        return;
    }
    let mut audit = judged(CLAIMS);
    let told = Mutex::new(Vec::new());
    let progress = |done: usize, of: usize| told.lock().expect("no panic").push((done, of));
    let limits = Limits { question: Duration::from_secs(60), ..Limits::default() };
    let judge = ask_z3(&Claims::of(&audit), &limits, &progress).expect("it is installed");
    let limit = Answer::NotAsked("it speaks of limits".to_owned());
    let wanted = [Answer::Agrees, Answer::Agrees, limit, Answer::Agrees];
    let answers: Vec<&Answer> = judge.answers.values().collect();
    assert_eq!(answers, wanted.iter().collect::<Vec<_>>());
    assert!(judge.asked && judge.name == "z3" && judge.agrees());
    let mut told = told.into_inner().expect("no panic");
    told.sort_unstable();
    assert_eq!(told, [(1, 3), (2, 3), (3, 3)]);
    // a claim that is not so
    let strange = found(goal("var x, y\nclaim c: x > y"), Finding::Proved, None);
    audit.judgements[1].links[0].accepted = Some(Rc::new(strange));
    let judge = ask_z3(&Claims::of(&audit), &limits, &|_, _| {}).expect("it is installed");
    assert!(judge.disagrees_on(1) && !judge.disagrees_on(2), "{judge:?}");
}

/// Whether all but the claim that is made wrong agree.
fn assert_heard(judge: &Judge, wrong: bool) {
    assert_eq!(judge.name, "Coq");
    assert!(judge.asked);
    for (place, answer) in &judge.answers {
        match place.0 {
            1 if wrong => assert!(matches!(answer, Answer::Disagrees(_)), "{judge:?}"),
            4 if wrong => assert!(matches!(answer, Answer::Partly(_)), "{judge:?}"),
            _ => assert_eq!(*answer, Answer::Agrees, "{judge:?}"),
        }
    }
    assert_eq!(judge.answers.len(), 4);
    assert_eq!(judge.axioms, ALLOWED_AXIOMS[..2]);
}

#[test]
fn coq_is_asked_about_a_file_with_its_theory_or_beside_it() {
    if !installed("coqc") {
        return;
    }
    let audit = judged(CLAIMS);
    let mut file = file(&Claims::of(&audit));
    let limits = Limits::default();
    assert_heard(&ask_coq(&file, &limits).expect("it is installed"), false);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("asked");
    let theory = Theory::within(folder, &limits).expect("it is installed");
    assert_heard(&theory.ask(&file, &limits).expect("it is installed"), false);
    let lemma = file.lemmas.iter_mut().find(|l| l.statement == 1).expect("it is emitted");
    lemma.text = lemma.text.replace("y > x", "y > x + 1");
    assert_heard(&theory.ask(&file, &limits).expect("it is installed"), true);
    let none = Limits { file: Duration::ZERO, ..limits };
    let judge = theory.ask(&file, &none).expect("it is installed");
    assert!(judge.answers.values().all(|a| matches!(a, Answer::Undecided(_))), "{judge:?}");
    // a theory that is not compiled in time
    assert!(Theory::new(&none).is_err());
}

#[test]
fn a_theory_that_coq_does_not_compile_is_none() {
    if !installed("coqc") {
        return;
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("not-compiled");
    // where Coq would write which names it has met
    let taken = format!("{THEORY}.glob");
    fs::create_dir_all(folder.join(&taken)).expect("the build directory is writable");
    match Theory::within(folder, &Limits::default()) {
        Err(NotAsked::Failed(why)) => {
            assert!(why.starts_with("coqc: ") && why.contains(&taken), "{why}");
        }
        other => unreachable!("{other:?}"),
    }
}
