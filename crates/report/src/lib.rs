//! Presents verdicts as text, Markdown, HTML, LaTeX and JSON; computes nothing.
//!
//! A [`Report`] chooses what is shown of an [`Audit`](kane_audit::Audit). [`text`] is for the terminal,
//! [`markdown`] and [`html`] for the web, [`latex`] for print, [`json`] for programs (its schema is
//! documented in `docs/report-schema.md`), and [`explain`] writes out one proof or witness in full.
//! [`collision`], [`scene`], [`matrix`], [`stability`], [`chart`], [`prices`] and [`growth`] are functions from data to a
//! [`Sheet`], which is written in any form; [`records`] says what a log of impacts follows; [`remarks`] puts verdicts beside lines; [`figures`] draws
//! curves and maps. All of them return
//! strings whose bytes depend on their arguments alone.
#![deny(clippy::float_arithmetic)]

mod breakable;
mod certificate;
pub mod chart;
pub mod collision;
mod envelope;
mod explain;
pub mod figures;
pub mod floats;
pub mod growth;
mod html;
mod json;
pub mod judges;
mod latex;
mod layers;
mod length;
mod markdown;
pub mod matrix;
mod origin;
mod outline;
mod picture;
mod place;
pub mod prices;
mod reach;
pub mod records;
pub mod remarks;
mod report;
pub mod scene;
#[cfg(feature = "schema")]
mod schema;
mod sheet;
mod shell;
mod shorten;
pub mod site;
pub mod stability;
mod summary;
mod tex;
mod text;
mod wording;
mod words;

pub use certificate::certificates;
pub use explain::explain;
pub use html::html;
pub use json::{SCHEMA_NAME, SCHEMA_VERSION, json};
pub use latex::latex;
pub use length::{ProofLength, proof_lengths};
pub use markdown::markdown;
pub use place::{Link, Place};
pub use report::{Picture, Report};
#[cfg(feature = "schema")]
pub use schema::schemas;
pub use sheet::{Page, Sheet};
pub use shell::{quoted, quoted_file};
pub use summary::Summary;
pub use text::text;
