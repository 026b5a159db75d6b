//! The models, and what they cost.

use std::fmt;
use std::sync::LazyLock;

use kane_algebra::syntax::nearest;
use kane_impact::laws::{RouthNewton, Stronge1990, Walton};
use kane_impact::{Law, Restitution};
use kane_number::System;

/// How impacts are resolved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mechanics {
    /// One dimension: no friction at all.
    NormalOnly,
    /// By a law.
    Law(&'static Law),
    /// Spheres that touch at once, Hertz's springs.
    Chain,
    /// An elastic contact: a half-space as a row of springs, or a pair of springs if that is stated.
    Compliant,
    /// The half-space annulus by annulus, after Maw, Barber and Fawcett.
    Annuli,
}

/// Coulomb friction on rigid bodies, Newton's restitution: slide, then stick.
pub(super) static COULOMB: LazyLock<Law> = LazyLock::new(|| Law::from(RouthNewton));
/// The same with Stronge's energetic restitution.
pub(super) static ENERGETIC: LazyLock<Law> = LazyLock::new(|| Law::from(Stronge1990));
/// The same where sticking gives a share of the slip back.
pub(super) static GRIP: LazyLock<Law> = LazyLock::new(|| Law::from(Walton::default()));

/// The names that laws had here when they had two.
const FORMER: [(&str, &str); 4] = [
    ("sliding", "whittaker-uncapped"),
    ("coulomb", "routh-newton"),
    ("grip", "walton"),
    ("energetic", "stronge-1990"),
];

/// Additions, multiplications, divisions and roots of a ball's fall, and of the look for its next
/// impact: what a test counts in this code.
const FLIGHT: [u64; 4] = [34, 21, 10, 1];

/// Of an impact without friction.
const NORMAL: [u64; 4] = [7, 6, 3, 0];

impl Mechanics {
    /// All that there are with these laws, from the least.
    fn all(laws: &'static [Law]) -> Vec<Self> {
        let by_law = laws.iter().filter(|law| law.info.model.is_some()).map(Self::Law);
        let mut all = vec![Self::NormalOnly];
        all.extend(by_law);
        all.sort_by_key(|mechanics| mechanics.operations());
        all.extend([Self::Chain, Self::Compliant, Self::Annuli]);
        all
    }

    /// Its name.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::NormalOnly => "normal-only",
            Self::Law(law) => law.info.id,
            Self::Chain => "chain",
            Self::Compliant => "compliant",
            Self::Annuli => "annuli",
        }
    }

    /// What it is, in words that follow "by".
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::NormalOnly => "normal impulses alone",
            Self::Law(law) => law.info.model.map_or(law.info.id, |model| model.words),
            Self::Chain => "the chain of Hertz's springs",
            Self::Compliant => "an elastic contact",
            Self::Annuli => "an elastic contact by annuli",
        }
    }

    /// Whether the operations of an impact are counted in the code; those of what takes steps depend
    /// on the contact, and are an estimate to the nearest power of ten.
    #[must_use]
    pub const fn is_counted(self) -> bool {
        !matches!(self, Self::Chain | Self::Compliant | Self::Annuli)
    }

    /// Additions, multiplications, divisions and roots of a ball's fall, its impact and the look for
    /// the next one. Those of the integrations are estimates to the nearest power of ten.
    #[must_use]
    pub fn operations(self) -> [u64; 4] {
        let with_flight =
            |impact: [u64; 4]| std::array::from_fn(|kind| FLIGHT[kind] + impact[kind]);
        match self {
            Self::NormalOnly => with_flight(NORMAL),
            Self::Law(law) => with_flight(law.info.model.map_or([0; 4], |model| model.operations)),
            Self::Chain => [100_000, 100_000, 10_000, 1_000],
            Self::Compliant => [100_000, 100_000, 1_000, 1_000],
            Self::Annuli => [10_000_000, 10_000_000, 100_000, 1_000],
        }
    }

    /// Whether it may stand in for any rigid law: it asks for nothing but μ and e.
    fn stands_in(law: &Law) -> bool {
        let plain = law.info.parameters.is_empty() && law.info.restitution == Restitution::Newton;
        law.info.model.is_some() && plain
    }
}

