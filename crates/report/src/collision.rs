//! One collision under the laws: data, and the three ways to show it.

mod json;
mod markdown;
mod text;

pub use json::{COLLISION_SCHEMA_NAME, COLLISION_SCHEMA_VERSION, json};
pub use markdown::markdown;
pub use text::text;

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
    pub(crate) fn outcomes(&self) -> impl Iterator<Item = (&LawAnswer, &Answer)> {
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
    pub(crate) fn creators(&self) -> Vec<&'static str> {
        let created = self.outcomes().filter(|(_, answer)| answer.energy == Energy::Created);
        created.map(|(law, _)| law.id).collect()
    }

    /// The counts as a sentence.
    pub(crate) fn headline(&self) -> String {
        let (all, some) = (self.laws.len(), self.outcomes().count());
        let created = self.creators().len();
        let mut line = match (self.in_depth, all) {
            (true, _) => return self.verdict(),
            (_, 1) => "1 law".to_owned(),
            _ => format!("{all} laws"),
        };
        if some < all {
            line.push_str(&format!(", {some} with an outcome"));
        }
        match created {
            0 => line.push_str("; none creates energy"),
            1 => line.push_str("; 1 creates energy"),
            _ => line.push_str(&format!("; {created} create energy")),
        }
        line
    }

    /// The news of one law in depth.
    fn verdict(&self) -> String {
        let Some((law, answer)) = self.outcomes().next() else {
            let law = self.laws.first().map_or("", |law| law.id);
            return format!("{law}: no outcome");
        };
        let (all, good) =
            (answer.checks.len(), answer.checks.iter().filter(|check| check.holds).count());
        let energy = match answer.energy {
            Energy::Lost => "energy is lost",
            Energy::Kept => "energy is kept",
            Energy::Created => "energy is CREATED",
        };
        format!("{}: {}; {energy}; {good} of {all} exact checks hold", law.id, answer.regime)
    }
}

impl Given {
    /// `mu = 0.092`, `mass = 1 kg (assumed)`.
    pub(crate) fn in_words(&self) -> String {
        let space = if self.unit.is_empty() || self.unit == "°" { "" } else { " " };
        let assumed = if self.assumed { " (default)" } else { "" };
        format!("{} = {}{space}{}{assumed}", self.symbol, self.value, self.unit)
    }
}

/// A float with four digits, for a table.
fn brief(float: f64) -> String {
    let rounded = format!("{float:.3e}");
    let Some((mantissa, power)) = rounded.split_once('e') else { return rounded };
    let digits = mantissa.trim_end_matches('0').trim_end_matches('.');
    match power.parse::<i32>() {
        Ok(0) if digits == "0" || digits == "-0" => "0".to_owned(),
        Ok(power @ -3..=3) => {
            let places = usize::try_from(3 - power).unwrap_or(0);
            format!("{float:.places$}")
        }
        _ => format!("{digits}e{power}"),
    }
}

/// A float with all digits that identify it.
fn full(float: f64) -> String {
    if float == 0.0 {
        return "0".to_owned();
    }
    let text = format!("{float:?}");
    text.strip_suffix(".0").map_or_else(|| text.clone(), str::to_owned)
}

/// An error in ulps.
fn ulps(error: f64) -> String {
    let size = error.abs();
    if size == 0.0 {
        "0".to_owned()
    } else if size < 0.005 {
        "<0.01".to_owned()
    } else if size < 10_000.0 {
        format!("{error:+.2}")
    } else {
        format!("{error:+.1e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_digits_and_no_noise() {
        for (float, shown) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1.000"),
            (-0.312_504, "-0.3125"),
            (0.000_123_456, "1.235e-4"),
            (12_345.6, "1.235e4"),
            (1e300, "1e300"),
        ] {
            assert_eq!(brief(float), shown);
        }
    }

    #[test]
    fn all_digits_are_those_that_identify_the_float() {
        assert_eq!(full(0.1), "0.1");
        assert_eq!(full(2.0), "2");
        assert_eq!(full(-0.0), "0");
        assert_eq!(full(-1e300), "-1e300");
    }

    #[test]
    fn one_check_that_fails_is_not_as_expected_and_says_so() {
        let check = |holds| Check { claim: "momentum".to_owned(), holds };
        let answer = Answer {
            regime: "slide",
            energy: Energy::Lost,
            readings: Vec::new(),
            checks: vec![check(true), check(false)],
            remarks: Vec::new(),
        };
        let law = LawAnswer {
            id: "some-law",
            statement: "i_x = 1",
            source: "nobody",
            restitution: "Newton",
            parameters: Vec::new(),
            answer: Ok(answer),
        };
        let collision = Collision {
            title: "A test".to_owned(),
            given: Vec::new(),
            notes: Vec::new(),
            before: Vec::new(),
            laws: vec![law],
            in_depth: true,
            command: "kane".to_owned(),
        };
        assert!(!collision.as_expected());
        assert!(text(&collision, crate::Page::default()).contains("DOES NOT HOLD  momentum"));
        assert!(markdown(&collision).contains("1 of 2 exact checks hold"));
        assert!(json(&collision).contains("\"as_expected\": false"));
    }

    #[test]
    fn small_and_great_errors_stay_short() {
        for (error, shown) in [(0.0, "0"), (-0.001, "<0.01"), (0.5, "+0.50"), (2e9, "+2.0e9")] {
            assert_eq!(ulps(error), shown);
        }
    }
}
