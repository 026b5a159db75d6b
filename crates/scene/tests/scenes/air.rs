//! Flights in air, against closed forms and another integrator.

use kane_scene::{Answer, Known, Picture, read};

use crate::{answered, tried};

/// What was asked is as near to these as is said, and that is near.
#[track_caller]
fn assert_answers(answer: &Answer, expected: &[f64], near: f64) {
    assert_eq!(answer.known, Some(Known::Estimated));
    assert_eq!(answer.lines.len(), expected.len());
    for (line, expected) in answer.lines.iter().zip(expected) {
        let error = line.error.expect("it is estimated");
        assert!(error <= near, "{}: {error}", line.quantity);
        let off = (line.value - expected).abs();
        assert!(off <= error + 1e-12, "{}: {} {expected}, {error}", line.quantity, line.value);
    }
}

/// A sphere that falls from rest in air with C_d = 2: with w² = m·g/(ρ·π·r²) it has v = w·tanh(g·t/w).
#[test]
fn a_fall_in_air_tends_to_its_last_speed() {
    let answer = answered(
        "friction = 0
restitution = 0.5
gravity_m_s2 = 9.81
[air]
density_kg_m3 = 1.2
drag_coefficient = 2
[[body]]
mass_kg = 0.01
radius_m = 0.05
position_m = [0, 10]
velocity_m_s = [0, 0]
[until]
duration_s = 1.5
[ask]
v_y_m_s = 1e-7
y_m = 1e-7
v_x_m_s = 1e-7
",
    );
    let (g, t) = (9.81, 1.5);
    let w = (0.01 * g / (1.2 * std::f64::consts::PI * 0.0025_f64)).sqrt();
    let turn: f64 = g * t / w;
    let (speed, way) = (w * turn.tanh(), w * w / g * turn.cosh().ln());
    assert_answers(&answer, &[-speed, 10.0 - way, 0.0], 1e-7);
}

/// Without weight and drag Magnus' force turns the way into a circle, at ρ·π·r³·C_m·ω/(2·m) a second.
#[test]
fn lift_alone_bends_the_way_into_a_circle() {
    let answer = answered(
        "friction = 0
restitution = 1
[air]
density_kg_m3 = 1.2
lift_coefficient = 1
[[body]]
mass_kg = 0.001
radius_m = 0.05
position_m = [0, 0]
velocity_m_s = [2, 0]
spin_rad_s = 20
[until]
duration_s = 1
[ask]
x_m = 1e-7
y_m = 1e-7
v_x_m_s = 1e-7
v_y_m_s = 1e-7
omega_rad_s = 0
",
    );
    let turn = 1.2 * std::f64::consts::PI * 0.000_125 * 20.0 / (2.0 * 0.001);
    let (sin, cos) = f64::sin_cos(turn);
    let expected = [2.0 * sin / turn, 2.0 * (1.0 - cos) / turn, 2.0 * cos, 2.0 * sin, 20.0];
    let asked: Vec<f64> = answer.lines.iter().map(|line| line.value).collect();
    for (value, expected) in asked.iter().zip(expected) {
        assert!((value - expected).abs() < 1e-9, "{asked:?}");
    }
    // the lift is upwards: spin from x to y is backspin of what flies along x
    assert!(asked[1] > 0.0);
}

/// The way of the ball by the midpoint rule with its error taken off: two grids, a sixteenth and a
/// thirty-second of a millisecond, and events by a straight line within a step.
#[test]
fn a_ball_with_topspin_flies_and_bounces_as_by_another_integrator() {
    let answer = answered(include_str!("../../../../docs/scenes/table-tennis.toml"));
    let coarse = by_midpoints(1.0 / 16_384.0);
    let fine = by_midpoints(1.0 / 32_768.0);
    for (line, (a, b)) in answer.lines.iter().zip(coarse.iter().zip(&fine)) {
        let better = b + (b - a) / 3.0;
        let noise = (b - a).abs();
        let off = (line.value - better).abs();
        assert!(noise < line.tolerance * 10.0, "{}: {a} {b}", line.quantity);
        assert!(off <= line.tolerance.max(noise), "{}: {} {better}", line.quantity, line.value);
        assert!(line.error.is_some_and(|error| error <= line.tolerance), "{line:?}");
    }
    // an f64 that is followed in steps is no exact model, and none in shorter or longer floats is tried
    assert!(answer.judged.iter().all(|judged| judged.model.to_string().ends_with("/f64")));
    assert!(answer.reasons[0].contains("no bound"), "{}", answer.reasons[0]);
}

