//! Derivations, scenes and logs as tests of another project.
//!
//! Each function is the whole of a test. It reads a file, relative to where the test runs (`cargo test`
//! runs in the folder of the package), and fails with all that is not as it should be:
//!
//! ```no_run
//! # mod tests {
//! use kane::testing::{Tested, document, log, scene};
//!
//! #[test]
//! fn the_derivation_holds() -> Tested {
//!     document("docs/derivation.md")
//! }
//!
//! #[test]
//! fn the_log_of_the_last_release_keeps_every_check() -> Tested {
//!     log("tests/impacts.csv")
//! }
//! # }
//! ```
//!
//! A small project that does so is in `docs/examples/as-a-test`. What is not checked never passes: a
//! document without a claim, a log without a row and a scene without an answer fail.

use std::fmt;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::Path;

use crate::audit::{Body, Options};
use crate::impact::laws;
use crate::records::reader::Kind;
use crate::records::study;
use crate::report::records::{RecordsReport, sheet};
use crate::report::{Page, Report, Summary, explain};
use crate::scene::{Effort, Verdict, answer, read};

/// What a test returns.
pub type Tested = Result<(), Failure>;

/// Why a test fails, in words. `cargo test` prints it by [`Debug`](fmt::Debug), which is the same text.
#[derive(Clone, PartialEq, Eq)]
pub struct Failure(String);

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl fmt::Debug for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Failure {}

/// Every statement of a derivation document ends as its author expects, and it has a claim.
///
/// # Errors
/// [`Failure`] with each statement that does not, its line, and the proof or the witness written out.
pub fn document(path: impl AsRef<Path>) -> Tested {
    let name = path.as_ref().display().to_string();
    let bytes = fs::read(&path).map_err(|error| unreadable(&name, &error))?;
    let document = crate::audit::read(&name, &bytes).map_err(|faults| {
        let faults: Vec<String> = faults.iter().map(ToString::to_string).collect();
        Failure(faults.join("\n"))
    })?;
    let audit = crate::audit::audit(document, &Options::default(), &mut |_, _| {});
    let statements = &audit.document.statements;
    if !statements.iter().any(|statement| matches!(statement.body, Body::Claim(_))) {
        return Err(Failure(format!("{name}: there is no claim, so that nothing is checked")));
    }
    if audit.as_expected() {
        return Ok(());
    }
    let mut told = Summary::of(&Report::new(&audit, format!("kane audit {name}"))).headline();
    for (index, (statement, judged)) in statements.iter().zip(&audit.judgements).enumerate() {
        if !judged.as_expected() {
            let written_out = explain(&audit, index).unwrap_or_default();
            told.push_str(&format!(
                "\n\n{name}:{}: {} is {}\n{}",
                statement.line,
                statement.label,
                judged.verdict,
                written_out.trim_end()
            ));
        }
    }
    Err(Failure(told))
}

/// A scene has an answer by a model that is known to be good enough.
///
/// # Errors
/// [`Failure`] with the reason.
pub fn scene(path: impl AsRef<Path>) -> Tested {
    let name = path.as_ref().display().to_string();
    let text = read::load(path.as_ref()).map_err(|error| unreadable(&name, &error))?;
    let scene = read::scene(&name, &text).map_err(|fault| Failure(fault.to_string()))?;
    let answer = answer(&scene, laws(), None, Effort::Chosen, &mut |_, _| {})
        .map_err(|none| Failure(format!("{name}: {none}")))?;
    let shown = answer.judged.iter().find(|judged| judged.model == answer.shown);
    match shown {
        Some(judged) if judged.verdict == Verdict::Meets => Ok(()),
        _ => Err(Failure(format!("{name}: no model is known to be good enough"))),
    }
}

/// Every row of a log of impacts is checked, and keeps every check, or fails one as a published law that
/// gives every row has it. Files called `.jsonl`, `.ndjson` or `.json` are JSON lines, all others CSV.
///
/// # Errors
/// [`Failure`] with the report on the log.
pub fn log(path: impl AsRef<Path>) -> Tested {
    let path = path.as_ref();
    let name = path.display().to_string();
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    let is_json = ["jsonl", "ndjson", "json"].contains(&&*ending);
    let kind = if is_json { Kind::JsonLines } else { Kind::Csv };
    let file = File::open(path).map_err(|error| unreadable(&name, &error))?;
    let study = study::study(BufReader::new(file), kind, &study::Options::new(laws()))
        .map_err(|fault| Failure(format!("{name}: {fault}")))?;
    if study.rows > 0 && study.as_expected() {
        return Ok(());
    }
    let command = format!("kane check {}", crate::report::quoted_file(&name));
    let report = RecordsReport { study: &study, log: &name, command: &command };
    Err(Failure(sheet(&report).text(Page::default())))
}

fn unreadable(name: &str, error: &dyn fmt::Display) -> Failure {
    Failure(format!("cannot read {name}: {error}"))
}
