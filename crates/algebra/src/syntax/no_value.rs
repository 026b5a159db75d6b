//! Why there is no value at a point.

use thiserror::Error;

/// Why an expression has no rational value at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum NoValue {
    /// a denominator is zero
    #[error("division by zero")]
    DivisionByZero,
    /// a radicand is negative
    #[error("root of a negative number")]
    NegativeRadicand,
    /// no branch applies and there is no `else`
    #[error("no case applies")]
    NoCase,
    /// on the boundary of a case, or at the root of zero, under a derivative
    #[error("not differentiable here")]
    NotDifferentiable,
    /// under a derivative, where the sides of a guard meet and may agree near the point
    #[error("a guard that may change here")]
    Unsettled,
    /// defined perhaps, but through an irrational root
    #[error("an irrational root")]
    Irrational,
    /// numbers or derivatives beyond the budget
    #[error("too large to compute")]
    TooLarge,
    /// the point has no value for a symbol
    #[error("a symbol without a value")]
    Unassigned,
}

impl NoValue {
    /// Whether the expression is known to be undefined; otherwise nothing is known.
    #[must_use]
    pub fn is_undefined(self) -> bool {
        match self {
            Self::DivisionByZero
            | Self::NegativeRadicand
            | Self::NoCase
            | Self::NotDifferentiable => true,
            Self::Unsettled | Self::Irrational | Self::TooLarge | Self::Unassigned => false,
        }
    }
}

/// Both, or the reason why not: that one is undefined outweighs that the other is out of reach.
pub(super) fn both<T>(a: Result<T, NoValue>, b: Result<T, NoValue>) -> Result<(T, T), NoValue> {
    match (a, b) {
        (Ok(a), Ok(b)) => Ok((a, b)),
        (Err(a), Err(b)) if b.is_undefined() && !a.is_undefined() => Err(b),
        (Err(reason), _) | (_, Err(reason)) => Err(reason),
    }
}
