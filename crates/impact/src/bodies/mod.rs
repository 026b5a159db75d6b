//! Bodies: what a contact is made of, in physical inputs, and how they move afterwards.
//!
//! Whatever is formed from the data of bodies, the slip above all, is formed in the wider companion
//! of the number system ([`Number::Wide`]) and rounded once. For `f64`
//! that is a double-double with an exponent of its own, so that nothing cancels, overflows or
//! underflows on the way.

mod collision;
mod double_pendulum;
mod planar_body;
mod shape;
mod sphere_on_plane;

pub use collision::{Collided, Collision, Ledger};
pub use double_pendulum::{Direction, DoublePendulum, Swung};
pub use planar_body::PlanarBody;
pub use shape::{Shape, UnknownShape};
pub use sphere_on_plane::{Rebound, SphereOnPlane};

use kane_number::{Number, Real};

use crate::{Contact, InvalidInput, NoImpulse, Outcome};

/// The planar motion of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion<N> {
    /// Velocity of the centre of mass along x, the tangent; m/s.
    pub vx: N,
    /// Velocity of the centre of mass along y; m/s.
    pub vy: N,
    /// Angular velocity; rad/s.
    pub omega: N,
}

impl<N> Motion<N> {
    /// The same motion in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> Motion<M> {
        Motion { vx: to(&self.vx), vy: to(&self.vy), omega: to(&self.omega) }
    }
}

/// Why a collision has no outcome.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CollideError<N> {
    /// The input is outside the domain, or a result is outside the range of the number system.
    #[error(transparent)]
    Invalid(#[from] InvalidInput<N>),
    /// The law gives no impulse.
    #[error(transparent)]
    NoImpulse(#[from] NoImpulse),
}

/// The wider companion of a number system.
type Wide<N> = <N as Real>::WideReal;

/// Rounds a quantity once, unless it is beyond the range.
fn narrow<N: Real>(quantity: &'static str, wide: &Wide<N>) -> Result<N, InvalidInput<N>> {
    crate::invalid::finite(quantity, N::narrow(wide))
}

/// Narrows the complaint about a wide value.
fn narrow_error<N: Real>(error: InvalidInput<Wide<N>>) -> InvalidInput<N> {
    error.map(N::narrow)
}

fn narrow_contact<N: Real>(wide: &Contact<Wide<N>>) -> Result<Contact<N>, InvalidInput<N>> {
    let narrowed = wide.map(N::narrow);
    let w = narrowed.delassus();
    for (quantity, value) in [
        ("the slip", narrowed.slip()),
        ("the approach speed", narrowed.approach()),
        ("the tangential mobility W_tt", w.tt()),
        ("the coupling W_tn", w.tn()),
        ("the normal mobility W_nn", w.nn()),
    ] {
        crate::invalid::finite(quantity, value.clone())?;
    }
    Ok(narrowed)
}

fn narrow_outcome<N: Real>(wide: &Outcome<Wide<N>>) -> Result<Outcome<N>, InvalidInput<N>> {
    let narrowed = wide.map(N::narrow);
    for (quantity, value) in [
        ("the tangential impulse", &narrowed.impulse.tangential),
        ("the normal impulse", &narrowed.impulse.normal),
        ("the slip after", &narrowed.slip),
        ("the speed of separation", &narrowed.separation),
        ("the work of the normal impulse", &narrowed.work.normal),
        ("the work of friction", &narrowed.work.tangential),
    ] {
        crate::invalid::finite(quantity, value.clone())?;
    }
    Ok(narrowed)
}

fn half<N: Number>(x: N) -> N {
    x / N::one().double()
}
