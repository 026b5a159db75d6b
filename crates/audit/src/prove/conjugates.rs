//! A difference of two sides that are not negative, times their sum: (P − Q)·(P + Q) = P² − Q². Where P and Q
//! are made of roots the squares say more than the sides.

use kane_kernel::{Monomial, Poly, Sign, State};
use num_bigint::BigInt;
use num_traits::One as _;

use super::combination::{Multiple, Size, Summand, combined, summand};
use super::hints::is_told;
use super::monomial::{Known, is_lesser};
use crate::argument::Argument;

/// Terms of a difference.
pub(super) const TERMS: usize = 8;
/// Variables in it and in what is said of its roots.
const VARIABLES: usize = 8;
/// The linear program of the products.
const SIZE: Size = Size { rows: 300, columns: 900, pivots: 400 };

/// The sides P and Q of P − Q, neither of them 0, all of whose terms are not negative.
pub(super) fn sides(state: &State<'_, '_>, p: &Poly) -> Option<(Poly, Poly)> {
    if p.len() > TERMS || !p.terms().all(|(m, _)| Known::of(state, m).is_some()) {
        return None;
    }
    let part = |lesser: bool| {
        let terms = p.terms().filter(|&term| is_lesser(state, term) == Some(lesser));
        Poly::sum(terms.map(|(m, c)| (m.to_vec(), c.clone())))
    };
    let (p, q) = (part(false), part(true).neg());
    (!p.is_empty() && !q.is_empty()).then_some((p, q))
}

/// Equations of degree two or more in a variable, with a number before its highest power: roots.
pub(super) fn roots(state: &State<'_, '_>) -> Vec<(usize, usize)> {
    let live =
        |i: &usize| state.atoms[*i].sign == Sign::Zero && state.atoms[*i].decided().is_none();
    let root = |i: usize| {
        let poly = &state.atoms[i].poly;
        let top = |v: usize| poly.coefficients(v).pop().is_some_and(|c| c.is_constant());
        let var = poly.vars().into_iter().rev().find(|&v| poly.degree(v) >= 2 && top(v))?;
        Some((i, var))
    };
    (0..state.atoms.len()).filter(live).filter_map(root).collect()
}

/// P² − Q² after the equations of roots; `None` for what is no such difference of sides.
fn squared(state: &State<'_, '_>, p: &Poly, roots: &[(usize, usize)]) -> Option<Poly> {
    if !roots.iter().any(|&(_, v)| p.degree(v) > 0) {
        return None;
    }
    let fuel = &state.scope.fuel;
    let (p, q) = sides(state, p)?;
    let mut left = p.pow(2, fuel).ok()?.sub(&q.pow(2, fuel).ok()?);
    for &(i, v) in roots.iter().rev() {
        left = left.remainder(v, &state.atoms[i].poly, true, fuel).ok()?;
    }
    Some(left)
}

/// A contradiction of the sides of one condition with the equations of their roots.
pub(super) fn closed(state: &State<'_, '_>) -> Option<Argument> {
    let roots = roots(state);
    (0..state.atoms.len()).rev().find_map(|i| {
        let atom = &state.atoms[i];
        let strict = atom.sign == Sign::Positive && atom.decided().is_none();
        strict.then(|| squared(state, &atom.poly, &roots))??;
        multiplied(state, i, &roots)
    })
}

/// Condition i times itself and times each of its terms, multiples of equations, and the other conditions.
fn multiplied(state: &State<'_, '_>, i: usize, roots: &[(usize, usize)]) -> Option<Argument> {
    let fuel = &state.scope.fuel;
    let poly = &state.atoms[i].poly;
    let mut summands: Vec<Summand> =
        vec![summand(state, Poly::one(), Vec::new())?, summand(state, Poly::one(), vec![(i, 2)])?];
    for (m, _) in poly.terms() {
        let Known { square, mut factors, .. } = Known::of(state, m)?;
        factors.push((i, 1));
        factors.sort_unstable();
        summands.push(summand(state, Poly::term(square, BigInt::one()), factors)?);
    }
    for (j, atom) in state.atoms.iter().enumerate() {
        if j != i && atom.sign.is_order() && atom.decided().is_none() && atom.poly.len() <= TERMS {
            summands.push(summand(state, Poly::one(), vec![(j, 1)])?);
        }
    }
    let mut vars = poly.vars();
    vars.extend(roots.iter().flat_map(|&(j, _)| state.atoms[j].poly.vars()));
    vars.sort_unstable();
    vars.dedup();
    if vars.len() > VARIABLES {
        return None;
    }
    let total = |m: &[(usize, u32)]| m.iter().map(|x| x.1).sum::<u32>();
    let degree = 2 * poly.terms().map(|(m, _)| total(m)).max()?;
    let mut multiples: Vec<Multiple> = Vec::new();
    for &(j, v) in roots {
        let equation = &state.atoms[j].poly;
        let Some(rest) = degree.checked_sub(equation.degree(v)) else { continue };
        for m in monomials(&vars, rest)? {
            let by = Poly::term(m, BigInt::one());
            let product = by.mul(equation, fuel).ok()?;
            multiples.push((j, by.neg(), product.neg()));
            multiples.push((j, by, product));
        }
    }
    combined(state, summands, multiples, &SIZE)
}

/// The monomials of some variables up to a degree; `None` if there are more than a linear program takes.
fn monomials(vars: &[usize], degree: u32) -> Option<Vec<Monomial>> {
    let mut out: Vec<Monomial> = vec![Monomial::new()];
    for &v in vars {
        let mut next = out.clone();
        for m in &out {
            let left = degree.saturating_sub(m.iter().map(|x| x.1).sum());
            next.extend((1..=left).map(|n| [&m[..], &[(v, n)]].concat()));
        }
        out = next;
        if out.len() > SIZE.columns / 2 {
            return None;
        }
    }
    Some(out)
}

/// A polynomial whose sign decides about sides with roots: a difference that is said not to vanish, or what the
/// squares of two sides differ by, if no condition tells its sign.
pub(super) fn telling(state: &State<'_, '_>) -> Option<Poly> {
    let roots = roots(state);
    state.atoms.iter().filter(|a| a.decided().is_none() && a.sign != Sign::Zero).find_map(|atom| {
        let left = squared(state, &atom.poly, &roots)?;
        let candidates = [atom.poly.primitive().1, left.primitive().1];
        let useful = |p: &&Poly| {
            !p.is_constant() && squared(state, p, &roots).is_some() && !is_told(state, p)
        };
        candidates.iter().find(useful).cloned()
    })
}
