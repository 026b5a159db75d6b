//! `kane audit`: reads documents, judges them, prints the reports.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use kane::audit::{Audit, Body, Diagnostic, Document, Memo, Options};
use kane::judges::{self, Claims, Judge, Limits, NotAsked, Theory};
use kane::report::remarks::{self, Remark, of_audit};
use kane::report::{self, Picture, Report};

use super::args::{AuditArgs, AuditFormat, JudgeName};
use super::delivery::Written;
use super::input::{self, Input, Unreadable, quoted};
use super::progress::Progress;
use super::{Outcome, bad_input, deliver, labels, output, watch};

/// Two figures for the paper, drawn beforehand: `docs/figures`, which the tests draw anew. With all of
/// them the page would be above a megabyte.
pub(super) const PICTURES: [Picture; 2] = {
    macro_rules! picture {
        ($stem:literal, $title:literal) => {
            Picture {
                title: $title,
                svg: include_str!(concat!("../../docs/figures/", $stem, ".svg")),
            }
        };
    }
    [
        picture!("slip-over-alpha", "k over α under all laws, with measured points"),
        picture!("energy-map", "at which friction and restitution laws create energy"),
    ]
};

/// Where the paper's question is answered as a whole.
const POINTER: &str = "docs/verdict.md answers Kane's puzzle on one page";

/// Runs the verb.
pub(super) fn run(args: &AuditArgs) -> Outcome {
    let mut memos = Memos::new();
    if args.watch {
        return watch::run(&args.files, &mut || once(args, Some(&mut memos)));
    }
    once(args, None)
}

/// By the name of a document, what was judged of it before.
type Memos = BTreeMap<String, Memo>;

