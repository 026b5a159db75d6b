use kane_impact::bodies::Motion;
use kane_impact::laws::{RouthNewton, Walton};
use kane_impact::{Law, laws};
use kane_number::{Interval, Lane as _, Rational};
use kane_scene::simulate::{Budget, End, Stopped, Until, run};
use kane_scene::{Coordinate, OffPlane, Resolver, Round, Side, Wall, World, read};

use crate::{above_floor, answered, assert_values, ball, n, of};

type Vector = [Rational; 3];
type Turn = [Vector; 3];

/// A sphere in space, by the literals of a ball and its rest.
fn sphere(
    mass: &str,
    radius: &str,
    place: [&str; 3],
    velocity: [&str; 3],
    spin: [&str; 3],
) -> Round<Rational> {
    let planar = ball(mass, radius, [place[0], place[1]], [velocity[0], velocity[1], spin[2]]);
    let off =
        OffPlane { z: n(place[2]), vz: n(velocity[2]), omega_x: n(spin[0]), omega_y: n(spin[1]) };
    Round { off_plane: Some(off), ..planar }
}

/// The same bodies as spheres in space.
fn lifted(world: &World<Rational>) -> World<Rational> {
    let mut world = world.clone();
    for body in &mut world.bodies {
        let [z, vz, omega_x, omega_y] = [(); 4].map(|()| n("0"));
        body.off_plane = Some(OffPlane { z, vz, omega_x, omega_y });
    }
    world
}

fn vectors(body: &Round<Rational>) -> [Vector; 3] {
    let off = body.off_plane.as_ref().expect("it is in space");
    let ([x, y], Motion { vx, vy, omega }) = (&body.position, &body.motion);
    [[x, y, &off.z], [vx, vy, &off.vz], [&off.omega_x, &off.omega_y, omega]]
        .map(|vector| vector.map(Clone::clone))
}

fn with(body: &Round<Rational>, [place, velocity, spin]: [Vector; 3]) -> Round<Rational> {
    let ([x, y, z], [vx, vy, vz], [omega_x, omega_y, omega]) = (place, velocity, spin);
    Round {
        position: [x, y],
        motion: Motion { vx, vy, omega },
        off_plane: Some(OffPlane { z, vz, omega_x, omega_y }),
        ..body.clone()
    }
}

fn turned(turn: &Turn, body: &Round<Rational>) -> Round<Rational> {
    let times = |vector: &Vector| {
        [0, 1, 2].map(|i| (0..3).map(|k| &turn[i][k] * &vector[k]).sum::<Rational>())
    };
    with(body, vectors(body).each_ref().map(times))
}

fn follow<N: Coordinate>(
    world: &World<Rational>,
    law: &dyn Resolver<N>,
    until: &Until<N>,
) -> Result<End<N>, Stopped> {
    run(&of::<N>(world), law, until, Budget::default(), &mut |_| {})
}

/// Bodies in the plane that meet each other and walls without two contacts at once.
fn planar_worlds() -> Vec<World<Rational>> {
    let one = ball("2", "1/10", ["0", "3/5"], ["1", "-3", "7"]);
    let other = ball("1/2", "1/5", ["1", "3/5"], ["-2", "-3", "-4"]);
    let mut meeting = above_floor(vec![one.clone(), other], "0", "1/7", "2/3");
    meeting.walls.clear();
    // 3 m/s downwards and 7/20 m above where it lies are 4 m/s at the floor
    let falling = ball("2", "1/10", ["0", "9/20"], ["1", "-3", "7"]);
    let mut room = above_floor(vec![falling], "10", "1/9", "3/4");
    room.walls.push(Wall { side: Side::Right, at: n("2") });
    vec![meeting, room]
}

#[test]
fn what_moves_in_the_plane_does_the_same_in_space() {
    let mut answered = 0;
    for planar in planar_worlds() {
        for law in [Law::from(RouthNewton), Law::from(Walton::default())] {
            for until in [Until::Impacts(1), Until::Impacts(2), Until::Duration(n("1/2"))] {
                let flat = follow::<Rational>(&planar, &law, &until);
                let space = follow::<Rational>(&lifted(&planar), &law, &until);
                match (flat, space) {
                    (Ok(flat), Ok(space)) => {
                        answered += 1;
                        assert_eq!((&flat.time, flat.impacts), (&space.time, space.impacts));
                        for (a, b) in flat.bodies.iter().zip(&space.bodies) {
                            assert_eq!((&a.position, &a.motion), (&b.position, &b.motion));
                            assert!(vectors(b)[1][2] == n("0") && vectors(b)[2][0] == n("0"));
                        }
                    }
                    // irrational times have no answer in either
                    (flat, space) => assert!(flat.is_err() && space.is_err(), "{flat:?} {space:?}"),
                }
            }
        }
    }
    assert!(answered >= 8, "{answered}");
}

