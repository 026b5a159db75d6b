use kane_impact::bodies::{Motion, SphereOnPlane};
use kane_impact::laws::{WangSuLi, WhittakerUncapped};
use kane_impact::{ImpactLaw as _, Law, NumberSystem};
use kane_number::{Number, Rational};
use proptest::prelude::*;

use crate::strategies::{float_sphere, sphere};
use crate::{cases, rational};

fn mirrored<N: Number>(sphere: &SphereOnPlane<N>) -> SphereOnPlane<N> {
    let Motion { vx, vy, omega } = sphere.before.clone();
    let before = Motion { vx: -vx, vy, omega: -omega };
    SphereOnPlane { before, ..sphere.clone() }
}

/// A mirrored collision is the mirror image of the collision: to the bit, in floats too.
fn is_odd<N: NumberSystem + PartialEq>(
    law: &Law,
    sphere: &SphereOnPlane<N>,
) -> Result<(), TestCaseError> {
    let fail = |error| TestCaseError::fail(format!("{error:?}"));
    let rebound = sphere.collide(law.over()).map_err(fail)?;
    let mirror = mirrored(sphere).collide(law.over()).map_err(fail)?;
    prop_assert_eq!(&mirror.tangential_impulse, &-rebound.tangential_impulse.clone());
    prop_assert_eq!(&mirror.normal_impulse, &rebound.normal_impulse);
    prop_assert_eq!(&mirror.after.vx, &-rebound.after.vx.clone());
    prop_assert_eq!(&mirror.after.omega, &-rebound.after.omega.clone());
    prop_assert_eq!(&mirror.energy, &rebound.energy);
    Ok(())
}

proptest! {
    #![proptest_config(cases(3000))]

    #[test]
    fn odd_symmetry(sphere in sphere(), float in float_sphere()) {
        for law in [Law::from(WangSuLi), Law::from(WhittakerUncapped)] {
            is_odd(&law, &sphere)?;
            is_odd(&law, &float)?;
        }
    }

    /// Where the contact point does not slide, the collision is a normal one.
    #[test]
    fn total_at_zero_slip(mut sphere in sphere()) {
        sphere.before.vx = &sphere.before.omega * &sphere.radius;
        let rebound = sphere.collide(&WangSuLi)?;
        prop_assert_eq!(&rebound.tangential_impulse, &rational(0, 1));
        prop_assert_eq!(&rebound.after.vx, &sphere.before.vx);
        prop_assert_eq!(&rebound.after.omega, &sphere.before.omega);
        prop_assert_eq!(&rebound.after.vy, &-(&sphere.restitution * &sphere.before.vy));
    }

    /// |I_x| ≤ μ·I_y everywhere, and |I_x| ≤ 2|v_t|/W_tt, so that the law is continuous at v_t = 0.
    #[test]
    fn the_impulse_stays_in_the_friction_cone_and_vanishes_with_the_slip(sphere in sphere()) {
        let contact = sphere.contact()?;
        let size = |x: Rational| if x < rational(0, 1) { -x } else { x };
        let impulse = size(WangSuLi.impulse(&contact)?.tangential);
        prop_assert!(impulse <= contact.sliding_impulse());
        prop_assert!(impulse * contact.delassus().tt() <= rational(2, 1) * size(contact.slip().clone()));
    }
}

proptest! {
    #![proptest_config(cases(60_000))]

    /// Whatever eight floats are given: an outcome of finite numbers, or an error that says why.
    #[test]
    fn no_float_input_gives_nan(bits in any::<[u64; 8]>(), masks in any::<u8>()) {
        // Three in four are between 1/2 and 1, to get past the checks; the others are any float.
        let input: Vec<f64> = bits.iter().enumerate().map(|(n, &bits)| {
            let wild = masks >> n & 1 == 1 && bits % 2 == 1;
            f64::from_bits(if wild { bits } else { 0.5_f64.to_bits() | bits >> 12 })
        }).collect();
        let &[mass, radius, inertia, friction, restitution, vx, vy, omega] = &input[..] else {
            unreachable!("eight numbers");
        };
        let before = Motion { vx, vy, omega };
        let sphere = SphereOnPlane { mass, radius, inertia, friction, restitution, before };
        if let Ok(rebound) = sphere.collide(&WangSuLi) {
            let Motion { vx, vy, omega } = rebound.after;
            let energy = rebound.energy.total();
            let all = [rebound.tangential_impulse, rebound.normal_impulse, vx, vy, omega, energy];
            prop_assert!(all.into_iter().all(f64::is_finite), "{all:?}");
        }
    }
}

/// No slip, no friction, no approach, no rebound: alone and together, in floats.
#[test]
fn corners_are_ordinary_inputs() {
    for corner in 0..16_u8 {
        let switch = |bit: u8, on: f64| if corner >> bit & 1 == 1 { 0.0 } else { on };
        let sphere = SphereOnPlane {
            mass: 2.0,
            radius: 0.5,
            inertia: 0.2,
            friction: switch(0, 0.3),
            restitution: switch(1, 0.8),
            before: Motion { vx: 1.0 + switch(2, 3.0), vy: switch(3, 1.5), omega: 2.0 },
        };
        for rebound in [sphere.collide(&WangSuLi), sphere.collide(&WhittakerUncapped)] {
            let rebound = rebound.expect("a corner is inside the domain");
            let nothing_tangential = corner & 0b1101 != 0;
            assert_eq!(rebound.tangential_impulse == 0.0, nothing_tangential, "{corner:04b}");
            assert!(rebound.energy.total() <= 0.0, "{corner:04b}");
        }
    }
}
