//! Spheres in space: they fly, meet walls and each other, one contact at a time.

use kane_number::System;

use super::bounce::Bounce;
use super::ending::{Budget, End, Ending, Stopped, Until};
use super::flight::Unknown;
use super::space_contact::{StruckInSpace, Touch, strike_in_space};
use crate::coordinate::Coordinate;
use crate::encounter::Encounter;
use crate::plane::Plane;
use crate::resolver::Resolver;
use crate::round::Round;
use crate::side::Side;
use crate::vector::{Vector, dot, minus, over, plus, square, times};
use crate::world::World;

/// In floats, impacts of a sphere so near to each other count as several contacts at once.
const TOGETHER: f64 = 1e-11;

/// A wall in space.
struct Face<N> {
    side: Side,
    /// of length 1, into the room
    normal: Vector<N>,
    /// a point of it at the start
    through: Vector<N>,
    velocity: Vector<N>,
}

impl<N: Coordinate> Face<N> {
    /// All walls of a world: those at an angle stand upright on the plane of x and y.
    fn all(world: &World<N>) -> Vec<Self> {
        let zero = N::zero;
        let of_side = |side: Side, at: &N| {
            let (axis, inwards) = match side {
                Side::Left => (0, N::one()),
                Side::Right => (0, -N::one()),
                Side::Floor | Side::Plane(_) => (1, N::one()),
                Side::Ceiling => (1, -N::one()),
                Side::Back => (2, N::one()),
                Side::Front => (2, -N::one()),
            };
            let along = |value: &N| {
                let mut vector = [zero(), zero(), zero()];
                vector[axis] = value.clone();
                vector
            };
            let velocity = [zero(), zero(), zero()];
            Self { side, normal: along(&inwards), through: along(at), velocity }
        };
        let at_angle = |(plane, number): (&Plane<N>, u8)| {
            let Plane { normal: [nx, ny], through: [x, y], velocity: [along, out] } = plane;
            let velocity = [
                along.clone() * ny + out.clone() * nx,
                out.clone() * ny - along.clone() * nx,
                zero(),
            ];
            Self {
                side: Side::Plane(number),
                normal: [nx.clone(), ny.clone(), zero()],
                through: [x.clone(), y.clone(), zero()],
                velocity,
            }
        };
        let of_room = world.walls.iter().map(|wall| of_side(wall.side, &wall.at));
        of_room.chain(world.planes.iter().zip(0..).map(at_angle)).collect()
    }

    /// How far a sphere is from the wall at a time.
    fn gap(&self, body: &Round<N>, time: &N) -> N {
        let from = minus(&body.place(), &plus(&self.through, &times(time, &self.velocity)));
        dot(&from, &self.normal) - &body.radius
    }

    /// The speed at which the gap grows, and its acceleration.
    fn parting(&self, body: &Round<N>, gravity: &N) -> [N; 2] {
        [dot(&minus(&body.velocity(), &self.velocity), &self.normal), self.pull(gravity)]
    }

    fn pull(&self, gravity: &N) -> N {
        -(gravity.clone() * &self.normal[1])
    }
}

/// The last impact of a sphere.
struct Left<N> {
    encounter: Encounter,
    /// how fast it left, and the slip afterwards
    speed: N,
    slip: Vector<N>,
}

/// All spheres, each at the time of its last impact.
struct Space<'a, N> {
    world: &'a World<N>,
    faces: Vec<Face<N>>,
    now: N,
    impacts: u64,
    bodies: Vec<Round<N>>,
    since: Vec<N>,
    /// how many impacts there had been then, its own among them
    settled: Vec<u64>,
    left: Vec<Option<Left<N>>>,
    /// when those meet that will, if nothing comes between
    ahead: Vec<(Encounter, Option<N>)>,
}

fn involves(encounter: Encounter, index: usize) -> bool {
    match encounter {
        Encounter::Wall(i, _) => i == index,
        Encounter::Pair(i, j) => i == index || j == index,
    }
}

