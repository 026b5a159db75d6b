//! Bodies with corners, against closed forms and what no law may change.

use kane_number::{Rational, parse};
use kane_scene::{Known, read};

use crate::{answered, assert_values, tried};

fn fault(text: &str) -> String {
    read::scene("tumbling.toml", text).expect_err("something is wrong").to_string()
}

const FLOOR: &str = "gravity_m_s2 = 9.81\nfloor_m = 0\n";

/// Angular momentum about the corner that is struck stays: ω⁺/ω = 1 − 3/2·sin²a for a uniform block, after
/// G. W. Housner, Bull. Seismol. Soc. Am. 53 (1963) 403-417, from memory; derived anew.
#[test]
fn a_rocking_block_keeps_the_share_of_its_spin_that_housner_gives() {
    let answer = answered(include_str!("../../../../docs/scenes/tumbling-brick.toml"));
    let n = |text: &str| parse(text).expect("a number");
    let (half_width, half_height) = (n("0.3"), n("0.8"));
    let square = |x: &Rational| x * x;
    let sine = square(&half_width) / (square(&half_width) + square(&half_height));
    let kept = n("1") - n("3/2") * sine;
    // it turns about the other corner then, at -b, h
    let expected = [-kept.clone(), kept.clone() * &half_height, kept * half_width];
    for (line, expected) in answer.lines.iter().zip(expected) {
        assert_eq!(line.exact, Some(expected.to_string()), "{}", line.quantity);
        assert_eq!(line.error, Some(0.0));
    }
    assert_eq!(answer.known, Some(Known::Exactly));
    let corner = answer.bounces[0].corner.as_ref().map(|(corner, _)| *corner);
    assert_eq!(corner, Some(1));
}

/// Without friction an end of a rod at the angle θ meets the floor with `W_nn` = (1 + 3·cos²θ)/m.
#[test]
fn a_rod_without_friction_strikes_with_one_end_and_then_with_the_other() {
    let text = "friction = 0
restitution = 0.5
gravity_m_s2 = 9.81
floor_m = 0
[rod]
mass_kg = 0.3
length_m = 1
half_tangent = \"1/3\"
position_m = [0, 1.3]
velocity_m_s = [0.25, 0]
[until]
impacts = 2
[ask]
time_s = 1e-10
omega_rad_s = 1e-8
v_y_m_s = 1e-9
x_m = 1e-9
turned_rad = 1e-9
";
    let (g, length, mass, e) = (9.81_f64, 1.0_f64, 0.3_f64, 0.5_f64);
    // tan(θ/2) = 1/3
    let (sin, cos) = (0.6_f64, 0.8_f64);
    let height = 1.3 - length / 2.0 * sin;
    let fall = (2.0 * height / g).sqrt();
    let speed = g * fall;
    let push = (1.0 + e) * speed * mass / (1.0 + 3.0 * cos * cos);
    // the left end is the lower one, and a push on it turns the rod towards x from y
    let (vy, omega) =
        (push / mass - speed, -push * length / 2.0 * cos * 12.0 / (mass * length * length));
    // the other end is at y + l/2·sin(θ + ω·t)
    let angle = sin.atan2(cos);
    let end = |t: f64| {
        let centre = length / 2.0 * sin + vy * t - g * t * t / 2.0;
        centre + length / 2.0 * (angle + omega * t).sin()
    };
    let (mut low, mut high) = (0.0_f64, 0.0_f64);
    while end(high) > 0.0 {
        (low, high) = (high, high + 1e-4);
    }
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if end(middle) > 0.0 { low = middle } else { high = middle }
    }
    let turned = omega * high;
    let reach = length / 2.0 * (angle + turned).cos();
    let down = vy - g * high;
    let closing = -(down + omega * reach);
    let push = (1.0 + e) * closing / (1.0 / mass + reach * reach * 12.0 / (mass * length * length));
    let expected = [
        fall + high,
        omega + push * reach * 12.0 / (mass * length * length),
        down + push / mass,
        0.25 * (fall + high),
        turned,
    ];
    let answer = answered(text);
    assert_eq!(answer.known, Some(Known::Enclosed));
    assert_values(&answer, &expected, 1e-9);
    for line in &answer.lines {
        assert!(line.error.is_some_and(|error| error <= line.tolerance), "{line:?}");
    }
    let corners: Vec<usize> =
        answer.bounces.iter().filter_map(|bounce| Some(bounce.corner.as_ref()?.0)).collect();
    assert_eq!(corners, [0, 1]);
}

const THROWN: &str = "[polygon]
mass_kg = 0.7
corners_m = [[0, 0], [0.5, 0], [0.6, 0.2], [0.1, 0.4]]
angle_deg = 20
position_m = [0, 1]
velocity_m_s = [1.5, 1]
spin_rad_s = 5
[until]
impacts = 5
";

#[test]
fn nothing_is_lost_without_friction_and_with_full_restitution() {
    let ask = "[ask]\nenergy_ratio = 1e-9\n";
    let answer = answered(&format!("friction = 0\nrestitution = 1\n{FLOOR}{THROWN}{ask}"));
    let line = &answer.lines[0];
    assert!((line.value - 1.0).abs() < 1e-12, "{}", line.value);
    assert_eq!(answer.bounces.len(), 5);
}

