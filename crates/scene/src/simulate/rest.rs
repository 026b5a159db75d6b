//! The end of a bouncing ball: infinitely many impacts in a finite time, in closed form.

use kane_impact::{Contact, Delassus};

use crate::coordinate::Coordinate;
use crate::resolver::{Lasting, Resolver};
use crate::round::Round;

/// How the slip goes on through the impacts that are left.
#[derive(Clone, Debug)]
pub(super) enum Tail<N> {
    /// The model has no friction.
    Free,
    /// The slip is zero, and stays so: what lies on the floor rolls.
    Rolling,
    /// What friction is left is too little for the number system to notice. How the ball slides on
    /// when it lies on the floor, the model does not tell.
    Unnoticed,
    /// Friction acts in full against the slip, by its sign, at every impact.
    Sliding(N),
    /// Every impact turns the slip u into −β₀·u.
    Gripping {
        /// u
        slip: N,
        /// β₀ ≤ e
        share: N,
        /// `W_tt`/`W_nn`
        ratio: N,
    },
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
/// If each impact gives the share β₀ < 1 of the slip u back, `v_x` + ((−β₀)ⁿ − 1)·u·`W_nn`/`W_tt` is the
/// velocity after n of them, and
///
/// ```text
/// Δv_x = −u·W_nn/W_tt        Δω = r·m/J·Δv_x
/// Δx = 2v/g·((v_x − u·W_nn/W_tt)/(1 − e) + u·W_nn/W_tt/(1 + β₀·e))
/// ```
///
/// Exact in exact numbers; in floats a few roundings.
pub(super) struct Rest<N> {
    pub(super) time: N,
    pub(super) body: Round<N>,
}

/// The next impact of a ball that has just left the floor with this slip.
fn next<N: Coordinate>(body: &Round<N>, slip: &N, friction: &N, restitution: &N) -> Contact<N> {
    let nn = N::one() / &body.mass;
    let delassus = Delassus::unchecked(nn.clone() + body.rotational_mobility(), N::zero(), nn);
    let approach = body.motion.vy.clone();
    Contact::unchecked(slip.clone(), approach, delassus, friction.clone(), restitution.clone())
}

/// Which tail the model has, if one can be told: `None` means that impacts have to be followed one by
/// one for now.
///
/// α falls from impact to impact where the slip is never stopped: with d·eⁿ for what the nth takes of it
/// and `u_∞` ≥ 0 for what is left of it in the end, α = d·eⁿ/(2·(`u_∞` + d·eⁿ/(1 − e))). Where shares of the
/// slip come back it grows by e/β₀. So the first α decides for all.
pub(super) fn tail<N: Coordinate>(
    resolver: &dyn Resolver<N>,
    body: &Round<N>,
    slip: &N,
    friction: &N,
    restitution: &N,
) -> Option<Tail<N>> {
    let next = next(body, slip, friction, restitution);
    let lasting = resolver.lasting(&next);
    let sign = slip.sign();
    let none = sign.is_equal() == Some(true);
    if none {
        return Some(Tail::Rolling);
    }
    if matches!(lasting, Lasting::Without) {
        return Some(Tail::Free);
    }
    let forward = match (sign.is_greater(), sign.is_less()) {
        (Some(true), _) => true,
        (_, Some(true)) => false,
        _ => return None,
    };
    let one = N::one();
    let ratio = next.delassus().tt().clone() / next.delassus().nn();
    // what the next impact takes from the slip, sliding, and what all of them do
    let first = ratio.clone() * friction * (one.clone() + restitution) * next.approach();
    let most = first.clone() / (one.clone() - restitution);
    let magnitude = if forward { slip.clone() } else { -slip.clone() };
    if matches!(lasting, Lasting::Unsummed) {
        // friction is at most full; where all of it is lost in rounding, there is none
        let unmoved = (magnitude.clone() - &most).compare(&magnitude).is_equal();
        return (unmoved == Some(true)).then_some(Tail::Unnoticed);
    }
    let slides = match &lasting {
        // α = first/(2·magnitude)
        Lasting::Full { up_to } => {
            first.compare(&(up_to.double() * &magnitude)).is_at_most()?
                && magnitude.compare(&most).is_at_least()?
        }
        Lasting::Share(_) => magnitude.compare(&most).is_at_least()?,
        Lasting::Without | Lasting::Unsummed => false,
    };
    if slides {
        return Some(Tail::Sliding(if forward { one } else { -one }));
    }
    let Lasting::Share(share) = lasting else { return None };
    let grips = first.compare(&((one + &share) * magnitude)).is_at_least()?;
    let lasts = share.compare(restitution).is_at_most()?;
    (grips && lasts).then(|| Tail::Gripping { slip: slip.clone(), share, ratio })
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
        Tail::Free | Tail::Rolling | Tail::Unnoticed => after.position[0] = vx.mul_add(&time, x),
        Tail::Sliding(sign) => {
            let step = friction.clone() * sign * (one.clone() + restitution) * up;
            let change = step.clone() / &lost;
            let behind = step * restitution / (lost.square() * (one + restitution));
            let distance = first_flight * (vx.clone() / &lost - behind);
            after.position[0] = x.clone() + distance;
            slow(&mut after, change);
        }
        Tail::Gripping { slip, share, ratio } => {
            let change = slip.clone() / ratio;
            let swings = change.clone() / share.mul_add(restitution, &one);
            let distance = first_flight * ((vx.clone() - &change) / &lost + swings);
            after.position[0] = x.clone() + distance;
            slow(&mut after, change);
        }
    }
    Rest { time, body: after }
}

/// Takes this from `v_x`, by friction, which turns the body too.
pub(super) fn slow<N: Coordinate>(body: &mut Round<N>, by: N) {
    body.motion.vx = body.motion.vx.clone() - &by;
    let turn = body.radius.clone() * &body.mass * by / &body.inertia;
    body.motion.omega = body.motion.omega.clone() - turn;
}
