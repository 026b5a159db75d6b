//! For contrast: springs where bodies overlap, stepped as common engines do.

use crate::round::Round;
use crate::side::Side;
use crate::world::World;

/// A penalty method with a step of fixed length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penalty {
    /// Of the linear spring of every contact; N/m.
    pub stiffness: f64,
    /// s
    pub step: f64,
}

/// An overlap: a body, the other one unless it is a wall, the normal from the first, the depth in metres.
struct Overlap {
    body: usize,
    other: Option<usize>,
    normal: [f64; 2],
    depth: f64,
}

/// The mechanical energy after the given time, in joules, by the semi-implicit method of Euler: what a
/// penalty method does to bodies that lose nothing along the normal. Friction is Coulomb's, in full
/// against the slip; the world's restitution is not asked.
///
/// Heuristic, and meant to be. The error is that of the steps in which bodies enter and leave a spring,
/// and depends on where in a step that happens, so that a smaller step may be worse.
#[must_use]
pub fn energy_by_penalty(world: &World<f64>, method: &Penalty, duration: f64) -> f64 {
    let mut world = world.clone();
    let mut time = 0.0;
    while time < duration {
        for overlap in overlaps(&world) {
            push(&mut world, &overlap, method);
        }
        for body in &mut world.bodies {
            body.motion.vy -= world.gravity * method.step;
            body.position[0] += body.motion.vx * method.step;
            body.position[1] += body.motion.vy * method.step;
        }
        time += method.step;
    }
    let springs = overlaps(&world).into_iter();
    let stored: f64 = springs.map(|o| method.stiffness * o.depth * o.depth / 2.0).sum();
    let of_body =
        |body: &Round<f64>| body.kinetic_energy() + body.mass * world.gravity * body.position[1];
    stored + world.bodies.iter().map(of_body).sum::<f64>()
}

fn overlaps(world: &World<f64>) -> Vec<Overlap> {
    let mut out = Vec::new();
    for (i, a) in world.bodies.iter().enumerate() {
        let [x, y] = a.position;
        for wall in &world.walls {
            let (normal, distance) = match wall.side {
                Side::Floor => ([0.0, -1.0], y - wall.at),
                Side::Ceiling => ([0.0, 1.0], wall.at - y),
                Side::Left => ([-1.0, 0.0], x - wall.at),
                Side::Right => ([1.0, 0.0], wall.at - x),
                Side::Plane(_) | Side::Back | Side::Front => continue,
            };
            if distance < a.radius {
                let depth = a.radius - distance;
                out.push(Overlap { body: i, other: None, normal, depth });
            }
        }
        for (j, b) in world.bodies.iter().enumerate().skip(i + 1) {
            let (dx, dy) = (b.position[0] - x, b.position[1] - y);
            let reach = a.radius + b.radius;
            let square = dx * dx + dy * dy;
            if square < reach * reach && square > 0.0 {
                let distance = square.sqrt();
                let normal = [dx / distance, dy / distance];
                out.push(Overlap { body: i, other: Some(j), normal, depth: reach - distance });
            }
        }
    }
    out
}

/// One step of one spring, on the velocities; all forces are of the positions at the start of the step.
fn push(world: &mut World<f64>, overlap: &Overlap, method: &Penalty) {
    let [nx, ny] = overlap.normal;
    let tangent = [-ny, nx];
    // the velocity of a body's point of contact along the tangent; it lies at ±r·n
    let along = |body: &Round<f64>, side: f64| {
        let motion = &body.motion;
        motion.vx * tangent[0] + motion.vy * tangent[1] + side * motion.omega * body.radius
    };
    let other = overlap.other.map_or(0.0, |j| along(&world.bodies[j], -1.0));
    let slip = other - along(&world.bodies[overlap.body], 1.0);
    let normal = method.stiffness * overlap.depth * method.step;
    let against = if slip == 0.0 { 0.0 } else { -slip.signum() };
    let tangential = against * world.friction * normal;
    let mut kick = |index: usize, sign: f64| {
        let body = &mut world.bodies[index];
        body.motion.vx += sign * (normal * nx + tangential * tangent[0]) / body.mass;
        body.motion.vy += sign * (normal * ny + tangential * tangent[1]) / body.mass;
        // on both sides the arm and the impulse change their sign together
        body.motion.omega -= tangential * body.radius / body.inertia;
    };
    kick(overlap.body, -1.0);
    if let Some(j) = overlap.other {
        kick(j, 1.0);
    }
}
