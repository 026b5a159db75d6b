//! `kane-lake`: logs of impacts in a query engine.

mod args;
#[cfg(feature = "cluster")]
mod journal;

use std::io::Write as _;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser as _;
use datafusion::arrow::util::pretty::pretty_format_batches;
use datafusion::prelude::{SessionConfig, SessionContext};
use kane_algebra::syntax::printable;
use kane_lake::{Asked, LakeFault, Reading, Whole, check, open};
use kane_report::Page;
use kane_report::records::{RecordsReport, json, sheet};

use crate::args::{CheckArgs, Cli, Format, LogArgs, SqlArgs, Verb};

/// Exit codes, as those of `kane`.
const UNEXPECTED: u8 = 1;
const BAD: u8 = 2;
const NOTHING: u8 = 3;

fn main() -> ExitCode {
    let cli = Cli::parse();
    let runtime = match tokio::runtime::Runtime::new() {
        Ok(runtime) => runtime,
        Err(error) => return bad(&format!("cannot start: {error}")),
    };
    match runtime.block_on(run(cli.verb)) {
        Ok(code) => code,
        Err(message) => bad(&message),
    }
}

async fn run(verb: Verb) -> Result<ExitCode, String> {
    match verb {
        Verb::Check(args) => checked(&args).await,
        Verb::Sql(args) => answered(&args).await,
        Verb::Functions => Ok(printed(&functions())),
        #[cfg(feature = "cluster")]
        Verb::Scheduler(args) => {
            journal::begin(args.journal);
            let options =
                kane_lake::cluster::SchedulerOptions { bind: args.bind, patience: args.patience };
            let ended = kane_lake::cluster::scheduler(&options).await;
            ended.map(|()| ExitCode::SUCCESS).map_err(|fault| fault.to_string())
        }
        #[cfg(feature = "cluster")]
        Verb::Executor(args) => {
            journal::begin(args.journal);
            let options = kane_lake::cluster::ExecutorOptions {
                bind: args.bind,
                tasks: args.tasks,
                scheduler: args.scheduler,
                cores: args.cores,
                work: args.work,
            };
            let ended = kane_lake::cluster::executor(&options).await;
            ended.map(|()| ExitCode::SUCCESS).map_err(|fault| fault.to_string())
        }
    }
}

async fn checked(args: &CheckArgs) -> Result<ExitCode, String> {
    let session = session(&args.log).await?;
    let log = open(&session, &args.logs, reading(&args.log)?).await.map_err(said)?;
    let study = match check(&session, &log).await {
        Ok(study) => study,
        Err(LakeFault::Parts("there is no row")) => return Ok(ExitCode::from(NOTHING)),
        Err(fault) => return Err(said(fault)),
    };
    let names: Vec<String> = args.logs.iter().map(|log| log.display().to_string()).collect();
    let name = names.join(" ");
    let command = format!("kane-lake check {name}");
    let report = RecordsReport { study: &study, log: &name, command: &command };
    let text = match args.format {
        Format::Text => sheet(&report).text(Page::default()),
        Format::Markdown => sheet(&report).markdown(),
        Format::Json => json(&report),
    };
    let shown = printed(&text);
    Ok(match study.rows {
        _ if shown != ExitCode::SUCCESS => shown,
        0 => ExitCode::from(NOTHING),
        _ if study.as_expected() => shown,
        _ => ExitCode::from(UNEXPECTED),
    })
}

async fn answered(args: &SqlArgs) -> Result<ExitCode, String> {
    let Some((query, logs)) = args.logs_and_query.split_last() else {
        return Err("give a log, and a query".to_owned());
    };
    let logs: Vec<PathBuf> = logs.iter().map(PathBuf::from).collect();
    let session = session(&args.log).await?;
    open(&session, &logs, reading(&args.log)?).await.map_err(said)?;
    let answer = session.sql(query).await.map_err(|error| said(error.into()))?;
    let batches = answer.collect().await.map_err(|error| said(error.into()))?;
    let table = pretty_format_batches(&batches).map_err(|error| error.to_string())?;
    Ok(printed(&format!("{table}\n")))
}

/// The session that answers: this process, or a cluster.
async fn session(args: &LogArgs) -> Result<SessionContext, String> {
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let parts = args.parts.unwrap_or(cores).max(1);
    #[cfg(feature = "cluster")]
    if let Some(scheduler) = &args.cluster {
        let session = kane_lake::cluster::session(scheduler, parts).await;
        return session.map_err(|fault| fault.to_string());
    }
    Ok(SessionContext::new_with_config(SessionConfig::new().with_target_partitions(parts)))
}

fn reading(args: &LogArgs) -> Result<Reading, String> {
    let mut map = Vec::new();
    for pair in &args.map {
        let (ours, theirs) = pair
            .split_once('=')
            .ok_or_else(|| format!("--map takes OURS=THEIRS, and `{pair}` has no `=`"))?;
        map.push((ours.to_owned(), theirs.to_owned()));
    }
    Ok(Reading { map, numbers: args.float })
}

/// A fault without the frames that the query engine puts around it.
fn said(fault: LakeFault) -> String {
    match fault {
        LakeFault::Engine(error) => error.strip_backtrace(),
        other => other.to_string(),
    }
}

fn functions() -> String {
    let mut text = String::from(
        "Functions of a row; without arguments they take the columns of the table by their names:\n\n",
    );
    for asked in Asked::all() {
        text.push_str(&format!("  {:<28}{}\n", asked.function(), asked.meaning()));
    }
    text.push_str("\nFunctions of many rows, with or without GROUP BY:\n\n");
    for whole in Whole::ALL {
        text.push_str(&format!("  {:<28}{}\n", whole.function(), whole.meaning()));
    }
    text
}

/// Prints; a reader that has seen enough is no error.
fn printed(text: &str) -> ExitCode {
    let mut out = std::io::stdout().lock();
    match out.write_all(printable(text).as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            bad(&format!("cannot print: {error}"))
        }
        _ => ExitCode::SUCCESS,
    }
}

fn bad(message: &str) -> ExitCode {
    let _ = writeln!(std::io::stderr().lock(), "error: {}", printable(message));
    ExitCode::from(BAD)
}
