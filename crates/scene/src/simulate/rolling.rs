//! What lies on the floor: it skids, rolls and stops.

use super::rest::{Tail, slow};
use crate::coordinate::{Coordinate, half};
use crate::round::Round;

/// A body that rests on the floor slides on under friction, until it rolls, and rolls on against the
/// resistance until it stops: with q = m·r²/J the slip stops after `v_t`/(μ·g·(1 + q)), and rolling has
/// the deceleration ρ·g·q/(1 + q). `None` if the number system cannot tell which.
pub(super) fn crept<N: Coordinate>(
    body: &Round<N>,
    tail: &Tail<N>,
    time: &N,
    gravity: &N,
    [friction, rolling]: [&N; 2],
) -> Option<Round<N>> {
    let mut after = body.clone();
    let mut left = time.clone();
    let slip = body.motion.omega.mul_add(&body.radius, &body.motion.vx);
    // by what the impacts say: formed anew the slip is not zero in floats and on intervals
    let mut rolls = matches!(tail, Tail::Gripping { .. } | Tail::Rolling);
    if let Tail::Sliding(sign) = tail {
        let slowing = friction.clone() * gravity * sign;
        let ratio = N::one() + body.mass.clone() * body.rotational_mobility();
        let stop = slip / (slowing.clone() * ratio);
        rolls = left.compare(&stop).is_less() == Some(false);
        let slides = if left.compare(&stop).is_less()? { left.clone() } else { stop };
        let change = slowing * &slides;
        let mean = body.motion.vx.clone() - half(change.clone());
        after.position[0] = mean.mul_add(&slides, &body.position[0]);
        slow(&mut after, change);
        left = left - slides;
    }
    if rolls && rolling.sign().is_equal() != Some(true) {
        return rolled(after, &left, gravity, rolling);
    }
    after.position[0] = after.motion.vx.mul_add(&left, &after.position[0]);
    Some(after)
}

/// What rolls, after some time of resistance.
fn rolled<N: Coordinate>(
    mut body: Round<N>,
    time: &N,
    gravity: &N,
    rolling: &N,
) -> Option<Round<N>> {
    let speed = body.motion.vx.clone();
    if speed.sign().is_equal() == Some(true) {
        return Some(body);
    }
    let turning = body.mass.clone() * body.rotational_mobility();
    let slowing = rolling.clone() * gravity * &turning / (N::one() + &turning);
    let forward = speed.sign().is_greater()?;
    let slowing = if forward { slowing } else { -slowing };
    let stop = speed.clone() / &slowing;
    let stops = time.compare(&stop).is_at_least()?;
    let time = if stops { &stop } else { time };
    let change = slowing * time;
    let mean = speed - half(change.clone());
    body.position[0] = mean.mul_add(time, &body.position[0]);
    if stops {
        (body.motion.vx, body.motion.omega) = (N::zero(), N::zero());
    } else {
        body.motion.vx = body.motion.vx - &change;
        body.motion.omega = body.motion.omega + change / &body.radius;
    }
    Some(body)
}
