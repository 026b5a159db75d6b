//! Coq accepts what it is handed: that a lemma says what its data say, and that the proof proves it. So what is written of
//! a claim beside its lemma needs no other judge. It is asked in the gate, for the time that it takes. Where it is not
//! installed these tests say so and check nothing; with `KANE_REQUIRE_JUDGES=1`, as in the gate, that is a failure.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use kane_judges::coq::{THEORY, shared_theory};
use kane_judges::is_installed;

use crate::document::judged;
use crate::lemmas::{Said, coq};
use crate::{chains, families, lemmas, many};

/// Whether a judge is there to be asked, and is to be asked now.
pub(crate) fn installed(program: &str) -> bool {
    let found = is_installed(program);
    let required = std::env::var_os("KANE_REQUIRE_JUDGES").is_some();
    assert!(found || !required, "{program} is not installed");
    let now = program != "coqc" || many::all();
    if !found || !now {
        println!(
            "skipped: {}",
            if now { "it is not installed" } else { "it is asked in the gate" }
        );
    }
    found && now
}

/// Has Coq compile a file of this text: what it says.
fn compiled(folder: &Path, name: &str, text: &str) -> (bool, String) {
    let file = format!("{name}.v");
    fs::write(folder.join(&file), text).expect("the build directory is writable");
    let mut command = Command::new("coqc");
    let run = command.args(["-q", "-Q", &theory_folder().to_string_lossy(), ""]).arg(&file);
    let output = run.current_dir(folder).output().expect("coqc starts");
    let said = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    (output.status.success(), said)
}

fn theory_folder() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("theory")
}

/// The theory, which is compiled once for as long as it says the same.
static THEORY_COMPILED: LazyLock<()> = LazyLock::new(|| {
    let folder = theory_folder();
    let (text, done) = (shared_theory(), folder.join("compiled"));
    if fs::read_to_string(&done).is_ok_and(|of| of == text) {
        return;
    }
    fs::create_dir_all(&folder).expect("the build directory is writable");
    let (accepted, said) = compiled(&folder, THEORY, &text);
    assert!(accepted, "{said}");
    fs::write(done, text).expect("the build directory is writable");
});

/// Puts the lemmas and theorems of statements to Coq.
fn assert_accepted(name: &str, said: &Said) {
    if !installed("coqc") {
        return;
    }
    LazyLock::force(&THEORY_COMPILED);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("accepted").join(name);
    fs::create_dir_all(&folder).expect("the build directory is writable");
    let text = coq(&judged(said.0)).beside_theory();
    let (accepted, said) = compiled(&folder, "claims", &text);
    assert!(accepted, "{said}\n{text}");
}

macro_rules! accepted {
    ($($name:ident: $said:expr,)*) => {
        $(
            #[test]
            fn $name() {
                assert_accepted(stringify!($name), &$said);
            }
        )*
    };
}

accepted! {
    bounds: lemmas::BOUNDS,
    premises: lemmas::PREMISES,
    findings: lemmas::FINDINGS,
    conditions: lemmas::CONDITIONS,
    derivatives: lemmas::DERIVATIVES,
    numbers: lemmas::NUMBERS,
    ranges: families::RANGES,
    limits: families::LIMITS,
    points_of_a_set: families::AT_POINTS,
    what_functions_refute: families::REFUTED,
    theorems: chains::AT_POINTS,
    theorems_about_functions: chains::ALONG,
    theorems_in_ranges: chains::RANGED,
    theorems_with_definitions: chains::DEFINED,
}
