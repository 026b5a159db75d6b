//! The theory of Maw, Barber and Fawcett, by annuli and by dimension reduction.
//!
//! The table was computed for this project with Maw's own arrangement of annuli (100 of them, 1000
//! steps) and is good to about 0.003 in k; originals not consulted.

use kane::impact::Alpha;
use kane::impact::compliant::{DimensionReduction, MawBarberFawcett, Process};

use super::compliant::{error, order, ratios, spread, steel};
use super::experiment::number_rows;

/// ψ1 and k, for χ = 1.4412 and e = 1.
const TABLE: [(f64, f64); 15] = [
    (0.100, 0.2044),
    (0.500, 0.0939),
    (0.750, 0.0167),
    (1.250, -0.1789),
    (1.500, -0.2865),
    (2.000, -0.4159),
    (2.250, -0.4468),
    (2.750, -0.4669),
    (3.000, -0.4590),
    (3.500, -0.4193),
    (3.750, -0.3905),
    (4.250, -0.3159),
    (4.500, -0.2687),
    (5.000, -0.1527),
    (6.000, 0.0392),
];

#[test]
fn the_curve_is_reproduced() {
    let steel = steel(1.0);
    let (annuli, reduced) = (MawBarberFawcett::new(steel), DimensionReduction::new(steel));
    for process in [&annuli as &dyn Process, &reduced] {
        let mut worst = 0.0_f64;
        for (psi, printed) in TABLE {
            let k = ratios(process, 2.0 * steel.chi() / psi).k;
            worst = worst.max((k - printed).abs());
        }
        println!("{}: greatest difference {worst:.4}", process.id());
        assert!(worst < 0.01, "{}: {worst}", process.id());
    }
    // the limit of normal collision was given as about 0.22
    assert!((ratios(&annuli, f64::INFINITY).k - 0.22).abs() < 0.02);
}

/// ψ1 > 4χ − 1 is sliding, k = 1 − 2α to the rounding of 1200 steps, and not so below.
#[test]
fn gross_sliding_is_exact() {
    let steel = steel(1.0);
    let (annuli, reduced) = (MawBarberFawcett::new(steel), DimensionReduction::new(steel));
    let threshold = 4.0 * steel.chi() - 1.0;
    for process in [&annuli as &dyn Process, &reduced] {
        let off = |psi: f64| {
            let alpha = 2.0 * steel.chi() / psi;
            (ratios(process, alpha).k - (1.0 - 2.0 * alpha)).abs()
        };
        for psi in [threshold * (1.0 + 1e-3), 5.0, 5.5, 6.0, 8.0, 12.0, 100.0] {
            assert!(off(psi) < 1e-12, "{} at {psi}: {:e}", process.id(), off(psi));
        }
        assert!(off(threshold * 0.98) > 1e-4, "{}", process.id());
    }
}

/// Finite elements, digitised: 0.03 where the digits are good, that is for α < 1.9; those beyond
/// have dy = 0.02 of a small x.
#[test]
fn finite_elements_agree() {
    let process = MawBarberFawcett::new(steel(1.0));
    let mut worst = 0.0_f64;
    for row in number_rows("chung-ooi-test5-elements.csv") {
        let (alpha, printed) = (3.5 / row[0], row[1] / row[0]);
        let k = ratios(&process, alpha).k;
        println!("alpha {alpha:.3}: k {k:+.4}, finite elements {printed:+.4}");
        if alpha < 1.9 {
            worst = worst.max((k - printed).abs());
        }
    }
    println!("greatest difference {worst:.4}");
    assert!(worst < 0.03, "{worst}");
}

/// The two ways through the half-space share no line of what they make of displacement, and agree as
/// far as the annuli say of themselves.
#[test]
fn annuli_and_reduction_agree() {
    for e in [1.0, 0.7] {
        let annuli = MawBarberFawcett::new(steel(e));
        let reduced = DimensionReduction::with_grid(steel(e), 200, 1000).expect("a grid");
        for alpha in spread(0.55, 50.0, 12) {
            let outcome = annuli.outcome(&Alpha::Finite(alpha)).expect("it settles");
            let difference = (outcome.ratios.k - ratios(&reduced, alpha).k).abs();
            println!("{e} {alpha:.3} {difference:.1e}, estimated {:.1e}", outcome.error);
            assert!(difference < outcome.error + 1e-12, "{e}, at {alpha}: {difference}");
            assert!(difference < 0.005, "{e}, at {alpha}: {difference}");
        }
    }
}

/// Steps and springs halved together: second order. For the margin see the bilinear pair; where the
/// springs join within a step adds as much again.
#[test]
fn reduction_converges_with_its_second_order() {
    let with = |n: usize| DimensionReduction::with_grid(steel(1.0), n, 4 * n).expect("a grid");
    let truth = with(400);
    let alphas = spread(0.62, 8.0, 16);
    let errors = [25, 50, 100].map(|n| error(&with(n), &alphas, &truth));
    let order = order("dimension reduction", &errors);
    assert!((order - 2.0).abs() < 0.4, "{order}");
}

/// Annuli and steps halved together: second order where the contact slides first, and its edge bears
/// little; first order at least where it sticks, and tractions are singular at the edge.
#[test]
fn annuli_converge_with_their_order() {
    let with = |n: usize| MawBarberFawcett::with_grid(steel(1.0), n, 10 * n).expect("a grid");
    let truth = DimensionReduction::with_grid(steel(1.0), 400, 1600).expect("a grid");
    for (what, from, to, least) in
        [("slides first", 0.65, 2.0, 1.7), ("sticks first", 3.0, 30.0, 1.0)]
    {
        let alphas = spread(from, to, 10);
        let errors = [8, 16, 32].map(|n| error(&with(n), &alphas, &truth));
        let order = order(&format!("annuli, {what}"), &errors);
        assert!(order > least, "{order}");
    }
}
