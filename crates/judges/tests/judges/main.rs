//! What other judges are handed means what was judged: read back by readers that know nothing of the printers, and put to
//! the judges themselves where they are installed.

mod accepted; // what Coq says of the lemmas
mod asked; // the judges themselves
mod chains; // what follows from the givens
mod document; // documents, goals, points
mod families; // what lemmas about functions say
mod files; // files as a whole
mod lemmas; // what lemmas of Coq say
#[path = "../../../../tests/shared/many.rs"]
#[expect(dead_code, reason = "here is nothing random")]
mod many; // how much a test does
mod open; // what is not emitted
mod questions; // what is asked in SMT-LIB
mod slopes; // derivatives in SMT-LIB
#[path = "../../../../tests/shared/smt.rs"]
mod smt; // a reader of SMT-LIB
