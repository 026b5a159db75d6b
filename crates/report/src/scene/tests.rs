//! What the reports say of answers that are made up, in which each number is another one.
#![allow(clippy::float_arithmetic, reason = "numbers are made up")]

use kane_impact::Impulse;
use kane_impact::bodies::{Direction, Ledger, Motion};
use kane_number::{Rational, System};
use kane_scene::simulate::{Bounce, Encounter, End, Ending};
use kane_scene::stress::Row;
use kane_scene::{
    Air, Answer, Corners, Judged, Kind, Known, Line, Mechanics, Model, OffPlane, Place, Plane,
    Quantity, Restitution, Round, Setup, Shown, Side, Spread, Terms, Tip, TipBody, Verdict, Wall,
    World,
};
use num_traits::One as _;
use serde_json::{Value, json};

use super::json::stated_rows;
use super::*;

/// A number and its text, which is another one, so that neither stands for the other.
pub(super) fn shown(n: i32) -> Shown {
    Shown { value: f64::from(n), text: format!("{n}/1") }
}

pub(super) fn round(n: i32) -> Round<Shown> {
    Round {
        mass: shown(n),
        inertia: shown(n + 1),
        radius: shown(n + 2),
        position: [shown(n + 3), shown(n + 4)],
        motion: Motion { vx: shown(n + 5), vy: shown(n + 6), omega: shown(n + 7) },
        off_plane: None,
    }
}

fn in_space(n: i32) -> Round<Shown> {
    let off = OffPlane {
        z: shown(n + 8),
        vz: shown(n + 9),
        omega_x: shown(n + 10),
        omega_y: shown(n + 11),
    };
    Round { off_plane: Some(off), ..round(n) }
}

pub(super) fn world(bodies: Vec<Round<Shown>>) -> World<Shown> {
    World {
        gravity: shown(3),
        air: None,
        walls: Vec::new(),
        planes: Vec::new(),
        bodies,
        corners: None,
        friction: shown(1),
        restitution: shown(2),
        terms: Vec::new(),
        rolling: shown(0),
    }
}

pub(super) fn bounce(
    encounter: Encounter,
    after: Round<Shown>,
    other: Option<Round<Shown>>,
) -> Bounce<Shown> {
    Bounce {
        time: shown(101),
        encounter,
        regime: "stick",
        slip: [shown(102), shown(103)],
        approach: shown(104),
        separation: shown(105),
        impulse: Impulse { tangential: shown(106), normal: shown(107) },
        ledger: Ledger { normal: shown(108), tangential: shown(109), rotational: shown(110) },
        gravity: shown(111),
        air: None,
        axes: None,
        corner: None,
        after: (after, other),
    }
}

fn end(bodies: Vec<Round<Shown>>) -> End<Shown> {
    End { time: shown(200), bodies, impacts: 7, ending: Ending::Duration, turned: None }
}

pub(super) fn model(system: System) -> Model {
    Model { mechanics: Mechanics::NormalOnly, system }
}

/// An answer by normal impulses in fractions.
pub(super) fn answer(world: World<Shown>) -> Answer {
    Answer {
        sha256: "5ce0".to_owned(),
        stated: Setup::Bodies(world),
        lines: Vec::new(),
        known: Some(Known::Exactly),
        judged: Vec::new(),
        chosen: Some(model(System::Rational)),
        wanted: None,
        shown: model(System::Rational),
        reasons: vec!["Because.".to_owned()],
        bounces: Vec::new(),
        sums: Vec::new(),
        end: None,
        start_energy: 2.5,
        picture: None,
    }
}

pub(super) fn report(answer: &Answer) -> SceneReport<'_> {
    SceneReport {
        answer,
        title: "Made up".to_owned(),
        command: "kane scene made-up.toml".to_owned(),
        is_compared: false,
    }
}

fn told(answer: &Answer) -> Value {
    serde_json::from_str(&super::json(&report(answer))).expect("JSON")
}

pub(super) fn judged(verdict: Verdict) -> Judged {
    Judged { model: model(System::Rational), cost: 5, errors: Vec::new(), ratio: None, verdict }
}

