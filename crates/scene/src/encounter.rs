//! Who meets whom.

use crate::side::Side;

/// Which bodies touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Encounter {
    /// A body and a wall.
    Wall(usize, Side),
    /// Two bodies, by their index; the first is the one whose impulse is counted.
    Pair(usize, usize),
}
