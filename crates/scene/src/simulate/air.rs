//! Motion in air, whose flights have no closed form: in steps, in floats.

use super::bounce::{Bounce, normal_of, strike};
use super::ending::{Budget, End, Ending, Stopped, Until};
use crate::air::Air;
use crate::encounter::Encounter;
use crate::resolver::Resolver;
use crate::round::Round;
use crate::side::Side;
use crate::world::World;

/// How finely flights are followed, and how far.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Steps {
    /// By the length of a usual step.
    pub(crate) finer: u32,
    /// How many bodies and pairs are looked at in all of them; for more the motion stops.
    pub(crate) looks: usize,
}

/// Halvings of a step in the search for the time of an impact.
const HALVINGS: u32 = 60;
/// Where in a step a body that has just left a wall is looked for away from it.
const PARTS: [f64; 7] = [0.5, 0.25, 0.75, 0.125, 0.875, 0.0625, 0.03125];

/// The bodies in flight, at one time for all.
struct Flight<'a> {
    world: &'a World<f64>,
    air: &'a Air<f64>,
    time: f64,
    bodies: Vec<Round<f64>>,
    last: Vec<Option<Encounter>>,
    /// the heights of the last impacts
    heights: Vec<f64>,
    /// the work of the air since then
    taken: Vec<f64>,
}

/// Bodies at a later time, and the work of the air on each until then.
type Ahead = (Vec<Round<f64>>, Vec<f64>);

impl Flight<'_> {
    /// All bodies after so long, and the work of the air on each.
    fn ahead(&self, step: f64) -> Ahead {
        let gravity = self.world.gravity;
        self.bodies.iter().map(|body| self.air.stepped(body, gravity, step)).unzip()
    }

    /// Flies on.
    fn fly(&mut self, (bodies, work): Ahead) {
        self.bodies = bodies;
        for (taken, work) in self.taken.iter_mut().zip(work) {
            *taken += work;
        }
    }

    /// All that may meet.
    fn encounters(&self) -> Vec<Encounter> {
        let world = self.world;
        let planes = (0..).map(Side::Plane).take(world.planes.len());
        let sides: Vec<Side> = world.walls.iter().map(|wall| wall.side).chain(planes).collect();
        let count = self.bodies.len();
        let mut all = Vec::new();
        for i in 0..count {
            all.extend(sides.iter().map(|side| Encounter::Wall(i, *side)));
            all.extend((i + 1..count).map(|j| Encounter::Pair(i, j)));
        }
        all
    }

    /// How far from each other the two are, and whether they come nearer.
    fn gap(&self, encounter: Encounter, bodies: &[Round<f64>], time: f64) -> (f64, bool) {
        match encounter {
            Encounter::Pair(i, j) => {
                let (a, b) = (&bodies[i], &bodies[j]);
                let [dx, dy] = [0, 1].map(|k| a.position[k] - b.position[k]);
                let [wx, wy] = [a.motion.vx - b.motion.vx, a.motion.vy - b.motion.vy];
                (dx.hypot(dy) - a.radius - b.radius, dx.mul_add(wx, dy * wy) < 0.0)
            }
            Encounter::Wall(i, side) => {
                let body = &bodies[i];
                if let Side::Plane(number) = side {
                    let Some(plane) = self.world.planes.get(usize::from(number)) else {
                        return (f64::INFINITY, false);
                    };
                    let [speed, _] = plane.parting(body, &self.world.gravity);
                    return (plane.gap(body, &time), speed < 0.0);
                }
                let wall = self.world.walls.iter().find(|wall| wall.side == side);
                let at = wall.map_or(f64::NEG_INFINITY, |wall| wall.at);
                let ([x, y], [nx, ny]) = (body.position, normal_of(self.world, side));
                let height = (x - at) * nx.abs() + (y - at) * ny.abs();
                let out = body.motion.vx.mul_add(nx, body.motion.vy * ny);
                ((nx + ny) * height - body.radius, out < 0.0)
            }
        }
    }

    /// Whether the two have met, and neither anything else since.
    fn touching(&self, encounter: Encounter) -> bool {
        match encounter {
            Encounter::Wall(i, _) => self.last[i] == Some(encounter),
            Encounter::Pair(i, j) => [i, j].iter().all(|k| self.last[*k] == Some(encounter)),
        }
    }

    /// When in a step the two meet, if they do, given all bodies at its end; `Err` if they leave and meet
    /// again so soon that the steps do not see it: they rest on each other.
    fn meets(
        &self,
        encounter: Encounter,
        step: f64,
        end: &[Round<f64>],
    ) -> Result<Option<f64>, ()> {
        if self.gap(encounter, end, self.time + step).0 >= 0.0 {
            return Ok(None);
        }
        let gap = |part: f64| self.gap(encounter, &self.ahead(part).0, self.time + part);
        let mut low = 0.0;
        if self.touching(encounter) {
            let mut parts = PARTS.iter().map(|part| part * step);
            low = parts.find(|part| gap(*part).0 > 0.0).ok_or(())?;
        }
        let mut high = step;
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(low, high);
            if gap(middle).0 < 0.0 { high = middle } else { low = middle }
        }
        Ok(gap(high).1.then_some(high))
    }
}

