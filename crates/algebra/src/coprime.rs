//! Coprime bases: polynomials without common or repeated roots of which given ones are products.

use std::collections::BTreeSet;

use kane_kernel::{Fuel, Rejection};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use polycore::{Gf, Uni};

use crate::irreducible::pieces;
use crate::work::spend_fraction;

type Q = BigRational;

/// Above this degree polynomials are split by greatest common divisors only, not factored.
const FACTOR_DEGREE: usize = 24;
/// Beyond this measure of degree and coefficients, too: factoring knows no budget.
const FACTOR_COST: u64 = 60_000;

/// Factors modulo a prime above which those of a polynomial are not searched for: all their sums are tried.
const MOST_PIECES: u32 = 8;

/// What a search for factors may take: some tenths of a second without optimization.
const MOST_LIFTING: u64 = 8_000_000;

pub(crate) fn uni(p: &[BigInt]) -> Uni<Q> {
    Uni::new(p.iter().map(|c| Q::from_integer(c.clone())).collect())
}

pub(crate) fn integers(p: &Uni<Q>) -> Vec<BigInt> {
    p.primitive().0.iter().map(|c| c.numer().clone()).collect()
}

/// Pairwise coprime square-free polynomials of which all inputs are products.
pub(crate) fn coprime_bases(
    polys: &[Vec<BigInt>],
    fuel: &Fuel,
) -> Result<Vec<Vec<BigInt>>, Rejection> {
    let mut seen = Vec::new();
    let mut irreducible: BTreeSet<Vec<BigInt>> = BTreeSet::new();
    let mut coarse: Vec<Uni<Q>> = Vec::new();
    for p in polys {
        if p.len() <= 1 || seen.contains(p) {
            continue;
        }
        seen.push(p.clone());
        let degree = u64::try_from(p.len()).unwrap_or(u64::MAX);
        let words = 1 + p.iter().map(BigInt::bits).max().unwrap_or(0) / 64;
        fuel.spend(degree.saturating_pow(3).saturating_mul(words))?;
        match irreducible_factors(p, fuel)? {
            Some(factors) => irreducible.extend(factors),
            None => coarse.extend(squarefree(p, fuel)?),
        }
    }
    // Refine until nothing is shared; irreducible factors are coprime already.
    let mut bases: Vec<Uni<Q>> = irreducible.iter().map(|p| uni(p)).collect();
    for mut part in coarse {
        let mut i = 0;
        while i < bases.len() && part.deg() > 0 {
            let g = gcd(&part, &bases[i], fuel)?;
            if g.deg() > 0 {
                let rest = divided(&bases[i], &g, fuel)?.0;
                part = divided(&part, &g, fuel)?.0;
                if rest.deg() > 0 {
                    bases.push(rest);
                }
                bases[i] = g;
            }
            i += 1;
        }
        if part.deg() > 0 {
            bases.push(part);
        }
    }
    Ok(bases.iter().map(integers).collect())
}

/// The irreducible factors of p, of degree 1 or more; none if it would take too long. A factor of
/// the reversed polynomial is one of p reversed, and what has the smaller leading coefficient is
/// factored faster, because it is made monic first.
fn irreducible_factors(p: &[BigInt], fuel: &Fuel) -> Result<Option<Vec<Vec<BigInt>>>, Rejection> {
    let zeros = p.iter().take_while(|c| c.is_zero()).count();
    let mut rest = p[zeros..].to_vec();
    let lead = |p: &[BigInt]| p.last().map_or(0, BigInt::bits);
    let backwards = rest.first().map_or(0, BigInt::bits) < lead(&rest);
    if backwards {
        rest.reverse();
    }
    let degree = u64::try_from(rest.len() - 1).unwrap_or(u64::MAX);
    let bits = rest.iter().map(BigInt::bits).max().unwrap_or(0);
    let height = bits.saturating_add(degree.saturating_mul(lead(&rest)));
    let cost = degree.saturating_mul(degree).saturating_mul(height);
    if rest.len() > FACTOR_DEGREE + 1 || cost > FACTOR_COST {
        return Ok(None);
    }
    fuel.spend(cost)?;
    let mut factors = if let Some(factors) = quadratic_factors(&rest) {
        factors
    } else {
        match pieces(&rest, fuel) {
            Some(1) => vec![primitive(&rest)],
            pieces => {
                // lifting takes the square of the bits
                let lifting = cost.saturating_mul(height);
                if pieces.is_some_and(|n| n > MOST_PIECES) || lifting > MOST_LIFTING {
                    return Ok(None);
                }
                let sums = cost << pieces.unwrap_or(MOST_PIECES);
                fuel.spend_beyond(lifting.saturating_add(sums))?;
                let factors = polyfactor::factor(&uni(&rest)).into_iter();
                factors.filter(|(f, _)| f.deg() > 0).map(|(f, _)| integers(&f)).collect()
            }
        }
    };
    if backwards {
        for factor in &mut factors {
            factor.reverse();
            // as the other way gives it: with a positive leading coefficient
            *factor = primitive(factor);
        }
    }
    if zeros > 0 {
        factors.push(vec![BigInt::from(0), BigInt::from(1)]);
    }
    Ok(Some(factors))
}

