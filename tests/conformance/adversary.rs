//! The adversary: random documents, and oracles in another language that share nothing with the
//! program (`scripts/adversary`).

use std::process::{Command, Output};

use crate::many::many;
use crate::support::{installed, root};

/// So many random claims, and those that cite them, are judged in the gate.
const CLAIMS: usize = 10_000;

/// Runs a script of the adversary; `None` where Python is not installed.
fn adversary(script: &str, arguments: &[&str]) -> Option<Output> {
    if !installed("python3") {
        return None;
    }
    let path = root().join("scripts/adversary").join(script);
    let output = Command::new("python3").arg("-B").arg(path).args(arguments).output();
    Some(output.expect("python3 runs"))
}

/// What a script printed, if it ended well.
fn succeeded(output: &Output) -> String {
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{printed}\n{errors}");
    println!("{printed}");
    printed
}

#[test]
fn the_oracles_agree_with_each_other() {
    if let Some(output) = adversary("selftest.py", &[]) {
        succeeded(&output);
    }
}

#[test]
fn no_wrong_verdict_of_old_comes_back() {
    if let Some(output) = adversary("run.py", &["--kane", env!("CARGO_BIN_EXE_kane"), "--found"]) {
        succeeded(&output);
    }
}

/// What a script printed that puts random claims to the program one document at a time.
fn trial(script: &str, claims: usize) -> Option<String> {
    let claims = many(claims).to_string();
    let arguments = [env!("CARGO_BIN_EXE_kane"), &claims, "gate", "--certificates"];
    let printed = succeeded(&adversary(script, &arguments)?);
    assert!(printed.contains(" 0 wrong, 0 certificates rejected"), "{printed}");
    Some(printed)
}

/// A busy machine without optimization gets more time than the ten seconds that the script gives.
#[test]
fn no_hostile_file_breaks_a_verb() {
    let count = many(180).to_string();
    let arguments = [env!("CARGO_BIN_EXE_kane"), &count, "gate", "--seconds", "100"];
    if let Some(output) = adversary("hostile.py", &arguments) {
        let printed = succeeded(&output);
        for verb in ["audit", "draft", "scene", "collide", "check", "stability"] {
            assert!(printed.contains(&format!("{verb}: the longest")), "{printed}");
        }
    }
}

#[test]
fn no_verdict_on_derivatives_of_functions_is_wrong() {
    if let Some(printed) = trial("motion.py", 300) {
        assert!(printed.contains("true proved") && printed.contains("false refuted"), "{printed}");
    }
}

#[test]
fn no_verdict_on_what_is_said_of_all_n_is_wrong() {
    if let Some(printed) = trial("sequences.py", 300) {
        let kinds = ["induction, true, proved: ", "induction, false, refuted: "];
        assert!(kinds.iter().all(|kind| printed.contains(kind)), "{printed}");
    }
}

#[test]
fn no_verdict_on_what_is_lowered_is_wrong() {
    if let Some(printed) = trial("lowered.py", 300) {
        let kinds = ["\nproved: ", "\nrefuted: ", "\nill-defined: ", "exists proved: "];
        let all = format!("\n{printed}");
        assert!(kinds.iter().all(|kind| all.contains(kind)), "{printed}");
    }
}

#[test]
fn no_verdict_on_angles_is_wrong() {
    if let Some(printed) = trial("angles.py", 120) {
        assert!(printed.contains("True proved") && printed.contains("False refuted"), "{printed}");
    }
}

#[test]
fn no_verdict_on_what_grows_is_wrong() {
    if let Some(printed) = trial("growing.py", 160) {
        let kinds = ["true Slope, proved: ", "false Slope, refuted: ", "true Limit, proved: "];
        assert!(kinds.iter().all(|kind| printed.contains(kind)), "{printed}");
    }
}

#[test]
fn no_verdict_on_exponentials_is_wrong() {
    if let Some(printed) = trial("exponentials.py", 240) {
        let kinds = ["true, proved: ", "false, refuted: "];
        assert!(kinds.iter().all(|kind| printed.contains(kind)), "{printed}");
    }
}

#[test]
fn no_verdict_on_sums_and_bounds_is_wrong() {
    if let Some(printed) = trial("sums.py", 240) {
        let kinds = ["induction, true, proved: ", "induction, false, refuted: "];
        assert!(kinds.iter().all(|kind| printed.contains(kind)), "{printed}");
    }
}

#[test]
fn no_verdict_is_wrong_where_all_of_the_language_stands_together() {
    if let Some(printed) = trial("mixed.py", 240) {
        let kinds = [
            "\ntrue, proved: ",
            "\nfalse, refuted: ",
            "true induction, proved: ",
            "true limit, proved: ",
        ];
        assert!(kinds.iter().all(|kind| printed.contains(kind)), "{printed}");
    }
}

