//! Where reports go: standard output and standard error.

use std::io::{self, IsTerminal as _, Write as _};

use kane::algebra::syntax::printable;
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
    let text = if stdout.is_terminal() { coloured(text) } else { printable(text).into_owned() };
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}

/// The text with its colours, and with all else that a terminal would obey written out.
fn coloured(text: &str) -> String {
    let is_colour = |rest: &str| {
        rest.strip_prefix('[').is_some_and(|rest| {
            rest.trim_start_matches(|c: char| c.is_ascii_digit() || c == ';').starts_with('m')
        })
    };
    let mut pieces = text.split('\u{1b}');
    let mut out = printable(pieces.next().unwrap_or_default()).into_owned();
    for piece in pieces {
        out.push_str(if is_colour(piece) { "\u{1b}" } else { "\\u{1b}" });
        out.push_str(&printable(piece));
    }
    out
}

/// Prints the text on standard error, if anybody listens; what a terminal would obey is written out.
pub(super) fn to_stderr(text: &str) {
    let _ = io::stderr().lock().write_all(printable(text).as_bytes());
}

#[cfg(test)]
mod tests {
    use super::coloured;

    #[test]
    fn a_terminal_is_sent_colours_and_nothing_else_that_it_obeys() {
        assert_eq!(coloured("\u{1b}[1;31mno\u{1b}[0m"), "\u{1b}[1;31mno\u{1b}[0m");
        assert_eq!(coloured("a\u{1b}[2K\r\u{9b}3Jb"), r"a\u{1b}[2K\u{d}\u{9b}3Jb");
    }
}
