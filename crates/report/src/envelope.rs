//! How every report for programs begins: what it is, and what wrote it.

use serde::Serialize;

/// The name and the version of a report's format.
#[derive(Serialize)]
pub(crate) struct Schema {
    pub(crate) name: &'static str,
    pub(crate) version: u32,
}

/// The program that wrote it.
#[derive(Serialize)]
pub(crate) struct Program {
    name: &'static str,
    version: &'static str,
}

impl Program {
    /// This program.
    pub(crate) const THIS: Self = Self { name: "kane", version: env!("CARGO_PKG_VERSION") };
}
