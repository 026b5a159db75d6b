//! `kane audit --watch`: the documents again whenever they change.

use std::io::{self, IsTerminal as _, Read as _, Write as _};
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, SystemTime};

use super::{Outcome, bad_input, output};

/// How often the files are looked at.
const INTERVAL: Duration = Duration::from_millis(200);
/// How old a change has to be before a file is read. What is written later has another time then, and a
/// file that is saved in pieces is mostly whole.
const SETTLED: Duration = Duration::from_millis(60);
/// How often a file that goes on changing is waited for.
const PATIENCE: usize = 20;

/// What is looked at of a file: when it was changed, and its length; `None` where there is none.
type Seen = Vec<Option<(SystemTime, u64)>>;

/// Runs `once` now and whenever one of the files changes. On a terminal it goes on until it is
/// interrupted, else until standard input ends. How the last run ended is how this one does.
pub(super) fn run(files: &[PathBuf], once: &mut dyn FnMut() -> Outcome) -> Outcome {
    if files.is_empty() {
        return bad_input(
            "--watch needs a file: the paper that the program carries does not change",
        );
    }
    if files.iter().any(|file| file.as_os_str() == "-") {
        return bad_input("--watch needs files: standard input comes once");
    }
    let end = end_of_input();
    loop {
        let seen = settled(files);
        clear();
        let outcome = once();
        output::to_stderr(&format!("watching {}\n", names(files)));
        loop {
            match end.recv_timeout(INTERVAL) {
                Ok(()) | Err(RecvTimeoutError::Disconnected) => return outcome,
                Err(RecvTimeoutError::Timeout) if look(files) != seen => break,
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    }
}

/// Something comes, or cannot come any more, when standard input ends. A terminal is left alone: what is
/// typed there is not for a program that may run in the background.
fn end_of_input() -> Receiver<()> {
    let (ended, end) = channel();
    thread::spawn(move || {
        if io::stdin().is_terminal() {
            // for ever, so that nobody takes the end of this thread for that of the input
            loop {
                thread::park();
            }
        }
        let mut bytes = [0; 512];
        loop {
            match io::stdin().read(&mut bytes) {
                Ok(1..) => {}
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Ok(0) | Err(_) => break,
            }
        }
        // nobody is left to be told where this fails
        let _ = ended.send(());
    });
    end
}

fn look(files: &[PathBuf]) -> Seen {
    let state = |file: &PathBuf| {
        let found = std::fs::metadata(file).ok()?;
        Some((found.modified().ok()?, found.len()))
    };
    files.iter().map(state).collect()
}

/// The files when the last change of them is some time ago.
fn settled(files: &[PathBuf]) -> Seen {
    let is_young = |state: &(SystemTime, u64)| {
        SystemTime::now().duration_since(state.0).is_ok_and(|age| age < SETTLED)
    };
    for _ in 0..PATIENCE {
        let seen = look(files);
        if !seen.iter().flatten().any(is_young) {
            return seen;
        }
        thread::sleep(SETTLED);
    }
    look(files)
}

/// Empties a terminal; elsewhere reports follow each other.
fn clear() {
    let mut stdout = io::stdout().lock();
    if stdout.is_terminal() {
        // the screen, what has scrolled away, and back to the corner; who cannot see it misses nothing
        let _ = stdout.write_all(b"\x1b[2J\x1b[3J\x1b[H").and_then(|()| stdout.flush());
    }
}

fn names(files: &[PathBuf]) -> String {
    let names: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
    names.join(", ")
}
