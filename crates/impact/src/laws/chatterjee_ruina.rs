//! Chatterjee and Ruina's algebraic law, in the plane.

use kane_number::{Number, Rational};

use crate::law::guards;
use crate::{Contact, Guard, ImpactLaw, Impulse, Regime, Relation};

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
/// max(−`e_t`, 1 − 2α). Energy never rises for 0 ≤ e ≤ 1 and −1 ≤ `e_t` ≤ 1.
///
/// Domain: every contact, with 0 ≤ e ≤ 1 and −1 ≤ `e_t` ≤ 1; the range of `e_t` is the caller's.
/// Exact in exact numbers.
///
/// Source: A. Chatterjee and A. Ruina, J. Appl. Mech. 65 (1998) 939–951, in the form in which the
/// public library OpenTissue implements it; abstract consulted, original not consulted.
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
        Self { restitution: Rational::zero() }
    }
}

impl ChatterjeeRuina {
    /// (1 + e_t)·det W·p_II,t = −(1 + e_t)·(`W_nn`·v_t + `W_tn`·a)
    fn tangential<N: Number>(&self, contact: &Contact<N>) -> N {
        let w = contact.delassus();
        let velocity = w.nn().mul_add(contact.slip(), &(contact.approach().clone() * w.tn()));
        -(velocity * (N::one() + N::from_rational(&self.restitution)))
    }

    /// The impulse before the cone is asked, times det W.
    fn numerators<N: Number>(&self, contact: &Contact<N>) -> (N, N) {
        let (w, tangential) = (contact.delassus(), self.tangential(contact));
        // W_nn·p_n = (1 + e)·a − W_tn·p_t
        let normal = contact.closing() * w.determinant() - tangential.clone() * w.tn();
        (tangential, normal / w.nn())
    }

    fn margin<N: Number>(&self, contact: &Contact<N>, tangential: fn(N) -> N) -> N {
        let (t, n) = self.numerators(contact);
        n.mul_add(contact.friction(), &tangential(t))
    }
}

impl ImpactLaw for ChatterjeeRuina {
    fn id(&self) -> &'static str {
        "chatterjee-ruina"
    }

    fn source(&self) -> &'static str {
        "A. Chatterjee and A. Ruina, J. Appl. Mech. 65 (1998) 939-951, in the form in which the public library OpenTissue implements it; abstract consulted, original not consulted"
    }

    fn statement(&self) -> &'static str {
        "k >= -e_t\ni_x = 1 when k > -e_t\ni_x <= 1 when k = -e_t"
    }

    fn parameters(&self) -> Vec<(&'static str, Rational)> {
        vec![("e_t", self.restitution.clone())]
    }

    fn is_stated_for_coupling(&self) -> bool {
        false
    }

    fn normal_collision(&self) -> Option<Rational> {
        Some(-self.restitution.clone())
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const {
            &[
                Regime {
                    // v_t⁺ = −e_t·v_t + (e − e_t)·a·W_tn/W_nn, from W·p_I and W·p_II
                    slip: Some(|law: &Self, contact: &Contact<N>, _| {
                        let restitution = N::from_rational(&law.restitution);
                        let (w, e) = (contact.delassus(), contact.restitution().clone());
                        let pushed = (e - &restitution) * contact.approach() * w.tn() / w.nn();
                        pushed - restitution * contact.slip()
                    }),
                    ..Regime::new(
                        "inside the cone",
                        guards![
                            Guard::new(
                                Relation::NotNegative,
                                |law: &Self, contact: &Contact<N>| { law.margin(contact, |t| t) }
                            ),
                            Guard::new(
                                Relation::NotNegative,
                                |law: &Self, contact: &Contact<N>| { law.margin(contact, |t| -t) }
                            ),
                        ],
                        |law, contact, _| {
                            let (tangential, normal) = law.numerators(contact);
                            let determinant = contact.delassus().determinant();
                            Impulse {
                                tangential: tangential / &determinant,
                                normal: normal / determinant,
                            }
                        },
                    )
                },
                Regime::new(
                    "on the cone, against the slip",
                    guards![Guard::new(Relation::Negative, |law: &Self, contact: &Contact<N>| {
                        law.tangential(contact)
                    })],
                    |_, contact, _| contact.with_ratio(&-contact.friction().clone()),
                ),
                Regime::new("on the cone, along the slip", &[], |_, contact, _| {
                    contact.with_ratio(contact.friction())
                }),
            ]
        }
    }
}
