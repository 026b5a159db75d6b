//! `kane scene`: the least model that answers a scene.

use std::io;

use kane::impact::laws;
use kane::report::scene::{
    SceneReport, compare_picture, html, json, ledger_picture, markdown, models_csv, picture,
    states_csv, text,
};
use kane::scene::{Effort, Model, Verdict, answer, read};

use super::args::{Format, SceneArgs};
use super::delivery::Written;
use super::input::quoted;
use super::progress::Progress;
use super::{Outcome, bad_input, deliver, output};

/// Runs the verb.
pub(super) fn run(args: &SceneArgs) -> Outcome {
    let name = args.file.display().to_string();
    let text_of_file = match read::load(&args.file) {
        Ok(text) => text,
        Err(error) => return bad_input(&format!("cannot read {name}: {error}")),
    };
    let wanted = match args.model.as_deref().map(|name| Model::named(name, laws())).transpose() {
        Ok(wanted) => wanted,
        Err(error) => return bad_input(&format!("--model: {error}")),
    };
    let scene = match read::scene(&name, &text_of_file) {
        Ok(scene) => scene,
        Err(fault) => {
            output::to_stderr(&fault.to_string());
            return Outcome::BadInput;
        }
    };
    let effort = if args.compare { Effort::All } else { Effort::Chosen };
    let mut progress = Progress::counting("models");
    let answered =
        answer(&scene, laws(), wanted, effort, &mut |done, all| progress.update(done, all));
    drop(progress);
    let answer = match answered {
        Ok(answer) => answer,
        Err(none) => {
            output::to_stderr(&format!("{none}\n"));
            return Outcome::Nothing;
        }
    };
    let mut command = format!("kane scene {}", quoted(&name));
    if let Some(model) = &args.model {
        command.push_str(&format!(" --model {}", quoted(model)));
    }
    if args.compare {
        command.push_str(" --compare");
    }
    let report = SceneReport { answer: &answer, title: scene.title.clone(), command };
    let stem = args.file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let shown = || match args.format {
        Format::Text => text(&report, output::page()),
        Format::Markdown => markdown(&report),
        Format::Json => json(&report),
    };
    let files = || files(&stem, &report, args.compare);
    if let Err(outcome) = deliver(args.out.as_deref(), &[&args.file], files, shown) {
        return outcome;
    }
    let good = answer
        .judged
        .iter()
        .any(|judged| judged.model == answer.shown && judged.verdict == Verdict::Meets);
    if good { Outcome::AsExpected } else { Outcome::Unexpected }
}

/// The report in every form.
fn files(stem: &str, report: &SceneReport<'_>, compare: bool) -> io::Result<Vec<Written>> {
    let mut files = vec![
        Written::new(format!("{stem}.md"), markdown(report)),
        Written::new(format!("{stem}.json"), json(report)),
        Written::new(format!("{stem}.html"), html(report).map_err(io::Error::other)?),
        Written::new(format!("{stem}-models.csv"), models_csv(report)),
    ];
    if report.answer.end.is_some() {
        files.push(Written::new(format!("{stem}-states.csv"), states_csv(report)));
    }
    if let Some(drawn) = picture(report).map_err(io::Error::other)? {
        files.push(Written::picture(format!("{stem}-{}.svg", drawn.name), &drawn.svg));
    }
    if let Some(picture) = ledger_picture(report).map_err(io::Error::other)? {
        files.push(Written::picture(format!("{stem}-ledger.svg"), &picture));
    }
    if compare {
        let picture = compare_picture(report).map_err(io::Error::other)?;
        files.push(Written::picture(format!("{stem}-compare.svg"), &picture));
    }
    Ok(files)
}
