//! Laws as values.

use std::fmt;
use std::sync::{Arc, LazyLock};

use kane_algebra::rational_function::RationalFunction;
use kane_number::{Algebraic, DoubleDouble, Interval, Rational, Real, Scaled};

use crate::laws::{
    Brach, ChatterjeeRuina, DjerassiNewton, DjerassiPoisson, DjerassiStronge, Garwin, GarwinCapped,
    KaneLevinson, Keller1986, KellerPrinted, KuninakaHayakawa, LougeAdams, RouthNewton, Saitoh,
    Smith1991, SmithPrinted, Stronge1990, Walton, WangSuLi, WhittakerStop, WhittakerUncapped,
};
use crate::{Formulas, ImpactLaw, LawInfo, LawOver, Restitution};

/// A law with the values of its parameters: what is said about it, and the same code over every
/// number system.
#[derive(Clone)]
pub struct Law {
    /// What is said about the law.
    pub info: &'static LawInfo,
    faces: Arc<dyn Faces>,
}

/// A law over every number system, instantiated here and nowhere above.
trait Faces:
    Formulas<RationalFunction>
    + LawOver<f32>
    + LawOver<f64>
    + LawOver<DoubleDouble>
    + LawOver<Scaled>
    + LawOver<Interval>
    + LawOver<Rational>
    + LawOver<Algebraic>
    + Send
    + Sync
{
    fn parameters(&self) -> Vec<(&'static str, Rational)>;
    fn normal_collision(&self) -> Option<Rational>;
    fn with(&self, name: &str, value: &Rational) -> Option<Law>;
}

impl<L: ImpactLaw> Faces for L {
    fn parameters(&self) -> Vec<(&'static str, Rational)> {
        ImpactLaw::parameters(self)
    }

    fn normal_collision(&self) -> Option<Rational> {
        ImpactLaw::normal_collision(self)
    }

    fn with(&self, name: &str, value: &Rational) -> Option<Law> {
        let place = L::INFO.parameters.iter().position(|parameter| parameter.name == name)?;
        let mut law = self.clone();
        law.values_mut().get_mut(place)?.clone_from(value);
        Some(Law::new(law))
    }
}

/// A number system over which every law stands.
pub trait NumberSystem: Real<WideReal = <Self as NumberSystem>::WideSystem> {
    /// The same type as [`WideReal`](Real::WideReal), named again to promise that it is one too.
    type WideSystem: NumberSystem;

    /// The law over this system.
    fn face(law: &Law) -> &dyn LawOver<Self>;
}

macro_rules! number_systems {
    ($($number:ty),*) => {
        $(impl NumberSystem for $number {
            type WideSystem = <Self as Real>::WideReal;

            fn face(law: &Law) -> &dyn LawOver<Self> {
                &*law.faces
            }
        })*
    };
}
number_systems!(f32, f64, DoubleDouble, Scaled, Interval, Rational, Algebraic);

impl Law {
    /// A law as its author wrote it: all of it is compiled once more where this is called. A published law is
    /// `Law::from` its value instead.
    pub fn new<L: ImpactLaw>(law: L) -> Self {
        Self { info: const { &L::INFO }, faces: Arc::new(law) }
    }

    /// The law over a number system.
    #[must_use]
    pub fn over<N: NumberSystem>(&self) -> &dyn LawOver<N> {
        N::face(self)
    }

    /// The law's formulas in symbols.
    #[must_use]
    pub fn symbolic(&self) -> &dyn Formulas<RationalFunction> {
        &*self.faces
    }

    /// Its own parameters by the names of the statement, beyond μ and e.
    #[must_use]
    pub fn parameters(&self) -> Vec<(&'static str, Rational)> {
        self.faces.parameters()
    }

    /// The limit of k in normal collision, see [`ImpactLaw::normal_collision`].
    #[must_use]
    pub fn normal_collision(&self) -> Option<Rational> {
        self.faces.normal_collision()
    }

    /// The names of its own parameters that stand at invented values.
    #[must_use]
    pub fn invented(&self) -> Vec<&'static str> {
        let own = self.info.parameters.iter().zip(self.parameters());
        let invented = own.filter(|(own, (_, value))| own.invented && *value == own.default());
        invented.map(|(own, _)| own.name).collect()
    }

    /// What its restitution says, and where.
    #[must_use]
    pub fn restitution(&self) -> &'static str {
        match self.info.restitution {
            Restitution::Newton if self.has_frame() => {
                "Newton, v_n'+ = e'*a' in a frame of the law's own, in which its statement and its cone stand too"
            }
            other => other.in_words(),
        }
    }

    /// The law with another value of a parameter, whose range is the caller's; `None` if it has no
    /// such parameter.
    #[must_use]
    pub fn with(&self, name: &str, value: &Rational) -> Option<Self> {
        self.faces.with(name, value)
    }

    /// Whether the law stands in a frame of its own where there is slip.
    #[must_use]
    pub fn has_frame(&self) -> bool {
        let one = Rational::from_integer(1.into());
        self.over::<Rational>().frame(&crate::Contact::of_alpha(one)).is_some()
    }
}

/// Laws are equal that have the same id and the same values of their parameters.
impl PartialEq for Law {
    fn eq(&self, other: &Self) -> bool {
        self.info.id == other.info.id && self.parameters() == other.parameters()
    }
}

impl Eq for Law {}

impl fmt::Debug for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Law")
            .field("id", &self.info.id)
            .field("parameters", &self.parameters())
            .finish_non_exhaustive()
    }
}

macro_rules! published {
    ($($law:ty),* $(,)?) => {
        $(impl From<$law> for Law {
            #[inline(never)]
            fn from(law: $law) -> Self {
                Self::new(law)
            }
        })*
    };
}
published!(
    WangSuLi,
    WhittakerUncapped,
    WhittakerStop,
    RouthNewton,
    Garwin,
    GarwinCapped,
    KaneLevinson,
    Brach,
    Keller1986,
    KellerPrinted,
    Stronge1990,
    Smith1991,
    SmithPrinted,
    Walton,
    ChatterjeeRuina,
    LougeAdams,
    KuninakaHayakawa,
    DjerassiNewton,
    DjerassiPoisson,
    DjerassiStronge,
    Saitoh,
);

/// Every published law with the defaults of its parameters, in the order of tables and reports: the
/// paper's, then by the year of the idea.
#[must_use]
pub fn laws() -> &'static [Law] {
    static LAWS: LazyLock<[Law; 21]> = LazyLock::new(|| {
        [
            Law::from(WangSuLi),
            Law::from(WhittakerUncapped),
            Law::from(WhittakerStop),
            Law::from(RouthNewton),
            Law::from(Garwin),
            Law::from(GarwinCapped),
            Law::from(KaneLevinson),
            Law::from(Brach::default()),
            Law::from(Keller1986),
            Law::from(KellerPrinted),
            Law::from(Stronge1990),
            Law::from(Smith1991),
            Law::from(SmithPrinted::default()),
            Law::from(Walton::default()),
            Law::from(ChatterjeeRuina::default()),
            Law::from(LougeAdams::default()),
            Law::from(KuninakaHayakawa::default()),
            Law::from(DjerassiNewton),
            Law::from(DjerassiPoisson),
            Law::from(DjerassiStronge),
            Law::from(Saitoh::default()),
        ]
    });
    &*LAWS
}

/// The law of this id, with the defaults of its parameters.
#[must_use]
pub fn law(id: &str) -> Option<&'static Law> {
    laws().iter().find(|law| law.info.id == id)
}
