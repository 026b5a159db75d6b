//! A body with corners: it flies, turns, and strikes walls with its corners.

use kane_impact::bodies::{Ledger, Motion, PlanarBody};
use kane_impact::{Contact, Impulse};
use kane_number::System;

use super::bounce::{Bounce, turned as components, turned_back};
use super::corner_path::{CornerPath, Untold};
use super::ending::{Budget, End, Ending, Stopped, Until};
use crate::coordinate::{Coordinate, half};
use crate::corners::Corners;
use crate::encounter::Encounter;
use crate::plane::Plane;
use crate::resolver::Resolver;
use crate::rotation::{turn, turned};
use crate::round::Round;
use crate::side::Side;
use crate::world::World;

/// Impacts of two corners so near to each other count as one at two places.
const TOGETHER: f64 = 1e-11;

/// The body at the time of its last impact.
struct Tumbling<'a, N> {
    world: &'a World<N>,
    corners: &'a Corners<N>,
    walls: Vec<(Side, Plane<N>)>,
    body: Round<N>,
    since: N,
    /// by which it has turned since the start
    angle: N,
    /// the corner and the wall of the last impact, and how fast they parted
    left: Option<(usize, usize, N)>,
    impacts: u64,
}

/// A corner meets a wall, both by index, at a time after the last impact.
struct Next<N> {
    time: N,
    corner: usize,
    wall: usize,
}

/// What a wall sees of the centre at the last impact: its height, its speed outwards, and the pull.
struct Centre<N> {
    height: N,
    speed: N,
    pull: N,
}

fn dot<N: Coordinate>(a: &[N; 2], b: &[N; 2]) -> N {
    a[0].clone() * &b[0] + a[1].clone() * &b[1]
}

impl<'a, N: Coordinate> Tumbling<'a, N> {
    fn new(world: &'a World<N>, corners: &'a Corners<N>) -> Self {
        Self {
            world,
            corners,
            walls: world.as_planes(),
            body: world.bodies[0].clone(),
            since: N::zero(),
            angle: N::zero(),
            left: None,
            impacts: 0,
        }
    }

    fn undecided(&self) -> Stopped {
        Stopped::Undecided { impact: self.impacts, time: self.since.to_f64() }
    }

    /// The arm of a corner after a turn since the start; `None` where the number system does not turn.
    fn arm(&self, corner: usize, angle: &N) -> Option<[N; 2]> {
        Some(turned(&self.corners.0[corner], &turn(angle)?))
    }

    fn centre(&self, wall: usize) -> Centre<N> {
        let (_, plane) = &self.walls[wall];
        let Motion { vx, vy, .. } = &self.body.motion;
        let from = [0, 1].map(|k| self.body.position[k].clone() - &plane.through[k]);
        Centre {
            height: dot(&from, &plane.normal) - self.since.clone() * &plane.velocity[1],
            speed: dot(&[vx.clone(), vy.clone()], &plane.normal) - &plane.velocity[1],
            pull: plane.pull(&self.world.gravity),
        }
    }

    fn path(&self, corner: usize, wall: usize, centre: &Centre<N>) -> Option<CornerPath<N>> {
        let normal = &self.walls[wall].1.normal;
        let leaves = matches!(&self.left, Some((c, w, _)) if (*c, *w) == (corner, wall));
        let (arm, angle) = if leaves {
            (self.arm(corner, &self.angle)?, N::zero())
        } else {
            (self.corners.0[corner].clone(), self.angle.clone())
        };
        let out = dot(&arm, normal);
        let along = dot(&[-arm[1].clone(), arm[0].clone()], normal);
        Some(CornerPath {
            gap: if leaves { N::zero() } else { centre.height.clone() + &out },
            speed: centre.speed.clone(),
            pull: centre.pull.clone(),
            angle,
            omega: self.body.motion.omega.clone(),
            out,
            along,
            leaves,
        })
    }

