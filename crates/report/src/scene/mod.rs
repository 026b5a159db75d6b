//! A scene: what was asked, by which model, and how it moved.

mod compare_picture;
mod contact_picture;
mod csv;
#[cfg(test)]
mod drawn;
mod impulse_picture;
mod json;
mod ledger_picture;
mod motion_picture;
mod sheet;
mod stress_picture;
#[cfg(test)]
mod tests;

pub use compare_picture::compare_picture;
pub use csv::{models_csv, states_csv, stress_csv};
pub(crate) use impulse_picture::drawn_impulse;
pub use json::json;
#[cfg(feature = "schema")]
pub(crate) use json::schema;
pub use ledger_picture::ledger_picture;
pub use sheet::sheet;
pub use stress_picture::stress_picture;

use kane_number::System;
use kane_scene::Picture;
use kane_scene::rounded::at_most;
use kane_scene::simulate::Encounter;
use kane_scene::{Answer, Judged, Known, Line, Place, Spread, Verdict};

/// An answer and how its report introduces it.
pub struct SceneReport<'a> {
    /// What is reported.
    pub answer: &'a Answer,
    /// What it is about.
    pub title: String,
    /// The command that prints this again.
    pub command: String,
    /// Whether all models were tried, and are drawn by error and cost.
    pub is_compared: bool,
}

impl SceneReport<'_> {
    /// The news in a sentence.
    #[must_use]
    pub fn headline(&self) -> String {
        let answer = self.answer;
        let shown = answer.shown;
        let verdict = answer.judged.iter().find(|judged| judged.model == shown);
        let good = verdict.is_some_and(|judged| judged.verdict == Verdict::Meets);
        let each = match answer.lines.len() {
            1 => "what is asked for is within its tolerance",
            _ => "all that is asked for is within its tolerance",
        };
        let surely = match answer.known {
            Some(Known::Estimated) => ", by an estimate",
            Some(Known::Documented) => ", as documented",
            _ => "",
        };
        let is_blurred =
            |line: &Line| line.spread.is_some_and(|spread| spread.exceeds(line.tolerance));
        let open = match answer.lines.iter().any(is_blurred) {
            true => "; the inputs leave more open",
            false => "",
        };
        match (good, answer.chosen) {
            (true, _) => format!("{shown}: {each}{surely}{open}"),
            (false, None) if answer.wanted.is_some() && !self.is_compared => match verdict {
                Some(Judged { verdict: Verdict::Misses { .. }, .. }) => {
                    format!("{shown}, the model asked for, is not good enough")
                }
                _ if shown.system == System::Interval => {
                    format!(
                        "{shown}, the model asked for, is not judged: its answers are the middles of intervals"
                    )
                }
                _ => format!("{shown}, the model asked for, is not known to be good enough"),
            },
            (false, None) => format!("no model is known to be good enough; shown is {shown}"),
            (false, Some(chosen)) => {
                format!("{shown} is not known to be good enough; {chosen} is")
            }
        }
    }
}

/// A picture, with what it is called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drawn {
    /// The end of its file's name.
    pub name: &'static str,
    /// Its heading.
    pub heading: &'static str,
    /// The drawing, SVG.
    pub svg: String,
}

/// The picture of a scene: what flies, the impulse of a tip, or forces over the time of contact;
/// `None` where the model has none.
#[must_use]
pub fn picture(report: &SceneReport<'_>) -> Option<Drawn> {
    let (name, heading) = drawn(report)?;
    let svg = match report.answer.picture.as_ref()? {
        Picture::Motion(strobe) => motion_picture::motion_picture(report, strobe),
        Picture::ImpulsePlane(plane) => drawn_impulse(&report.title, &report.command, plane),
        Picture::ContactTime(contact) => contact_picture::contact_picture(report, contact),
    };
    Some(Drawn { name, heading, svg })
}

/// Which picture a scene has: the end of its file's name, and its heading.
fn drawn(report: &SceneReport<'_>) -> Option<(&'static str, &'static str)> {
    Some(match report.answer.picture.as_ref()? {
        Picture::Motion(_) => ("motion", "Motion"),
        Picture::ImpulsePlane(_) => ("impulse", "Impulse"),
        Picture::ContactTime(_) => ("contact", "Contact"),
    })
}

/// The width of pictures with a plot.
const WIDTH: f64 = 860.0;

/// What stands below a picture: what is to be known of it, and where it comes from.
fn notes(report: &SceneReport<'_>, note: &str) -> Vec<String> {
    notes_of(&report.command, note)
}