fn line(kind: Kind, body: usize) -> Line {
    Line {
        quantity: Quantity { kind, body },
        value: 0.25,
        exact: Some("1/4".to_owned()),
        error: Some(0.0),
        tolerance: 0.5,
        spread: None,
    }
}

#[test]
fn numbers_have_eight_digits_and_no_zeros_behind_them() {
    let cases = [
        (0.0, "0"),
        (-0.0, "0"),
        (1.0, "1"),
        (-2.5, "-2.5"),
        (1.0 / 3.0, "0.33333333"),
        (-2.0 / 3.0, "-0.66666667"),
        (12.345_678_912, "12.345679"),
        (1.234_567_891_2, "1.2345679"),
        (123_456.789, "123456.79"),
        (999_999.0, "999999"),
        (300.0, "300"),
        // below and above these a power of ten is told
        (0.000_1, "0.0001"),
        (0.000_09, "9.00000e-5"),
        (1e6, "1.00000e6"),
        (-1.5e9, "-1.50000e9"),
    ];
    for (value, expected) in cases {
        assert_eq!(number(value), expected);
    }
}

#[test]
fn errors_have_two_digits_and_signs_stay() {
    let cases = [
        (0.0, "0"),
        (0.001_234, "0.0012"),
        (0.012_34, "0.012"),
        (0.123_4, "0.12"),
        (1.234, "1.2"),
        (-1.234, "-1.2"),
        (12.34, "12"),
        (12_345.6, "12346"),
        (100.0, "100"),
        (0.5, "0.5"),
        (0.000_99, "9.9e-4"),
        (1e5, "1.0e5"),
        (-2.5e-7, "-2.5e-7"),
    ];
    for (value, expected) in cases {
        assert_eq!(brief(value), expected);
    }
    assert_eq!([0.0, 0.123_4, -12.0].map(small), ["0", "1.2e-1", "-1.2e1"]);
}

#[test]
fn an_error_is_told_as_surely_as_it_is_known() {
    let told = |size: f64, known| error(Some(size), Some(known));
    for sure in [Known::Exactly, Known::Enclosed] {
        assert_eq!([told(0.0, sure), told(0.25, sure)], ["none", "at most 0.25"]);
    }
    // an estimate of zero is no proof
    let documented = [0.0, 0.25].map(|size| told(size, Known::Documented));
    assert_eq!(documented, ["0, documented", "0.25, documented"]);
    let estimated = [0.0, 0.25].map(|size| told(size, Known::Estimated));
    assert_eq!(estimated, ["0, estimated", "0.25, estimated"]);
    assert_eq!(error(None, Some(Known::Exactly)), "unknown");
    assert_eq!(error(Some(0.0), None), "unknown");
    let spread = |enclosed| Some(Spread { by: 0.5, at_least: 0.1, enclosed });
    assert_eq!(
        [moved(spread(true)), moved(spread(false)), moved(None)],
        ["within ±0.5", "±0.5 at corners", ""]
    );
}

#[test]
fn a_bound_is_never_told_as_less_than_it_is() {
    // 4.44e-15 is more than 4.4e-15
    let size = 4.440_892_098_500_626e-15;
    let told = |known| error(Some(size), Some(known));
    assert_eq!(told(Known::Enclosed), "at most 4.5e-15");
    assert_eq!(told(Known::Documented), "4.5e-15, documented");
    assert_eq!(told(Known::Estimated), "4.4e-15, estimated");
    let spread = |enclosed| Some(Spread { by: 2.31, at_least: 0.1, enclosed });
    assert_eq!([moved(spread(true)), moved(spread(false))], ["within ±2.4", "±2.3 at corners"]);
    // and a tolerance is told as it was stated
    assert_eq!([0.0, 1e-9, 0.05, 20.0].map(in_full), ["0", "1.0e-9", "0.05", "20"]);
    assert_eq!([1.25e-7, 0.001_23, 150.25].map(in_full), ["1.25e-7", "0.00123", "150.25"]);
}

