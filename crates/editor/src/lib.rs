//! An editor that answers: derivation documents in any editor that speaks the language server protocol.
//!
//! While one types, errors appear at their places with advice, and each claim has its verdict at the end
//! of its line; a verdict that is not the expected one is a diagnostic with its reason. Hovering shows
//! the proof or the witness; labels can be followed, renamed and completed.
//!
//! [`serve`] is the whole of it. One thread reads messages, one judges, one answers: judging blocks no
//! typing, and of several texts of a document only the newest is judged. What did not change is not
//! judged again ([`Memo`](kane_audit::Memo)). Nothing is computed here that the audit does not say, and
//! what is shown always belongs to the text that the editor has: a verdict on an older one is dropped.
//!
//! The protocol: <https://microsoft.github.io/language-server-protocol/>, version 3.17. Why so:
//! `docs/decisions/0036-an-editor-that-answers.md`.
#![deny(clippy::float_arithmetic)]

mod completion;
mod document;
mod event;
mod findings;
mod judging;
mod labels;
mod message;
mod position;
mod rename;
mod session;
mod transport;

pub use session::{End, serve};
