//! Products of two conditions, where there are too many variables for products with squares.

use kane_algebra::squares::total_degree;
use kane_kernel::{Atom, Poly, Sign, State};

use super::combination::{Multiple, Size, Summand, combined, summand};
use super::elimination::Factors;
use super::linear::combination;
use super::tactics;
use crate::argument::Argument;

/// Conditions that are multiplied by each other; where there are more, only those of degree one are.
const CONDITIONS: usize = 28;
/// Conditions that count alone.
const ALONE: usize = 120;
/// Terms of a condition that is multiplied.
const TERMS: usize = 24;
/// The linear program of the products.
const SIZE: Size = Size { rows: 400, columns: 600, pivots: 400 };
/// Variables whose sign is asked for.
const UNSIGNED: usize = 3;

/// Multiples of conditions, of products of two of them, and of equations times a variable, that sum to 0
/// although one is positive.
pub(super) fn pairs(state: &State<'_, '_>, vars: &[usize]) -> Option<Argument> {
    let fuel = &state.scope.fuel;
    let live = |sign: fn(Sign) -> bool| -> Vec<usize> {
        let short = |a: &Atom| a.decided().is_none() && a.poly.len() <= TERMS;
        (0..state.atoms.len())
            .filter(|&i| sign(state.atoms[i].sign) && short(&state.atoms[i]))
            .collect()
    };
    let (mut known, equations) = (live(Sign::is_order), live(|sign| sign == Sign::Zero));
    known.retain(|&i| !is_repeated(state, i));
    let mut multiplied = known.clone();
    if known.len() > CONDITIONS {
        multiplied.retain(|&i| total_degree(&state.atoms[i].poly) == 1);
    }
    if multiplied.len() > CONDITIONS || known.len() > ALONE {
        return None;
    }
    let mut factors: Vec<Factors> = vec![Vec::new()];
    for &i in &known {
        factors.push(vec![(i, 1)]);
        if let Some(n) = multiplied.iter().position(|&j| j == i) {
            factors.extend(multiplied[..n].iter().map(|&j| vec![(j, 1), (i, 1)]));
            factors.push(vec![(i, 2)]);
        }
    }
    let summands = factors.into_iter().map(|factors| summand(state, Poly::one(), factors));
    let summands: Vec<Summand> = summands.collect::<Option<_>>()?;
    let mut multiples: Vec<Multiple> = Vec::new();
    let by: Vec<Poly> =
        std::iter::once(Poly::one()).chain(vars.iter().map(|&v| Poly::var(v))).collect();
    for &i in &equations {
        for by in &by {
            let product = by.mul(&state.atoms[i].poly, fuel).ok()?;
            multiples.push((i, by.neg(), product.neg()));
            multiples.push((i, by.clone(), product));
        }
    }
    combined(state, summands, multiples, &SIZE)
}

/// Whether another condition says the same or more.
fn is_repeated(state: &State<'_, '_>, i: usize) -> bool {
    let atom = &state.atoms[i];
    state.atoms.iter().enumerate().any(|(j, other)| {
        let more = other.sign == Sign::Positive && atom.sign == Sign::NonNegative;
        other.poly == atom.poly && (more || other.sign == atom.sign && j < i)
    })
}

/// The same in the cases of the sign of one variable that multiplies others and has no sign yet.
pub(super) fn by_sign(state: &State<'_, '_>, vars: &[usize]) -> Option<Argument> {
    let told = |v: usize| {
        let alone = |a: &Atom| a.sign != Sign::NonZero && a.poly.len() == 1 && a.poly.vars() == [v];
        state.atoms.iter().any(alone)
    };
    let shared = |v: usize| {
        let products = state.atoms.iter().flat_map(|a| a.poly.terms());
        products.filter(|(m, _)| m.len() > 1 && m.iter().any(|&(w, n)| w == v && n == 1)).count()
    };
    let mut unsigned: Vec<(usize, usize)> =
        vars.iter().filter(|&&v| !told(v)).map(|&v| (shared(v), v)).collect();
    unsigned.retain(|u| u.0 > 0);
    unsigned.sort_by_key(|&(count, v)| (std::cmp::Reverse(count), v));
    unsigned.iter().take(UNSIGNED).find_map(|&(_, v)| {
        let poly = Poly::var(v);
        let case = |sign, poly: Poly| {
            let next = state.with(Atom::new(poly, sign));
            let proof = tactics::quick(&next).or_else(|| combination(&next));
            proof.or_else(|| pairs(&next, vars)).map(Box::new)
        };
        Some(Argument::Split {
            positive: case(Sign::Positive, poly.clone())?,
            negative: case(Sign::Positive, poly.neg())?,
            zero: case(Sign::Zero, poly.clone())?,
            poly,
        })
    })
}
