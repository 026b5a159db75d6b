//! `kane collide`: one collision, from flags or a file, under all laws or one in depth.

mod file;
mod flags;

use std::path::Path;

use kane::algebra::syntax::nearest;
use kane::collide::{Parameters, answer, law_ids};
use kane::impact::InvalidInput;
use kane::number::{Algebraic, Rational};
use kane::report::Page;
use kane::report::collision::{self, Collision};
use kane::scene::read::read as read_number;

use super::args::{CollideArgs, Format};
use super::delivery::Written;
use super::input::quoted;
use super::{Outcome, bad_input, deliver, output};

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
    let shown = || match args.format {
        Format::Text => collision::text(&collision, output::page()),
        Format::Markdown => collision::markdown(&collision),
        Format::Json => collision::json(&collision),
    };
    let inputs: Vec<&Path> = args.file.iter().map(AsRef::as_ref).collect();
    let files = || Ok(files(&stem(args), &collision));
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
    let law = args.law.as_deref();
    if let Some(law) = law {
        known_law(law)?;
    }
    for (flag, value) in flags::pairs(&args.body) {
        if value.starts_with("--") {
            return Err(Fault::Message(format!("{flag} has no value: `{value}` follows")));
        }
    }
    let parameters = parameters(&args.param)?;
    let mut question = match &args.file {
        Some(path) => file::question(path, &args.body)?,
        None => flags::question(&args.body)?,
    };
    question.parameters = parameters;
    for param in &args.param {
        question.command.push_str(&format!(" --param {}", quoted(param)));
    }
    if let Some(law) = law {
        question.command.push_str(&format!(" --law {}", quoted(law)));
    }
    answer(&question, law).map_err(|error| Fault::Message(in_words(error)))
}

/// A value outside the domain that showed only when the contact was formed.
fn in_words(error: InvalidInput<Rational>) -> String {
    let apart =
        matches!(&error, InvalidInput::Negative { quantity, .. } if quantity.contains("approach"));
    let told = error.map(|exact| kane::collide::written(&Algebraic::from(exact.clone())));
    match apart {
        true => format!("the bodies move apart: {told}"),
        false => told.to_string(),
    }
}

/// Whether the law is one of ours.
fn known_law(law: &str) -> Result<(), String> {
    let ids = law_ids();
    if ids.contains(&law) {
        return Ok(());
    }
    let family: Vec<&str> = ids.iter().copied().filter(|id| id.contains(law)).collect();
    if !law.is_empty() && !family.is_empty() {
        let family = family.join("` or `");
        return Err(format!("--law: no law is called `{law}`; did you mean `{family}`?"));
    }
    match nearest(law, ids.iter().copied()) {
        Some(near) => Err(format!("--law: no law is called `{law}`; did you mean `{near}`?")),
        None => Err(format!("--law: no law is called `{law}`; there are {}", ids.join(", "))),
    }
}

/// The laws' parameters, from `law.name=value`.
fn parameters(given: &[String]) -> Result<Parameters, String> {
    let mut parameters = Parameters::default();
    for text in given {
        let Some((path, value)) = text.split_once('=') else {
            return Err(format!(
                "--param: `{text}` has no value; write LAW.NAME=VALUE, as in walton.beta0=0.44"
            ));
        };
        let value = read_number(value).map_err(|error| format!("--param {path} {error}"))?;
        parameters.set(path, value).map_err(|error| format!("--param: {error}"))?;
    }
    Ok(parameters)
}

/// What the files of `--out` are called.
fn stem(args: &CollideArgs) -> String {
    let stem = args.file.as_ref().and_then(|file| file.file_stem());
    stem.map_or_else(|| "collision".to_owned(), |stem| stem.to_string_lossy().into_owned())
}

/// The report in every form.
fn files(stem: &str, collision: &Collision) -> Vec<Written> {
    let forms = [
        ("txt", collision::text(collision, Page::default())),
        ("md", collision::markdown(collision)),
        ("json", collision::json(collision)),
    ];
    forms.map(|(ending, text)| Written::new(format!("{stem}.{ending}"), text)).to_vec()
}
