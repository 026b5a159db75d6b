//! The motion as a picture shows it.

use crate::choose::{Mechanics, Model, run_for_picture};
use crate::plane::Plane;
use crate::round::Round;
use crate::scene::{Scene, Setup};
use crate::side::Side;
use crate::simulate::Ending;
use crate::world::World;

/// The bodies at one moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// s
    pub time: f64,
    /// Centre (m) and orientation (rad) of each body.
    pub bodies: Vec<([f64; 2], f64)>,
}

/// Pictures at equal intervals and, of few impacts, at these; and the ways between.
#[derive(Clone, Debug, PartialEq)]
pub struct Strobe {
    /// From the start to the end.
    pub frames: Vec<Frame>,
    /// From one picture to the next, those at impacts left out; s.
    pub apart: f64,
    /// Whether every impact has a picture of its own.
    pub shows_impacts: bool,
    /// The way of each body's centre, finely.
    pub paths: Vec<Vec<[f64; 2]>>,
    /// Whether spheres move in space; the picture is what one sees along z, and has no orientation.
    pub is_in_space: bool,
    /// Velocities of the bodies right after the last impact, if the motion ends there: where they go on; m/s.
    pub leaving: Vec<[f64; 2]>,
    /// r of each body, or how far its corners reach; m.
    pub radii: Vec<f64>,
    /// Of a body with corners: these from its centre, where it is not turned; m.
    pub corners: Vec<[f64; 2]>,
    /// The walls and where they are; m.
    pub walls: Vec<(Side, f64)>,
    /// Walls at an angle: a point at the end, and the direction in which they go on both ways; m.
    pub planes: Vec<([f64; 2], [f64; 2])>,
}

/// The most pictures in a strobe and the fewest, and points of a path.
const FRAMES: u32 = 24;
const FEWEST: u32 = 4;
const POINTS: u32 = 288;
/// Steps in air of one body, and how much longer they are than those of a motion that is computed.
const STEPS: u32 = 1 << 20;
const COARSER: f64 = 4.0;
/// The most impacts that each have a picture.
const FEW_IMPACTS: usize = 6;

/// So many that a body moves by about 5/4 of its radius from one to the next: more would hide each
/// other.
fn frames(paths: &[Vec<[f64; 2]>], radii: &[f64]) -> u32 {
    let length = |path: &Vec<[f64; 2]>| -> f64 {
        path.windows(2).map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])).sum()
    };
    let far = paths.iter().zip(radii).map(|(path, radius)| length(path) / (1.25 * radius));
    let far = far.fold(0.0, f64::max);
    (FEWEST..FRAMES).find(|n| f64::from(*n) >= far).unwrap_or(FRAMES)
}

/// Where a wall is in the end, and which way it goes.
fn at_end(plane: &Plane<f64>, time: f64) -> ([f64; 2], [f64; 2]) {
    let [nx, ny] = plane.normal;
    let [_, advancing] = plane.velocity;
    let [x, y] = plane.through;
    ([x + nx * advancing * time, y + ny * advancing * time], [ny, -nx])
}

/// When a body was last struck, as it was then, and how far it had turned.
type Struck = (f64, Round<f64>, f64);

/// The motion of one body, asked at times that ascend.
struct Motion<'a> {
    world: &'a World<f64>,
    struck: &'a [Struck],
    last: usize,
    /// where the air has taken it until then
    body: Round<f64>,
    time: f64,
    steps: u32,
}

impl<'a> Motion<'a> {
    fn of(world: &'a World<f64>, struck: &'a [Struck]) -> Option<Self> {
        let (time, body, _) = struck.first()?;
        Some(Self { world, struck, last: 0, body: body.clone(), time: *time, steps: STEPS })
    }

    /// Where the centre is and how far it has turned; `None` where the air takes too many steps until then.
    fn at(&mut self, time: f64) -> Option<([f64; 2], f64)> {
        while let Some((since, body, _)) = self.struck.get(self.last + 1).filter(|s| s.0 <= time) {
            (self.last, self.time, self.body) = (self.last + 1, *since, body.clone());
        }
        let (since, body, angle) = &self.struck[self.last];
        let gravity = self.world.gravity;
        let mut position = match &self.world.air {
            Some(air) => {
                while self.time < time {
                    self.steps = self.steps.checked_sub(1)?;
                    let step = COARSER * air.step(std::slice::from_ref(&self.body), gravity);
                    let ends = self.time + step >= time;
                    let step = if ends { time - self.time } else { step };
                    self.body = air.stepped(&self.body, gravity, step).0;
                    self.time = if ends { time } else { self.time + step };
                }
                self.body.position
            }
            None => body.flown(&(time - since), &gravity).position,
        };
        // what has come to rest does not fall through the floor
        for wall in self.world.walls.iter().filter(|wall| wall.side == Side::Floor) {
            position[1] = position[1].max(wall.at + body.radius);
        }
        Some((position, angle + body.motion.omega * (time - since)))
    }
}