#[test]
fn answers_that_are_rounded_are_said_to_be() {
    let said = |value: f64, exact: Option<&str>| {
        let mut answer = answer(world(vec![round(20)]));
        let exact = exact.map(str::to_owned);
        answer.lines = vec![Line { value, exact, ..line(Kind::K, 0) }];
        let told = sheet(&report(&answer)).text(crate::sheet::Page::default());
        told.contains("Answers are rounded here")
    };
    assert!(said(1.0 / 3.0, None));
    assert!(said(0.1, None), "the float is not a tenth");
    assert!(!said(0.25, None));
    assert!(!said(1.0 / 3.0, Some("1/3")));
    // a fraction that is too long to be shown
    assert!(said(0.25, Some("1000000000000/4000000000001")));
}

#[test]
fn bodies_are_counted_from_one() {
    let (wall, pair) = (Encounter::Wall(1, Side::Left), Encounter::Pair(0, 2));
    assert_eq!(ids(wall), ["body-2", "left"]);
    assert_eq!(ids(pair), ["body-1", "body-3"]);
    assert_eq!([who(wall, 2), who(pair, 3)], ["2, left wall", "1 and 3"]);
    // the only one needs no number
    assert_eq!(who(Encounter::Wall(0, Side::Floor), 1), "floor");
}

#[test]
fn costs_that_are_estimated_are_told_as_such() {
    let of = |mechanics| {
        let model = Model { mechanics, system: System::F64 };
        cost(&Judged { model, cost: 120, errors: vec![], ratio: None, verdict: Verdict::Meets })
    };
    assert_eq!(of(Mechanics::NormalOnly), "120");
    for steps in [Mechanics::Chain, Mechanics::Compliant, Mechanics::Annuli] {
        assert_eq!(of(steps), "about 120");
    }
}

#[test]
fn what_is_said_of_a_model_has_its_reason() {
    let quantity = Quantity { kind: Kind::K, body: 0 };
    let misses = |place| verdict(&Verdict::Misses { quantity, by: 0.125, place }, None);
    assert_eq!(misses(Place::Stated), "k off by 0.12");
    assert_eq!(misses(Place::Corner), "k off by 0.12 within the uncertainty");
    assert_eq!(misses(Place::Near), "k off by 0.12 within 1%");
    let meets = |known| verdict(&Verdict::Meets, known);
    assert_eq!(meets(Some(Known::Exactly)), "good enough");
    assert_eq!(meets(Some(Known::Enclosed)), "good enough");
    assert_eq!(meets(Some(Known::Documented)), "good enough as documented");
    assert_eq!(meets(Some(Known::Estimated)), "good enough by an estimate");
    assert_eq!(verdict(&Verdict::Uncertified("too long"), None), "not certified: too long");
    assert_eq!(verdict(&Verdict::Fails("no root".to_owned()), None), "no answer: no root");
}

#[test]
fn the_headline_says_by_which_model_and_how_surely() {
    let mut answer = answer(world(vec![round(20)]));
    answer.judged = vec![judged(Verdict::Meets)];
    answer.lines = vec![line(Kind::K, 0)];
    let model = "normal-only/rational";
    let one = format!("{model}: what is asked for is within its tolerance");
    assert_eq!(report(&answer).headline(), one);
    answer.known = Some(Known::Estimated);
    assert_eq!(report(&answer).headline(), format!("{one}, by an estimate"));
    answer.known = Some(Known::Documented);
    assert_eq!(report(&answer).headline(), format!("{one}, as documented"));
    answer.known = Some(Known::Exactly);
    // the inputs move it by more than was asked: known of at least so much
    answer.lines[0].spread = Some(Spread { by: 2.0, at_least: 0.75, enclosed: true });
    assert_eq!(report(&answer).headline(), format!("{one}; the inputs leave more open"));
    answer.lines[0].spread = Some(Spread { by: 2.0, at_least: 0.25, enclosed: true });
    answer.lines.push(line(Kind::Energy, 0));
    let all = format!("{model}: all that is asked for is within its tolerance");
    assert_eq!(report(&answer).headline(), all);
}

