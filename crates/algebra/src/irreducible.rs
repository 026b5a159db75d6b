//! Irreducible polynomials, as the degrees of factors modulo primes show them: most are seen at once, and need no
//! search for factors.

use kane_kernel::Fuel;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;
use polycore::{Gf, Uni};

/// Whether no factor of p has a degree between 0 and its own: such a factor is one modulo each prime too, with a degree
/// that the factors there add up to. Exact where it is `true`; `false` says nothing.
pub(crate) fn is_irreducible(p: &[BigInt], fuel: &Fuel) -> bool {
    // one bit of a word a degree
    let Some(degree) = p.len().checked_sub(1).filter(|n| (1..64).contains(n)) else {
        return false;
    };
    let whole = 1 | 1 << degree;
    let mut possible = u64::MAX;
    for sums in [sums::<11>, sums::<13>, sums::<17>, sums::<19>, sums::<23>, sums::<29>] {
        if fuel.spend((degree * degree * degree) as u64).is_err() {
            return false;
        }
        possible &= sums(p).unwrap_or(u64::MAX);
        if possible == whole {
            return true;
        }
    }
    false
}

/// The degrees of products of factors modulo a prime, one bit a degree; `None` where the degree falls there or a factor
/// is repeated (Cantor and Zassenhaus 1981: factors of distinct degrees).
fn sums<const PRIME: u64>(p: &[BigInt]) -> Option<u64> {
    let residue = |c: &BigInt| c.mod_floor(&PRIME.into()).to_u64();
    let residues: Option<Vec<_>> = p.iter().map(|c| Some(Gf::<PRIME>::new(residue(c)?))).collect();
    let mut rest = Uni::new(residues?);
    if rest.deg() + 1 != p.len() || rest.gcd(&rest.derivative()).deg() > 0 {
        return None;
    }
    let mut sums = 1u64;
    let mut power = Uni::x();
    for degree in 1.. {
        if 2 * degree > rest.deg() {
            break;
        }
        // all irreducible polynomials whose degree divides n divide x^(pⁿ) − x
        power = power.powmod(PRIME, &rest);
        let product = rest.gcd(&(&power - &Uni::x()));
        for _ in 0..product.deg() / degree {
            sums |= sums << degree;
        }
        rest = rest.exact(&product)?;
    }
    if rest.deg() > 0 {
        sums |= sums << rest.deg();
    }
    Some(sums)
}

#[cfg(test)]
mod tests {
    use num_traits::Zero;
    use quickcheck::quickcheck;

    use super::*;
    use crate::coprime::uni;

    fn fuel() -> Fuel {
        Fuel::new(1 << 30)
    }

    fn whole(p: &[i8]) -> Vec<BigInt> {
        let mut p: Vec<BigInt> = p.iter().map(|c| BigInt::from(*c)).collect();
        while p.last().is_some_and(Zero::is_zero) {
            p.pop();
        }
        p
    }

    quickcheck! {
        fn what_is_said_to_be_irreducible_is_not_a_product(a: Vec<i8>, b: Vec<i8>) -> bool {
            let (a, b) = (whole(&a[..a.len().min(5)]), whole(&b[..b.len().min(5)]));
            let product = &uni(&a) * &uni(&b);
            let product: Vec<BigInt> = product.0.iter().map(|c| c.numer().clone()).collect();
            a.len() < 2 || b.len() < 2 || !is_irreducible(&product, &fuel())
        }

        fn what_is_said_to_be_irreducible_has_one_factor(p: Vec<i8>) -> bool {
            let p = whole(&p[..p.len().min(7)]);
            let one = || {
                let factors = polyfactor::factor(&uni(&p)).into_iter();
                factors.filter(|(f, _)| f.deg() > 0).map(|(_, n)| n).sum::<u32>() == 1
            };
            !is_irreducible(&p, &fuel()) || one()
        }
    }

    #[test]
    fn polynomials_without_rational_factors_are_seen() {
        for p in
            [&[-2, 0, 0, 0, 1][..], &[1, 1, 1, 1, 1], &[3, -3, 0, 0, 0, 1], &[-1, -1, 0, 0, 0, 1]]
        {
            assert!(is_irreducible(&whole(p), &fuel()), "{p:?}");
        }
    }

    #[test]
    fn what_falls_apart_modulo_every_prime_is_left_to_the_search() {
        assert!(!is_irreducible(&whole(&[1, 0, 0, 0, 1]), &fuel()));
    }

    #[test]
    fn without_a_budget_nothing_is_said() {
        assert!(!is_irreducible(&whole(&[-2, 0, 0, 0, 1]), &Fuel::new(0)));
    }
}
