//! What must hold of the house and of the documents that it ships.
//!
//! The suites with random statements have a quarter of what the gate has (`KANE_GATE=1`), and the long run
//! ten times that (`KANE_LONG=1`).

mod adversarial; // what is too large ends soon
mod adversary; // random documents against oracles in another language
mod circles; // no circle between files, but those that are known
mod decision; // statements in one variable, without the kernel
mod documents; // the documents and pages that are shipped
mod faults; // what is planted in the kernel, and which test catches it
mod generate; // random statements
mod judges; // Coq and z3 on every shipped document
mod layering; // which crate may know which, and what the kernel links
mod line_ends; // lines end at LF, CR or CRLF
mod literature; // printed numbers and measured points
#[path = "../shared/many.rs"]
mod many; // how much a test does
mod mutation; // certificates changed in one place
mod on_a_sphere; // k(α) of every law, as a formula
mod one_variable; // one variable is complete
mod printing; // what is printed is what was judged
mod rounding; // bounds on rounding errors, proved by Gappa
mod sampling; // points at which hypotheses hold, without the kernel
#[cfg(feature = "cli")]
mod second_checker; // the checker of certificates in Python
mod semantics; // one small document a rule of the language
mod several_variables; // sixty claims, and how many are decided
#[path = "../shared/smt.rs"]
mod smt; // a reader of SMT-LIB
mod soundness; // nothing false is accepted
mod spatial; // the planar code against three dimensions
mod support; // chance, documents, goals

/// As the program has it: what these tests wait for is mostly the search for proofs.
#[global_allocator]
static MEMORY: mimalloc::MiMalloc = mimalloc::MiMalloc;
