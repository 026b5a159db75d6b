//! `kane stability FILE.fpcore`: bounds, worst inputs and repairs of FPCore.

use std::path::Path;

use kane::floats::rigor::Inputs;
use kane::floats::{Core, fpcore};
use kane::measure::Ranges;
use kane::measure::certify::{Account, Work, account};
use kane::report::floats::{FloatsReport, json, sheet, sources};

use super::args::StabilityArgs;
use super::delivery::Written;
use super::input::{Input, quoted};
use super::progress::Progress;
use super::{Outcome, bad_input, deliver, forms, output};

/// Whether a file holds FPCore, by its name.
pub(super) fn is_fpcore(file: &Path) -> bool {
    file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("fpcore"))
}

/// Runs the verb on FPCore.
pub(super) fn run(args: &StabilityArgs, input: &Input, file: &Path, ranges: &Ranges) -> Outcome {
    let Ok(text) = std::str::from_utf8(&input.bytes) else {
        bad_input(&format!("{} is not UTF-8", input.name));
        return Outcome::BadInput;
    };
    let mut cores = match fpcore::read(&input.name, text) {
        Ok(cores) => cores,
        Err(fault) => {
            output::to_stderr(&format!("{fault}\n"));
            return Outcome::BadInput;
        }
    };
    for core in &mut cores {
        narrow(core, ranges);
    }
    let names = || cores.iter().flat_map(|core| &core.arguments).map(|a| a.name.as_str());
    if !known(ranges, names()) {
        return Outcome::BadInput;
    }
    let accounts = accounts(cores, args.rounded_inputs);
    let command = format!("kane stability {}{}", quoted(&file.display().to_string()), flags(args));
    let report = FloatsReport { name: input.name.clone(), accounts: &accounts, command };
    let sheet = sheet(&report);
    let shown = || forms::printed(args.format, &sheet, || json(&report));
    let written = || {
        let stem = format!("{}-floats", input.stem);
        let mut files = forms::files(&stem, &sheet, json(&report));
        files.extend(code(&stem, &accounts));
        Ok(files)
    };
    match deliver(args.out.as_deref(), &[file], written, shown) {
        Ok(()) => Outcome::AsExpected,
        Err(outcome) => outcome,
    }
}

/// The arguments over the ranges that are examined.
fn narrow(core: &mut Core, ranges: &Ranges) {
    for argument in &mut core.arguments {
        let (lower, upper) = (argument.lower.as_ref(), argument.upper.as_ref());
        (argument.lower, argument.upper) = ranges.of(&argument.name, lower, upper);
    }
}

fn accounts(cores: Vec<Core>, rounded: bool) -> Vec<Account> {
    let inputs = if rounded { Inputs::Reals } else { Inputs::Floats };
    let work = Work { inputs, ..Work::default() };
    let mut progress = Progress::counting("formulas");
    let all = cores.len();
    let one = |(index, core): (usize, Core)| {
        progress.update(index, all);
        let label = core.name.clone().unwrap_or_else(|| format!("formula {}", index + 1));
        account(&label, &core, work)
    };
    cores.into_iter().enumerate().map(one).collect()
}

/// The best forms as source code.
pub(super) fn code(stem: &str, accounts: &[Account]) -> Vec<Written> {
    let file =
        |(ending, text): (&str, String)| Written::question(format!("{stem}.{ending}"), &text);
    sources(accounts).into_iter().map(file).collect()
}

/// Whether every range that the user gives is of an input that there is; says so if not.
pub(super) fn known<'a>(ranges: &Ranges, names: impl Iterator<Item = &'a str>) -> bool {
    let mut all: Vec<&str> = names.collect();
    all.sort_unstable();
    all.dedup();
    for (name, ..) in &ranges.given {
        if !all.contains(&name.as_str()) {
            let inputs = all.join(", ");
            bad_input(&format!("no formula has an input {name:?}; the inputs are: {inputs}"));
            return false;
        }
    }
    true
}

/// The flags of a command that prints a report again.
pub(super) fn flags(args: &StabilityArgs) -> String {
    let mut flags: String =
        args.range.iter().map(|range| format!(" --range {}", quoted(range))).collect();
    if args.full_line {
        flags.push_str(" --full-line");
    }
    if args.rounded_inputs {
        flags.push_str(" --rounded-inputs");
    }
    flags
}