/// A way to resolve impacts, in a number system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Model {
    /// How.
    pub mechanics: Mechanics,
    /// In which numbers.
    pub system: System,
}

impl Model {
    /// The cost of one impact, in additions of `f64`, by the weights of `docs/data/methods.csv`;
    /// see [`Mechanics::is_counted`].
    #[must_use]
    pub fn cost(self) -> u64 {
        let counted = self.mechanics.operations().into_iter().zip(self.system.weights());
        counted.map(|(count, weight)| count * weight).sum()
    }
}

impl fmt::Display for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&format!("{}/{}", self.mechanics.id(), self.system))
    }
}

/// A word that names no model.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct UnknownModel(String);

impl Model {
    /// The model of a name: `routh-newton`, which is in `f64`, or `routh-newton/rational`.
    ///
    /// # Errors
    /// [`UnknownModel`], with the name that may be meant.
    pub fn named(text: &str, laws: &'static [Law]) -> Result<Self, UnknownModel> {
        let (name, system) = text.split_once('/').unwrap_or((text, "f64"));
        let unknown = |what: &str, word: &str, names: Vec<String>| {
            let near = nearest(word, names.iter().map(String::as_str));
            let hint = match near {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("there are {}", names.join(", ")),
            };
            UnknownModel(format!("no {what} is called `{word}`; {hint}"))
        };
        if let Some((former, id)) = FORMER.iter().find(|(former, _)| *former == name) {
            return Err(UnknownModel(format!(
                "no model is called `{former}` any more; its law has the id `{id}`"
            )));
        }
        let all = Mechanics::all(laws);
        let mechanics = all.iter().copied().find(|mechanics| mechanics.id() == name);
        let names = || all.iter().map(|mechanics| mechanics.id().to_owned()).collect();
        let mechanics = mechanics.ok_or_else(|| unknown("model", name, names()))?;
        let found = System::ALL.into_iter().find(|known| known.to_string() == system);
        let systems = || System::ALL.iter().map(ToString::to_string).collect();
        let system = found.ok_or_else(|| unknown("number system", system, systems()))?;
        Ok(Self { mechanics, system })
    }
}

/// The names of the models with these laws, from the least.
#[must_use]
pub fn model_names(laws: &'static [Law]) -> Vec<&'static str> {
    Mechanics::all(laws).into_iter().map(Mechanics::id).collect()
}

/// What may stand in for a reference, the reference among them, from the cheapest; among equals the
/// shorter floats first. What is followed in steps is so in `f64` alone.
pub(super) fn candidates(
    reference: Mechanics,
    laws: &'static [Law],
    only_floats: bool,
) -> Vec<Model> {
    use Mechanics::{Annuli, Chain, Compliant, NormalOnly};
    let mut mechanics = vec![NormalOnly];
    if !matches!(reference, NormalOnly | Chain) {
        let laws = laws.iter().filter(|law| Mechanics::stands_in(law));
        mechanics.extend(laws.map(Mechanics::Law));
    }
    if !mechanics.contains(&reference) {
        mechanics.push(reference);
    }
    if reference == Compliant {
        mechanics.push(Annuli);
    }
    let systems = |mechanics: Mechanics| match mechanics {
        _ if only_floats => vec![System::F64],
        Chain | Compliant | Annuli => vec![System::F64],
        _ => vec![System::F32, System::F64, System::DoubleDouble, System::Rational],
    };
    let mut all: Vec<Model> = mechanics
        .iter()
        .flat_map(|mechanics| {
            systems(*mechanics).into_iter().map(|system| Model { mechanics: *mechanics, system })
        })
        .collect();
    all.sort_by_key(|model| (model.cost(), model.system));
    all
}

/// The reference itself, in floats.
pub(super) const fn faithful(reference: Mechanics) -> Model {
    Model { mechanics: reference, system: System::F64 }
}
