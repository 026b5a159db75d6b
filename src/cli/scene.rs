//! `kane scene`: the least model that answers a scene.

use kane::impact::laws;
use kane::report::scene::{SceneReport, json, models_csv, sheet, states_csv};
use kane::scene::{Effort, Model, Verdict, answer, read};

use super::args::SceneArgs;
use super::carried::{self, SCENES};
use super::delivery::Written;
use super::input::{quoted, quoted_file};
use super::progress::Progress;
use super::{Outcome, bad_input, deliver, forms, output};

/// Runs the verb.
pub(super) fn run(args: &SceneArgs) -> Outcome {
    let name = args.file.display().to_string();
    let text_of_file = match carried::named(&args.file, &SCENES) {
        Some(shipped) => shipped.text.to_owned(),
        None => match read::load(&args.file) {
            Ok(text) => text,
            Err(error) => {
                return bad_input(&carried::unreadable(&args.file, &error, "toml", &SCENES));
            }
        },
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
    let mut command = format!("kane scene {}", quoted_file(&name));
    if let Some(model) = &args.model {
        command.push_str(&format!(" --model {}", quoted(model)));
    }
    if args.compare {
        command.push_str(" --compare");
    }
    let (title, is_compared) = (scene.title.clone(), args.compare);
    let report = SceneReport { answer: &answer, title, command, is_compared };
    let stem = args.file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let sheet = sheet(&report);
    let shown = || forms::printed(args.format, &sheet, || json(&report));
    let files = || {
        let mut files = forms::files(&stem, &sheet, json(&report));
        files.push(Written::new(format!("{stem}-models.csv"), models_csv(&report)));
        if answer.end.is_some() {
            files.push(Written::new(format!("{stem}-states.csv"), states_csv(&report)));
        }
        Ok(files)
    };
    if let Err(outcome) = deliver(args.out.as_deref(), &[&args.file], files, shown) {
        return outcome;
    }
    let good = answer
        .judged
        .iter()
        .any(|judged| judged.model == answer.shown && judged.verdict == Verdict::Meets);
    if good { Outcome::AsExpected } else { Outcome::Unexpected }
}