/// The same by the command.
fn notes_of(command: &str, note: &str) -> Vec<String> {
    let from = format!("kane {}: {command}", env!("CARGO_PKG_VERSION"));
    [note.to_owned(), from].into_iter().filter(|note| !note.is_empty()).collect()
}

/// A number for a table, with its sign where it has one.
pub(crate) fn number(value: f64) -> String {
    let magnitude = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if (1e-4..1e6).contains(&magnitude) {
        let whole = format!("{magnitude:.0}").len();
        let digits = if magnitude >= 1.0 { 8_usize.saturating_sub(whole) } else { 8 };
        let text = format!("{value:.digits$}");
        if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        } else {
            text
        }
    } else {
        format!("{value:.5e}")
    }
}

/// An error, a tolerance or a place on an axis, to two digits, or as many as it has before the point.
pub(crate) fn brief(value: f64) -> String {
    let magnitude = value.abs();
    if value == 0.0 || !(1e-3..1e5).contains(&magnitude) {
        return small(value);
    }
    // the digit before the last to be kept
    let digits = [1e-2, 1e-1, 1.0, 10.0].iter().position(|bound| magnitude < *bound);
    let decimals = digits.map_or(0, |n| 4 - n);
    let text = format!("{value:.decimals$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// What was stated, as [`brief`] tells it if nothing is lost, or in full.
fn in_full(value: f64) -> String {
    let text = brief(value);
    match text.parse() == Ok(value) {
        true => text,
        false if (1e-3..1e5).contains(&value.abs()) => value.to_string(),
        false => format!("{value:e}"),
    }
}

/// An error to two digits.
pub(crate) fn small(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.1e}") }
}

/// A power of ten on an axis: `1e-12`.
fn power(value: f64) -> String {
    format!("{value:.0e}")
}

/// The cost of a model, and whether it is counted or only estimated.
pub(crate) fn cost(judged: &Judged) -> String {
    let about = if judged.model.mechanics.is_counted() { "" } else { "about " };
    format!("{about}{}", judged.cost)
}

/// What is known of an error: its size, and whether that is a bound or an estimate.
pub(crate) fn error(error: Option<f64>, known: Option<Known>) -> String {
    match (error, known) {
        (Some(0.0), Some(Known::Exactly | Known::Enclosed)) => "none".to_owned(),
        (Some(error), Some(Known::Exactly | Known::Enclosed)) => {
            format!("at most {}", at_most(error, brief))
        }
        (Some(error), Some(Known::Documented)) => {
            format!("{}, documented", at_most(error, brief))
        }
        (Some(error), Some(Known::Estimated)) => format!("{}, estimated", brief(error)),
        _ => "unknown".to_owned(),
    }
}

/// How far the stated uncertainty moves an answer.
pub(crate) fn moved(spread: Option<Spread>) -> String {
    match spread {
        Some(Spread { by, enclosed: true, .. }) => format!("within ±{}", at_most(by, brief)),
        Some(Spread { by, enclosed: false, .. }) => format!("±{} at corners", brief(by)),
        None => String::new(),
    }
}

/// The id of a body in files for programs; bodies are counted from 1.
pub(crate) fn body_id(index: usize) -> String {
    format!("body-{}", index + 1)
}

/// The ids of who meets.
pub(crate) fn ids(encounter: Encounter) -> Vec<String> {
    match encounter {
        Encounter::Wall(i, side) => vec![body_id(i), side.id().to_owned()],
        Encounter::Pair(i, j) => vec![body_id(i), body_id(j)],
    }
}

/// Who meets, in words; bodies are counted from 1.
pub(crate) fn who(encounter: Encounter, bodies: usize) -> String {
    match encounter {
        Encounter::Wall(_, side) if bodies == 1 => side.name().to_owned(),
        Encounter::Wall(i, side) => format!("{}, {}", i + 1, side.name()),
        Encounter::Pair(i, j) => format!("{} and {}", i + 1, j + 1),
    }
}

/// What is said of a model, in a few words.
pub(crate) fn verdict(verdict: &Verdict, known: Option<Known>) -> String {
    match verdict {
        Verdict::Meets => match known {
            Some(Known::Estimated) => "good enough by an estimate".to_owned(),
            Some(Known::Documented) => "good enough as documented".to_owned(),
            _ => "good enough".to_owned(),
        },
        Verdict::Misses { quantity, by, place } => {
            let place = match place {
                Place::Stated => "",
                Place::Corner => " within the uncertainty",
                Place::Near => " within 1%",
            };
            format!("{quantity} off by {}{place}", brief(*by))
        }
        Verdict::Uncertified(why) => format!("not certified: {why}"),
        Verdict::Fails(reason) => format!("no answer: {reason}"),
    }
}
