//! `kane chart`: speed against accuracy.

use std::fs;
use std::io;
use std::path::Path;

use kane::measure::chart::{Effort, chart};
use kane::report::chart::{ChartReport, csv, json, markdown, text};
use kane::report::chart_picture;

use super::args::{ChartArgs, Format};
use super::progress::Progress;
use super::{Outcome, deliver, output};

/// Runs the verb.
pub(super) fn run(args: &ChartArgs) -> Outcome {
    let effort = if args.quick { Effort::Quick } else { Effort::Full };
    let mut progress = Progress::counting("rounds");
    let all = chart(effort, &mut |done, all| progress.update(done, all));
    drop(progress);
    let command = if args.quick { "kane chart --quick" } else { "kane chart" };
    let report = ChartReport { all: &all, machine: machine(), command: command.to_owned() };
    let shown = || match args.format {
        Format::Text => text(&report, output::page()),
        Format::Markdown => markdown(&report),
        Format::Json => json(&report),
    };
    if let Err(outcome) = deliver(args.out.as_deref(), |dir| write(dir, &report), shown) {
        return outcome;
    }
    Outcome::AsExpected
}

/// Writes chart in every form.
fn write(dir: &Path, report: &ChartReport<'_>) -> io::Result<()> {
    fs::create_dir_all(dir)?;
    let picture = chart_picture(report).map_err(io::Error::other)?;
    let forms =
        [("md", markdown(report)), ("json", json(report)), ("csv", csv(report)), ("svg", picture)];
    for (ending, text) in forms {
        output::to_file(&dir.join(format!("chart.{ending}")), &text)?;
    }
    Ok(())
}

/// The processor as far as it says, how many there are, and how the program was compiled.
fn machine() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info
        .lines()
        .find_map(|line| line.strip_prefix("model name"))
        .map(|rest| rest.trim_start_matches([' ', '\t', ':']).trim().to_owned());
    let model = model.unwrap_or_else(|| "processor unknown".to_owned());
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let fused = if cfg!(target_feature = "fma") { "with fused multiply-add" } else { "no fma" };
    let build = if cfg!(debug_assertions) { "unoptimised build" } else { "release build" };
    let (os, arch) = (std::env::consts::OS, std::env::consts::ARCH);
    let compiler = env!("KANE_RUSTC");
    format!("{model}, {cores} cores, {os} {arch}, {fused}; {compiler}, {build}")
}
