//! Where all bodies are between two events, and what they meet next.

use super::bounce::{Bounce, normal_of, strike};
use super::ending::{Budget, End, Ending, Stopped, Until};
use super::flight::{Unknown, again, to_body, to_plane, to_wall};
use super::rest::{Tail, rest, tail};
use super::rolling::crept;
use crate::coordinate::Coordinate;
use crate::encounter::Encounter;
use crate::resolver::Resolver;
use crate::round::Round;
use crate::side::Side;
use crate::world::{Wall, World};

/// Every body at the time of its last impact, and what it meets next.
pub(super) struct State<'a, N> {
    world: &'a World<N>,
    pub(super) now: N,
    pub(super) impacts: u64,
    bodies: Vec<Round<N>>,
    since: Vec<N>,
    /// how many impacts there had been then, its own among them
    settled: Vec<u64>,
    last: Vec<Option<Encounter>>,
    /// the slip after the last impact, where that was with a floor or a ceiling
    held: Vec<Option<N>>,
    /// how fast it left the wall of its last impact, where that was a wall
    leaving: Vec<Option<N>>,
    next: Vec<Option<(N, Encounter)>>,
}

impl<'a, N: Coordinate> State<'a, N> {
    pub(super) fn new(world: &'a World<N>) -> Self {
        let count = world.bodies.len();
        Self {
            world,
            now: N::zero(),
            impacts: 0,
            bodies: world.bodies.clone(),
            since: vec![N::zero(); count],
            settled: vec![0; count],
            last: vec![None; count],
            held: vec![None; count],
            leaving: vec![None; count],
            next: vec![None; count],
        }
    }

    pub(super) fn undecided(&self) -> Stopped {
        Stopped::Undecided { impact: self.impacts, time: self.now.to_f64() }
    }

    #[inline]
    fn here(&self, index: usize) -> Round<N> {
        if self.settled[index] == self.impacts {
            // no time has passed, which an interval would not know
            return self.bodies[index].clone();
        }
        let time = self.now.clone() - &self.since[index];
        self.bodies[index].flown(&time, &self.world.gravity)
    }

    /// Looks for what the body meets next, and tells those that it would meet before all else.
    ///
    /// # Errors
    /// [`Stopped::Undecided`], and [`Stopped::Lies`] where nothing but the wall that it has met holds it.
    pub(super) fn predict(&mut self, index: usize) -> Result<(), Stopped> {
        if self.lies(index) {
            return Err(Stopped::Lies { impact: self.impacts, time: self.now.to_f64() });
        }
        self.look(index).map_err(|Unknown| self.undecided())
    }

    /// Whether a body has met a wall, does not leave it, and gravity presses it against it.
    fn lies(&self, index: usize) -> bool {
        let (Some(Encounter::Wall(_, side)), Some(speed)) =
            (self.last[index], &self.leaving[index])
        else {
            return false;
        };
        let [_, up] = normal_of(self.world, side);
        let is = |sign: Option<bool>| sign == Some(true);
        is(speed.sign().is_equal())
            && is(up.sign().is_greater())
            && is(self.world.gravity.sign().is_greater())
    }

    fn look(&mut self, index: usize) -> Result<(), Unknown> {
        let body = self.here(index);
        let mut best: Option<(N, Encounter)> = None;
        for wall in &self.world.walls {
            let encounter = Encounter::Wall(index, wall.side);
            let touching = self.last[index] == Some(encounter);
            // up and down again counts from where it left
            let (from, start) = if touching {
                (&self.bodies[index], &self.since[index])
            } else {
                (&body, &self.now)
            };
            if let Some(time) = to_wall(from, wall, &self.world.gravity, touching)? {
                let time = start.clone() + time;
                if earlier((&time, encounter), best.as_ref())? {
                    best = Some((time, encounter));
                }
            }
        }
        for (plane, number) in self.world.planes.iter().zip(0..) {
            let encounter = Encounter::Wall(index, Side::Plane(number));
            let gravity = &self.world.gravity;
            let (found, start) = match &self.leaving[index] {
                Some(speed) if self.last[index] == Some(encounter) => {
                    (again(plane, speed, gravity)?, &self.since[index])
                }
                _ => (to_plane(&body, plane, gravity, &self.now)?, &self.now),
            };
            if let Some(time) = found {
                let time = start.clone() + time;
                if earlier((&time, encounter), best.as_ref())? {
                    best = Some((time, encounter));
                }
            }
        }
        for other in 0..self.bodies.len() {
            if other == index {
                continue;
            }
            let encounter = Encounter::Pair(index.min(other), index.max(other));
            let parted = Some(encounter);
            if self.last[index] == parted && self.last[other] == parted {
                continue;
            }
            let Some(time) = to_body(&body, &self.here(other))? else { continue };
            let time = self.now.clone() + time;
            if earlier((&time, encounter), best.as_ref())? {
                best = Some((time.clone(), encounter));
            }
            if earlier((&time, encounter), self.next[other].as_ref())? {
                self.next[other] = Some((time, encounter));
            }
        }
        self.next[index] = best;
        Ok(())
    }

