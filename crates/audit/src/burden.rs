//! What takes long where a link of a claim does.

use std::fmt;

use kane_kernel::Finding;

use crate::LinkJudgement;

/// Operations a step from which it is not the number of steps that takes long.
const STEP: u64 = 100_000;

/// What most of the work on a link went into, as far as its counts show it: *heuristic*.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Burden {
    /// many states of the search, each of them looked at quickly
    States,
    /// few steps, and a proof: linear and semidefinite programs are long
    Sums,
    /// few steps, and no proof: points are looked for
    Points,
}

impl LinkJudgement {
    /// What takes long about this link: *heuristic*, from its counts of steps and operations.
    #[must_use]
    pub fn burden(&self) -> Burden {
        let proved = |a: &std::rc::Rc<crate::Accepted>| a.certificate.finding == Finding::Proved;
        match self.work / self.cost.max(1) {
            ..STEP => Burden::States,
            _ if self.accepted.as_ref().is_some_and(proved) => Burden::Sums,
            _ => Burden::Points,
        }
    }
}

impl fmt::Display for Burden {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::States => "many states are looked at",
            Self::Sums => "sums of products and squares, as linear and semidefinite programs",
            Self::Points => "a point, in few steps that are long",
        })
    }
}
