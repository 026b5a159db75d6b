//! The grammar of `kane check`.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, ValueEnum};

pub(super) const CHECK_EXAMPLES: &str = "\
Examples:
  kane check impacts.csv                  what the log follows, in a sentence, and every check
  kane check impacts.jsonl --out reports  also writes reports/impacts-check.html, .svg and more
  kane check - < impacts.csv              a log from standard input
  kane check --schema                     the columns, with their units
  kane check log.csv --preset mujoco      columns called qvel[0] before, qvel[1] before, ...
  kane check log.csv --map vx1_pre_m_s=speed_in
                                          a column by another name
  kane check log.csv --row 17             the collision of line 17, for kane collide
  kane check --generate > sweep.csv       impacts for an engine to run, that tell laws apart
  kane check new.csv --baseline old.csv   whether a new version does worse
  kane check log.csv --format junit       every check as a test, for continuous integration

A log has one row an impact: mass, inertia (or radius and shape), arm (or radius), velocity and spin \
before and after; mu, e, the time step and more if they are known. See docs/records.md.

Exit codes:
  0  every check holds, or fails as a published law that gives every row has it; with --baseline,
     nothing is worse than before
  1  a check fails or is undecided, a row is rejected, or units are suspected; with --baseline,
     something is worse
  2  bad input or usage
  3  no row could be checked; with --baseline, none of one of the logs";

#[derive(Args, Debug)]
pub(crate) struct CheckArgs {
    /// The log, CSV or JSON lines (.jsonl, .ndjson, .json); - for standard input
    #[arg(value_name = "LOG", required_unless_present_any = ["schema", "generate"])]
    pub(crate) log: Option<PathBuf>,

    /// Print the columns of a log, and stop
    #[arg(long, conflicts_with_all = ["log", "generate"])]
    pub(crate) schema: bool,

    /// Print a sweep of impacts that would tell laws apart, as CSV for an engine to run, and stop
    #[arg(long, conflicts_with = "log")]
    pub(crate) generate: bool,

    /// Whose names the columns have, where these say nothing by themselves; --map goes before
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(presets()))]
    pub(crate) preset: Option<String>,

    /// What a column of the schema is called in the log; may be repeated
    #[arg(long, value_name = "OURS=THEIRS")]
    pub(crate) map: Vec<String>,

    /// The log is JSON lines, whatever its name
    #[arg(long)]
    pub(crate) jsonl: bool,

    /// In which format the numbers were computed, if they do not tell: f32, f64, a count of decimals, or `6 digits`
    #[arg(long, value_name = "FORMAT")]
    pub(crate) float: Option<String>,

    /// How far coordinates reach in the engine's world, in contact arms; 0 if the normal and the arm do not come from positions
    #[arg(
        long,
        value_name = "ARMS",
        default_value_t = kane::records::tolerance::EXTENT,
        allow_negative_numbers = true
    )]
    pub(crate) extent: f64,

    /// Print the collision of this line as a file for kane collide, and stop
    #[arg(long, value_name = "LINE", allow_negative_numbers = true)]
    pub(crate) row: Option<u64>,

    /// Compare with an older log: exit code 1 if a check or the law does worse
    #[arg(long, value_name = "OLD", conflicts_with = "out")]
    pub(crate) baseline: Option<PathBuf>,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = CheckFormat::Text)]
    pub(crate) format: CheckFormat,

    /// Also write NAME-check.html, .txt, .md, .tex, .json, .svg and .xml (JUnit) into this directory
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

/// The names of presets, with whose they are.
fn presets() -> impl Iterator<Item = PossibleValue> {
    kane::records::preset::PRESETS
        .iter()
        .map(|preset| PossibleValue::new(preset.name).help(preset.of))
}

/// How the report on a log is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum CheckFormat {
    /// for people: the news, then a line each
    Text,
    /// for programs; the schemas are in docs
    Json,
    /// for the web
    Markdown,
    /// for continuous integration: each check as a test of JUnit's XML
    Junit,
    /// for editors and scanners of code: every check beside its worst row, in SARIF 2.1.0
    Sarif,
    /// for a step of a GitHub workflow: what fails, beside its row
    Github,
}
