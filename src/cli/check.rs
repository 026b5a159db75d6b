//! `kane check`: what a log of impacts obeys.

use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::Path;

use kane::impact::laws;
use kane::records::comparison::compare;
use kane::records::format::NoFormat;
use kane::records::opening::opening;
use kane::records::preset::Preset;
use kane::records::reader::{Kind, names};
use kane::records::study::{Options, Study, study};
use kane::records::{replay, sweep};
use kane::report::records::{
    RecordsReport, compared_json, compared_junit, compared_markdown, compared_text, json, junit,
    schema, sheet,
};
use kane::report::remarks;

use super::args::{CheckArgs, CheckFormat, Format};
use super::delivery::Written;
use super::input::{quoted, quoted_file};
use super::{Outcome, bad_input, deliver, forms, output};

/// Bytes that are read at once.
const BUFFER: usize = 1 << 18;

/// Runs the verb.
pub(super) fn run(args: &CheckArgs) -> Outcome {
    if args.schema {
        return printed(&schema());
    }
    if args.generate {
        return printed(&sweep::csv());
    }
    let Some(log) = &args.log else { return bad_input("which log? Give a file, or -") };
    let options = match options(args) {
        Ok(options) => options,
        Err(message) => return bad_input(&message),
    };
    if let Some(line) = args.row {
        return row(args, log, line, &options);
    }
    let name = log.display().to_string();
    let study = match studied(args, log, &options) {
        Ok(study) => study,
        Err(message) => return unread(&name, message, args.format),
    };
    let command = command(args, &name);
    let beside_rows = matches!(args.format, CheckFormat::Sarif | CheckFormat::Github);
    if args.baseline.is_some() && beside_rows {
        return bad_input(
            "a comparison of two logs has no rows to put remarks beside; choose text, json or junit",
        );
    }
    if let Some(old) = &args.baseline {
        return baseline(args, old, &study, &options, &name);
    }
    let report = RecordsReport { study: &study, log: &name, command: &command };
    let sheet = sheet(&report);
    let printed = |format| forms::printed(format, &sheet, || json(&report));
    let shown = || match args.format {
        CheckFormat::Text => printed(Format::Text),
        CheckFormat::Json => printed(Format::Json),
        CheckFormat::Markdown => printed(Format::Markdown),
        CheckFormat::Junit => junit(&report),
        CheckFormat::Sarif => remarks::sarif(&remarks::of_log(&report)),
        CheckFormat::Github => remarks::workflow(&remarks::of_log(&report)),
    };
    let stem = log.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let files = || {
        let mut files = forms::files(&format!("{stem}-check"), &sheet, json(&report));
        files.push(Written::picture(format!("{stem}-check.xml"), &junit(&report)));
        Ok(files)
    };
    if let Err(outcome) = deliver(args.out.as_deref(), &[log], files, shown) {
        return outcome;
    }
    match study.rows {
        0 => Outcome::Nothing,
        _ if study.as_expected() => Outcome::AsExpected,
        _ => Outcome::Unexpected,
    }
}

/// Ends a run whose log cannot be checked. What puts remarks beside lines is told, too.
fn unread(name: &str, why: String, format: CheckFormat) -> Outcome {
    bad_input(&why);
    let remarks = [remarks::unread(name, why)];
    match format {
        CheckFormat::Sarif => printed(&remarks::sarif(&remarks)),
        CheckFormat::Github => printed(&remarks::workflow(&remarks)),
        CheckFormat::Text | CheckFormat::Json | CheckFormat::Markdown | CheckFormat::Junit => {
            Outcome::BadInput
        }
    };
    Outcome::BadInput
}

fn printed(text: &str) -> Outcome {
    match output::to_stdout(text) {
        Ok(()) => Outcome::AsExpected,
        Err(error) => bad_input(&format!("cannot print: {error}")),
    }
}

/// What the flags ask.
fn options(args: &CheckArgs) -> Result<Options<'static>, String> {
    let mut options = Options::new(laws());
    for pair in &args.map {
        let (ours, theirs) = pair
            .split_once('=')
            .ok_or_else(|| format!("--map takes OURS=THEIRS, and `{pair}` has no `=`"))?;
        options.map.push((ours.to_owned(), theirs.to_owned()));
    }
    let format = args.float.as_deref().map(str::parse).transpose();
    options.format = format.map_err(|wrong: NoFormat| format!("--float takes {wrong}"))?;
    if !(0.0..=1e12).contains(&args.extent) {
        return Err("--extent must be between 0 and 1e12 arms".to_owned());
    }
    options.extent = args.extent;
    Ok(options)
}

