//! The examples of every verb's help, run as a shell runs them.
#![cfg(unix)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::{finish, kane, scratch};

/// Examples that are not run here, and why.
const LEFT_OUT: [(&str, &str); 7] = [
    ("kane laws", "the whole matrix takes half a minute; tests/golden/matrix.rs has it"),
    ("kane laws --out reports", "the same"),
    ("kane laws --property energy", "a column takes as long"),
    ("kane chart --out charts", "times every method; --quick is run"),
    ("kane chart --growth", "takes minutes; tests/golden/growth.rs has a quick one"),
    ("kane site --out site", "takes a minute; tests/cli/site.rs has it"),
    ("kane audit --judges coq,z3", "needs both; tests/conformance/judges.rs has it"),
];

/// Examples that end with another exit code than 0, as their verb's help says.
const OTHERWISE: [(&str, i32); 1] = [("kane scene backspin --model whittaker-uncapped", 1)];

/// The verbs that the help lists, and the examples of each one's help.
fn examples() -> Vec<(String, Vec<String>)> {
    let help = kane(&["--help"]).stdout;
    let listed = help.split("Commands:\n").nth(1).expect("a list of verbs");
    let verbs = listed.lines().take_while(|line| line.starts_with("  "));
    let verbs = verbs.filter(|line| !line.starts_with("    ") && !line.trim().starts_with("help"));
    let verbs = verbs.map(|line| line.trim().split(' ').next().expect("a verb").to_owned());
    let of = |verb: &str| {
        let help = kane(&[verb, "--help"]).stdout;
        let shown = help.split("Examples:\n").nth(1).unwrap_or_default();
        let lines = shown.lines().take_while(|line| !line.is_empty());
        // what stands behind two spaces, or on a line of its own, says what the example does
        let commands = lines.filter_map(|line| line.strip_prefix("  kane "));
        commands.map(|line| format!("kane {}", line.split("  ").next().unwrap_or(line))).collect()
    };
    verbs.map(|verb| (verb.clone(), of(&verb))).collect()
}

/// A directory with the files that the examples name, and with the places that a shell reads completions from.
fn desk() -> PathBuf {
    let dir = scratch("examples");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (name, of) in [
        ("notes.md", "docs/examples/as-a-test/derivation.md"),
        ("a.md", "docs/examples/as-a-test/derivation.md"),
        ("b.md", "docs/derivations/bouncing-ball.md"),
        ("paper.tex", "tests/drafts/rigid-bodies.tex"),
        ("formulas.fpcore", "docs/examples/pole.fpcore"),
        ("old.csv", "docs/examples/as-a-test/impacts.csv"),
        ("new.csv", "docs/examples/as-a-test/impacts.csv"),
        ("impacts.csv", "docs/examples/as-a-test/impacts.csv"),
        ("scene.toml", "docs/scenes/backspin.toml"),
        ("collision.toml", "docs/collisions/ellipse.toml"),
    ] {
        fs::copy(root.join(of), dir.join(name)).expect("it is shipped");
    }
    let impacts = fs::read_to_string(dir.join("impacts.csv")).expect("it was copied");
    let lines: Vec<&str> = impacts.lines().collect();
    let names: Vec<&str> = lines[0].split(',').collect();
    let row = |line: &&str| {
        let cells = names.iter().zip(line.split(','));
        let cells: Vec<String> = cells.map(|(name, cell)| format!("\"{name}\":{cell}")).collect();
        format!("{{{}}}\n", cells.join(","))
    };
    fs::write(dir.join("impacts.jsonl"), lines[1..].iter().map(row).collect::<String>())
        .expect("writable");
    for place in [".local/share/bash-completion/completions", ".zfunc", ".config/fish/completions"]
    {
        fs::create_dir_all(dir.join(place)).expect("writable");
    }
    dir
}

/// A log for the example: long enough for `--row`, with the names that it maps or that its preset knows.
fn log(example: &str, dir: &Path) {
    let impacts = fs::read_to_string(dir.join("impacts.csv")).expect("it was copied");
    let (names, rows) = impacts.split_once('\n').expect("a head and rows");
    let names = if example.contains("--map") {
        names.replace("vx_pre_m_s", "speed_in")
    } else if example.contains("mujoco") {
        let ours = ["vx_pre_m_s", "vy_pre_m_s", "omega_pre_rad_s"];
        let ours = ours.into_iter().chain(["vx_post_m_s", "vy_post_m_s", "omega_post_rad_s"]);
        ours.enumerate().fold(names.to_owned(), |names, (at, name)| {
            let when = if at < 3 { "before" } else { "after" };
            names.replace(name, &format!("qvel[{}] {when}", at % 3))
        })
    } else {
        names.to_owned()
    };
    fs::write(dir.join("log.csv"), format!("{names}\n{}", rows.repeat(10))).expect("writable");
}

#[test]
fn every_example_of_the_help_runs() {
    let dir = desk();
    let program = Path::new(env!("CARGO_BIN_EXE_kane")).parent().expect("it is in a directory");
    let path = std::env::var("PATH").unwrap_or_default();
    let path = format!("{}:{path}", program.display());
    let (mut run, mut left_out) = (0, 0);
    for (verb, examples) in examples() {
        assert!(!examples.is_empty() || verb == "lsp", "the help of {verb} has no example");
        for example in examples {
            if LEFT_OUT.iter().any(|(left, _)| *left == example) {
                left_out += 1;
                continue;
            }
            log(&example, &dir);
            // `man` itself is not ours
            let command = example.split(" | man").next().expect("a command");
            let output = Command::new("sh")
                .args(["-c", command])
                .current_dir(&dir)
                .env("HOME", &dir)
                .env("PATH", &path)
                .stdin(Stdio::null())
                .output()
                .expect("a shell starts");
            let output = finish(output);
            let code = OTHERWISE.iter().find(|(other, _)| *other == example).map_or(0, |o| o.1);
            assert_eq!(output.code, code, "{command}: {}{}", output.stdout, output.stderr);
            run += 1;
        }
    }
    assert_eq!(left_out, LEFT_OUT.len(), "an example that is left out is in no help");
    assert!(run > 40, "only {run} examples are run");
}

#[test]
fn examples_fit_a_line_and_every_help_ends_with_exit_codes() {
    for (verb, _) in examples() {
        let page = kane(&["man", &verb]).stdout;
        let notes = page.split(".SH NOTES\n.nf\n").nth(1).expect("notes");
        // a paragraph is one line, which is broken where the terminal ends
        for line in notes.lines().filter(|line| line.starts_with(' ')) {
            let shown = line.replace("\\-", "-").replace("\\(aq", "'").replace("\\(ga", "`");
            assert!(shown.chars().count() <= 100, "{verb}: {shown}");
        }
        assert!(notes.contains("\nExit codes:\n.nf\n"), "the help of {verb} has no exit codes");
    }
}
