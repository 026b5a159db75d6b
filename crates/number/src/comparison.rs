//! The answer to a comparison in a number system that may not know.

use std::cmp::Ordering;

/// What is known about the order of a and b: the set of orderings that are still possible.
///
/// One ordering is left for exact numbers. Overlapping intervals leave two or three, and yet
/// `[0, 1] ≥ 0` is certain, which a plain `Option<Ordering>` could not say. NaN leaves all three,
/// so no guard ever holds for it and none is refuted.
///
/// The questions return `Some(true)` or `Some(false)` when every possible ordering agrees, and
/// `None` when the number system cannot tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Comparison {
    less: bool,
    equal: bool,
    greater: bool,
}

impl Comparison {
    /// Nothing is known.
    pub const UNKNOWN: Self = Self::possible(true, true, true);

    /// The comparison that leaves the orderings marked `true`, of which there is at least one.
    #[must_use]
    pub const fn possible(less: bool, equal: bool, greater: bool) -> Self {
        debug_assert!(less || equal || greater, "some ordering must be possible");
        Self { less, equal, greater }
    }

    /// Whether a < b.
    #[must_use]
    pub const fn is_less(self) -> Option<bool> {
        certain(self.less, self.equal || self.greater)
    }

    /// Whether a ≤ b.
    #[must_use]
    pub const fn is_at_most(self) -> Option<bool> {
        certain(self.less || self.equal, self.greater)
    }

    /// Whether a = b.
    #[must_use]
    pub const fn is_equal(self) -> Option<bool> {
        certain(self.equal, self.less || self.greater)
    }

    /// Whether a ≥ b.
    #[must_use]
    pub const fn is_at_least(self) -> Option<bool> {
        certain(self.greater || self.equal, self.less)
    }

    /// Whether a > b.
    #[must_use]
    pub const fn is_greater(self) -> Option<bool> {
        certain(self.greater, self.equal || self.less)
    }
}

const fn certain(can_hold: bool, can_fail: bool) -> Option<bool> {
    match (can_hold, can_fail) {
        (true, false) => Some(true),
        (false, true) => Some(false),
        _ => None,
    }
}

impl From<Ordering> for Comparison {
    fn from(known: Ordering) -> Self {
        Self::possible(known.is_lt(), known.is_eq(), known.is_gt())
    }
}

impl From<Option<Ordering>> for Comparison {
    fn from(known: Option<Ordering>) -> Self {
        known.map_or(Self::UNKNOWN, Self::from)
    }
}