#[test]
fn a_turned_meeting_is_the_planar_one_turned() {
    let turn: Turn = [["2/3", "-1/3", "2/3"], ["2/3", "2/3", "-1/3"], ["-1/3", "2/3", "2/3"]]
        .map(|row| row.map(n));
    let world = lifted(&planar_worlds()[0]);
    let mut turned_world = world.clone();
    for body in &mut turned_world.bodies {
        *body = turned(&turn, body);
    }
    let law = Law::from(RouthNewton);
    let (there, here) = (
        follow::<Rational>(&turned_world, &law, &Until::Impacts(1)).expect("they meet"),
        follow::<Rational>(&world, &law, &Until::Impacts(1)).expect("they meet"),
    );
    assert_eq!(there.time, here.time);
    assert_eq!(
        there.bodies,
        here.bodies.iter().map(|body| turned(&turn, body)).collect::<Vec<_>>()
    );
    // and it was no meeting without friction or spin
    assert!(here.bodies[0].motion.omega != world.bodies[0].motion.omega);
}

#[test]
fn every_side_of_a_room_in_space_is_the_floor_turned() {
    // columns are where x, y and z of the floor go
    let sides: [(Side, i32, [[i32; 3]; 3]); 6] = [
        (Side::Floor, -1, [[1, 0, 0], [0, 1, 0], [0, 0, 1]]),
        (Side::Ceiling, 1, [[-1, 0, 0], [0, -1, 0], [0, 0, 1]]),
        (Side::Left, -1, [[0, 1, 0], [-1, 0, 0], [0, 0, 1]]),
        (Side::Right, 1, [[0, -1, 0], [1, 0, 0], [0, 0, 1]]),
        (Side::Back, -1, [[1, 0, 0], [0, 0, -1], [0, 1, 0]]),
        (Side::Front, 1, [[1, 0, 0], [0, 0, 1], [0, -1, 0]]),
    ];
    // the slip is (3/2, −2) m/s, along x and z of the floor
    let start = sphere("2", "1/10", ["0", "0", "0"], ["1", "-2", "1"], ["30", "9", "5"]);
    let mut outcomes = Vec::new();
    for (side, at, turn) in sides {
        let turn = turn.map(|row| row.map(|k| Rational::from_integer(k.into())));
        let mut world = above_floor(vec![turned(&turn, &start)], "0", "1/9", "3/4");
        world.walls = vec![Wall { side, at: Rational::from_integer(at.into()) }];
        let law = Law::from(RouthNewton);
        let end = follow::<Rational>(&world, &law, &Until::Impacts(1)).expect("it meets the wall");
        // back by the transposed matrix
        let back: Turn = [0, 1, 2].map(|i| [0, 1, 2].map(|k| turn[k][i].clone()));
        outcomes.push((end.time.clone(), turned(&back, &end.bodies[0])));
    }
    assert!(outcomes.iter().all(|outcome| *outcome == outcomes[0]), "{outcomes:?}");
    // by hand: friction μ·(1 + e)·a = 7/18 m/s against (3/5, −4/5), and J/(m·r) = 1/25 m
    let [_, velocity, spin] = vectors(&outcomes[0].1);
    assert_eq!(velocity, [n("1") - n("7/30"), n("3/2"), n("1") + n("14/45")]);
    assert_eq!(spin, [n("30") - n("70/9"), n("9"), n("5") - n("35/6")]);
}

#[test]
fn friction_that_suffices_stops_the_slip_in_every_direction() {
    let start = sphere("3", "1/10", ["0", "1", "0"], ["1", "-2", "1"], ["30", "9", "5"]);
    let world = above_floor(vec![start], "0", "1", "1/2");
    let end = follow::<Rational>(&world, &Law::from(RouthNewton), &Until::Impacts(1))
        .expect("it meets the floor");
    let [_, [vx, _, vz], [omega_x, omega_y, omega]] = vectors(&end.bodies[0]);
    assert_eq!((&vx + &omega * n("1/10"), &vz - &omega_x * n("1/10")), (n("0"), n("0")));
    // two sevenths of the slip went into the velocity; what turns about the normal is not touched
    assert_eq!((vx, vz, omega_y), (n("1") - n("3/7"), n("1") + n("4/7"), n("9")));
}