    /// By then the centre is through the wall, or no corner reaches it any more; `None` if none ever does.
    fn horizon(&self, centre: &Centre<N>) -> Option<f64> {
        let reach = self.corners.0.iter().map(|arm| dot(arm, arm).enclosed().upper().sqrt());
        let reach = reach.fold(0.0, f64::max) * (1.0 + 1e-12);
        let (h, w) = (centre.height.enclosed(), centre.speed.enclosed());
        let longer = |time: f64| time.mul_add(1.01, 1e-9);
        let pull = centre.pull.enclosed();
        if pull.upper() < 0.0 {
            let [h, w, a] = [h.upper().max(0.0), w.upper(), -pull.upper()];
            return Some(longer((w + (w * w + 2.0 * a * h).sqrt()) / a));
        }
        let beyond = h.lower() - reach;
        if pull.lower() > 0.0 {
            // when the centre is out of reach for good
            let [w, a] = [w.lower(), pull.lower()];
            let square = w * w - 2.0 * a * beyond + 1e-12 * (w * w + 2.0 * a * beyond.abs());
            let last = (square >= 0.0).then(|| (square.sqrt() - w) / a)?;
            return (last >= 0.0).then(|| longer(last));
        }
        if w.upper() < 0.0 {
            return Some(longer(h.upper().max(0.0) / -w.upper()));
        }
        if w.lower() > 0.0 {
            return (beyond <= 0.0).then(|| longer(-beyond / w.lower()));
        }
        if w.is_point() && beyond > 0.0 {
            return None;
        }
        let turning = self.body.motion.omega.enclosed();
        let slowest = turning.lower().max(-turning.upper());
        match (w.is_point(), slowest > 0.0) {
            // a whole turn shows all
            (true, true) => Some(longer(7.0 / slowest)),
            (true, false) if turning.is_point() => None,
            _ => Some(f64::INFINITY),
        }
    }

    /// What comes next.
    fn next(&self) -> Result<Option<Next<N>>, Stopped> {
        if let Some((_, _, parted)) = &self.left
            && parted.sign().is_greater() != Some(true)
        {
            let time = self.since.to_f64();
            return Err(match parted.sign().is_equal() {
                Some(true) => Stopped::Lies { impact: self.impacts, time },
                _ => self.undecided(),
            });
        }
        let told = |Untold| self.undecided();
        let mut best: Option<Next<N>> = None;
        let mut all = Vec::new();
        let centres: Vec<Centre<N>> = (0..self.walls.len()).map(|wall| self.centre(wall)).collect();
        for (wall, centre) in centres.iter().enumerate() {
            for corner in 0..self.corners.0.len() {
                let path = self.path(corner, wall, centre).ok_or_else(|| self.undecided())?;
                all.push((corner, wall, path));
            }
        }
        // what touches and comes nearer, meets now; exact numbers need no more than that
        let now = |path: &CornerPath<N>| {
            let [height, speed] = path.at(&N::zero())?;
            let meets = !path.leaves && height.sign().is_equal() == Some(true);
            Some(meets && speed.sign().is_less() == Some(true))
        };
        let mut at_once = all.iter().filter(|(.., path)| now(path) == Some(true));
        if let Some((corner, wall, _)) = at_once.next() {
            return match at_once.next() {
                None => Ok(Some(Next { time: N::zero(), corner: *corner, wall: *wall })),
                Some(_) => Err(self.flat(&N::zero())),
            };
        }
        let horizons: Vec<Option<f64>> =
            centres.iter().map(|centre| self.horizon(centre)).collect();
        for (corner, wall, path) in all {
            let Some(horizon) = horizons[wall] else { continue };
            let known = best.as_ref().map_or(f64::INFINITY, |best| best.time.enclosed().upper());
            let Some(time) = path.comes_down(horizon.min(known * 1.01 + 1e-9)).map_err(told)?
            else {
                continue;
            };
            let Some(other) = &best else {
                best = Some(Next { time, corner, wall });
                continue;
            };
            if N::SYSTEM != System::Interval {
                let (a, b) = (time.to_f64(), other.time.to_f64());
                if (a - b).abs() <= TOGETHER * (1.0 + self.since.to_f64() + a) {
                    return Err(self.flat(&time));
                }
            }
            if time.compare(&other.time).is_less().ok_or_else(|| self.undecided())? {
                best = Some(Next { time, corner, wall });
            }
        }
        Ok(best)
    }

    fn flat(&self, time: &N) -> Stopped {
        let time = (self.since.clone() + time).to_f64();
        Stopped::Flat { impact: self.impacts + 1, time }
    }

    fn flown(&self, time: &N) -> (Round<N>, N) {
        let body = self.body.flown(time, &self.world.gravity);
        (body, self.body.motion.omega.mul_add(time, &self.angle))
    }

