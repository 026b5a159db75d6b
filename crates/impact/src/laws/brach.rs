//! Brach's impulse ratio, within the bound that energy sets.

use kane_number::{Number, Rational};

use super::share::{Share, regimes};
use crate::{Contact, ImpactLaw, Impulse, LawInfo, Parameter, Provenance, Regime};

/// A given ratio of the impulses, `p_t` = −`μ_B`·`p_n`, admitted where it does not create energy
/// (id `brach`).
///
/// `μ_B` is a datum of the collision, given here as a share of μ: `i_x` = `μ_B`/μ. Where the
/// contact does not couple, k = 1 − 2α·`i_x`, and the bound on the tangential energy alone would be
/// `μ_B` ≤ 2·`μ_c` with the ratio `μ_c` = μ/(2α) that just stops the slip. The bound used here is
/// on all energy, ΔT ≤ 0.
///
/// Domain: contacts on which the ratio has a normal impulse that pushes, `W_nn` > `μ_B`·`W_tn`, and
/// creates no energy; elsewhere, and so for large α, the law has no answer. Without tangential
/// impulse at `v_t` = 0. Exact in exact numbers.
///
/// In floats, barring under- and overflow, 6 roundings, 6 ulp, where the contact does not couple.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Brach {
    /// `μ_B`/μ, a pure number.
    pub share: Rational,
}

impl Default for Brach {
    /// `μ_B` = μ.
    fn default() -> Self {
        Self { share: SHARE.default() }
    }
}

const SHARE: Parameter = Parameter {
    name: "share",
    meaning: "mu_B/mu, the ratio of the impulses by mu",
    least: 0,
    greatest: None,
    default: (1, 1),
    invented: false,
};

impl Share for Brach {
    fn share(&self) -> &Rational {
        &self.share
    }
}

impl ImpactLaw for Brach {
    const INFO: LawInfo = LawInfo {
        id: "brach",
        people: "Brach",
        year: Some(1984),
        source: "R. M. Brach, J. Appl. Mech. 51 (1984) 164-170 and 56 (1989) 133-138, from memory of their use in the literature, originals not consulted; the energy bound is derived here from dT = p*(v + v+)/2",
        known_by: Provenance::Others,
        statement: "i_x = share",
        gap: Some("the impulse ratio mu_B has no normal impulse that pushes"),
        rejects: Some("its impulse would create energy"),
        parameters: &[SHARE],
        on_a_sphere: &[("", "1 - 2*share*alpha")],
        ..LawInfo::PLAIN
    };

    fn values(&self) -> Vec<&Rational> {
        vec![&self.share]
    }

    fn values_mut(&mut self) -> Vec<&mut Rational> {
        vec![&mut self.share]
    }

    fn normal_collision(&self) -> Option<Rational> {
        None // k falls without bound, until the bound forbids it
    }

    fn acceptance<N: Number>(&self, contact: &Contact<N>, impulse: &Impulse<N>) -> Option<N> {
        Some(contact.energy_loss(impulse))
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const { &regimes("given ratio") }
    }
}
