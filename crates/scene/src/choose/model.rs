//! The models, and what they cost.

use std::fmt;
use std::str::FromStr;

use kane_algebra::syntax::nearest;
use kane_number::System;

/// How impacts are resolved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Mechanics {
    /// One dimension: no friction at all.
    NormalOnly,
    /// Friction in full against the slip before, all the time: k = 1 − 2α.
    Sliding,
    /// The law of Wang, Su and Li.
    WangSuLi,
    /// Coulomb friction on rigid bodies, Newton's restitution: slide, then stick.
    Coulomb,
    /// The same where sticking gives a share of the slip back, after Walton.
    Grip,
    /// Coulomb friction on rigid bodies, Stronge's energetic restitution.
    Energetic,
    /// Spheres that touch at once, Hertz's springs.
    Chain,
    /// An elastic contact: a half-space as a row of springs, or a pair of springs if that is stated.
    Compliant,
    /// The half-space annulus by annulus, after Maw, Barber and Fawcett.
    Annuli,
}

impl Mechanics {
    /// From the least.
    pub const ALL: [Self; 9] = [
        Self::NormalOnly,
        Self::Sliding,
        Self::WangSuLi,
        Self::Coulomb,
        Self::Grip,
        Self::Energetic,
        Self::Chain,
        Self::Compliant,
        Self::Annuli,
    ];

    /// Its name.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::NormalOnly => "normal-only",
            Self::Sliding => "sliding",
            Self::WangSuLi => "wang-su-li",
            Self::Coulomb => "coulomb",
            Self::Grip => "grip",
            Self::Energetic => "energetic",
            Self::Chain => "chain",
            Self::Compliant => "compliant",
            Self::Annuli => "annuli",
        }
    }

    /// What it is, in words that follow "by".
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::NormalOnly => "normal impulses alone",
            Self::Sliding => "friction in full against the slip",
            Self::WangSuLi => "the law of Wang, Su and Li",
            Self::Coulomb => "Coulomb friction on rigid bodies",
            Self::Grip => "Coulomb friction with tangential restitution",
            Self::Energetic => "Coulomb friction with energetic restitution",
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
    /// the next one, the most over little and much slip: what a test counts in this code (a fused
    /// multiply-add is two). Those of the integrations are estimates to the nearest power of ten.
    #[must_use]
    pub const fn operations(self) -> [u64; 4] {
        match self {
            Self::NormalOnly => [41, 27, 13, 1],
            Self::Sliding => [43, 33, 14, 1],
            Self::WangSuLi => [63, 45, 21, 1],
            Self::Coulomb => [63, 51, 17, 1],
            Self::Grip => [55, 48, 14, 1],
            Self::Energetic => [96, 81, 28, 2],
            Self::Chain => [100_000, 100_000, 10_000, 1_000],
            Self::Compliant => [100_000, 100_000, 1_000, 1_000],
            Self::Annuli => [10_000_000, 10_000_000, 100_000, 1_000],
        }
    }
}

/// A way to resolve impacts, in a number system.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
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

impl FromStr for Model {
    type Err = UnknownModel;

    /// `coulomb`, which is in `f64`, or `coulomb/rational`.
    fn from_str(text: &str) -> Result<Self, UnknownModel> {
        let (name, system) = text.split_once('/').unwrap_or((text, "f64"));
        let names = || Mechanics::ALL.iter().map(|mechanics| mechanics.id());
        let unknown = |what: &str, word: &str, names: Vec<String>| {
            let near = nearest(word, names.iter().map(String::as_str));
            let hint = match near {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("there are {}", names.join(", ")),
            };
            UnknownModel(format!("no {what} is called `{word}`; {hint}"))
        };
        let mechanics = Mechanics::ALL.into_iter().find(|mechanics| mechanics.id() == name);
        let mechanics = mechanics
            .ok_or_else(|| unknown("model", name, names().map(str::to_owned).collect()))?;
        let found = System::ALL.into_iter().find(|known| known.to_string() == system);
        let systems = || System::ALL.iter().map(ToString::to_string).collect();
        let system = found.ok_or_else(|| unknown("number system", system, systems()))?;
        Ok(Self { mechanics, system })
    }
}

/// What may stand in for a reference, the reference among them, from the cheapest; among equals the
/// shorter floats first.
pub(super) fn candidates(reference: Mechanics) -> Vec<Model> {
    use Mechanics::{
        Annuli, Chain, Compliant, Coulomb, Energetic, Grip, NormalOnly, Sliding, WangSuLi,
    };
    let mechanics: &[Mechanics] = match reference {
        NormalOnly => &[NormalOnly],
        Chain => &[NormalOnly, Chain],
        Grip => &[NormalOnly, Sliding, WangSuLi, Coulomb, Grip],
        Energetic => &[NormalOnly, Sliding, WangSuLi, Coulomb, Energetic],
        Compliant => &[NormalOnly, Sliding, WangSuLi, Coulomb, Compliant, Annuli],
        _ => &[NormalOnly, Sliding, WangSuLi, Coulomb],
    };
    let systems = |mechanics: Mechanics| match mechanics {
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
