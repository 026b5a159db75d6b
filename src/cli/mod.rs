//! The command line: arguments in, exit code out.

mod args;
mod audit;
mod carried;
mod chart;
mod check;
mod collide;
mod delivery;
mod draft;
mod floats;
mod forms;
mod help;
mod ids;
mod input;
mod labels;
mod laws;
mod lsp;
mod machine;
mod output;
mod packed;
mod prices;
mod progress;
mod scene;
mod shell;
mod site;
mod stability;
mod watch;

use std::io;
use std::path::Path;
use std::process::ExitCode;

use clap::FromArgMatches as _;
use kane::algebra::syntax::visible;

use args::{Cli, Verb};
use delivery::Written;

/// How a run ends; the codes are the same for every verb.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outcome {
    /// everything is as expected
    AsExpected,
    /// a claim or a check is not
    Unexpected,
    /// bad input or usage, already reported on standard error
    BadInput,
    /// nothing could be checked
    Nothing,
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        Self::from(match outcome {
            Outcome::AsExpected => 0,
            Outcome::Unexpected => 1,
            Outcome::BadInput => 2,
            Outcome::Nothing => 3,
        })
    }
}

/// Runs the program.
pub(crate) fn run() -> ExitCode {
    // before anything is parsed, so that what clap says has the colours that are asked for, too
    let when = output::When::asked(std::env::args_os());
    let command = help::command().color(when.of_help());
    let matches = command
        .try_get_matches()
        .unwrap_or_else(|error| help::seen(help::with_format(error, std::env::args_os())).exit());
    let cli = Cli::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    output::choose(cli.color);
    let outcome = match cli.verb {
        Verb::Audit(args) => audit::run(&args),
        Verb::Draft(args) => draft::run(&args),
        Verb::Laws(args) => laws::run(&args),
        Verb::Collide(args) => collide::run(&args),
        Verb::Chart(args) => chart::run(&args),
        Verb::Stability(args) => stability::run(&args),
        Verb::Scene(args) => scene::run(&args),
        Verb::Check(args) => check::run(&args),
        Verb::Site(args) => site::run(&args),
        Verb::Lsp(args) => lsp::run(&args),
        Verb::Completions(args) => shell::completions(&args),
        Verb::Man(args) => shell::man(&args),
    };
    outcome.into()
}

/// Reports on standard error that the run cannot go on. A closed standard error leaves the exit code to speak.
///
/// It is one line, whatever names of files and values stand in it: a workflow reads lines as commands.
fn bad_input(message: &str) -> Outcome {
    output::to_stderr(&format!("error: {}\n", visible(message)));
    Outcome::BadInput
}

/// Ends a run that has a report: writes the forms that `--out` asks for, in place of no input, then prints.
///
/// # Errors
///
/// How the run ends if one of the two cannot be done, already reported on standard error.
fn deliver(
    out: Option<&Path>,
    inputs: &[&Path],
    files: impl FnOnce() -> io::Result<Vec<Written>>,
    shown: impl FnOnce() -> String,
) -> Result<(), Outcome> {
    if let Some(dir) = out {
        let files = files().map_err(|error| bad_input(&error.to_string()))?;
        delivery::write(dir, inputs, &files).map_err(|why| bad_input(&why.to_string()))?;
    }
    output::to_stdout(&shown()).map_err(|error| bad_input(&format!("cannot print: {error}")))
}
