//! Bounds, worst inputs and poles of formulas whose answers are known.

use kane_floats::rigor::{Bounded, Budget, FaultKind, Goal, Inputs, bounded};
use kane_floats::{Core, Effort, Machine, fpcore, text, worst};

fn core(text: &str) -> Core {
    fpcore::read("t.fpcore", text).expect("it is well formed").remove(0)
}

fn bound<M: Machine>(core: &Core, goal: Goal) -> Bounded {
    let budget = Budget { cells: 1_500, ratio: 1.02 };
    bounded::<M>(core, Inputs::Floats, goal, budget).expect("there are floats")
}

const EFFORT: Effort = Effort { drawn: 1_500, climbs: 4, rounds: 20 };

/// x + y on [1, 2]²: half an ulp of results in [2, 4], and that is met.
#[test]
fn one_sum_is_bounded_by_half_an_ulp() {
    let core = core("(FPCore (x y) :pre (and (<= 1 x 2) (<= 1 y 2)) (+ x y))");
    assert_eq!(bound::<f64>(&core, Goal::Absolute).bound, f64::EPSILON);
    assert_eq!(bound::<f32>(&core, Goal::Absolute).bound, f64::from(f32::EPSILON));
    let found = worst::<f64>(&core, &[], Goal::Absolute, EFFORT).expect("there are points");
    assert_eq!(found.compared.error, f64::EPSILON);
}

/// What is computed exactly has no error: Sterbenz's difference, powers of two, integers, minima.
#[test]
fn exact_operations_have_no_error() {
    let exact = [
        "(FPCore (x y) :pre (and (<= 1 x 2) (<= 1 y 2)) (- x y))",
        "(FPCore (x) :pre (<= 1 x 1e3) (* 4 (/ x 8)))",
        "(FPCore (x) :pre (<= -8 x 8) (fabs (- (fmin x 3))))",
        "(FPCore (x) :pre (<= 0 x 0) (+ (* 3 5) (* x 0.1)))",
        "(FPCore (x) :pre (<= 4 x 4) (sqrt x))",
        "(FPCore (x) :pre (<= -5 x 5) (if (< x 0) (- x) x))",
    ];
    for text in exact {
        assert_eq!(bound::<f64>(&core(text), Goal::Absolute).bound, 0.0, "{text}");
    }
}

/// The classical cancellation: √(x + 1) − √x loses digits with x, and the bound says so.
#[test]
fn cancellation_is_seen_by_the_bound_and_by_the_search() {
    let core = core("(FPCore (x) :pre (<= 1 x 1e4) (- (sqrt (+ x 1)) (sqrt x)))");
    let found = bound::<f64>(&core, Goal::Ulps);
    let worst = worst::<f64>(&core, &found.worst, Goal::Ulps, EFFORT).expect("there are points");
    assert!(worst.compared.ulps > 2.0_f64.powi(11), "{worst:?}");
    assert!(worst.compared.ulps <= found.bound && found.bound < 2.0_f64.powi(20), "{found:?}");
}

/// A false all-clear of old: 1 − p² next to 1 loses half of its digits, on few floats.
#[test]
fn the_ends_of_a_domain_are_searched_to_the_float() {
    let core = core("(FPCore (p) :pre (< 0 p 1) (- 1 (* p p)))");
    let found = bound::<f64>(&core, Goal::Ulps);
    let worst = worst::<f64>(&core, &found.worst, Goal::Ulps, EFFORT).expect("there are points");
    assert!(worst.compared.ulps > 2.0_f64.powi(24), "{worst:?}");
    assert!(worst.at[0] > 0.999_999 && worst.at[0] < 1.0);
    assert!(worst.compared.ulps <= found.bound);
}

#[test]
fn poles_roots_and_overflows_have_their_place() {
    let cases = [
        ("(FPCore (x) :pre (<= -1 x 1) (/ 1 x))", FaultKind::DivisionByZero, "1/x", true),
        (
            "(FPCore (x) :pre (<= -1 x 1) (sqrt (- x 1/2)))",
            FaultKind::NegativeRoot,
            "sqrt(x - 0.5)",
            true,
        ),
        ("(FPCore (x) :pre (<= 1 x 1e200) (* x x))", FaultKind::Overflow, "x*x", true),
        ("(FPCore (x) (+ x 1e400))", FaultKind::Overflow, "1000", true),
        (
            "(FPCore (x y) :pre (and (<= 1 x 2) (<= 1 y 2)) (/ 1 (- x y)))",
            FaultKind::DivisionByZero,
            "1/(x - y)",
            true,
        ),
    ];
    for (written, kind, place, certain) in cases {
        let core = core(written);
        let pole = bound::<f64>(&core, Goal::Absolute).pole.expect(written);
        assert_eq!((pole.kind, pole.certain), (kind, certain), "{written}: {pole:?}");
        assert!(text::infix(&core, pole.operation).starts_with(place), "{written}: {pole:?}");
    }
    // a float is excluded from the range, or by what is assumed: no pole
    for text in [
        "(FPCore (x) :pre (< 0 x 1) (/ 1 (- 1 x)))",
        "(FPCore (x) :pre (<= -1 x 1) (/ 1 (+ 1 (* x x))))",
        "(FPCore (x y) :pre (and (<= 1 x 2) (<= 1 y 2)) (sqrt (+ (* x x) (* y y))))",
        "(FPCore (x) :pre (<= -1 x 1) (if (< x 1/2) x (/ 1 x)))",
        "(FPCore (x y) :pre (and (<= 0 x 1) (<= 0 y 1) (<= (+ x 1/2) y)) (/ 1 (- y x)))",
    ] {
        let found = bound::<f64>(&core(text), Goal::Absolute);
        assert!(found.pole.is_none() && found.bound.is_finite(), "{text}: {found:?}");
    }
}

/// A choice that rounding can turn is counted with its jump, one that it cannot is not.
#[test]
fn a_choice_counts_by_its_jump() {
    let jumps = core("(FPCore (x) :pre (<= 0 x 1) (if (< (* x 0.1) 0.05) 0 1))");
    assert!(bound::<f64>(&jumps, Goal::Absolute).bound >= 1.0);
    let certain = core("(FPCore (x) :pre (<= 0 x 1) (if (< x 1/2) 0 1))");
    assert_eq!(bound::<f64>(&certain, Goal::Absolute).bound, 0.0);
}

#[test]
fn an_empty_range_is_named() {
    let core = core("(FPCore (x y) :pre (< 1 y 1.0000000000000001) (+ x y))");
    let nowhere = bounded::<f64>(&core, Inputs::Floats, Goal::Absolute, Budget::default());
    assert_eq!(nowhere, Err("y".to_owned()));
}

/// Inputs that are rounded themselves bring their own error, times the derivative.
#[test]
fn rounded_inputs_count() {
    let core = core("(FPCore (x) :pre (<= 1 x 1.5) (* 4 x))");
    let budget = Budget::default();
    let reals = bounded::<f64>(&core, Inputs::Reals, Goal::Absolute, budget).expect("floats");
    assert_eq!(reals.bound, 2.0 * f64::EPSILON);
    assert_eq!(bound::<f64>(&core, Goal::Absolute).bound, 0.0);
}