#[test]
fn momentum_angular_momentum_and_the_ledger_are_kept() {
    let mut world = above_floor(
        vec![
            sphere("2", "0.1", ["0", "0", "0"], ["3", "1", "0.5"], ["4", "-9", "20"]),
            sphere("0.7", "0.2", ["1", "0.4", "0.1"], ["-1", "0.2", "0"], ["-7", "2", "11"]),
        ],
        "0",
        "0.3",
        "0.8",
    );
    world.walls.clear();
    let world = of::<f64>(&world);
    let sums = |bodies: &[Round<f64>]| {
        let mut sums = [0.0; 7];
        for body in bodies {
            let off = body.off_plane.as_ref().expect("it is in space");
            let (p, m) = ([body.position[0], body.position[1], off.z], body.mass);
            let v = [body.motion.vx, body.motion.vy, off.vz];
            let w = [off.omega_x, off.omega_y, body.motion.omega];
            for k in 0..3 {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                sums[k] += m * v[k];
                sums[3 + k] += m * (p[i] * v[j] - p[j] * v[i]) + body.inertia * w[k];
            }
            sums[6] += body.kinetic_energy();
        }
        sums
    };
    let mut gained = 0.0;
    let law = Law::from(RouthNewton);
    let end = run(&world, &law, &Until::Impacts(1), Budget::default(), &mut |bounce| {
        gained += bounce.ledger.total();
        assert!(bounce.slip[0] > 0.0 && bounce.impulse.tangential < 0.0);
    })
    .expect("they meet");
    let (before, after) = (sums(&world.bodies), sums(&end.bodies));
    for k in 0..6 {
        assert!((before[k] - after[k]).abs() < 1e-12, "{k}: {before:?} {after:?}");
    }
    assert!((before[6] + gained - after[6]).abs() < 1e-12);
    assert!(gained < -0.1);
}

#[test]
fn intervals_hold_the_motion_in_space() {
    let mut world = above_floor(
        vec![
            sphere("2", "1/10", ["1", "1", "1"], ["3", "1", "1/2"], ["4", "-9", "20"]),
            sphere("7/10", "1/5", ["2", "7/5", "6/5"], ["-1", "1/5", "0"], ["-7", "2", "11"]),
        ],
        "10",
        "3/10",
        "4/5",
    );
    for (side, at) in [(Side::Left, "0"), (Side::Right, "3"), (Side::Back, "0"), (Side::Front, "3")]
    {
        world.walls.push(Wall { side, at: n(at) });
    }
    let (law, impacts) = (Law::from(RouthNewton), 12);
    let within = follow::<Interval>(&world, &law, &Until::Impacts(impacts)).expect("they tell");
    let long = follow::<kane_number::DoubleDouble>(&world, &law, &Until::Impacts(impacts));
    let long = long.expect("floats go on");
    let mut ends = Vec::new();
    within.map(|x| ends.push(*x));
    let mut held = ends.into_iter();
    let mut worst = 0.0_f64;
    long.map(|x| {
        let interval = held.next().expect("as many numbers");
        worst = worst.max(interval.width());
        assert!(interval.contains(&x.exact().expect("it is finite")), "{interval} {x}");
    });
    assert!(worst < 1e-3, "{worst}");
    // which is a motion that walls of the third direction took part in
    let mut sides = Vec::new();
    run(&of::<f64>(&world), &law, &Until::Impacts(impacts), Budget::default(), &mut |bounce| {
        sides.push(bounce.encounter);
    })
    .expect("they go on");
    let depth = |met: &kane_scene::simulate::Encounter| {
        matches!(met, kane_scene::simulate::Encounter::Wall(_, Side::Back | Side::Front))
    };
    assert!(sides.iter().any(depth), "{sides:?}");
}

