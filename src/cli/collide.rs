//! `kane collide`: one collision, from flags or a file, under all laws or one in depth.

mod flags;

use std::path::Path;

use kane::algebra::syntax::Diagnostic;
use kane::collide::{Collision, Question, answer, in_depth};
use kane::impact::{InvalidInput, Law, UnknownParameter, laws, set_parameter};
use kane::number::{Algebraic, Rational};
use kane::report::collision;
use kane::scene::read;

use super::args::{BodyArgs, CollideArgs};
use super::carried::{self, COLLISIONS};
use super::ids::{law_ids, parameter_ids, unknown};
use super::input::{quoted, quoted_file};
use super::{Outcome, bad_input, deliver, forms, output};

/// Runs the verb.
pub(super) fn run(args: &CollideArgs) -> Outcome {
    let collision = match collision(args) {
        Ok(collision) => collision,
        Err(Fault::Message(message)) => return bad_input(&message),
        Err(Fault::Shown(faults)) => {
            output::to_stderr(&faults);
            return Outcome::BadInput;
        }
    };
    let sheet = collision::sheet(&collision);
    let json = || collision::json(&collision);
    let shown = || forms::printed(args.format, &sheet, json);
    let inputs: Vec<&Path> = args.file.iter().map(AsRef::as_ref).collect();
    let files = || Ok(forms::files(&stem(args), &sheet, json()));
    if let Err(outcome) = deliver(args.out.as_deref(), &inputs, files, shown) {
        return outcome;
    }
    if !collision.has_outcome() {
        Outcome::Nothing
    } else if collision.as_expected() {
        Outcome::AsExpected
    } else {
        Outcome::Unexpected
    }
}

/// What is wrong with the input.
enum Fault {
    /// a message without its `error: `
    Message(String),
    /// a message as it is to be shown, with the place in a file
    Shown(String),
}

impl From<kane::scene::read::Fault> for Fault {
    fn from(fault: kane::scene::read::Fault) -> Self {
        Self::Shown(fault.to_string())
    }
}

impl From<String> for Fault {
    fn from(message: String) -> Self {
        Self::Message(message)
    }
}

/// Reads the input and puts it to the laws.
fn collision(args: &CollideArgs) -> Result<Collision, Fault> {
    let place = args.law.as_deref().map(known_law).transpose()?;
    for (flag, value) in flags::pairs(&args.body) {
        if value.starts_with("--") {
            return Err(Fault::Message(format!("{flag} has no value: `{value}` follows")));
        }
    }
    let laws = with_parameters(&args.param)?;
    let mut question = match &args.file {
        Some(path) => question_of(path, &args.body)?,
        None => flags::question(&args.body)?,
    };
    for param in &args.param {
        question.command.push_str(&format!(" --param {}", quoted(param)));
    }
    if let Some(law) = &args.law {
        question.command.push_str(&format!(" --law {}", quoted(law)));
    }
    let answered = match place {
        Some(place) => in_depth(&question, &laws[place]),
        None => {
            let laws = without_invented(laws, &mut question.notes);
            answer(&question, &laws)
        }
    };
    answered.map_err(|error| located(error, args))
}

/// What is wrong with the values, at the field or with the flags that say how the bodies move if it is
/// that.
fn located(error: InvalidInput<Rational>, args: &CollideArgs) -> Fault {
    let apart = is_apart(&error);
    let message = in_words(error);
    if !apart {
        return Fault::Message(message);
    }
    let Some(path) = &args.file else {
        let moving = ["--vx", "--vy", "--speed", "--angle", "--half-tangent", "--spin"];
        let pairs = flags::pairs(&args.body);
        let given: Vec<&str> =
            pairs.iter().map(|(flag, _)| *flag).filter(|flag| moving.contains(flag)).collect();
        return Fault::Message(format!("{message}; see {}", given.join(", ")));
    };
    let text = match carried::named(path, &COLLISIONS) {
        Some(shipped) => shipped.text.to_owned(),
        None => read::load(path).unwrap_or_default(),
    };
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let field = line.split('=').next().unwrap_or_default();
        if line.contains('=') && !field.contains('#') && field.contains("velocit") {
            let place = start..start + line.trim_end().len();
            let name = path.display().to_string();
            return Fault::Shown(Diagnostic::new(&name, &text, place, message).to_string());
        }
        start += line.len();
    }
    Fault::Message(format!("{}: {message}", path.display()))
}

