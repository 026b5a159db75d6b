//! Walls at an angle or in motion, and contacts with terms of their own, each by another way.

use kane_impact::Law;
use kane_impact::laws::RouthNewton;
use kane_number::{Interval, Lane as _, Number as _, Rational};
use kane_scene::simulate::{Bounce, Budget, Encounter, End, Until, run};
use kane_scene::{
    Answer, Coordinate, NormalOnly, Plane, Resolver, Restitution, Side, Terms, World,
};

use crate::{above_floor, answered, ball, n, of, tried};

fn followed<N: Coordinate>(
    world: &World<N>,
    resolver: &dyn Resolver<N>,
    impacts: u64,
) -> (End<N>, Vec<Bounce<N>>) {
    let mut seen = Vec::new();
    let until = Until::Impacts(impacts);
    let end = run(world, resolver, &until, Budget::default(), &mut |bounce: &Bounce<N>| {
        seen.push(bounce.clone());
    });
    (end.expect("it comes to its end"), seen)
}

/// What was asked is within its tolerance of these, in their order.
#[track_caller]
fn assert_answers(answer: &Answer, expected: &[f64]) {
    assert_eq!(answer.lines.len(), expected.len());
    for (line, expected) in answer.lines.iter().zip(expected) {
        let noise = 1e-12 * expected.abs();
        let off = (line.value - expected).abs();
        assert!(off <= line.tolerance + noise, "{}: {} {expected}", line.quantity, line.value);
        assert!(line.error.is_some_and(|error| error <= line.tolerance), "{line:?}");
    }
}

/// The plane y = 0, as a wall of its own.
fn level() -> Plane<Rational> {
    Plane { normal: [n("0"), n("1")], through: [n("3"), n("0")], velocity: [n("0"), n("0")] }
}

#[test]
fn a_level_plane_is_a_floor() {
    let ball = ball("2", "1/10", ["0", "1"], ["3", "-1", "7"]);
    let floor = of::<Interval>(&above_floor(vec![ball], "10", "1/50", "3/4"));
    let law = Law::from(RouthNewton);
    let mut plane = floor.clone();
    plane.walls.clear();
    plane.planes.push(level().map(Interval::from_rational));
    let (a, b) = (followed(&floor, &law, 4), followed(&plane, &law, 4));
    for (a, b) in a.1.iter().zip(&b.1) {
        assert_eq!(a.regime, b.regime);
        for (a, b) in [(a.time, b.time), (a.slip[1], b.slip[1]), (a.separation, b.separation)] {
            assert!((a.midpoint() - b.midpoint()).abs() < 1e-13 && a.width() < 1e-12, "{a} {b}");
        }
    }
}

/// Dropped on a slope without friction and loss, a ball needs the same time for every flight, and the
/// ways between its marks on the slope are as 1 : 2 : 3.
#[test]
fn on_a_smooth_slope_the_ways_are_as_one_two_three() {
    let ball = ball("1", "1/10", ["0", "2"], ["0", "0", "0"]);
    let mut world = above_floor(vec![ball], "10", "0", "1");
    world.walls.clear();
    // tan of the slope 3/4, downwards to the right: it points along (4/5, −3/5)
    let normal = [n("3/5"), n("4/5")];
    world.planes.push(Plane { normal, through: [n("0"), n("0")], velocity: [n("0"), n("0")] });
    let (_, seen) = followed(&of::<f64>(&world), &NormalOnly, 5);
    let flights: Vec<f64> = seen.windows(2).map(|pair| pair[1].time - pair[0].time).collect();
    let way = |pair: &[Bounce<f64>]| {
        let [a, b] = [&pair[0].after.0.position, &pair[1].after.0.position];
        (b[0] - a[0]).hypot(b[1] - a[1])
    };
    let ways: Vec<f64> = seen.windows(2).map(way).collect();
    for (index, (flight, way)) in flights.iter().zip(&ways).enumerate() {
        let times = f64::from(u32::try_from(index).expect("few") + 1);
        assert!((flight - flights[0]).abs() < 1e-12, "{flights:?}");
        assert!((way - times * ways[0]).abs() < 1e-12, "{ways:?}");
    }
}

