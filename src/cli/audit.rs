//! `kane audit`: reads documents, judges them, prints the reports.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use kane::audit::{Audit, Body, Document, Options};
use kane::report::{self, Report};

use super::args::{AuditArgs, Format};
use super::input::{self, Input, quoted};
use super::progress::Progress;
use super::{Outcome, bad_input, deliver, labels, output};

/// Runs the verb.
pub(super) fn run(args: &AuditArgs) -> Outcome {
    let (inputs, unreadable) = input::read(&args.files);
    if let Some(twin) = args.out.as_ref().and_then(|_| twin(&inputs)) {
        return bad_input(&format!(
            "two documents are called `{twin}`; --out would write one over the other"
        ));
    }
    let (documents, faults) = documents(&inputs);
    for error in &unreadable {
        bad_input(error);
    }
    output::to_stderr(&faults);
    if !(unreadable.is_empty() && faults.is_empty()) {
        return Outcome::BadInput;
    }
    let wanted: Vec<&String> = args.only.iter().chain(&args.explain).collect();
    for label in &wanted {
        if documents.iter().all(|document| labels::find(document, label).is_empty()) {
            return bad_input(&labels::unknown(&documents, label));
        }
    }

    let mut audits = Vec::new();
    for (input, document) in inputs.iter().zip(documents) {
        let chosen = (!wanted.is_empty()).then(|| {
            wanted.iter().flat_map(|label| labels::find(&document, label)).collect::<Vec<_>>()
        });
        audits.push((input, judge(document, chosen.as_deref()), chosen));
    }
    let (inputs, reports): (Vec<&Input>, Vec<Report<'_>>) = audits
        .iter()
        .filter(|(_, _, chosen)| chosen.as_ref().is_none_or(|indices| !indices.is_empty()))
        .map(|(input, audit, chosen)| {
            let report = Report::new(audit, command(input, &args.only));
            (*input, chosen.iter().fold(report, |report, indices| report.only(indices)))
        })
        .unzip();

    let shown = || match args.explain {
        Some(_) => explanations(&reports),
        None => print(&reports, args.format),
    };
    let written = |dir: &Path| write(dir, &inputs, &reports);
    if let Err(outcome) = deliver(args.out.as_deref(), written, shown) {
        return outcome;
    }
    outcome(&reports)
}

/// The documents that could be read, and everything that is wrong with the others.
fn documents(inputs: &[Input]) -> (Vec<Document>, String) {
    let mut documents = Vec::new();
    let mut faults = String::new();
    for input in inputs {
        match kane::audit::read(&input.name, &input.bytes) {
            Ok(document) => documents.push(document),
            Err(found) => {
                for diagnostic in found {
                    faults.push_str(&diagnostic.to_string());
                    faults.push('\n');
                }
            }
        }
    }
    (documents, faults)
}

/// Judges the document, or of it only what is asked for and what that cites.
fn judge(document: Document, chosen: Option<&[usize]>) -> Audit {
    let options = Options { only: chosen.map(<[usize]>::to_vec), ..Options::default() };
    let mut progress = Progress::new();
    kane::audit::audit(document, &options, &mut |done, all| progress.update(done, all))
}

/// The command that prints one document's report again.
fn command(input: &Input, only: &[String]) -> String {
    let mut command = input.command.clone();
    for label in only {
        command.push_str(" --only ");
        command.push_str(&quoted(label));
    }
    command
}

/// The reports in one string.
fn print(reports: &[Report<'_>], format: Format) -> String {
    let join = |each: &dyn Fn(&Report<'_>) -> String| {
        reports.iter().map(each).collect::<Vec<_>>().join("\n")
    };
    match format {
        Format::Text => {
            let page = output::page();
            join(&|report| report::text(report, page))
        }
        Format::Markdown => join(&|report| report::markdown(report)),
        Format::Json => report::json(reports),
    }
}

/// The chosen statements in full.
fn explanations(reports: &[Report<'_>]) -> String {
    let each = reports.iter().flat_map(|report| {
        report.shown.iter().filter_map(|&index| report::explain(report.audit, index))
    });
    each.collect::<Vec<_>>().join("\n")
}

/// Writes NAME in every form for every report.
fn write(dir: &Path, inputs: &[&Input], reports: &[Report<'_>]) -> std::io::Result<()> {
    fs::create_dir_all(dir)?;
    for (input, report) in inputs.iter().zip(reports) {
        let forms = [
            ("html", report::html(report)),
            ("md", report::markdown(report)),
            ("tex", report::latex(report)),
            ("json", report::json(std::slice::from_ref(report))),
        ];
        for (ending, text) in forms {
            output::to_file(&dir.join(format!("{}.{ending}", input.stem)), &text)?;
        }
    }
    Ok(())
}

/// A name that two documents share.
fn twin(inputs: &[Input]) -> Option<&str> {
    let mut seen = BTreeSet::new();
    inputs.iter().map(|input| input.stem.as_str()).find(|stem| !seen.insert(*stem))
}

/// How the run ends.
fn outcome(reports: &[Report<'_>]) -> Outcome {
    let is_claim = |body: &Body| matches!(body, Body::Claim(_));
    let mut statements = reports.iter().flat_map(|report| &report.audit.document.statements);
    if !reports.iter().all(Report::as_expected) {
        Outcome::Unexpected
    } else if statements.any(|statement| is_claim(&statement.body)) {
        Outcome::AsExpected
    } else {
        Outcome::Nothing
    }
}
