//! LaTeX as people write it, read as statements of the language of derivations.
//!
//! [`statement`] reads one formula: products get their signs, names their subscripts, and what has no
//! meaning in the language, or two readings, is refused with the reason. [`draft()`] reads a whole
//! paper. Nothing here judges: what is read is a proposal to an author.

#![forbid(unsafe_code)]

mod adjacent;
mod command;
mod display;
mod domain;
mod draft;
mod environment;
mod formula;
mod function;
mod macros;
mod name;
mod part;
mod plain;
mod prose;
mod refusal;
mod relation;
mod source;
mod symbol;
mod token;
mod unreadable;

pub use draft::{Draft, Outcome, draft};
pub use name::{Names, Symbol};
pub use relation::{Statement, statement};
pub use source::Format;
pub use unreadable::Unreadable;
