//! The judges as programs: each is run for a limited time, and its answers are read.

mod coq;
mod process;
mod z3;

use std::time::Duration;

pub use coq::{ALLOWED_AXIOMS, Theory, ask_coq};
pub use z3::ask_z3;

/// How long a judge may take.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// for the file of one document
    pub file: Duration,
    /// for one question
    pub question: Duration,
}

impl Default for Limits {
    fn default() -> Self {
        Self { file: Duration::from_secs(300), question: Duration::from_secs(10) }
    }
}

/// A judge that could not be asked.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NotAsked {
    /// there is no such program
    #[error("{0} is not installed")]
    NotInstalled(&'static str),
    /// the program could not be run
    #[error("{0}")]
    Failed(String),
}

/// Whether a program is there to be run.
#[must_use]
pub fn is_installed(program: &str) -> bool {
    let paths = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&paths).any(|folder| folder.join(program).is_file())
}