    #[inline]
    pub(super) fn earliest(&self) -> Result<Option<(N, Encounter)>, Stopped> {
        let mut best: Option<&(N, Encounter)> = None;
        for next in self.next.iter().flatten() {
            if earlier((&next.0, next.1), best).map_err(|Unknown| self.undecided())? {
                best = Some(next);
            }
        }
        Ok(best.cloned())
    }

    /// Brings the bodies to their impact and through it.
    #[inline]
    pub(super) fn meet(
        &mut self,
        resolver: &dyn Resolver<N>,
        time: N,
        encounter: Encounter,
    ) -> Result<Bounce<N>, Stopped> {
        self.now = time;
        let world = self.world;
        let fault =
            |source| Stopped::NoImpulse { impact: self.impacts, time: self.now.to_f64(), source };
        let fallen = |index: usize, body: &Round<N>| {
            let drop = self.bodies[index].position[1].clone() - &body.position[1];
            body.mass.clone() * &world.gravity * drop
        };
        let (first, second, normal, held) = match encounter {
            Encounter::Wall(index, side) => {
                let mut body = self.here(index);
                if let Some(wall) = world.walls.iter().find(|wall| wall.side == side) {
                    at_wall(&mut body, wall);
                }
                if let Side::Plane(number) = side
                    && let Some(plane) = world.planes.get(usize::from(number))
                {
                    plane.touch(&mut body, &self.now);
                }
                let again = self.last[index] == Some(encounter);
                if again && side == Side::Floor {
                    // what goes up comes down as fast; v − g·(2v/g) would round, and widen
                    body.motion.vy = -self.bodies[index].motion.vy.clone();
                }
                let held = if again { self.held[index].as_ref() } else { None };
                (body, None, normal_of(world, side), held)
            }
            Encounter::Pair(i, j) => {
                let (first, second) = (self.here(i), self.here(j));
                let reach = first.radius.clone() + &second.radius;
                let normal =
                    [0, 1].map(|k| (first.position[k].clone() - &second.position[k]) / &reach);
                (first, Some(second), normal, None)
            }
        };
        let struck = strike(resolver, (world, encounter), &normal, &first, second.as_ref(), held)
            .map_err(fault)?;
        let gravity = match (encounter, &second) {
            (Encounter::Pair(i, j), Some(second)) => fallen(i, &first) + fallen(j, second),
            (Encounter::Wall(i, _) | Encounter::Pair(i, _), _) => fallen(i, &first),
        };
        let bounce = struck.at(self.now.clone(), encounter, gravity);
        match encounter {
            Encounter::Wall(i, side) => {
                let level = matches!(side, Side::Floor | Side::Ceiling);
                self.leaving[i] = Some(bounce.separation.clone());
                self.held[i] = level.then(|| bounce.slip[1].clone());
                self.settle(i, encounter, bounce.after.0.clone());
            }
            Encounter::Pair(i, j) => {
                for index in [i, j] {
                    self.held[index] = None;
                    self.leaving[index] = None;
                }
                self.settle(i, encounter, bounce.after.0.clone());
                if let Some(second) = &bounce.after.1 {
                    self.settle(j, encounter, second.clone());
                }
            }
        }
        Ok(bounce)
    }

    #[inline]
    fn settle(&mut self, index: usize, encounter: Encounter, body: Round<N>) {
        self.bodies[index] = body;
        self.since[index] = self.now.clone();
        self.settled[index] = self.impacts;
        self.last[index] = Some(encounter);
        self.next[index] = None;
    }

    /// Looks again for all whose next impact has changed.
    ///
    /// # Errors
    /// As [`predict`](Self::predict).
    pub(super) fn refresh(&mut self, encounter: Encounter) -> Result<(), Stopped> {
        let (i, j) = match encounter {
            Encounter::Wall(i, _) => (i, i),
            Encounter::Pair(i, j) => (i, j),
        };
        // those that were to meet one of the two must look elsewhere
        for other in 0..self.bodies.len() {
            let waits = matches!(&self.next[other], Some((_, Encounter::Pair(a, b)))
                if [*a, *b].contains(&i) || [*a, *b].contains(&j));
            if waits {
                self.next[other] = None;
                self.predict(other)?;
            }
        }
        self.predict(i)?;
        if j != i {
            self.predict(j)?;
        }
        Ok(())
    }