/// Whether the bodies move apart, so that there is no collision.
fn is_apart(error: &InvalidInput<Rational>) -> bool {
    matches!(error, InvalidInput::Negative { quantity, .. } if quantity.contains("approach"))
}

/// The laws that do not run on invented numbers, and a note of those that do.
fn without_invented(laws: Vec<Law>, notes: &mut Vec<String>) -> Vec<Law> {
    let (kept, left): (Vec<Law>, Vec<Law>) =
        laws.into_iter().partition(|law| law.invented().is_empty());
    let flags: Vec<String> = left
        .iter()
        .flat_map(|law| {
            law.invented().into_iter().map(|name| format!("--param {}.{name}", law.info.id))
        })
        .collect();
    if !flags.is_empty() {
        notes.push(format!(
            "Left out, because their parameters would be invented: give {} a value, or ask by --law.",
            flags.join(", ")
        ));
    }
    kept
}

/// What is asked by a file.
fn question_of(path: &Path, flags: &BodyArgs) -> Result<Question, Fault> {
    if let Some((flag, _)) = flags::pairs(flags).first() {
        return Err(Fault::Message(format!(
            "{flag} and {} describe two collisions; give one of them",
            path.display()
        )));
    }
    let name = path.display().to_string();
    let text = match carried::named(path, &COLLISIONS) {
        Some(shipped) => shipped.text.to_owned(),
        None => read::load(path)
            .map_err(|error| carried::unreadable(path, &error, "toml", &COLLISIONS))?,
    };
    let mut question = read::collision(&name, &text)?;
    question.command = format!("kane collide {}", quoted_file(&name));
    Ok(question)
}

/// A value outside the domain that showed only when the contact was formed.
fn in_words(error: InvalidInput<Rational>) -> String {
    let apart = is_apart(&error);
    let told = error.map(|exact| kane::collide::written(&Algebraic::from(exact.clone())));
    match apart {
        true => format!("the bodies move apart: {told}"),
        false => told.to_string(),
    }
}

/// The place of a law among all.
fn known_law(law: &str) -> Result<usize, String> {
    let ids = law_ids();
    if let Some(place) = ids.iter().position(|id| *id == law) {
        return Ok(place);
    }
    Err(format!("--law: {}", unknown("law", law, &ids)))
}

/// All laws, with the parameters of `law.name=value`.
fn with_parameters(given: &[String]) -> Result<Vec<Law>, String> {
    let mut laws = laws().to_vec();
    for text in given {
        let Some((path, value)) = text.split_once('=') else {
            return Err(format!(
                "--param: `{text}` has no value; write LAW.NAME=VALUE, as in walton.beta0=0.44"
            ));
        };
        let value = read::read(value).map_err(|error| format!("--param {path} {error}"))?;
        set_parameter(&mut laws, path, &value).map_err(|error| match error {
            UnknownParameter::Name { name, .. } => {
                let ids = parameter_ids();
                let ids: Vec<&str> = ids.iter().map(String::as_str).collect();
                format!("--param: {}", unknown("parameter", &name, &ids))
            }
            other => format!("--param: {other}"),
        })?;
    }
    Ok(laws)
}

/// What the files of `--out` are called.
fn stem(args: &CollideArgs) -> String {
    let stem = args.file.as_ref().and_then(|file| file.file_stem());
    stem.map_or_else(|| "collision".to_owned(), |stem| stem.to_string_lossy().into_owned())
}
