//! What must hold of an outcome in exact numbers, whatever the law.

use super::lanes::Happened;
use super::{Check, System};
use kane_impact::bodies::Ledger;
use kane_impact::{Facing, Frame, Law, NumberSystem, Restitution};

/// Checks the outcome against momentum, restitution and energy, by other ways than the law's.
pub(super) fn checks<N: NumberSystem>(
    law: &Law,
    system: &System<N>,
    happened: &Happened<N>,
) -> Vec<Check> {
    let Happened { contact, outcome, after, .. } = happened;
    let (info, law) = (law.info, law.over::<N>());
    let equal = |a: &N, b: &N| a.compare(b).is_equal() == Some(true);
    let check = |claim: &str, holds: bool| Check { claim: claim.to_owned(), holds };
    let work = outcome.work.total();

    let mut checks = vec![
        check(
            "momentum along the tangent: v_t+ = v_t + W_tt*p_t + W_tn*p_n",
            equal(&outcome.slip, &contact.slip_after(&outcome.impulse)),
        ),
        check(
            "momentum along the normal: v_n+ = -a + W_tn*p_t + W_nn*p_n",
            equal(&outcome.separation, &contact.separation_after(&outcome.impulse)),
        ),
    ];
    let moving = system.moving(&after.velocities);
    if info.restitution == Restitution::Newton {
        let (forward, impulse) = match contact.facing() {
            Some(Facing::Backward) => (contact.mirrored(), outcome.impulse.clone().mirrored()),
            _ => (contact.clone(), outcome.impulse.clone()),
        };
        let slips = contact.slip().sign().is_equal() != Some(true);
        let (claim, separation, newton) = match law.frame(&forward).filter(|_| slips) {
            None => {
                let newton = contact.restitution().clone() * contact.approach();
                ("restitution after Newton: v_n+ = e*a", outcome.separation.clone(), newton)
            }
            Some(Frame { turn, contact }) => {
                let newton = contact.restitution().clone() * contact.approach();
                let separation = contact.separation_after(&impulse.turned(&turn));
                ("restitution after Newton in the law's frame: v_n'+ = e'*a'", separation, newton)
            }
        };
        checks.push(check(claim, equal(&separation, &newton)));
    }
    let change = moving.kinetic_energy() - system.kinetic_energy();
    checks.push(check("energy: T+ - T- of the bodies = dE_t + dE_n", equal(&change, &work)));
    if let Some(Ledger { normal, tangential, rotational }) = &after.ledger {
        let sum = normal.clone() + tangential + rotational;
        checks.push(check("energy by parts: dT_x + dT_y + dT_rot = dE", equal(&sum, &work)));
    }
    // alpha is formed with Newton's p_n in the contact's own frame
    let uncoupled =
        contact.delassus().tn().sign().is_equal() == Some(true) && law.frame(contact).is_none();
    if let (true, Some(alpha), Some(ratios)) = (uncoupled, contact.alpha(), outcome.ratios(contact))
    {
        let one = N::one();
        // i_x is that of a forward slip, and alpha has the sign of the slip
        let alpha = if contact.facing() == Some(Facing::Backward) { -alpha } else { alpha };
        let momentum = alpha.double() * &ratios.impulse;
        let holds = equal(&momentum, &(one.clone() - &ratios.k));
        checks.push(check("without coupling: 2*|alpha|*i_x = 1 - k", holds));
        let twice = -(ratios.impulse.clone() * (one + &ratios.k));
        let holds = equal(&ratios.energy.double(), &twice);
        checks.push(check("without coupling: 2*de = -i_x*(1 + k)", holds));
    }
    checks
}
