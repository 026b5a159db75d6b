//! How far floats are from exact numbers. Throughout, u = 2^−53 and one ulp of a number of
//! magnitude 1 to 2 is 2u.
//!
//! **k = (1 − α)/(1 + α)**: q − p and q + p with q = 1, p = α are exact as pairs of a sum and its
//! error (TwoSum), and so is the remainder of the quotient (FMA). So the correction that is added
//! to fl(d/s) is the whole error but for rounding of its own: of three terms, each at most 2u
//! relative to k·s, by four roundings, hence below 16u² of |k|. The last sum is rounded once:
//! **1/2 ulp** and less than 2^−20 in either format, asked as 51/100.
//! Without the correction the sharp bound would be 9/4 ulp, at α ≈ 2^56/7.
//!
//! **i_x = 1/(1 + α)**: one relative error of at most u in s is at most 1 ulp, and the division
//! adds 1/2: **3/2 ulp**.
//!
//! **Δe = −i_x²**: the relative error of i_x is at most 3/2·u: for α < 1 it is u/s + u·s/2 with
//! 1 ≤ s ≤ 2, and beyond, s is exact unless it is rounded to a power of two, where i_x is just
//! below one and rounds with u/2. So the square is off by less than 3 ulp and a little before it is
//! rounded, and that adds at most 1 (1/2, doubled if the result crosses into the next binade):
//! **4 ulp**.

use kane_impact::bodies::SphereOnPlane;
use kane_impact::laws::{WangSuLi, WhittakerUncapped};
use kane_impact::{Alpha, ImpactLaw as _, Law, NumberSystem, Ratios};
use kane_number::{Binary, Number, Ordered, Rational, decode, error_in_ulps};
use proptest::prelude::*;

use crate::strategies::{alpha, exact, float_sphere, sphere};
use crate::{cases, rational, two_to};

fn magnitude(number: Rational) -> Rational {
    if number < rational(0, 1) { -number } else { number }
}

/// The law in floats and in exact numbers at the same α.
fn both<F: Binary + NumberSystem>(law: &Law, alpha: F) -> (Ratios<F>, Ratios<Rational>) {
    let truth = Alpha::Finite(decode(alpha).expect("a finite α"));
    let float = Alpha::new(alpha).expect("α ≥ 0");
    let answers = (law.over().ratios(&float), law.over().ratios(&truth));
    (answers.0.expect("finite α"), answers.1.expect("finite α"))
}

/// The errors of k, i_x and Δe in ulps, without sign.
fn errors<F: Binary>(float: &Ratios<F>, truth: &Ratios<Rational>) -> [Rational; 3] {
    [(float.k, &truth.k), (float.impulse, &truth.impulse), (float.energy, &truth.energy)]
        .map(|(float, truth)| magnitude(error_in_ulps(float, truth).expect("a finite result")))
}

fn within<F: Binary + NumberSystem>(alpha: F) -> Result<(), TestCaseError> {
    let (float, truth) = both(&Law::from(WangSuLi), alpha);
    let [k, impulse, energy] = errors(&float, &truth);
    prop_assert!(k <= rational(51, 100), "k is off by {k} ulp at α = {alpha}");
    prop_assert!(impulse <= rational(3, 2), "i_x is off by {impulse} ulp at α = {alpha}");
    prop_assert!(energy <= rational(4, 1), "Δe is off by {energy} ulp at α = {alpha}");
    Ok(())
}

proptest! {
    #![proptest_config(cases(24_000))]

    #[test]
    fn exact_and_float_agree(alpha in alpha()) {
        within(alpha)?;
        // The derivation holds for any precision.
        let single = f32::from_rational(&exact(alpha));
        if single.is_finite() {
            within(single)?;
        }
    }

    /// 2α is exact, so that k and Δe are each rounded once.
    #[test]
    fn exact_and_float_agree_for_whittaker(alpha in alpha()) {
        prop_assume!(alpha < 2.0_f64.powi(1023)); // where 2α is finite
        let (float, truth) = both(&Law::from(WhittakerUncapped), alpha);
        let [k, impulse, energy] = errors(&float, &truth);
        prop_assert!(k <= rational(1, 2) && energy <= rational(1, 2));
        prop_assert_eq!(impulse, rational(0, 1));
    }
}