#[test]
fn a_model_that_is_not_good_enough_is_never_told_as_one_that_is() {
    let mut answer = answer(world(vec![round(20)]));
    let model = "normal-only/rational";
    let quantity = Quantity { kind: Kind::K, body: 0 };
    let misses = Verdict::Misses { quantity, by: 1.0, place: Place::Stated };
    answer.judged = vec![judged(misses)];
    answer.chosen = None;
    answer.wanted = Some(answer.shown);
    let headline = |answer: &Answer| report(answer).headline();
    assert_eq!(headline(&answer), format!("{model}, the model asked for, is not good enough"));
    answer.judged = vec![judged(Verdict::Uncertified("why"))];
    let not_known = format!("{model}, the model asked for, is not known to be good enough");
    assert_eq!(headline(&answer), not_known);
    // that another one is good enough says nothing of this one
    answer.judged = vec![Judged { model: self::model(System::F32), ..judged(Verdict::Meets) }];
    assert_eq!(headline(&answer), not_known);
    let none = format!("no model is known to be good enough; shown is {model}");
    let compared = SceneReport { is_compared: true, ..report(&answer) };
    assert_eq!(compared.headline(), none);
    answer.wanted = None;
    assert_eq!(headline(&answer), none);
    answer.chosen = Some(self::model(System::F32));
    let other = format!("{model} is not known to be good enough; normal-only/f32 is");
    assert_eq!(headline(&answer), other);
}

#[test]
fn each_number_that_a_scene_states_is_told_under_its_name() {
    let mut world = world(vec![round(20), round(30)]);
    world.air = Some(Air { density: shown(5), drag: shown(6), lift: shown(7) });
    world.rolling = shown(4);
    world.walls =
        vec![Wall { side: Side::Floor, at: shown(8) }, Wall { side: Side::Right, at: shown(9) }];
    let plane = |n: i32| Plane {
        normal: [shown(n), shown(n + 1)],
        through: [shown(n + 2), shown(n + 3)],
        velocity: [shown(n + 4), shown(n + 5)],
    };
    world.planes = vec![plane(50), plane(60)];
    let terms = |between, friction: Option<i32>, restitution| Terms {
        between,
        friction: friction.map(shown),
        restitution,
    };
    world.terms = vec![
        terms(Some(Encounter::Pair(0, 1)), Some(10), Some(Restitution::Constant(shown(11)))),
        terms(
            Some(Encounter::Wall(1, Side::Floor)),
            None,
            Some(Restitution::QuarterPower { speed: shown(12), value: shown(13) }),
        ),
        terms(None, Some(14), None),
        terms(
            None,
            None,
            Some(Restitution::Table(vec![[shown(15), shown(16)], [shown(17), shown(18)]])),
        ),
    ];
    let answer = answer(world);
    let mut expected = vec![
        ("all", "friction", 1.0),
        ("all", "restitution", 2.0),
        ("all", "gravity_m_s2", 3.0),
        ("all", "rolling_resistance", 4.0),
        ("all", "density_kg_m3", 5.0),
        ("all", "drag_coefficient", 6.0),
        ("all", "lift_coefficient", 7.0),
        ("floor", "at_m", 8.0),
        ("right", "at_m", 9.0),
    ];
    for (wall, n) in [("wall-1", 50.0), ("wall-2", 60.0)] {
        expected.extend([
            (wall, "normal_x", n),
            (wall, "normal_y", n + 1.0),
            (wall, "through_x_m", n + 2.0),
            (wall, "through_y_m", n + 3.0),
            (wall, "sliding_m_s", n + 4.0),
            (wall, "advancing_m_s", n + 5.0),
        ]);
    }
    expected.extend([
        ("body-1, body-2", "friction", 10.0),
        ("body-1, body-2", "restitution", 11.0),
        ("body-2, floor", "restitution", 13.0),
        ("body-2, floor", "restitution_at_m_s", 12.0),
        ("all", "friction", 14.0),
        ("all", "speed_m_s", 15.0),
        ("all", "restitution", 16.0),
        ("all", "speed_m_s", 17.0),
        ("all", "restitution", 18.0),
    ]);
    for (body, n) in [("body-1", 20.0), ("body-2", 30.0)] {
        expected.extend([
            (body, "mass_kg", n),
            (body, "radius_m", n + 2.0),
            (body, "inertia_kg_m2", n + 1.0),
            (body, "x_m", n + 3.0),
            (body, "y_m", n + 4.0),
            (body, "v_x_m_s", n + 5.0),
            (body, "v_y_m_s", n + 6.0),
            (body, "omega_rad_s", n + 7.0),
        ]);
    }
    let rows = stated_rows(&answer);
    let rows: Vec<(&str, &str, f64)> =
        rows.iter().map(|(of, name, value)| (of.as_str(), *name, *value)).collect();
    assert_eq!(rows, expected);
    let scene = &told(&answer)["scene"];
    assert_eq!(scene["sha256"], "5ce0");
    assert_eq!(
        scene["walls"][1],
        json!({ "id": "right", "at_m": 9.0, "exact": { "at_m": "9/1" } })
    );
    assert_eq!(
        scene["contacts"][3],
        json!({ "between": null, "exact": {}, "by_speed": [
            { "speed_m_s": 15.0, "restitution": 16.0,
              "exact": { "speed_m_s": "15/1", "restitution": "16/1" } },
            { "speed_m_s": 17.0, "restitution": 18.0,
              "exact": { "speed_m_s": "17/1", "restitution": "18/1" } },
        ] })
    );
    assert_eq!(scene["contacts"][0]["between"], json!(["body-1", "body-2"]));
    assert_eq!(scene["contacts"][0]["friction"], 10.0);
}

