//! The grammar of `kane audit` and `kane draft`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

pub(super) const AUDIT_EXAMPLES: &str = "\
Examples:
  kane audit                              the paper, which the program carries with it
  kane audit --only 9                     one statement of it, by its label
  kane audit --explain 16                 its proof or witness, step by step
  kane audit - < notes.md                 a document from standard input
  kane audit notes.md --watch             again whenever it changes
  kane audit notes.md --out reports       writes reports/notes.html, .tex, .md and .json
  kane audit a.md b.md --format json      two documents, for programs
  kane audit --judges coq,z3              what a proof assistant and a solver say, too

A document is Markdown with blocks tagged `kane`. Every claim in it ends proved, refuted, \
ill-defined, vacuous, unsupported or undecided; `expect` says what its author thinks.

Exit codes:
  0  everything is as expected
  1  a claim is not, or another judge disagrees
  2  bad input or usage
  3  no document has a claim, or a judge is not installed";

pub(super) const DRAFT_EXAMPLES: &str = "\
Examples:
  kane draft paper.tex > paper.md         a document to go on from
  kane draft paper.tex > paper.md && kane audit paper.md
                                          what follows from what, as far as the guesses go

Every equation stands in the draft as printed and under its number. Those that can be read are \
statements; the others are quoted with the reason, which standard error lists, too. Which of them are \
premises, what a claim rests on, and the ranges of symbols are guesses from the words around them. \
docs/draft.md says how, and what is read.

Exit codes:
  0  every equation is read
  1  some are not
  2  bad input or usage
  3  there is no displayed equation";

/// Another judge of claims.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum JudgeName {
    /// a proof assistant: every certificate as a Coq proof
    Coq,
    /// a solver: every claim's opposite as polynomial conditions
    Z3,
}

#[derive(Args, Debug)]
pub(crate) struct AuditArgs {
    /// Documents to audit, `-` for standard input; a shipped one by its name; without one, the paper on oblique collisions
    #[arg(value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,

    /// Also write every form of each report, and its claims for Coq and SMT-LIB, into this directory
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// Also write the certificate of each document, and nothing else, into this directory
    #[arg(long, value_name = "DIR", conflicts_with = "out")]
    pub(crate) certificates: Option<PathBuf>,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = AuditFormat::Text)]
    pub(crate) format: AuditFormat,

    /// Put the claims to other judges too, which have to be installed
    #[arg(
        long,
        value_enum,
        value_delimiter = ',',
        value_name = "JUDGE",
        conflicts_with = "explain"
    )]
    pub(crate) judges: Vec<JudgeName>,

    /// Go on without the judges that are not installed
    #[arg(long, requires = "judges")]
    pub(crate) optional: bool,

    /// Show the statement with this label alone; may be repeated
    #[arg(long, value_name = "LABEL")]
    pub(crate) only: Vec<String>,

    /// Coefficient operations that one search may take before its claim is undecided [default: 40000000]
    ///
    /// With fewer, the number of states and of functions that are tried shrinks in the same measure.
    #[arg(long, value_name = "OPERATIONS", allow_negative_numbers = true)]
    pub(crate) budget: Option<u64>,

    /// Multiply every budget, of states, operations, functions and squares, by this number
    #[arg(
        long,
        value_name = "N",
        value_parser = clap::value_parser!(u64).range(1..=1_000_000),
        allow_negative_numbers = true
    )]
    pub(crate) effort: Option<u64>,

    /// Print the proof or the witness of the statement with this label, step by step; may be repeated
    #[arg(long, value_name = "LABEL", conflicts_with_all = ["format", "only", "out", "certificates"])]
    pub(crate) explain: Vec<String>,

    /// Judge again whenever a file changes, until Ctrl-C or the end of piped input
    #[arg(long)]
    pub(crate) watch: bool,
}

/// How the report on documents is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum AuditFormat {
    /// for people: the news, then a line each
    Text,
    /// for programs; the schemas are in docs
    Json,
    /// for the web
    Markdown,
    /// for editors and scanners of code: every claim beside its line, in SARIF 2.1.0
    Sarif,
    /// for a step of a GitHub workflow: what is not proved, beside its line
    Github,
}

#[derive(Args, Debug)]
pub(crate) struct DraftArgs {
    /// The paper: LaTeX, or Markdown if its name ends in `.md`; `-` for LaTeX from standard input
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
}
