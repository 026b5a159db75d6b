use kane_impact::bodies::{Motion, SphereOnPlane};
use kane_number::{Rational, decode};
use proptest::prelude::*;

use crate::{rational, two_to};

/// Non-negative finite floats, as α: the whole range of exponents, the neighbourhoods where a
/// binade or a regime of rounding ends, and the places where 1 ± α is a tie.
pub(crate) fn alpha() -> impl Strategy<Value = f64> {
    let any_exponent = (0..f64::INFINITY.to_bits()).prop_map(f64::from_bits);
    let moderate = (-60_i32..60, any::<u32>()).prop_map(|(exponent, fraction)| {
        (1.0 + f64::from(fraction) * 2.0_f64.powi(-32)) * 2.0_f64.powi(exponent)
    });
    let centres = prop::sample::select(vec![
        1.0 / 3.0,
        0.5,
        1.0,
        2.0,
        3.0,
        2.0_f64.powi(-53),
        2.0_f64.powi(53),
        2.0_f64.powi(54),
        2.0_f64.powi(56) / 7.0, // the worst case of k, see `agreement`
        2.0_f64.powi(537),      // i_x² underflows
        2.0_f64.powi(1022),     // i_x becomes subnormal
        f64::MIN_POSITIVE,
    ]);
    let near = (centres, -40_i64..40)
        .prop_map(|(centre, steps)| f64::from_bits(centre.to_bits().wrapping_add_signed(steps)));
    let ties = (1_u64 << 52..1 << 54, 1_i32..80)
        .prop_map(|(odd, halvings)| exact_float(odd | 1) * 2.0_f64.powi(-halvings));
    let edges = prop::sample::select(vec![0.0, f64::from_bits(1), f64::MAX]);
    prop_oneof![3 => any_exponent, 3 => moderate, 3 => near, 2 => ties, 1 => edges]
}

fn exact_float(integer: u64) -> f64 {
    let (high, low) = (integer >> 32, integer & 0xffff_ffff);
    let part = |bits: u64| f64::from(u32::try_from(bits).expect("32 bits"));
    part(high) * 2.0_f64.powi(32) + part(low)
}

/// Positive rationals: small fractions, and the same scaled by extreme powers of two.
pub(crate) fn positive() -> impl Strategy<Value = Rational> {
    let small = (1_i32..1000, 1_i32..1000).prop_map(|(n, d)| rational(n, d));
    let scale = prop_oneof![3 => Just(0), 1 => -1074..1024_i32];
    (small, scale).prop_map(|(number, scale)| number * two_to(scale))
}

/// Zero one time in eight, otherwise positive.
pub(crate) fn not_negative() -> impl Strategy<Value = Rational> {
    prop_oneof![1 => Just(rational(0, 1)), 7 => positive()]
}

/// Of either sign, zero included.
pub(crate) fn signed() -> impl Strategy<Value = Rational> {
    (not_negative(), any::<bool>()).prop_map(|(n, negative)| if negative { -n } else { n })
}

/// 0 ≤ e ≤ 1, often at an end or next to it.
pub(crate) fn restitution() -> impl Strategy<Value = Rational> {
    prop_oneof![
        1 => Just(rational(0, 1)),
        1 => Just(rational(1, 1)),
        1 => (1..1074_i32).prop_map(|n| rational(1, 1) - two_to(-n)),
        3 => (0_i32..=1000).prop_map(|n| rational(n, 1000)),
    ]
}

/// Spheres with exact data: huge ratios of mass and inertia, μ = 0, grazing, slip of either sign.
pub(crate) fn sphere() -> impl Strategy<Value = SphereOnPlane<Rational>> {
    let body = (positive(), positive(), positive());
    let surface = (not_negative(), restitution());
    let before = (signed(), not_negative(), signed());
    (body, surface, before).prop_map(
        |((mass, radius, inertia), (friction, restitution), (vx, vy, omega))| SphereOnPlane {
            mass,
            radius,
            inertia,
            friction,
            restitution,
            before: Motion { vx, vy, omega },
        },
    )
}

/// Spheres with float data of exponents within ±60, so that no product under- or overflows; one
/// time in four v_x0 and ω0·r agree to nearly all digits.
pub(crate) fn float_sphere() -> impl Strategy<Value = SphereOnPlane<f64>> {
    let magnitude = || {
        (-60_i32..60, any::<u64>()).prop_map(|(exponent, bits)| {
            f64::from_bits(1.0_f64.to_bits() | bits >> 12) * 2.0_f64.powi(exponent)
        })
    };
    let signed = || (magnitude(), any::<bool>()).prop_map(|(x, sign)| if sign { -x } else { x });
    let unit =
        prop_oneof![Just(0.0), Just(1.0), (0..=1000_u32).prop_map(|n| f64::from(n) / 1000.0)];
    let cancelling = prop_oneof![3 => Just(None), 1 => (-4_i64..4).prop_map(Some)];
    let body = (magnitude(), magnitude(), magnitude());
    (body, magnitude(), unit, signed(), magnitude(), signed(), cancelling).prop_map(
        |((mass, radius, inertia), friction, restitution, vx, vy, omega, cancelling)| {
            let vx = cancelling.map_or(vx, |steps| {
                f64::from_bits((omega * radius).to_bits().wrapping_add_signed(steps))
            });
            let before = Motion { vx, vy, omega };
            SphereOnPlane { mass, radius, inertia, friction, restitution, before }
        },
    )
}

pub(crate) fn exact(float: f64) -> Rational {
    decode(float).expect("the strategy gives finite floats")
}