#[test]
fn a_body_with_corners_has_no_radius() {
    let mut world = world(vec![round(20)]);
    world.corners = Some(Corners(vec![[shown(70), shown(71)], [shown(72), shown(73)]]));
    let rows = stated_rows(&answer(world));
    let of = |wanted: &str| -> Vec<(&'static str, f64)> {
        rows.iter().filter(|row| row.0 == wanted).map(|row| (row.1, row.2)).collect()
    };
    assert_eq!(of("corner-1"), [("x_m", 70.0), ("y_m", 71.0)]);
    assert_eq!(of("corner-2"), [("x_m", 72.0), ("y_m", 73.0)]);
    let names: Vec<&str> = of("body-1").into_iter().map(|(name, _)| name).collect();
    let expected = ["mass_kg", "inertia_kg_m2", "x_m", "y_m", "v_x_m_s", "v_y_m_s", "omega_rad_s"];
    assert_eq!(names, expected);
}

#[test]
fn a_tip_states_what_it_is_of() {
    let one = || Direction { cos: Rational::one(), sin: Rational::one() };
    let tip = |body| {
        let tip = Tip { body, friction: shown(1), restitution: shown(2) };
        let mut answer = answer(world(vec![]));
        answer.stated = Setup::Tip(tip);
        stated_rows(&answer)
    };
    let row = |of: &str, name, n| (of.to_owned(), name, n);
    let all = [row("all", "friction", 1.0), row("all", "restitution", 2.0)];
    let motion = Motion { vx: shown(5), vy: shown(6), omega: shown(7) };
    let rod = tip(TipBody::Rod { mass: shown(3), length: shown(4), direction: one(), motion });
    let body = [
        row("body-1", "mass_kg", 3.0),
        row("body-1", "length_m", 4.0),
        row("body-1", "v_x_m_s", 5.0),
        row("body-1", "v_y_m_s", 6.0),
        row("body-1", "omega_rad_s", 7.0),
    ];
    assert_eq!(rod, [&all[..], &body].concat());
    let pendulum = tip(TipBody::Pendulum {
        mass: shown(3),
        length: shown(4),
        angles: [one(), one()],
        speeds: [shown(8), shown(9)],
    });
    let body = [
        row("body-1", "mass_kg", 3.0),
        row("body-1", "length_m", 4.0),
        row("body-1", "u1_rad_s", 8.0),
        row("body-1", "u2_rad_s", 9.0),
    ];
    assert_eq!(pendulum, [&all[..], &body].concat());
}

