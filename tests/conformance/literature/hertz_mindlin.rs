//! Incremental Hertz–Mindlin, against the theory that Chung and Ooi (2011) print for their test 4.

use kane::impact::Alpha;
use kane::impact::compliant::{Compliance, Elastic, HertzMindlin, Memory, Process};

use super::compliant::{error, order, ratios, spread, steel};
use super::experiment::number_rows;

/// The root of the mean square of k's error from an angle on.
fn misses(process: &dyn Process, from: f64) -> f64 {
    let mut squares = Vec::new();
    for row in number_rows("chung-ooi-test4-theory.csv") {
        let [angle, recoil] = [row[0], row[1]].map(f64::to_radians);
        let alpha = 1.75 * 0.092 * 1.98 / angle.tan();
        let printed = 0.98 * recoil.tan() / angle.tan();
        let k = ratios(process, alpha).k;
        println!("{:5.2} degrees: alpha {alpha:.4}, k {k:+.4}, printed {printed:+.4}", row[0]);
        if row[0] >= from {
            squares.push((k - printed).powi(2));
        }
    }
    let count = f64::from(u32::try_from(squares.len()).expect("few"));
    let rms = (squares.iter().sum::<f64>() / count).sqrt();
    println!("{}: rms {rms:.4} over {count} from {from} degrees", process.id());
    rms
}

/// Increments of the force, alumina on a rigid plane: 0.03 from 10° on, as was asked for. The point
/// that is nominally at 10° was digitised at 9.96°, and is missed by 0.13: with it 0.05.
#[test]
fn the_theory_of_test_four_is_reproduced() {
    let sphere = Compliance::of_poisson(3.5, 0.23, 0.98).expect("alumina on a rigid plane");
    assert!((sphere.chi() - 1.5226).abs() < 5e-5);
    let process = HertzMindlin::new(sphere);
    assert!(misses(&process, 10.0) < 0.03);
    assert!(misses(&process, 9.5) < 0.05);
}

/// Increments of the displacement, on the plane that they name (aluminium alloy, E = 70 GPa,
/// ν = 0.33), reproduce the point at 10°, too, to what digitised points are good for, so that this
/// is probably what they computed. At 5° their damping matters, which is another one.
#[test]
fn the_theory_of_test_four_is_that_of_displacements() {
    let elastic = |young: f64, poisson: f64| Elastic {
        shear_modulus: young / (2.0 * (1.0 + poisson)),
        poisson,
    };
    let bodies = [elastic(380e9, 0.23), elastic(70e9, 0.33)];
    let alloy = Compliance::between(bodies, 3.5, 0.98).expect("a sphere on a plane");
    assert!((alloy.chi() - 1.4223).abs() < 5e-5, "{}", alloy.chi());
    let displacement = HertzMindlin::new(alloy).remembering(Memory::Displacement);
    assert!(misses(&displacement, 9.5) < 0.015);
    assert!(misses(&HertzMindlin::new(alloy), 9.5) > 0.025);
}

/// On a solid sphere with ν = 0.3 and e = 1, increments of force create no energy for α up to 100.
#[test]
fn on_a_sphere_increments_of_force_create_no_energy() {
    let process = HertzMindlin::new(steel(1.0));
    for alpha in spread(0.01, 100.0, 200) {
        let outcome = process.outcome(&Alpha::Finite(alpha)).expect("it ends");
        assert!(outcome.ledger.above_start <= 1e-12, "at {alpha}: {:?}", outcome.ledger);
    }
}

/// But they can: both shortcuts return more than they took, for a stiffer sphere near normal
/// collision and for one that does not rebound. No fault of the steps: sixteen times as many say so,
/// too, and the cone holds all the while. The ledger tells.
#[test]
fn increments_can_create_energy() {
    for (memory, chi, e, alpha, least) in
        [(Memory::Force, 1.75, 1.0, 359.0, 1.03), (Memory::Displacement, 1.4412, 0.0, 2.2476, 1.2)]
    {
        let compliance = Compliance::new(chi, e).expect("in the domain");
        for steps in [200, 3200] {
            let process = HertzMindlin::with_steps(compliance, steps).expect("a budget");
            let process = process.remembering(memory);
            let outcome = process.outcome(&Alpha::Finite(alpha)).expect("it ends");
            assert!(outcome.ratios.k.abs() > least, "{memory:?}: {outcome:?}");
            assert!(outcome.ratios.energy > 0.0 && outcome.error < 0.01, "{outcome:?}");
            assert!(outcome.ledger.above_start > 0.05, "{outcome:?}");
            assert!(outcome.ledger.beyond_cone == 0.0, "{outcome:?}");
        }
    }
}

/// Second order; for the margin see the bilinear pair.
#[test]
fn steps_converge_with_their_second_order() {
    for (e, memory) in [(1.0, Memory::Force), (0.8, Memory::Force), (1.0, Memory::Displacement)] {
        let alphas = spread(0.62, 8.0, 16);
        let with = |steps| {
            HertzMindlin::with_steps(steel(e), steps).expect("a budget").remembering(memory)
        };
        let truth = with(12_800);
        let errors = [100, 200, 400, 800].map(|steps| error(&with(steps), &alphas, &truth));
        let order = order(&format!("hertz-mindlin, e = {e}, {memory:?}"), &errors);
        assert!((order - 2.0).abs() < 0.2, "{order}");
        assert!(errors[1] < 1e-3, "the default is as good as it says: {errors:?}");
    }
}
