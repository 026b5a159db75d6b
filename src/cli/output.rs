//! Where reports go: standard output and standard error.

use std::ffi::OsString;
use std::io::{self, IsTerminal as _, Write as _};
use std::sync::OnceLock;

use clap::{ColorChoice, ValueEnum};
use kane::algebra::syntax::printable;
use kane::report::Page;

/// When reports have colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum When {
    /// on a terminal that is not dumb, unless `NO_COLOR` or `CLICOLOR=0` is set; elsewhere with `CLICOLOR_FORCE=1`
    #[default]
    Auto,
    /// in pipes and files, too
    Always,
    /// nowhere
    Never,
}

impl When {
    /// What the command line asks, read before it is parsed: messages about the parsing have colours,
    /// too. What is no answer is left to the parser to refuse.
    pub(super) fn asked(arguments: impl Iterator<Item = OsString>) -> Self {
        let words = arguments.map(|word| word.to_string_lossy().into_owned());
        let words: Vec<String> = words.take_while(|word| word != "--").collect();
        let last = words.iter().enumerate().rev().find_map(|(at, word)| {
            let value = match word.strip_prefix("--color")? {
                "" => words.get(at + 1)?,
                value => value.strip_prefix('=')?,
            };
            Self::from_str(value, false).ok()
        });
        last.unwrap_or_default()
    }
}

impl When {
    /// What help and messages about the command line follow. clap takes any `CLICOLOR_FORCE` for a wish, a 0 too.
    pub(super) fn of_help(self) -> ColorChoice {
        let is_unforced = std::env::var_os("CLICOLOR_FORCE").is_some_and(|value| value == "0");
        match self {
            Self::Auto if is_unforced => {
                let terminal = io::stdout().is_terminal() && io::stderr().is_terminal();
                let wanted = environment_wants_colours(terminal, |name| std::env::var_os(name));
                if wanted { ColorChoice::Always } else { ColorChoice::Never }
            }
            Self::Auto => ColorChoice::Auto,
            Self::Always => ColorChoice::Always,
            Self::Never => ColorChoice::Never,
        }
    }
}

/// What the command line asks, for the whole of the run.
static CHOSEN: OnceLock<When> = OnceLock::new();

/// Keeps what the command line asks. Only the first word counts.
pub(super) fn choose(when: When) {
    let _ = CHOSEN.set(when);
}

/// The page that standard output is: its width on a terminal, and colours there or where they are asked for.
pub(super) fn page() -> Page {
    let terminal = io::stdout().is_terminal();
    let width = terminal.then(|| usize::from(console::Term::stdout().size().1));
    Page { width, colour: colours_wanted(terminal) }
}

/// Whether standard output is sent colours. A flag goes before the environment.
fn colours_wanted(terminal: bool) -> bool {
    match CHOSEN.get().copied().unwrap_or_default() {
        When::Always => true,
        When::Never => false,
        When::Auto => environment_wants_colours(terminal, |name| std::env::var_os(name)),
    }
}

/// What the environment asks, in the order of clap, which colours help and messages: `NO_COLOR` set to
/// anything, `CLICOLOR_FORCE` to anything but 0, `CLICOLOR` to 0, and the kind of terminal.
fn environment_wants_colours(terminal: bool, of: impl Fn(&str) -> Option<OsString>) -> bool {
    let set = |name| of(name).filter(|value| !value.is_empty());
    if set("NO_COLOR").is_some() {
        return false;
    }
    if set("CLICOLOR_FORCE").is_some_and(|value| value != "0") {
        return true;
    }
    let wanted = set("CLICOLOR").is_none_or(|value| value != "0");
    terminal && wanted && of("TERM").is_none_or(|term| term != "dumb")
}

/// Prints the text. A reader that has seen enough and closed the pipe is not an error.
///
/// # Errors
///
/// Everything else that keeps the text from being written.
pub(super) fn to_stdout(text: &str) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    let may_be_coloured = stdout.is_terminal() || colours_wanted(false);
    let text = if may_be_coloured { coloured(text) } else { printable(text).into_owned() };
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
    use super::{When, coloured, environment_wants_colours};

    #[test]
    fn the_last_word_on_colours_counts_and_none_after_the_dashes() {
        let asked = |words: &str| When::asked(words.split(' ').map(Into::into));
        assert_eq!(asked("kane audit"), When::Auto);
        assert_eq!(asked("kane audit --color never"), When::Never);
        assert_eq!(asked("kane --color=always audit --help"), When::Always);
        assert_eq!(asked("kane --color=always audit --color never"), When::Never);
        assert_eq!(asked("kane audit -- --color=always"), When::Auto);
        assert_eq!(asked("kane --color=sometimes --colour always --color"), When::Auto);
    }

    #[test]
    fn the_environment_is_heard_in_the_order_of_other_programs() {
        let wanted = |terminal, set: &[(&str, &str)]| {
            let of = |name: &str| set.iter().find(|(key, _)| *key == name).map(|(_, v)| v.into());
            environment_wants_colours(terminal, of)
        };
        assert!(wanted(true, &[]) && !wanted(false, &[]));
        assert!(!wanted(true, &[("NO_COLOR", "0")]) && wanted(true, &[("NO_COLOR", "")]));
        assert!(!wanted(true, &[("CLICOLOR", "0")]) && !wanted(false, &[("CLICOLOR", "1")]));
        assert!(wanted(false, &[("CLICOLOR_FORCE", "1"), ("CLICOLOR", "0")]));
        assert!(!wanted(false, &[("CLICOLOR_FORCE", "0")]));
        assert!(!wanted(true, &[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")]));
        assert!(!wanted(true, &[("TERM", "dumb")]) && wanted(true, &[("TERM", "xterm")]));
    }

    #[test]
    fn a_terminal_is_sent_colours_and_nothing_else_that_it_obeys() {
        assert_eq!(coloured("\u{1b}[1;31mno\u{1b}[0m"), "\u{1b}[1;31mno\u{1b}[0m");
        assert_eq!(coloured("a\u{1b}[2K\r\u{9b}3Jb"), r"a\u{1b}[2K\u{d}\u{9b}3Jb");
    }
}