/// The irreducible factors of a polynomial of degree two at most: most are, and need no search.
fn quadratic_factors(p: &[BigInt]) -> Option<Vec<Vec<BigInt>>> {
    match p {
        [] | [_] => Some(Vec::new()),
        [_, _] => Some(vec![primitive(p)]),
        [c, b, a] => {
            let discriminant: BigInt = b * b - a * c * 4;
            let root = if discriminant.is_negative() { None } else { Some(discriminant.sqrt()) };
            let Some(root) = root.filter(|root| root * root == discriminant) else {
                return Some(vec![primitive(p)]);
            };
            // 4·a·p = (2·a·x + b − s)·(2·a·x + b + s)
            let factor = |s: BigInt| primitive(&[b + s, a * 2]);
            let factors = [factor(-&root), factor(root)];
            Some(if factors[0] == factors[1] { factors[..1].to_vec() } else { factors.to_vec() })
        }
        _ => None,
    }
}

/// A polynomial without a factor that all coefficients share, with a positive leading one.
fn primitive(p: &[BigInt]) -> Vec<BigInt> {
    let mut content = p.iter().fold(BigInt::zero(), |g, c| if g.is_one() { g } else { g.gcd(c) });
    if p.last().is_some_and(Signed::is_negative) {
        content = -content;
    }
    p.iter().map(|c| if content.is_one() { c.clone() } else { c / &content }).collect()
}

/// The square-free parts of p, without their multiplicities (Yun 1976).
fn squarefree(p: &[BigInt], fuel: &Fuel) -> Result<Vec<Uni<Q>>, Rejection> {
    let f = uni(p);
    if visibly_squarefree(p, fuel)? {
        return Ok(vec![f]);
    }
    let slope = f.derivative();
    let common = gcd(&f, &slope, fuel)?;
    let (mut rest, mut slope) = (divided(&f, &common, fuel)?.0, divided(&slope, &common, fuel)?.0);
    let mut parts = Vec::new();
    while rest.deg() > 0 {
        slope = &slope - &rest.derivative();
        let part = gcd(&rest, &slope, fuel)?;
        (rest, slope) = (divided(&rest, &part, fuel)?.0, divided(&slope, &part, fuel)?.0);
        parts.extend((part.deg() > 0).then_some(part));
    }
    Ok(parts)
}

/// Whether p keeps its degree modulo a prime and shares no root with its derivative there: it then
/// has no square factor, and no long division is needed to see it.
fn visibly_squarefree(p: &[BigInt], fuel: &Fuel) -> Result<bool, Rejection> {
    const PRIME: u64 = (1 << 61) - 1;
    let degree = u64::try_from(p.len()).unwrap_or(u64::MAX);
    fuel.spend(degree.saturating_mul(degree))?;
    let residue = |c: &BigInt| c.mod_floor(&PRIME.into()).to_u64().unwrap_or(0);
    let f: Uni<Gf<PRIME>> = Uni::new(p.iter().map(|c| Gf::new(residue(c))).collect());
    Ok(f.deg() + 1 == p.len() && f.gcd(&f.derivative()).deg() == 0)
}

/// The monic greatest common divisor (Euclid). The remainders are made monic on the way, which
/// keeps their coefficients as small as they can be.
fn gcd(a: &Uni<Q>, b: &Uni<Q>, fuel: &Fuel) -> Result<Uni<Q>, Rejection> {
    let (mut a, mut b) = (a.clone(), b.monic());
    while !b.is_zero() {
        let rest = divided(&a, &b, fuel)?.1;
        a = std::mem::replace(&mut b, rest.monic());
    }
    Ok(a.monic())
}

