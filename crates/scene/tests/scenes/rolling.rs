//! A ball on the floor: it skids, rolls and stops, by formulas written out here.

use kane_impact::laws;
use kane_scene::{Effort, answer, read};

const PUTT: &str = include_str!("../../../../docs/scenes/putt.toml");

/// x, `v_x` and ω of the putt after a time.
fn putt(time: &str) -> [f64; 3] {
    let text = PUTT.replacen("duration_s = 3", &format!("duration_s = {time}"), 1);
    let scene = read::scene("putt.toml", &text).expect("the scene is well formed");
    let answer = answer(&scene, laws(), None, Effort::Chosen, &mut |_, _| {});
    let answer = answer.expect("there is an answer");
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
    let scene = read::scene("putt.toml", &text).expect("the scene is well formed");
    let answer = answer(&scene, laws(), None, Effort::Chosen, &mut |_, _| {});
    let line = answer.expect("there is an answer").lines[1].clone();
    assert!((line.value - 2.5 * 5.0 / 7.0).abs() < 1e-12, "{line:?}");
}
