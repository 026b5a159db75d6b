//! A ball on the floor: it skids, rolls and stops, by formulas written out here.

use crate::{answered, assert_values};

const PUTT: &str = include_str!("../../../../docs/scenes/putt.toml");

/// x, `v_x` and ω of the putt after a time.
fn putt(time: &str) -> [f64; 3] {
    let text = PUTT.replacen("duration_s = 3", &format!("duration_s = {time}"), 1);
    let answer = answered(&text);
    for line in &answer.lines {
        assert!(line.error.is_some_and(|error| error <= line.tolerance), "{time}: {line:?}");
    }
    std::array::from_fn(|index| answer.lines[index].value)
}

#[track_caller]
fn assert_near(found: [f64; 3], expected: [f64; 3], near: f64) {
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() < near * (1.0 + expected.abs()), "{found} {expected}");
    }
}

/// A solid sphere: 5/7 of the speed, after 2·v/(7·μ·g) and on 12·v²/(49·μ·g).
#[test]
fn a_putt_rolls_with_five_sevenths_of_its_speed_and_stops() {
    let (v, r, skidding, rolling) = (2.5, 0.02135, 0.4 * 9.81, 0.08 * 9.81 * 5.0 / 7.0);
    // while it skids
    let t = 0.1;
    let skids = [v * t - skidding * t * t / 2.0, v - skidding * t, -2.5 * skidding * t / r];
    assert_near(putt("0.1"), skids, 1e-9);
    let (since, way, speed) =
        (2.0 * v / (7.0 * skidding), 12.0 * v * v / (49.0 * skidding), 5.0 / 7.0 * v);
    // while it rolls
    let t = 3.0 - since;
    let now = speed - rolling * t;
    assert!(now > 0.0);
    assert_near(putt("3"), [way + speed * t - rolling * t * t / 2.0, now, -now / r], 1e-9);
    // and where it lies, to the tolerance: as nothing else is asked than two zeros, f32 will do
    assert_near(putt("30"), [way + speed * speed / (2.0 * rolling), 0.0, 0.0], 1e-6);
}

#[test]
fn without_resistance_it_rolls_on() {
    let text = PUTT.replacen("rolling_resistance = 0.08\n", "", 1);
    assert_ne!(text, PUTT);
    let line = answered(&text).lines[1].clone();
    assert!((line.value - 2.5 * 5.0 / 7.0).abs() < 1e-12, "{line:?}");
}

/// Where the impacts have stopped the slip before the ball lies, it rolls all the same: floats and intervals do
/// not see it in what is left of the slip.
#[test]
fn a_ball_whose_slip_has_stopped_before_it_lies_rolls_to_its_stop() {
    let text = "friction = 0.894
restitution = 0.5
rolling_resistance = 0.04
gravity_m_s2 = 10
floor_m = 0
[[body]]
mass_kg = 1.517
radius_m = 0.052
mobility_ratio = 2
position_m = [0, 0.271]
velocity_m_s = [-1.79, -2.905]
[until]
duration_s = 9
[ask]
x_m = 1e-9
v_x_m_s = 1e-9
omega_rad_s = 1e-9
";
    let answer = answered(text);
    // half of v_x is left where the slip stops at the first impact, with up for what it leaves with
    let (g, vx) = (10.0_f64, -1.79_f64);
    let down = (2.905_f64 * 2.905 + 2.0 * g * (0.271 - 0.052)).sqrt();
    let first = (down - 2.905) / g;
    let rolls = vx / 2.0;
    let bouncing = 2.0 * (0.5 * down) / (g * 0.5);
    let slowing = 0.04 * g / 2.0;
    let way = vx * first + rolls * bouncing - rolls * rolls / (2.0 * slowing);
    assert_values(&answer, &[way, 0.0, 0.0], 1e-9);
}
