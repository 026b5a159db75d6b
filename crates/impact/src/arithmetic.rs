//! Sums and products whose terms may cancel, with the rounding errors carried along.

use kane_number::Number;

/// a·b − c·d, in binary floats within 3/2 ulp barring under- and overflow; exact in exact numbers.
///
/// The rounding error of c·d is recovered by a fused multiply-add and given back. Source: W. Kahan;
/// bound by C.-P. Jeannerod, N. Louvet, J.-M. Muller (2013).
pub(crate) fn difference_of_products<N: Number>(a: &N, b: &N, c: &N, d: &N) -> N {
    let product = c.clone() * d;
    let error = (-c.clone()).mul_add(d, &product);
    a.mul_add(b, &-product) + error
}

/// a + b and what rounding took from it, so that the pair is exact in binary floats.
///
/// Source: D. Knuth, TwoSum. The error is zero in exact numbers.
pub(crate) fn two_sum<N: Number>(a: &N, b: &N) -> (N, N) {
    let sum = a.clone() + b;
    let of_b = sum.clone() - a;
    let of_a = sum.clone() - &of_b;
    let error = (a.clone() - of_a) + (b.clone() - of_b);
    (sum, error)
}
