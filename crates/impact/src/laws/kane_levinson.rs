//! The algorithm of Kane and Levinson: friction by the slip at the end.

use kane_number::{Number, Rational};

use super::whittaker_uncapped::slide;
use crate::info::STOPS;
use crate::law::guards;
use crate::{Contact, Guard, ImpactLaw, LawInfo, Provenance, Regime, Relation};

/// Friction that opposes the slip *after* the collision (id `kane-levinson`).
///
/// With Newton's restitution: if the impulse that ends with `v_t⁺` = 0 lies in the friction cone,
/// the contact sticks; otherwise `p_t` = −μ·`p_n`·sgn(`v_t⁺`), with the sign for which that holds.
/// Exactly one of the three is consistent, because `v_t⁺` grows with `p_t`/`p_n` wherever
/// `p_n` > 0. On a sphere this is k = max(0, 1 − 2α). On a contact that couples it may create
/// energy: this is the setting in which Kane found his puzzle.
///
/// Domain: every contact. Exact in exact numbers.
///
/// In floats each regime is a quotient of few terms; with coupling they may cancel, and the bound
/// is the width of the result on intervals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KaneLevinson;

/// det W·(μ·`p_n` ± `p_t`) of the impulse that ends without slip.
fn margin<N: Number>(contact: &Contact<N>, tangential: fn(N) -> N) -> N {
    let (t, n) = contact.numerators_ending_at(&N::zero());
    n.mul_add(contact.friction(), &tangential(t))
}

impl ImpactLaw for KaneLevinson {
    const INFO: LawInfo = LawInfo {
        id: "kane-levinson",
        people: "Kane and Levinson",
        year: Some(1985),
        source: "T. R. Kane and D. A. Levinson, Dynamics: Theory and Applications (1985), as quoted in the literature on the puzzle; original not consulted",
        known_by: Provenance::Others,
        statement: "i_x = 1 when k > 0\ni_x <= 1 when k = 0\ni_x >= -1 when k = 0\ni_x = -1 when k < 0",
        on_a_sphere: STOPS,
        engines: "in the plane the one-step law of time-stepping engines: Moreau's inclusion, Newton's restitution and Coulomb's cone on the velocity afterwards",
        ..LawInfo::PLAIN
    };

    fn normal_collision(&self) -> Option<Rational> {
        Some(Rational::zero())
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const {
            &[
                Regime {
                    slip: Some(|_, _, _| N::zero()),
                    work: None,
                    ..Regime::new(
                        "stick",
                        guards![
                            Guard::new(Relation::NotNegative, |_, contact: &Contact<N>| {
                                margin(contact, |t| t)
                            }),
                            Guard::new(Relation::NotNegative, |_, contact: &Contact<N>| {
                                margin(contact, |t| -t)
                            }),
                        ],
                        |_, contact, _| contact.ending_at(&N::zero()),
                    )
                },
                Regime::new("slide", guards![Guard::slides_apart(), Guard::slides_on()], slide),
                Regime::new(
                    "slide back",
                    guards![
                        Guard::new(Relation::Positive, |_, contact: &Contact<N>| {
                            contact
                                .friction()
                                .mul_add(contact.delassus().tn(), contact.delassus().nn())
                        }),
                        Guard::new(Relation::NotPositive, |_, contact: &Contact<N>| {
                            let (w, mu) = (contact.delassus(), contact.friction());
                            let before = contact.slip().clone() * mu.mul_add(w.tn(), w.nn());
                            before + contact.closing() * mu.mul_add(w.tt(), w.tn())
                        }),
                    ],
                    |_, contact, _| contact.with_ratio(contact.friction()),
                ),
            ]
        }
    }
}
