//! How much is tried to show on which side of a quotient an expression lies near a limit.

/// Steps of a brief search.
const BRIEF: u64 = 45;
/// One part in so many of the work that is left goes to a brief search, and to one of full length.
const SHARES: (u64, u64) = (2000, 2);

/// How it is tried to show that an expression lies on one side of a quotient.
#[derive(Clone, Copy, Debug)]
pub(super) struct Round {
    /// steps of a search of full length
    pub(super) steps: u64,
    /// whether few quotients along few germs are tried for a short time: what can be shown takes little as a rule, and what
    /// is false takes all that it gets
    pub(super) is_brief: bool,
    /// whether sides with several roots are squared before anything is solved for
    pub(super) squares_first: bool,
}

impl Round {
    /// The rounds, one after the other; where no roots are, the last one alone.
    pub(super) fn all(steps: u64, has_roots: bool) -> impl Iterator<Item = Self> {
        let ways = [(true, false), (true, true), (false, false)];
        let round = move |(is_brief, squares_first)| Self { steps, is_brief, squares_first };
        ways.into_iter().filter(move |(is_brief, _)| has_roots || !is_brief).map(round)
    }

    /// Steps of one search.
    pub(super) fn steps(self) -> u64 {
        if self.is_brief { self.steps.min(BRIEF) } else { self.steps }
    }

    /// What one search may take of the work that is left.
    pub(super) fn share(self, left: u64) -> u64 {
        left / if self.is_brief { SHARES.0 } else { SHARES.1 }
    }
}
