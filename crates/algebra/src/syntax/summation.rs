//! What the symbol of a sum or a product up to an index comes from.

use kane_kernel::Expr;

/// What the symbol of a sum or a product up to an index comes from.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Summation {
    /// whether it is a product
    pub product: bool,
    /// the index
    pub index: usize,
    /// its value at the index 0
    pub first: Expr,
    /// the term that the step from n to n + 1 takes in
    pub term: Expr,
}

impl Summation {
    /// The value with one term more.
    #[must_use]
    pub fn joined(&self, value: Expr) -> Expr {
        joined(self.product, value, self.term.clone())
    }
}

/// A value with one term more.
pub(crate) fn joined(product: bool, value: Expr, term: Expr) -> Expr {
    match product {
        true => Expr::Mul(value.into(), term.into()),
        false => Expr::Add(value.into(), term.into()),
    }
}
