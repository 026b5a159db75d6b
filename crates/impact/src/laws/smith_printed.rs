//! The law printed under Smith's name: Whittaker's with a share η.

use kane_number::{Number, Rational};

use super::share::{Share, regimes};
use super::whittaker_uncapped::JAM;
use crate::{ImpactLaw, LawInfo, Parameter, Provenance, Regime};

/// Sliding with the share η of the friction: `i_x` = η (id `smith-printed`).
///
/// Where the contact does not couple, k = 1 − 2η·α. Energy is created for α > 1/η. This is not the
/// law of Smith's paper, for which see [`Smith1991`](crate::laws::Smith1991).
///
/// Domain: contacts on which the ratio has a normal impulse that pushes, `W_nn` > η·μ·`W_tn`;
/// without tangential impulse at `v_t` = 0. Exact in exact numbers.
///
/// In floats, barring under- and overflow, 6 roundings, 6 ulp, where the contact does not couple.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SmithPrinted {
    /// η, a pure number; 2/5 in the paper.
    pub share: Rational,
}

impl Default for SmithPrinted {
    fn default() -> Self {
        Self { share: ETA.default() }
    }
}

const ETA: Parameter = Parameter {
    name: "eta",
    meaning: "the share of the friction",
    least: 0,
    greatest: None,
    default: (2, 5),
    invented: false,
};

impl Share for SmithPrinted {
    fn share(&self) -> &Rational {
        &self.share
    }
}

impl ImpactLaw for SmithPrinted {
    const INFO: LawInfo = LawInfo {
        id: "smith-printed",
        people: "Wang, Su and Li",
        form: "under Smith's name",
        source: "Wang, Su and Li, the text above equation (24), with eta = 0.4; their (25) prints i_xW = 1 for it, which contradicts momentum. Original consulted",
        known_by: Provenance::Original,
        statement: "i_x = eta",
        gap: Some(JAM),
        parameters: &[ETA],
        on_a_sphere: &[("", "1 - 2*eta*alpha")],
        ..LawInfo::PLAIN
    };

    fn values(&self) -> Vec<&Rational> {
        vec![&self.share]
    }

    fn values_mut(&mut self) -> Vec<&mut Rational> {
        vec![&mut self.share]
    }

    fn normal_collision(&self) -> Option<Rational> {
        None // k falls without bound
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const { &regimes("slide") }
    }
}
