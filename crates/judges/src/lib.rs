//! Other judges: Coq checks the lemmas of a document, z3 answers its claims as polynomial
//! conditions. Neither is trusted with a verdict; a disagreement is a finding of its own.
//!
//! [`coq`] turns accepted certificates into lemmas with proofs, [`smt`] turns claims into questions.
//! Both only write text. [`ask_coq`], [`Theory::ask`] and [`ask_z3`] run the programs and return a
//! [`Judge`], which is data; how it is shown is not our business.
#![deny(clippy::float_arithmetic)]

mod answer;
mod ask;
mod claims;
pub mod coq;
pub mod smt;

pub use answer::{Answer, Judge};
pub use ask::{ALLOWED_AXIOMS, Limits, NotAsked, Theory, ask_coq, ask_z3, is_installed};
pub use claims::Claims;
