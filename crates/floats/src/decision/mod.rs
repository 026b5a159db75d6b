//! Comparisons that are decided as exact numbers decide them.
//!
//! Next to a tie plain floats decide wrongly: what is compared has been rounded before. A certified version
//! compares floats with a bound on what they are off by, and where that does not tell, exact numbers.

mod code;
mod compared;
mod exact;
mod filter;
mod lines;
mod share;

use crate::Language;

pub use code::{certified, function_name};
pub use compared::{Decision, decisions};
pub use share::{Share, Tie, share};

/// What certified comparisons need beside themselves, once in a file.
#[must_use]
pub const fn prelude(language: Language) -> &'static str {
    match language {
        Language::Rust => include_str!("prelude/exact.rs"),
        Language::C => include_str!("prelude/exact.c"),
        Language::Python => include_str!("prelude/exact.py"),
    }
}
