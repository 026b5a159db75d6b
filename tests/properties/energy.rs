use kane_impact::Contact;
use kane_impact::bodies::{Motion, SphereOnPlane};
use kane_impact::laws::{WangSuLi, WhittakerUncapped};
use kane_number::Rational;
use proptest::prelude::*;

use crate::strategies::{positive, restitution, sphere};
use crate::{cases, rational, two_to};

/// j_p·μ²·(1 + e)·(α − 1) > (1 − e)·α, for v_t ≠ 0 with α formed from |v_t|.
///
/// Derivation. By (18) and (23) friction changes the energy by μ·I_y·v_t·(α − 1), and restitution
/// by −m·v_y0²·(1 − e²)/2. With I_y = m·(1 + e)·v_y0 and v_t = j_p·μ·(1 + e)·v_y0/(2α) from (7),
///
/// ```text
/// ΔE = m·(1 + e)·v_y0²/(2α) · [ j_p·μ²·(1 + e)·(α − 1) − (1 − e)·α ]
/// ```
///
/// and the factor is positive for α > 0. At α = 0, that is μ = 0 or v_y0 = 0, the criterion reads
/// −j_p·μ²·(1 + e) > 0, which is false, as ΔE ≤ 0 is.
fn criterion(sphere: &SphereOnPlane<Rational>, alpha: &Rational) -> bool {
    let one = rational(1, 1);
    lever(sphere) * (alpha - &one) > (one - &sphere.restitution) * alpha
}

/// j_p·μ²·(1 + e), with j_p = 1 + m·r²/J.
fn lever(sphere: &SphereOnPlane<Rational>) -> Rational {
    let one = rational(1, 1);
    let j_p = &one + &sphere.mass * &sphere.radius * &sphere.radius / &sphere.inertia;
    j_p * &sphere.friction * &sphere.friction * (one + &sphere.restitution)
}

fn sliding_change(contact: &Contact<Rational>) -> Rational {
    contact.sliding_impulse() * contact.delassus().tt()
}

fn gains(sphere: &SphereOnPlane<Rational>) -> Result<bool, TestCaseError> {
    Ok(sphere.collide(&WhittakerUncapped)?.energy.total() > rational(0, 1))
}

proptest! {
    #![proptest_config(cases(4500))]

    /// In the normal direction, in the tangential and rotational directions together, in total.
    #[test]
    fn energy_never_rises(sphere in sphere()) {
        let energy = sphere.collide(&WangSuLi)?.energy;
        let zero = rational(0, 1);
        prop_assert!(energy.normal <= zero);
        prop_assert!(energy.by_friction() <= zero);
        prop_assert!(energy.total() <= zero);
    }

    #[test]
    fn whittaker_gains_energy_exactly_when(sphere in sphere()) {
        let expected = match sphere.contact()?.alpha() {
            Some(alpha) if alpha < rational(0, 1) => criterion(&sphere, &-alpha),
            Some(alpha) => criterion(&sphere, &alpha),
            None => false, // no slip, no impulse
        };
        prop_assert_eq!(gains(&sphere)?, expected);
    }

    /// The same with the threshold planted: α* = c/(c − 1 + e) with c = j_p·μ²·(1 + e) > 1 − e, and
    /// the slip chosen so that α is at α*, or off it by a hair. Both directions, every time.
    #[test]
    fn whittaker_gains_energy_exactly_beyond_the_threshold(
        body in (positive(), positive(), positive()),
        excess in positive(),
        restitution in restitution(),
        (vy, omega) in (positive(), positive()),
        hair in 1_i32..200,
    ) {
        let (mass, radius, inertia) = body;
        let friction = rational(1, 1) + excess; // then c ≥ j_p·μ² > 1 ≥ 1 − e
        let before = Motion { vx: rational(0, 1), vy, omega };
        let mut sphere = SphereOnPlane { mass, radius, inertia, friction, restitution, before };
        let lever = lever(&sphere);
        let threshold = &lever / (&lever - rational(1, 1) + &sphere.restitution);
        let sliding = sliding_change(&sphere.contact()?);
        for side in [-1, 0, 1] {
            let alpha = &threshold * (rational(1, 1) + two_to(-hair) * rational(side, 1));
            let slip = &sliding / (rational(2, 1) * &alpha);
            sphere.before.vx = slip + &sphere.before.omega * &sphere.radius;
            prop_assert_eq!(sphere.contact()?.alpha(), Some(alpha.clone()));
            prop_assert_eq!(criterion(&sphere, &alpha), side > 0);
            prop_assert_eq!(gains(&sphere)?, side > 0);
        }
    }
}

/// Numbers to check by hand: a solid sphere, e = 1, μ = 1, α = 7/2·1·2·1/2/v_t = 7/2 at v_t = 1.
#[test]
fn whittaker_creates_energy_on_a_plain_sphere() {
    let n = |n| rational(n, 1);
    let sphere = SphereOnPlane {
        mass: n(1),
        radius: n(1),
        inertia: rational(2, 5),
        friction: n(1),
        restitution: n(1),
        before: Motion { vx: n(1), vy: n(1), omega: n(0) },
    };
    let whittaker = sphere.collide(&WhittakerUncapped).expect("valid");
    assert_eq!(whittaker.energy.total(), n(5)); // 2·(7/2 − 1)
    let paper = sphere.collide(&WangSuLi).expect("valid");
    assert_eq!(paper.energy.total(), rational(-8, 81)); // −2/(9/2)²
}
