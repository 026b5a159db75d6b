//! The exact value of a program, enclosed as closely as is needed.

mod enclosure;
mod value;

pub use enclosure::Enclosure;
pub use value::{Compared, compared, value};
