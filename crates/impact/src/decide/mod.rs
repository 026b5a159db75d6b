//! Signs that are right for every finite input: which regime, energy gained or lost, inside the
//! friction cone.
//!
//! A decision asks for the sign of a polynomial in the inputs of a [`SphereOnPlane<f64>`]. Three
//! [stages](Stage) are tried in turn, the cheapest first: plain floats with a proved bound on their
//! error, intervals, and exact integers. The answer is that of exact arithmetic on the floats as
//! given, always, also at a tie; the stage says what it took.
//!
//! ```
//! use std::cmp::Ordering;
//! use kane_impact::bodies::{Motion, SphereOnPlane};
//! use kane_impact::decide::{self, Stage};
//!
//! // in floats sliding ends at rest: 0.1 + 0.2 is vy; in numbers it would turn the slip round
//! let sphere = SphereOnPlane {
//!     mass: 1.0,
//!     radius: 1.0,
//!     inertia: 1.0,
//!     friction: 0.5,
//!     restitution: 0.0,
//!     before: Motion { vx: 0.1, vy: 0.30000000000000004, omega: -0.2 },
//! };
//! let decision = decide::sliding(&sphere)?;
//! assert_eq!((decision.sign, decision.stage), (Ordering::Less, Stage::Fixed));
//! # Ok::<(), kane_impact::InvalidInput<f64>>(())
//! ```
//!
//! All decisions are exact, and refuse the inputs that
//! [`collide`](crate::bodies::SphereOnPlane::collide) refuses; they never refuse a result for
//! its size.

pub(crate) mod arithmetic;
mod column;
mod dyadic;
mod filter;
mod fraction;
pub(crate) mod question;

pub use column::{Spheres, sliding_all};
pub(crate) use dyadic::Dyadic;
pub use fraction::Fraction;

use std::cmp::Ordering;

use kane_number::{Fixed, Interval};

use crate::InvalidInput;
use crate::bodies::SphereOnPlane;
use crate::invalid::{finite, fraction, not_negative, positive};
use arithmetic::Arithmetic;
use filter::Filter;
use question::{Cone, FrictionGain, Gain, Question, Sliding, Slip};

/// What it took to decide a sign, the cheapest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stage {
    /// Plain floats with a bound on their error that is proved in advance.
    Filter,
    /// Intervals.
    Interval,
    /// Integers of at most 1024 bits.
    Fixed,
    /// Integers of any size.
    Big,
}

/// The sign of a quantity, certain for the floats as given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decision {
    /// How the quantity compares with zero.
    pub sign: Ordering,
    /// The last stage that was needed.
    pub stage: Stage,
}

/// How many decisions each stage made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Shares {
    /// By [`Stage::Filter`].
    pub filter: u64,
    /// By [`Stage::Interval`].
    pub interval: u64,
    /// By [`Stage::Fixed`].
    pub fixed: u64,
    /// By [`Stage::Big`].
    pub big: u64,
}

impl Shares {
    /// Counts one decision more.
    pub const fn count(&mut self, stage: Stage) {
        let share = match stage {
            Stage::Filter => &mut self.filter,
            Stage::Interval => &mut self.interval,
            Stage::Fixed => &mut self.fixed,
            Stage::Big => &mut self.big,
        };
        *share += 1;
    }

    /// How many decisions were counted.
    #[must_use]
    pub const fn total(&self) -> u64 {
        self.filter + self.interval + self.fixed + self.big
    }
}

/// Decides the sign of the slip v = v_x − ω·r.
///
/// # Errors
/// [`InvalidInput`] for the first input outside its domain.
#[inline]
pub fn slip(sphere: &SphereOnPlane<f64>) -> Result<Decision, InvalidInput<f64>> {
    decide(&Slip, sphere)
}

/// Decides the sign of |v| − `W_tt`·S, the slip that sliding to the end would leave: that of 1 − 2α
/// where there is slip.
///
/// `Less` where the slip would turn round, so that the laws with a stop leave the regime of sliding;
/// `Equal` where it ends at rest exactly.
///
/// # Errors
/// [`InvalidInput`] for the first input outside its domain.
#[inline]
pub fn sliding(sphere: &SphereOnPlane<f64>) -> Result<Decision, InvalidInput<f64>> {
    decide(&Sliding, sphere)
}

/// Decides the sign of the work of friction under
/// [`WhittakerUncapped`](crate::laws::WhittakerUncapped): that of α − 1 where there is slip and
/// friction, and `Equal` elsewhere.
///
/// # Errors
/// [`InvalidInput`] for the first input outside its domain.
#[inline]
pub fn friction_work(sphere: &SphereOnPlane<f64>) -> Result<Decision, InvalidInput<f64>> {
    let gain = decide(&FrictionGain, sphere)?;
    if sphere.friction == 0.0 || sphere.before.vy == 0.0 {
        return Ok(Decision { sign: Ordering::Equal, ..gain });
    }
    // b·s > 0, so that v = 0 is excluded unless this is positive
    match gain.sign {
        Ordering::Greater => unless_at_rest(sphere, gain, Ordering::Equal),
        _ => Ok(gain),
    }
}

