//! `kane stability`: where the formulas of a document fail in floating point, bounds, and repairs.

use std::path::Path;

use kane::floats::rigor::Inputs;
use kane::measure::certify::{Account, Work, account, core_of};
use kane::measure::{self, Ranges, Stability};
use kane::report::stability::{StabilityReport, csv, json, sheet};

use super::args::StabilityArgs;
use super::delivery::Written;
use super::input::{self, quoted_file};
use super::progress::Progress;
use super::{Outcome, bad_input, deliver, floats, forms, output};

/// Runs the verb.
pub(super) fn run(args: &StabilityArgs) -> Outcome {
    let Some(ranges) = floats::ranges(&args.range, args.full_line) else {
        return Outcome::BadInput;
    };
    let files: Vec<_> = args.file.iter().cloned().collect();
    let (inputs, unreadable) = input::read(&files);
    for error in &unreadable {
        bad_input(&error.message);
    }
    let Some(input) = inputs.first() else { return Outcome::BadInput };
    if let Some(file) = args.file.as_deref().filter(|file| floats::is_fpcore(file)) {
        return floats::run(args, input, file, &ranges);
    }
    let document = match kane::audit::read(&input.name, &input.bytes) {
        Ok(document) => document,
        Err(faults) => {
            for fault in faults {
                output::to_stderr(&format!("{fault}\n"));
            }
            return Outcome::BadInput;
        }
    };
    let found = measure::formulas(&document);
    let names = found.formulas.iter().flat_map(|f| &f.inputs).map(|input| input.name.as_str());
    if !floats::known(&ranges, names) {
        return Outcome::BadInput;
    }
    let mut progress = Progress::counting("formats of formulas");
    // beside the paper, the forms that the program knows are examined themselves
    let all = args.file.is_none();
    let stability = measure::examine_over(&document, all, &ranges, &mut |done, all| {
        progress.update(done, all);
    });
    drop(progress);
    let accounts =
        if args.file.is_some() { accounts(&stability, args.rounded_inputs) } else { Vec::new() };

    let command = match &args.file {
        None => format!("kane stability{}", floats::flags(args)),
        Some(file) => {
            format!(
                "kane stability {}{}",
                quoted_file(&file.display().to_string()),
                floats::flags(args)
            )
        }
    };
    let report = StabilityReport { stability: &stability, accounts: &accounts, command };
    let sheet = sheet(&report);
    let shown = || forms::printed(args.format, &sheet, || json(&report));
    let inputs: Vec<&Path> = files.iter().map(AsRef::as_ref).collect();
    let written = || {
        let stem = format!("{}-stability", input.stem);
        let mut files = forms::files(&stem, &sheet, json(&report));
        files.push(Written::new(format!("{stem}.csv"), csv(&report)));
        if !accounts.is_empty() {
            files.extend(floats::code(&stem, &accounts));
        }
        Ok(files)
    };
    if let Err(outcome) = deliver(args.out.as_deref(), &inputs, written, shown) {
        return outcome;
    }
    if stability.subject.examined == 0 { Outcome::Nothing } else { Outcome::AsExpected }
}

/// Bounds and repairs of every formula of the document. The ranges are in the formulas already.
fn accounts(stability: &Stability, rounded: bool) -> Vec<Account> {
    let inputs = if rounded { Inputs::Reals } else { Inputs::Floats };
    let work = Work { inputs, ..Work::brief() };
    let mut progress = Progress::counting("bounds");
    let own = stability.subject.own;
    let one = |(index, formula): (usize, &measure::Formula)| {
        progress.update(index, own);
        let core = core_of(formula, &Ranges::full_line());
        account(&formula.label, &core, work)
    };
    stability.subject.formulas.iter().take(own).enumerate().map(one).collect()
}
