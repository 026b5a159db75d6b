//! Djerassi's solutions of the planar collision with friction.

use kane_number::{Number, Rational};

use super::routh::{UNCOUPLED, regimes};
use crate::{Contact, ImpactLaw, Impulse, Regime, Restitution};

/// Routh's process with Newton's restitution, accepted where energy does not rise (id
/// `djerassi-newton`).
///
/// The impulse of [`RouthNewton`](crate::laws::RouthNewton); where it would create energy the law
/// has no answer. On a sphere it always has one.
///
/// Source: S. Djerassi, Multibody Syst. Dyn. 21 (2009) 37–54, part A, from memory of its use in the
/// literature: that Newton's hypothesis needs criteria of acceptance; the criterion is ours.
///
/// In floats the bound with coupling is the width of the result on intervals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DjerassiNewton;

/// Routh's process with Poisson's restitution (id `djerassi-poisson`).
///
/// The impulse of [`Keller1986`](crate::laws::Keller1986), always accepted.
///
/// Source: S. Djerassi, Multibody Syst. Dyn. 21 (2009) 55–70, part B; introduction of its sequel
/// consulted: the solution exists, is unique, coherent and energy-consistent.
///
/// In floats the bound with coupling is the width of the result on intervals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DjerassiPoisson;

/// Routh's process with energetic restitution (id `djerassi-stronge`).
///
/// The impulse of [`Stronge1990`](crate::laws::Stronge1990), always accepted.
///
/// Source: S. Djerassi, Multibody Syst. Dyn. 21 (2009) 55–70, part B; introduction of its sequel
/// consulted.
///
/// With coupling plain floats are heuristic once the slip has stopped, and intervals enclose the
/// impulse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DjerassiStronge;

impl ImpactLaw for DjerassiNewton {
    fn id(&self) -> &'static str {
        "djerassi-newton"
    }

    fn source(&self) -> &'static str {
        "S. Djerassi, Multibody Syst. Dyn. 21 (2009) 37-54, part A, from memory of its use in the literature; the criterion of acceptance is ours"
    }

    fn statement(&self) -> &'static str {
        UNCOUPLED
    }

    fn is_stated_for_coupling(&self) -> bool {
        false
    }

    fn normal_collision(&self) -> Option<Rational> {
        Some(Rational::zero())
    }

    fn gap(&self) -> Option<&'static str> {
        Some("Newton's hypothesis would create energy here, so its solution is not accepted")
    }

    fn acceptance<N: Number>(&self, contact: &Contact<N>, impulse: &Impulse<N>) -> Option<N> {
        Some(contact.energy_loss(impulse))
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        regimes!(newton, newton)
    }
}

impl ImpactLaw for DjerassiPoisson {
    fn id(&self) -> &'static str {
        "djerassi-poisson"
    }

    fn source(&self) -> &'static str {
        "S. Djerassi, Multibody Syst. Dyn. 21 (2009) 55-70, part B; introduction of its sequel consulted"
    }

    fn statement(&self) -> &'static str {
        UNCOUPLED
    }

    fn restitution(&self) -> Restitution {
        Restitution::Poisson
    }

    fn is_stated_for_coupling(&self) -> bool {
        false
    }

    fn normal_collision(&self) -> Option<Rational> {
        Some(Rational::zero())
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        regimes!(poisson_compression, poisson_restitution)
    }
}

impl ImpactLaw for DjerassiStronge {
    fn id(&self) -> &'static str {
        "djerassi-stronge"
    }

    fn source(&self) -> &'static str {
        "S. Djerassi, Multibody Syst. Dyn. 21 (2009) 55-70, part B; introduction of its sequel consulted"
    }

    fn statement(&self) -> &'static str {
        UNCOUPLED
    }

    fn restitution(&self) -> Restitution {
        Restitution::Energetic
    }

    fn is_stated_for_coupling(&self) -> bool {
        false
    }

    fn normal_collision(&self) -> Option<Rational> {
        Some(Rational::zero())
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        regimes!(energetic_compression, energetic_restitution)
    }
}
