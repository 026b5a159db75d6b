//! The documents that the command line names.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use super::carried::{self, DERIVATIONS};

pub(super) use kane::report::{quoted, quoted_file};

/// The paper, carried along so that an installed program needs no checkout.
const PAPER: &str = include_str!("../../docs/derivations/oblique-collision.md");
/// Where the paper stands in a checkout.
const PAPER_NAME: &str = "oblique-collision.md";

/// What standard input is called in messages.
const STANDARD_INPUT: &str = "standard input";

/// The bytes of a document and what to call it.
pub(super) struct Input {
    /// as the user wrote it
    pub(super) name: String,
    /// what its reports are called, without an ending
    pub(super) stem: String,
    /// the command that audits it
    pub(super) command: String,
    pub(super) bytes: Vec<u8>,
}

impl Input {
    /// Whether this is the paper, wherever it was read from.
    pub(super) fn is_paper(&self) -> bool {
        self.bytes == PAPER.as_bytes()
    }
}

/// A document that cannot be read.
pub(super) struct Unreadable {
    /// as the user wrote it
    pub(super) name: String,
    /// what it is, and why
    pub(super) message: String,
}

/// Reads every file, or takes the paper if there is none; with one message for every file that cannot be read.
pub(super) fn read(files: &[PathBuf]) -> (Vec<Input>, Vec<Unreadable>) {
    if files.is_empty() {
        let paper = Input {
            name: PAPER_NAME.to_owned(),
            stem: PAPER_NAME.trim_end_matches(".md").to_owned(),
            command: "kane audit".to_owned(),
            bytes: PAPER.as_bytes().to_vec(),
        };
        return (vec![paper], vec![]);
    }
    let mut inputs = Vec::new();
    let mut errors = Vec::new();
    for (at, file) in files.iter().enumerate() {
        let piped = is_standard_input(file);
        let name = if piped { STANDARD_INPUT.to_owned() } else { file.display().to_string() };
        if piped && files.iter().take(at).any(|other| is_standard_input(other)) {
            let message = "`-` is standard input, which can be read once".to_owned();
            errors.push(Unreadable { name, message });
            continue;
        }
        let stem = if piped {
            "stdin".to_owned()
        } else {
            file.file_stem().unwrap_or_default().to_string_lossy().into_owned()
        };
        match load(file) {
            Ok(bytes) => inputs.push(Input {
                name,
                stem,
                command: format!("kane audit {}", quoted_file(&file.display().to_string())),
                bytes,
            }),
            Err(error) => {
                let message = match piped {
                    true => format!("cannot read {name}: {error}"),
                    false => carried::unreadable(file, &error.to_string(), "md", &DERIVATIONS),
                };
                errors.push(Unreadable { name, message });
            }
        }
    }
    (inputs, errors)
}

/// The file's bytes, but at most one more than the reader accepts: a larger file is refused, not held in memory.
fn load(file: &PathBuf) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let limit = u64::try_from(kane::audit::MAX_FILE_BYTES).unwrap_or(u64::MAX).saturating_add(1);
    if let Some(shipped) = carried::named(file, &DERIVATIONS) {
        return Ok(shipped.text.as_bytes().to_vec());
    }
    let source: Box<dyn Read> =
        if is_standard_input(file) { Box::new(io::stdin()) } else { Box::new(File::open(file)?) };
    source.take(limit).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Whether a file is written as `-`. A file of that name is `./-`.
fn is_standard_input(file: &Path) -> bool {
    file.as_os_str() == "-"
}
