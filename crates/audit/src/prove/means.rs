//! Arithmetic and geometric means: a monomial that lies between others is at most a mean of them. Each step of the
//! chain is x^p + x^q − 2·x^((p + q)/2) = x^m·(x^((p − m)/2) − x^((q − m)/2))², where m has the lower powers of p and q
//! (Reznick, Forms derived from the arithmetic-geometric inequality, 1989): few terms in many variables of any degree.

use std::collections::BTreeSet;

use kane_kernel::{Atom, Monomial, Poly, Sign, State, exponent};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One, Signed};

use super::circuits::{Term, circuits};
use super::combination::{Size, Summand, combined, summand};
use super::monomial::{known, sign};
use crate::argument::Argument;

/// Terms of a condition.
const TERMS: usize = 120;
/// Terms of one between all of which chains are looked for.
const FEW: usize = 24;
/// Monomials between terms.
const POINTS: usize = 120;
/// Rounds in which they are found, each between those of the one before.
const ROUNDS: usize = 2;
/// The linear program of the steps.
const SIZE: Size = Size { rows: 240, columns: 1200, pivots: 400 };

/// A contradiction between one condition and means of its terms.
pub(super) fn means(state: &State<'_, '_>) -> Option<Argument> {
    apart(state).find_map(|i| below(state, i, &[]))
}

/// The same between sums of products of one condition with each of its variables, which are not negative, and means of
/// their terms: between the powers in a²·c·d + b²·a·d + c²·a·b + d²·b·c no mean has whole powers, and that it is at least
/// 4·a·b·c·d is shown where both are multiplied by a + b + c + d (as Pólya, Über positive Darstellung von Polynomen, 1928).
pub(super) fn multiplied(state: &State<'_, '_>) -> Option<Argument> {
    apart(state).find_map(|i| {
        let vars = state.atoms[i].poly.vars();
        let above_zero = |&v: &usize| sign(state, v).filter(|known| !known.1).map(|known| known.0);
        below(state, i, &vars.iter().map(above_zero).collect::<Option<Vec<_>>>()?)
    })
}

/// Conditions with few terms of both signs, the last one first.
fn apart<'a>(state: &'a State<'_, '_>) -> impl Iterator<Item = usize> + 'a {
    (0..state.atoms.len()).rev().filter(|&i| fits(&state.atoms[i]))
}

fn fits(atom: &Atom) -> bool {
    let up = atom.poly.terms().any(|(_, c)| c.is_positive());
    let down = atom.poly.terms().filter(|(_, c)| c.is_negative()).count();
    let few = atom.sign == Sign::Positive && up && down > 1 && atom.poly.len() <= TERMS;
    few && atom.decided().is_none()
}

/// The contradiction with one condition, alone or with its products with some others.
fn below(state: &State<'_, '_>, i: usize, by: &[usize]) -> Option<Argument> {
    let product = |&j: &usize| summand(state, Poly::one(), vec![(i.min(j), 1), (i.max(j), 1)]);
    let alone = summand(state, Poly::one(), vec![(i, 1)])?;
    let products = by.iter().map(product).collect::<Option<Vec<Summand>>>()?;
    let mut summands: Vec<Summand> = std::iter::once(alone).chain(products).collect();
    let vars = state.atoms[i].poly.vars();
    let row = |m: &[(usize, u32)]| -> Vec<u32> { vars.iter().map(|&v| exponent(m, v)).collect() };
    let monomial = |row: &[u32]| -> Monomial {
        vars.iter().copied().zip(row.iter().copied()).filter(|power| power.1 > 0).collect()
    };
    let all = match &summands[1..] {
        [] => summands[0].1.clone(),
        products => products.iter().fold(Poly::default(), |sum, (_, poly, _)| sum.add(poly)),
    };
    let terms: Vec<Term> = all.terms().map(|(m, c)| (row(m), c.clone())).collect();
    let circuits = circuits(&terms, &state.scope.fuel)?;
    for (p, _) in terms.iter().filter(|term| term.1.is_negative()) {
        if let Some((square, factors)) = known(state, &monomial(p)) {
            summands.push(summand(state, Poly::term(square, BigInt::one()), factors)?);
        }
    }
    let by_steps = |steps: BTreeSet<[Vec<u32>; 2]>| {
        let mut summands = summands.clone();
        for [p, q] in steps {
            let Some((common, [p, q])) = step(&p, &q) else { continue };
            let Some((square, factors)) = known(state, &monomial(&common)) else { continue };
            let half = |row: &[u32]| Poly::term(monomial(row), BigInt::one());
            let square = Poly::term(square, BigInt::one());
            let square = square.mul(&half(&p).sub(&half(&q)), &state.scope.fuel).ok()?;
            summands.push(summand(state, square, factors)?);
        }
        combined(state, summands, Vec::new(), &SIZE)
    };
    // between the terms of one circuit there may be no chain, and between those of all there is
    let all = || {
        let few = terms.len() <= FEW;
        few.then(|| steps(terms.iter().map(|term| term.0.clone()).collect()))
    };
    by_steps(circuits.into_iter().flat_map(steps).collect()).or_else(|| by_steps(all()?))
}

/// Points of which the middle is one, too, between some that are given.
fn steps(ends: BTreeSet<Vec<u32>>) -> BTreeSet<[Vec<u32>; 2]> {
    let points = between(ends).unwrap_or_default();
    let mut steps = BTreeSet::new();
    for (n, p) in points.iter().enumerate() {
        let middle =
            |q: &Vec<u32>| -> Vec<u32> { p.iter().zip(q).map(|(a, b)| (a + b) / 2).collect() };
        let whole = points.iter().take(n).filter(|q| points.contains(&middle(q)));
        steps.extend(whole.map(|q| [p.clone(), q.clone()]));
    }
    steps
}

/// All points of the lattice on the segments between some, and on those between these; `None` for too many.
fn between(ends: BTreeSet<Vec<u32>>) -> Option<BTreeSet<Vec<u32>>> {
    let mut points = ends;
    for _ in 0..ROUNDS {
        let old: Vec<Vec<u32>> = points.iter().cloned().collect();
        for (n, p) in old.iter().enumerate() {
            for q in &old[..n] {
                let parts = p.iter().zip(q).fold(0, |g: u32, (a, b)| g.gcd(&a.abs_diff(*b)));
                for k in 1..parts {
                    // p + k·(q − p)/parts
                    let at = |(a, b): (&u32, &u32)| (a * (parts - k) + b * k) / parts;
                    points.insert(p.iter().zip(q).map(at).collect());
                }
                if points.len() > POINTS {
                    return None;
                }
            }
        }
    }
    Some(points)
}

/// The lower powers of two points, and half of what is left of each; `None` where that is no square.
fn step(p: &[u32], q: &[u32]) -> Option<(Vec<u32>, [Vec<u32>; 2])> {
    let common: Vec<u32> = p.iter().zip(q).map(|(a, b)| *a.min(b)).collect();
    let half = |row: &[u32]| -> Option<Vec<u32>> {
        let left = row.iter().zip(&common).map(|(a, m)| a - m);
        left.map(|n| n.is_even().then_some(n / 2)).collect()
    };
    let halves = [half(p)?, half(q)?];
    Some((common, halves))
}
