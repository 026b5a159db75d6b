//! The grammar of `kane completions` and `kane man`.

use std::path::PathBuf;

use clap::Args;
use clap_complete::Shell;

pub(super) const COMPLETIONS: &str = "\
Examples:
  kane completions bash > ~/.local/share/bash-completion/completions/kane
  kane completions zsh > ~/.zfunc/_kane       in a directory of your $fpath
  kane completions fish > ~/.config/fish/completions/kane.fish

They know the ids of laws, properties, parameters and models of this version.

Exit codes:
  0  they are printed
  2  bad input or usage";

pub(super) const MAN: &str = "\
Examples:
  kane man | man -l -                         the page of the program
  kane man audit | man -l -                   the page of a verb
  kane man --out ~/.local/share/man/man1      all pages, where man finds them

Exit codes:
  0  the pages are printed or written
  2  bad input or usage";

#[derive(Args, Debug)]
pub(crate) struct CompletionsArgs {
    /// The shell
    #[arg(value_enum, value_name = "SHELL")]
    pub(crate) shell: Shell,
}

#[derive(Args, Debug)]
pub(crate) struct ManArgs {
    /// The verb whose page is printed; without one, the page of the program
    #[arg(value_name = "VERB", conflicts_with = "out")]
    pub(crate) verb: Option<String>,

    /// Write kane.1 and a page for every verb into this directory instead
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}
