//! A ball comes to rest under every model as that model goes on, not as Coulomb friction does.

use kane_impact::laws::{RouthNewton, Walton, WangSuLi, WhittakerUncapped};
use kane_impact::{Law, laws};
use kane_number::Rational;
use kane_scene::simulate::{Budget, Ending, Stopped, Until, run};
use kane_scene::{
    Effort, Elastic, Model, NormalOnly, Process, Resolver, Verdict, World, answer, read,
};

use crate::{above_floor, ball, n, of};

/// Dropped from 0.45 m above where it touches, at 10 m/s forwards, over a floor of this μ and e.
fn thrown(friction: &str, restitution: &str) -> World<Rational> {
    let ball = ball("1", "1/10", ["0", "11/20"], ["10", "0", "0"]);
    above_floor(vec![ball], "10", friction, restitution)
}

#[test]
fn without_friction_nothing_slows_a_ball_that_comes_to_rest() {
    let world = thrown("1/20", "19/20");
    let end = run(&of::<f64>(&world), &NormalOnly, &Until::Rest, Budget::default(), &mut |_| {});
    let end = end.unwrap();
    // it falls for 3/10 s, and bounces for 2·e/(1 − e) times as long
    let time = 0.3 * (1.0 + 2.0 * 19.0);
    let body = &end.bodies[0];
    assert_eq!((end.ending, body.motion.vx, body.motion.omega), (Ending::Rest, 10.0, 0.0));
    assert!((end.time - time).abs() < 1e-9 && (body.position[0] - 10.0 * time).abs() < 1e-8);
    // and nothing does afterwards
    let until = Until::Duration(20.0);
    let later = run(&of::<f64>(&world), &NormalOnly, &until, Budget::default(), &mut |_| {});
    let later = &later.unwrap().bodies[0];
    assert_eq!((later.motion.vx, later.motion.omega), (10.0, 0.0));
    assert!((later.position[0] - 200.0).abs() < 1e-8);
}

#[test]
fn the_sum_of_a_model_is_what_its_impacts_come_to_one_by_one() {
    let elastic = |ratio: &str| Elastic {
        stiffness_ratio: n(ratio),
        process: Process::DimensionReduction,
        loss: None,
        finer: 1,
    };
    let walton = |share: &str| Law::from(Walton { restitution: n(share) });
    let models: [(&str, Box<dyn Resolver<f64>>); 6] = [
        ("no friction", Box::new(NormalOnly)),
        ("coulomb", Box::new(Law::from(RouthNewton))),
        ("in full", Box::new(Law::from(WhittakerUncapped))),
        ("a share of 0.44", Box::new(walton("11/25"))),
        ("a share of 0.74", Box::new(walton("37/50"))),
        ("elastic", Box::new(elastic("14/17"))),
    ];
    for (name, model) in &models {
        // slides for ever, stops slipping, grips from the start
        for friction in ["1/100", "1/5", "2"] {
            if (*name, friction) == ("elastic", "2") || (*name, friction) == ("elastic", "1/5") {
                continue; // a contact that swings has no sum
            }
            if *name == "in full" && friction != "1/100" {
                continue; // nor one whose slip is thrown back and forth
            }
            let world = of::<f64>(&thrown(friction, "3/4"));
            let follow = |until: &Until<f64>| {
                run(&world, &**model, until, Budget::default(), &mut |_| {}).expect(name)
            };
            let (rest, far) = (follow(&Until::Rest), follow(&Until::Impacts(160)));
            assert!(rest.impacts < 100, "{name}, mu = {friction}: it is summed up");
            let (a, b) = (&rest.bodies[0], &far.bodies[0]);
            let off = [
                rest.time - far.time,
                a.position[0] - b.position[0],
                a.motion.vx - b.motion.vx,
                (a.motion.omega - b.motion.omega) / 20.0,
            ];
            assert!(off.iter().all(|off| off.abs() < 1e-11), "{name}, mu = {friction}: {off:?}");
        }
    }
}

#[test]
fn the_sum_of_shares_is_exact_in_exact_numbers() {
    let world =
        above_floor(vec![ball("1", "1/10", ["0", "27/20"], ["1", "0", "3"])], "10", "1", "3/4");
    let law = Law::from(Walton { restitution: n("11/25") });
    let rest = |shown| {
        let budget = Budget { shown, ..Budget::default() };
        run(&world, &law, &Until::Rest, budget, &mut |_| {}).unwrap()
    };
    let (early, late) = (rest(1), rest(30));
    assert!(early.impacts < late.impacts);
    assert_eq!((&early.time, &early.bodies), (&late.time, &late.bodies));
    // all slip is gone
    let body = &early.bodies[0];
    assert_eq!(&body.motion.vx + &body.motion.omega * &body.radius, n("0"));
}

#[test]
fn a_law_without_a_sum_is_followed_until_the_ball_lies_still() {
    // what 3,000 impacts in an independent program come to
    let end = run(
        &of::<f64>(&thrown("1/50", "19/20")),
        &Law::from(WangSuLi),
        &Until::Rest,
        Budget::default(),
        &mut |_| {},
    );
    let end = end.unwrap();
    let motion = &end.bodies[0].motion;
    assert!((500..3_000).contains(&end.impacts), "{}", end.impacts);
    assert!((motion.vx - 7.6956).abs() < 5e-5 && (motion.omega + 57.61).abs() < 0.01, "{motion:?}");
    // and what it does while it lies there, the law does not tell
    let world = of::<f64>(&thrown("1/50", "0"));
    let law = Law::from(WangSuLi);
    let later = run(&world, &law, &Until::Duration(20.0), Budget::default(), &mut |_| {});
    assert_eq!(later.unwrap_err(), Stopped::LiesUntold);
}

#[test]
fn friction_that_counts_is_not_certified_away() {
    let text = r#"
        friction = 0.05
        restitution = 0.95
        gravity_m_s2 = 10
        floor_m = 0
        [[body]]
        mass_kg = 1
        radius_m = 0.1
        position_m = [0, 0.55]
        velocity_m_s = [10, 0]
        [until]
        rest = true
        [ask]
        v_x_m_s = 0.01
    "#;
    let scene = read::scene("loose", text).unwrap();
    let answered = answer(&scene, laws(), None, Effort::All, &mut |_, _| {}).unwrap();
    let without = Model::named("normal-only/f64", laws()).unwrap();
    let judged = answered.judged.iter().find(|judged| judged.model == without).unwrap();
    assert!(matches!(judged.verdict, Verdict::Misses { by, .. } if by > 2.8), "{judged:?}");
    // with it the ball rolls in the end
    let rolling = 10.0 * 5.0 / 7.0;
    assert!((answered.lines[0].value - rolling).abs() < 0.01, "{:?}", answered.lines[0]);
}
