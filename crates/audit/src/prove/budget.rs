//! How much a search may do, and which ways it goes.

/// What a document may take in all. Operations are counted so that there are fifty to a hundred million in a
/// second on one core where variables are few: five to ten seconds.
const DOCUMENT: u64 = 480_000_000;
/// One part in so many of a document's budget is kept for the claims to come, in equal shares.
const KEPT: u64 = 4;

/// How much work one link may take. All numbers count steps, none of them time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Budget {
    /// states that one search may visit
    pub steps: u64,
    /// coefficient operations of one search
    pub fuel: u64,
    /// coefficient operations of one check
    pub check: u64,
    /// tuples of functions that are tried as a model
    pub functions: usize,
    /// whether ideals may be computed where substitution does not close
    pub ideals: bool,
    /// whether products of premises and boxes may be tried, which take long
    pub products: bool,
    /// coefficient operations of one search for sums of squares
    pub squares: u64,
    /// coefficient operations of one search among cells
    pub cells: u64,
    /// coefficient operations of all claims of a document together, or of a goal judged on its own
    pub document: u64,
}

impl Default for Budget {
    fn default() -> Self {
        Self {
            steps: 4_000,
            fuel: 40_000_000,
            check: 400_000_000,
            functions: 60,
            ideals: true,
            products: true,
            squares: 200_000_000,
            cells: 10_000_000,
            document: DOCUMENT,
        }
    }
}

impl Budget {
    /// Such a part of the work.
    #[must_use]
    pub(crate) fn share(self, part: u64) -> Self {
        Self {
            steps: self.steps / part,
            fuel: self.fuel / part,
            squares: self.squares / part,
            cells: self.cells / part,
            ..self
        }
    }

    /// What a claim may spend of what is `left` for a document of `claims` claims, `after` of them
    /// still to come: all but their shares. So a hard claim leaves something for each that follows,
    /// and what a document says further down changes nothing above it but those shares.
    ///
    /// It comes in eighths of the document's budget, as long as there is one: so what a claim is given
    /// seldom changes with what those above it spent, and what was judged before can be used again.
    pub(crate) fn of_claim(self, left: u64, claims: u64, after: u64) -> u64 {
        let share = self.document / KEPT / claims.max(1);
        let most = left.saturating_sub(share.saturating_mul(after));
        let eighth = (self.document / 8).max(1);
        if most < eighth { most } else { most - most % eighth }
    }

    /// As many times the work.
    #[must_use]
    pub fn times(self, factor: u64) -> Self {
        let functions = usize::try_from(factor).unwrap_or(usize::MAX);
        Self {
            steps: self.steps.saturating_mul(factor),
            fuel: self.fuel.saturating_mul(factor),
            check: self.check.saturating_mul(factor),
            functions: self.functions.saturating_mul(functions),
            squares: self.squares.saturating_mul(factor),
            cells: self.cells.saturating_mul(factor),
            document: self.document.saturating_mul(factor),
            ..self
        }
    }
}

/// Which ways a search goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ways {
    /// the cheap ones, with little work: so that what is easy to refute does not wait for a proof to fail
    Brief,
    /// the same of the claim alone, where what it cites only leads astray
    Alone,
    /// those that most claims need
    Near,
    /// those that take long, too: cells and elimination by cases
    Far,
}

impl Ways {
    /// Whether there is little work for them.
    pub(super) fn are_brief(self) -> bool {
        matches!(self, Self::Brief | Self::Alone)
    }
}
