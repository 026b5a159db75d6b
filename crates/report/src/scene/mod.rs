//! A scene: what was asked, by which model, and how it moved. Presentation only.

mod csv;
mod html;
mod json;
mod ledger_picture;
mod markdown;
mod motion_picture;
mod stress_picture;
mod text;

pub use csv::{models_csv, states_csv, stress_csv};
pub use html::html;
pub use json::json;
pub use ledger_picture::{compare_picture, ledger_picture};
pub use markdown::markdown;
pub use motion_picture::motion_picture;
pub use stress_picture::stress_picture;
pub use text::text;

use kane_scene::simulate::Encounter;
use kane_scene::{Answer, Verdict};

/// An answer and how its report introduces it.
pub struct SceneReport<'a> {
    /// What is reported.
    pub answer: &'a Answer,
    /// What it is about.
    pub title: String,
    /// The command that prints this again.
    pub command: String,
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
        match (good, answer.chosen) {
            (true, _) => format!("{shown}: {each}"),
            (false, None) => format!("no model is known to be good enough; shown is {shown}"),
            (false, Some(chosen)) => {
                format!("{shown} is not known to be good enough; {chosen} is")
            }
        }
    }
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

/// An error or a tolerance.
pub(crate) fn small(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.1e}") }
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
pub(crate) fn verdict(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Meets => "good enough".to_owned(),
        Verdict::Misses { quantity, by, at_a_corner } => {
            let place = if *at_a_corner { " within the uncertainty" } else { "" };
            format!("{quantity} off by {}{place}", small(*by))
        }
        Verdict::Uncertified(why) => format!("not certified: {why}"),
        Verdict::Fails(reason) => format!("no answer: {reason}"),
    }
}
