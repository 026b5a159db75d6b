//! `kane chart FILE`: speed against accuracy of the formulas of a document or of FPCore.

use std::path::Path;

use kane::floats::Core;
use kane::measure::Ranges;
use kane::measure::certify::{Work, core_of};
use kane::measure::chart::Effort;
use kane::measure::prices::prices;
use kane::report::prices::{PricesReport, csv, json, sheet};

use super::args::ChartArgs;
use super::delivery::Written;
use super::input::{self, Input, quoted_file};
use super::machine::machine;
use super::progress::Progress;
use super::{Outcome, bad_input, deliver, floats, forms, output};

/// Runs the verb on a file.
pub(super) fn run(args: &ChartArgs, file: &Path, effort: Effort) -> Outcome {
    let Some(ranges) = floats::ranges(&args.range, args.full_line) else {
        return Outcome::BadInput;
    };
    let (inputs, unreadable) = input::read(&[file.to_owned()]);
    for error in &unreadable {
        bad_input(&error.message);
    }
    let Some(input) = inputs.first() else { return Outcome::BadInput };
    let cores = match cores(input, file, &ranges) {
        Ok(cores) => cores,
        Err(outcome) => return outcome,
    };
    let (mut all, mut left_out) = (Vec::new(), Vec::new());
    let mut progress = Progress::counting("formulas");
    let count = cores.len();
    for (index, (label, core)) in cores.into_iter().enumerate() {
        progress.update(index, count);
        match prices(&label, &core, Work::brief(), effort, &mut |_, _| {}) {
            Ok(found) if !found.ways.is_empty() => all.push(found),
            Ok(_) => left_out.push((label, "it has no value at most inputs".to_owned())),
            Err(name) => left_out.push((label, format!("no float is in the range of {name}"))),
        }
    }
    drop(progress);
    let mut command = format!("kane chart {}", quoted_file(&file.display().to_string()));
    command.push_str(&floats::range_flags(&args.range, args.full_line));
    command.push_str(if args.quick { " --quick" } else { "" });
    let name = input.name.clone();
    let report = PricesReport { name, all: &all, left_out, machine: machine(), command };
    let sheet = sheet(&report);
    let written = || {
        let stem = format!("{}-prices", input.stem);
        let mut files = forms::files(&stem, &sheet, json(&report));
        files.push(Written::new(format!("{stem}.csv"), csv(&report)));
        Ok(files)
    };
    let shown = || forms::printed(args.format, &sheet, || json(&report));
    if let Err(outcome) = deliver(args.out.as_deref(), &[file], written, shown) {
        return outcome;
    }
    if all.is_empty() { Outcome::Nothing } else { Outcome::AsExpected }
}

/// The formulas with what they are called; says why if there are none to be had.
fn cores(input: &Input, file: &Path, ranges: &Ranges) -> Result<Vec<(String, Core)>, Outcome> {
    if floats::is_fpcore(file) {
        let cores = floats::cores(input, ranges)?;
        return Ok(cores
            .into_iter()
            .enumerate()
            .map(|(index, core)| (floats::label(&core, index), core))
            .collect());
    }
    let document = match kane::audit::read(&input.name, &input.bytes) {
        Ok(document) => document,
        Err(faults) => {
            for fault in faults {
                output::to_stderr(&format!("{fault}\n"));
            }
            return Err(Outcome::BadInput);
        }
    };
    let found = kane::measure::formulas(&document).formulas;
    let names = found.iter().flat_map(|formula| &formula.inputs).map(|input| input.name.as_str());
    if !floats::known(ranges, names) {
        return Err(Outcome::BadInput);
    }
    Ok(found.iter().map(|formula| (formula.label.clone(), core_of(formula, ranges))).collect())
}
