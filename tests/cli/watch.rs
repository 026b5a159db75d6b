//! `kane audit --watch`: judged again when a file changes, until standard input ends.

use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Child, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use super::{command, document, kane, scratch};

/// Longer than any of these documents takes on a busy machine.
const PATIENCE: Duration = Duration::from_secs(60);

/// A program that watches, and the lines that it prints.
struct Watching {
    child: Child,
    out: Receiver<String>,
    err: Receiver<String>,
}

fn lines(stream: impl Read + Send + 'static) -> Receiver<String> {
    let (sender, lines) = channel();
    std::thread::spawn(move || {
        for line in BufReader::new(stream).lines().map_while(Result::ok) {
            if sender.send(line).is_err() {
                return;
            }
        }
    });
    lines
}

/// Waits for a line with this in it; all that was printed up to there.
fn wait(lines: &Receiver<String>, part: &str) -> String {
    let mut seen = String::new();
    loop {
        let line = lines.recv_timeout(PATIENCE);
        assert!(line.is_ok(), "no `{part}`:\n{seen}");
        let line = line.expect("it has come");
        seen.push_str(&line);
        seen.push('\n');
        if line.contains(part) {
            return seen;
        }
    }
}

fn watch(path: &str) -> Watching {
    let mut program = command();
    program.args(["audit", path, "--watch"]);
    program.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = program.spawn().expect("the program starts");
    let out = lines(child.stdout.take().expect("it is piped"));
    let err = lines(child.stderr.take().expect("it is piped"));
    Watching { child, out, err }
}

fn write(dir: &Path, statements: &str) -> String {
    document(dir, "w.md", statements)
}

#[test]
fn a_document_is_judged_again_whenever_it_changes() {
    let dir = scratch("watch");
    let path = write(&dir, "var x > 0\nclaim a: x > 0");
    let mut watching = watch(&path);
    wait(&watching.out, "1 claim: 1 proved");
    wait(&watching.err, "watching ");
    // of the same length, at once
    write(&dir, "var x > 0\nclaim a: x > 1");
    wait(&watching.out, "1 claim: 1 refuted");
    wait(&watching.err, "watching ");
    write(&dir, "var x > 0\nclaim a: y > 1");
    let faults = wait(&watching.err, "watching ");
    assert!(faults.contains("unknown symbol `y`") && faults.contains("w.md:5:10"), "{faults}");
    // editors put a new file into the place of the old one
    std::fs::remove_file(&path).expect("it can be removed");
    let gone = wait(&watching.err, "watching ");
    assert!(gone.contains("w.md"), "{gone}");
    write(&dir, "var x > 0\nclaim a: x > 0\nclaim b: x > 2");
    wait(&watching.out, "2 claims: 1 proved, 1 refuted");
    wait(&watching.err, "watching ");
    // the last run decides
    drop(watching.child.stdin.take());
    let status = watching.child.wait().expect("it ends");
    assert_eq!(status.code(), Some(1));
}

#[test]
fn what_is_shown_while_watching_is_what_is_shown_once() {
    let dir = scratch("watch-same");
    let path = write(&dir, "var x > 0\nlet f := x + 1\nclaim a: f > 1\nclaim b: f > 2 from a");
    let mut watching = watch(&path);
    wait(&watching.err, "watching ");
    write(&dir, "var x > 0\nlet f := x + 3\nclaim a: f > 1\nclaim b: f > 2 from a");
    wait(&watching.err, "watching ");
    drop(watching.child.stdin.take());
    assert_eq!(watching.child.wait().expect("it ends").code(), Some(0));
    let shown: Vec<String> = watching.out.iter().collect();
    let once = kane(&["audit", &path]).stdout;
    assert!(shown.join("\n").ends_with(once.trim_end()), "{shown:#?}\n{once}");
}

#[test]
fn what_does_not_change_is_not_watched() {
    for arguments in [&["audit", "--watch"][..], &["audit", "-", "--watch"]] {
        let run = kane(arguments);
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains("--watch needs"), "{}", run.stderr);
    }
    // input that has ended already ends it after one run
    let dir = scratch("watch-once");
    let path = write(&dir, "var x > 0\nclaim a: x > 0");
    let run = kane(&["audit", &path, "--watch"]);
    assert_eq!((run.code, run.stdout.matches("1 proved").count()), (0, 1));
}
