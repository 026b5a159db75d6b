//! One collision, answered by every law, in every number system.
//!
//! A [`Question`] is a [`System`] of exact inputs with the parameters of laws. [`answer`] runs the
//! same law code in exact numbers (rational or algebraic), in plain `f64`, in double-double and on
//! intervals, and returns the data of a [report](crate::report::collision): nothing is printed here.
//!
//! ```
//! use kane::collide::{Parameters, Question, System, answer};
//! use kane::impact::bodies::{Motion, SphereOnPlane};
//! use kane::number::parse;
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
//! let question = Question::new(System::Sphere(sphere), Parameters::default());
//! let collision = answer(&question, Some("wang-su-li")).expect("the input is in its domain");
//! let law = collision.laws[0].answer.as_ref().expect("the law has an outcome");
//! let k = law.readings.iter().find(|reading| reading.symbol == "k").expect("it is there");
//! assert_eq!(k.exact.as_deref(), Some("0")); // α = 1; in floats μ is not quite 2/7
//! assert!(law.checks.iter().all(|check| check.holds));
//! ```

mod checks;
mod lanes;
mod parameters;
mod readings;
mod system;
mod written;

pub use kane_scene::read::direction;
pub use parameters::{Parameters, UnknownParameter};
pub use system::{Happened, System};
pub use written::written;

use crate::impact::InvalidInput;
pub use crate::impact::laws::law_ids;
use crate::number::Rational;
use crate::report::collision::{Collision, Given};

/// What is asked: a collision, and how its report introduces it.
#[derive(Clone, Debug)]
pub struct Question {
    /// What collides, in exact numbers.
    pub system: System<Rational>,
    /// The parameters of laws that are not their defaults.
    pub parameters: Parameters,
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
    pub fn new(system: System<Rational>, parameters: Parameters) -> Self {
        Self {
            title: system.title().to_owned(),
            notes: vec![system.signs().to_owned()],
            given: Vec::new(),
            command: String::new(),
            system,
            parameters,
        }
    }
}

/// Answers under the law of this id in depth, or under all laws.
///
/// A law of an unknown id leaves the report without laws.
///
/// # Errors
/// [`InvalidInput`] for the first input outside its domain; bodies that move apart have a negative
/// approach speed.
pub fn answer(question: &Question, law: Option<&str>) -> Result<Collision, InvalidInput<Rational>> {
    let contact = question.system.contact()?;
    let laws = question.parameters.laws();
    let laws = laws.iter().filter(|known| law.is_none_or(|wanted| wanted == known.info.id));
    let laws = laws.map(|known| readings::answer(known, &question.system, law.is_some()));
    Ok(Collision {
        title: question.title.clone(),
        given: question.given.clone(),
        notes: question.notes.clone(),
        before: readings::before(&question.system, &contact),
        laws: laws.collect(),
        in_depth: law.is_some(),
        command: question.command.clone(),
    })
}