#[test]
fn a_belt_takes_the_ball_along() {
    // the slip is against the belt: at the belt's own speed, rolling, nothing happens along it
    let mut world =
        above_floor(vec![ball("1", "1/10", ["0", "1"], ["2", "0", "0"])], "10", "1/2", "1/2");
    world.walls.clear();
    let belt = |speed: &str| Plane { velocity: [n(speed), n("0")], ..level() };
    world.planes = vec![belt("2")];
    let law = Law::from(RouthNewton);
    let (end, _) = followed(&of::<f64>(&world), &law, 1);
    assert_eq!((end.bodies[0].motion.vx, end.bodies[0].motion.omega), (2.0, 0.0));
    // and otherwise it is what the floor does to the ball in the belt's frame
    world.planes = vec![belt("-1")];
    let (taken, _) = followed(&of::<f64>(&world), &law, 1);
    let mut seen_by_belt = above_floor(world.bodies.clone(), "10", "1/2", "1/2");
    seen_by_belt.bodies[0].motion.vx = n("3");
    let (still, _) = followed(&of::<f64>(&seen_by_belt), &law, 1);
    let [taken, still] = [&taken.bodies[0].motion, &still.bodies[0].motion];
    assert!((taken.vx - (still.vx - 1.0)).abs() < 1e-12);
    assert!((taken.omega - still.omega).abs() < 1e-12);
}

/// Between walls at 0 and at 2 − t/10, radius 1/10, speed 1 at first: by hand, in fractions.
#[test]
fn a_ball_between_closing_walls_gains_twice_the_walls_speed() {
    let answer = answered(include_str!("../../../../docs/scenes/squeezed.toml"));
    let (mut time, mut x, mut v) = (n("0"), n("1"), n("1"));
    let (r, u, zero) = (n("1/10"), n("1/10"), n("0"));
    for _ in 0..7 {
        let flight = match v > zero {
            // x + v·t = 2 − r − u·(time + t)
            true => (n("2") - &r - &u * &time - &x) / (&v + &u),
            false => (&x - &r) / -v.clone(),
        };
        time += &flight;
        x += &v * &flight;
        v = if v > zero { -v - n("2") * &u } else { -v };
    }
    assert_answers(&answer, &[time, x, v].map(|exact| exact.to_f64()));
}

/// By the speeds alone: what comes down is what went up.
#[test]
fn a_tennis_ball_keeps_less_of_a_faster_impact() {
    let answer = answered(include_str!("../../../../docs/scenes/tennis-clay.toml"));
    let e = |a: f64| match a {
        a if a <= 2.0 => 0.85,
        a if a <= 7.0 => 0.85 - 0.1 * (a - 2.0) / 5.0,
        a if a <= 14.0 => 0.75 - 0.15 * (a - 7.0) / 7.0,
        _ => 0.6,
    };
    let (g, r, mass, ratio) = (9.81, 0.033, 0.0577, 31.0 / 11.0);
    let inertia = mass * r * r / (ratio - 1.0);
    let (mut vx, mut omega) = (28.0, -150.0);
    let mut a = f64::sqrt(81.0 + 2.0 * g * (1.0 - r));
    let mut time = (a - 9.0) / g;
    for impact in 0..3 {
        let normal = mass * (1.0 + e(a)) * a;
        let slip: f64 = vx + omega * r;
        // slide, or stick if less will do
        let stick = slip.abs() * mass / ratio;
        let tangential = -slip.signum() * stick.min(0.8 * normal);
        vx += tangential / mass;
        omega += r * tangential / inertia;
        a *= e(a);
        if impact < 2 {
            time += 2.0 * a / g;
        }
    }
    assert_answers(&answer, &[time, vx, a, omega]);
}

/// Garwin's ball: normal and tangential velocity of the contact are turned back, at whatever angle.
#[test]
fn a_superball_jumps_between_two_sloping_walls() {
    let text = include_str!("../../../../docs/scenes/superball-groove.toml");
    let answer = answered(text);
    let (g, r) = (9.81, 0.025);
    let normals = [[-0.8, 0.6], [0.8, 0.6]];
    let (mut p, mut v, mut omega, mut last) = ([0.1, 0.8], [0.5, 0.0], 0.0, None);
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    for _ in 0..4 {
        // the first root beyond now of h + w·t − g·n_y·t²/2 = 0, downwards
        let hits = normals.iter().enumerate().map(|(wall, normal)| {
            let gap = if last == Some(wall) { 0.0 } else { dot(p, *normal) - r };
            let (speed, pull) = (dot(v, *normal), g * normal[1]);
            ((speed + (speed * speed + 2.0 * pull * gap).sqrt()) / pull, wall)
        });
        let (time, wall) = hits.min_by(|a, b| a.0.total_cmp(&b.0)).expect("there are walls");
        p = [p[0] + v[0] * time, p[1] + v[1] * time - g * time * time / 2.0];
        v[1] -= g * time;
        let (normal, tangent) = (normals[wall], [normals[wall][1], -normals[wall][0]]);
        let (out, along) = (dot(v, normal), dot(v, tangent));
        let slip = along + omega * r;
        // of −2·slip the centre has 2/7, the spin 5/7
        let (out, along) = (-out, along - 2.0 * slip * 2.0 / 7.0);
        omega -= 2.0 * slip * 5.0 / 7.0 / r;
        v = [0, 1].map(|k| along * tangent[k] + out * normal[k]);
        last = Some(wall);
    }
    assert_answers(&answer, &[p[0], p[1], v[0], v[1], omega]);
}

