//! Exact numbers out of TOML files, with faults that point at their place.

mod air;
mod angle;
mod ask;
mod bodies;
mod collision;
mod contacts;
mod file;
mod flags;
mod number;
mod reader;
mod source;
mod spheres;
mod stated;
mod tumbling;

pub use collision::{TURNED, collision, of_the_paper};
pub use file::scene;
pub use flags::Flags;
pub use number::{Domain, read, read_in};
pub use reader::{Name, Reader, name};
pub use source::{Fault, Number, Source, load};
pub use stated::Stated;
