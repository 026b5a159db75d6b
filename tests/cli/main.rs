//! The program as its user meets it: what it prints, where, and how it exits.

mod axe; // pages held against a checker of accessible pages
mod browser; // the page in a browser: what loads, filters, the graph, widths, contrast
mod check; // logs of impacts: forms, exit codes, an engine that is named
mod chromium; // the browser that it is opened in
mod collide; // the second verb: messages, exit codes, forms
mod disk; // --out on a disk that is full, read-only, shared, or left in the middle
mod errors; // what bad input gets
mod examples; // the examples of the help, run
mod exits; // exit codes
mod figures; // the figures, and the page that shows them
mod files; // --out
mod forms; // --format, --only, --explain, and that two runs agree
mod hidden; // characters that are not seen reach nothing that is shown
mod injection; // names and titles that speak the languages of reports
mod laws; // the matrix: exit codes, one cell in full, files
mod limits;
mod lsp; // the language server as an editor starts it
mod matrix_page; // the page of the matrix in a browser
mod print; // the report for LaTeX, compiled
mod readme; // the README shows what the program prints
mod release; // one version, wherever one is named
mod remarks; // verdicts beside lines: SARIF and workflow commands
mod scene; // scenes: models, files, exit codes
#[path = "../schemas/mod.rs"]
mod schemas; // that reports are as their JSON Schemas say
mod shell; // colours, completions, manual pages, near names
mod site; // the site
mod stability; // stability and chart
mod watch; // --watch

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A run of the program that is over.
struct Run {
    code: i32,
    stdout: String,
    stderr: String,
}

/// The program with these arguments, in the root of the checkout.
///
/// Every report for programs that it prints, or leaves in the directory behind `--out`, is held against its schema.
fn kane(arguments: &[&str]) -> Run {
    let run = finish(command().args(arguments).output().expect("the program starts"));
    schemas::assert_valid_if_ours(&run.stdout);
    let out = arguments.iter().skip_while(|argument| **argument != "--out").nth(1);
    let written = out.and_then(|out| std::fs::read_dir(out).ok()).into_iter().flatten().flatten();
    for path in written.map(|entry| entry.path()) {
        if path.extension().is_some_and(|ending| ending == "json") {
            let text = std::fs::read_to_string(&path);
            schemas::assert_valid_if_ours(&text.unwrap_or_default());
        }
    }
    run
}

/// The program, with nothing in its environment that changes what it prints.
fn command() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_kane"));
    command
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .env_remove("NO_COLOR")
        .env_remove("CLICOLOR_FORCE")
        .stdin(Stdio::null());
    command
}

fn finish(output: Output) -> Run {
    Run {
        code: output.status.code().expect("the program is not killed"),
        stdout: String::from_utf8(output.stdout).expect("reports are UTF-8"),
        stderr: String::from_utf8(output.stderr).expect("messages are UTF-8"),
    }
}

/// A directory of this test's own, empty, under the build directory.
fn scratch(name: &str) -> PathBuf {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if dir.exists() {
        std::fs::remove_dir_all(&dir).expect("the last run's directory can be removed");
    }
    std::fs::create_dir_all(&dir).expect("the build directory is writable");
    dir
}

/// Writes a document with these statements and returns its path.
fn document(dir: &Path, name: &str, statements: &str) -> String {
    let path = dir.join(name);
    let text = format!("# Test\n\n```kane\n{statements}\n```\n");
    std::fs::write(&path, text).expect("the scratch directory is writable");
    path.to_str().expect("the build directory has a UTF-8 name").to_owned()
}
