//! Motion, event by event: flights in closed form between impacts, never a fixed step.

mod air;
mod bounce;
mod chain;
mod corner_path;
mod ending;
mod flight;
mod penalty;
mod rest;
mod rolling;
mod run;
mod space;
mod space_contact;
mod state;
mod tumble;

pub use crate::encounter::Encounter;
pub(crate) use air::{Steps, run_in_air};
pub use bounce::Bounce;
pub use chain::{Chain, ChainError, ContactTime, Moment, collide_chain, watch_chain};
pub use ending::{Budget, End, Ending, Stopped, Until};
pub use penalty::{Penalty, energy_by_penalty};
pub use run::run;
pub(crate) use tumble::run_tumbling;
