//! The end of a bouncing ball: infinitely many impacts in a finite time, in closed form.

use crate::coordinate::Coordinate;
use crate::world::Round;

/// How the slip goes on through the impacts that are left.
#[derive(Clone, Debug)]
pub(super) enum Tail<N> {
    /// No friction acts: the slip is zero and stays so, or μ = 0.
    Free,
    /// Friction acts in full against the slip, by its sign, at every impact.
    Sliding(N),
}

/// What is left of the bouncing of a ball that has just left the floor upwards with v, for
/// 0 ≤ e < 1. The flights last 2v·eⁿ/g, so that
///
/// ```text
/// T = 2v/(g·(1 − e))        Σ p_n/m = (1 + e)·v/(1 − e)
/// ```
///
/// and, sliding all the way with s the sign of the slip, `v_x` falls by s·μ·(1 + e)·v·eⁿ at each impact:
///
/// ```text
/// Δv_x = −s·μ·(1 + e)·v/(1 − e)        Δω = r·m/J·Δv_x
/// Δx = 2v/g·(v_x/(1 − e) − s·μ·(1 + e)·v·e/((1 − e)²·(1 + e)))
/// ```
///
/// Exact in exact numbers; in floats a few roundings.
pub(super) struct Rest<N> {
    pub(super) time: N,
    pub(super) body: Round<N>,
}

/// Which tail there is, if one can be told: `None` means that the slip stops within finitely many
/// impacts, which must be followed first.
pub(super) fn tail<N: Coordinate>(
    body: &Round<N>,
    slip: &N,
    friction: &N,
    restitution: &N,
) -> Option<Tail<N>> {
    let sign = slip.sign();
    if sign.is_equal() == Some(true) || friction.sign().is_equal() == Some(true) {
        return Some(Tail::Free);
    }
    let forward = match (sign.is_greater(), sign.is_less()) {
        (Some(true), _) => true,
        (_, Some(true)) => false,
        _ => return None,
    };
    let one = N::one();
    let up = &body.motion.vy;
    let velocity = (one.clone() + restitution) * up / (one.clone() - restitution);
    // what all impacts together can take from the slip: W_tt/W_nn times μ·Σp_n/m
    let ratio = one + body.mass.clone() * body.rotational_mobility();
    let most = ratio * friction * velocity;
    let magnitude = if forward { slip.clone() } else { -slip.clone() };
    let lasts = magnitude.compare(&most).is_at_least()?;
    let sign = if forward { N::one() } else { -N::one() };
    lasts.then_some(Tail::Sliding(sign))
}

/// Follows the tail to its end.
pub(super) fn rest<N: Coordinate>(
    body: &Round<N>,
    tail: &Tail<N>,
    gravity: &N,
    friction: &N,
    restitution: &N,
) -> Rest<N> {
    let one = N::one();
    let up = &body.motion.vy;
    let lost = one.clone() - restitution;
    let first_flight = up.double() / gravity;
    let time = first_flight.clone() / &lost;
    let mut after = body.clone();
    after.motion.vy = N::zero();
    let vx = &body.motion.vx;
    let [x, _] = &body.position;
    match tail {
        Tail::Free => after.position[0] = vx.mul_add(&time, x),
        Tail::Sliding(sign) => {
            let step = friction.clone() * sign * (one.clone() + restitution) * up;
            let change = step.clone() / &lost;
            let behind = step * restitution / (lost.square() * (one + restitution));
            let distance = first_flight * (vx.clone() / &lost - behind);
            after.position[0] = x.clone() + distance;
            after.motion.vx = vx.clone() - &change;
            let turn = body.radius.clone() * &body.mass * change / &body.inertia;
            after.motion.omega = body.motion.omega.clone() - turn;
        }
    }
    Rest { time, body: after }
}
