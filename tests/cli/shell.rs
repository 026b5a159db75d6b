//! The program among other programs of a shell: colours, completions, manual pages, near names.

use std::fs;
use std::process::Command;

use crate::{command, finish, kane, scratch};

const README: &str = include_str!("../../README.md");

/// The verbs with their lines, as the program's help lists them.
fn verbs() -> Vec<(String, String)> {
    let help = kane(&["--help"]);
    assert_eq!(help.code, 0, "{}", help.stderr);
    let listed = help.stdout.split("Commands:\n").nth(1).expect("a list of verbs");
    let mut verbs: Vec<(String, String)> = Vec::new();
    for line in listed.lines().take_while(|line| line.starts_with("  ")) {
        // what a line has no room for goes on below it
        if let (true, Some((_, about))) = (line.starts_with("    "), verbs.last_mut()) {
            about.push_str(&format!(" {}", line.trim()));
        } else if let Some((verb, about)) = line.trim().split_once("  ") {
            verbs.push((verb.to_owned(), about.trim().to_owned()));
        }
    }
    verbs.retain(|(verb, _)| verb != "help");
    verbs
}

#[test]
fn the_readme_has_a_line_for_every_verb() {
    let rows: Vec<(String, String)> = README
        .lines()
        .filter_map(|line| line.strip_prefix("| `kane ")?.strip_suffix(" |")?.split_once("` | "))
        .map(|(verb, about)| (verb.to_owned(), about.to_owned()))
        .collect();
    assert_eq!(rows, verbs());
    assert!(rows.len() >= 10, "{rows:?}");
}

#[test]
fn colours_are_where_they_are_asked_for_and_nowhere_else() {
    let coloured = |arguments: &[&str], no_color: &str| {
        let run = command().args(arguments).env("NO_COLOR", no_color).output().expect("it starts");
        finish(run).stdout.contains('\u{1b}')
    };
    let audit = ["audit", "docs/derivations/bouncing-ball.md"];
    for (flag, expected) in
        [("--color=auto", false), ("--color=always", true), ("--color=never", false)]
    {
        let with = [&audit[..], &[flag]].concat();
        assert_eq!(coloured(&with, ""), expected, "{flag}");
        // a flag goes before the environment
        assert_eq!(coloured(&with, "1"), expected, "{flag} with NO_COLOR");
        assert_eq!(coloured(&["laws", "--help", flag], ""), expected, "{flag} in help");
    }
    let json = [&audit[..], &["--format", "json", "--color", "always"]].concat();
    assert!(!coloured(&json, ""), "programs are sent no colours");
    assert_eq!(kane(&["audit", "--color", "sometimes"]).code, 2);
}

#[test]
fn completions_know_verbs_flags_and_ids() {
    for shell in ["bash", "zsh", "fish"] {
        let run = kane(&["completions", shell]);
        assert_eq!(run.code, 0, "{}", run.stderr);
        for word in ["audit", "stability", "smith-1991", "energy", "walton.beta0=", "routh-newton"]
        {
            assert!(run.stdout.contains(word), "{shell} does not know {word}");
        }
    }
    assert_eq!(kane(&["completions", "tcsh"]).code, 2);
    // what stands without a flag, which clap_complete does not tell fish
    let fish = kane(&["completions", "fish"]).stdout;
    for (verb, value) in [("man", "audit"), ("completions", "bash")] {
        let line =
            format!("\ncomplete -c kane -n \"__fish_kane_using_subcommand {verb}\" -f -a \"");
        let offered = fish.split_once(&line).and_then(|(_, rest)| rest.split_once('"'));
        let (offered, _) = offered.expect("fish knows what may stand there");
        assert!(offered.split(' ').any(|word| word == value), "{verb}: {offered}");
    }
}

/// What bash offers after these words.
fn offered(script: &str, words: &[&str]) -> Vec<String> {
    let list: Vec<String> = words.iter().map(|word| format!("'{word}'")).collect();
    let at = words.len() - 1;
    let (current, before) = (words[at], words[at - 1]);
    let ask = format!(
        "{script}\nCOMP_WORDS=({}); COMP_CWORD={at}; _kane kane '{current}' '{before}'; printf '%s\\n' \"${{COMPREPLY[@]}}\"",
        list.join(" ")
    );
    let output = Command::new("bash").args(["--norc", "-c", &ask]).output().expect("bash starts");
    String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect()
}

#[test]
#[cfg(target_os = "linux")]
fn bash_completes_verbs_and_ids() {
    let script = kane(&["completions", "bash"]).stdout;
    assert_eq!(offered(&script, &["kane", "sta"]), ["stability"]);
    assert_eq!(
        offered(&script, &["kane", "laws", "--law", "smith"]),
        ["smith-1991", "smith-printed"]
    );
    assert_eq!(offered(&script, &["kane", "audit", "--form"]), ["--format"]);
    assert_eq!(offered(&script, &["kane", "man", "sta"]), ["stability"]);
    let all = offered(&script, &["kane", "laws", "--property", ""]);
    assert!(all.contains(&"energy".to_owned()), "{all:?}");
}

