//! `kane stability`: where the formulas of a document fail in floating point.

use std::path::Path;

use kane::measure;
use kane::report::stability::{StabilityReport, csv, json, sheet};

use super::args::StabilityArgs;
use super::delivery::Written;
use super::input::{self, quoted};
use super::progress::Progress;
use super::{Outcome, bad_input, deliver, forms, output};

/// Runs the verb.
pub(super) fn run(args: &StabilityArgs) -> Outcome {
    let files: Vec<_> = args.file.iter().cloned().collect();
    let (inputs, unreadable) = input::read(&files);
    for error in &unreadable {
        bad_input(error);
    }
    let Some(input) = inputs.first() else { return Outcome::BadInput };
    let document = match kane::audit::read(&input.name, &input.bytes) {
        Ok(document) => document,
        Err(faults) => {
            for fault in faults {
                output::to_stderr(&format!("{fault}\n"));
            }
            return Outcome::BadInput;
        }
    };
    let mut progress = Progress::counting("formats of formulas");
    // beside the paper, the forms that the program knows are examined themselves
    let stability = measure::examine(&document, args.file.is_none(), &mut |done, all| {
        progress.update(done, all);
    });
    drop(progress);

    let command = match &args.file {
        None => "kane stability".to_owned(),
        Some(file) => format!("kane stability {}", quoted(&file.display().to_string())),
    };
    let report = StabilityReport { stability: &stability, command };
    let sheet = sheet(&report);
    let shown = || forms::printed(args.format, &sheet, || json(&report));
    let inputs: Vec<&Path> = files.iter().map(AsRef::as_ref).collect();
    let written = || {
        let stem = format!("{}-stability", input.stem);
        let mut files = forms::files(&stem, &sheet, json(&report));
        files.push(Written::new(format!("{stem}.csv"), csv(&report)));
        Ok(files)
    };
    if let Err(outcome) = deliver(args.out.as_deref(), &inputs, written, shown) {
        return outcome;
    }
    if stability.subject.examined == 0 { Outcome::Nothing } else { Outcome::AsExpected }
}
