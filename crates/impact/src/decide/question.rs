//! The questions, each one polynomial in the inputs of a sphere.
//!
//! With v = v_x − ω·r, s = μ·(1 + e)·v_y and b = J + m·r², the quantities of a law on a sphere are
//!
//! ```text
//! S = m·s    W_tt = b/(m·J)    α = W_tt·S/(2·|v|) = b·s/(2·J·|v|)
//! ```
//!
//! so that every sign in terms of α becomes one of sums and products.

use super::arithmetic::Arithmetic;
use super::filter::is_small;
use crate::bodies::SphereOnPlane;

/// A quantity whose sign is asked.
pub(super) trait Question {
    /// Whether its inputs besides the sphere's are finite and at most what the filter allows.
    #[inline]
    fn is_usual(&self) -> bool {
        true
    }

    /// The quantity, up to a positive factor.
    fn value<A: Arithmetic>(&self, sphere: &SphereOnPlane<f64>) -> A;
}

/// v = v_x − ω·r.
#[inline]
pub(crate) fn slip<A: Arithmetic>(sphere: &SphereOnPlane<f64>) -> A {
    let turning = A::number(sphere.before.omega).times(&A::size(sphere.radius));
    A::number(sphere.before.vx).minus(&turning)
}

/// s = μ·(1 + e)·v_y.
#[inline]
pub(crate) fn sliding<A: Arithmetic>(sphere: &SphereOnPlane<f64>) -> A {
    let closing = A::one_and(sphere.restitution).times(&A::size(sphere.before.vy));
    A::size(sphere.friction).times(&closing)
}

/// b·s with b = J + m·r²: what sliding takes from J·|v|.
#[inline]
pub(crate) fn slowing<A: Arithmetic>(sphere: &SphereOnPlane<f64>) -> A {
    let radius = A::size(sphere.radius);
    let orbit = A::size(sphere.mass).times(&radius).times(&radius);
    A::size(sphere.inertia).plus(&orbit).times(&sliding(sphere))
}

/// J·|v|.
#[inline]
pub(crate) fn reach<A: Arithmetic>(sphere: &SphereOnPlane<f64>) -> A {
    A::size(sphere.inertia).times(&slip::<A>(sphere).abs())
}

/// The slip itself.
pub(super) struct Slip;

impl Question for Slip {
    #[inline]
    fn value<A: Arithmetic>(&self, sphere: &SphereOnPlane<f64>) -> A {
        slip(sphere)
    }
}

/// J·|v| − b·s = J·|v|·(1 − 2α).
pub(super) struct Sliding;

impl Question for Sliding {
    #[inline]
    fn value<A: Arithmetic>(&self, sphere: &SphereOnPlane<f64>) -> A {
        reach::<A>(sphere).minus(&slowing(sphere))
    }
}

/// b·s − 2·J·|v| = 2·J·|v|·(α − 1).
pub(super) struct FrictionGain;

impl Question for FrictionGain {
    #[inline]
    fn value<A: Arithmetic>(&self, sphere: &SphereOnPlane<f64>) -> A {
        slowing::<A>(sphere).minus(&reach::<A>(sphere).double())
    }
}

/// μ·(b·s − 2·J·|v|) − J·v_y·(1 − e).
///
/// ΔE = S·(W_tt·S/2 − |v|) − m·v_y²·(1 − e²)/2 is this times m·(1 + e)·v_y/(2·J).
pub(super) struct Gain;

impl Question for Gain {
    #[inline]
    fn value<A: Arithmetic>(&self, sphere: &SphereOnPlane<f64>) -> A {
        let won = A::size(sphere.friction).times(&FrictionGain.value::<A>(sphere));
        let lost = A::size(sphere.inertia).times(&A::size(sphere.before.vy));
        won.minus(&lost.times(&A::one_less(sphere.restitution)))
    }
}

/// m·s − |I_x|.
pub(super) struct Cone {
    pub(super) tangential: f64,
}

impl Question for Cone {
    #[inline]
    fn is_usual(&self) -> bool {
        is_small(self.tangential)
    }

    #[inline]
    fn value<A: Arithmetic>(&self, sphere: &SphereOnPlane<f64>) -> A {
        let limit = A::size(sphere.mass).times(&sliding(sphere));
        limit.minus(&A::number(self.tangential).abs())
    }
}
