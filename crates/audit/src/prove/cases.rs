//! Elimination by cases: a variable of degree one or two goes by the signs of leading coefficients, of
//! discriminants and of resultants. Told their signs, products of conditions and squares close each
//! case: from a > 0 and b² < 4ac it follows that a·x² + b·x + c > 0, for 4a·(a·x² + b·x + c) is
//! (2a·x + b)² + 4ac − b².

use kane_algebra::ring::{common_sign, content_in};
use kane_kernel::{Atom, Fuel, Poly, Sign, State};

use super::combination::{Multiple, Size, Summand, combined, summand};
use super::elimination::Factors;
use super::tactics;
use crate::argument::Argument;

/// Terms of a polynomial whose sign is asked for, and its total degree.
const TERMS: usize = 24;
const DEGREE: u32 = 6;
/// Conditions in the variable that goes.
const CONDITIONS: usize = 5;

/// Conditions whose products are taken in pairs.
const PAIRED: usize = 14;
/// The linear program for those.
const SIZE: Size = Size { rows: 260, columns: 500, pivots: 300 };

/// A contradiction by products of two conditions, and by the square of what completes a quadratic one
/// times a condition, in any number of variables: what is left to say once signs are told.
pub(super) fn closed(state: &State<'_, '_>, vars: &[usize], fuel: &Fuel) -> Option<Argument> {
    let live = |sign: fn(Sign) -> bool| -> Vec<usize> {
        let all = 0..state.atoms.len();
        all.filter(|&i| sign(state.atoms[i].sign) && state.atoms[i].decided().is_none()).collect()
    };
    let (ordered, equations) = (live(Sign::is_order), live(|s| s == Sign::Zero));
    if ordered.len() > PAIRED {
        return None;
    }
    let mut known: Vec<Factors> = ordered.iter().map(|&i| vec![(i, 1)]).collect();
    for (n, &i) in ordered.iter().enumerate() {
        known.push(vec![(i, 2)]);
        known.extend(ordered[n + 1..].iter().map(|&j| vec![(i, 1), (j, 1)]));
    }
    known.extend(live(|s| s == Sign::NonZero).iter().map(|&i| vec![(i, 2)]));
    let one = Poly::one();
    let mut named: Vec<(Poly, Factors)> = known.into_iter().map(|f| (one.clone(), f)).collect();
    for v in vars {
        for a in conditions(state, *v).filter(|a| a.poly.degree(*v) == 2) {
            let slope = a.poly.derivative(*v, fuel).ok()?.primitive().1;
            if named.iter().all(|(square, _)| *square != slope) {
                named.push((slope.clone(), Vec::new()));
                named.extend(ordered.iter().map(|&i| (slope.clone(), vec![(i, 1)])));
            }
        }
    }
    let mut summands: Vec<Summand> = Vec::new();
    for (square, factors) in named {
        summands.push(summand(state, square, factors)?);
    }
    summands.push(summand(state, one.clone(), Vec::new())?);
    let mut multiples: Vec<Multiple> = Vec::new();
    for &i in &equations {
        let bases = ordered.iter().map(|&j| state.atoms[j].poly.clone());
        for by in
            std::iter::once(one.clone()).chain(vars.iter().map(|v| Poly::var(*v))).chain(bases)
        {
            let multiple = by.mul(&state.atoms[i].poly, fuel).ok()?;
            multiples.push((i, by.clone(), multiple.clone()));
            multiples.push((i, by.neg(), multiple.neg()));
        }
    }
    combined(state, summands, multiples, &SIZE)
}

/// A polynomial in fewer variables whose sign is not told, and tells most about one of them.
pub(super) fn telling(state: &State<'_, '_>, vars: &[usize], fuel: &Fuel) -> Option<Poly> {
    let mut order: Vec<(usize, u32, usize)> = Vec::new();
    for &v in vars {
        let with: Vec<&Atom> = conditions(state, v).collect();
        let top = with.iter().map(|a| a.poly.degree(v)).max().unwrap_or(0);
        if (1..=2).contains(&top) && with.len() <= CONDITIONS {
            order.push((with.len(), top, v));
        }
    }
    order.sort_unstable();
    order.iter().find_map(|&(_, _, v)| {
        let with: Vec<&Poly> = conditions(state, v).map(|a| &a.poly).collect();
        let mut found: Vec<Poly> = Vec::new();
        for p in &with {
            found.extend(p.coefficients(v).pop());
        }
        for p in with.iter().filter(|p| p.degree(v) == 2) {
            found.extend(discriminant(p, v, fuel));
        }
        for (i, p) in with.iter().enumerate() {
            for q in with.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, q)| q) {
                found.extend(at_zero_of(p, q, v, fuel));
            }
        }
        found.into_iter().find_map(|p| untold(state, &p))
    })
}

/// The conditions of order that bind a variable to others.
fn conditions<'a>(state: &'a State<'_, '_>, v: usize) -> impl Iterator<Item = &'a Atom> {
    let live = |a: &&Atom| a.sign != Sign::NonZero && a.decided().is_none();
    state.atoms.iter().filter(live).filter(move |a| a.poly.degree(v) > 0)
}

/// b² − 4ac
fn discriminant(p: &Poly, v: usize, fuel: &Fuel) -> Option<Poly> {
    let [c, b, a] = <[Poly; 3]>::try_from(p.coefficients(v)).ok()?;
    Some(b.mul(&b, fuel).ok()?.sub(&a.mul(&c, fuel).ok()?.scale(&4.into())))
}

/// What p is, up to a square, where a linear q is zero.
fn at_zero_of(p: &Poly, q: &Poly, v: usize, fuel: &Fuel) -> Option<Poly> {
    if q.degree(v) != 1 || p.degree(v) > 2 {
        return None;
    }
    p.remainder(v, q, true, fuel).ok()
}

/// A factor of p whose sign is neither known nor seen at once.
fn untold(state: &State<'_, '_>, p: &Poly) -> Option<Poly> {
    let total = |p: &Poly| p.terms().map(|(m, _)| m.iter().map(|x| x.1).sum::<u32>()).max();
    if p.is_constant() || p.len() > TERMS || total(p).unwrap_or(0) > DEGREE {
        return None;
    }
    let mut parts = vec![p.primitive().1];
    if p.len() == 1 {
        parts = p.vars().into_iter().map(Poly::var).collect();
    } else {
        let contents = p.vars().into_iter().map(|v| content_in(p, v));
        parts.splice(0..0, contents.filter(|c| !c.is_constant()));
    }
    parts.into_iter().find(|p| !is_told(state, p))
}

/// Whether the sign of p, or of its opposite, is known or the conditions show it at once.
fn is_told(state: &State<'_, '_>, p: &Poly) -> bool {
    let same = |q: &Poly| {
        let q = q.primitive().1;
        q == *p || q == p.neg()
    };
    let known = |a: &Atom| a.sign != Sign::NonNegative && a.sign != Sign::NonZero && same(&a.poly);
    let impossible = |p: Poly| {
        let trial = state.with(Atom::new(p, Sign::Positive));
        tactics::wrong_sign(&trial, trial.atoms.len() - 1).is_some()
    };
    state.atoms.iter().any(known)
        || common_sign(p).is_some() && (impossible(p.clone()) || impossible(p.neg()))
}
