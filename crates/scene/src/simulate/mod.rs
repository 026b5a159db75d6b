//! Motion, event by event: flights in closed form between impacts, never a fixed step.

mod air;
mod chain;
mod encounter;
mod flight;
mod penalty;
mod rest;
mod run;
mod state;

pub(crate) use air::run_in_air;
pub use chain::{Chain, ChainError, ContactTime, Moment, collide_chain, watch_chain};
pub use encounter::{Bounce, Encounter};
pub use penalty::{Penalty, energy_by_penalty};
pub use run::{Budget, End, Ending, Stopped, Until, run};
