//! The Rust half of the Python package `kane`.
//!
//! Each function takes text, numbers or columns, asks the rooms of the workspace and returns JSON, or
//! fills columns that the caller owns. What users see, classes, fractions and tables, is Python and
//! stands in `python/kane`. Bad input is a `ValueError`; nothing here panics on it. No function holds the
//! interpreter's lock while it works.

mod audited;
mod away;
mod columns;
mod described;
mod logged;
mod worlds;

use pyo3::prelude::*;

/// The module `kane._kane`.
#[pymodule]
mod _kane {
    #[pymodule_export]
    use super::audited::{audit, explain};
    #[pymodule_export]
    use super::columns::{batch, batch_contacts, batched, survey};
    #[pymodule_export]
    use super::described::{laws, version};
    #[pymodule_export]
    use super::logged::{check_columns, check_text};
    #[pymodule_export]
    use super::worlds::{collide, scene};
}

/// A message as Python's `ValueError`.
fn bad_input(message: impl std::fmt::Display) -> PyErr {
    pyo3::exceptions::PyValueError::new_err(message.to_string())
}
