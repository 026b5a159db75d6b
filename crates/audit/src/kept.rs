//! A proof in which definitions are left as they are.

use kane_kernel::Goal;

use crate::argument::Grounds;

/// A proof of a goal in which definitions are symbols of their own, behind those of the goal.
#[derive(Clone, Debug)]
pub(crate) struct Kept {
    /// the goal with these symbols
    pub(crate) goal: Goal,
    /// the definitions, in the order of their symbols
    pub(crate) definitions: Vec<usize>,
    /// its proof
    pub(crate) grounds: Grounds,
}
