//! Surds: square roots of numbers, in the field of one algebraic number.
//!
//! A point has one algebraic number. Roots that are rational multiples of products of others are
//! written by them; of two that are left, √A and √B, w = √A + √B is the number: with D = 2·(B − A)
//!
//! √A = (w³ − (3·A + B)·w)/D,  √B = ((A + 3·B)·w − w³)/D,  w⁴ − 2·(A + B)·w² + (A − B)² = 0,
//!
//! and w² > A + B tells w from its conjugates. All roots are taken as positive; other signs, and
//! more than two roots, are left to be found otherwise.

use kane_kernel::{Atom, Poly, Sign};
use num_bigint::BigInt;
use num_traits::{One, Signed};

use super::conics::root;
use super::parameter::Parametrised;

/// v = √radicand/over, with an integer radicand that is no square.
struct Surd {
    v: usize,
    radicand: BigInt,
    over: BigInt,
}

/// Writes the surds of a state by one number, if it has two or more.
pub(super) fn surds(written: &mut Parametrised<'_, '_>) -> Option<()> {
    let mut found: Vec<Surd> = Vec::new();
    for surd in written.state.atoms.iter().filter_map(surd) {
        if !written.is_gone(surd.v) && found.iter().all(|s| s.v != surd.v) {
            found.push(surd);
        }
    }
    if found.len() < 2 {
        return Some(());
    }
    let mut basis: Vec<Surd> = Vec::new();
    for surd in found {
        match multiple(&surd, &basis) {
            Some((num, d)) => written.write(&[(surd.v, num)], &Poly::constant(d))?,
            None => basis.push(surd),
        }
    }
    basis.sort_by(|a, b| a.radicand.cmp(&b.radicand));
    match &basis[..] {
        [_] => Some(()),
        [small, large] => pair(written, small, large),
        _ => None,
    }
}

/// v of a·v² = b.
fn surd(atom: &Atom) -> Option<Surd> {
    let [v] = atom.poly.vars()[..] else { return None };
    if atom.sign != Sign::Zero || atom.poly.degree(v) != 2 {
        return None;
    }
    let parts = atom.poly.univariate(v)?;
    let [c, zero, a] = &parts[..] else { return None };
    if *zero != BigInt::ZERO || c.is_negative() == a.is_negative() {
        return None;
    }
    let (radicand, over) = ((c * a).abs(), a.abs());
    root(&radicand).is_none().then_some(Surd { v, radicand, over })
}

/// A surd as a rational multiple of a product of some others: numerator and denominator.
fn multiple(surd: &Surd, basis: &[Surd]) -> Option<(Poly, BigInt)> {
    // √r = √(r·Π)/Π·√Π, where r·Π is a square
    (1..1_usize << basis.len().min(2)).find_map(|choice| {
        let chosen = || basis.iter().enumerate().filter(|(i, _)| choice >> i & 1 == 1);
        let product: BigInt = chosen().map(|(_, s)| &s.radicand).product();
        let factor = root(&(&surd.radicand * &product))?;
        let variables = chosen().map(|(_, s)| (s.v, 1)).collect();
        let scale: BigInt = chosen().map(|(_, s)| &s.over).product();
        Some((Poly::term(variables, factor * scale), product * &surd.over))
    })
}

/// Two roots by their sum.
fn pair(written: &mut Parametrised<'_, '_>, small: &Surd, large: &Surd) -> Option<()> {
    let (a, b) = (&small.radicand, &large.radicand);
    let w = written.fresh();
    let cubic = |linear: BigInt, cube: BigInt| {
        Poly::in_variable(w, &[BigInt::ZERO, linear, BigInt::ZERO, cube])
    };
    let one = BigInt::one;
    let nums = [
        (small.v, cubic(BigInt::ZERO - a * 3 - b, one()).scale(&large.over)),
        (large.v, cubic(a + b * 3, -one()).scale(&small.over)),
    ];
    let d = (b - a) * 2 * &small.over * &large.over;
    let zero = || BigInt::ZERO;
    let (sum, apart) = (a + b, a - b);
    let equation = [&apart * &apart, zero(), &sum * -2, zero(), one()];
    let beyond = [-sum, zero(), one()];
    written.write(&nums, &Poly::constant(d))?;
    for (coefficients, sign) in [
        (&equation[..], Sign::Zero),
        (&beyond[..], Sign::Positive),
        (&[zero(), one()][..], Sign::Positive),
    ] {
        let atom = Atom::new(Poly::in_variable(w, coefficients), sign);
        written.state = written.state.with(atom);
    }
    Some(())
}
