//! The events of a world, in their order.

use kane_impact::NoImpulse;

use super::encounter::{Bounce, Encounter, normal_of, strike};
use super::flight::{Unknown, to_body, to_wall};
use super::rest::{Tail, rest, tail};
use crate::coordinate::Coordinate;
use crate::resolver::Resolver;
use crate::world::{Round, Side, Wall, World};

/// When to stop.
#[derive(Clone, Debug, PartialEq)]
pub enum Until<N> {
    /// After so many impacts.
    Impacts(u64),
    /// At this time; s.
    Duration(N),
    /// When a bouncing ball has come to rest on the floor.
    Rest,
}

impl<N> Until<N> {
    /// The same in another number system.
    pub fn map<M>(&self, to: impl FnOnce(&N) -> M) -> Until<M> {
        match self {
            Self::Impacts(n) => Until::Impacts(*n),
            Self::Duration(time) => Until::Duration(to(time)),
            Self::Rest => Until::Rest,
        }
    }
}

/// How much work a motion may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// The most impacts that are followed one by one.
    pub impacts: u64,
    /// So many impacts of a ball that comes to rest are shown before the rest of them, infinitely
    /// many, is summed up.
    pub shown: u64,
}

impl Default for Budget {
    fn default() -> Self {
        Self { impacts: 100_000, shown: 12 }
    }
}

/// Why a motion ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The impacts asked for have happened.
    Impacts,
    /// The time is over.
    Duration,
    /// The ball rests on the floor, after infinitely many impacts.
    Rest,
    /// Nothing meets any more.
    Quiet,
}

/// The state at the end.
#[derive(Clone, Debug, PartialEq)]
pub struct End<N> {
    /// s
    pub time: N,
    /// Every body at that time.
    pub bodies: Vec<Round<N>>,
    /// Impacts that were followed one by one.
    pub impacts: u64,
    /// Why it ended.
    pub ending: Ending,
}

impl<N> End<N> {
    /// The same with other numbers.
    pub fn map<M>(&self, mut to: impl FnMut(&N) -> M) -> End<M> {
        End {
            time: to(&self.time),
            bodies: self.bodies.iter().map(|body| body.map(&mut to)).collect(),
            impacts: self.impacts,
            ending: self.ending,
        }
    }
}

/// Why a motion could not be followed to its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Stopped {
    /// The law has no answer.
    #[error("impact {impact} at {time} s: {source}")]
    NoImpulse {
        /// Counted from 1.
        impact: u64,
        /// s, rounded
        time: f64,
        /// The law's reason.
        source: NoImpulse,
    },
    /// The number system cannot tell what comes next, or does not hold the time of it.
    #[error("after impact {impact} at {time} s the number system cannot tell what comes next")]
    Undecided {
        /// Counted from 1; 0 is the start.
        impact: u64,
        /// s, rounded
        time: f64,
    },
    /// More impacts than the budget allows.
    #[error(
        "{impacts} impacts happened by {time} s, and the end is not reached; many impacts in a short time are a pile that comes to rest, which is followed for one ball on a floor alone"
    )]
    Budget {
        /// The budget.
        impacts: u64,
        /// s, rounded
        time: f64,
    },
    /// Exact numbers have become too long.
    #[error("after impact {impact} at {time} s the exact numbers are too long to go on with")]
    Long {
        /// Counted from 1.
        impact: u64,
        /// s, rounded
        time: f64,
    },
    /// The ball never rests.
    #[error("without loss, e = 1, a ball never comes to rest; give `impacts` or `duration_s`")]
    NeverRests,
    /// The rest is that of one ball on a floor.
    #[error(
        "`rest` needs one ball, a floor, no other wall, and gravity; give `impacts` or `duration_s`"
    )]
    NotABall,
}

/// Follows a world, event by event, and tells an observer every impact.
///
/// A flight is in closed form, and the next impact is the earliest root of a polynomial of degree two.
/// Each body keeps the state of its own last impact, so that what does not meet is not rounded. A
/// ball that comes to rest is followed to the end of infinitely many impacts in closed form.
///
/// Exact in exact numbers, and enclosing on intervals, as far as they can tell the order of events; in
/// floats heuristic: each impact rounds, and the errors grow as the motion amplifies them.
///
/// # Errors
/// [`Stopped`].
pub fn run<N: Coordinate, R: Resolver<N>>(
    world: &World<N>,
    resolver: &R,
    until: &Until<N>,
    budget: Budget,
    observer: &mut impl FnMut(&Bounce<N>),
) -> Result<End<N>, Stopped> {
    let mut state = State::new(world);
    if matches!(until, Until::Rest) {
        state.can_rest()?;
    }
    for index in 0..world.bodies.len() {
        state.predict(index).map_err(|Unknown| state.undecided())?;
    }
    loop {
        if matches!(until, Until::Impacts(asked) if *asked <= state.impacts) {
            return Ok(state.end(Ending::Impacts));
        }
        let next = state.earliest()?;
        if let Until::Duration(end) = until {
            let over = match &next {
                Some((time, _)) => end.compare(time).is_less().ok_or_else(|| state.undecided())?,
                None => true,
            };
            if over {
                return Ok(state.end_at(end.clone()));
            }
        }
        let Some((time, encounter)) = next else {
            return Ok(state.end(Ending::Quiet));
        };
        if state.impacts == budget.impacts {
            let time = state.now.to_f64();
            return Err(Stopped::Budget { impacts: budget.impacts, time });
        }
        state.impacts += 1;
        let bounce = state.meet(resolver, time, encounter)?;
        observer(&bounce);
        if bounce.time.is_long() || bounce.slip[1].is_long() {
            return Err(Stopped::Long { impact: state.impacts, time: state.now.to_f64() });
        }
        if let Some(end) = state.rests(until, budget, &bounce) {
            return Ok(end);
        }
        state.refresh(encounter).map_err(|Unknown| state.undecided())?;
    }
}

