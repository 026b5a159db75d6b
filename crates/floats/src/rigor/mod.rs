//! Rigorous bounds on round-off.
//!
//! Over a box of inputs, a forward pass gives for every operation a linear form of its exact
//! value, an enclosure of what the machine holds, and a bound on the distance between the two. A backward
//! pass gives ∂result/∂operation over all values in between, so that the mean-value theorem bounds
//! the error of the result by Σ |∂f/∂vᵢ|·hᵢ, where hᵢ is half an ulp of the operation's greatest value: no
//! remainder term is left to bound. Branch and bound splits boxes until the bound is close to what
//! single points give.

mod bound;
mod domain;
mod form;
mod lossy;
mod pass;
mod slopes;
pub(crate) mod upward;

pub use bound::{Bounded, Budget, Goal, Pole, bounded};
pub use domain::{Cell, Inputs};
pub use lossy::lossy;
pub use pass::FaultKind;
