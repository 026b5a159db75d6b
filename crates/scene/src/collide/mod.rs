//! One collision, answered by laws, in every number system.
//!
//! A [`Question`] is a [`System`] of exact inputs, [read from a file](crate::read::collision) or put
//! together. [`answer`] and [`in_depth`] run the same law code in exact numbers (rational or
//! algebraic), in plain `f64`, in double-double and on intervals, and return data: nothing is printed
//! here.
//!
//! ```
//! use kane_impact::bodies::{Motion, SphereOnPlane};
//! use kane_impact::law;
//! use kane_number::parse;
//! use kane_scene::collide::{Question, System, in_depth};
//!
//! let n = |text| parse(text).expect("a literal");
//! let sphere = SphereOnPlane {
//!     mass: n("1"),
//!     radius: n("1"),
//!     inertia: n("2/5"),
//!     friction: n("2/7"),
//!     restitution: n("1"),
//!     before: Motion { vx: n("1"), vy: n("1"), omega: n("0") },
//! };
//! let question = Question::new(System::Sphere(sphere));
//! let law = law("wang-su-li").expect("it is known");
//! let collision = in_depth(&question, law).expect("the input is in its domain");
//! let law = collision.laws[0].answer.as_ref().expect("the law has an outcome");
//! let k = law.readings.iter().find(|reading| reading.symbol == "k").expect("it is there");
//! assert_eq!(k.exact.as_deref(), Some("0")); // α = 1; in floats μ is not quite 2/7
//! assert!(law.checks.iter().all(|check| check.holds));
//! ```

mod checks;
mod collision;
mod lanes;
mod readings;
mod system;
mod written;

use kane_impact::{InvalidInput, Law};
use kane_number::{Lane as _, Rational};

use crate::impulse_plane::ImpulsePlane;

pub use collision::{Answer, Check, Collision, Energy, Errors, Given, LawAnswer, Reading};
pub use system::System;
pub use written::written;

/// What is asked: a collision, and how its report introduces it.
#[derive(Clone, Debug)]
pub struct Question {
    /// What collides, in exact numbers.
    pub system: System<Rational>,
    /// What collides, in words.
    pub title: String,
    /// The inputs as they were given, or assumed.
    pub given: Vec<Given>,
    /// Conventions and reservations, one sentence each.
    pub notes: Vec<String>,
    /// The command that asks this again.
    pub command: String,
}

impl Question {
    /// A question that says no more of its inputs than the numbers.
    #[must_use]
    pub fn new(system: System<Rational>) -> Self {
        Self {
            title: system.title().to_owned(),
            notes: vec![system.signs().to_owned()],
            given: Vec::new(),
            command: String::new(),
            system,
        }
    }
}

/// Answers under all of these laws, in short.
///
/// # Errors
/// [`InvalidInput`] for the first input outside its domain; bodies that move apart have a negative
/// approach speed.
pub fn answer(question: &Question, laws: &[Law]) -> Result<Collision, InvalidInput<Rational>> {
    answered(question, laws, false)
}

/// Answers under one law, with every quantity in every number system, and checks.
///
/// # Errors
/// As [`answer`].
pub fn in_depth(question: &Question, law: &Law) -> Result<Collision, InvalidInput<Rational>> {
    answered(question, std::slice::from_ref(law), true)
}

/// What a reader of these laws' numbers must not miss.
fn caveats(laws: &[Law]) -> impl Iterator<Item = String> {
    let told = laws.iter().filter_map(|law| Some((law.info.id, law.info.caveat?)));
    told.map(|(id, caveat)| format!("{id}: {caveat}."))
}

/// The impulse of a law, tangential and normal.
fn end(law: &LawAnswer) -> Option<(&'static str, [f64; 2])> {
    let readings = &law.answer.as_ref().ok()?.readings;
    let value = |symbol| readings.iter().find(|reading| reading.symbol == symbol)?.float;
    Some((law.id, [value("p_t")?, value("p_n")?]))
}

fn answered(
    question: &Question,
    laws: &[Law],
    in_depth: bool,
) -> Result<Collision, InvalidInput<Rational>> {
    let contact = question.system.contact()?;
    let answer = |law: &Law| readings::answer(law, &question.system, in_depth);
    let answers: Vec<LawAnswer> = laws.iter().map(answer).collect();
    let process = laws.first().filter(|law| in_depth && law.info.is_process);
    let plane = ImpulsePlane::of_ends(
        &contact.map(Rational::to_f64),
        process.map(|law| law.info.restitution),
        answers.iter().filter_map(end).collect(),
    );
    Ok(Collision {
        title: question.title.clone(),
        given: question.given.clone(),
        notes: question.notes.iter().cloned().chain(caveats(laws)).collect(),
        before: readings::before(&question.system, &contact),
        laws: answers,
        plane,
        in_depth,
        command: question.command.clone(),
    })
}