/// Every body at the time of its last impact, and what it meets next.
struct State<'a, N> {
    world: &'a World<N>,
    now: N,
    impacts: u64,
    bodies: Vec<Round<N>>,
    since: Vec<N>,
    /// how many impacts there had been then, its own among them
    settled: Vec<u64>,
    last: Vec<Option<Encounter>>,
    /// the slip after the last impact, where that was with a floor or a ceiling
    held: Vec<Option<N>>,
    next: Vec<Option<(N, Encounter)>>,
}

impl<'a, N: Coordinate> State<'a, N> {
    fn new(world: &'a World<N>) -> Self {
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
            next: vec![None; count],
        }
    }

    fn undecided(&self) -> Stopped {
        Stopped::Undecided { impact: self.impacts, time: self.now.to_f64() }
    }

    fn here(&self, index: usize) -> Round<N> {
        if self.settled[index] == self.impacts {
            // no time has passed, which an interval would not know
            return self.bodies[index].clone();
        }
        let time = self.now.clone() - &self.since[index];
        self.bodies[index].flown(&time, &self.world.gravity)
    }

    /// Looks for what the body meets next, and tells those that it would meet before all else.
    fn predict(&mut self, index: usize) -> Result<(), Unknown> {
        let body = self.here(index);
        let mut best: Option<(N, Encounter)> = None;
        for wall in &self.world.walls {
            let encounter = Encounter::Wall(index, wall.side);
            let touching = self.last[index] == Some(encounter);
            if let Some(time) = to_wall(&body, wall, &self.world.gravity, touching)? {
                let time = self.now.clone() + time;
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

    fn earliest(&self) -> Result<Option<(N, Encounter)>, Stopped> {
        let mut best: Option<&(N, Encounter)> = None;
        for next in self.next.iter().flatten() {
            if earlier((&next.0, next.1), best).map_err(|Unknown| self.undecided())? {
                best = Some(next);
            }
        }
        Ok(best.cloned())
    }

    /// Brings the bodies to their impact and through it.
    fn meet<R: Resolver<N>>(
        &mut self,
        resolver: &R,
        time: N,
        encounter: Encounter,
    ) -> Result<Bounce<N>, Stopped> {
        self.now = time;
        let world = self.world;
        let coefficients = (&world.friction, &world.restitution);
        let fault = |source| Stopped::NoImpulse {
            impact: self.impacts,
            time: self.now.to_f64(),
            source,
        };
        let fallen = |index: usize, body: &Round<N>| {
            let drop = self.bodies[index].position[1].clone() - &body.position[1];
            body.mass.clone() * &world.gravity * drop
        };
        let (struck, gravity) = match encounter {
            Encounter::Wall(index, side) => {
                let mut body = self.here(index);
                if let Some(wall) = world.walls.iter().find(|wall| wall.side == side) {
                    at_wall(&mut body, wall);
                }
                let again = self.last[index] == Some(encounter);
                if again && side == Side::Floor {
                    // what goes up comes down as fast; v − g·(2v/g) would round, and widen
                    body.motion.vy = -self.bodies[index].motion.vy.clone();
                }
                let held = if again { self.held[index].as_ref() } else { None };
                let normal = normal_of(side);
                let struck =
                    strike(resolver, coefficients, &normal, &body, None, held).map_err(fault)?;
                (struck, fallen(index, &body))
            }
            Encounter::Pair(i, j) => {
                let (first, second) = (self.here(i), self.here(j));
                let reach = first.radius.clone() + &second.radius;
                let normal = [0, 1]
                    .map(|k| (first.position[k].clone() - &second.position[k]) / &reach);
                let struck =
                    strike(resolver, coefficients, &normal, &first, Some(&second), None)
                        .map_err(fault)?;
                (struck, fallen(i, &first) + fallen(j, &second))
            }
        };
        let bounce = Bounce {
            time: self.now.clone(),
            encounter,
            regime: struck.regime,
            slip: struck.slip,
            approach: struck.approach,
            separation: struck.separation,
            impulse: struck.impulse,
            ledger: struck.ledger,
            gravity,
            after: (struck.first, struck.second),
        };
        match encounter {
            Encounter::Wall(i, side) => {
                let level = matches!(side, Side::Floor | Side::Ceiling);
                self.held[i] = level.then(|| bounce.slip[1].clone());
                self.settle(i, encounter, bounce.after.0.clone());
            }
            Encounter::Pair(i, j) => {
                self.held[i] = None;
                self.held[j] = None;
                self.settle(i, encounter, bounce.after.0.clone());
                if let Some(second) = &bounce.after.1 {
                    self.settle(j, encounter, second.clone());
                }
            }
        }
        Ok(bounce)
    }

    fn settle(&mut self, index: usize, encounter: Encounter, body: Round<N>) {
        self.bodies[index] = body;
        self.since[index] = self.now.clone();
        self.settled[index] = self.impacts;
        self.last[index] = Some(encounter);
        self.next[index] = None;
    }

    /// Looks again for all whose next impact has changed.
    fn refresh(&mut self, encounter: Encounter) -> Result<(), Unknown> {
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
    fn end(&self, ending: Ending) -> End<N> {
        let bodies = (0..self.bodies.len()).map(|index| self.here(index)).collect();
        End { time: self.now.clone(), bodies, impacts: self.impacts, ending }
    }

    /// The end at a later time.
    fn end_at(&self, time: N) -> End<N> {
        let states = self.bodies.iter().zip(&self.since);
        let flown = states
            .map(|(body, since)| body.flown(&(time.clone() - since), &self.world.gravity))
            .collect();
        End { time, bodies: flown, impacts: self.impacts, ending: Ending::Duration }
    }

    /// Whether this is one ball above a floor.
    fn is_ball(&self) -> bool {
        let floor = matches!(&self.world.walls[..], [Wall { side: Side::Floor, .. }]);
        floor && self.bodies.len() == 1 && self.world.gravity.sign().is_greater() == Some(true)
    }

    fn can_rest(&self) -> Result<(), Stopped> {
        if !self.is_ball() {
            return Err(Stopped::NotABall);
        }
        let loses = self.world.restitution.compare(&N::one()).is_less();
        if loses == Some(false) { Err(Stopped::NeverRests) } else { Ok(()) }
    }

    /// The end, if the ball comes to rest before anything else is asked for.
    fn rests(&self, until: &Until<N>, budget: Budget, bounce: &Bounce<N>) -> Option<End<N>> {
        let World { gravity, friction, restitution, .. } = self.world;
        let body = &bounce.after.0;
        let lies = body.motion.vy.sign().is_equal() == Some(true);
        let asked = match until {
            Until::Impacts(_) => lies,
            Until::Duration(_) | Until::Rest => true,
        };
        if !asked || !(lies || self.impacts >= budget.shown) || self.can_rest().is_err() {
            return None;
        }
        if restitution.compare(&N::one()).is_less() != Some(true) {
            return None;
        }
        let tail = tail(body, &bounce.slip[1], friction, restitution)?;
        let rest = rest(body, &tail, gravity, friction, restitution);
        let time = self.now.clone() + &rest.time;
        let end = |time, body, ending| End {
            time,
            bodies: vec![body],
            impacts: self.impacts,
            ending,
        };
        match until {
            Until::Duration(end_time) => {
                if end_time.compare(&time).is_less() != Some(false) {
                    return None;
                }
                let left = end_time.clone() - time;
                let body = crept(&rest.body, &tail, &left, gravity, friction)?;
                Some(end(end_time.clone(), body, Ending::Duration))
            }
            _ => Some(end(time, rest.body, Ending::Rest)),
        }
    }
}

/// A body that rests on the floor slides on under friction, until it rolls.
fn crept<N: Coordinate>(
    body: &Round<N>,
    tail: &Tail<N>,
    time: &N,
    gravity: &N,
    friction: &N,
) -> Option<Round<N>> {
    let mut after = body.clone();
    let mut left = time.clone();
    if let Tail::Sliding(sign) = tail {
        let slip = body.motion.omega.mul_add(&body.radius, &body.motion.vx);
        let slowing = friction.clone() * gravity * sign;
        let ratio = N::one() + body.mass.clone() * body.rotational_mobility();
        let stop = slip / (slowing.clone() * ratio);
        let slides = if left.compare(&stop).is_less()? { left.clone() } else { stop };
        let change = slowing * &slides;
        let mean = body.motion.vx.clone() - crate::coordinate::half(change.clone());
        after.position[0] = mean.mul_add(&slides, &body.position[0]);
        after.motion.vx = body.motion.vx.clone() - &change;
        let turn = body.radius.clone() * &body.mass * change / &body.inertia;
        after.motion.omega = body.motion.omega.clone() - turn;
        left = left - slides;
    }
    after.position[0] = after.motion.vx.mul_add(&left, &after.position[0]);
    Some(after)
}

/// A body that touches a wall is where the wall is, whatever rounding says.
fn at_wall<N: Coordinate>(body: &mut Round<N>, wall: &Wall<N>) {
    let r = &body.radius;
    match wall.side {
        Side::Left => body.position[0] = wall.at.clone() + r,
        Side::Right => body.position[0] = wall.at.clone() - r,
        Side::Floor => body.position[1] = wall.at.clone() + r,
        Side::Ceiling => body.position[1] = wall.at.clone() - r,
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