/// Decides the sign of the change of all kinetic energy under
/// [`WhittakerUncapped`](crate::laws::WhittakerUncapped):
///
/// ```text
/// ΔE = m·(1 + e)·v_y²/(2α) · [ j_p·μ²·(1 + e)·(α − 1) − (1 − e)·α ]    j_p = 1 + m·r²/J
/// ```
///
/// and −m·v_y²·(1 − e²)/2 without slip, where that law has no friction.
///
/// # Errors
/// [`InvalidInput`] for the first input outside its domain.
#[inline]
pub fn energy(sphere: &SphereOnPlane<f64>) -> Result<Decision, InvalidInput<f64>> {
    let gain = decide(&Gain, sphere)?;
    if sphere.before.vy == 0.0 {
        return Ok(Decision { sign: Ordering::Equal, ..gain });
    }
    // where the question is negative at v = 0, so is −(1 − e): its last term is the only negative
    match gain.sign {
        Ordering::Less => Ok(gain),
        _ if sphere.restitution < 1.0 => unless_at_rest(sphere, gain, Ordering::Less),
        _ => unless_at_rest(sphere, gain, Ordering::Equal),
    }
}

/// Decides the sign of μ·m·(1 + e)·v_y − |I_x|: whether a tangential impulse is inside the friction
/// cone (`Greater`), on it (`Equal`) or outside.
///
/// # Errors
/// [`InvalidInput`] for the first input outside its domain, the impulse last.
#[inline]
pub fn in_cone(
    sphere: &SphereOnPlane<f64>,
    tangential: f64,
) -> Result<Decision, InvalidInput<f64>> {
    if !tangential.is_finite() {
        check(sphere)?;
        finite("the tangential impulse", tangential)?;
    }
    decide(&Cone { tangential }, sphere)
}

/// A decision that holds with slip, or the sign that holds without.
#[inline]
fn unless_at_rest(
    sphere: &SphereOnPlane<f64>,
    moving: Decision,
    at_rest: Ordering,
) -> Result<Decision, InvalidInput<f64>> {
    let slip = decide(&Slip, sphere)?;
    let sign = if slip.sign == Ordering::Equal { at_rest } else { moving.sign };
    Ok(Decision { sign, stage: moving.stage.max(slip.stage) })
}

#[inline]
fn decide<Q: Question>(
    question: &Q,
    sphere: &SphereOnPlane<f64>,
) -> Result<Decision, InvalidInput<f64>> {
    if is_usual(sphere)
        && question.is_usual()
        && let Some(sign) = question.value::<Filter>(sphere).sign()
    {
        return Ok(Decision { sign, stage: Stage::Filter });
    }
    decide_later(question, sphere)
}

/// Whether all inputs are in their domains and at most what the filter allows, each by one comparison
/// of its bits; says no to −0 where no sign is allowed, which [`check`] then accepts.
#[inline]
fn is_usual(sphere: &SphereOnPlane<f64>) -> bool {
    let positive = |x: f64| x.to_bits().wrapping_sub(1) < filter::GREATEST;
    let not_negative = |x: f64| x.to_bits() <= filter::GREATEST;
    positive(sphere.mass)
        && positive(sphere.radius)
        && positive(sphere.inertia)
        && not_negative(sphere.friction)
        && sphere.restitution.to_bits() <= 1.0_f64.to_bits()
        && not_negative(sphere.before.vy)
        && filter::is_small(sphere.before.vx)
        && filter::is_small(sphere.before.omega)
}

/// The domains in the order and the words of [`collide`](SphereOnPlane::collide).
pub(crate) fn check(sphere: &SphereOnPlane<f64>) -> Result<(), InvalidInput<f64>> {
    positive("the radius", sphere.radius)?;
    positive("the mass", sphere.mass)?;
    positive("the moment of inertia", sphere.inertia)?;
    finite("the tangential velocity", sphere.before.vx)?;
    finite("the normal velocity", sphere.before.vy)?;
    finite("the angular velocity", sphere.before.omega)?;
    not_negative("the approach speed", sphere.before.vy)?;
    not_negative("the friction coefficient", sphere.friction)?;
    fraction("the restitution", sphere.restitution)?;
    Ok(())
}

/// The stages after the first.
#[cold]
#[inline(never)]
fn decide_later<Q: Question>(
    question: &Q,
    sphere: &SphereOnPlane<f64>,
) -> Result<Decision, InvalidInput<f64>> {
    check(sphere)?;
    let by = |stage| move |sign| Decision { sign, stage };
    let decision = Arithmetic::sign(&question.value::<Interval>(sphere))
        .map(by(Stage::Interval))
        .or_else(|| question.value::<Fixed>(sphere).sign().map(by(Stage::Fixed)))
        .or_else(|| question.value::<Dyadic>(sphere).sign().map(by(Stage::Big)));
    Ok(decision.expect("integers of any size hold every sign"))
}
