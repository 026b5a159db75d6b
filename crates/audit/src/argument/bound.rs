//! Bounds of a variable: conditions c + k·v ≥ 0 or > 0.

use kane_kernel::{Atom, Poly};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero as _;

/// The value −c/k at which a condition bounds a variable, and k: the bound is a lower one if k > 0.
pub(crate) fn bound(atom: &Atom, v: usize) -> Option<(BigRational, &BigInt)> {
    if atom.sign.is_order() { zero(&atom.poly, v) } else { None }
}

/// The zero −c/k of a polynomial c + k·v with k not 0, and k.
pub(crate) fn zero(p: &Poly, v: usize) -> Option<(BigRational, &BigInt)> {
    let (mut c, mut k) = (BigInt::zero(), None);
    for (m, coefficient) in p.terms() {
        match m {
            [] => c = coefficient.clone(),
            [power] if *power == (v, 1) => k = Some(coefficient),
            _ => return None,
        }
    }
    Some((BigRational::new(-c, k?.clone()), k?))
}
