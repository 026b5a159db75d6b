//! The motion as a picture shows it.

use crate::choose::{Mechanics, Model, run_for_picture};
use crate::scene::{Scene, Setup};
use crate::world::{Round, Side};

/// The bodies at one moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// s
    pub time: f64,
    /// Centre (m) and orientation (rad) of each body.
    pub bodies: Vec<([f64; 2], f64)>,
}

/// Pictures at equal intervals, and the ways between.
#[derive(Clone, Debug, PartialEq)]
pub struct Strobe {
    /// From the start to the end.
    pub frames: Vec<Frame>,
    /// The way of each body's centre, finely.
    pub paths: Vec<Vec<[f64; 2]>>,
    /// r of each body; m.
    pub radii: Vec<f64>,
    /// The walls and where they are; m.
    pub walls: Vec<(Side, f64)>,
}

/// Pictures in a strobe, and points of a path for each.
const FRAMES: u32 = 24;
const FINE: u32 = 12;

impl Strobe {
    /// The motion under a model, in floats; `None` where nothing flies.
    pub(crate) fn of(scene: &Scene, model: Model) -> Option<Self> {
        let Setup::Bodies(stated) = &scene.setup else { return None };
        if model.mechanics == Mechanics::Chain {
            return None;
        }
        let world = stated.map(|stated| crate::Coordinate::to_f64(&stated.value));
        let (end, bounces) = run_for_picture(scene, &world, model.mechanics)?;
        let time = end.time;
        let mut states: Vec<Vec<(f64, Round<f64>, f64)>> =
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
        let at = |index: usize, time: f64| {
            let states = &states[index];
            let last = states.partition_point(|(since, ..)| *since <= time).max(1) - 1;
            let (since, body, angle) = &states[last];
            let flown = body.flown(&(time - since), &world.gravity);
            let mut position = flown.position;
            // what has come to rest does not fall through the floor
            for wall in &world.walls {
                if wall.side == Side::Floor {
                    position[1] = position[1].max(wall.at + body.radius);
                }
            }
            (position, angle + body.motion.omega * (time - since))
        };
        let bodies = world.bodies.len();
        let moment = |n: u32, of: u32| time * f64::from(n) / f64::from(of);
        let frames = (0..=FRAMES)
            .map(|n| Frame {
                time: moment(n, FRAMES),
                bodies: (0..bodies).map(|index| at(index, moment(n, FRAMES))).collect(),
            })
            .collect();
        let paths = (0..bodies)
            .map(|index| {
                // with its corners
                let mut times: Vec<f64> = (0..=FRAMES * FINE)
                    .map(|n| moment(n, FRAMES * FINE))
                    .chain(states[index].iter().map(|(since, ..)| *since))
                    .collect();
                times.sort_by(f64::total_cmp);
                times.into_iter().map(|time| at(index, time).0).collect()
            })
            .collect();
        Some(Self {
            frames,
            paths,
            radii: world.bodies.iter().map(|body| body.radius).collect(),
            walls: world.walls.iter().map(|wall| (wall.side, wall.at)).collect(),
        })
    }
}
