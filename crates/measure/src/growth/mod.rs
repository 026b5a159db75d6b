//! How cost grows with size: rows in a batch, bounces in a chain, variables and degree in the audit.
//!
//! Times are readings of a clock and differ from run to run; bits, digits, steps and verdicts do not.

mod audit;
mod chain;
mod clock;
mod rows;

pub use audit::{Asked, Family};
pub use chain::{Bounce, Chain, Digits, End, Why};
pub use rows::{Batch, Rows, Way};

use crate::chart::Effort;

/// All curves.
#[derive(Clone, Debug)]
pub struct Growth {
    /// rows in a batch, per kernel; empty where nothing was timed
    pub batches: Vec<Batch>,
    /// bounces in a chain, per law
    pub chains: Vec<Chain>,
    /// variables and degree in the audit, per family of claims
    pub families: Vec<Family>,
}

/// What there is to report while it grows: how much is done, of how much.
struct Told<'a> {
    done: usize,
    all: usize,
    progress: &'a mut dyn FnMut(usize, usize),
}

impl Told<'_> {
    fn step(&mut self) {
        self.done += 1;
        (self.progress)(self.done, self.all);
    }
}

fn grow(effort: Effort, timed: bool, progress: &mut dyn FnMut(usize, usize)) -> Growth {
    let all = rows::steps(effort, timed) + chain::steps(effort) + audit::steps(effort);
    let mut told = Told { done: 0, all, progress };
    let batches = if timed { rows::batches(effort, &mut told) } else { Vec::new() };
    let chains = chain::chains(effort, timed, &mut told);
    let families = audit::families(effort, timed, &mut told);
    Growth { batches, chains, families }
}

/// The curves with the time that each point takes on this machine.
#[must_use]
pub fn growth(effort: Effort, progress: &mut dyn FnMut(usize, usize)) -> Growth {
    grow(effort, true, progress)
}

/// The curves without a clock. Deterministic.
#[must_use]
pub fn counted(effort: Effort) -> Growth {
    grow(effort, false, &mut |_, _| {})
}
