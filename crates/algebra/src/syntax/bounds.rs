//! How much an expression may hold.

/// Parentheses, calls, prefix signs and exponents within each other.
pub const MAX_NESTING: usize = 256;
/// Operations on top of each other, definitions expanded. Whoever walks an expression by
/// recursion goes this deep and no deeper.
pub const MAX_HEIGHT: usize = 1000;
/// Magnitude of exponents.
pub const MAX_EXPONENT: i32 = 10_000;
/// Digits of a literal.
pub const MAX_DIGITS: usize = 10_000;

/// Items of a comma list and branches of `cases`.
pub const MAX_ITEMS: usize = 10_000;
