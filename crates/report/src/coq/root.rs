//! Points at an algebraic number: an interval around it in which all signs can be read off.

use kane_kernel::{Finding, Goal, Point, Scope};

use super::NotEmitted;
use super::reify::Symbols;

/// The number, and the proofs that close what is to be shown there.
pub(super) fn generator(
    _symbols: &Symbols<'_>,
    _scope: &Scope<'_>,
    _goal: &Goal,
    _finding: Finding,
    point: &Point,
) -> Result<(String, String), NotEmitted> {
    match &point.generator {
        None => Ok(("None".to_owned(), "[Absurd]".to_owned())),
        Some(_) => Err(NotEmitted::Step("a point at an algebraic number")),
    }
}
