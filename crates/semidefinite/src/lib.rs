//! Small semidefinite feasibility problems in floats: is there a y such that G(y) = G₀ + Σ yᵢGᵢ is
//! positive semidefinite?
//!
//! What comes out is a hint (*heuristic*): whoever asks rounds it and checks it exactly. Nothing but
//! +, −, ×, ÷ and square roots is used, in a fixed order and without fused operations, so the same question has the same answer on every machine.

mod center;
mod cholesky;
mod eigen;
mod null_space;
mod pencil;

pub use center::{Center, center};
pub use eigen::{Eigen, eigen, vanishing};
pub use null_space::null_space;
pub use pencil::{Entry, Pencil};

/// A dense square matrix, row by row.
pub type Matrix = Vec<Vec<f64>>;
