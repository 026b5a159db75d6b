//! Djerassi's solutions of the planar collision with friction.

use super::routh::{PROCESS, process_law};
use crate::{LawInfo, Provenance, Restitution};

/// Routh's process with Newton's restitution, accepted where energy does not rise (id
/// `djerassi-newton`).
///
/// The impulse of [`RouthNewton`](crate::laws::RouthNewton); where it would create energy the law
/// has no answer. On a sphere it always has one.
///
/// Domain: contacts on which that impulse creates no energy, among them all that do not couple,
/// with k = max(0, 1 − 2α); elsewhere the law has no answer. Exact in exact numbers.
///
/// In floats the bound with coupling is the width of the result on intervals; without, heuristic: a
/// few ulp.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DjerassiNewton;

/// Routh's process with Poisson's restitution (id `djerassi-poisson`).
///
/// The impulse of [`Keller1986`](crate::laws::Keller1986), always accepted.
///
/// Domain: every contact; where it does not couple, k = max(0, 1 − 2α). Exact in exact numbers.
///
/// In floats the bound with coupling is the width of the result on intervals; without, heuristic: a
/// few ulp.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DjerassiPoisson;

/// Routh's process with energetic restitution (id `djerassi-stronge`).
///
/// The impulse of [`Stronge1990`](crate::laws::Stronge1990), always accepted.
///
/// Domain: every contact; where it does not couple, k = max(0, 1 − 2α). Exact in exact numbers:
/// algebraic ones hold the square root, rational ones only where it is rational, as it always is
/// without coupling.
///
/// In floats heuristic: a few ulp where the contact does not couple; with coupling, once the slip has
/// stopped, plain floats have no bound, and intervals enclose the impulse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DjerassiStronge;

process_law!(
    DjerassiNewton,
    newton,
    newton,
    LawInfo {
        id: "djerassi-newton",
        people: "Djerassi",
        year: Some(2009),
        form: "part A",
        source: "S. Djerassi, Multibody Syst. Dyn. 21 (2009) 37-54, part A, from memory of its use in the literature: that Newton's hypothesis needs criteria of acceptance; original not consulted, and the criterion is ours",
        known_by: Provenance::Others,
        gap: Some("Newton's hypothesis would create energy here, so its solution is not accepted"),
        ..PROCESS
    },
    accepted by energy_loss
);
process_law!(
    DjerassiPoisson,
    poisson_compression,
    poisson_restitution,
    LawInfo {
        id: "djerassi-poisson",
        people: "Djerassi",
        year: Some(2009),
        form: "part B",
        source: "S. Djerassi, Multibody Syst. Dyn. 21 (2009) 55-70, part B, original not consulted; introduction of its sequel consulted: the solution exists, is unique, coherent and energy-consistent",
        known_by: Provenance::OthersAndAbstract,
        restitution: Restitution::Poisson,
        ..PROCESS
    }
);
process_law!(
    DjerassiStronge,
    energetic_compression,
    energetic_restitution,
    LawInfo {
        id: "djerassi-stronge",
        people: "Djerassi",
        year: Some(2009),
        form: "part B",
        source: "S. Djerassi, Multibody Syst. Dyn. 21 (2009) 55-70, part B, original not consulted; introduction of its sequel consulted",
        known_by: Provenance::OthersAndAbstract,
        restitution: Restitution::Energetic,
        ..PROCESS
    }
);