/// Follows a world with air: flights by Runge and Kutta, in steps that are `finer` times as short as the
/// usual ones; the time of an impact to the last bit of its step.
///
/// Heuristic: compare two runs. Bodies that graze each other within a step, at less than a hundredth or
/// so of their radius, may be missed.
///
/// # Errors
/// [`Stopped`]; [`Stopped::Steps`] for too many of them, as those of a ball that comes to rest.
pub(crate) fn run_in_air(
    world: &World<f64>,
    air: &Air<f64>,
    resolver: &dyn Resolver<f64>,
    until: &Until<f64>,
    (budget, Steps { finer, looks }): (Budget, Steps),
    observer: &mut dyn FnMut(&Bounce<f64>),
) -> Result<End<f64>, Stopped> {
    if *until == Until::Rest {
        return Err(Stopped::InAir);
    }
    let count = world.bodies.len();
    let mut flight = Flight {
        world,
        air,
        time: 0.0,
        bodies: world.bodies.clone(),
        last: vec![None; count],
        heights: world.bodies.iter().map(|body| body.position[1]).collect(),
        taken: vec![0.0; count],
    };
    let encounters = flight.encounters();
    let mut impacts = 0;
    let steps = looks / (count + encounters.len()).max(1);
    for _ in 0..steps {
        let end = |ending| {
            let (time, bodies) = (flight.time, flight.bodies.clone());
            Ok(End { time, bodies, impacts, ending, turned: None })
        };
        match until {
            Until::Impacts(asked) if *asked <= impacts => return end(Ending::Impacts),
            Until::Duration(time) if *time <= flight.time => return end(Ending::Duration),
            _ => {}
        }
        let mut step = air.step(&flight.bodies, world.gravity) / f64::from(finer);
        let mut over = None;
        if let Until::Duration(end) = until
            && *end <= flight.time + step
        {
            (step, over) = (end - flight.time, Some(*end));
        }
        let ahead = flight.ahead(step);
        let mut first: Option<(f64, Encounter)> = None;
        for encounter in &encounters {
            let rests = |()| Stopped::Undecided { impact: impacts, time: flight.time };
            let Some(part) = flight.meets(*encounter, step, &ahead.0).map_err(rests)? else {
                continue;
            };
            if first.is_none_or(|(best, _)| part < best) {
                first = Some((part, *encounter));
            }
        }
        let Some((part, encounter)) = first else {
            flight.fly(ahead);
            flight.time = over.unwrap_or(flight.time + step);
            continue;
        };
        if impacts == budget.impacts {
            return Err(Stopped::Budget { impacts, time: flight.time });
        }
        flight.fly(flight.ahead(part));
        flight.time += part;
        impacts += 1;
        let bounce = meet(&mut flight, resolver, encounter, impacts)?;
        observer(&bounce);
    }
    Err(Stopped::Steps { impacts, time: flight.time })
}

/// Brings two through their impact.
fn meet(
    flight: &mut Flight<'_>,
    resolver: &dyn Resolver<f64>,
    encounter: Encounter,
    impact: u64,
) -> Result<Bounce<f64>, Stopped> {
    let (time, world) = (flight.time, flight.world);
    let (first, second, normal) = match encounter {
        Encounter::Wall(i, side) => (i, None, normal_of(world, side)),
        Encounter::Pair(i, j) => {
            let [a, b] = [i, j].map(|k| &flight.bodies[k]);
            let reach = a.radius + b.radius;
            (i, Some(j), [0, 1].map(|k| (a.position[k] - b.position[k]) / reach))
        }
    };
    let bodies = &flight.bodies;
    let other = second.map(|j| &bodies[j]);
    let terms = (world, encounter);
    let struck = strike(resolver, terms, &normal, &bodies[first], other, None)
        .map_err(|source| Stopped::NoImpulse { impact, time, source })?;
    let fallen = |index: usize| {
        let body = &bodies[index];
        body.mass * world.gravity * (flight.heights[index] - body.position[1])
    };
    let gravity = fallen(first) + second.map_or(0.0, fallen);
    let taken = flight.taken[first] + second.map_or(0.0, |second| flight.taken[second]);
    let bounce = Bounce { air: Some(taken), ..struck.at(time, encounter, gravity) };
    let after = std::iter::once(Some(&bounce.after.0)).chain([bounce.after.1.as_ref()]);
    for (index, body) in bounce.bodies().zip(after.flatten()) {
        flight.heights[index] = body.position[1];
        flight.taken[index] = 0.0;
        flight.bodies[index] = body.clone();
        flight.last[index] = Some(encounter);
    }
    Ok(bounce)
}
