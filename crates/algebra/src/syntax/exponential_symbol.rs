//! Symbols that stand for exponentials and logarithms, and the bounds that these have from those of what is in them.

use kane_kernel::Bound;
use num_rational::BigRational;
use num_traits::{One as _, Zero as _};

/// What stands for the exponential of a part of a symbol, or for the logarithm of a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Exponential {
    /// the symbol that stands for it
    pub symbol: usize,
    /// of which symbol
    pub of: usize,
    /// into how many parts that is cut; 0 for a logarithm
    pub parts: u32,
    /// whether its bounds are all that the bounds of the other symbol say
    pub exact: bool,
}

/// What the bounds of a symbol say of its exponential, and whether that is all that they say.
pub(crate) fn bounds_of_exponential(ends: [Option<&Bound>; 2]) -> ([Option<Bound>; 2], bool) {
    let zero = BigRational::zero();
    let above = Bound { value: zero.clone(), strict: true };
    let at_one = |bound: &Bound| {
        let strict = bound.strict || !bound.value.is_zero();
        Bound { value: BigRational::one(), strict }
    };
    let [lower, upper] = ends;
    let exact = ends.into_iter().flatten().all(|bound| bound.value.is_zero());
    let lower = lower.filter(|bound| bound.value >= zero).map_or(above, at_one);
    let upper = upper.filter(|bound| bound.value <= zero).map(at_one);
    ([Some(lower), upper], exact)
}

/// What the bounds of a positive symbol say of its logarithm, and whether that is all that they say.
pub(crate) fn bounds_of_logarithm(ends: [Option<&Bound>; 2]) -> ([Option<Bound>; 2], bool) {
    let one = BigRational::one();
    let at_zero = |bound: &Bound| {
        let strict = bound.strict || !bound.value.is_one();
        Bound { value: BigRational::zero(), strict }
    };
    let [lower, upper] = ends;
    let exact = lower.is_some_and(|b| b.value.is_one() || (b.strict && b.value.is_zero()))
        && upper.is_none_or(|b| b.value.is_one());
    let lower = lower.filter(|bound| bound.value >= one).map(at_zero);
    let upper = upper.filter(|bound| bound.value <= one).map(at_zero);
    ([lower, upper], exact)
}
