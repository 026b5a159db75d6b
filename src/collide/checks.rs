//! What must hold of an outcome in exact numbers, whatever the law.

use crate::impact::bodies::{CollideError, Ledger};
use crate::impact::{Facing, Frame, Law, NumberSystem, Restitution};
use crate::report::collision::Check;

use super::{Happened, System};

/// Checks the outcome against momentum, restitution and energy, by other ways than the law's.
pub(super) fn checks<N: NumberSystem>(
    law: &Law,
    system: &System<N>,
) -> Result<Vec<Check>, CollideError<N>> {
    let (info, of_system, law) = (law.info, law.over(), law.over::<N>());
    let contact = system.contact()?;
    let Happened { outcome, after, ledger } = system.collide(of_system)?;
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
    let moving = system.moving(&after);
    if info.restitution == Restitution::Newton {
        let forward = law.regime(&contact)?;
        let impulse = match forward.facing {
            Facing::Forward => outcome.impulse.clone(),
            Facing::Backward => outcome.impulse.clone().mirrored(),
        };
        let slips = contact.slip().sign().is_equal() != Some(true);
        let (claim, separation, newton) = match law.frame(&forward.contact).filter(|_| slips) {
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
    if let Some(Ledger { normal, tangential, rotational }) = ledger {
        let sum = normal + tangential + rotational;
        checks.push(check("energy by parts: dT_x + dT_y + dT_rot = dE", equal(&sum, &work)));
    }
    // alpha is formed with Newton's p_n in the contact's own frame
    let uncoupled =
        contact.delassus().tn().sign().is_equal() == Some(true) && law.frame(&contact).is_none();
    if let (true, Some(alpha), Some(ratios)) =
        (uncoupled, contact.alpha(), outcome.ratios(&contact))
    {
        let one = N::one();
        let momentum = alpha.double() * &ratios.impulse;
        let holds = equal(&momentum, &(one.clone() - &ratios.k));
        checks.push(check("without coupling: 2*alpha*i_x = 1 - k", holds));
        let twice = -(ratios.impulse.clone() * (one + &ratios.k));
        let holds = equal(&ratios.energy.double(), &twice);
        checks.push(check("without coupling: 2*de = -i_x*(1 + k)", holds));
    }
    Ok(checks)
}
