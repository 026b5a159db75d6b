//! `kane chart`: speed against accuracy, growth, and the figures.

use kane::measure::chart::{Effort, chart};
use kane::measure::growth::growth;
use kane::report::chart::{self as digits, ChartReport};
use kane::report::figures as drawn;
use kane::report::growth::{self as size, GrowthReport};

use super::args::ChartArgs;
use super::delivery::Written;
use super::machine::machine;
use super::progress::Progress;
use super::{Outcome, bad_input, deliver, forms, prices};

/// Runs the verb.
pub(super) fn run(args: &ChartArgs) -> Outcome {
    let effort = if args.quick { Effort::Quick } else { Effort::Full };
    if let Some(file) = &args.file {
        return prices::run(args, file, effort);
    }
    let mut command = "kane chart".to_owned();
    for (flag, given) in [(" --growth", args.growth), (" --quick", args.quick)] {
        command.push_str(if given { flag } else { "" });
    }
    let delivered = match (args.figures, args.growth) {
        (true, _) => figures(args),
        (false, true) => by_size(args, effort, command),
        (false, false) => by_digit(args, effort, command),
    };
    delivered.err().unwrap_or(Outcome::AsExpected)
}

/// What the next digit costs.
fn by_digit(args: &ChartArgs, effort: Effort, command: String) -> Result<(), Outcome> {
    let mut progress = Progress::counting("rounds");
    let all = chart(effort, &mut |done, all| progress.update(done, all));
    drop(progress);
    let report = ChartReport { all: &all, machine: machine(), command };
    let sheet = digits::sheet(&report);
    let files = || {
        let mut files = forms::files("chart", &sheet, digits::json(&report));
        files.push(Written::new("chart.csv", digits::csv(&report)));
        Ok(files)
    };
    let shown = || forms::printed(args.format, &sheet, || digits::json(&report));
    deliver(args.out.as_deref(), &[], files, shown)
}

/// How cost grows with size.
fn by_size(args: &ChartArgs, effort: Effort, command: String) -> Result<(), Outcome> {
    let mut progress = Progress::counting("steps");
    let growth = growth(effort, &mut |done, all| progress.update(done, all));
    drop(progress);
    let report = GrowthReport { growth: &growth, machine: machine(), command };
    let sheet = size::sheet(&report);
    let files = || {
        let mut files = forms::files("growth", &sheet, size::json(&report));
        files.push(Written::new("growth.csv", size::csv(&report)));
        Ok(files)
    };
    let shown = || forms::printed(args.format, &sheet, || size::json(&report));
    deliver(args.out.as_deref(), &[], files, shown)
}

/// What the laws say, drawn.
fn figures(args: &ChartArgs) -> Result<(), Outcome> {
    let mut progress = Progress::counting("points");
    let figures = kane::figures::figures(&mut |done, all| progress.update(done, all));
    drop(progress);
    let figures = figures.map_err(|error| bad_input(&error.to_string()))?;
    let files = || {
        let mut files = Vec::new();
        for figure in &figures {
            let picture = drawn::svg(figure);
            for (ending, text) in [("svg", picture), ("csv", drawn::csv(figure))] {
                files.push(Written::new(format!("{}.{ending}", figure.stem), text));
            }
        }
        Ok(files)
    };
    deliver(args.out.as_deref(), &[], files, || drawn::text(&figures))
}
