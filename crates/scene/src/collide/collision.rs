//! What laws say of one collision, as data.

use crate::impulse_plane::ImpulsePlane;

/// A collision, and what laws say of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Collision {
    /// What collides, in words.
    pub title: String,
    /// The inputs.
    pub given: Vec<Given>,
    /// Conventions and reservations, one sentence each.
    pub notes: Vec<String>,
    /// The contact and the energy before the collision.
    pub before: Vec<Reading>,
    /// The laws that were asked.
    pub laws: Vec<LawAnswer>,
    /// The impact in the plane of its impulse, in floats; `None` where no law has an end there.
    pub plane: Option<ImpulsePlane>,
    /// Whether one law is shown with every quantity, instead of all laws in a table.
    pub in_depth: bool,
    /// A command that prints this report.
    pub command: String,
}

/// An input as it was given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Given {
    /// Its symbol or name.
    pub symbol: String,
    /// Its value as text, exact.
    pub value: String,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// Whether it was assumed because nobody gave it.
    pub assumed: bool,
}

/// What a law says, and where it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct LawAnswer {
    /// The law's id.
    pub id: &'static str,
    /// What the law adds to momentum and restitution, a claim a line.
    pub statement: &'static str,
    /// Who published it, and what was consulted.
    pub source: &'static str,
    /// The hypothesis of restitution.
    pub restitution: &'static str,
    /// The law's own parameters, exact.
    pub parameters: Vec<(&'static str, String)>,
    /// Its answer, or why it has none.
    pub answer: Result<Answer, String>,
}

/// The outcome under one law.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// What happens at the contact.
    pub regime: &'static str,
    /// What becomes of the kinetic energy, decided exactly.
    pub energy: Energy,
    /// The quantities.
    pub readings: Vec<Reading>,
    /// What was checked in exact numbers.
    pub checks: Vec<Check>,
    /// What is noteworthy about the number systems.
    pub remarks: Vec<String>,
}

/// What becomes of the kinetic energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Energy {
    /// It falls.
    Lost,
    /// It stays the same.
    Kept,
    /// It rises.
    Created,
}

impl Energy {
    /// A word for it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Lost => "lost",
            Self::Kept => "kept",
            Self::Created => "created",
        }
    }
}

/// A quantity in the number systems that know it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reading {
    /// Its symbol.
    pub symbol: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// What it is, in a few words.
    pub meaning: &'static str,
    /// Whether the table of all laws has a column for it.
    pub column: bool,
    /// The exact value as text, cut after 20 digits if it is long.
    pub exact: Option<String>,
    /// The same as a fraction in full, if it is rational.
    pub fraction: Option<String>,
    /// The float: the exact value rounded, or the result by way of double-double.
    pub float: Option<f64>,
    /// The result of plain `f64` arithmetic.
    pub plain: Option<f64>,
    /// How far the floats are off, if that was asked.
    pub errors: Option<Errors>,
    /// The ends of the interval that encloses the exact value; they may be infinite.
    pub enclosure: Option<[f64; 2]>,
}

/// Errors in ulps; each is its own, not a sum of the others.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// What rounding the inputs to floats does to the exact value.
    pub inputs: Option<f64>,
    /// What plain `f64` arithmetic adds to that.
    pub plain: Option<f64>,
    /// What the way by double-double adds to that.
    pub wide: Option<f64>,
}

/// A check in exact numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Check {
    /// What must hold.
    pub claim: String,
    /// Whether it does.
    pub holds: bool,
}

impl Collision {
    /// The outcomes, with their laws.
    pub fn outcomes(&self) -> impl Iterator<Item = (&LawAnswer, &Answer)> {
        self.laws.iter().filter_map(|law| law.answer.as_ref().ok().map(|answer| (law, answer)))
    }

    /// Whether any law has an outcome.
    #[must_use]
    pub fn has_outcome(&self) -> bool {
        self.outcomes().next().is_some()
    }

    /// Whether every check holds.
    #[must_use]
    pub fn as_expected(&self) -> bool {
        self.outcomes().all(|(_, answer)| answer.checks.iter().all(|check| check.holds))
    }

    /// The laws that create energy.
    #[must_use]
    pub fn creators(&self) -> Vec<&'static str> {
        let created = self.outcomes().filter(|(_, answer)| answer.energy == Energy::Created);
        created.map(|(law, _)| law.id).collect()
    }
}
