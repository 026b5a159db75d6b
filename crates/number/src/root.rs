//! The greatest root of a polynomial of degree 3 at most, by the means of each kind of system.

/// Bracketed Newton on monotone pieces, for all the floating systems.
pub(crate) mod float;
/// Exclusion from the top, and closed forms, on intervals.
pub(crate) mod interval;
/// The ordinary quadratic in floats, quickly.
pub(crate) mod quadratic;
/// By the rational root theorem, or not at all.
pub(crate) mod rational;
