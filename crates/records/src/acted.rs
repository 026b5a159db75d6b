//! A contact at the point where its impulse acted.

use crate::case::Case;
use crate::event::Moving;

/// Slips and inverse inertia of a contact at the arm y' at which the impulse acted, J·Δω = x·p_n − y'·p_t. The stated y
/// is uncertain by what the surfaces move within a time step, and y' is within that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Acted {
    /// u_t before; m/s
    pub(crate) slip: f64,
    /// u_t⁺; m/s
    pub(crate) slip_after: f64,
    /// W_tt, W_tn, W_nn; 1/kg
    pub(crate) mobility: [f64; 3],
}

impl Acted {
    /// `None` without a time step, and where the impulse tells an arm that is farther off than the time step allows, or
    /// none for want of friction.
    pub(crate) fn of(case: &Case<'_>) -> Option<Self> {
        case.given.dt.filter(|dt| *dt > 0.0)?;
        let facts = &case.facts;
        let mut event = case.event.clone();
        let [x, y] = event.first.arm;
        let reach = case.tolerance.arm * (x.abs() + y.abs());
        move_arm(&mut event.first, facts.moment / facts.impulse[0], reach)?;
        if let Some(body) = &mut event.second {
            let (moment, [friction, _]) = (facts.other_moment?, facts.reaction?);
            move_arm(body, moment / friction, reach)?;
        }
        let (facts, w) = (event.facts(), event.delassus());
        let mobility = [*w.tt(), *w.tn(), *w.nn()];
        Some(Self { slip: facts.before[0], slip_after: facts.after[0], mobility })
    }
}

/// M = J·Δω − (x·p_n − y·p_t) = (y − y')·p_t.
fn move_arm(body: &mut Moving<f64>, by: f64, reach: f64) -> Option<()> {
    body.arm[1] -= by;
    (by.abs() <= reach).then_some(())
}
