//! What must not vanish, in one form: primitive, coprime, without repeated factors, in one order.

use std::cmp::Reverse;

use kane_kernel::{Poly, Power};
use num_bigint::BigInt;
use num_traits::{One, Signed};

use crate::ring;

fn total(m: &[Power]) -> u32 {
    m.iter().map(|p| p.1).fold(0, u32::saturating_add)
}

/// Terms by falling degree, then by falling powers of the first symbols.
pub(super) fn ordered(p: &Poly) -> Vec<(&[Power], &BigInt)> {
    let mut terms: Vec<_> = p.terms().collect();
    terms.sort_by_cached_key(|(m, _)| {
        let powers: Vec<_> = m.iter().map(|&(v, e)| (v, Reverse(e))).collect();
        (Reverse(total(m)), powers)
    });
    terms
}

/// Whether the coefficient of highest degree is negative.
pub(super) fn leads_negative(p: &Poly) -> bool {
    ordered(p).first().is_some_and(|(_, c)| c.is_negative())
}

/// The primitive polynomial with the same zeros whose coefficient of highest degree is positive.
pub(super) fn signed(p: &Poly) -> Poly {
    let (_, p) = p.primitive();
    if leads_negative(&p) { p.neg() } else { p }
}

/// Pairwise coprime polynomials without repeated factors whose product has the zeros of all.
pub(super) fn coprime<'a>(polys: impl Iterator<Item = &'a Poly>) -> Vec<Poly> {
    let mut todo: Vec<Poly> = polys.flat_map(radical).collect();
    let mut base: Vec<Poly> = Vec::new();
    while let Some(p) = todo.pop() {
        if p.is_constant() || base.contains(&p) {
            continue;
        }
        let shares = |b: &Poly| !ring::gcd(b, &p).is_constant();
        match base.iter().position(shares) {
            None => base.push(p),
            Some(i) => {
                let b = base.swap_remove(i);
                let (p_rest, b_rest) = ring::cancelled(&p, &b);
                todo.extend([signed(&ring::gcd(&p, &b)), signed(&p_rest), signed(&b_rest)]);
            }
        }
    }
    let degree = |p: &Poly| p.terms().map(|(m, _)| total(m)).max();
    base.sort_by_cached_key(|p| (degree(p), p.len(), p.clone()));
    base
}

/// Its symbols that divide it, and the rest without repeated factors.
fn radical(p: &Poly) -> Vec<Poly> {
    let mut rest = p.clone();
    let mut parts = Vec::new();
    for v in p.vars() {
        let least = p.terms().map(|(m, _)| kane_kernel::exponent(m, v)).min().unwrap_or(0);
        if least > 0 {
            parts.push(Poly::var(v));
            rest = ring::cancelled(&rest, &Poly::term(vec![(v, least)], BigInt::one())).0;
        }
    }
    // what all derivatives share with it are the repeats
    let mut repeats = rest.clone();
    for v in rest.vars() {
        repeats = ring::gcd(&repeats, &derivative(&rest, v));
        if repeats.is_constant() {
            break;
        }
    }
    if !repeats.is_constant() {
        rest = ring::cancelled(&rest, &repeats).0;
    }
    parts.push(signed(&rest));
    parts
}

fn derivative(p: &Poly, v: usize) -> Poly {
    let terms = p.terms().filter(|(m, _)| kane_kernel::exponent(m, v) > 0);
    Poly::sum(terms.map(|(m, c)| {
        let lowered = m.iter().map(|&(w, n)| (w, if w == v { n - 1 } else { n }));
        (lowered.collect(), c * kane_kernel::exponent(m, v))
    }))
}
