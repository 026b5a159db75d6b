//! How much a search may do, and which ways it goes.

/// How much work one link may take. All numbers count steps, none of them time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
        }
    }
}

impl Budget {
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
            ..self
        }
    }
}

/// Which ways a search goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ways {
    /// those that most claims need
    Near,
    /// those that take long, too: cells and elimination by cases
    Far,
}