/// The form of the log.
fn kind(args: &CheckArgs, log: &Path) -> Kind {
    let ending = log.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    if args.jsonl || ["jsonl", "ndjson", "json"].contains(&&*ending) {
        Kind::JsonLines
    } else {
        Kind::Csv
    }
}

/// The bytes of the log.
fn file(log: &Path) -> Result<Box<dyn BufRead>, String> {
    if log.as_os_str() == "-" {
        return Ok(Box::new(BufReader::with_capacity(BUFFER, io::stdin())));
    }
    let file =
        File::open(log).map_err(|error| format!("cannot read {}: {error}", log.display()))?;
    Ok(Box::new(BufReader::with_capacity(BUFFER, file)))
}

/// Opens the log, and adds what the preset says of its names, which `--map` goes before.
fn opened<'a>(
    args: &CheckArgs,
    log: &Path,
    options: &Options<'a>,
) -> Result<(impl BufRead, Options<'a>), String> {
    let file = file(log)?;
    let (start, input) =
        opening(file).map_err(|error| format!("cannot read {}: {error}", log.display()))?;
    let mut options = options.clone();
    if let Some(preset) = args.preset.as_deref().and_then(Preset::named) {
        let mut map = preset.map(&names(&start, kind(args, log)));
        map.retain(|(ours, theirs)| {
            !options.map.iter().any(|(known, name)| known == ours || name == theirs)
        });
        options.map.extend(map);
    }
    Ok((input, options))
}

fn studied(args: &CheckArgs, log: &Path, options: &Options<'_>) -> Result<Study, String> {
    let (input, options) = opened(args, log, options)?;
    study(input, kind(args, log), &options).map_err(|fault| format!("{}: {fault}", log.display()))
}

/// The command that prints the report again.
fn command(args: &CheckArgs, name: &str) -> String {
    let mut command = format!("kane check {}", quoted_file(name));
    if let Some(preset) = &args.preset {
        command.push_str(&format!(" --preset {preset}"));
    }
    for pair in &args.map {
        command.push_str(&format!(" --map {}", quoted(pair)));
    }
    if args.jsonl {
        command.push_str(" --jsonl");
    }
    if let Some(float) = &args.float {
        command.push_str(&format!(" --float {}", quoted(float)));
    }
    if args.extent.to_bits() != kane::records::tolerance::EXTENT.to_bits() {
        command.push_str(&format!(" --extent {}", args.extent));
    }
    command
}

/// The collision of one line.
fn row(args: &CheckArgs, log: &Path, line: u64, options: &Options<'_>) -> Outcome {
    let (input, options) = match opened(args, log, options) {
        Ok(opened) => opened,
        Err(message) => return bad_input(&message),
    };
    match replay::of_line(input, kind(args, log), &options.map, line) {
        Ok(file) => printed(&file),
        Err(fault) => bad_input(&format!("{}: {fault}", log.display())),
    }
}

/// The log against an older one.
fn baseline(
    args: &CheckArgs,
    old: &Path,
    new: &Study,
    options: &Options<'_>,
    name: &str,
) -> Outcome {
    let before = match studied(args, old, options) {
        Ok(study) => study,
        Err(message) => return bad_input(&message),
    };
    let comparison = compare(&before, new);
    let names = [old.display().to_string(), name.to_owned()];
    let shown = match args.format {
        CheckFormat::Json => compared_json(&comparison, &names),
        CheckFormat::Junit => compared_junit(&comparison, &names),
        CheckFormat::Markdown => compared_markdown(&comparison, &names),
        CheckFormat::Text | CheckFormat::Sarif | CheckFormat::Github => {
            compared_text(&comparison, &names)
        }
    };
    match output::to_stdout(&shown) {
        Err(error) => bad_input(&format!("cannot print: {error}")),
        Ok(()) if !comparison.compares() => Outcome::Nothing,
        Ok(()) if comparison.is_worse() => Outcome::Unexpected,
        Ok(()) => Outcome::AsExpected,
    }
}