impl Strobe {
    /// The motion under a model, in floats; `None` where nothing flies, or the air takes too many steps.
    pub(crate) fn of(scene: &Scene, model: Model) -> Option<Self> {
        let Setup::Bodies(stated) = &scene.setup else { return None };
        if model.mechanics == Mechanics::Chain {
            return None;
        }
        let world = stated.map(|stated| kane_number::Lane::to_f64(&stated.value));
        let (end, bounces) = run_for_picture(scene, &world, model.mechanics)?;
        let time = end.time;
        let mut states: Vec<Vec<Struck>> =
            world.bodies.iter().map(|body| vec![(0.0, body.clone(), 0.0)]).collect();
        for bounce in &bounces {
            let involved: Vec<(usize, &Round<f64>)> = match bounce.encounter {
                crate::simulate::Encounter::Wall(i, _) => vec![(i, &bounce.after.0)],
                crate::simulate::Encounter::Pair(i, j) => {
                    let second = bounce.after.1.as_ref().map(|body| (j, body));
                    std::iter::once((i, &bounce.after.0)).chain(second).collect()
                }
            };
            for (index, body) in involved {
                let turned = states[index].last().map_or(0.0, |(since, before, angle)| {
                    angle + before.motion.omega * (bounce.time - since)
                });
                states[index].push((bounce.time, body.clone(), turned));
            }
        }
        let bodies = world.bodies.len();
        let moment = |n: u32, of: u32| time * f64::from(n) / f64::from(of);
        let along = |index: usize, times: &[f64]| -> Option<Vec<([f64; 2], f64)>> {
            let mut motion = Motion::of(&world, &states[index])?;
            times.iter().map(|time| motion.at(*time)).collect()
        };
        let path = |index: usize| {
            // with its corners
            let mut times: Vec<f64> = (0..=POINTS)
                .map(|n| moment(n, POINTS))
                .chain(states[index].iter().map(|(since, ..)| *since))
                .collect();
            times.sort_by(f64::total_cmp);
            Some(along(index, &times)?.into_iter().map(|(position, _)| position).collect())
        };
        let paths = (0..bodies).map(path).collect::<Option<Vec<Vec<[f64; 2]>>>>()?;
        let leaving = match end.ending {
            Ending::Impacts => end.bodies.iter().map(|b| [b.motion.vx, b.motion.vy]).collect(),
            _ => Vec::new(),
        };
        let corners = world.corners.as_ref().map_or_else(Vec::new, |corners| corners.0.clone());
        let reach = corners.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
        let radii: Vec<f64> = world.bodies.iter().map(|body| body.radius.max(reach)).collect();
        let count = frames(&paths, &radii);
        let shows_impacts = (1..=FEW_IMPACTS).contains(&bounces.len());
        let mut moments: Vec<f64> = (0..=count).map(|n| moment(n, count)).collect();
        if shows_impacts {
            moments.extend(bounces.iter().map(|bounce| bounce.time));
        }
        moments.sort_by(f64::total_cmp);
        moments.dedup();
        let places = (0..bodies).map(|index| along(index, &moments));
        let places: Vec<Vec<([f64; 2], f64)>> = places.collect::<Option<_>>()?;
        let frame = |(n, time)| Frame { time, bodies: places.iter().map(|of| of[n]).collect() };
        let frames = moments.into_iter().enumerate().map(frame).collect();
        Some(Self {
            frames,
            apart: moment(1, count),
            shows_impacts,
            paths,
            leaving,
            is_in_space: world.is_in_space(),
            radii,
            corners,
            walls: world.walls.iter().map(|wall| (wall.side, wall.at)).collect(),
            planes: world.planes.iter().map(|plane| at_end(plane, time)).collect(),
        })
    }
}
