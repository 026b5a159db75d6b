//! What is refused at the door, by name and with its value.

use kane_impact::bodies::{CollideError, Motion, SphereOnPlane};
use kane_impact::laws::WangSuLi;
use kane_impact::{Alpha, InvalidAlpha, InvalidInput};

const SPHERE: SphereOnPlane<f64> = SphereOnPlane {
    mass: 2.0,
    radius: 0.5,
    inertia: 0.2,
    friction: 0.3,
    restitution: 0.8,
    before: Motion { vx: 1.0, vy: 1.5, omega: -2.0 },
};

fn refusal(spoil: impl Fn(&mut SphereOnPlane<f64>)) -> String {
    let mut sphere = SPHERE;
    spoil(&mut sphere);
    let error = sphere.collide(&WangSuLi).expect_err("spoilt");
    error.to_string()
}

#[test]
fn each_input_outside_its_domain_is_named() {
    for (message, shown) in [
        (refusal(|s| s.mass = 0.0), "the mass is 0, but must be positive"),
        (refusal(|s| s.mass = f64::NAN), "the mass is NaN, which is not finite"),
        (refusal(|s| s.radius = -1.0), "the radius is -1, but must be positive"),
        (refusal(|s| s.inertia = -0.0), "the moment of inertia is -0, but must be positive"),
        (
            refusal(|s| s.friction = -0.1),
            "the friction coefficient is -0.1, but must not be negative",
        ),
        (refusal(|s| s.restitution = 1.5), "the restitution is 1.5, but must not exceed 1"),
        (refusal(|s| s.restitution = -0.5), "the restitution is -0.5, but must not be negative"),
        (refusal(|s| s.before.vy = -1.0), "the approach speed is -1, but must not be negative"),
        (
            refusal(|s| s.before.vx = f64::INFINITY),
            "the tangential velocity is inf, which is not finite",
        ),
        (
            refusal(|s| s.before.omega = f64::NAN),
            "the angular velocity is NaN, which is not finite",
        ),
    ] {
        assert_eq!(message, shown);
    }
}

#[test]
fn leaving_the_range_of_floats_is_an_error_and_not_a_nan() {
    let mut sphere = SPHERE;
    sphere.before.vx = f64::MAX;
    sphere.before.omega = -f64::MAX;
    let error = sphere.collide(&WangSuLi);
    let Err(CollideError::Invalid(InvalidInput::NotFinite { quantity, value })) = error else {
        unreachable!("{error:?}");
    };
    assert_eq!((quantity, value), ("the slip after", f64::INFINITY));
}

#[test]
fn alpha_is_at_least_zero() {
    assert_eq!(Alpha::new(-1.0), Err(InvalidAlpha::Negative(-1.0)));
    assert!(matches!(Alpha::new(f64::NAN), Err(InvalidAlpha::UnknownSign(_))));
    assert_eq!(Alpha::new(-0.0), Ok(Alpha::Finite(0.0)));
    assert_eq!(Alpha::new(f64::INFINITY), Ok(Alpha::Infinite));
}
