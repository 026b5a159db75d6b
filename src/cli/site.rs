//! `kane site`: every report as a page, and an index that says what they come to.

mod stages;

use std::path::Path;

use kane::audit::{Audit, Options};
use kane::collide::{Collision, answer};
use kane::impact::laws;
use kane::matrix::Selection;
use kane::measure::Stability;
use kane::measure::chart::chart;
use kane::measure::growth::growth;
use kane::report::chart::ChartReport;
use kane::report::growth::GrowthReport;
use kane::report::matrix::MatrixReport;
use kane::report::scene::SceneReport;
use kane::report::site::{File, Site};
use kane::report::stability::StabilityReport;
use kane::report::{Page, Report};
use kane::scene::{Answer, Effort, read};
use kane::{figures, measure};

use super::args::SiteArgs;
use super::carried::{COLLISIONS, DERIVATIONS, Document, SCENES};
use super::delivery::{self, Written};
use super::{Outcome, bad_input, machine, output};
use stages::Stages;

/// The page that is opened first.
const INDEX: &str = "index.html";

/// Runs the verb.
pub(super) fn run(args: &SiteArgs) -> Outcome {
    made(&args.out).err().unwrap_or(Outcome::AsExpected)
}

/// Makes the site and writes it; all of it or nothing.
fn made(out: &Path) -> Result<(), Outcome> {
    // what it takes most of a minute to make should have a place
    delivery::look(out, INDEX).map_err(|why| bad_input(&why.to_string()))?;
    let mut stages = Stages::default();
    // proofs on one core, numbers on another; what is timed comes after them
    let (audits, matrix, numbers) = std::thread::scope(|scope| {
        let numbers = scope.spawn(|| {
            (
                stages::timed("stability", stability),
                stages::timed("figures", || figures::figures(&mut |_, _| {})),
                stages::timed("collisions", collisions),
                stages::timed("scenes", scenes),
            )
        });
        let audits = stages::timed("derivations", audits);
        let selection = Selection::default();
        let matrix =
            stages::timed("laws", || kane::matrix::matrix(laws(), &selection, &mut |_, _| {}));
        (audits, matrix, numbers.join())
    });
    let numbers = numbers.map_err(|_| bad_input("the numbers could not be had"))?;
    let (audits, matrix) = (stages.took(audits)?, stages.took(matrix));
    let (stability, figures) = (stages.took(numbers.0)?, stages.took(numbers.1));
    let figures = figures.map_err(|error| bad_input(&error.to_string()))?;
    let fits = figures::experiment::fits(laws());
    let (collisions, scenes) = (stages.took(numbers.2)?, stages.took(numbers.3)?);
    let effort = measure::chart::Effort::Quick;
    let methods = stages.take("chart", || chart(effort, &mut |_, _| {}));
    let growth = stages.take("growth", || growth(effort, &mut |_, _| {}));
    let audit = |(stem, audit): &'_ (&'static str, Audit)| {
        (*stem, format!("kane audit docs/derivations/{stem}.md"), audit.clone())
    };
    let audits: Vec<_> = audits.iter().map(audit).collect();
    let reports = audits.iter().map(|(stem, command, audit)| {
        let report = Report::new(audit, command.clone());
        let is_paper = *stem == DERIVATIONS[0].stem;
        let report = if is_paper { report.with_pictures(&super::audit::PICTURES) } else { report };
        ((*stem).to_owned(), report)
    });
    let scene = |(stem, title, answer): &'_ (&'static str, String, Answer)| {
        let command = format!("kane scene docs/scenes/{stem}.toml");
        (*stem, title.clone(), command, answer.clone())
    };
    let scenes: Vec<_> = scenes.iter().map(scene).collect();
    let site = Site {
        audits: reports.collect(),
        matrix: MatrixReport { matrix: &matrix, command: "kane laws".to_owned() },
        laws: super::laws::LAWS,
        chart: ChartReport {
            all: &methods,
            machine: machine::machine(),
            command: "kane chart --quick".to_owned(),
        },
        stability: StabilityReport {
            stability: &stability,
            accounts: &[],
            command: "kane stability --full-line".to_owned(),
        },
        growth: GrowthReport {
            growth: &growth,
            machine: machine::machine(),
            command: "kane chart --growth --quick".to_owned(),
        },
        figures: &figures,
        fits: &fits,
        collisions: collisions.iter().map(|(stem, one)| ((*stem).to_owned(), one)).collect(),
        scenes: scenes
            .iter()
            .map(|(stem, title, command, answer)| {
                let (title, command) = (title.clone(), command.clone());
                let report = SceneReport { answer, title, command, is_compared: false };
                ((*stem).to_owned(), report)
            })
            .collect(),
        command: "kane site --out DIR".to_owned(),
    };
    let files: Vec<Written> = stages.take("pages", || site.files()).iter().map(written).collect();
    stages
        .take("writing", || delivery::write(out, &[], &files))
        .map_err(|why| bad_input(&why.to_string()))?;
    stages.finish();
    let bytes: usize = files.iter().map(|file| file.bytes().len()).sum();
    let kilobytes = bytes / 1000;
    let index = out.join(INDEX);
    let told = format!(
        "{}\n{} files, {kilobytes} kB; open {}\n",
        kane::report::site::index(&site).text(Page::default()),
        files.len(),
        index.display()
    );
    output::to_stdout(&told).map_err(|error| bad_input(&format!("cannot print: {error}")))
}

