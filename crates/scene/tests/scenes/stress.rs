//! Drift, reversal, Zeno, grazing, penalty steps: what the table of stress says, asserted.

use kane_impact::laws::RouthNewton;
use kane_impact::{Law, laws};
use kane_scene::simulate::{Budget, Until, run};
use kane_scene::stress::{Row, box_of_discs, rows, there_and_back};
use kane_scene::{NormalOnly, World};

use crate::{above_floor, ball, energy, of};

/// Half the spacing of floats at 1.
const U: f64 = 1.0 / (1_u64 << 53) as f64;

#[test]
fn hard_inputs_cost_no_more_digits_than_they_must() {
    let rows = rows(laws());
    let of = |case: &'static str| rows.iter().filter(move |row| row.case.starts_with(case));
    let all = |case, bound: f64| {
        assert!(of(case).count() > 2, "{case}");
        for row in of(case) {
            assert!(row.error <= bound, "{row:?}");
        }
    };
    // a law has some ten roundings, each of at most u relative, on quantities that do not cancel;
    // k beside a kink is at most 1, so that the same holds absolutely
    all("kink", 20.0 * U);
    all("grazing", 20.0 * U);
    all("restitution", 20.0 * U);
    all("vanishing inertia", 20.0 * U);

    // sliding: p_n = closing/(W_nn − μ·W_tn), and the difference loses what μ is close to
    // its critical value; beyond that there is no impulse at all, where the process still has one
    for row in of("jam") {
        let digits: i32 = row.to[4..].parse().expect("the exponent");
        let lost = 10_f64.powi(digits);
        match (row.method, row.to.starts_with('-')) {
            ("whittaker-uncapped/f64", false) => assert!(row.error.is_infinite(), "{row:?}"),
            ("whittaker-uncapped/f64", true) | (_, true) => {
                assert!(row.error <= 20.0 * U * lost, "{row:?}")
            }
            (_, false) => assert!(row.error <= 20.0 * U * lost, "{row:?}"),
        }
    }

    // 1 − e loses what e is close to 1; following impacts never ends
    for row in of("Zeno") {
        let digits: i32 = row.to[3..].parse().expect("the exponent");
        match row.method {
            "closed form/f64" => assert!(row.error <= 20.0 * U * 10_f64.powi(digits), "{row:?}"),
            _ => assert!(digits < 2 || row.error > 1e-7, "{row:?}"),
        }
    }

    // spheres that touch are no sequence of pairs; with a gap beyond their compression they are
    let apart: Vec<&Row> = of("nearly simultaneous").collect();
    assert!(apart[0].error > 0.05 && apart.last().is_some_and(|row| row.error <= 1e-6));

    // the penalty method is not even monotone: some smaller step is worse
    for motion in ["a drop", "50 discs", "three spheres", "grazing"] {
        let of_motion = of("penalty").filter(|row| row.method == motion);
        let steps: Vec<f64> = of_motion.map(|row| row.error).collect();
        assert_eq!(steps.len(), 11, "{motion}");
        assert!(steps.windows(2).any(|pair| pair[1] > pair[0]), "{motion}: {steps:?}");
        // and its best is far worse than an event
        assert!(steps.iter().all(|error| *error > 1e-9), "{motion}: {steps:?}");
    }
}

#[test]
fn a_million_bounces_drift_by_no_more_than_their_roundings() {
    // n equal flights: the sum errs by at most n·u relatively, the flight by 2u; the velocity turns
    // exactly
    let rows = rows(laws());
    let worst = rows
        .iter()
        .find(|row| row.case.starts_with("drift") && row.to == "1e6" && row.method == "f64");
    assert!(worst.expect("it is measured").error < 1e6 * U);
    let world = above_floor(vec![ball("1", "1", ["0", "1"], ["0", "-3", "0"])], "10", "1/5", "1");
    let budget = Budget { impacts: 1_000_000, ..Budget::default() };
    let until = Until::Impacts(1_000_000);
    let world = of::<f64>(&world);
    let end = run(&world, &Law::from(RouthNewton), &until, budget, &mut |_| {}).unwrap();
    assert_eq!(energy(&end.bodies), energy(&world.bodies));
}

