//! What is said of formulas in floats.

mod bounds;
mod decisions;
mod fpcore;
mod repairs;
mod soundness;