#[test]
fn an_impact_is_told_number_by_number_and_exactly_where_the_model_is_exact() {
    let mut answer = answer(world(vec![round(20), round(30)]));
    answer.bounces = vec![bounce(Encounter::Pair(1, 0), round(40), Some(round(50)))];
    answer.bounces[0].air = Some(shown(112));
    answer.end = Some(end(vec![round(60), round(70)]));
    let state = |id: &str, n: i32| {
        let texts = (3..8).map(|k| format!("{}/1", n + k)).collect::<Vec<_>>();
        let n = f64::from(n);
        json!({
            "id": id, "x_m": n + 3.0, "y_m": n + 4.0, "v_x_m_s": n + 5.0, "v_y_m_s": n + 6.0,
            "omega_rad_s": n + 7.0,
            "exact": { "x_m": texts[0], "y_m": texts[1], "v_x_m_s": texts[2], "v_y_m_s": texts[3],
                "omega_rad_s": texts[4] },
        })
    };
    let told_of = told(&answer);
    assert_eq!(
        told_of["impacts"],
        json!([{
            "who": ["body-2", "body-1"],
            "regime": "stick",
            "time_s": 101.0,
            "v_t_before_m_s": 102.0,
            "v_t_after_m_s": 103.0,
            "approach_m_s": 104.0,
            "separation_m_s": 105.0,
            "p_t_n_s": 106.0,
            "p_n_n_s": 107.0,
            "normal_j": 108.0,
            "tangential_j": 109.0,
            "rotational_j": 110.0,
            "gravity_j": 111.0,
            "air_j": 112.0,
            "exact": {
                "time_s": "101/1", "v_t_before_m_s": "102/1", "v_t_after_m_s": "103/1",
                "approach_m_s": "104/1", "separation_m_s": "105/1", "p_t_n_s": "106/1",
                "p_n_n_s": "107/1", "normal_j": "108/1", "tangential_j": "109/1",
                "rotational_j": "110/1", "gravity_j": "111/1", "air_j": "112/1",
            },
            "after": [state("body-2", 40), state("body-1", 50)],
        }])
    );
    assert_eq!(
        told_of["end"],
        json!({
            "impacts": 7, "time_s": 200.0, "exact": { "time_s": "200/1" },
            "bodies": [state("body-1", 60), state("body-2", 70)],
        })
    );
    assert_eq!(told_of["kinetic_energy_at_start_j"], 2.5);
    assert_eq!(told_of["shown"], "normal-only/rational");
    // a float is not exact, whatever the scene says
    answer.shown = model(System::F64);
    let told_of = told(&answer);
    assert_eq!(told_of["end"]["bodies"][0].get("exact"), None);
    assert_eq!(told_of["impacts"][0].get("exact"), None);
    assert_eq!(told_of["scene"]["exact"]["friction"], "1/1");
}

#[test]
fn zero_has_no_sign() {
    let mut answer = answer(world(vec![round(20)]));
    let mut still = round(20);
    still.motion.vx = Shown { value: -0.0, text: "0".to_owned() };
    answer.end = Some(end(vec![still]));
    let text = super::json(&report(&answer));
    assert!(text.contains("\"v_x_m_s\": 0.0,"), "{text}");
    assert!(!text.contains("-0.0"), "{text}");
}

#[test]
fn a_sphere_in_space_and_a_body_with_corners_have_more_numbers() {
    let mut answer = answer(world(vec![in_space(20)]));
    let mut of = bounce(Encounter::Wall(0, Side::Floor), in_space(40), None);
    of.axes = Some([[shown(121), shown(122), shown(123)], [shown(124), shown(125), shown(126)]]);
    of.corner = Some((2, shown(127)));
    answer.bounces = vec![of];
    answer.end = Some(End { turned: Some(shown(201)), ..end(vec![in_space(60)]) });
    let told = told(&answer);
    let impact = &told["impacts"][0];
    assert_eq!(impact["corner"], 3);
    assert_eq!(impact["who"], json!(["body-1", "floor"]));
    let names = [
        ("tangent_x", 121.0),
        ("tangent_y", 122.0),
        ("tangent_z", 123.0),
        ("normal_x", 124.0),
        ("normal_y", 125.0),
        ("normal_z", 126.0),
        ("turned_rad", 127.0),
    ];
    for (name, value) in names {
        assert_eq!(impact[name], value, "{name}");
    }
    assert_eq!(told["end"]["turned_rad"], 201.0);
    for (state, n) in [(&impact["after"][0], 40.0), (&told["end"]["bodies"][0], 60.0)] {
        let names =
            [("z_m", 8.0), ("v_z_m_s", 9.0), ("omega_x_rad_s", 10.0), ("omega_y_rad_s", 11.0)];
        for (name, k) in names {
            assert_eq!(state[name], n + k, "{name}");
        }
    }
}

