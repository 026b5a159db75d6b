//! What arithmetic in fractions costs, in the operations in which budgets count.
//!
//! A budget for one search counts what its own parts grow with, and its numbers stay as they are: what is
//! decided within them hangs on them. The budget of which it is a part is one of time, in products of two
//! integer coefficients, so there the greatest common divisors, which fractions are reduced by, count too.

use kane_kernel::{Checked, Fuel};

/// What a sum or a product of fractions of one word costs beside counting it.
pub(crate) const FRACTION: u64 = 30;

/// Spends what a sum or a product of fractions costs that have this many words together.
///
/// # Errors
/// The kernel's rejection when the budget, or what it is part of, does not reach.
pub(crate) fn spend_fraction(words: u64, fuel: &Fuel) -> Checked {
    let square = words.saturating_mul(words);
    fuel.spend(square)?;
    fuel.spend_beyond(square.saturating_mul(4))
}