#[test]
fn of_several_terms_the_first_that_fits_is_taken() {
    let mut world =
        above_floor(vec![ball("1", "1/10", ["0", "1"], ["3", "-1", "0"])], "10", "1/5", "1/2");
    let floor = Some(Encounter::Wall(0, Side::Floor));
    let terms = |between, e: &str| Terms {
        between,
        friction: None,
        restitution: Some(Restitution::Constant(n(e))),
    };
    let separation = |world: &World<Rational>| {
        let (_, seen) = followed(&of::<f64>(world), &NormalOnly, 1);
        seen[0].separation / seen[0].approach
    };
    assert_eq!(separation(&world), 0.5);
    world.terms = vec![terms(Some(Encounter::Wall(0, Side::Left)), "1/8"), terms(floor, "3/4")];
    assert_eq!(separation(&world), 0.75);
    world.terms.insert(0, terms(None, "1/4"));
    assert_eq!(separation(&world), 0.25);
}

#[test]
fn restitution_falls_with_the_fourth_root_of_the_speed() {
    let stated = Restitution::QuarterPower { speed: 16.0, value: 0.5 };
    for (speed, e) in [(16.0, 0.5), (256.0, 0.25), (1.0, 1.0), (1e-9, 1.0)] {
        assert_eq!(stated.at(&speed), Ok(e), "{speed}");
    }
    // exact where the root is; elsewhere exact numbers say that they have none
    let exact = Restitution::QuarterPower { speed: n("16"), value: n("1/2") };
    assert_eq!(exact.at(&n("256")), Ok(n("1/4")));
    assert!(exact.at(&n("17")).is_err());
    // intervals hold what floats say, and do not guess
    let wide = exact.map(Interval::from_rational);
    let e = wide.at(&Interval::from_rational(&n("100"))).expect("it is told");
    assert!(e.contains(&n("0.3162277660168379")) || e.width() < 1e-15, "{e}");
    assert!(wide.at(&Interval::between(0.5, 2.0)).is_err());
}

/// A ball that has left the floor, whose way to another ball is then no longer barred, comes back to the floor
/// when it would have without the others.
#[test]
fn a_ball_that_is_looked_at_again_in_flight_comes_down_when_it_should() {
    let jumper = ball("1", "1/10", ["0", "1/5"], ["0", "-1", "0"]);
    let above = ball("1", "1/10", ["0", "3"], ["0", "0", "0"]);
    let striker = ball("1", "1/10", ["-3", "3"], ["10", "0", "0"]);
    let alone = above_floor(vec![jumper.clone()], "10", "0", "1");
    let (_, seen) = followed(&of::<f64>(&alone), &NormalOnly, 2);
    let world = above_floor(vec![jumper, above, striker], "10", "0", "1");
    let (_, all) = followed(&of::<f64>(&world), &NormalOnly, 3);
    assert_eq!(all[1].encounter, Encounter::Pair(1, 2));
    assert_eq!(all[2].encounter, Encounter::Wall(0, Side::Floor));
    assert!((all[2].time - seen[1].time).abs() < 1e-12, "{} {}", all[2].time, seen[1].time);
    // and on a floor that is a plane
    let mut sloping = of::<f64>(&world);
    sloping.walls.clear();
    sloping.planes.push(level().map(|x| x.to_f64()));
    let (_, again) = followed(&sloping, &NormalOnly, 3);
    assert!((again[2].time - seen[1].time).abs() < 1e-12, "{} {}", again[2].time, seen[1].time);
}

/// What gravity presses against a wall does not go through it.
#[test]
fn what_lies_on_a_wall_has_no_answer_after_that() {
    let body = "[[body]]
mass_kg = 1
radius_m = 0.1
position_m = [0, 2]
velocity_m_s = [0, 0]
";
    let end = "[until]\nduration_s = 3\n[ask]\ny_m = 0.1\n";
    let slope = "[[wall]]\nthrough_m = [0, 0]\nangle_deg = 20\n";
    let two_walls = "floor_m = 0\nleft_m = -1\n";
    for (walls, tables) in [("", slope), (two_walls, "")] {
        let top = "friction = 0.3\nrestitution = 0\ngravity_m_s2 = 9.81\n";
        let text = format!("{top}{walls}{tables}{body}{end}");
        let none = tried(&text);
        let why = none.expect_err("it lies on the wall").to_string();
        assert!(why.contains("lies on a wall"), "{why}");
        // the impact itself has an answer
        let text = text.replace("duration_s = 3", "impacts = 1").replace("\ny_m", "\nv_y_m_s");
        let first = tried(&text);
        assert_eq!(first.expect("there is an answer").bounces.len(), 1);
    }
}