/// Judges and shows the documents once.
fn once(args: &AuditArgs, mut memos: Option<&mut Memos>) -> Outcome {
    let (inputs, unreadable) = input::read(&args.files);
    let dir = args.out.as_deref().or(args.certificates.as_deref());
    if let Some(twin) = dir.and_then(|_| twin(&inputs)) {
        return bad_input(&format!(
            "two documents are called `{twin}`; the files of one would be written over the other's"
        ));
    }
    let (documents, faults) = documents(&inputs);
    for error in &unreadable {
        bad_input(&error.message);
    }
    for fault in &faults {
        output::to_stderr(&format!("{fault}\n"));
    }
    if !(unreadable.is_empty() && faults.is_empty()) {
        return unread(&unreadable, &faults, args.format);
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
        let memo = memos.as_mut().map(|memos| memos.entry(input.name.clone()).or_default());
        audits.push((input, judge(document, chosen.as_deref(), args, memo), chosen));
    }
    let (inputs, reports): (Vec<&Input>, Vec<Report<'_>>) = audits
        .iter()
        .filter(|(_, _, chosen)| chosen.as_ref().is_none_or(|indices| !indices.is_empty()))
        .map(|(input, audit, chosen)| {
            let report = Report::new(audit, command(input, args));
            let report = match input.is_paper() {
                true => report.with_pictures(&PICTURES).with_pointer(POINTER),
                false => report,
            };
            (*input, chosen.iter().fold(report, |report, indices| report.only(indices)))
        })
        .unzip();

    let mut coq = Coq { shares: reports.len() >= SHARING, theory: None };
    let answers = reports.iter().map(|report| ask(report, args, &mut coq)).collect();
    let answers: Vec<Vec<Judge>> = match answers {
        Ok(answers) => answers,
        Err(outcome) => return outcome,
    };
    let reports: Vec<Report<'_>> = reports
        .into_iter()
        .zip(&answers)
        .map(|(report, judges)| report.with_judges(judges))
        .collect();
    let shown = || match args.explain.is_empty() {
        true => print(&reports, args.format),
        false => explanations(&reports),
    };
    let named = args.files.iter().filter(|file| file.as_os_str() != "-");
    let paths: Vec<&Path> = named.map(PathBuf::as_path).collect();
    let files = || {
        Ok(match args.out {
            Some(_) => files(&inputs, &reports),
            None => certificates(&inputs, &reports),
        })
    };
    if let Err(outcome) = deliver(dir, &paths, files, shown) {
        return outcome;
    }
    match outcome(&reports) {
        Outcome::AsExpected if !answers.iter().flatten().all(Judge::agrees) => Outcome::Unexpected,
        other => other,
    }
}

/// Ends a run whose documents cannot be read or have faults. What puts remarks beside lines is told of them, too.
fn unread(unreadable: &[Unreadable], faults: &[Diagnostic], format: AuditFormat) -> Outcome {
    let missing = unreadable.iter().map(|file| remarks::unread(&file.name, file.message.clone()));
    let remarks: Vec<Remark> = missing.chain(faults.iter().map(remarks::of_fault)).collect();
    let shown = match format {
        AuditFormat::Sarif => remarks::sarif(&remarks),
        AuditFormat::Github => remarks::workflow(&remarks),
        AuditFormat::Text | AuditFormat::Json | AuditFormat::Markdown => return Outcome::BadInput,
    };
    match output::to_stdout(&shown) {
        Ok(()) => Outcome::BadInput,
        Err(error) => bad_input(&format!("cannot print: {error}")),
    }
}

/// From how many documents on Coq compiles the whole theory once, and not for each document its part.
const SHARING: usize = 3;

/// Coq, with the theory that documents share once it is compiled.
struct Coq {
    shares: bool,
    theory: Option<Result<Theory, NotAsked>>,
}

impl Coq {
    fn ask(&mut self, claims: &Claims<'_>, limits: &Limits) -> Result<Judge, NotAsked> {
        let file = judges::coq::file(claims);
        if !self.shares {
            return judges::ask_coq(&file, limits);
        }
        let theory = self.theory.get_or_insert_with(|| Theory::new(limits)).as_ref();
        theory.map_err(Clone::clone)?.ask(&file, limits)
    }
}

/// Puts the claims of a document to the judges that are asked for.
fn ask(report: &Report<'_>, args: &AuditArgs, coq: &mut Coq) -> Result<Vec<Judge>, Outcome> {
    let limits = Limits::default();
    let claims = claims(report);
    let mut all = Vec::new();
    for name in &args.judges {
        let progress = Mutex::new(Progress::counting("questions"));
        let tell = |done, all| {
            if let Ok(mut bar) = progress.lock() {
                bar.update(done, all);
            }
        };
        let judged = match name {
            JudgeName::Coq => {
                tell(0, 1);
                coq.ask(&claims, &limits)
            }
            JudgeName::Z3 => judges::ask_z3(&claims, &limits, &tell),
        };
        match judged {
            Ok(judge) => all.push(judge),
            Err(NotAsked::NotInstalled(_)) if args.optional => {
                let name = match name {
                    JudgeName::Coq => "Coq",
                    JudgeName::Z3 => "z3",
                };
                all.push(Judge { name: name.to_owned(), ..Judge::default() });
            }
            Err(why) => {
                bad_input(&format!("{why}; nothing was checked by it"));
                return Err(Outcome::Nothing);
            }
        }
    }
    Ok(all)
}

/// The claims that a report shows, as they are put to judges.
fn claims<'a>(report: &Report<'a>) -> Claims<'a> {
    Claims::of(report.audit).only(&report.shown)
}

/// The documents that could be read, and everything that is wrong with the others.
fn documents(inputs: &[Input]) -> (Vec<Document>, Vec<Diagnostic>) {
    let (mut documents, mut faults) = (Vec::new(), Vec::new());
    for input in inputs {
        match kane::audit::read(&input.name, &input.bytes) {
            Ok(document) => documents.push(document),
            Err(found) => faults.extend(found),
        }
    }
    (documents, faults)
}