#[test]
fn no_witness_that_is_found_and_no_limit_at_a_symbol_is_wrong() {
    if let Some(printed) = trial("existence.py", 120) {
        let kinds = ["exists, proved: ", "limit, true, proved: ", "limit, changed, refuted: "];
        assert!(kinds.iter().all(|kind| printed.contains(kind)), "{printed}");
    }
}

/// So many random scenes are answered in the gate.
const SCENES: usize = 70;

#[test]
fn no_answer_to_a_random_scene_is_further_off_than_it_says() {
    let scenes = many(SCENES).to_string();
    if let Some(output) = adversary("scenes.py", &[env!("CARGO_BIN_EXE_kane"), &scenes, "gate"]) {
        let printed = succeeded(&output);
        assert!(printed.contains(" answers, 0 wrong"), "{printed}");
        let kinds =
            ["answers enclosed: ", "answers estimated: ", "ledgers: ", "enclosed spreads: "];
        assert!(kinds.iter().all(|kind| printed.contains(kind)), "{printed}");
    }
}

/// So many random collisions are put to all laws, or to one in depth, in the gate.
const COLLISIONS: usize = 120;

#[test]
fn nothing_that_is_said_of_a_random_collision_is_wrong() {
    let count = many(COLLISIONS).to_string();
    let arguments = [env!("CARGO_BIN_EXE_kane"), &count, "gate"];
    if let Some(output) = adversary("collisions.py", &arguments) {
        let printed = succeeded(&output);
        assert!(printed.contains(" collisions, 0 wrong"), "{printed}");
        let kinds = ["irrational outcomes: ", "contacts on which energy is created: "];
        assert!(kinds.iter().all(|kind| printed.contains(kind)), "{printed}");
    }
}

/// Every law in both formats, clean twice and with each of six faults.
const LOGS: usize = 21 * 2 * 8;

#[test]
fn nothing_that_is_said_of_a_random_log_is_wrong() {
    let logs = many(LOGS).to_string();
    if let Some(output) = adversary("records.py", &[env!("CARGO_BIN_EXE_kane"), &logs, "gate"]) {
        let printed = succeeded(&output);
        assert!(printed.contains(" logs, 0 wrong"), "{printed}");
        let kinds = ["clean logs named: ", "sign of friction: found", "e off by 0.01: found"];
        assert!(kinds.iter().all(|kind| printed.contains(kind)), "{printed}");
    }
}

#[test]
fn no_verdict_on_a_random_claim_is_wrong() {
    let claims = many(CLAIMS).to_string();
    // where z3 is not installed the script says what it leaves out; the gate asks for it
    installed("z3");
    let arguments = ["--kane", env!("CARGO_BIN_EXE_kane"), "--claims", &claims];
    if let Some(output) = adversary("run.py", &arguments) {
        let printed = succeeded(&output);
        assert!(printed.contains("wrong: 0"), "{printed}");
    }
}

#[test]
fn no_verdict_on_a_limit_with_roots_is_wrong() {
    let arguments = ["--kane", env!("CARGO_BIN_EXE_kane"), "--claims", "100", "--certificates"];
    let arguments = [&arguments[..], &["--budget", "1000000"]].concat();
    if let Some(output) = adversary("radicals.py", &arguments) {
        let printed = succeeded(&output);
        assert!(printed.contains("wrong: 0"), "{printed}");
    }
}

#[test]
fn no_verdict_on_a_limit_with_several_symbols_under_roots_is_wrong() {
    if let Some(printed) = trial("parameters.py", 64) {
        let kinds = ["right, proved: ", "wrong, refuted: "];
        assert!(kinds.iter().all(|kind| printed.contains(kind)), "{printed}");
    }
}

#[test]
fn no_verdict_on_a_limit_near_a_kink_is_wrong() {
    if let Some(printed) = trial("kinks.py", 48) {
        let kinds = ["right, proved: ", "wrong, refuted: "];
        assert!(kinds.iter().all(|kind| printed.contains(kind)), "{printed}");
    }
}

#[test]
fn no_verdict_on_roots_of_numbers_is_wrong() {
    if let Some(printed) = trial("surds.py", 160) {
        let kinds = [
            "equal sides, true, proved: ",
            "equal sides, false, refuted: ",
            "by chance, true, proved: ",
        ];
        assert!(kinds.iter().all(|kind| printed.contains(kind)), "{printed}");
    }
}

#[test]
fn no_verdict_on_what_touches_at_a_point_is_wrong() {
    if let Some(printed) = trial("touching.py", 100) {
        let kinds =
            ["claims, right, proved: ", "claims, wrong, refuted: ", "claims, wrong, ill-defined: "];
        assert!(kinds.iter().all(|kind| printed.contains(kind)), "{printed}");
    }
}