#[test]
fn several_contacts_at_once_are_refused_where_there_is_friction() {
    let corner = |friction: &str| {
        let start = sphere("1", "1/10", ["1", "1", "1"], ["-1", "-1", "0"], ["0", "0", "0"]);
        let mut world = above_floor(vec![start], "0", friction, "1/2");
        world.walls.push(Wall { side: Side::Left, at: n("0") });
        follow::<Rational>(&world, &Law::from(RouthNewton), &Until::Impacts(2))
    };
    assert_eq!(corner("0").expect("walls answer one after the other").impacts, 2);
    assert!(matches!(corner("1/5"), Err(Stopped::AtOnce { impact: 1, .. })));
    // what touches already is struck at the same time
    let row = |friction: &str| {
        let at =
            |x: &str, v: &str| sphere("1", "1/10", [x, "0", "0"], [v, "0", "0"], ["0", "0", "0"]);
        let bodies = vec![at("0", "1"), at("1", "0"), at("6/5", "0")];
        let mut world = above_floor(bodies, "0", friction, "1");
        world.walls.clear();
        follow::<Rational>(&world, &Law::from(RouthNewton), &Until::Impacts(2))
    };
    assert_eq!(row("0").expect("one hands on to the next").bodies[2].motion.vx, n("1"));
    assert!(matches!(row("1/5"), Err(Stopped::AtOnce { impact: 2, .. })));
}

#[test]
fn a_law_that_turns_the_axes_says_nothing_in_space() {
    let start = sphere("1", "1/10", ["0", "1", "0"], ["3", "-1", "4"], ["0", "0", "0"]);
    let world = above_floor(vec![start], "0", "1/5", "1/2");
    let mut turning = 0;
    for law in laws() {
        if let Err(Stopped::NoImpulse { source, .. }) =
            follow::<f64>(&world, law, &Until::Impacts(1))
            && source.to_string().contains("in one plane")
        {
            turning += 1;
        }
    }
    assert!(turning > 0, "some law has a frame of its own");
}

#[test]
fn a_moving_wall_stands_upright_on_the_plane() {
    // a floor that slides along x at 3 m/s and rises at 1 m/s is a floor at rest for one who goes along
    let start = |velocity| sphere("1", "1/10", ["0", "1", "0"], velocity, ["30", "9", "5"]);
    let plane = |velocity: [&str; 2]| kane_scene::Plane {
        normal: [n("0"), n("1")],
        through: [n("0"), n("0")],
        velocity: velocity.map(n),
    };
    let after = |velocity, of_wall| {
        let mut world = above_floor(vec![start(velocity)], "0", "1/9", "3/4");
        world.walls.clear();
        world.planes.push(plane(of_wall));
        follow::<Rational>(&world, &Law::from(RouthNewton), &Until::Impacts(1)).expect("they meet")
    };
    let (still, moving) =
        (after(["1", "-2", "1"], ["0", "0"]), after(["4", "-1", "1"], ["3", "1"]));
    let ([_, a, spin], [_, b, same]) = (vectors(&still.bodies[0]), vectors(&moving.bodies[0]));
    assert_eq!((b, same), ([&a[0] + n("3"), &a[1] + n("1"), a[2].clone()], spin));
    assert_eq!(still.time, moving.time);
}

const CUSHION: &str = include_str!("../../../../docs/scenes/billiard-cushion.toml");

#[test]
fn a_cushion_with_side_spin_is_what_friction_against_one_slip_gives() {
    // m·Δv = −μ·(1 + e)·m·a·s/|s| with s = (v_x + r·ω_z, v_z − r·ω_x), J·Δω = −r·n × (m·Δv)
    let (mu, e, r, a) = (0.14, 0.85, 0.025, 2.0);
    let (v, w) = ([0.9, -2.0, 0.0], [80.0, 36.0, 24.0]);
    let slip: [f64; 2] = [v[0] + r * w[2], v[2] - r * w[0]];
    let push = mu * (1.0 + e) * a / slip[0].hypot(slip[1]);
    let change = slip.map(|s| -push * s);
    // J/(m·r²) = 2/5
    let spun = change.map(|dv| dv / (0.4 * r));
    let expected =
        [v[0] + change[0], e * a, v[2] + change[1], w[0] - spun[1], w[1], w[2] + spun[0]];
    assert_values(&answered(CUSHION), &expected, 1e-9);
    // the ball is turned, and lifted off the table
    assert!(expected[2] > 0.4);
}