/// Judges the document, or of it only what is asked for and what that cites.
fn judge(
    document: Document,
    chosen: Option<&[usize]>,
    args: &AuditArgs,
    memo: Option<&mut Memo>,
) -> Audit {
    let mut options = Options { only: chosen.map(<[usize]>::to_vec), ..Options::default() };
    if let Some(fuel) = args.budget {
        let whole = options.budget;
        options.budget.fuel = fuel;
        // states and functions in the same measure
        let part = |n: u64| n.saturating_mul(fuel.min(whole.fuel)) / whole.fuel;
        options.budget.steps = part(whole.steps).max(1);
        options.budget.squares = part(whole.squares);
        options.budget.functions = part(whole.functions as u64).try_into().unwrap_or(usize::MAX);
    }
    options.budget = options.budget.times(args.effort.unwrap_or(1));
    let mut progress = Progress::new();
    let mut tell = |done, all| progress.update(done, all);
    let Some(memo) = memo else {
        return kane::audit::audit(document, &options, &mut tell);
    };
    let mut go_on = |done, all| {
        tell(done, all);
        true
    };
    let again = kane::audit::audit_again(document, &options, memo, &mut go_on);
    again.expect("it is told to go on")
}

/// The command that prints one document's report again.
fn command(input: &Input, args: &AuditArgs) -> String {
    let mut command = input.command.clone();
    if let Some(budget) = args.budget {
        command.push_str(&format!(" --budget {budget}"));
    }
    if let Some(effort) = args.effort {
        command.push_str(&format!(" --effort {effort}"));
    }
    for label in &args.only {
        command.push_str(" --only ");
        command.push_str(&quoted(label));
    }
    command
}

/// The reports in one string.
fn print(reports: &[Report<'_>], format: AuditFormat) -> String {
    let join = |each: &dyn Fn(&Report<'_>) -> String| {
        reports.iter().map(each).collect::<Vec<_>>().join("\n")
    };
    let remarks = || reports.iter().flat_map(of_audit).collect::<Vec<Remark>>();
    match format {
        AuditFormat::Text => {
            let page = output::page();
            join(&|report| {
                report::text(report, page) + &report::judges::text(report.audit, report.judges)
            })
        }
        AuditFormat::Markdown => join(&report::markdown),
        AuditFormat::Json => report::json(reports),
        AuditFormat::Sarif => remarks::sarif(&remarks()),
        AuditFormat::Github => remarks::workflow(&remarks()),
    }
}

/// The chosen statements in full.
fn explanations(reports: &[Report<'_>]) -> String {
    let each = reports.iter().flat_map(|report| {
        report.shown.iter().filter_map(|&index| report::explain(report.audit, index))
    });
    each.collect::<Vec<_>>().join("\n")
}

/// Every report in every form, its claims for Coq, and each as a question for a solver.
fn files(inputs: &[&Input], reports: &[Report<'_>]) -> Vec<Written> {
    let mut files = Vec::new();
    for (input, report) in inputs.iter().zip(reports) {
        let forms = [
            ("html", report::html(report)),
            ("md", report::markdown(report)),
            ("tex", report::latex(report)),
            ("json", report::json(std::slice::from_ref(report))),
        ];
        for (ending, text) in forms {
            files.push(Written::new(format!("{}.{ending}", input.stem), text));
        }
        files.push(certificate(input, report));
        let claims = claims(report);
        let lemmas = judges::coq::file(&claims).text();
        files.push(Written::question(format!("{}.v", judges::coq::library(&input.stem)), &lemmas));
        for (name, question) in judges::smt::questions(&claims) {
            let path = Path::new(&input.stem).join(format!("{name}.smt2"));
            files.push(Written::question(path, &question.text));
        }
    }
    files
}

/// The certificates of the documents alone.
fn certificates(inputs: &[&Input], reports: &[Report<'_>]) -> Vec<Written> {
    inputs.iter().zip(reports).map(|(input, report)| certificate(input, report)).collect()
}

/// What was found of each claim of a document, for a checker.
fn certificate(input: &Input, report: &Report<'_>) -> Written {
    Written::new(format!("{}.cert.json", input.stem), report::certificates(report))
}

/// A name that two documents share, at least as libraries.
fn twin(inputs: &[Input]) -> Option<&str> {
    let mut seen = BTreeSet::new();
    inputs
        .iter()
        .map(|input| input.stem.as_str())
        .find(|stem| !seen.insert(judges::coq::library(stem)))
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