impl<'a, N: Coordinate> Space<'a, N> {
    fn new(world: &'a World<N>) -> Self {
        let (faces, count) = (Face::all(world), world.bodies.len());
        let mut ahead = Vec::new();
        for i in 0..count {
            ahead.extend(faces.iter().map(|face| (Encounter::Wall(i, face.side), None)));
            ahead.extend((i + 1..count).map(|j| (Encounter::Pair(i, j), None)));
        }
        Self {
            world,
            faces,
            now: N::zero(),
            impacts: 0,
            bodies: world.bodies.clone(),
            since: vec![N::zero(); count],
            settled: vec![0; count],
            left: std::iter::repeat_with(|| None).take(count).collect(),
            ahead,
        }
    }

    fn undecided(&self) -> Stopped {
        Stopped::Undecided { impact: self.impacts, time: self.now.to_f64() }
    }

    /// A sphere at a time after its last impact.
    fn at(&self, index: usize, time: &N) -> Round<N> {
        self.bodies[index].flown(&(time.clone() - &self.since[index]), &self.world.gravity)
    }

    /// A sphere at the time of the last impact of all.
    fn here(&self, index: usize) -> Round<N> {
        if self.settled[index] == self.impacts {
            // it has not flown, which an interval would not know
            return self.bodies[index].clone();
        }
        self.at(index, &self.now)
    }

    fn last(&self, index: usize) -> Option<Encounter> {
        self.left[index].as_ref().map(|left| left.encounter)
    }

    fn face(&self, side: Side) -> Option<&Face<N>> {
        self.faces.iter().find(|face| face.side == side)
    }

    /// When two meet, if they do.
    fn meeting(&self, encounter: Encounter) -> Result<Option<N>, Unknown> {
        let gravity = &self.world.gravity;
        match encounter {
            Encounter::Wall(i, side) => {
                let Some(face) = self.face(side) else { return Ok(None) };
                let (found, from) = match &self.left[i] {
                    Some(left) if left.encounter == encounter => {
                        let parting = [left.speed.clone(), face.pull(gravity)];
                        (Plane::closes(&N::zero(), &parting, true), &self.since[i])
                    }
                    _ => {
                        let body = self.here(i);
                        let gap = not_below_zero(face.gap(&body, &self.now));
                        let parting = face.parting(&body, gravity);
                        (Plane::closes(&gap, &parting, false), &self.now)
                    }
                };
                Ok(found.map_err(|()| Unknown)?.map(|time| from.clone() + time))
            }
            Encounter::Pair(i, j) => {
                if [i, j].iter().all(|k| self.last(*k) == Some(encounter)) {
                    return Ok(None);
                }
                let found = closing(&self.here(i), &self.here(j))?;
                Ok(found.map(|time| self.now.clone() + time))
            }
        }
    }

    /// Looks again for all that these may meet.
    fn look(&mut self, bodies: &[usize]) -> Result<(), Unknown> {
        let mut ahead = std::mem::take(&mut self.ahead);
        for (encounter, time) in &mut ahead {
            if bodies.iter().any(|index| involves(*encounter, *index)) {
                *time = self.meeting(*encounter)?;
            }
        }
        self.ahead = ahead;
        Ok(())
    }

    fn earliest(&self) -> Result<Option<(N, Encounter)>, Stopped> {
        let mut best: Option<(&N, Encounter)> = None;
        for (encounter, time) in &self.ahead {
            let Some(time) = time else { continue };
            let earlier = match best {
                None => true,
                Some((known, _)) => {
                    time.compare(known).is_less().ok_or_else(|| self.undecided())?
                }
            };
            if earlier {
                best = Some((time, *encounter));
            }
        }
        Ok(best.map(|(time, encounter)| (time.clone(), encounter)))
    }

    /// Whether one time is certainly after another, by more than floats may be off.
    fn is_later(&self, time: &N, than: &N) -> bool {
        if matches!(N::SYSTEM, System::Interval | System::Rational) {
            return time.compare(than).is_greater() == Some(true);
        }
        let (time, than) = (time.to_f64(), than.to_f64());
        time - than > TOGETHER * (1.0 + time)
    }

