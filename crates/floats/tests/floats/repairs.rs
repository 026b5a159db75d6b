//! Known repairs are found, and formulas are written as functions.

use kane_floats::rigor::Goal;
use kane_floats::{Core, Effort, Language, Precision, emit, fpcore, repairs, worst};

fn core(text: &str) -> Core {
    fpcore::read("t.fpcore", text).expect("it is well formed").remove(0)
}

#[test]
fn known_cancellations_are_repaired() {
    let cases = [
        (
            "(FPCore (x) :pre (<= 1 x 1e12) (- (sqrt (+ x 1)) (sqrt x)))",
            "1/(sqrt(x + 1) + sqrt(x))",
        ),
        ("(FPCore (x) :pre (<= 1 x 1e6) (- (/ 1 (+ x 1)) (/ 1 x)))", "-1/"),
        ("(FPCore (p) :pre (< 0 p 1) (- 1 (* p p)))", "(1 - p)*(1 + p)"),
        ("(FPCore (x) :pre (<= 1 x 1e9) (- (* (+ x 1) (+ x 1)) (* x x)))", "2*x + 1"),
        ("(FPCore (b) :pre (<= 1e3 b 1e7) (/ (+ (- b) (sqrt (- (* b b) 4))) 2))", "-2/"),
    ];
    for (text, form) in cases {
        let core = core(text);
        let effort = Effort { drawn: 500, climbs: 3, rounds: 10 };
        let worst = worst::<f64>(&core, &[], Goal::Ulps, effort).expect("there are points");
        let (given, found) = repairs::<f64>(&core, &[worst.at]).expect("it is a formula");
        let best = found.first().expect("there is a better form");
        let texts: Vec<String> = found.iter().map(|proposal| proposal.core.text()).collect();
        assert!(texts.iter().any(|text| text.contains(form)), "{text}: {texts:?}");
        assert!(best.lost + 5.0 < given.lost, "{text}: {given:?} {best:?}");
    }
}

#[test]
fn a_formula_that_is_right_has_no_repair() {
    let (_, found) =
        repairs::<f64>(&core("(FPCore (x) :pre (<= 1 x 2) (+ x 1))"), &[]).expect("a formula");
    assert!(found.is_empty(), "{found:?}");
    assert!(repairs::<f64>(&core("(FPCore (x) (if (< x 1) x 1))"), &[]).is_none());
}

#[test]
fn functions_carry_out_the_operations_in_order() {
    let core = core(
        "(FPCore f (x-1 y) (let ([s (sqrt x-1)]) (if (< s 1/10) (fma s y -2) (/ s (+ s y)))))",
    );
    let rust = "pub fn f(x_1: f64, y: f64) -> f64 {
    let t2 = x_1.sqrt();
    let t5 = t2.mul_add(y, (-2.0_f64));
    let t6 = t2 + y;
    let t7 = t2 / t6;
    if t2 < 0.1_f64 { t5 } else { t7 }
}";
    let c = "float f(float x_1, float y) {
    const float t2 = sqrtf(x_1);
    const float t5 = fmaf(t2, y, (-2.0f));
    const float t6 = t2 + y;
    const float t7 = t2 / t6;
    return (t2 < 0.1f) ? t5 : t7;
}";
    let python = "def f(x_1, y):
    t2 = sqrt(x_1)
    if t2 < 0.1:
        t5 = fma(t2, y, (-2.0))
        t8 = t5
    else:
        t6 = t2 + y
        t7 = t2 / t6
        t8 = t7
    return t8";
    assert_eq!(emit(&core, Precision::F64, Language::Rust), rust);
    assert_eq!(emit(&core, Precision::F32, Language::C), c);
    assert_eq!(emit(&core, Precision::F64, Language::Python), python);
}
