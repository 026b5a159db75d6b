//! What is said about a law, as data beside its code.

use kane_number::Rational;

/// The hypothesis by which the coefficient of restitution ends a collision.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Restitution {
    /// Kinematic: `v_n⁺` = −e·`v_n`, in the law's [frame](crate::ImpactLaw::frame).
    Newton,
    /// Kinetic: the normal impulse of restitution is e times that of compression.
    Poisson,
    /// Energetic, after Stronge: the normal work of restitution is e² times that of compression.
    Energetic,
}

impl Restitution {
    /// Its name in a table.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Newton => "Newton",
            Self::Poisson => "Poisson",
            Self::Energetic => "energetic",
        }
    }

    /// What it says.
    #[must_use]
    pub const fn in_words(self) -> &'static str {
        match self {
            Self::Newton => "Newton, v_n+ = e*a",
            Self::Poisson => "Poisson, the impulse of restitution is e times that of compression",
            Self::Energetic => {
                "energetic, the normal work of restitution is e^2 times that of compression"
            }
        }
    }
}

/// What was read of the publication of a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Provenance {
    /// The publication itself.
    Original,
    /// Its abstract; the formula was derived anew from what that says.
    Abstract,
    /// Other publications that quote it, and its abstract or one of a sequel.
    OthersAndAbstract,
    /// Other publications that quote it.
    Others,
}

impl Provenance {
    /// Its name in a table.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Original => "original",
            Self::Abstract => "abstract",
            Self::OthersAndAbstract => "through others, and an abstract",
            Self::Others => "through others",
        }
    }
}

/// A parameter of a law, and its domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// The name in the law's statement.
    pub name: &'static str,
    /// What it is, in a few words.
    pub meaning: &'static str,
    /// The least value.
    pub least: i8,
    /// The greatest value, or `None` without bound.
    pub greatest: Option<i8>,
    /// Numerator and denominator, which is not zero, of the value where none is given.
    pub default: (i64, i64),
    /// Whether that value is invented here and belongs to no material.
    pub invented: bool,
}

impl Parameter {
    /// The value where none is given.
    #[must_use]
    pub fn default(&self) -> Rational {
        Rational::new(self.default.0.into(), self.default.1.into())
    }

    /// Whether a value is in the domain.
    #[must_use]
    pub fn admits(&self, value: &Rational) -> bool {
        let bound = |n: i8| Rational::from_integer(n.into());
        *value >= bound(self.least)
            && self.greatest.is_none_or(|greatest| *value <= bound(greatest))
    }

    /// The domain in words.
    #[must_use]
    pub fn domain(&self) -> String {
        match self.greatest {
            Some(greatest) => format!("from {} to {greatest}", self.least),
            None => format!("at least {}", self.least),
        }
    }
}

/// How a law goes on through the infinitely many impacts of a ball that comes to rest, each with e
/// times the approach of the one before, on a contact that does not couple and has no friction
/// without slip.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Lasting {
    /// Friction acts in full against the slip, as long as all that is left of it does not stop that.
    Full,
    /// So it does, or else every impact gives the same share of the slip back: the law's only
    /// parameter.
    Share,
    /// There is no closed form: impacts are followed one by one as long as there is slip.
    Unsummed,
}

/// What whoever chooses between models needs to know of a law that is one of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ModelInfo {
    /// What the law is, in words that follow "by".
    pub words: &'static str,
    /// Additions, multiplications, divisions and roots of an impact of a ball, the most over little
    /// and much slip: what a test counts in the law's code (a fused multiply-add is two).
    pub operations: [u64; 4],
    /// What becomes of the slip of a ball that comes to rest.
    pub lasting: Lasting,
}

/// On a sphere, the slip slows down by friction until it stops.
pub(crate) const STOPS: &[(&str, &str)] = &[("", "max(0, 1 - 2*alpha)")];

/// What is said about a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LawInfo {
    /// The name of the law in every table and report; printed and true forms differ.
    pub id: &'static str,
    /// Whose law it is.
    pub people: &'static str,
    /// The year of the publication, where the law is named after one.
    pub year: Option<u16>,
    /// Which form of their law this is, or under which name they print it; empty for the only one.
    pub form: &'static str,
    /// Who published the law, and what was consulted: one sentence without its full stop.
    pub source: &'static str,
    /// On what the formula rests.
    pub known_by: Provenance,
    /// What the law adds to momentum and restitution, in the derivation language, one claim a
    /// line, for a contact that faces forwards: in the symbols k = `v_t⁺`/`v_t`, `i_x` =
    /// −`p_t`/(μ·`p_n`), alpha, e, mu and the law's own parameters.
    pub statement: &'static str,
    /// k(α) on a sphere, in pieces: up to which α, or nothing for the last, and the formula. Empty
    /// for a law in a frame of its own, whose k depends on e, μ and the angle of incidence one by one.
    pub on_a_sphere: &'static [(&'static str, &'static str)],
    /// Whether the statement also determines the impulse on contacts that couple, or only, as for
    /// the laws that integrate a process, what they come to where the contact does not.
    pub stated_for_coupling: bool,
    /// Whether the law is the process of [`oracle::integrate`](crate::oracle::integrate) under its
    /// restitution.
    pub is_process: bool,
    /// The law's own parameters, beyond μ and e.
    pub parameters: &'static [Parameter],
    /// The hypothesis of restitution.
    pub restitution: Restitution,
    /// What the law lacks where no regime applies, or `None` if the regimes cover every contact.
    pub gap: Option<&'static str>,
    /// Why an answer that a regime has is not accepted, where that is another cause than the gap.
    pub rejects: Option<&'static str>,
    /// What a reader of its numbers must not miss, in a sentence without its full stop.
    pub caveat: Option<&'static str>,
    /// For a law that scenes may be answered by.
    pub model: Option<ModelInfo>,
    /// Where the law is met under another name: a sentence without its full stop, or nothing.
    pub engines: &'static str,
}

impl LawInfo {
    /// What most laws have in common: Newton's restitution, no parameters, no gap, and a statement
    /// that determines the impulse everywhere. The texts are empty.
    pub const PLAIN: Self = Self {
        id: "",
        people: "",
        year: None,
        form: "",
        source: "",
        known_by: Provenance::Others,
        statement: "",
        on_a_sphere: &[],
        stated_for_coupling: true,
        is_process: false,
        parameters: &[],
        restitution: Restitution::Newton,
        gap: None,
        rejects: None,
        caveat: None,
        model: None,
        engines: "",
    };

    /// All that the law lacks: its gap, and what it rejects.
    #[must_use]
    pub fn lacks(&self) -> Option<String> {
        match (self.gap, self.rejects) {
            (Some(gap), Some(rejects)) => Some(format!("{gap}, or {rejects}")),
            (gap, rejects) => gap.or(rejects).map(ToOwned::to_owned),
        }
    }

    /// Whose law it is, and since when: `Garwin 1969, with Coulomb's bound`.
    #[must_use]
    pub fn who(&self) -> String {
        let year = self.year.map_or_else(String::new, |year| format!(" {year}"));
        let form = if self.form.is_empty() { "" } else { ", " };
        format!("{}{year}{form}{}", self.people, self.form)
    }
}
