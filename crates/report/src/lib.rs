//! Presents verdicts as text, Markdown and JSON; computes nothing.
//!
//! A [`Report`] chooses what is shown of an [`Audit`](kane_audit::Audit). [`text`] is for the terminal,
//! [`markdown`] for the web, [`json`] for programs (its schema is documented in `docs/report-schema.md`),
//! and [`explain`] writes out one proof or witness in full. [`collision`] does the same for one collision
//! under the laws, [`stability`] and [`chart`] for what the measurements found. All of them return
//! strings whose bytes depend on their arguments alone.
#![deny(clippy::float_arithmetic)]

pub mod chart;
mod chart_picture;
pub mod collision;
mod envelope;
mod gappa;
mod explain;
mod json;
mod markdown;
mod report;
mod shorten;
pub mod stability;
mod summary;
mod text;

pub use chart_picture::picture as chart_picture;
pub use explain::explain;
pub use gappa::gappa;
pub use json::{SCHEMA_NAME, SCHEMA_VERSION, json};
pub use markdown::markdown;
pub use report::Report;
pub use summary::Summary;
pub use text::{Page, text};
