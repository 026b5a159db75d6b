//! Surds: square roots of numbers, in the field of one algebraic number.
//!
//! A point has one algebraic number. Roots that are rational multiples of products of others are written by them; of two
//! or three that are left, the sum w is the number. Its odd powers are sums of products of an odd number of the roots, as
//! many powers as there are such products, so that each root is a sum of odd powers of w, and the next power is one, too:
//!
//! √A = (w³ − (3·A + B)·w)/D,  √B = ((A + 3·B)·w − w³)/D,  w⁴ − 2·(A + B)·w² + (A − B)² = 0,  D = 2·(B − A).
//!
//! That w is larger than the sum of all but the least root tells it from its conjugates. All roots are taken as positive;
//! other signs, and more roots, are left to be found otherwise.

use kane_algebra::linear_program::common_denominator;
use kane_kernel::{Atom, Poly, Sign};
use kane_number::{Rational, linear};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use super::conics::root;
use super::parameter::Parametrised;

/// Roots of which no one is a multiple of a product of others.
const MOST: usize = 3;

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
    match basis.len() {
        1 => Some(()),
        2..=MOST => by_sum(written, &basis),
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
    (1..1_usize << basis.len().min(MOST)).find_map(|choice| {
        let chosen = || basis.iter().enumerate().filter(|(i, _)| choice >> i & 1 == 1);
        let product: BigInt = chosen().map(|(_, s)| &s.radicand).product();
        let factor = root(&(&surd.radicand * &product))?;
        let variables = chosen().map(|(_, s)| (s.v, 1)).collect();
        let scale: BigInt = chosen().map(|(_, s)| &s.over).product();
        Some((Poly::term(variables, factor * scale), product * &surd.over))
    })
}

/// Roots by their sum.
fn by_sum(written: &mut Parametrised<'_, '_>, roots: &[Surd]) -> Option<()> {
    let radicands: Vec<&BigInt> = roots.iter().map(|root| &root.radicand).collect();
    let powers = odd_powers(&radicands);
    let (next, powers) = powers.split_last()?;
    let unit = |of: usize| {
        let entry = |k: usize| if k == of { Rational::one() } else { Rational::zero() };
        (0..powers.len()).map(entry).collect::<Vec<_>>()
    };
    // the roots themselves stand first among the products
    let mut sides: Vec<Vec<Rational>> = (0..roots.len()).map(unit).collect();
    sides.push(next.clone());
    let found = linear::solve(powers, &sides.iter().map(Vec::as_slice).collect::<Vec<_>>())?;
    let (last, of_roots) = found.split_last()?;
    let w = written.fresh();
    let zero = || BigInt::ZERO;
    let over = common_denominator(of_roots.iter().flatten());
    let all_over: BigInt = roots.iter().map(|root| &root.over).product();
    let num = |(root, parts): (&Surd, &Vec<Rational>)| {
        let scale = Rational::from(&over * &all_over / &root.over);
        let whole = parts.iter().flat_map(|c| [zero(), (c * &scale).to_integer()]);
        (root.v, Poly::in_variable(w, &whole.collect::<Vec<_>>()))
    };
    let nums: Vec<(usize, Poly)> = roots.iter().zip(of_roots).map(num).collect();
    written.write(&nums, &Poly::constant(over * all_over))?;
    // w is a factor of its odd powers
    let over = common_denominator(last);
    let lower =
        last.iter().flat_map(|c| [-(c * Rational::from(over.clone())).to_integer(), zero()]);
    let equation: Vec<BigInt> = lower.chain([over.clone()]).collect();
    // each root in quarters, rounded down, is less than one of them below: in sum less than the least root
    let quarters: BigInt = roots[1..].iter().map(|root| (&root.radicand * 16_u32).sqrt()).sum();
    let beyond = [-quarters, BigInt::from(4)];
    for (coefficients, sign) in [(&equation[..], Sign::Zero), (&beyond[..], Sign::Positive)] {
        let atom = Atom::new(Poly::in_variable(w, coefficients), sign);
        written.state = written.state.with(atom);
    }
    Some(())
}

/// The odd powers of the sum of some roots, one more than there are products of an odd number of them, each by the weights
/// of these products: of the roots first, then of those of three.
fn odd_powers(radicands: &[&BigInt]) -> Vec<Vec<Rational>> {
    let count = 1_usize << radicands.len();
    let mut odd: Vec<usize> = (0..count).filter(|set| set.count_ones() % 2 == 1).collect();
    odd.sort_by_key(|set| set.count_ones());
    let mut power = vec![BigInt::ZERO; count];
    power[0] = BigInt::one();
    let times_sum = |power: &[BigInt]| {
        let mut product = vec![BigInt::ZERO; count];
        for (set, weight) in power.iter().enumerate() {
            for (i, radicand) in radicands.iter().enumerate() {
                let is_square = set >> i & 1 == 1;
                let by = if is_square { weight * *radicand } else { weight.clone() };
                product[set ^ 1 << i] += by;
            }
        }
        product
    };
    (0..=odd.len())
        .map(|n| {
            power = times_sum(&power);
            if n > 0 {
                power = times_sum(&power);
            }
            odd.iter().map(|set| Rational::from(power[*set].clone())).collect()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (√2 + √3 + √5)³ = 26·√2 + 24·√3 + 20·√5 + 6·√30, and (√2 + √3)⁵ = 109·√2 + 89·√3.
    #[test]
    fn powers_of_sums_of_roots_are_sums_of_products_of_roots() {
        let [two, three, five] = [2, 3, 5].map(BigInt::from);
        let whole = |row: &[i32]| -> Vec<Rational> {
            row.iter().map(|n| Rational::from(BigInt::from(*n))).collect()
        };
        let of_three: Vec<Vec<Rational>> = odd_powers(&[&two, &three, &five]);
        assert_eq!(of_three[1], whole(&[26, 24, 20, 6]));
        assert_eq!(odd_powers(&[&two, &three])[2], whole(&[109, 89]));
    }
}
