//! Rows of models, of states and of errors, and how a motion ends.

use super::*;

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