#[test]
fn every_verb_has_a_page_of_the_manual() {
    let dir = scratch("man");
    let run = kane(&["man", "--out", dir.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    for (verb, about) in verbs() {
        let page = fs::read_to_string(dir.join(format!("kane-{verb}.1"))).expect("it was written");
        assert!(page.lines().any(|line| line.starts_with(".TH")), "{verb}");
        let plain = page.replace("\\-", "-").replace("\\(aq", "'");
        assert!(plain.contains(&about), "{verb}: {about}");
        assert_eq!(kane(&["man", &verb]).stdout, page.split_once('\n').expect("a mark").1);
    }
    let page = fs::read_to_string(dir.join("kane-collide.1")).expect("it was written");
    let plain = page.replace("\\-", "-");
    for law in kane::impact::laws() {
        for own in law.info.parameters {
            let name = format!("\n  {}.{} = ", law.info.id, own.name);
            assert!(plain.contains(&name), "the page lacks {name}");
        }
    }
    // every page again, over its own, and none over somebody else's
    assert_eq!(kane(&["man", "--out", dir.to_str().expect("UTF-8")]).code, 0);
    fs::write(dir.join("kane.1"), ".TH MINE 1\n").expect("writable");
    assert_eq!(kane(&["man", "--out", dir.to_str().expect("UTF-8")]).code, 2);
    let unknown = kane(&["man", "adit"]);
    assert!(unknown.code == 2 && unknown.stderr.contains("did you mean `audit`?"));
    let listed: Vec<String> = verbs().into_iter().map(|(verb, _)| verb).collect();
    let unknown = kane(&["man", "zzzzzz"]).stderr;
    assert!(unknown.contains(&format!("there are {}", listed.join(", "))), "as in help: {unknown}");
}

#[test]
fn near_names_are_suggested_for_every_id() {
    for (arguments, hint) in [
        (&["laws", "--law", "smith"][..], "did you mean `smith-1991` or `smith-printed`?"),
        (&["laws", "--property", "energi"], "did you mean `energy`?"),
        (&["laws", "--explain", "smith:energy"], "did you mean `smith-1991` or `smith-printed`?"),
        (&["scene", "docs/scenes/backspn.toml"], "did you mean `docs/scenes/backspin.toml`?"),
        (&["scene", "backspn"], "did you mean `backspin`, which is shipped?"),
        (&["scene", "docs/scenes/rest.toml", "--model", "wang"], "there are "),
        (&["collide", "pendulum"], "did you mean `double-pendulum`, which is shipped?"),
        (
            &["collide", "docs/collisions/elipse.toml"],
            "did you mean `docs/collisions/ellipse.toml`?",
        ),
        (&["audit", "docs/derivations/keppler.md"], "did you mean `docs/derivations/kepler.md`?"),
        (&["audit", "keplr"], "did you mean `kepler`, which is shipped?"),
        (&["adit"], "'audit'"),
        (&["audit", "--json"], "the form of a report is `--format json`"),
        (&["completions", "bsh"], "'bash'"),
    ] {
        let run = kane(arguments);
        assert_eq!(run.code, 2, "{arguments:?}");
        assert!(run.stderr.contains(hint), "{arguments:?}: {}", run.stderr);
    }
}

#[test]
fn a_form_that_a_verb_has_not_is_not_suggested() {
    for (verb, flag, told) in
        [("audit", "--sarif", true), ("collide", "--sarif", false), ("check", "--junit", true)]
    {
        let run = kane(&[verb, flag]);
        assert_eq!(run.code, 2, "{verb} {flag}");
        assert_eq!(run.stderr.contains("the form of a report is"), told, "{verb}: {}", run.stderr);
    }
}

#[test]
fn what_is_shipped_goes_by_its_name_unless_a_file_is_called_so() {
    let by_name = kane(&["scene", "backspin", "--format", "json"]);
    let by_path = kane(&["scene", "docs/scenes/backspin.toml", "--format", "json"]);
    assert_eq!((by_name.code, by_path.code), (0, 0), "{}{}", by_name.stderr, by_path.stderr);
    let path = "docs/scenes/backspin.toml";
    assert_eq!(by_name.stdout, by_path.stdout.replace(path, "backspin"));
    let audit = kane(&["audit", "bouncing-ball"]);
    assert_eq!(audit.code, 0, "{}", audit.stderr);
    let dir = scratch("shipped");
    fs::write(dir.join("backspin"), "this is no scene\n").expect("writable");
    let mut own = command();
    let own = own.args(["scene", "backspin"]).current_dir(&dir).output().expect("it starts");
    assert_eq!(finish(own).code, 2, "the file is read");
}
