//! The trusted part: statements, their normal form, certificates and the check.
//!
//! [`check`] receives a [`Goal`] as parsed and a [`Certificate`], generates every obligation from
//! the goal itself, and accepts or names the reason. Nothing here searches; whoever finds a
//! certificate may be as clever, or as wrong, as they like.
#![deny(clippy::float_arithmetic)]

mod ast;
mod check;
mod derivative;
mod door;
mod limit;
mod model;
mod normal;
mod poly;
mod proof;
mod rejection;
mod state;
mod univariate;

pub use ast::*;
pub use check::{
    check, claim_state, differ, digest, on_functions, point_state, range_premise, scope, unequal,
};
pub use limit::{
    Place, constants, differs, inside_goal, inside_state, misses, narrowing, owed, premised,
    premises, sides,
};
pub use normal::{Atom, Atoms, Cases, Piece, Scope, Sign};
pub use poly::{Fraction, Fuel, Monomial, Poly, Power, exponent};
pub use proof::*;
pub use rejection::{Checked, Rejection};
pub use state::{Passages, State};
pub use univariate::{descartes, shift, sign, sign_at};
