//! Scenes: the motion, the choice of a model, the format, and where methods fail.

mod air; // drag and Magnus' force, against closed forms and another integrator
mod choice; // every shipped scene: the chosen model meets the tolerance, the next cheaper misses
mod counting; // what models cost, counted
mod format; // what bad files get
mod motion; // flights and impacts, each by two ways
mod picture; // what pictures show
mod rest; // every model to the end of infinitely many impacts, its own way
mod rolling; // what lies on the floor skids, rolls, stops
mod space; // spheres in space, against the plane, turned, and by hand
mod stress; // drift, reversal, Zeno, grazing, penalty steps
mod tumbling; // bodies with corners, against closed forms and what no law may change
mod walls; // walls at an angle or in motion, terms of single contacts

use kane_impact::bodies::Motion;
use kane_impact::laws;
use kane_number::{Rational, parse};
use kane_scene::{Answer, Coordinate, Effort, NoAnswer, Round, Side, Wall, World, answer, read};

/// The answer to a scene, or why there is none.
fn tried(text: &str) -> Result<Answer, NoAnswer> {
    let scene = read::scene("scene.toml", text).expect("the scene is well formed");
    answer(&scene, laws(), None, Effort::Chosen, &mut |_, _| {})
}

/// The answer to a scene.
fn answered(text: &str) -> Answer {
    tried(text).expect("there is an answer")
}

/// Every value that was asked for is so near to these.
#[track_caller]
fn assert_values(answer: &Answer, expected: &[f64], near: f64) {
    for (line, expected) in answer.lines.iter().zip(expected) {
        let off = (line.value - expected).abs();
        assert!(off < near, "{}: {} {expected}", line.quantity, line.value);
    }
}

/// A literal.
fn n(text: &str) -> Rational {
    parse(text).expect("a literal")
}

/// A ball with J = 2/5·m·r² and all that is given as literals.
fn ball(mass: &str, radius: &str, position: [&str; 2], motion: [&str; 3]) -> Round<Rational> {
    let [x, y] = position.map(n);
    let [vx, vy, omega] = motion.map(n);
    let (mass, radius) = (n(mass), n(radius));
    Round {
        inertia: &mass * &radius * &radius * n("2/5"),
        mass,
        radius,
        position: [x, y],
        motion: Motion { vx, vy, omega },
        off_plane: None,
    }
}

/// A world of balls above a floor at 0.
fn above_floor(
    bodies: Vec<Round<Rational>>,
    gravity: &str,
    friction: &str,
    restitution: &str,
) -> World<Rational> {
    World {
        gravity: n(gravity),
        walls: vec![Wall { side: Side::Floor, at: n("0") }],
        air: None,
        planes: vec![],
        terms: vec![],
        corners: None,
        rolling: n("0"),
        bodies,
        friction: n(friction),
        restitution: n(restitution),
    }
}

/// The same world in another number system.
fn of<N: Coordinate>(world: &World<Rational>) -> World<N> {
    world.map(N::from_rational)
}

/// The kinetic energy of all bodies.
fn energy<N: Coordinate>(bodies: &[Round<N>]) -> N {
    bodies.iter().fold(N::zero(), |sum, body| sum + body.kinetic_energy())
}
