//! Impact laws, written once for every number system.
//!
//! A law maps a [`Contact`] to the tangential impulse. It is generic over
//! [`Number`](kane_number::Number), so the code that runs in `f64` is the code that runs in exact
//! rationals, and the two can be compared digit by digit. The laws are in [`laws()`], what collides is
//! in [`bodies`]. What happens in time between elastic bodies is in [`compliant`].
//!
//! ```
//! use kane_impact::bodies::{CollideError, Motion, SphereOnPlane};
//! use kane_impact::laws::WangSuLi;
//! use kane_number::{Rational, parse};
//!
//! // A solid sphere, J = 2/5·m·r², that arrives at 45° without spin.
//! let n = |text| parse(text).expect("a literal");
//! let sphere = SphereOnPlane {
//!     mass: n("1"),
//!     radius: n("1"),
//!     inertia: n("2/5"),
//!     friction: n("2/7"),
//!     restitution: n("1"),
//!     before: Motion { vx: n("1"), vy: n("1"), omega: n("0") },
//! };
//! // α = 7/2·μ(1 + e)/2 = 1: the contact point comes to rest, k = 0, and i_x = 1/2.
//! assert_eq!(sphere.alpha()?, Some(n("1")));
//! let rebound = sphere.collide(&WangSuLi)?;
//! assert_eq!(rebound.tangential_impulse, n("2/7"));
//! assert_eq!(rebound.after.vx, rebound.after.omega); // v_x − ω·r = 0
//! assert_eq!(rebound.energy.total(), n("-1/7"));
//! # Ok::<(), CollideError<Rational>>(())
//! ```
//!
//! # Signs
//!
//! x is along the plane and y points into it. The approach speed is v_y0 ≥ 0, the tangential
//! velocity of the contact point is v_t = v_x − ω·r, and the impulses on the sphere are −I_x along
//! x and −I_y along y, so that I_x > 0 opposes v_t > 0:
//!
//! ```text
//! m·(v_y − v_y0) = −I_y      m·(v_x − v_x0) = −I_x      J·(ω − ω0) = r·I_x
//! ```
//!
//! The first is not equation (1) of Wang, Su and Li, which prints +I_y: with their (4),
//! v_y = −e·v_y0, that would make I_y = −m·(1 + e)·v_y0, whereas their text uses
//! I_y = m·(1 + e)·v_y0 ≥ 0. We follow the text.
#![deny(clippy::float_arithmetic)]

mod alpha;
mod arithmetic;
pub mod batch;
pub mod bodies;
mod catalogue;
pub mod compliant;
mod contact;
pub mod decide;
mod delassus;
pub mod double;
pub mod exact;
mod frame;
mod impulse;
mod info;
mod invalid;
mod law;
pub mod laws;
pub mod oracle;
mod outcome;
mod over;
mod parameters;
mod spatial;
mod spatial_contact;

pub mod puzzle;
mod resolution;

pub use alpha::{Alpha, InvalidAlpha, Ratios};
pub use catalogue::{Law, NumberSystem, law, laws};
pub use contact::{Contact, Facing};
pub use delassus::Delassus;
pub use frame::Frame;
pub use impulse::Impulse;
pub use info::{Lasting, LawInfo, ModelInfo, Parameter, Provenance, Restitution};
pub use invalid::InvalidInput;
pub use law::{Chosen, Coefficients, Formula, Guard, ImpactLaw, Regime, Relation, Root};
pub use outcome::{Outcome, Work};
pub use over::{Equation, Formulas, LawOver, RegimeOver, Taken};
pub use parameters::{UnknownParameter, set_parameter};
pub use resolution::NoImpulse;
pub use spatial::{SpatialDelassus, Symmetric};
pub use spatial_contact::SpatialContact;
