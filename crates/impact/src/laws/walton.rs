//! Walton's three parameters: e, μ and the tangential restitution β0.

use kane_number::{Number, Rational};

use super::whittaker_uncapped::slide;
use crate::law::guards;
use crate::{
    Contact, Guard, ImpactLaw, Lasting, LawInfo, ModelInfo, Parameter, Provenance, Regime, Relation,
};

/// Sliding, or else a fixed share of the slip reversed: k = max(−β0, 1 − 2α) (id `walton`).
///
/// Sliding forwards all the time if it ends with `v_t⁺` ≥ −β0·`v_t`; else the impulse that ends
/// with `v_t⁺` = −β0·`v_t`. The law is published for spheres; carried over to contacts that couple
/// it may leave the friction cone, and where its normal impulse would pull it has no answer.
///
/// Domain: contacts on which the rebound has a normal impulse that pushes, among them all that do
/// not couple, with 0 ≤ β0 ≤ 1; the range of β0 is the caller's. Exact in exact numbers.
///
/// In floats, barring under- and overflow, within 7 ulp where the contact does not couple.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Walton {
    /// β0, the tangential restitution at sticking; 0 ≤ β0 ≤ 1.
    pub restitution: Rational,
}

impl Default for Walton {
    fn default() -> Self {
        Self { restitution: BETA0.default() }
    }
}

/// β0 of glass spheres.
pub(crate) const BETA0: Parameter = Parameter {
    name: "beta0",
    meaning: "the tangential restitution at sticking",
    least: 0,
    greatest: Some(1),
    default: (11, 25),
    invented: false,
};

/// A law that reverses a fixed share of the slip where it does not slide.
pub(crate) trait Rebounds: ImpactLaw {
    /// β0, the share.
    fn share<N: Number>(&self) -> N;

    /// v_t⁺ = −β0·v_t.
    fn slip<N: Number>(&self, contact: &Contact<N>) -> N {
        -(self.share::<N>() * contact.slip())
    }
}

/// Sliding forwards all the time, if it ends with v_t⁺ ≥ −β0·v_t:
/// (1 + β0)·v_t·(`W_nn` − μ·`W_tn`) ≥ (1 + e)·a·(μ·`W_tt` − `W_tn`).
pub(crate) const fn slide_on<L: Rebounds, N: Number>() -> Regime<L, N> {
    Regime::new(
        "slide",
        guards![
            Guard::slides_apart(),
            Guard::new(Relation::NotNegative, |law: &L, contact: &Contact<N>| {
                let change = (N::one() + law.share::<N>()) * contact.slip();
                change * contact.separation_rate() - contact.closing() * contact.slowing_rate()
            }),
        ],
        slide,
    )
}

/// The impulse that ends with v_t⁺ = −β0·v_t, if it pushes; (1 + β0)·v_t/`W_tt` without coupling.
pub(crate) const fn rebound<L: Rebounds, N: Number>(name: &'static str) -> Regime<L, N> {
    Regime {
        slip: Some(|law: &L, contact, _| law.slip(contact)),
        ..Regime::new(
            name,
            guards![Guard::new(Relation::NotNegative, pushes)],
            |law, contact, _| contact.ending_at(&law.slip(contact)),
        )
    }
}

/// det W times the normal impulse of the rebound, which must push.
pub(crate) fn pushes<L: Rebounds, N: Number>(law: &L, contact: &Contact<N>) -> N {
    contact.numerators_ending_at(&law.slip(contact)).1
}

pub(crate) const PULL: &str = "the rebound of the slip has no normal impulse that pushes";

impl Rebounds for Walton {
    fn share<N: Number>(&self) -> N {
        N::from_rational(&self.restitution)
    }
}

impl ImpactLaw for Walton {
    const INFO: LawInfo = LawInfo {
        id: "walton",
        people: "Walton",
        year: Some(1993),
        source: "O. R. Walton, in Particulate Two-Phase Flow, ed. Roco (1993), as quoted by Foerster et al. (1994); original not consulted. The default beta0 = 0.44 is theirs for glass spheres, from memory",
        known_by: Provenance::Others,
        statement: "k >= -beta0\ni_x = 1 when k > -beta0\ni_x <= 1 when k = -beta0",
        gap: Some(PULL),
        parameters: &[BETA0],
        on_a_sphere: &[("", "max(-beta0, 1 - 2*alpha)")],
        model: Some(ModelInfo {
            words: "Coulomb friction with tangential restitution",
            operations: [21, 27, 4, 0],
            lasting: Lasting::Share,
        }),
        ..LawInfo::PLAIN
    };

    fn values(&self) -> Vec<&Rational> {
        vec![&self.restitution]
    }

    fn values_mut(&mut self) -> Vec<&mut Rational> {
        vec![&mut self.restitution]
    }

    fn normal_collision(&self) -> Option<Rational> {
        Some(-self.restitution.clone())
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const { &[slide_on(), rebound("rebound of the slip")] }
    }
}
