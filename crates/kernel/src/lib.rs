//! The trusted part: statements, their normal form, certificates and the check.
//!
//! [`check`] receives a [`Goal`] as parsed and a [`Certificate`], generates every obligation from
//! the goal itself, and accepts or names the reason. Nothing here searches; whoever finds a
//! certificate may be as clever, or as wrong, as they like.
#![deny(clippy::float_arithmetic)]

mod ast;
mod check;
mod derivative;
mod limit;
mod normal;
mod poly;
mod proof;
mod rejection;
mod state;
mod substitution;
mod univariate;

pub use ast::*;
pub use check::{check, claim_state, digest, range_premise, satisfies, scope};
pub use derivative::derivative;
pub use limit::{
    along, at_point, constants, differs, leaves, misses, narrows, premised, sides, start,
};
pub use normal::{Atom, Atoms, Cases, Piece, Scope, Sign, Truth};
pub use poly::{Fraction, Fuel, Monomial, Poly, exponent};
pub use proof::*;
pub use rejection::Rejection;
pub use state::{State, cells, depends, in_variable};
pub use substitution::substituted;
pub use univariate::{descartes, sign, sign_at};
