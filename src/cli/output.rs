//! Where reports go: standard output and standard error.

use std::io::{self, IsTerminal as _, Write as _};

use kane::report::Page;

/// The page that standard output is: its width and colours on a terminal, neither elsewhere.
pub(super) fn page() -> Page {
    if !io::stdout().is_terminal() {
        return Page::default();
    }
    let (_, columns) = console::Term::stdout().size();
    Page { width: Some(usize::from(columns)), colour: colours_wanted() }
}

/// Whether a terminal may be sent colours: not if `NO_COLOR` is set to anything, or the terminal is dumb.
fn colours_wanted() -> bool {
    let set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    !set("NO_COLOR") && std::env::var_os("TERM").is_none_or(|term| term != "dumb")
}

/// Prints the text. A reader that has seen enough and closed the pipe is not an error.
///
/// # Errors
///
/// Everything else that keeps the text from being written.
pub(super) fn to_stdout(text: &str) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}

/// Prints the text on standard error, if anybody listens.
pub(super) fn to_stderr(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}
