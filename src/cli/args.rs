//! The command line's grammar.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

/// Checks the derivations of collision laws, line by line.
#[derive(Debug, Parser)]
#[command(name = "kane", version, arg_required_else_help = true, after_help = EXIT)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) verb: Verb,
}

const EXIT: &str = "\
Exit codes:
  0  everything is as expected
  1  a claim or a check is not
  2  bad input or usage
  3  nothing could be checked";

const EXAMPLES: &str = "\
Examples:
  kane audit                              the paper, which the program carries with it
  kane audit --only 9                     one statement of it, by its label
  kane audit --explain 16                 its proof or witness, step by step
  kane audit notes.md --out reports       writes reports/notes.md and reports/notes.json
  kane audit a.md b.md --format json      two documents, for programs

A document is Markdown with blocks tagged `kane`. Every claim in it ends proved, refuted,
ill-defined, vacuous, unsupported or undecided; `expect` says what its author thinks.

Exit codes:
  0  everything is as expected
  1  a claim is not
  2  bad input or usage
  3  no document has a claim";

const CHART_EXAMPLES: &str = "\
Examples:
  kane chart --quick                      a first look, in some seconds
  kane chart --out charts                 also writes charts/chart.svg, .csv, .json and .md

A method is a form of a law in a number system. Its error is that at the worst of some hundred
inputs, alpha from 2^-30 to 2^30, against the exact value; its time is the median of several
rounds in which all methods take turns. A warning says where the clock contradicts the costs that
are counted in docs/data/methods.csv.";

const STABILITY_EXAMPLES: &str = "\
Examples:
  kane stability                          the paper, and the equal forms that the program knows
  kane stability notes.md                 the formulas of a document of yours
  kane stability --out maps               also writes maps/oblique-collision-stability.svg,
                                          .csv, .json and .md

A formula is evaluated as written, in f32 and in f64, over all positive inputs of its domain. It
fails where it returns NaN, an infinity, 0 or the wrong sign though the exact value is otherwise,
or where more than half of its bits are wrong. Ranges end at representable numbers.

Exit codes:
  0  the formulas are examined, whatever is found
  2  bad input or usage
  3  the document has no formula of one or two inputs";

#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Judge every statement of derivation documents
    #[command(after_help = EXAMPLES)]
    Audit(AuditArgs),
    /// Chart speed against accuracy: what the next digit costs
    #[command(after_help = CHART_EXAMPLES)]
    Chart(ChartArgs),
    /// Find where the formulas of a derivation document fail in floating point
    #[command(after_help = STABILITY_EXAMPLES)]
    Stability(StabilityArgs),
}

#[derive(Args, Debug)]
pub(crate) struct AuditArgs {
    /// Documents to audit; without one, the paper on oblique collisions
    #[arg(value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,

    /// Also write NAME.md and NAME.json for every document into this directory
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,

    /// Show the statement with this label alone; may be repeated
    #[arg(long, value_name = "LABEL")]
    pub(crate) only: Vec<String>,

    /// Print the proof or the witness of the statement with this label, step by step
    #[arg(long, value_name = "LABEL", conflicts_with_all = ["format", "only", "out"])]
    pub(crate) explain: Option<String>,
}

#[derive(Args, Debug)]
pub(crate) struct ChartArgs {
    /// Fewer and shorter rounds
    #[arg(long)]
    pub(crate) quick: bool,

    /// Also write chart.md, .json, .csv and .svg into this directory
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// How to print the table
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
}

#[derive(Args, Debug)]
pub(crate) struct StabilityArgs {
    /// The document; without one, the paper on oblique collisions
    #[arg(value_name = "DOCUMENT")]
    pub(crate) file: Option<PathBuf>,

    /// Also write NAME-stability.md, .json, .csv and .svg into this directory
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
}

/// How a report is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// the news, then one line a statement
    Text,
    /// for programs; see docs/report-schema.md
    Json,
    /// for the web, with formulas and proofs
    Markdown,
}
