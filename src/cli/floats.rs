//! `kane stability FILE.fpcore`: bounds, worst inputs and repairs of FPCore.

use std::path::Path;

use kane::algebra::syntax::Diagnostic;
use kane::floats::rigor::Inputs;
use kane::floats::{Core, fpcore};
use kane::measure::Ranges;
use kane::measure::certify::{Account, Work, account};
use kane::report::floats::{FloatsReport, json, questions, sheet, sources};

use super::args::StabilityArgs;
use super::delivery::Written;
use super::input::{Input, quoted, quoted_file};
use super::progress::Progress;
use super::{Outcome, bad_input, deliver, forms, output};

/// Whether a file holds FPCore, by its name.
pub(super) fn is_fpcore(file: &Path) -> bool {
    file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("fpcore"))
}

/// Runs the verb on FPCore.
pub(super) fn run(args: &StabilityArgs, input: &Input, file: &Path, ranges: &Ranges) -> Outcome {
    let cores = match cores(input, ranges) {
        Ok(cores) => cores,
        Err(outcome) => return outcome,
    };
    let accounts = accounts(cores, args.rounded_inputs);
    let command =
        format!("kane stability {}{}", quoted_file(&file.display().to_string()), flags(args));
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

/// The formulas of a file over the ranges that are examined; says what is wrong if it cannot be read, or has none.
pub(super) fn cores(input: &Input, ranges: &Ranges) -> Result<Vec<Core>, Outcome> {
    let Ok(text) = std::str::from_utf8(&input.bytes) else {
        output::to_stderr(&Diagnostic::not_utf8(&input.name, &input.bytes).to_string());
        return Err(Outcome::BadInput);
    };
    let mut cores = match fpcore::read(&input.name, text) {
        Ok(cores) => cores,
        Err(fault) => {
            output::to_stderr(&format!("{fault}\n"));
            return Err(Outcome::BadInput);
        }
    };
    if cores.is_empty() {
        bad_input(&format!("{} has no FPCore", input.name));
        return Err(Outcome::Nothing);
    }
    for core in &mut cores {
        narrow(core, ranges);
    }
    let names = || cores.iter().flat_map(|core| &core.arguments).map(|a| a.name.as_str());
    if known(ranges, names()) { Ok(cores) } else { Err(Outcome::BadInput) }
}

/// What a formula is called, by its place in the file.
pub(super) fn label(core: &Core, index: usize) -> String {
    core.name.clone().unwrap_or_else(|| format!("formula {}", index + 1))
}

/// The ranges that the user gives; says which one cannot be read.
pub(super) fn ranges(given: &[String], full_line: bool) -> Option<Ranges> {
    let mut ranges = Ranges { full_line, ..Ranges::default() };
    for range in given {
        if let Err(error) = ranges.add(range) {
            bad_input(&format!("--range {range}: {error}"));
            return None;
        }
    }
    Some(ranges)
}

/// The flags of ranges.
pub(super) fn range_flags(given: &[String], full_line: bool) -> String {
    let mut flags: String =
        given.iter().map(|range| format!(" --range {}", quoted(range))).collect();
    flags.push_str(if full_line { " --full-line" } else { "" });
    flags
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
        account(&label(&core, index), &core, work)
    };
    cores.into_iter().enumerate().map(one).collect()
}

/// The best forms as source code, and the bounds as questions to Gappa.
pub(super) fn code(stem: &str, accounts: &[Account]) -> Vec<Written> {
    let file =
        |(ending, text): (&str, String)| Written::question(format!("{stem}.{ending}"), &text);
    let questions = questions(accounts).into_iter();
    let question =
        |(ending, text): (String, String)| Written::question(format!("{stem}-{ending}"), &text);
    sources(accounts).into_iter().map(file).chain(questions.map(question)).collect()
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
    let mut flags = range_flags(&args.range, args.full_line);
    if args.rounded_inputs {
        flags.push_str(" --rounded-inputs");
    }
    flags
}
