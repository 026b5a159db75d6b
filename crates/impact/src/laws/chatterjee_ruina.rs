//! Chatterjee and Ruina's algebraic law, in the plane.

use kane_number::{Number, Rational};

use super::walton::Rebounds;
use crate::law::guards;
use crate::{Contact, Guard, ImpactLaw, Impulse, LawInfo, Parameter, Provenance, Regime, Relation};

/// Between the frictionless and the sticking plastic impulse, inside the cone (id
/// `chatterjee-ruina`).
///
/// With the plastic impulses `p_I` = (0, a/`W_nn`) without friction and `p_II` = −W⁻¹·v of
/// sticking,
///
/// ```text
/// p = (1 + e)·p_I + (1 + e_t)·(p_II − p_I)         if that is inside the friction cone,
/// p = (1 + e)·p_I + κ·(p_II − p_I)                  else, with the κ that puts it on the cone.
/// ```
///
/// Both plastic impulses end with `v_n` = 0, so e is Newton's coefficient. On a sphere, k =
/// max(−`e_t`, 1 − 2α). Energy never rises for 0 ≤ e ≤ 1 and −1 ≤ `e_t` ≤ 1. The same formula holds in
/// space, see [`impulse_in_space`](Self::impulse_in_space).
///
/// Domain: every contact, with 0 ≤ e ≤ 1 and −1 ≤ `e_t` ≤ 1; the range of `e_t` is the caller's.
/// Exact in exact numbers.
///
/// In floats the bound with coupling is the width of the result on intervals; without, heuristic: a
/// few ulp.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChatterjeeRuina {
    /// e_t, the tangential restitution, −1 ≤ e_t ≤ 1.
    pub restitution: Rational,
}

impl Default for ChatterjeeRuina {
    /// e_t = 0.
    fn default() -> Self {
        Self { restitution: E_T.default() }
    }
}

const E_T: Parameter = Parameter {
    name: "e_t",
    meaning: "the tangential restitution",
    least: -1,
    greatest: Some(1),
    default: (0, 1),
    invented: false,
};

/// Where the law stands: in the contact's frame, or in one of the law's own.
pub(crate) trait View<L> {
    /// The contact as it is seen there.
    fn contact<N: Number>(law: &L, contact: &Contact<N>) -> Contact<N>;

    /// An impulse from there, in the contact's frame.
    fn back<N: Number>(law: &L, contact: &Contact<N>, impulse: Impulse<N>) -> Impulse<N>;

    /// Whether the contact is seen as it is.
    const PLAIN: bool;
}

/// In the contact's own frame.
pub(crate) struct Own;

impl<L> View<L> for Own {
    fn contact<N: Number>(_: &L, contact: &Contact<N>) -> Contact<N> {
        contact.clone()
    }

    fn back<N: Number>(_: &L, _: &Contact<N>, impulse: Impulse<N>) -> Impulse<N> {
        impulse
    }

    const PLAIN: bool = true;
}

/// (1 + e_t)·det W·p_II,t = −(1 + e_t)·(`W_nn`·v_t + `W_tn`·a)
fn tangential<L: Rebounds, N: Number>(law: &L, contact: &Contact<N>) -> N {
    let w = contact.delassus();
    let velocity = w.nn().mul_add(contact.slip(), &(contact.approach().clone() * w.tn()));
    -(velocity * (N::one() + law.share::<N>()))
}

/// The impulse before the cone is asked, times det W.
fn numerators<L: Rebounds, N: Number>(law: &L, contact: &Contact<N>) -> (N, N) {
    let (w, tangential) = (contact.delassus(), tangential(law, contact));
    // W_nn·p_n = (1 + e)·a − W_tn·p_t
    let normal = contact.closing() * w.determinant() - tangential.clone() * w.tn();
    (tangential, normal / w.nn())
}

/// μ·`p_n` + `p_t` ≥ 0 of that impulse.
pub(crate) const fn above<V: View<L>, L: Rebounds, N: Number>() -> Guard<L, N> {
    Guard::new(Relation::NotNegative, |law: &L, contact: &Contact<N>| {
        let contact = V::contact(law, contact);
        let (tangential, normal) = numerators(law, &contact);
        normal.mul_add(contact.friction(), &tangential)
    })
}