    /// Brings the body to its impact and through it.
    fn meet(&mut self, resolver: &dyn Resolver<N>, next: &Next<N>) -> Result<Bounce<N>, Stopped> {
        let (side, plane) = &self.walls[next.wall];
        let encounter = Encounter::Wall(0, *side);
        let (body, angle) = self.flown(&next.time);
        let now = self.since.clone() + &next.time;
        let fault =
            |source| Stopped::NoImpulse { impact: self.impacts + 1, time: now.to_f64(), source };
        let arm = self.arm(next.corner, &angle).ok_or_else(|| self.undecided())?;
        let Motion { vx, vy, omega } = &body.motion;
        // in the frame of the wall, along its tangent and its normal
        let [t, n] = components([vx, vy], &plane.normal);
        let [along, out] = &plane.velocity;
        let tip = PlanarBody {
            mass: body.mass.clone(),
            inertia: body.inertia.clone(),
            arm: components([&arm[0], &arm[1]], &plane.normal),
            before: Motion { vx: t.clone() - along, vy: n.clone() - out, omega: omega.clone() },
        };
        let [slip, separation] = tip.velocity();
        let approach = -separation;
        let world = self.world;
        let e = world.restitution_of(encounter, &approach).map_err(fault)?;
        let stays = e.sign().is_equal() == Some(true);
        let friction = world.friction_of(encounter).clone();
        let contact = Contact::unchecked(slip.clone(), approach, tip.delassus(), friction, e);
        let outcome = resolver.resolve(&contact).map_err(fault)?;
        let Impulse { tangential, normal } = &outcome.impulse;
        let after = tip.after(&outcome.impulse);
        let mean = |a: &N, b: &N| half(a.clone() + b);
        let velocity = [after.vx.clone() + along, after.vy.clone() + out];
        let torque = tip.arm[0].clone() * normal - tip.arm[1].clone() * tangential;
        let ledger = Ledger {
            normal: mean(&n, &velocity[1]) * normal,
            tangential: mean(&t, &velocity[0]) * tangential,
            rotational: mean(omega, &after.omega) * torque,
        };
        let [vx, vy] = turned_back(velocity, &plane.normal);
        let fallen = self.body.position[1].clone() - &body.position[1];
        let gravity = body.mass.clone() * &world.gravity * fallen;
        let struck = Round { motion: Motion { vx, vy, omega: after.omega }, ..body };
        // without restitution it parts with nothing, whatever rounding says
        let parted = if stays { N::zero() } else { outcome.separation.clone() };
        self.left = Some((next.corner, next.wall, parted));
        (self.body, self.since, self.angle) = (struck.clone(), now.clone(), angle.clone());
        self.impacts += 1;
        Ok(Bounce {
            time: now,
            encounter,
            regime: outcome.regime,
            slip: [slip, outcome.slip],
            approach: contact.approach().clone(),
            separation: outcome.separation,
            impulse: outcome.impulse,
            ledger,
            gravity,
            air: None,
            axes: None,
            corner: Some((next.corner, angle)),
            after: (struck, None),
        })
    }

    fn end(&self, ending: Ending) -> End<N> {
        End {
            time: self.since.clone(),
            bodies: vec![self.body.clone()],
            impacts: self.impacts,
            ending,
            turned: Some(self.angle.clone()),
        }
    }
}

/// Follows a body with corners from impact to impact.
///
/// A flight is in closed form, and the next impact is the earliest at which a corner comes down on a wall,
/// as [`CornerPath`] finds it. Encloses on intervals; in exact numbers only what touches a wall at the start
/// has an answer, since other turns have no exact sine; in floats heuristic.
///
/// # Errors
/// [`Stopped`]; [`Stopped::Flat`] if two corners arrive at once, [`Stopped::Lies`] if one stays.
pub(crate) fn run_tumbling<N: Coordinate>(
    world: &World<N>,
    corners: &Corners<N>,
    resolver: &dyn Resolver<N>,
    until: &Until<N>,
    budget: Budget,
    observer: &mut dyn FnMut(&Bounce<N>),
) -> Result<End<N>, Stopped> {
    let mut tumbling = Tumbling::new(world, corners);
    loop {
        match until {
            Until::Rest => return Err(Stopped::NotABall),
            Until::Impacts(asked) if *asked <= tumbling.impacts => {
                return Ok(tumbling.end(Ending::Impacts));
            }
            _ => {}
        }
        let next = tumbling.next()?;
        if let Until::Duration(end) = until {
            let left = end.clone() - &tumbling.since;
            let over = match &next {
                Some(next) => {
                    left.compare(&next.time).is_less().ok_or_else(|| tumbling.undecided())?
                }
                None => true,
            };
            if over {
                let (body, angle) = tumbling.flown(&left);
                return Ok(End {
                    time: end.clone(),
                    bodies: vec![body],
                    turned: Some(angle),
                    ..tumbling.end(Ending::Duration)
                });
            }
        }
        let Some(next) = next else { return Ok(tumbling.end(Ending::Quiet)) };
        if tumbling.impacts == budget.impacts {
            let time = tumbling.since.to_f64();
            return Err(Stopped::Budget { impacts: budget.impacts, time });
        }
        observer(&tumbling.meet(resolver, &next)?);
    }
}