/// Time, x, `v_x`, `v_y` and ω after the second impact of the shipped ball.
fn by_midpoints(step: f64) -> [f64; 5] {
    let (g, r, mass): (f64, f64, f64) = (9.81, 0.02, 0.0027);
    let part = 1.2 * std::f64::consts::PI * r * r / (2.0 * mass);
    let mut state = [0.0, 0.3, 9.0, 3.0];
    let mut omega = -600.0;
    let slope = |[_, _, vx, vy]: [f64; 4], omega: f64| {
        let speed = f64::hypot(vx, vy);
        let (drag, lift) = (0.5 * part * speed, 0.6 * part * r * omega);
        [vx, vy, -drag * vx - lift * vy, -drag * vy + lift * vx - g]
    };
    let stepped = |state: [f64; 4], omega: f64, step: f64| {
        let first = slope(state, omega);
        let middle = std::array::from_fn(|k| state[k] + step / 2.0 * first[k]);
        let second = slope(middle, omega);
        std::array::from_fn::<f64, 4, _>(|k| state[k] + step * second[k])
    };
    let (mut time, mut impacts) = (0.0, 0);
    while impacts < 2 {
        let next = stepped(state, omega, step);
        if next[1] >= r {
            (state, time) = (next, time + step);
            continue;
        }
        // the secant in the step, mended thrice
        let mut part = step * (state[1] - r) / (state[1] - next[1]);
        for _ in 0..3 {
            let there = stepped(state, omega, part);
            part += (there[1] - r) / -there[3];
        }
        state = stepped(state, omega, part);
        time += part;
        impacts += 1;
        // a hollow sphere, J = 2/3·m·r²: friction stops the slip, or slides
        let normal = mass * 1.9 * -state[3];
        let slip = state[2] + omega * r;
        let friction = -slip.signum() * (slip.abs() * mass / 2.5).min(0.25 * normal);
        state[1] = r;
        state[2] += friction / mass;
        state[3] *= -0.9;
        omega += friction / (2.0 / 3.0 * mass * r);
    }
    [time, state[0], state[2], state[3], omega]
}

#[test]
fn what_does_not_go_in_air_says_so() {
    let text = include_str!("../../../../docs/scenes/table-tennis.toml");
    let rest = text.replace("impacts = 2", "rest = true");
    let refused = tried(&rest);
    let refused = refused.expect_err("it has no closed form").to_string();
    assert!(refused.contains("a flight in air is followed in floats"), "{refused}");
    for (change, with, message) in [
        ("density_kg_m3 = 1.2", "density_kg_m3 = -1", "must be at least 0"),
        ("density_kg_m3 = 1.2", "", "missing field `density_kg_m3`"),
        ("drag_coefficient", "drag", "unknown field `drag`"),
    ] {
        let bad = text.replacen(change, with, 1);
        let fault = read::scene("bad.toml", &bad).expect_err(with);
        assert!(fault.message.contains(message), "{}", fault.message);
    }
}

/// The parts of the ledger, the work of the air among them, are the change of the kinetic energy.
#[test]
fn the_ledger_in_air_adds_up() {
    let answer = answered(include_str!("../../../../docs/scenes/table-tennis.toml"));
    let sums = answer.sums.last().expect("there are impacts");
    let [_, _, _, gravity, air] = sums.parts;
    assert!(air < -1e-3 && gravity > 0.0, "{:?}", sums.parts);
    let body = &answer.bounces.last().expect("there are impacts").after.0;
    let n = |shown: &kane_scene::Shown| shown.value;
    let [mass, inertia] = [n(&body.mass), n(&body.inertia)];
    let (vx, vy, omega) = (n(&body.motion.vx), n(&body.motion.vy), n(&body.motion.omega));
    let after = (mass * (vx * vx + vy * vy) + inertia * omega * omega) / 2.0;
    let parts: f64 = sums.parts.iter().sum();
    assert!((answer.start_energy + parts - after).abs() < 1e-9, "{parts} {after}");
}

/// A ball that is thrown faster than anything is: the air takes nearly all of its speed while it flies a part of its radius. Its
/// picture once took steps as short as the first one all the way.
#[test]
fn a_picture_in_air_takes_the_steps_of_the_motion() {
    let answer = answered(
        "friction = 0.25
restitution = 0.9
gravity_m_s2 = 9.81
floor_m = 0
[air]
density_kg_m3 = 1.2
drag_coefficient = 0.5
lift_coefficient = 0.6
[[body]]
mass_kg = 0.0027
radius_m = 0.02
shape = \"hollow-sphere\"
position_m = [0, 0.3]
velocity_m_s = [3e20, 3]
spin_rad_s = -600
[until]
impacts = 2
[ask]
time_s = 1e-6
",
    );
    let Some(Picture::Motion(strobe)) = &answer.picture else { panic!("a motion") };
    let end = answer.end.expect("it ends");
    let [x, y] = *strobe.paths[0].last().expect("a path");
    let [to_x, to_y] = end.bodies[0].position.clone().map(|at| at.value);
    // its steps are four times as long as those of the motion
    let far = to_x.abs().max(1.0);
    assert!((x - to_x).abs() < 1e-3 * far && (y - to_y).abs() < 1e-3, "{x} {y}, {to_x} {to_y}");
}

/// Air like a solid, in which a ball takes millions of steps to fall; and a fall of a million radii.
#[test]
fn a_flight_of_too_many_steps_is_not_followed_to_its_end() {
    for (density, fall) in [("2e7", 1), ("1", 10_000)] {
        let scene = format!(
            "friction = 0.25
restitution = 0.9
gravity_m_s2 = 9.81
floor_m = 0
[air]
density_kg_m3 = {density}
drag_coefficient = 1
lift_coefficient = 0.6
[[body]]
mass_kg = 0.0027
radius_m = 0.02
position_m = [0, {fall}]
velocity_m_s = [9, 3]
spin_rad_s = -600
[until]
impacts = 2
[ask]
time_s = 1e-6
"
        );
        let refused = tried(&scene).expect_err("nothing answers").to_string();
        assert!(refused.contains("more steps than are made"), "{refused}");
    }
}
