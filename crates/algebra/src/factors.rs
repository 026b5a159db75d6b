//! Polynomials as products, as far as greatest common divisors tell: contents in each variable, and powers.
//!
//! Not all factors are found: of `x² − y²` neither. What is found multiplies to the polynomial.

use kane_kernel::{Fuel, Poly, exponent};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::Signed as _;

use crate::quotient::exact_quotient;
use crate::ring::{content_in, gcd};

/// Terms of a polynomial beyond which it is not taken apart.
const WIDEST: usize = 150;
/// Work that the product of the factors may take.
const FUEL: u64 = 1_000_000;

/// c and the factors f with powers n, single variables first, with p = c·Π fⁿ.
#[must_use]
pub fn factors(p: &Poly) -> (BigInt, Vec<(Poly, u32)>) {
    taken_apart(p).unwrap_or_else(|| {
        let (content, rest) = p.primitive();
        (content, vec![(rest, 1)])
    })
}

fn taken_apart(p: &Poly) -> Option<(BigInt, Vec<(Poly, u32)>)> {
    if p.is_constant() || p.len() > WIDEST {
        return None;
    }
    let mut factors: Vec<(Poly, u32)> = Vec::new();
    let mut rest = p.primitive().1;
    for v in p.vars() {
        let lowest = rest.terms().map(|(m, _)| exponent(m, v)).min().unwrap_or(0);
        if lowest > 0 {
            rest = exact_quotient(&rest, &Poly::power(v, lowest), &budget())?;
            factors.push((Poly::var(v), lowest));
        }
    }
    split(rest, 1, &mut factors)?;
    let (fuel, mut product) = (Fuel::new(FUEL), Poly::one());
    for (f, n) in &factors {
        product = product.mul(&f.pow(*n, &fuel).ok()?, &fuel).ok()?;
    }
    let lead = |p: &Poly| p.terms().last().map(|(_, c)| c.clone());
    let (c, remainder) = lead(p)?.div_rem(&lead(&product)?);
    let is_product = remainder == BigInt::default() && *p == product.scale(&c);
    is_product.then_some((c, factors))
}

/// Adds the factors of p to the power n.
fn split(p: Poly, n: u32, factors: &mut Vec<(Poly, u32)>) -> Option<()> {
    if p.is_constant() {
        return Some(());
    }
    let vars = p.vars();
    for &v in &vars {
        let content = content_in(&p, v);
        if !content.is_constant() {
            let rest = exact_quotient(&p, &content, &budget())?;
            split(content, n, factors)?;
            return split(rest, n, factors);
        }
    }
    let v = *vars.first()?;
    let common = gcd(&p, &p.derivative(v, &Fuel::new(FUEL)).ok()?);
    if !common.is_constant() {
        let rest = exact_quotient(&p, &common, &budget())?;
        split(common, n, factors)?;
        return split(rest, n, factors);
    }
    let mut p = p.primitive().1;
    // of a square with something beside it one factor was in the greatest common divisor, and one is here
    for (f, power) in factors.iter_mut() {
        while let Some(rest) = exact_quotient(&p, f, &budget()) {
            (p, *power) = (rest, *power + n);
        }
    }
    if !p.is_constant() {
        factors.push((if is_mostly_negative(&p) { p.neg() } else { p }, n));
    }
    Some(())
}

/// What one division may take.
fn budget() -> Fuel {
    Fuel::new(FUEL).within(FUEL)
}

fn is_mostly_negative(p: &Poly) -> bool {
    let negative = p.terms().filter(|(_, c)| c.is_negative()).count();
    2 * negative > p.len()
        || 2 * negative == p.len() && p.terms().next().is_some_and(|t| t.1.is_negative())
}

#[cfg(test)]
mod tests {
    use num_traits::One as _;

    use super::*;

    fn var(v: usize) -> Poly {
        Poly::var(v)
    }

    fn times(p: &Poly, q: &Poly) -> Poly {
        p.mul(q, &Fuel::new(FUEL)).expect("small")
    }

    #[test]
    fn what_is_multiplied_is_taken_apart() {
        // −6·x²·(1 + y)·(x − z)²
        let (sum, gap) = (var(1).add(&Poly::one()), var(0).sub(&var(2)));
        let product = times(&times(&Poly::power(0, 2), &sum), &times(&gap, &gap));
        let (c, found) = factors(&product.scale(&(-6).into()));
        assert_eq!(c.magnitude(), &6u32.into());
        let degrees: Vec<u32> = found.iter().map(|f| f.1).collect();
        assert_eq!(found[0], (var(0), 2));
        assert_eq!(found.len(), 3, "{found:?}");
        assert!(degrees.contains(&1) && found.iter().any(|f| f.1 == 2 && f.0.len() == 2));
        let again = found.iter().fold(Poly::constant(c), |product, (f, n)| {
            times(&product, &f.pow(*n, &Fuel::new(FUEL)).expect("small"))
        });
        assert_eq!(again, product.scale(&(-6).into()), "the product is what was taken apart");
    }

    #[test]
    fn a_square_is_told_from_what_stands_beside_it() {
        // (x·y − 1)²·(y − x·y − 1)
        let product = times(&var(0), &var(1));
        let (gap, rest) = (product.sub(&Poly::one()), var(1).sub(&product).sub(&Poly::one()));
        let whole = times(&times(&gap, &gap), &rest);
        let (_, found) = factors(&whole);
        let powers: Vec<(usize, u32)> = found.iter().map(|(f, n)| (f.len(), *n)).collect();
        assert_eq!(powers, [(2, 2), (3, 1)], "{found:?}");
    }

    #[test]
    fn what_has_no_factors_is_itself() {
        let p = var(0).add(&var(1)).scale(&4.into());
        assert_eq!(factors(&p), (4.into(), vec![(var(0).add(&var(1)), 1)]));
        assert_eq!(factors(&Poly::one()), (BigInt::one(), vec![(Poly::one(), 1)]));
    }
}