/// The kinetic energy after each impact is that at the start and what the ledger says.
#[test]
fn the_ledger_of_a_tumbling_body_adds_up() {
    let wall = "[[wall]]
through_m = [3, 0]
half_tangent = 1
sliding_m_s = 0.7
advancing_m_s = 0.4
";
    let ask = "[ask]\nkinetic_energy_j = 1e-6\n";
    let text = format!("friction = 0.3\nrestitution = 0.8\n{FLOOR}{wall}{THROWN}{ask}");
    let answer = answered(&text);
    let sums = answer.sums.last().expect("there are impacts");
    let gained: f64 = sums.parts.iter().sum();
    let after = answer.lines[0].value;
    assert!((answer.start_energy + gained - after).abs() < 1e-9, "{gained} {after}");
    assert!(answer.bounces.iter().any(|bounce| bounce.ledger.tangential.value != 0.0));
}

/// A floor that slides and rises is the same as a body that moves the other way.
#[test]
fn a_moving_floor_is_a_floor_at_rest_seen_from_elsewhere() {
    let body = |speed: &str| {
        format!(
            "[polygon]
mass_kg = 0.7
corners_m = [[0, 0], [0.5, 0], [0.6, 0.2], [0.1, 0.4]]
position_m = [0, 1]
velocity_m_s = {speed}
spin_rad_s = 5
[until]
impacts = 3
[ask]
time_s = 1e-9
omega_rad_s = 1e-9
turned_rad = 1e-9
v_x_m_s = 1e-9
"
        )
    };
    let wall = |more: &str| format!("[[wall]]\nthrough_m = [0, 0]\nangle_deg = 0\n{more}");
    let terms = "friction = 0.3\nrestitution = 0.8\ngravity_m_s2 = 9.81\n";
    let moved = "sliding_m_s = 0.5\nadvancing_m_s = 0.25\n";
    let moving = answered(&format!("{terms}{}{}", wall(moved), body("[1.5, 1.25]")));
    let at_rest = answered(&format!("{terms}{}{}", wall(""), body("[1, 1]")));
    let mut seen: Vec<f64> = at_rest.lines.iter().map(|line| line.value).collect();
    seen[3] += 0.5;
    assert_values(&moving, &seen, 1e-9);
}

#[test]
fn what_lands_flat_or_stays_has_no_answer() {
    let body = "[polygon]
mass_kg = 1
corners_m = [[0, 0], [1, 0], [1, 1], [0, 1]]
position_m = [0, 2]
velocity_m_s = [0, 0]
[until]
impacts = 1
[ask]
v_y_m_s = 0.1
";
    let flat = tried(&format!("friction = 0.3\nrestitution = 0.5\n{FLOOR}{body}"));
    let why = flat.expect_err("two corners arrive at once").to_string();
    assert!(why.contains("two corners meet walls at once"), "{why}");
    let turned = body.replace("[until]\nimpacts = 1", "angle_deg = 30\n[until]\nimpacts = 2");
    let stays = tried(&format!("friction = 0.3\nrestitution = 0\n{FLOOR}{turned}"));
    let why = stays.expect_err("a corner stays").to_string();
    assert!(why.contains("lies on a wall"), "{why}");
}

#[test]
fn what_is_not_described_of_a_body_with_corners_is_a_fault() {
    let top = "friction = 0.3\nrestitution = 0.5\n";
    let text = |top: &str, more: &str| format!("{top}{FLOOR}{more}{THROWN}[ask]\nx_m = 1\n");
    let air = fault(&text(top, "[air]\ndensity_kg_m3 = 1\n"));
    assert!(air.contains("are for round bodies"), "{air}");
    let rolls = fault(&text(&format!("{top}rolling_resistance = 0.1\n"), ""));
    assert!(rolls.contains("are for round bodies"), "{rolls}");
    let springs = fault(&text(&format!("{top}poisson_ratio = 0.3\n"), ""));
    assert!(springs.contains("round bodies alone"), "{springs}");
    let inside = fault(&text(top, "").replace("position_m = [0, 1]", "position_m = [0, 0.1]"));
    assert!(inside.contains("is inside the floor"), "{inside}");
    let clockwise = fault(&text(top, "").replace("[0.1, 0.4]]", "[0.1, -0.4]]"));
    assert!(clockwise.contains("counterclockwise"), "{clockwise}");
    let round = "[[body]]\nmass_kg = 1\nradius_m = 1\nposition_m = [0, 2]\nvelocity_m_s = [0, 0]\n";
    let asked = format!("{top}{FLOOR}{round}[until]\nimpacts = 1\n[ask]\nturned_rad = 1\n");
    assert!(fault(&asked).contains("is of a [polygon] or a [rod]"));
    let two = text(top, "").replace("x_m = 1", "turned_rad_of_2 = 1");
    assert!(fault(&two).contains("counted from 1"));
}
