//! Formulas as machines compute them: FPCore, rigorous bounds on round-off, worst inputs, repairs.
//!
//! ```
//! use kane_floats::fpcore;
//! let cores = fpcore::read("a.fpcore", "(FPCore (x) :pre (<= 1 x 2) (- (sqrt (+ x 1)) (sqrt x)))");
//! let core = &cores.expect("it is well formed")[0];
//! assert_eq!(core.text(), "sqrt(x + 1) - sqrt(x)");
//! ```
#![deny(clippy::float_arithmetic)]

mod core;
pub mod decision;
mod draw;
mod emit;
pub mod exact;
pub mod fpcore;
mod gappa;
mod machine;
mod program;
mod repair;
pub mod rigor;
mod search;
pub mod text;

pub use core::{Argument, Core, Precision};
pub use draw::points;
pub use emit::{Language, emit};
pub use gappa::gappa;
pub use machine::{Machine, Runner, places};
pub use program::{Operation, Program, Test};
pub use repair::{Proposal, fused, repairs};
pub use search::{Effort, Worst, worst};