    /// Whether the contact of an impact has company at one of its spheres, and any of them friction: one that
    /// is due at the same time, or that has just been.
    fn has_company(&self, time: &N, encounter: Encounter) -> bool {
        let rough = |encounter| self.world.friction_of(encounter).sign().is_equal() != Some(true);
        let of = |other: Encounter, at: &N, index: usize| {
            let both = involves(encounter, index) && involves(other, index);
            let together = !self.is_later(time, at) && !self.is_later(at, time);
            both && other != encounter && together && (rough(encounter) || rough(other))
        };
        (0..self.bodies.len()).any(|index| {
            let before = self.last(index).is_some_and(|last| of(last, &self.since[index], index));
            let due = |(other, at): &(Encounter, Option<N>)| {
                at.as_ref().is_some_and(|at| of(*other, at, index))
            };
            before || self.ahead.iter().any(due)
        })
    }

    /// Brings two through their impact.
    fn meet(
        &mut self,
        resolver: &dyn Resolver<N>,
        time: N,
        encounter: Encounter,
    ) -> Result<Bounce<N>, Stopped> {
        let (impact, at) = (self.impacts + 1, time.to_f64());
        if self.has_company(&time, encounter) {
            return Err(match N::SYSTEM {
                System::Interval => self.undecided(),
                _ => Stopped::AtOnce { impact, time: at },
            });
        }
        let indices = match encounter {
            Encounter::Wall(i, _) => vec![i],
            Encounter::Pair(i, j) => vec![i, j],
        };
        let mut arrived: Vec<Round<N>> = indices.iter().map(|i| self.at(*i, &time)).collect();
        let again = self.last(indices[0]) == Some(encounter);
        let before = self.left[indices[0]].as_ref().filter(|_| again);
        let touch = match encounter {
            Encounter::Wall(i, side) => {
                let face = self.face(side).ok_or_else(|| self.undecided())?;
                let body = &mut arrived[0];
                let gap = face.gap(body, &time);
                let place = minus(&body.place(), &times(&gap, &face.normal));
                let mut velocity = body.velocity();
                if again && side == Side::Floor {
                    // what goes up comes down as fast
                    velocity[1] = -self.bodies[i].motion.vy.clone();
                }
                *body = body.moved(place, velocity, body.spin());
                let level = matches!(side, Side::Floor | Side::Ceiling);
                let held = before.filter(|_| level).map(|left| &left.slip);
                let (normal, velocity) = (face.normal.clone(), Some(&face.velocity));
                Touch { encounter, normal, velocity, held }
            }
            Encounter::Pair(..) => {
                let [a, b] = [&arrived[0], &arrived[1]];
                let reach = a.radius.clone() + &b.radius;
                let normal = over(&minus(&a.place(), &b.place()), &reach);
                Touch { encounter, normal, velocity: None, held: None }
            }
        };
        let struck = strike_in_space(resolver, self.world, &touch, &arrived[0], arrived.get(1));
        let fault = |source| Stopped::NoImpulse { impact, time: at, source };
        let StruckInSpace { struck, tangent } = struck.map_err(fault)?;
        let fallen = |(index, body): (&usize, &Round<N>)| {
            let drop = self.bodies[*index].position[1].clone() - &body.position[1];
            body.mass.clone() * &self.world.gravity * drop
        };
        let gravity = indices.iter().zip(&arrived).map(fallen).fold(N::zero(), |a, b| a + b);
        let slip = times(&struck.slip[1], &tangent);
        let axes = Some([tangent, touch.normal]);
        let bounce = Bounce { axes, ..struck.at(time.clone(), encounter, gravity) };
        let after = std::iter::once(&bounce.after.0).chain(&bounce.after.1);
        for (index, body) in indices.iter().zip(after) {
            self.bodies[*index] = body.clone();
            self.since[*index] = time.clone();
            self.settled[*index] = impact;
            let (speed, slip) = (bounce.separation.clone(), slip.clone());
            self.left[*index] = Some(Left { encounter, speed, slip });
        }
        (self.now, self.impacts) = (time, impact);
        Ok(bounce)
    }

