//! What a scene states, what came of an impact, and what was asked.

use super::*;

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
