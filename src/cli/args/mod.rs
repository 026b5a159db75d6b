//! The command line's grammar: what all verbs share here, and a file for each group of verbs.

mod check;
mod derivations;
mod floats;
mod laws;
mod scene;
mod shell;
mod site;

use clap::{Parser, Subcommand, ValueEnum};

pub(crate) use check::{CheckArgs, CheckFormat};
pub(crate) use derivations::{AuditArgs, AuditFormat, DraftArgs, JudgeName};
pub(crate) use floats::{ChartArgs, StabilityArgs};
pub(crate) use laws::{BodyArgs, CollideArgs, LawsArgs};
pub(crate) use laws::{COLLIDE_EXAMPLES, COLLIDE_EXIT, LAWS_EXAMPLES, LAWS_EXIT};
pub(crate) use scene::{SCENE_EXAMPLES, SCENE_EXIT, SceneArgs};
pub(crate) use shell::{CompletionsArgs, ManArgs};
pub(crate) use site::SiteArgs;

use super::output::When;

/// Checks the derivations and the arithmetic of collision laws.
#[derive(Debug, Parser)]
#[command(name = "kane", version, arg_required_else_help = true, after_help = EXIT)]
pub(crate) struct Cli {
    /// Colours: auto (on a terminal, unless NO_COLOR or CLICOLOR=0 is set), always or never
    #[arg(
        long,
        global = true,
        value_enum,
        value_name = "WHEN",
        default_value_t = When::Auto,
        hide_possible_values = true,
        help_heading = "Everywhere"
    )]
    pub(crate) color: When,

    #[command(subcommand)]
    pub(crate) verb: Verb,
}

const EXIT: &str = "\
Exit codes:
  0  everything is as expected
  1  a claim or a check is not
  2  bad input or usage
  3  nothing could be checked";

#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Judge every statement of derivation documents
    #[command(after_help = derivations::AUDIT_EXAMPLES)]
    Audit(AuditArgs),
    /// Make a draft of a derivation document from a paper in LaTeX or Markdown
    #[command(after_help = derivations::DRAFT_EXAMPLES)]
    Draft(DraftArgs),
    /// Hold every law against every property that mechanics asks of it
    Laws(LawsArgs),
    /// Put one collision to every law, exactly and in floats
    Collide(Box<CollideArgs>),
    /// Chart speed against accuracy: what the next digit costs
    #[command(after_help = floats::CHART_EXAMPLES)]
    Chart(ChartArgs),
    /// Find where the formulas of a derivation document fail in floating point
    #[command(after_help = floats::STABILITY_EXAMPLES)]
    Stability(StabilityArgs),
    /// Answer a scene by the least model that is good enough
    Scene(SceneArgs),
    /// Check a log of impacts row by row, and name the law that it follows
    #[command(after_help = check::CHECK_EXAMPLES)]
    Check(CheckArgs),
    /// Make a site of every report: an index that says what they come to, four pictures, and a page each
    #[command(after_help = site::SITE_EXAMPLES)]
    Site(SiteArgs),
    /// Answer an editor while a derivation document is written
    #[command(after_help = super::lsp::ABOUT)]
    Lsp(super::lsp::LspArgs),
    /// Print the completions of a shell
    #[command(after_help = shell::COMPLETIONS)]
    Completions(CompletionsArgs),
    /// Print a manual page, or write all of them
    #[command(after_help = shell::MAN)]
    Man(ManArgs),
}

/// How a report is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// for people: the news, then a line each
    Text,
    /// for programs; the schemas are in docs
    Json,
    /// for the web
    Markdown,
}