#[test]
fn a_cradle_in_space_is_the_one_along_a_line_turned_and_falling() {
    let answer = answered(include_str!("../../../../docs/scenes/cradle-in-space.toml"));
    let line = "friction = 0\nrestitution = 1\n";
    let body = |mass: &str, x: &str, v: &str| {
        format!(
            "[[body]]\nmass_kg = {mass}\nradius_m = 0.0145\nposition_m = [{x}, 0]\nvelocity_m_s = [{v}, 0]\n"
        )
    };
    let bodies = [body("0.1", "0", "1.5"), body("0.06", "0.06", "0"), body("0.03", "0.105", "0")];
    let asked = "[until]\nimpacts = 2\n[ask]\nv_x_m_s_of_3 = 0\nv_x_m_s_of_2 = 0\nv_x_m_s = 0\ntime_s = 0\n";
    let planar = answered(&format!("{line}{}{asked}", bodies.concat()));
    let [third, second, first, time] = [0, 1, 2, 3].map(|k| planar.lines[k].value);
    let along = |v: f64| [v * 2.0 / 3.0, v / 3.0 - 10.0 * time, v * 2.0 / 3.0];
    let [x, y, z] = along(third);
    assert_values(&answer, &[x, y, z, along(second)[2], along(first)[2], time], 1e-15);
    assert!(answer.lines.iter().all(|line| line.error == Some(0.0)));
}

#[test]
fn what_is_described_in_one_plane_is_refused_in_space() {
    let scene = |top: &str, body: &str, until: &str, ask: &str| {
        let text = format!(
            "friction = 0.1\nrestitution = 0.5\n{top}\n[[body]]\nmass_kg = 1\nradius_m = 0.1\n{body}\n[until]\n{until}\n[ask]\n{ask} = 1\n"
        );
        read::scene("scene.toml", &text).map(|_| ()).map_err(|fault| fault.message.clone())
    };
    let good = (
        "floor_m = 0",
        "position_m = [0, 1, 0]\nvelocity_m_s = [1, -1, 0]",
        "impacts = 1",
        "v_z_m_s",
    );
    assert_eq!(scene(good.0, good.1, good.2, good.3), Ok(()));
    let flat = "position_m = [0, 1]\nvelocity_m_s = [1, -1]";
    for (top, body, until, ask, expected) in [
        (good.0, good.1, "rest = true", good.3, "rest is described in the plane"),
        (good.0, flat, good.2, "v_z_m_s", "v_z_m_s is of spheres in space"),
        (good.0, flat, good.2, "omega_x_rad_s", "omega_x_rad_s is of spheres in space"),
        (
            "rolling_resistance = 0.1\nfloor_m = 0",
            good.1,
            good.2,
            good.3,
            "rolling_resistance is described for motion in the plane",
        ),
        (
            "air = { density_kg_m3 = 1 }",
            good.1,
            good.2,
            good.3,
            "[air] is described for motion in the plane",
        ),
        ("hertz_stiffness_n_m_3_2 = 1", good.1, good.2, good.3, "a stiffness is"),
        ("back_m = 0", flat, good.2, good.3, "body 1 is inside the back wall"),
        ("front_m = 0.05", flat, good.2, good.3, "body 1 is inside the front wall"),
        (
            good.0,
            "shape = \"disc\"\nposition_m = [0, 1, 0]\nvelocity_m_s = [1, -1]",
            good.2,
            good.3,
            "in space a body is a sphere",
        ),
        (
            good.0,
            "mobility_ratio = 2\nposition_m = [0, 1, 0]\nvelocity_m_s = [1, -1]",
            good.2,
            good.3,
            "in space a body is a sphere",
        ),
        (
            good.0,
            "position_m = [0]\nvelocity_m_s = [1, -1]",
            good.2,
            good.3,
            "position_m needs two numbers, or three in space",
        ),
        (
            good.0,
            "position_m = [0, 1, 0, 0]\nvelocity_m_s = [1, -1]",
            good.2,
            good.3,
            "position_m needs two numbers, or three in space",
        ),
        (
            good.0,
            "position_m = [0, 1]\nvelocity_m_s = [1, -1]\nspin_rad_s = 1\nspins_rad_s = [0, 0, 1]",
            good.2,
            good.3,
            "give one of them",
        ),
    ] {
        let found = scene(top, body, until, ask).expect_err(expected);
        assert!(found.contains(expected), "{found}");
    }
    // a third component may be left out, and is 0
    assert_eq!(scene("floor_m = 0\nback_m = -1", flat, good.2, good.3), Ok(()));
}