    /// Whether a sphere has met a wall, does not leave it, and gravity presses it against it.
    fn lies(&self, index: usize) -> bool {
        let Some(Left { encounter: Encounter::Wall(_, side), speed, .. }) = &self.left[index]
        else {
            return false;
        };
        let pull = self.face(*side).map(|face| face.pull(&self.world.gravity));
        let is = |sign: Option<bool>| sign == Some(true);
        is(speed.sign().is_equal()) && pull.is_some_and(|pull| is(pull.sign().is_less()))
    }

    /// The end here and now.
    fn end(&self, ending: Ending) -> End<N> {
        let bodies = (0..self.bodies.len()).map(|index| self.here(index)).collect();
        End { time: self.now.clone(), bodies, impacts: self.impacts, ending, turned: None }
    }

    /// The end at a later time.
    fn end_at(&self, time: N) -> End<N> {
        let bodies = (0..self.bodies.len()).map(|index| self.at(index, &time)).collect();
        End { time, bodies, impacts: self.impacts, ending: Ending::Duration, turned: None }
    }
}

/// Gaps may be negative by rounding, times must not.
fn not_below_zero<N: Coordinate>(gap: N) -> N {
    if gap.sign().is_less() == Some(true) { N::zero() } else { gap }
}

/// The time until two spheres meet, if they do: |d + w·t| = `r_1` + `r_2`, since gravity moves both alike.
fn closing<N: Coordinate>(a: &Round<N>, b: &Round<N>) -> Result<Option<N>, Unknown> {
    let d = minus(&a.place(), &b.place());
    let w = minus(&a.velocity(), &b.velocity());
    let closing = dot(&d, &w);
    if !closing.sign().is_less().ok_or(Unknown)? {
        return Ok(None);
    }
    let gap = not_below_zero(square(&d) - (a.radius.clone() + &b.radius).square());
    let discriminant = closing.square() - square(&w) * &gap;
    if discriminant.sign().is_less().ok_or(Unknown)? {
        return Ok(None);
    }
    let root = discriminant.sqrt().ok_or(Unknown)?;
    Ok(Some(gap / (root - closing)))
}

/// Follows spheres in space from impact to impact, as [`run`](super::run) does those in a plane.
///
/// # Errors
/// [`Stopped`]; [`Stopped::AtOnce`] where a sphere has several contacts at once with friction,
/// [`Stopped::Lies`] where one stays on a wall.
pub(super) fn run_in_space<N: Coordinate>(
    world: &World<N>,
    resolver: &dyn Resolver<N>,
    until: &Until<N>,
    budget: Budget,
    observer: &mut dyn FnMut(&Bounce<N>),
) -> Result<End<N>, Stopped> {
    if matches!(until, Until::Rest) {
        return Err(Stopped::RestInSpace);
    }
    let mut space = Space::new(world);
    let mut moved: Vec<usize> = (0..world.bodies.len()).collect();
    loop {
        if until.is_met(space.impacts) {
            return Ok(space.end(Ending::Impacts));
        }
        if space.impacts > 0 && moved.iter().any(|index| space.lies(*index)) {
            return Err(Stopped::Lies { impact: space.impacts, time: space.now.to_f64() });
        }
        space.look(&moved).map_err(|Unknown| space.undecided())?;
        let next = space.earliest()?;
        let over = until.before(next.as_ref().map(|(time, _)| time));
        if let Some(end) = over.map_err(|Unknown| space.undecided())? {
            return Ok(space.end_at(end.clone()));
        }
        let Some((time, encounter)) = next else {
            return Ok(space.end(Ending::Quiet));
        };
        if space.impacts == budget.impacts {
            let time = space.now.to_f64();
            return Err(Stopped::Budget { impacts: budget.impacts, time });
        }
        let bounce = space.meet(resolver, time, encounter)?;
        observer(&bounce);
        if bounce.time.is_long() || bounce.slip[1].is_long() {
            return Err(Stopped::Long { impact: space.impacts, time: space.now.to_f64() });
        }
        moved = bounce.bodies().collect();
    }
}
