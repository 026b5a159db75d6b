//! The field that two numbers of different fields share.

use std::sync::Arc;

use num_traits::{One, Zero};
use polycore::Uni;

use super::field::{NumberField, times};
use super::linear::solve;
use super::roots::{factor_at, factors};
use crate::sturm::Sturm;
use crate::{Integer, Rational};

/// A field that contains two others, and their generators in it.
pub(super) struct Compositum {
    pub(super) field: Arc<NumberField>,
    pub(super) first: Uni<Rational>,
    pub(super) second: Uni<Rational>,
}

/// ℚ(α, β) = ℚ(γ) with γ = α + kβ for the first positive integer k that tells all pairs of
/// conjugates apart.
///
/// In the algebra ℚ\[u, v\]/(f(u), g(v)) of dimension n·m the powers of u + kv are then a basis.
/// Expressed in it, the next power gives γ's polynomial, and u and v give α and β: one linear
/// system for all three. Then the factor that has γ for a root is split off. Exact; of the order
/// of (n·m)³ operations on rationals that grow, so for a few mixed operations on small degrees.
pub(super) fn compositum(a: &NumberField, b: &NumberField) -> Compositum {
    let found = (1_u64..).find_map(|k| {
        let k = Integer::from(k);
        let [polynomial, first, second] = generate(a.modulus(), b.modulus(), &k)?;
        let (modulus, low, high) = isolate_sum(&polynomial, a, b, &k);
        let field = Arc::new(NumberField::new(&modulus, low, high));
        let (first, second) = (&first % &modulus, &second % &modulus);
        Some(Compositum { field, first, second })
    });
    found.expect("all but finitely many integers separate the conjugates")
}

/// γ's polynomial, and α and β as polynomials in γ; `None` if k does not separate.
fn generate(f: &Uni<Rational>, g: &Uni<Rational>, k: &Integer) -> Option<[Uni<Rational>; 3]> {
    let (n, m) = (f.deg(), g.deg());
    let unit = |i: usize, j: usize| {
        let mut vector = vec![Rational::zero(); n * m];
        vector[i * m + j] = Rational::one();
        vector
    };
    let times_generator = |vector: &[Rational]| {
        let mut product = vec![Rational::zero(); n * m];
        for i in 0..n {
            for j in 0..m {
                let entry = &vector[i * m + j];
                if entry.is_zero() {
                    continue;
                }
                // u·uⁱ, reduced by f where i + 1 = n.
                if i + 1 < n {
                    product[(i + 1) * m + j] += entry;
                } else {
                    for (power, c) in f.0[..n].iter().enumerate() {
                        product[power * m + j] -= entry * c;
                    }
                }
                let entry = entry * k;
                if j + 1 < m {
                    product[i * m + j + 1] += entry;
                } else {
                    for (power, c) in g.0[..m].iter().enumerate() {
                        product[i * m + power] -= &entry * c;
                    }
                }
            }
        }
        product
    };
    let mut powers = vec![unit(0, 0)];
    for index in 0..n * m {
        powers.push(times_generator(&powers[index]));
    }
    let last = powers.pop()?;
    let (u, v) = (unit(1, 0), unit(0, 1));
    let mut solutions = solve(&powers, &[&last, &u, &v])?.into_iter();
    let mut polynomial: Vec<Rational> = solutions.next()?.iter().map(|c| -c).collect();
    polynomial.push(Rational::one());
    Some([Uni::new(polynomial), Uni::new(solutions.next()?), Uni::new(solutions.next()?)])
}

/// The factor of γ's polynomial that is zero at γ, and an interval that isolates γ.
fn isolate_sum(
    polynomial: &Uni<Rational>,
    a: &NumberField,
    b: &NumberField,
    k: &Integer,
) -> (Uni<Rational>, Rational, Rational) {
    let k = Rational::from_integer(k.clone());
    let sturm = Sturm::new(polynomial);
    let mut bits = 16;
    loop {
        let (low, high) = a.generator(bits);
        let (from, to) = times(&b.generator(bits), &(k.clone(), k.clone()));
        let (low, high) = (low + from, high + to);
        // γ, which is irrational, lies between the ends: then the upper one is no root either
        if sturm.has_one(&low, &high) {
            let factor = factor_at(polynomial, &factors(polynomial), &low, &high);
            return (factor, low, high);
        }
        bits *= 2;
    }
}
