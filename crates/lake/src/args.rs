//! The command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use kane_lake::Numbers;

/// Checks logs of impacts in Parquet, Arrow and CSV, and answers queries about them.
#[derive(Debug, Parser)]
#[command(name = "kane-lake", version, arg_required_else_help = true, after_help = EXIT)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) verb: Verb,
}

const EXIT: &str = "\
Exit codes:
  0  everything is as expected
  1  a check fails, or a row is rejected
  2  bad input or usage
  3  no row could be checked";

#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Check a log as `kane check` does
    Check(CheckArgs),
    /// Answer a query over a log, which is the table `log`
    Sql(SqlArgs),
    /// List the functions
    Functions,
    /// Run the scheduler of a cluster
    #[cfg(feature = "cluster")]
    Scheduler(SchedulerArgs),
    /// Run an executor of a cluster
    #[cfg(feature = "cluster")]
    Executor(ExecutorArgs),
}

/// What both verbs ask of a log.
#[derive(Args, Debug)]
pub(crate) struct LogArgs {
    /// What a column of the schema is called in the log; may be repeated
    #[arg(long, value_name = "OURS=THEIRS")]
    pub(crate) map: Vec<String>,

    /// The format of the numbers: f64, f32, `4 decimals` or `6 digits`, and perhaps `, extent 1000`;
    /// without it the first rows tell
    #[arg(long, value_name = "FORMAT")]
    pub(crate) float: Option<Numbers>,

    /// Parts that are worked on at once; as many as there are cores if it is not given
    #[arg(long, value_name = "N")]
    pub(crate) parts: Option<usize>,

    /// Have a cluster do it: its scheduler
    #[cfg(feature = "cluster")]
    #[arg(long, value_name = "HOST:PORT")]
    pub(crate) cluster: Option<String>,
}

#[derive(Args, Debug)]
pub(crate) struct CheckArgs {
    /// Files of one form: .parquet, .pq, .arrow, .feather, .csv, .tsv, .txt; or directories of them
    #[arg(value_name = "LOG", required = true)]
    pub(crate) logs: Vec<PathBuf>,

    #[command(flatten)]
    pub(crate) log: LogArgs,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
}

#[derive(Args, Debug)]
pub(crate) struct SqlArgs {
    /// Files of one form, or directories of them, and the query last
    #[arg(value_name = "LOG… QUERY", required = true, num_args = 2..)]
    pub(crate) logs_and_query: Vec<String>,

    #[command(flatten)]
    pub(crate) log: LogArgs,
}

#[cfg(feature = "cluster")]
#[derive(Args, Debug)]
pub(crate) struct SchedulerArgs {
    /// Where to listen
    #[arg(long, value_name = "HOST:PORT", default_value = "127.0.0.1:50050")]
    pub(crate) bind: String,

    /// Give an executor up that says nothing for so many seconds; they speak every two seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 30)]
    pub(crate) patience: u64,

    /// What to say on standard error
    #[arg(long, value_enum, value_name = "LEVEL", default_value_t = Level::Warn)]
    pub(crate) journal: Level,
}

#[cfg(feature = "cluster")]
#[derive(Args, Debug)]
pub(crate) struct ExecutorArgs {
    /// Where to listen for other executors
    #[arg(long, value_name = "HOST:PORT", default_value = "127.0.0.1:50051")]
    pub(crate) bind: String,

    /// Where to listen for tasks, on the same host
    #[arg(long, value_name = "PORT", default_value_t = 50052)]
    pub(crate) tasks: u16,

    /// The scheduler
    #[arg(long, value_name = "HOST:PORT", default_value = "127.0.0.1:50050")]
    pub(crate) scheduler: String,

    /// Tasks at once; as many as there are cores if it is 0
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) cores: usize,

    /// Where to keep results between stages; a directory of its own if it is not given
    #[arg(long, value_name = "DIR")]
    pub(crate) work: Option<PathBuf>,

    /// What to say on standard error
    #[arg(long, value_enum, value_name = "LEVEL", default_value_t = Level::Warn)]
    pub(crate) journal: Level,
}

/// How a report is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// for people
    Text,
    /// for programs
    Json,
    /// for a page
    Markdown,
}

/// How much a process of a cluster says.
#[cfg(feature = "cluster")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Level {
    /// nothing
    Off,
    /// what goes wrong
    Error,
    /// and what may
    Warn,
    /// and what happens
    Info,
    /// and how
    Debug,
}