/// Quotient and remainder. Coefficients grow while a division runs, so each of its steps spends what
/// it costs then.
fn divided(a: &Uni<Q>, b: &Uni<Q>, fuel: &Fuel) -> Result<(Uni<Q>, Uni<Q>), Rejection> {
    let words = |q: &Q| 1 + (q.numer().bits() + q.denom().bits()) / 64;
    let (mut rest, mut quotient) = (a.0.clone(), Vec::new());
    let lead = b.lc();
    while rest.len() >= b.0.len() {
        let (at, top) = (rest.len() - b.0.len(), rest.pop().unwrap_or_else(Q::zero) / &lead);
        for (i, c) in b.0[..b.deg()].iter().enumerate() {
            if !top.is_zero() && !c.is_zero() {
                let size = words(&top) + words(c) + words(&rest[at + i]);
                spend_fraction(size, fuel)?;
                rest[at + i] -= &top * c;
            }
        }
        quotient.push(top);
    }
    quotient.reverse();
    Ok((Uni::new(quotient), Uni::new(rest)))
}

/// p = constant · Π baseᵢ^eᵢ, where no coefficients of a base share a factor: so all quotients have whole ones (Gauss
/// 1801).
pub(crate) fn factor_over(
    p: &[BigInt],
    bases: &[Vec<BigInt>],
    fuel: &Fuel,
) -> Result<(Q, Vec<u32>), Rejection> {
    let mut rest = p.to_vec();
    let mut powers = vec![0; bases.len()];
    for (base, n) in bases.iter().zip(&mut powers) {
        while rest.len() >= base.len()
            && let Some(quotient) = whole_quotient(&rest, base, fuel)?
        {
            rest = quotient;
            *n += 1;
        }
    }
    match &rest[..] {
        [] => Ok((Q::zero(), powers)),
        [constant] => Ok((Q::from_integer(constant.clone()), powers)),
        _ => Err(Rejection::NotAnIdentity),
    }
}

/// The quotient of two polynomials, if it has whole coefficients and nothing remains.
fn whole_quotient(
    p: &[BigInt],
    by: &[BigInt],
    fuel: &Fuel,
) -> Result<Option<Vec<BigInt>>, Rejection> {
    let words = |c: &BigInt| 1 + c.bits() / 64;
    let Some((lead, lower)) = by.split_last() else { return Ok(None) };
    let (mut rest, mut quotient) = (p.to_vec(), Vec::new());
    while rest.len() > lower.len() {
        let Some(top) = rest.pop() else { break };
        let at = rest.len() - lower.len();
        let (top, remainder) = top.div_rem(lead);
        if !remainder.is_zero() {
            return Ok(None);
        }
        for (c, x) in lower.iter().zip(&mut rest[at..]) {
            if !top.is_zero() && !c.is_zero() {
                fuel.spend(words(&top) + words(c) + words(x))?;
                *x -= &top * c;
            }
        }
        quotient.push(top);
    }
    quotient.reverse();
    Ok(rest.iter().all(Zero::is_zero).then_some(quotient))
}

#[cfg(test)]
mod tests {
    use quickcheck::quickcheck;

    use super::*;

    quickcheck! {
        fn short_polynomials_have_the_factors_that_a_search_finds(c: i16, b: i16, a: i16, n: i8) -> bool {
            // some with rational roots, some with a common factor
            let products = [vec![c, b, a], vec![c, a], vec![c.wrapping_mul(b) / 4, 0, a]];
            products.iter().all(|p| {
                let mut p: Vec<BigInt> = p.iter().map(|x| BigInt::from(*x) * n).collect();
                while p.last().is_some_and(Zero::is_zero) {
                    p.pop();
                }
                if p.is_empty() {
                    return true;
                }
                let Some(mut quick) = quadratic_factors(&p) else { return false };
                let found = polyfactor::factor(&uni(&p)).into_iter().filter(|(f, _)| f.deg() > 0);
                let mut found: Vec<Vec<BigInt>> = found.map(|(f, _)| integers(&f)).collect();
                quick.sort();
                found.sort();
                quick == found
            })
        }

        fn products_of_two_lines_fall_into_them(a: i16, b: i16, c: i16, d: i16) -> bool {
            let line = |n: i16, m: i16| vec![BigInt::from(n), BigInt::from(i32::from(m) * 2 + 1)];
            let (one, other) = (line(a, b), line(c, d));
            let product = &uni(&one) * &uni(&other);
            let whole: Vec<BigInt> = product.0.iter().map(|c| c.numer().clone()).collect();
            let factors = quadratic_factors(&whole);
            factors.is_some_and(|f| f.contains(&primitive(&one)) && f.contains(&primitive(&other)))
        }
    }
}
