//! Discs that strike a plane in Rapier, one row an impact: `cargo run -p in-an-engine --example impacts > log.csv`,
//! then `kane check log.csv`.

use std::fmt::Write as _;

use rapier2d::prelude::*;

const MU: f32 = 0.3;
const E: f32 = 0.5;
const DT: f32 = 1.0 / 240.0;

/// A disc of 1 kg and 1 m that will touch the plane two and a half steps from now, in a world without gravity.
/// At α = μ·(1 + e)·|v_n|/v_t its friction takes the α-th part of its slip.
fn disc_above_a_plane(alpha: f32) -> (PhysicsWorld, RigidBodyHandle) {
    let mut world = PhysicsWorld { gravity: Vector::ZERO, ..PhysicsWorld::default() };
    world.integration_parameters.dt = DT;
    let surface = |shape: ColliderBuilder| shape.friction(MU).restitution(E);
    let plane = ColliderBuilder::cuboid(99.0, 1.0);
    world.insert(RigidBodyBuilder::fixed().translation(Vector::new(0.0, -1.0)), surface(plane));
    let disc = RigidBodyBuilder::dynamic()
        .translation(Vector::new(0.0, 1.0 + 2.5 * DT))
        .linvel(Vector::new(1.5 * MU * (1.0 + E) / alpha, -1.0));
    let (disc, _) = world.insert(disc, surface(ColliderBuilder::ball(1.0).mass(1.0)));
    (world, disc)
}

/// The log: the columns that `kane check` asks for, and a row for each impact.
fn impacts() -> String {
    let mut log = String::from(
        "mass,inertia,radius,mu,e,dt,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n",
    );
    for alpha in [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0] {
        let (mut world, disc) = disc_above_a_plane(alpha);
        let motion =
            |world: &PhysicsWorld| (world.bodies[disc].linvel(), world.bodies[disc].angvel());
        let (v, omega) = motion(&world);
        (0..8).for_each(|_| world.step());
        let (v_post, omega_post) = motion(&world);
        let _ = writeln!(
            log,
            "1,0.5,1,{MU},{E},{DT},{},{},{omega},{},{},{omega_post}",
            v.x, v.y, v_post.x, v_post.y,
        );
    }
    log
}

fn main() {
    print!("{}", impacts());
}

#[cfg(test)]
mod tests {
    use kane_impact::laws;
    use kane_records::reader::Kind;
    use kane_records::study::{Options, study};
    use kane_report::records::headline;

    /// The first sentence of `kane check`, which is that of the recording of this engine
    /// (`crates/records/tests/data`).
    #[test]
    fn the_sentence_says_what_the_engine_does_with_friction() {
        let log = super::impacts();
        let study = study(log.as_bytes(), Kind::Csv, &Options::new(laws())).expect("it is a log");
        assert_eq!(study.rows, 7);
        let told = headline(&study);
        let expected = "Restitution as stated; friction saturates at mu*p_n/(1 + e)";
        assert!(told.starts_with(expected), "{told}");
    }
}
