//! Second ways to the same answers, which share no formula with the laws.

mod path;

pub use path::{Event, NoPath, Path, PathEvent, integrate};