#[test]
fn what_was_asked_is_told_with_its_error_and_what_the_inputs_do() {
    let mut answer = answer(world(vec![round(20)]));
    let spread = |enclosed| Some(Spread { by: 0.75, at_least: 0.1, enclosed });
    answer.lines = vec![
        Line { spread: spread(true), ..line(Kind::Vx, 1) },
        Line { spread: spread(false), exact: None, error: None, ..line(Kind::Time, 0) },
        line(Kind::K, 0),
    ];
    answer.known = Some(Known::Enclosed);
    let told_of = told(&answer);
    let asked = |quantity: &str, unit: &str, exact: Value, error: Value, by: Value, are: Value| {
        json!({
            "quantity": quantity, "unit": unit, "value": 0.25, "exact": exact, "error": error,
            "error_is": "enclosed", "tolerance": 0.5, "inputs_move_it_by": by, "inputs_are": are,
        })
    };
    let none = Value::Null;
    let expected = [
        asked("v_x_m_s_of_2", "m/s", json!("1/4"), json!(0.0), json!(0.75), json!("enclosed")),
        asked("time_s", "s", none.clone(), none.clone(), json!(0.75), json!("at corners")),
        asked("k", "", json!("1/4"), json!(0.0), none.clone(), none.clone()),
    ];
    assert_eq!(told_of["asked"], Value::from(expected.to_vec()));
    answer.known = None;
    assert_eq!(told(&answer)["asked"][0]["error_is"], none);
}

/// Three models: one that is good enough, one that takes steps, and one whose error is unknown.
fn tried() -> Answer {
    let mut answer = answer(world(vec![round(20)]));
    answer.judged = vec![
        Judged { errors: vec![Some(0.5)], ratio: Some(0.125), ..judged(Verdict::Meets) },
        Judged {
            model: Model { mechanics: Mechanics::Chain, system: System::F64 },
            cost: 70,
            errors: vec![None],
            ratio: Some(8.0),
            verdict: Verdict::Fails("no, none".to_owned()),
        },
        Judged { cost: 9, ..judged(Verdict::Uncertified("too long")) },
    ];
    answer.known = Some(Known::Estimated);
    answer
}

#[test]
fn each_model_that_was_tried_is_told_with_its_cost_and_its_error() {
    let told = told(&tried());
    let expected = json!([
        { "model": "normal-only/rational", "cost": 5, "cost_is": "counted", "errors": [0.5],
          "errors_are": "estimated", "error_by_tolerance": 0.125, "good_enough": true,
          "verdict": "good enough by an estimate" },
        { "model": "chain/f64", "cost": 70, "cost_is": "estimated", "errors": [null],
          "errors_are": "estimated", "error_by_tolerance": 8.0, "good_enough": false,
          "verdict": "no answer: no, none" },
        { "model": "normal-only/rational", "cost": 9, "cost_is": "counted", "errors": [],
          "errors_are": null, "error_by_tolerance": null, "good_enough": false,
          "verdict": "not certified: too long" },
    ]);
    assert_eq!(told["models"], expected);
    let csv = "model,cost,cost_is,error_by_tolerance,error_is,verdict\n\
        normal-only/rational,5,counted,1.25e-1,estimated,good enough by an estimate\n\
        chain/f64,70,estimated,8e0,estimated,\"no answer: no, none\"\n\
        normal-only/rational,9,counted,,,not certified: too long\n";
    assert_eq!(models_csv(&report(&tried())), csv);
}

