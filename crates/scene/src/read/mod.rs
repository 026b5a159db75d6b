//! Exact numbers out of TOML files, with faults that point at their place.

mod angle;
mod ask;
mod bodies;
mod file;
mod number;
mod source;
mod stated;

pub use angle::direction;
pub use bodies::{Pendulum, Rod};
pub use file::scene;
pub use number::{Domain, read, read_in};
pub use source::{Fault, Number, Source, load};
pub use stated::Stated;
