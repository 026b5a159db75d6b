//! When bodies in flight meet.

use crate::coordinate::Coordinate;
use crate::plane::Plane;
use crate::round::Round;
use crate::side::Side;
use crate::world::Wall;

/// The number system cannot tell whether or when two things meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Unknown;

/// The time until a body reaches a wall, if it does. `touching` says that it is there already, and
/// leaves.
pub(super) fn to_wall<N: Coordinate>(
    body: &Round<N>,
    wall: &Wall<N>,
    gravity: &N,
    touching: bool,
) -> Result<Option<N>, Unknown> {
    let [x, y] = &body.position;
    let r = &body.radius;
    let weightless = gravity.sign().is_equal() == Some(true);
    match wall.side {
        Side::Left => straight(x.clone() - &wall.at - r, &body.motion.vx, touching),
        Side::Right => straight(wall.at.clone() - x - r, &-body.motion.vx.clone(), touching),
        Side::Floor if weightless => straight(y.clone() - &wall.at - r, &body.motion.vy, touching),
        Side::Ceiling if weightless => {
            straight(wall.at.clone() - y - r, &-body.motion.vy.clone(), touching)
        }
        Side::Floor if touching => {
            // up and down again; without upward speed the body rests, and there is no next impact
            let up = &body.motion.vy;
            if up.sign().is_equal() == Some(true) {
                return Ok(None);
            }
            Ok(Some(up.double() / gravity))
        }
        Side::Floor => {
            let height = y.clone() - &wall.at - r;
            let up = &body.motion.vy;
            let root = (up.square() + gravity.double() * &height).sqrt().ok_or(Unknown)?;
            Ok(Some(if up.sign().is_less() == Some(true) {
                height.double() / (root - up)
            } else {
                (root + up) / gravity
            }))
        }
        Side::Ceiling if touching => Ok(None),
        Side::Ceiling => {
            let gap = wall.at.clone() - y - r;
            let up = &body.motion.vy;
            if !up.sign().is_greater().ok_or(Unknown)? {
                return Ok(None);
            }
            let square = up.square() - gravity.double() * &gap;
            if square.sign().is_less().ok_or(Unknown)? {
                return Ok(None);
            }
            let root = square.sqrt().ok_or(Unknown)?;
            Ok(Some(gap.double() / (root + up)))
        }
        // these are no sides of a room, or not met in the plane
        Side::Plane(_) | Side::Back | Side::Front => Ok(None),
    }
}

/// The time until a body that leaves a plane at this speed is back, if it comes back.
pub(super) fn again<N: Coordinate>(
    plane: &Plane<N>,
    speed: &N,
    gravity: &N,
) -> Result<Option<N>, Unknown> {
    let parting = [speed.clone(), plane.pull(gravity)];
    Plane::closes(&N::zero(), &parting, true).map_err(|()| Unknown)
}

/// The time until a body reaches a plane, if it does, both given at the time `now`.
pub(super) fn to_plane<N: Coordinate>(
    body: &Round<N>,
    plane: &Plane<N>,
    gravity: &N,
    now: &N,
) -> Result<Option<N>, Unknown> {
    let gap = not_before(plane.gap(body, now));
    let parting = plane.parting(body, gravity);
    Plane::closes(&gap, &parting, false).map_err(|()| Unknown)
}

/// Without acceleration: a gap that closes with −`speed`.
fn straight<N: Coordinate>(gap: N, speed: &N, touching: bool) -> Result<Option<N>, Unknown> {
    if touching || !speed.sign().is_less().ok_or(Unknown)? {
        return Ok(None);
    }
    Ok(Some(not_before(gap) / -speed.clone()))
}

/// Gaps may be negative by rounding, times must not.
fn not_before<N: Coordinate>(gap: N) -> N {
    if gap.sign().is_less() == Some(true) { N::zero() } else { gap }
}

/// The time until two bodies meet, if they do, both given at the same time. Gravity moves both
/// alike, so that their relative motion is uniform: |d + w·t| = `r_1` + `r_2`.
pub(super) fn to_body<N: Coordinate>(a: &Round<N>, b: &Round<N>) -> Result<Option<N>, Unknown> {
    let d = [0, 1].map(|i| a.position[i].clone() - &b.position[i]);
    let w = [a.motion.vx.clone() - &b.motion.vx, a.motion.vy.clone() - &b.motion.vy];
    let dot = |a: &[N; 2], b: &[N; 2]| a[0].clone() * &b[0] + a[1].clone() * &b[1];
    let closing = dot(&d, &w);
    if !closing.sign().is_less().ok_or(Unknown)? {
        return Ok(None);
    }
    let reach = a.radius.clone() + &b.radius;
    let gap = not_before(dot(&d, &d) - reach.square());
    let speed = dot(&w, &w);
    let discriminant = closing.square() - speed * &gap;
    if discriminant.sign().is_less().ok_or(Unknown)? {
        return Ok(None);
    }
    let root = discriminant.sqrt().ok_or(Unknown)?;
    Ok(Some(gap / (root - closing)))
}