#[test]
fn rows_of_states_have_a_cell_for_each_name() {
    let mut answer = answer(world(vec![round(20), round(30)]));
    answer.bounces = vec![
        bounce(Encounter::Wall(1, Side::Floor), round(40), None),
        bounce(Encounter::Pair(0, 1), round(50), Some(round(60))),
    ];
    answer.end = Some(end(vec![round(70), round(80)]));
    let csv = states_csv(&report(&answer));
    assert_eq!(
        csv,
        "impact,time_s,who,regime,body,x_m,y_m,v_x_m_s,v_y_m_s,omega_rad_s,\
         dT_normal_j,dT_tangential_j,dT_rotational_j,gravity_j\n\
         start,0,,,body-1,23/1,24/1,25/1,26/1,27/1,,,,\n\
         start,0,,,body-2,33/1,34/1,35/1,36/1,37/1,,,,\n\
         1,101/1,body-2 floor,stick,body-2,43/1,44/1,45/1,46/1,47/1,108/1,109/1,110/1,111/1\n\
         2,101/1,body-1 body-2,stick,body-1,53/1,54/1,55/1,56/1,57/1,108/1,109/1,110/1,111/1\n\
         2,101/1,body-1 body-2,stick,body-2,63/1,64/1,65/1,66/1,67/1,108/1,109/1,110/1,111/1\n\
         end,200/1,,,body-1,73/1,74/1,75/1,76/1,77/1,,,,\n\
         end,200/1,,,body-2,83/1,84/1,85/1,86/1,87/1,,,,\n"
    );
}

#[test]
fn rows_of_states_in_space_in_air_and_with_corners_have_their_own_cells() {
    let mut answer = answer(world(vec![in_space(20)]));
    let mut of = bounce(Encounter::Wall(0, Side::Floor), in_space(40), None);
    of.air = Some(shown(112));
    of.corner = Some((0, shown(127)));
    answer.bounces = vec![of];
    let csv = states_csv(&report(&answer));
    assert_eq!(
        csv,
        "impact,time_s,who,regime,body,x_m,y_m,v_x_m_s,v_y_m_s,omega_rad_s,\
         z_m,v_z_m_s,omega_x_rad_s,omega_y_rad_s,\
         dT_normal_j,dT_tangential_j,dT_rotational_j,gravity_j,air_j,corner,turned_rad\n\
         start,0,,,body-1,23/1,24/1,25/1,26/1,27/1,28/1,29/1,30/1,31/1,,,,,,,\n\
         1,101/1,body-1 floor,stick,body-1,43/1,44/1,45/1,46/1,47/1,48/1,49/1,50/1,51/1,\
         108/1,109/1,110/1,111/1,112/1,1,127/1\n"
    );
}

#[test]
fn errors_under_stress_have_two_digits() {
    let row = |error| Row { case: "a", pushed: "b", to: "1e-3".to_owned(), method: "c", error };
    let csv = stress_csv(&[row(0.0), row(0.126), row(f64::INFINITY)]);
    assert_eq!(
        csv,
        "case,pushed,to,method,error\na,b,1e-3,c,0\na,b,1e-3,c,1.3e-1\na,b,1e-3,c,inf\n"
    );
}

#[test]
fn how_a_motion_ends_is_told_with_its_time_and_its_impacts() {
    let mut answer = answer(world(vec![round(20)]));
    answer.bounces = vec![bounce(Encounter::Wall(0, Side::Floor), round(40), None)];
    let cases = [
        (Ending::Impacts, "after the impacts asked for"),
        (Ending::Duration, "at the end of the time asked for"),
        (Ending::Rest, "at rest, after infinitely many more impacts"),
        (Ending::Quiet, "nothing meets any more"),
    ];
    for (ending, words) in cases {
        answer.end = Some(End { ending, ..end(vec![round(60)]) });
        let text = sheet(&report(&answer)).text(crate::sheet::Page::default());
        let expected = format!("t = 200 s: {words}. Impacts: 7.");
        assert!(text.contains(&expected), "{text}");
    }
}

#[test]
fn an_exact_answer_is_told_as_it_is_unless_it_is_long() {
    let text = |exact: &str| {
        let mut answer = answer(world(vec![round(20)]));
        answer.lines = vec![Line { exact: Some(exact.to_owned()), ..line(Kind::K, 0) }];
        answer.judged = vec![judged(Verdict::Meets)];
        sheet(&report(&answer)).text(crate::sheet::Page::default())
    };
    let long = |digits: usize| format!("1/{}", "4".repeat(digits));
    assert!(text(&long(22)).contains(&long(22)));
    let told = text(&long(23));
    assert!(!told.contains("1/4") && told.contains(" 0.25 "), "{told}");
}
