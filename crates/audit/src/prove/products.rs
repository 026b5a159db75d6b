//! Linear programs over products of conditions.

use kane_algebra::ring::Ring;
use kane_algebra::squares::total_degree;
use kane_kernel::{Monomial, Poly, Sign, State, Term};
use num_bigint::BigInt;
use num_traits::One;

use super::combination::{Multiple, Size, Summand, combined};
use super::elimination::Factors;
use crate::argument::Argument;

/// A product of conditions by their indices and powers, multiplied out, and whether it is positive for sure.
type Product = (Factors, Poly, bool);

/// Linear programming over products of atoms and squares of binomials (Handelman 1988; diagonally
/// dominant sums of squares). Small systems only.
pub(super) fn products(state: &State<'_, '_>, degree: u32) -> Option<Argument> {
    let fuel = &state.scope.fuel;
    let live: Vec<usize> =
        (0..state.atoms.len()).filter(|&i| state.atoms[i].decided().is_none()).collect();
    let having = |sign: &dyn Fn(Sign) -> bool| -> Vec<usize> {
        live.iter().copied().filter(|&i| sign(state.atoms[i].sign)).collect()
    };
    let known = having(&|s| matches!(s, Sign::Positive | Sign::NonNegative));
    let ring = Ring::of(&live.iter().map(|&i| &state.atoms[i].poly).collect::<Vec<_>>());
    let top = live.iter().map(|&i| total_degree(&state.atoms[i].poly)).max()?;
    if ring.len() > 5 || known.len() > 14 || top > 8 || live.is_empty() {
        return None;
    }
    let limit = top.max(degree);
    let mut generators = of_conditions(state, &known, degree, limit)?;
    for i in having(&|s| s == Sign::NonZero) {
        let square = state.atoms[i].poly.pow(2, fuel).ok()?;
        generators.push((vec![(i, 2)], square, true));
    }
    if generators.len() > 400 {
        return None;
    }
    let mut vars: Vec<usize> = live.iter().flat_map(|&i| state.atoms[i].poly.vars()).collect();
    vars.sort_unstable();
    vars.dedup();
    let monomials = monomials(&vars, (limit / 2).min(3));
    let mut columns: Vec<Summand> = Vec::new();
    let mut add = |square: Poly, g: &Product| -> Option<()> {
        let p = square.pow(2, fuel).ok()?.mul(&g.1, fuel).ok()?;
        if total_degree(&p) <= limit && columns.len() < 1500 {
            let strict = g.2 && square.is_constant();
            let term = Term { weight: BigInt::one(), square, factors: g.0.clone() };
            columns.push((term, p, strict));
        }
        Some(())
    };
    for g in &generators {
        add(Poly::one(), g)?;
    }
    let squares = with_binomials(&monomials);
    for g in generators.iter().filter(|g| g.0.len() <= 1) {
        for s in squares.iter().filter(|s| !s.is_constant()) {
            add(s.clone(), g)?;
        }
    }
    let mut multiples: Vec<Multiple> = Vec::new();
    for i in having(&|s| s == Sign::Zero) {
        for m in &monomials {
            let m = Poly::term(m.clone(), BigInt::one());
            let p = m.mul(&state.atoms[i].poly, fuel).ok()?;
            if total_degree(&p) <= limit {
                multiples.push((i, m.clone(), p.clone()));
                multiples.push((i, m.neg(), p.neg()));
            }
        }
    }
    combined(state, columns, multiples, &Size { rows: 130, columns: 1500, pivots: 400 })
}

/// Products of at most `degree` atoms, of a total degree of at most `limit`, and 1. `None` if the budget is spent.
fn of_conditions(
    state: &State<'_, '_>,
    known: &[usize],
    degree: u32,
    limit: u32,
) -> Option<Vec<Product>> {
    let mut generators: Vec<Product> = vec![(Vec::new(), Poly::one(), true)];
    let mut layer = generators.clone();
    for _ in 0..degree {
        let mut next = Vec::new();
        for (factors, p, strict) in &layer {
            let from = factors.last().map_or(0, |f| f.0);
            for &i in known.iter().filter(|&&i| i >= from) {
                let q = p.mul(&state.atoms[i].poly, &state.scope.fuel).ok()?;
                if total_degree(&q) > limit {
                    continue;
                }
                let mut factors = factors.clone();
                match factors.last_mut() {
                    Some(last) if last.0 == i => last.1 += 1,
                    _ => factors.push((i, 1)),
                }
                next.push((factors, q, *strict && state.atoms[i].sign == Sign::Positive));
            }
        }
        generators.extend(next.iter().cloned());
        layer = next;
    }
    Some(generators)
}

/// Monomials in these variables up to a degree, or up to the one at which they are more than 36.
fn monomials(vars: &[usize], degree: u32) -> Vec<Monomial> {
    let mut monomials: Vec<Monomial> = vec![Vec::new()];
    for _ in 0..degree {
        let mut next = Vec::new();
        for m in &monomials {
            for &v in vars {
                let mut n = m.clone();
                match n.iter_mut().find(|x| x.0 == v) {
                    Some(x) => x.1 += 1,
                    None => {
                        n.push((v, 1));
                        n.sort_unstable();
                    }
                }
                next.push(n);
            }
        }
        monomials.extend(next);
        monomials.sort();
        monomials.dedup();
        if monomials.len() > 36 {
            break;
        }
    }
    monomials
}

/// Monomials, and the sums and differences of two of them.
fn with_binomials(monomials: &[Monomial]) -> Vec<Poly> {
    let mut out = Vec::new();
    for (i, a) in monomials.iter().enumerate() {
        let a = Poly::term(a.clone(), BigInt::one());
        for b in &monomials[..i] {
            let b = Poly::term(b.clone(), BigInt::one());
            out.push(a.add(&b));
            out.push(a.sub(&b));
        }
        out.push(a);
    }
    out
}
