//! `kane lsp`: talks with an editor.

use std::io;

use clap::Args;
use kane_editor::{End, serve};

use super::{Outcome, bad_input, output};

/// What `--help` says behind the options.
pub(super) const ABOUT: &str = "\
An editor starts this by itself and talks with it over standard input and output. While one types, \
errors appear at their places, and each claim has its verdict in the margin; hovering shows the \
proof or the witness; labels can be followed, renamed and completed. How to set up VS Code, Neovim, \
Helix and Emacs is in editors/README.md.

Exit codes:
  0  the editor ended the conversation
  1  the conversation broke off
  2  bad input or usage";

#[derive(Args, Debug)]
pub(crate) struct LspArgs {
    /// Talk over standard input and output, as it does without this, too: some editors say it
    #[arg(long)]
    stdio: bool,
}

/// Runs the verb.
pub(super) fn run(_: &LspArgs) -> Outcome {
    match serve(io::stdin(), io::stdout().lock()) {
        Ok(End::Orderly) => Outcome::AsExpected,
        Ok(End::Abrupt) => {
            // an editor keeps this in its log; a person who began this by hand sees what it is for
            output::to_stderr(
                "error: the input ended before the editor ended the conversation; an editor starts this by itself, see \
                 editors/README.md\n",
            );
            Outcome::Unexpected
        }
        Err(error) => bad_input(&format!("the conversation with the editor broke off: {error}")),
    }
}
