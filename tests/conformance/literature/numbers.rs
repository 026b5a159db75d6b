//! Single values that the closed forms give.

use kane::impact::laws::{ChatterjeeRuina, Garwin, Keller1986, Smith1991, WangSuLi};
use kane::impact::{Alpha, ImpactLaw as _, Law, laws};
use kane::number::{Algebraic, Number, Rational, decode};

use super::{assert_printed, exact, k_by_id};

fn alphas() -> [Rational; 14] {
    ["1/10", "1/4", "2/5", "1/2", "3/5", "3/4", "1", "5/4", "3/2", "2", "3", "5", "10", "100"]
        .map(exact)
}

/// Momentum: `i_x` = (1 − k)/(2α), equation (9) of Wang, Su and Li, whatever the law; exactly.
#[test]
fn momentum_ties_the_impulse_to_the_slip_under_every_law() {
    for alpha in alphas().map(Algebraic::from) {
        let mut tied = 0;
        for law in laws() {
            if let Some(ratios) = law.over().ratios(&Alpha::Finite(alpha.clone())) {
                assert!(ratios.is_consistent(&alpha), "{} at α = {alpha}", law.info.id);
                tied += 1;
            }
        }
        assert!(tied >= 17, "at α = {alpha} only {tied} laws have an answer");
    }
}

/// The same in `f64`, to the 10⁻¹² that was asked: k and i are off by a few ulp, those of k are
/// at most 3·10⁻¹⁴ as |k| < 200, and 2α ≥ 1/5 divides them by 400 times as much where k is that large.
#[test]
fn floats_are_tied_to_a_millionth_of_a_millionth() {
    for alpha in alphas().map(|alpha| f64::from_rational(&alpha)) {
        for law in laws() {
            let Some(ratios) = law.over().ratios(&Alpha::Finite(alpha)) else { continue };
            let difference = ratios.impulse - (1.0 - ratios.k) / (2.0 * alpha);
            assert!(difference.abs() < 1e-12, "{} at α = {alpha}: {difference}", law.info.id);
        }
    }
}

fn float(law: &Law, alpha: f64) -> [f64; 3] {
    let ratios = law.over().ratios(&Alpha::Finite(alpha)).expect("a finite α");
    [ratios.k, ratios.impulse, ratios.energy]
}

/// Source: C. E. Smith (1991) as quoted by Chatterjee and Ruina (1998): k = α − √(α² + 2α − 1).
#[test]
fn smith_reverses_the_slip_by_a_square_root() {
    let [k, i, _] = float(&Law::from(Smith1991), 1.0);
    assert_printed("k(1) = 1 − √2", k, "-0.41421356");
    assert_printed("i(1) = 1/√2", i, "0.70710678");
    let [k, i, _] = float(&Law::from(Smith1991), 2.0);
    assert_printed("k(2) = 2 − √7", k, "-0.64575131");
    assert_printed("i(2)", i, "0.4114");
    let [k, i, _] = float(&Law::from(Smith1991), 5.0);
    assert_printed("k(5)", k, "-0.8310");
    assert_printed("i(5)", i, "0.1831");
    // α² + 2α − 1 = (7/4)² at α = 5/4: exact numbers hold this one
    let exact = Smith1991.ratios(&Alpha::Finite(exact("5/4"))).expect("a rational root");
    assert_eq!((exact.k.to_string(), exact.impulse.to_string()), ("-1/2".into(), "3/5".into()));
}

/// Source: Wang, Su and Li, (16), (17) and (19); J. B. Keller (1986) on a sphere.
#[test]
fn the_paper_and_keller_meet_at_one_point() {
    let one = Alpha::Finite(Rational::one());
    let paper = WangSuLi.ratios(&one).expect("α = 1");
    let keller = Keller1986.ratios(&one).expect("α = 1");
    assert_eq!(paper, keller);
    assert_eq!([paper.k, paper.impulse, paper.energy], ["0", "1/2", "-1/4"].map(exact));
    for alpha in alphas() {
        let difference = k_by_id("wang-su-li", &alpha).expect("total")
            - k_by_id("keller-1986", &alpha).expect("total");
        // (1 − α)/(1 + α) − max(0, 1 − 2α) has the sign of 1 − α
        let zero = Algebraic::from(Rational::zero());
        let (sign, expected) = (difference.cmp(&zero), Rational::one().cmp(&alpha));
        assert_eq!(sign, expected, "at α = {alpha}");
    }
}

/// Source: A. Chatterjee and A. Ruina (1998) on a sphere, `e_t` = 1/2.
#[test]
fn chatterjee_and_ruina_inside_and_on_the_cone() {
    let law = ChatterjeeRuina { restitution: exact("1/2") };
    for (alpha, k, i) in [("0.6", "-0.2", "1"), ("1", "-0.5", "0.75")] {
        let ratios = law.ratios(&Alpha::Finite(exact(alpha))).expect("a finite α");
        assert_eq!([ratios.k, ratios.impulse], [k, i].map(exact), "at α = {alpha}");
    }
}

/// Source: R. L. Garwin (1969): no energy is lost, and i = 1/α.
#[test]
fn the_superball_loses_nothing() {
    for alpha in alphas() {
        let ratios = Garwin.ratios(&Alpha::Finite(alpha.clone())).expect("a finite α");
        assert_eq!((ratios.impulse, ratios.energy), (alpha.recip(), Rational::zero()));
    }
}

/// The helper itself: half a unit of the last printed digit, no more.
#[test]
fn printed_digits_are_a_tolerance_of_half_a_unit() {
    for (value, printed, meets) in [
        ("0.81818", "0.8182", true),
        ("0.81815", "0.8182", true),
        ("0.818149", "0.8182", false),
        ("0.2", "0.20", true),
        ("0.206", "0.20", false),
        ("-0.44", "-0.44", true),
        ("0.001", "0", false),
    ] {
        assert_eq!(super::rounds_to(exact(value), printed), meets, "{value} as {printed}");
    }
    assert_eq!(decode(0.5_f64).ok(), Some(exact("1/2")));
}
