//! For contrast: motions of the list that lose nothing along the normal, by a penalty method.

use std::f64::consts::PI;

use kane_impact::Law;
use kane_impact::bodies::Motion;
use kane_impact::laws::RouthNewton;
use num_traits::Signed as _;

use super::{Row, ball, box_of_discs, integer, ratio};
use crate::round::Round;
use crate::simulate::{Budget, Penalty, Until, energy_by_penalty, run};
use crate::world::World;
use kane_number::Lane;

/// A motion, and what its energy is to be.
struct Contrast {
    name: &'static str,
    world: World<f64>,
    /// Of the springs; N/m.
    stiffness: f64,
    /// Of two bodies in a contact, m₁·m₂/(m₁ + m₂); kg.
    mass: f64,
    /// s
    duration: f64,
    /// At the end; J.
    energy: f64,
    /// What the error is divided by; J.
    scale: f64,
}

/// The error of the energy, by the length of a step.
pub(super) fn rows(rows: &mut Vec<Row>) {
    for contrast in [drop(), grazing(), spheres(), discs()] {
        let lasts = PI * (contrast.mass / contrast.stiffness).sqrt();
        for parts in [4_u32, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128] {
            let step = lasts / f64::from(parts);
            let method = Penalty { stiffness: contrast.stiffness, step };
            let energy = energy_by_penalty(&contrast.world, &method, contrast.duration);
            rows.push(Row {
                case: "penalty with a fixed step, error of the energy",
                pushed: "step, by the time that a contact lasts",
                to: format!("1/{parts}"),
                method: contrast.name,
                error: ((energy - contrast.energy) / contrast.scale).abs(),
            });
        }
    }
}

/// The ball of the drift, dropped.
fn drop() -> Contrast {
    let mut world = ball(integer(1), ratio(2, 5), [integer(0), integer(0)], integer(1));
    world.bodies[0].position[1] = integer(2);
    let energy = 20.0;
    // of the height above the floor alone, so that the radius is no part of it
    Contrast {
        name: "a drop",
        world: world.map(Lane::to_f64),
        stiffness: 1e4,
        mass: 1.0,
        duration: 10.0,
        energy,
        scale: energy / 2.0,
    }
}

/// The ball that comes at 84.3 degrees and slides all the time: by what friction takes from it, exactly.
fn grazing() -> Contrast {
    let mut world = ball(ratio(1, 3), ratio(2, 5), [ratio(1, 3), ratio(-1, 30)], integer(1));
    world.gravity = integer(0);
    // a little above the floor: one that starts on it starts with a step, and errs less
    world.bodies[0].position[1] = ratio(1001, 1000);
    let before = world.bodies[0].kinetic_energy();
    let budget = Budget::default();
    let end = run(&world, &Law::from(RouthNewton), &Until::Impacts(1), budget, &mut |_| {}).ok();
    let after = end.map_or_else(|| before.clone(), |end| end.bodies[0].kinetic_energy());
    Contrast {
        name: "grazing",
        world: world.map(Lane::to_f64),
        stiffness: 1e4,
        mass: 1.0 / 3.0,
        duration: 0.1,
        energy: after.to_f64(),
        scale: (before - after).abs().to_f64(),
    }
}

/// Three spheres in a row that touch, and the first one strikes.
fn spheres() -> Contrast {
    let sphere = |x: f64, vx: f64| Round {
        mass: 0.1,
        inertia: 4e-5,
        radius: 0.01,
        position: [x, 0.0],
        motion: Motion { vx, vy: 0.0, omega: 0.0 },
        off_plane: None,
    };
    let bodies = vec![sphere(-0.03, 1.0), sphere(0.0, 0.0), sphere(0.02, 0.0)];
    let (gravity, friction, restitution) = (0.0, 0.0, 1.0);
    Contrast {
        name: "three spheres",
        world: World {
            gravity,
            air: None,
            walls: Vec::new(),
            planes: Vec::new(),
            bodies,
            friction,
            restitution,
            terms: Vec::new(),
            corners: None,
            rolling: 0.0,
        },
        stiffness: 1e5,
        mass: 0.05,
        duration: 0.1,
        energy: 0.05,
        scale: 0.05,
    }
}

/// The box of discs.
fn discs() -> Contrast {
    let world = box_of_discs();
    let energy = world.bodies.iter().map(Round::kinetic_energy).sum();
    Contrast {
        name: "50 discs",
        world,
        stiffness: 1e3,
        mass: 5e-3,
        duration: 1.0,
        energy,
        scale: energy,
    }
}
