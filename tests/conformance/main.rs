//! What must hold of the house and of the documents that it ships.
//!
//! `KANE_LONG=1` makes the suites with random statements ten times as long.

mod documents; // the documents and pages that are shipped
mod layering; // which crate may know which, and what the kernel links
mod semantics; // one small document a rule of the language
mod support; // chance, documents, goals