/// The drift of the energy, relatively, after so many impacts of fifty discs.
fn box_drift(impacts: u64) -> f64 {
    let discs = box_of_discs();
    let budget = Budget { impacts: u64::MAX, ..Budget::default() };
    let end = run(&discs, &NormalOnly, &Until::Impacts(impacts), budget, &mut |_| {})
        .expect("it can be followed");
    (energy(&end.bodies) / energy(&discs.bodies) - 1.0).abs()
}

#[test]
fn a_box_of_discs_keeps_its_energy() {
    assert!(box_drift(100_000) < 1e-10);
}

/// Seconds in a release build, a minute else: `cargo test --release -p kane-scene -- --ignored`.
#[test]
#[ignore = "long"]
fn a_box_of_discs_keeps_its_energy_over_a_million_impacts() {
    let drift = box_drift(1_000_000);
    println!("drift {drift:e}");
    assert!(drift < 1e-9);
}

#[test]
fn a_disc_alone_finds_its_way_back() {
    let mut alone = box_of_discs();
    alone.bodies.truncate(1);
    // each impact rounds time and place once or twice; nothing amplifies
    let world = World { ..alone };
    for impacts in [1, 10, 100, 1_000] {
        #[allow(clippy::cast_precision_loss, reason = "a small count")]
        let bound = 20.0 * U * impacts as f64 * 10.0;
        let far = there_and_back(&world, impacts);
        assert!(far < bound, "{impacts}: {far:e}");
    }
}

#[test]
fn many_discs_find_their_way_back_for_a_while() {
    let discs = box_of_discs();
    assert!(there_and_back(&discs, 25) < 1e-13);
    let (ten, many) = (there_and_back(&discs, 250), there_and_back(&discs, 1_500));
    println!("{ten:e} {many:e}");
    // a collision of discs multiplies a distance by about 1 + 2·way/(2·radius), and the ways are some
    // 0.15 m between radii of 0.06 m: 3.5^10·u is 3e-11, and each disc rounds a few times
    assert!(ten < 1e-10, "ten collisions a disc: {ten:e}");
    assert!(many > 1e-3, "and then they do not: {many:e}");
}

/// `cargo test --release -p kane-scene --test scenes million_bounces_take -- --ignored --nocapture`
#[test]
#[ignore = "a measurement"]
fn a_million_bounces_take_little_time() {
    let world = above_floor(vec![ball("1", "1", ["0", "1"], ["1", "-3", "0"])], "10", "1/5", "1");
    let world = of::<f64>(&world);
    let budget = Budget { impacts: 1_000_000, ..Budget::default() };
    let since = std::time::Instant::now();
    // what this thread has had of a processor, where the system tells, because others run too
    let now = || {
        let told = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
        let spent = told.split_whitespace().next().and_then(|ns| ns.parse::<f64>().ok());
        spent.map_or_else(|| since.elapsed().as_secs_f64(), |ns| ns * 1e-9)
    };
    let mut times = Vec::new();
    for _ in 0..15 {
        let start = now();
        let until = Until::Impacts(1_000_000);
        let end = run(&world, &Law::from(RouthNewton), &until, budget, &mut |_| {}).unwrap();
        assert_eq!(end.impacts, 1_000_000);
        times.push(now() - start);
    }
    times.sort_by(f64::total_cmp);
    let (least, middle) = (times[0], times[times.len() / 2]);
    println!(
        "10^6 planar bounces: {least:.3} s at least, {middle:.3} s the median of {}",
        times.len()
    );
    // the least, because what else runs on the core only adds
    assert!(cfg!(debug_assertions) || least < 0.15, "{times:?}");
}