/// A derivation, read.
fn derivation(document: &Document) -> Result<kane::audit::Document, Outcome> {
    let name = format!("{}.md", document.stem);
    kane::audit::read(&name, document.text.as_bytes()).map_err(|faults| {
        let faults: Vec<String> = faults.iter().map(ToString::to_string).collect();
        output::to_stderr(&format!("error: {}\n", faults.join("\n")));
        Outcome::BadInput
    })
}

/// Where the formulas of the paper fail.
fn stability() -> Result<Stability, Outcome> {
    Ok(measure::examine(&derivation(&DERIVATIONS[0])?, true, &mut |_, _| {}))
}

/// The shipped derivations, judged.
fn audits() -> Result<Vec<(&'static str, Audit)>, Outcome> {
    let judged = |document: &Document| {
        let read = derivation(document)?;
        let audit = kane::audit::audit(read, &Options::default(), &mut |_, _| {});
        Ok((document.stem, audit))
    };
    DERIVATIONS.iter().map(judged).collect()
}

/// The shipped collisions, put to every law that does not run on invented numbers.
fn collisions() -> Result<Vec<(&'static str, Collision)>, Outcome> {
    let laws: Vec<_> = laws().iter().filter(|law| law.invented().is_empty()).cloned().collect();
    let asked = |document: &Document| {
        let name = format!("docs/collisions/{}.toml", document.stem);
        let mut question =
            read::collision(&name, document.text).map_err(|fault| bad_input(&fault.to_string()))?;
        question.command = format!("kane collide {name}");
        let answered = answer(&question, &laws).map_err(|error| bad_input(&error.to_string()))?;
        Ok((document.stem, answered))
    };
    COLLISIONS.iter().map(asked).collect()
}

/// The shipped scenes with their titles, each answered by the least model.
fn scenes() -> Result<Vec<(&'static str, String, Answer)>, Outcome> {
    let asked = |document: &Document| {
        let name = format!("docs/scenes/{}.toml", document.stem);
        let scene =
            read::scene(&name, document.text).map_err(|fault| bad_input(&fault.to_string()))?;
        let answered = kane::scene::answer(&scene, laws(), None, Effort::Chosen, &mut |_, _| {})
            .map_err(|none| bad_input(&format!("{name}: {none}")))?;
        Ok((document.stem, scene.title.clone(), answered))
    };
    SCENES.iter().map(asked).collect()
}

/// A file of the site as it is written, with the mark of this program where its form has no other.
fn written(file: &File) -> Written {
    let named = match file.name().rsplit('.').next() {
        Some("svg") => Written::picture(file.name(), &file.text),
        Some("v" | "css" | "js") => Written::question(file.name(), &file.text),
        _ => Written::new(file.name(), file.text.clone()),
    };
    Written { path: file.path.clone().into(), ..named }
}
