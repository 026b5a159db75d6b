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
    /// `None` without a time step, where there is too little friction to tell the arm, and where it is farther off than
    /// the time step allows.
    pub(crate) fn of(case: &Case<'_>) -> Option<Self> {
        case.given.dt.filter(|dt| *dt > 0.0)?;
        let (facts, tolerance) = (&case.facts, &case.tolerance);
        let mut event = case.event.clone();
        let told = facts.impulse[0].abs() > 100.0 * tolerance.tangential;
        if !told || facts.moment.abs() > tolerance.moment {
            return None;
        }
        move_arm(&mut event.first, facts.moment, facts.impulse[0]);
        if let Some(body) = &mut event.second {
            let (moment, [friction, _]) = (facts.other_moment?, facts.reaction?);
            if moment.abs() > tolerance.other_moment {
                return None;
            }
            move_arm(body, moment, friction);
        }
        let (facts, w) = (event.facts(), event.delassus());
        let mobility = [*w.tt(), *w.tn(), *w.nn()];
        Some(Self { slip: facts.before[0], slip_after: facts.after[0], mobility })
    }
}

/// M = J·Δω − (x·p_n − y·p_t) = (y − y')·p_t.
fn move_arm(body: &mut Moving<f64>, moment: f64, friction: f64) {
    body.arm[1] -= moment / friction;
}
