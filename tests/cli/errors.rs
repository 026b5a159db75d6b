//! Bad input gets all errors with file, line, column and caret, on standard error, and exit code 2.

use crate::{document, kane, scratch};

/// Each kind of fault: its name, the statements, what the message says, and the marked text.
const FAULTS: &[(&str, &str, &str, &str)] = &[
    ("unknown-symbol", "var alpha\ngiven a: alhpa = 1", "unknown symbol `alhpa`", "alhpa"),
    ("unknown-label", "var x\nclaim b: x = 1 from nowhere", "nowhere", "nowhere"),
    ("below", "var x\nclaim a: x = 1 from b\nclaim b: x = 1", "b", "b"),
    ("duplicate", "var x\ngiven a: x = 1\ngiven a: x = 2", "a", "a"),
    ("open", "var x\ngiven a: (x = 1", "never closed", "("),
    ("number", "var x\ngiven a: x = 1.2.3", "malformed number `1.2.3`", "1.2.3"),
    ("twice-equal", "var x\ngiven a: x == 1", "`==` means nothing here: it is written `=`", "=="),
    ("semicolon", "var x\ngiven a: x = 1;", "without a `;`", ";"),
    ("no-label", "var x\ngiven x = 1", "as in `given NAME: a = b`", "="),
    ("no-side", "var x\ngiven a: x =", "relation without a right side", ""),
    ("exponent", "var x\ngiven a: x^(1/2) = 1", "the exponent is not an integer", ""),
];

#[test]
fn every_kind_of_fault_is_named_and_marked() {
    let dir = scratch("faults");
    for (name, statements, message, marked) in FAULTS {
        let path = document(&dir, &format!("{name}.md"), statements);
        let run = kane(&["audit", &path]);
        assert_eq!(run.code, 2, "{name}");
        assert!(run.stdout.is_empty(), "{name}: {}", run.stdout);
        assert!(run.stderr.starts_with("error: "), "{name}: {}", run.stderr);
        assert!(run.stderr.contains(message), "{name}: {}", run.stderr);
        assert!(run.stderr.contains(&format!("{path}:")), "{name}: {}", run.stderr);
        assert!(caret_of(&run.stderr).contains(marked), "{name}: {}", run.stderr);
    }
}

/// The text over the first row of carets.
fn caret_of(message: &str) -> String {
    let lines: Vec<&str> = message.lines().collect();
    let row = lines.iter().position(|line| line.contains('^')).expect("there is a caret");
    let from = lines[row].find('^').expect("found above");
    let count = lines[row].matches('^').count();
    lines[row - 1].chars().skip(from).take(count).collect()
}

#[test]
fn a_misspelt_symbol_gets_a_suggestion() {
    let path = document(&scratch("misspelt"), "a.md", "var alpha\ngiven a: alhpa = 1");
    let run = kane(&["audit", &path]);
    assert!(run.stderr.contains("did you mean `alpha`?"), "{}", run.stderr);
    assert!(run.stderr.contains("a.md:5:10"), "{}", run.stderr);
}

#[test]
fn all_faults_of_all_files_are_told_in_one_run() {
    let dir = scratch("several");
    let first = document(&dir, "first.md", "var x\ngiven a: y = 1\ngiven b: z = 1");
    let second = document(&dir, "second.md", "var x\ngiven a: x = 1..2");
    let missing = dir.join("missing.md");
    let run = kane(&["audit", &first, &second, missing.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 2);
    assert_eq!(run.stderr.matches("error: ").count(), 4, "{}", run.stderr);
    assert!(run.stderr.contains("cannot read"), "{}", run.stderr);
}

#[test]
fn a_file_that_is_not_text_is_refused() {
    let path = scratch("bytes").join("bytes.md");
    std::fs::write(&path, b"# Test\n\n\xff\xfe\n").expect("the scratch directory is writable");
    let run = kane(&["audit", path.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("not UTF-8"), "{}", run.stderr);
    assert!(run.stderr.contains("bytes.md:3:1"), "{}", run.stderr);
}

#[test]
fn whoever_reads_a_file_says_where_it_stops_being_text() {
    let dir = scratch("not-text");
    let verbs = [
        ("audit", "md"),
        ("draft", "tex"),
        ("stability", "fpcore"),
        ("stability", "md"),
        ("scene", "toml"),
        ("collide", "toml"),
    ];
    for (verb, ending) in verbs {
        let path = dir.join(format!("bytes.{ending}"));
        std::fs::write(&path, b"# T\r\nsecond\rthird \xc3(\n").expect("the directory is writable");
        let run = kane(&[verb, path.to_str().expect("UTF-8")]);
        assert_eq!(run.code, 2, "{verb}: {}", run.stdout);
        let place = run.stderr.contains(":3:7") || run.stderr.contains("line 3, column 7");
        assert!(place && run.stderr.contains("not UTF-8"), "{verb} {ending}: {}", run.stderr);
        assert!(run.stderr.contains("bytes."), "{verb}: {}", run.stderr);
    }
}

#[test]
fn a_directory_is_not_a_document() {
    let dir = scratch("directory");
    let run = kane(&["audit", dir.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("cannot read"), "{}", run.stderr);
}

#[test]
fn an_unknown_label_gets_a_suggestion() {
    for (wanted, suggestion) in [("k-rage", "`k-range`"), ("(16", "`(16)`")] {
        for option in ["--only", "--explain"] {
            let run = kane(&["audit", option, wanted]);
            assert_eq!(run.code, 2, "{wanted}");
            assert!(run.stderr.contains(suggestion), "{}", run.stderr);
        }
    }
}
