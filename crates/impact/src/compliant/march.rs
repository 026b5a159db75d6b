//! The tangential motion, step by step, with its ledger.

use super::hertz::Node;
use super::{Compliance, NoOutcome, grazing};
use crate::Ratios;

/// What the steps of a process were held to. Energies are divided by that of the slip before.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ledger {
    /// How many steps, or, for a closed form, pieces there were.
    pub steps: usize,
    /// The greatest excess of |friction| over μ·F, in units of the greatest μ·F; 0 if never.
    pub beyond_cone: f64,
    /// The greatest kinetic energy of the slip above the one before, over all steps; 0 if never.
    pub above_start: f64,
    /// The sum of all rises of kinetic and stored energy together, the method's own term of O(h²)
    /// taken off; `None` where a process has no stored energy that depends on its state alone.
    pub created: Option<f64>,
}

/// A moment of a collision, as an observer sees it. Dimensionless, see [the module](super).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Time since the bodies touched, by that in which the approach speed covers the greatest
    /// penetration.
    pub time: f64,
    /// F, the normal force; its impulse is 1 + e.
    pub normal: f64,
    /// g/λ, the friction by μ in the same unit, so that Coulomb's cone is |friction| ≤ normal; 0
    /// throughout if α = ∞.
    pub friction: f64,
    /// y = `v_t`/`v_t0`.
    pub slip: f64,
}

/// The tangential answer of a contact to displacement.
pub(super) trait Response {
    /// Goes on to a node at which the bodies are displaced by `displacement` in all, `by` of it since
    /// the last one, and returns the friction g.
    fn respond(&mut self, to: usize, displacement: f64, by: f64) -> Result<f64, NoOutcome>;

    /// The energy that is stored, if that is a function of the state.
    fn stored(&self) -> Option<f64>;

    /// The greatest excess over the local cone at this state, in units of the greatest force; for
    /// a single contact that of [`march`] says it all.
    fn beyond_cone(&self) -> f64 {
        0.0
    }
}

/// λ·F; in normal collision the cone is as wide as need be until the bodies part.
pub(super) fn bound(cone: f64, force: f64) -> f64 {
    if cone == f64::INFINITY { cone } else { cone * force }
}

/// Velocity Verlet: of second order where friction changes smoothly, and exact in its balance:
///
/// ```text
/// ΔS = h·y − χ·h²·g    y⁺ = y − χ·h·(g + g⁺)
/// Δ(y²/(4χ) − χ·h²·g²/4) = −(g + g⁺)/2·ΔS
/// ```
///
/// so that no energy appears which the response did not give.
///
/// Without a response the contact slides forwards all the time.
pub(super) fn march(
    nodes: &[Node],
    compliance: &Compliance,
    alpha: f64,
    mut response: Option<&mut impl Response>,
    observe: &mut dyn FnMut(&Moment),
) -> Result<(Ratios<f64>, Ledger), NoOutcome> {
    let stored = response.as_ref().map_or(Some(0.0), |response| response.stored());
    let mut ledger = Ledger { created: stored.map(|_| 0.0), ..Ledger::default() };
    if alpha == 0.0 {
        return Ok((grazing(), ledger));
    }
    let (chi, cone) = (compliance.chi(), compliance.cone(alpha));
    let whole = cone * (1.0 + compliance.restitution());
    let greatest = nodes.iter().map(|node| node.force).fold(0.0, f64::max);
    let (mut y, mut g, mut displacement) = (1.0_f64, 0.0_f64, 0.0_f64);
    let (mut impulse, mut work) = (0.0, 0.0);
    let mut stored = stored.unwrap_or(0.0);
    let moment = |node: &Node, g: f64, y: f64| Moment {
        time: node.time,
        normal: node.force,
        friction: g / cone,
        slip: y,
    };
    if let Some(first) = nodes.first() {
        observe(&moment(first, g, y));
    }
    for (n, pair) in nodes.windows(2).enumerate() {
        let [from, to] = pair else { continue };
        let h = to.time - from.time;
        let by = h * (y - chi * h * g);
        displacement += by;
        let next = match &mut response {
            Some(response) => response.respond(n + 1, displacement, by)?,
            None => bound(cone, to.force),
        };
        let mean = (g + next) / 2.0;
        let slower = y - 2.0 * chi * h * mean;
        impulse += h * mean;
        work -= h * mean * (y + slower) / 2.0;
        let excess = (next.abs() - bound(cone, to.force)).max(0.0) / (cone * greatest);
        let local = response.as_ref().map_or(0.0, |response| response.beyond_cone());
        ledger.beyond_cone = ledger.beyond_cone.max(excess).max(local);
        ledger.above_start = ledger.above_start.max(slower * slower - 1.0);
        let now = response.as_ref().and_then(|response| response.stored());
        if let (Some(now), Some(created)) = (now, &mut ledger.created) {
            let method = chi * h * h * (next * next - g * g) / 4.0;
            let kinetic = (slower * slower - y * y) / (4.0 * chi);
            *created += ((kinetic - method + now - stored) * 4.0 * chi).max(0.0);
            stored = now;
        }
        (y, g) = (slower, next);
        ledger.steps += 1;
        observe(&moment(to, g, y));
    }
    Ok((Ratios { k: y, impulse: impulse / whole, energy: work / whole }, ledger))
}