/// μ·`p_n` − `p_t` ≥ 0 of that impulse.
pub(crate) const fn below<V: View<L>, L: Rebounds, N: Number>() -> Guard<L, N> {
    Guard::new(Relation::NotNegative, |law: &L, contact: &Contact<N>| {
        let contact = V::contact(law, contact);
        let (tangential, normal) = numerators(law, &contact);
        normal.mul_add(contact.friction(), &-tangential)
    })
}

/// `p_t` < 0 of that impulse.
pub(crate) const fn backward<V: View<L>, L: Rebounds, N: Number>() -> Guard<L, N> {
    Guard::new(Relation::Negative, |law: &L, contact: &Contact<N>| {
        tangential(law, &V::contact(law, contact))
    })
}

/// That impulse, where it is inside the cone.
pub(crate) const fn inside<V: View<L>, L: Rebounds, N: Number>(
    name: &'static str,
    guards: &'static [Guard<L, N>],
) -> Regime<L, N> {
    let regime = Regime::new(name, guards, |law: &L, contact: &Contact<N>, _: &N| {
        let seen = V::contact(law, contact);
        let (tangential, normal) = numerators(law, &seen);
        let determinant = seen.delassus().determinant();
        let (tangential, normal) = (tangential / &determinant, normal / determinant);
        V::back(law, contact, Impulse { tangential, normal })
    });
    if !V::PLAIN {
        return regime;
    }
    Regime {
        // v_t⁺ = −e_t·v_t + (e − e_t)·a·W_tn/W_nn, from W·p_I and W·p_II
        slip: Some(|law: &L, contact: &Contact<N>, _: &N| {
            let share = law.share::<N>();
            let (w, e) = (contact.delassus(), contact.restitution().clone());
            let pushed = (e - &share) * contact.approach() * w.tn() / w.nn();
            pushed - share * contact.slip()
        }),
        ..regime
    }
}

/// The impulse on the cone, backwards.
pub(crate) const fn on_the_cone_backward<V: View<L>, L: Rebounds, N: Number>(
    name: &'static str,
    guards: &'static [Guard<L, N>],
) -> Regime<L, N> {
    Regime::new(name, guards, |law, contact, _| {
        let seen = V::contact(law, contact);
        V::back(law, contact, seen.with_ratio(&-seen.friction().clone()))
    })
}

/// The impulse on the cone, forwards.
pub(crate) const fn on_the_cone_forward<V: View<L>, L: Rebounds, N: Number>(
    name: &'static str,
    guards: &'static [Guard<L, N>],
) -> Regime<L, N> {
    Regime::new(name, guards, |law, contact, _| {
        let seen = V::contact(law, contact);
        V::back(law, contact, seen.with_ratio(seen.friction()))
    })
}

/// What the law comes to on a contact that does not couple, in terms of β0 = `e_t`.
pub(crate) const UNCOUPLED: &str = "k >= -beta0\ni_x = 1 when k > -beta0\ni_x <= 1 when k = -beta0";

impl Rebounds for ChatterjeeRuina {
    fn share<N: Number>(&self) -> N {
        N::from_rational(&self.restitution)
    }
}

impl ImpactLaw for ChatterjeeRuina {
    const INFO: LawInfo = LawInfo {
        id: "chatterjee-ruina",
        people: "Chatterjee and Ruina",
        year: Some(1998),
        source: "A. Chatterjee and A. Ruina, J. Appl. Mech. 65 (1998) 939-951, in the form in which the public library OpenTissue implements it; abstract consulted, original not consulted",
        known_by: Provenance::OthersAndAbstract,
        statement: "k >= -e_t\ni_x = 1 when k > -e_t\ni_x <= 1 when k = -e_t",
        stated_for_coupling: false,
        parameters: &[E_T],
        on_a_sphere: &[("", "max(-e_t, 1 - 2*alpha)")],
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
        const {
            &[
                inside::<Own, Self, N>(
                    "inside the cone",
                    guards![above::<Own, Self, N>(), below::<Own, Self, N>()],
                ),
                on_the_cone_backward::<Own, Self, N>(
                    "on the cone, against the slip",
                    guards![backward::<Own, Self, N>()],
                ),
                on_the_cone_forward::<Own, Self, N>("on the cone, along the slip", &[]),
            ]
        }
    }
}
