//! Irreducible polynomials, as the degrees of factors modulo primes show them: most are seen at once, and need no
//! search for factors.

use kane_kernel::Fuel;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;
use polycore::{Gf, Uni};

/// 1 for what is irreducible: a factor is one modulo each prime too, with a degree that the factors there add up to, and
/// none is left between 0 and that of p. Else the smallest number of factors modulo a prime, all sums of which a search
/// for factors has to try. Exact where it is 1; `None` where nothing is known.
pub(crate) fn pieces(p: &[BigInt], fuel: &Fuel) -> Option<u32> {
    // one bit of a word a degree
    let degree = p.len().checked_sub(1).filter(|n| (1..64).contains(n))?;
    let whole = 1 | 1 << degree;
    let (mut possible, mut fewest) = (u64::MAX, None);
    for sums in [sums::<11>, sums::<13>, sums::<17>, sums::<19>, sums::<23>, sums::<29>] {
        fuel.spend((degree * degree * degree) as u64).ok()?;
        let Some((degrees, count)) = sums(p) else { continue };
        possible &= degrees;
        if possible == whole {
            return Some(1);
        }
        fewest = Some(fewest.map_or(count, |n: u32| n.min(count)));
    }
    fewest
}

/// The degrees of products of factors modulo a prime, one bit a degree, and how many factors there are; `None` where
/// the degree falls there or a factor is repeated (Cantor and Zassenhaus 1981: factors of distinct degrees).
fn sums<const PRIME: u64>(p: &[BigInt]) -> Option<(u64, u32)> {
    let residue = |c: &BigInt| c.mod_floor(&PRIME.into()).to_u64();
    let residues: Option<Vec<_>> = p.iter().map(|c| Some(Gf::<PRIME>::new(residue(c)?))).collect();
    let mut rest = Uni::new(residues?);
    if rest.deg() + 1 != p.len() || rest.gcd(&rest.derivative()).deg() > 0 {
        return None;
    }
    let (mut sums, mut count) = (1u64, 0);
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
            count += 1;
        }
        rest = rest.exact(&product)?;
    }
    if rest.deg() > 0 {
        sums |= sums << rest.deg();
        count += 1;
    }
    Some((sums, count))
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
            a.len() < 2 || b.len() < 2 || pieces(&product, &fuel()) != Some(1)
        }

        fn what_is_said_to_be_irreducible_has_one_factor(p: Vec<i8>) -> bool {
            let p = whole(&p[..p.len().min(7)]);
            let one = || {
                let factors = polyfactor::factor(&uni(&p)).into_iter();
                factors.filter(|(f, _)| f.deg() > 0).map(|(_, n)| n).sum::<u32>() == 1
            };
            pieces(&p, &fuel()) != Some(1) || one()
        }
    }

    #[test]
    fn polynomials_without_rational_factors_are_seen() {
        for p in
            [&[-2, 0, 0, 0, 1][..], &[1, 1, 1, 1, 1], &[3, -3, 0, 0, 0, 1], &[-1, -1, 0, 0, 0, 1]]
        {
            assert_eq!(pieces(&whole(p), &fuel()), Some(1), "{p:?}");
        }
    }

    #[test]
    fn what_falls_apart_modulo_every_prime_is_left_to_the_search() {
        assert_eq!(pieces(&whole(&[1, 0, 0, 0, 1]), &fuel()), Some(2));
    }

    #[test]
    fn without_a_budget_nothing_is_said() {
        assert_eq!(pieces(&whole(&[-2, 0, 0, 0, 1]), &Fuel::new(0)), None);
    }
}
