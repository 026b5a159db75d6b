//! Djerassi's solutions of the planar collision with friction.

use super::routh::process_law;

/// Routh's process with Newton's restitution, accepted where energy does not rise (id
/// `djerassi-newton`).
///
/// The impulse of [`RouthNewton`](crate::laws::RouthNewton); where it would create energy the law
/// has no answer. On a sphere it always has one.
///
/// Domain: contacts on which that impulse creates no energy, among them all that do not couple,
/// with k = max(0, 1 − 2α); elsewhere the law has no answer. Exact in exact numbers.
///
/// Source: S. Djerassi, Multibody Syst. Dyn. 21 (2009) 37–54, part A, from memory of its use in the
/// literature: that Newton's hypothesis needs criteria of acceptance; original not consulted, and
/// the criterion is ours.
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
/// Source: S. Djerassi, Multibody Syst. Dyn. 21 (2009) 55–70, part B, original not consulted;
/// introduction of its sequel consulted: the solution exists, is unique, coherent and
/// energy-consistent.
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
/// Source: S. Djerassi, Multibody Syst. Dyn. 21 (2009) 55–70, part B, original not consulted;
/// introduction of its sequel consulted.
///
/// In floats heuristic: a few ulp where the contact does not couple; with coupling, once the slip has
/// stopped, plain floats have no bound, and intervals enclose the impulse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DjerassiStronge;

process_law!(
    DjerassiNewton,
    "djerassi-newton",
    "Djerassi 2009, part A",
    "S. Djerassi, Multibody Syst. Dyn. 21 (2009) 37-54, part A, from memory of its use in the literature: that Newton's hypothesis needs criteria of acceptance; original not consulted, and the criterion is ours",
    Newton: newton, newton,
    "Newton's hypothesis would create energy here, so its solution is not accepted" by energy_loss
);
process_law!(
    DjerassiPoisson, "djerassi-poisson",
    "Djerassi 2009, part B", "S. Djerassi, Multibody Syst. Dyn. 21 (2009) 55-70, part B, original not consulted; introduction of its sequel consulted: the solution exists, is unique, coherent and energy-consistent", Poisson: poisson_compression, poisson_restitution
);
process_law!(
    DjerassiStronge, "djerassi-stronge",
    "Djerassi 2009, part B", "S. Djerassi, Multibody Syst. Dyn. 21 (2009) 55-70, part B, original not consulted; introduction of its sequel consulted", Energetic: energetic_compression, energetic_restitution
);
