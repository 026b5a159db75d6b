//! What is shown says what was judged: no character that a terminal obeys, or that nobody sees, gets
//! through to a report or a message.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::{command, finish, kane, scratch};

/// Erases the line, goes back to its start, conceals what follows; one character for the first two;
/// turns the order; stops it.
const NASTY: &str = "\u{1b}[2K\u{1b}[1G proved \u{1b}[8m\u{9b}31m\u{202e}\u{7}\u{8}\u{2066}";

fn is_forbidden(c: char) -> bool {
    (c.is_control() && !matches!(c, '\n' | '\t'))
        || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

fn assert_clean(what: &str, text: &str) {
    let found = text.chars().find(|c| is_forbidden(*c));
    assert_eq!(found, None, "{what}: {text:?}");
}

fn write(path: &Path, text: &str) -> String {
    fs::write(path, text).expect("the scratch directory is writable");
    path.to_str().expect("UTF-8").to_owned()
}

/// Every file below.
fn files(dir: &Path) -> Vec<std::path::PathBuf> {
    let entries = fs::read_dir(dir).expect("it was made").map(|e| e.expect("readable").path());
    let nested = entries.map(|path| if path.is_dir() { files(&path) } else { vec![path] });
    nested.flatten().collect()
}

#[test]
fn prose_titles_and_file_names_are_shown_with_their_control_characters_written_out() {
    let dir = scratch("hidden");
    let statements =
        "```kane\nvar x > 0\ngiven g: x > 1\nclaim a: x > 0 from g\nclaim b: x > 2\n```";
    let text = format!(
        "# T{NASTY}\n\n## H{NASTY} $x{NASTY}$\n\nProse{NASTY} `code{NASTY}` [l{NASTY}](http://a/{NASTY})\n\n{statements}\n"
    );
    let name = dir.join("n\u{1b}[2K\u{202e}.md");
    let document = write(&name, &text);
    for arguments in [
        vec!["audit", &document],
        vec!["audit", &document, "--format", "markdown"],
        vec!["audit", &document, "--format", "json"],
        vec!["audit", &document, "--explain", "b"],
        vec!["stability", &document],
        vec!["audit", &document, "--only", NASTY],
    ] {
        let run = kane(&arguments);
        assert_clean(&format!("{arguments:?}"), &(run.stdout + &run.stderr));
    }
    let out = dir.join("out");
    let run = kane(&["audit", &document, "--out", out.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let written = files(&out);
    assert_eq!(written.len(), 8, "{written:?}");
    for path in &written {
        assert_clean(&path.display().to_string(), &fs::read_to_string(path).expect("UTF-8"));
    }
    let page = written.iter().find(|path| path.extension().is_some_and(|e| e == "html"));
    let page = fs::read_to_string(page.expect("it was written")).expect("UTF-8");
    assert!(
        page.contains(r"T\u{1b}[2K\u{1b}[1G proved \u{1b}[8m\u{9b}31m\u{202e}"),
        "in its title"
    );
    assert!(page.contains(r"Prose\u{1b}[2K"), "and in its prose");
}

#[test]
fn a_label_or_a_comment_with_a_control_character_is_an_error_with_its_place() {
    let dir = scratch("hidden-label");
    for (name, statement, place) in [
        ("label", "claim (\u{1b}[2K\r  proved  \u{1b}[8m): x = x + 1 expect refuted", ":5:8"),
        ("comment", "claim a: x = x # \u{1b}[8m", ":5:18"),
        ("order", "claim (a\u{202e}b): x = x", ":5:9"),
        ("width", "claim a\u{200b}b: x = x", ":5:8"),
        ("escape", "claim a: x = \u{9b}8m x", ":5:14"),
    ] {
        let text = format!("# T\n\n```kane\nvar x\n{statement}\n```\n");
        let document = write(&dir.join(format!("{name}.md")), &text);
        let run = kane(&["audit", &document]);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{name}");
        assert!(run.stderr.contains("character U+"), "{name}: {}", run.stderr);
        assert!(run.stderr.contains(&format!("{name}.md{place}")), "{name}: {}", run.stderr);
        assert_clean(name, &run.stderr);
    }
}

/// A spreadsheet computes what begins with one of four characters; a name or a formula may begin so.
#[test]
fn a_spreadsheet_computes_no_name_and_no_formula() {
    let dir = scratch("hidden-csv");
    let out = dir.join("out");
    let out = out.to_str().expect("UTF-8");
    let core = "(FPCore (x) :name \"=HYPERLINK(1)\" :precision binary64 :pre (<= 1 x 2) (- x))";
    let core = write(&dir.join("one.fpcore"), core);
    let run = kane(&["chart", &core, "--out", out]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let lets = "# T\n\n```kane\nvar x > 0\nlet f := -x/(1 + x) + 1\n```\n";
    let lets = write(&dir.join("two.md"), lets);
    let run = kane(&["stability", &lets, "--out", out]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let tables = files(Path::new(out)).into_iter();
    let tables: Vec<_> =
        tables.filter(|path| path.extension().is_some_and(|e| e == "csv")).collect();
    assert_eq!(tables.len(), 2, "{tables:?}");
    let mut marked = 0;
    for table in tables {
        let text = fs::read_to_string(table).expect("UTF-8");
        for cell in text.lines().flat_map(|line| line.split(',')) {
            let cell = cell.trim_start_matches('"');
            marked += usize::from(cell.starts_with('\''));
            let signed = cell.starts_with(['=', '+', '-', '@']);
            assert!(!signed || cell.parse::<f64>().is_ok(), "{cell}: {text}");
        }
    }
    assert!(marked > 1, "the name and the formula");
}

#[test]
fn the_title_of_a_scene_cannot_speak_for_the_program() {
    let dir = scratch("hidden-scene");
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/scenes/rest.toml");
    let text = fs::read_to_string(root).expect("it is committed");
    let title = text.lines().find(|line| line.starts_with("title")).expect("it has a title");
    let nasty = title.replacen('"', "\"\\u001b[2K\\u202e\\u009b8m", 1);
    let scene = write(&dir.join("scene.toml"), &text.replace(title, &nasty));
    let out = dir.join("out");
    let run = kane(&["scene", &scene, "--out", out.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains(r"\u{1b}[2K\u{202e}\u{9b}8m"), "{}", run.stdout);
    assert_clean("standard output", &run.stdout);
    for path in files(&out) {
        assert_clean(&path.display().to_string(), &fs::read_to_string(path).expect("UTF-8"));
    }
    let broken = write(&dir.join("broken.toml"), "\u{1b}[2K = 1\n");
    let run = kane(&["scene", &broken]);
    assert_eq!(run.code, 2);
    assert_clean("standard error", &run.stderr);
}

/// A name of a file, or a value, with an end of a line in it: a workflow would take what follows for a command, and a
/// reader for a verdict.
#[test]
#[cfg(unix)]
fn no_name_of_a_file_or_of_a_row_begins_a_line() {
    const NAME: &str = "a\n::error::x\nclaim (1): proved";
    let dir = scratch("line-in-a-name");
    let write = |ending: &str, text: &str| {
        let path = dir.join(format!("{NAME}{ending}"));
        fs::write(&path, text).expect("the scratch folder is ours");
        path.to_str().expect("UTF-8").to_owned()
    };
    let head =
        "mass,inertia,rx,ry,mu,e,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post,id,pair\n";
    let row = format!(
        "1,0.4,0,-1,0.1,0.5,2.123456789,-1,0,1.973456789,0.5,-0.75,\"{NAME}\",\"{NAME}\"\n"
    );
    let log = write(".csv", &format!("{head}{row}"));
    let words = write(".md", "```kane\nvar x > 0\nlet f := x + 1\n```\n");
    let collision = write(".toml", include_str!("../../docs/collisions/rod-tip.toml"));
    let scene = write("-scene.toml", include_str!("../../docs/scenes/squeezed.toml"));
    let gone = dir.join(format!("{NAME}-gone")).to_str().expect("UTF-8").to_owned();
    let runs: [&[&str]; 17] = [
        &["check", &log],
        &["check", &log, "--format", "markdown"],
        &["check", &log, "--baseline", &log],
        &["check", &log, "--row", "99"],
        &["check", &gone],
        &["stability", &words],
        &["draft", &words],
        &["audit", &gone],
        &["audit", "--only", NAME],
        &["collide", &collision],
        &["collide", &gone],
        &["collide", "--body", NAME],
        &["scene", &scene],
        &["scene", "rest", "--model", NAME],
        &["scene", "rest", "--format", NAME],
        &["check", "--a", NAME],
        &[NAME],
    ];
    for arguments in runs {
        let run = kane(arguments);
        for line in run.stdout.lines().chain(run.stderr.lines()) {
            let begun = ["::error", "claim (1): proved"]
                .iter()
                .any(|begin| line.trim_start().starts_with(begin));
            assert!(!begun, "{arguments:?}: {line}");
        }
    }
}

/// What a report says to run is run by a shell, from files that are hard to name.
#[test]
#[cfg(unix)]
fn a_command_that_a_report_tells_prints_it_again() {
    let dir = scratch("command-of-a-name");
    let names = ["a\n$(touch x)'\u{1b}\u{202e}\\é", "-v", "it's `x`", "a b\t;c"];
    let log = "mass,inertia,rx,ry,mu,e,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n1,0.4,0,-1,0.1,0.5,2,-1,0,1.85,0.5,-0.375\n";
    for name in names {
        let files = [
            ("check", format!("{name}.csv"), log),
            ("audit", format!("{name}.md"), "# T\n\n```kane\nvar x\nclaim a: x = x\n```\n"),
            ("collide", format!("{name}.toml"), include_str!("../../docs/collisions/rod-tip.toml")),
            ("scene", format!("{name}-s.toml"), include_str!("../../docs/scenes/squeezed.toml")),
        ];
        for (verb, file, text) in &files {
            write(&dir.join(file), text);
            let run = command().current_dir(&dir).args([verb, "--", &**file]).output();
            let told = finish(run.expect("it starts")).stdout;
            let last = told.trim_end().lines().next_back().unwrap_or_default();
            let (_, again) = last.split_once(": kane ").expect("a command");
            let shell = format!("{} {again}", env!("CARGO_BIN_EXE_kane"));
            let run = Command::new("bash").args(["-c", &shell]).current_dir(&dir).output();
            let printed = finish(run.expect("bash")).stdout;
            // a name that looks like a flag is told as the file that it names
            assert_eq!(printed.replace("./-", "-"), told.replace("./-", "-"), "{again}");
        }
    }
    assert!(!dir.join("x").exists());
}
