//! Garwin's superball, and the same within Coulomb's bound.

use kane_number::{Number, Rational};

use super::walton::{PULL, Rebounds, pushes, rebound, slide_on};
use crate::law::guards;
use crate::{Contact, Guard, ImpactLaw, LawInfo, Provenance, Regime, Relation};

/// The superball: the slip is reversed whatever friction it takes, k = −1 (id `garwin`).
///
/// Friction does no work: Δe = 0. Coulomb's bound is not asked; on a sphere it is kept for α ≥ 1.
///
/// Domain: contacts on which the reversal has a normal impulse that pushes, among them all that do
/// not couple, with `i_x` = 1/α; elsewhere the law has no answer. Exact in exact numbers.
///
/// In floats, barring under- and overflow, within 4 ulp where the contact does not couple.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Garwin;

/// The superball on a surface of finite friction: k = max(−1, 1 − 2α) (id `garwin-capped`).
///
/// Sliding forwards all the time if it does not reverse the slip entirely, else [`Garwin`]'s
/// reversal.
///
/// Domain: that of [`Garwin`], and all contacts that slide. Exact in exact numbers.
///
/// In floats, barring under- and overflow, within 7 ulp where the contact does not couple.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GarwinCapped;

impl Rebounds for Garwin {
    fn share<N: Number>(&self) -> N {
        N::one()
    }
}

impl Rebounds for GarwinCapped {
    fn share<N: Number>(&self) -> N {
        N::one()
    }
}

/// The regime of total reversal, whose friction does no work.
const fn reverse<L: Rebounds, N: Number>() -> Regime<L, N> {
    Regime { work: Some(|_, _, _| N::zero()), ..rebound("reverse") }
}

impl ImpactLaw for Garwin {
    const INFO: LawInfo = LawInfo {
        id: "garwin",
        people: "Garwin",
        year: Some(1969),
        source: "R. L. Garwin, Am. J. Phys. 37 (1969) 88-92, for e = 1; abstract consulted",
        known_by: Provenance::Abstract,
        statement: "k = -1",
        gap: Some(PULL),
        on_a_sphere: &[("", "-1")],
        ..LawInfo::PLAIN
    };

    fn normal_collision(&self) -> Option<Rational> {
        Some(-Rational::one())
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        // at α = 0 nothing moves by an impulse along the tangent, and no impulse reverses the slip
        const {
            &[Regime {
                guards: guards![
                    Guard::new(Relation::Positive, |_: &Self, contact: &Contact<N>| contact
                        .delassus()
                        .determinant()),
                    Guard::new(Relation::NotNegative, pushes),
                ],
                ..reverse()
            }]
        }
    }
}

impl ImpactLaw for GarwinCapped {
    const INFO: LawInfo = LawInfo {
        id: "garwin-capped",
        people: "Garwin",
        year: Some(1969),
        form: "with Coulomb's bound",
        source: "Garwin's law with Coulomb's bound, as used for balls by Cross (2002), original not consulted; derived here",
        known_by: Provenance::Others,
        statement: "k >= -1\ni_x = 1 when k > -1\ni_x <= 1 when k = -1",
        gap: Some(PULL),
        on_a_sphere: &[("", "max(-1, 1 - 2*alpha)")],
        ..LawInfo::PLAIN
    };

    fn normal_collision(&self) -> Option<Rational> {
        Some(-Rational::one())
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const { &[slide_on(), reverse()] }
    }
}