    /// The end here and now.
    pub(super) fn end(&self, ending: Ending) -> End<N> {
        let bodies = (0..self.bodies.len()).map(|index| self.here(index)).collect();
        End { time: self.now.clone(), bodies, impacts: self.impacts, ending, turned: None }
    }

    /// The end at a later time.
    pub(super) fn end_at(&self, time: N) -> End<N> {
        let states = self.bodies.iter().zip(&self.since);
        let flown = states
            .map(|(body, since)| body.flown(&(time.clone() - since), &self.world.gravity))
            .collect();
        let (impacts, ending) = (self.impacts, Ending::Duration);
        End { time, bodies: flown, impacts, ending, turned: None }
    }

    /// Whether this is one ball above a floor.
    fn is_ball(&self) -> bool {
        let floor = matches!(&self.world.walls[..], [Wall { side: Side::Floor, .. }]);
        floor
            && self.world.planes.is_empty()
            && self.bodies.len() == 1
            && self.world.gravity.sign().is_greater() == Some(true)
    }

    pub(super) fn can_rest(&self) -> Result<(), Stopped> {
        if !self.is_ball() {
            return Err(Stopped::NotABall);
        }
        let restitution = self.world.constant_restitution(ON_THE_FLOOR);
        let loses = restitution.ok_or(Stopped::BySpeed)?.compare(&N::one()).is_less();
        if loses == Some(false) { Err(Stopped::NeverRests) } else { Ok(()) }
    }

    /// The end, if the ball comes to rest before anything else is asked for, and the model tells how.
    ///
    /// # Errors
    /// If the ball lies on the floor and slips, and the model does not tell how that goes on.
    pub(super) fn rests(
        &self,
        resolver: &dyn Resolver<N>,
        until: &Until<N>,
        budget: Budget,
        bounce: &Bounce<N>,
    ) -> Result<Option<End<N>>, Stopped> {
        let (gravity, friction) = (&self.world.gravity, self.world.friction_of(ON_THE_FLOOR));
        let body = &bounce.after.0;
        let lies = body.motion.vy.sign().is_equal() == Some(true);
        let asked = match until {
            Until::Impacts(_) => lies,
            Until::Duration(_) | Until::Rest => true,
        };
        if !asked || !(lies || self.impacts >= budget.shown) || self.can_rest().is_err() {
            return Ok(None);
        }
        let Some(restitution) = self.world.constant_restitution(ON_THE_FLOOR) else {
            return Ok(None);
        };
        if restitution.compare(&N::one()).is_less() != Some(true) {
            return Ok(None);
        }
        let Some(tail) = tail(resolver, body, &bounce.slip[1], friction, restitution) else {
            return match (lies, until) {
                (false, _) => Ok(None),
                (true, Until::Duration(_)) => Err(Stopped::LiesUntold),
                // nothing is left to sum up
                (true, _) => Ok(Some(self.end(Ending::Rest))),
            };
        };
        let rest = rest(body, &tail, gravity, friction, restitution);
        let time = self.now.clone() + &rest.time;
        let end = |time, body, ending| End {
            time,
            bodies: vec![body],
            impacts: self.impacts,
            ending,
            turned: None,
        };
        Ok(match until {
            Until::Duration(end_time) => {
                if end_time.compare(&time).is_less() != Some(false) {
                    return Ok(None);
                }
                if matches!(tail, Tail::Unnoticed) {
                    return Err(Stopped::LiesUntold);
                }
                let left = end_time.clone() - time;
                let rolling = &self.world.rolling;
                let body = crept(&rest.body, &tail, &left, gravity, [friction, rolling]);
                body.map(|body| end(end_time.clone(), body, Ending::Duration))
            }
            _ => Some(end(time, rest.body, Ending::Rest)),
        })
    }
}

/// Where the only ball of a world may come to rest.
const ON_THE_FLOOR: Encounter = Encounter::Wall(0, Side::Floor);

/// A body that touches a wall is where the wall is, whatever rounding says.
fn at_wall<N: Coordinate>(body: &mut Round<N>, wall: &Wall<N>) {
    let r = &body.radius;
    match wall.side {
        Side::Left => body.position[0] = wall.at.clone() + r,
        Side::Right => body.position[0] = wall.at.clone() - r,
        Side::Floor => body.position[1] = wall.at.clone() + r,
        Side::Ceiling => body.position[1] = wall.at.clone() - r,
        Side::Plane(_) | Side::Back | Side::Front => {}
    }
}

/// Whether an encounter comes before the best so far; one that is known from its other body does not.
fn earlier<N: Coordinate>(
    (time, encounter): (&N, Encounter),
    best: Option<&(N, Encounter)>,
) -> Result<bool, Unknown> {
    match best {
        None => Ok(true),
        Some((_, known)) if *known == encounter => Ok(false),
        Some((best, _)) => time.compare(best).is_less().ok_or(Unknown),
    }
}