proptest! {
    #![proptest_config(cases(3000))]

    /// Relative errors to first order: v_t u, I_y 3u, W_tt 3u; then μ·I_y 4u and W_tt·μ·I_y 8u;
    /// q/(q + p) is as good as p/q, 9u, and two roundings: 11u; the impulse 4 + 11 + 1 = 16u.
    /// Dividing by m and subtracting from v_x0 gives 18u of the first and u of the second; with
    /// r/J, 19u and u. The second order is far below u/100.
    #[test]
    fn exact_and_float_agree_on_spheres(float in float_sphere()) {
        let truth = float.map(|&x| exact(x));
        let (computed, rebound) = (float.collide(&WangSuLi)?, truth.collide(&WangSuLi)?);
        let near = |computed: f64, truth: &Rational, terms: &[(i32, Rational)]| {
            let bound = terms.iter().fold(rational(0, 1), |sum, (roundings, size)| {
                sum + magnitude(size.clone()) * (rational(*roundings, 1) + rational(1, 100)) * two_to(-53)
            });
            magnitude(exact(computed) - truth) <= bound
        };
        let impulse = &rebound.tangential_impulse;
        prop_assert!(near(computed.tangential_impulse, impulse, &[(16, impulse.clone())]));
        let (jump, before) = (impulse / &truth.mass, &truth.before);
        prop_assert!(near(computed.after.vx, &rebound.after.vx, &[(18, jump), (1, before.vx.clone())]));
        let jump = impulse * &truth.radius / &truth.inertia;
        prop_assert!(near(computed.after.omega, &rebound.after.omega, &[(19, jump), (1, before.omega.clone())]));
        prop_assert!(near(computed.after.vy, &rebound.after.vy, &[(1, rebound.after.vy.clone())]));
    }

    #[test]
    fn the_sphere_and_alpha_tell_the_same_story(sphere in sphere()) {
        same_story(&sphere, &Law::from(WangSuLi))?;
        same_story(&sphere, &Law::from(WhittakerUncapped))?;
    }
}

/// Equations (1) to (9), (18) and (19), exactly, whenever v_t > 0; and the ledger by squares.
fn same_story(sphere: &SphereOnPlane<Rational>, law: &Law) -> Result<(), TestCaseError> {
    let contact = sphere.contact()?;
    let rebound = sphere.collide(law.over())?;
    let (before, after) = (&sphere.before, &rebound.after);
    let (i_x, i_y) = (&rebound.tangential_impulse, &rebound.normal_impulse);
    prop_assert_eq!(&sphere.mass * (&after.vy - &before.vy), -i_y.clone());
    prop_assert_eq!(&sphere.mass * (&after.vx - &before.vx), -i_x.clone());
    prop_assert_eq!(&sphere.inertia * (&after.omega - &before.omega), &sphere.radius * i_x);
    prop_assert_eq!(&after.vy, &-(&sphere.restitution * &before.vy));

    let change = |weight: &Rational, after: &Rational, before: &Rational| {
        weight * (after.square() - before.square()) / rational(2, 1)
    };
    prop_assert_eq!(&rebound.energy.normal, &change(&sphere.mass, &after.vy, &before.vy));
    prop_assert_eq!(&rebound.energy.tangential, &change(&sphere.mass, &after.vx, &before.vx));
    prop_assert_eq!(
        &rebound.energy.rotational,
        &change(&sphere.inertia, &after.omega, &before.omega)
    );

    let slip = contact.slip();
    if slip.sign().is_greater() == Some(true) {
        let alpha = contact.alpha().expect("the slip is not zero");
        let ratios = law.over().ratios(&Alpha::Finite(alpha.clone())).expect("α is finite");
        let sliding = contact.sliding_impulse();
        prop_assert!(ratios.is_consistent(&alpha));
        prop_assert_eq!(&after.vx - &after.omega * &sphere.radius, &ratios.k * slip);
        prop_assert_eq!(&rebound.slip, &(&ratios.k * slip));
        prop_assert_eq!(i_x, &(&ratios.impulse * &sliding));
        prop_assert_eq!(rebound.energy.by_friction(), &ratios.energy * sliding * slip);
    }
    Ok(())
}

fn error_of_k<F: Binary + NumberSystem>(alpha: F) -> Rational {
    let (float, truth) = both(&Law::from(WangSuLi), alpha);
    errors(&float, &truth)[0].clone()
}

/// Where the plain quotient is off by 9/4 ulp, and next above 1/3, where it is off by 2.
#[test]
fn k_is_nearly_correctly_rounded_where_the_plain_quotient_is_worst() {
    let bound = rational(51, 100);
    assert!(error_of_k(10_293_942_005_418_274.0_f64) <= bound);
    assert!(error_of_k(19_173_958.0_f32) <= bound);
    for step in 0..4 {
        assert!(error_of_k(f64::from_bits((1.0_f64 / 3.0).to_bits() + step)) <= bound);
    }
    for step in 0..4 {
        assert!(error_of_k(f32::from_bits((1.0_f32 / 3.0).to_bits() + step)) <= bound);
    }
}

/// 1 − α in floats at α = ∞ would give NaN.
#[test]
fn infinite_alpha_is_an_ordinary_input() {
    let alpha = Alpha::new(f64::INFINITY).expect("α ≥ 0");
    let ratios = WangSuLi.ratios(&alpha).expect("has a limit");
    assert_eq!((ratios.k, ratios.impulse, ratios.energy), (-1.0, 0.0, 0.0));
    assert_eq!(WhittakerUncapped.ratios(&alpha), None);
}
