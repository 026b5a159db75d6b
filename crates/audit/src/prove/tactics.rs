//! Ways to close a state without branching: conflicts, signs, sign tables, products, ideals.
//!
//! A tactic only proposes; the kernel's own rules say whether the proposal closes the state.

use std::cell::OnceCell;

use kane_algebra::division::division;
use kane_algebra::point::specialised;
use kane_algebra::quotient::exact_quotient;
use kane_algebra::ring::common_sign;
use kane_kernel::{Atom, Monomial, Poly, Sign, State, Term};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::{line, reciprocal};
use crate::argument::{Argument, Rules};

type Q = BigRational;
/// A state that is visibly contradictory: false constants, atoms against each other, wrong signs.
pub(crate) fn quick(state: &State<'_, '_>) -> Option<Argument> {
    quick_among(state, &vec![true; state.atoms.len()])
}

/// The same, if only these atoms are new.
pub(crate) fn quick_among(state: &State<'_, '_>, fresh: &[bool]) -> Option<Argument> {
    if let Some(i) = state.atoms.iter().position(|a| a.decided() == Some(false)) {
        return Some(Argument::Absurd(i));
    }
    let undecided = |i: &usize| fresh[*i] && state.atoms[*i].decided().is_none();
    conflict(state, fresh)
        .or_else(|| reciprocal::multiple(state, fresh))
        .or_else(|| multiple_of_equation(state, fresh))
        .or_else(|| {
            (0..state.atoms.len()).rev().filter(undecided).find_map(|i| wrong_sign(state, i))
        })
}

/// Two or three atoms about the same polynomial that cannot all hold.
fn conflict(state: &State<'_, '_>, fresh: &[bool]) -> Option<Argument> {
    let cells = vec![OnceCell::new(); state.atoms.len()];
    let keyed = |i: usize| -> &(Poly, bool, BigInt, Sign) {
        cells[i].get_or_init(|| {
            let a = &state.atoms[i];
            let (content, p) = a.poly.primitive();
            let negative = p.terms().next().is_some_and(|(_, c)| c.is_negative());
            (if negative { p.neg() } else { p }, negative, content, a.sign)
        })
    };
    let factor = |i: usize, n: u32| (i, n);
    for (j, atom) in state.atoms.iter().enumerate() {
        if atom.poly.is_constant() {
            continue;
        }
        for (i, other) in state.atoms[..j].iter().enumerate() {
            if !(fresh[i] || fresh[j]) || other.poly.len() != atom.poly.len() {
                continue;
            }
            let (a, b) = (keyed(i), keyed(j));
            if a.0 != b.0 {
                continue;
            }
            let one = Poly::one();
            let term = |weight: &BigInt, factors| Term {
                weight: weight.clone(),
                square: one.clone(),
                factors,
            };
            let proof = match (a.3, b.3) {
                (Sign::Zero, Sign::Positive | Sign::NonZero) => cancel_to_constant(state, i, j),
                (Sign::Positive | Sign::NonZero, Sign::Zero) => cancel_to_constant(state, j, i),
                (x, y) if x.is_order() && y.is_order() && a.1 != b.1 => {
                    let opposed =
                        vec![term(&b.2, vec![factor(i, 1)]), term(&a.2, vec![factor(j, 1)])];
                    if x == Sign::Positive || y == Sign::Positive {
                        Some(Argument::Positive { terms: opposed, cofactors: Vec::new() })
                    } else {
                        // ≥ and ≤ leave only 0, which a third atom may exclude.
                        let excludes =
                            |&k: &usize| keyed(k).0 == b.0 && keyed(k).3 == Sign::NonZero;
                        let third = (0..state.atoms.len()).find(excludes);
                        third.map(|k| Argument::Positive {
                            terms: vec![
                                term(
                                    &(&keyed(k).2 * &keyed(k).2),
                                    vec![factor(i, 1), factor(j, 1)],
                                ),
                                term(&(&a.2 * &b.2), vec![factor(k, 2)]),
                            ],
                            cofactors: Vec::new(),
                        })
                    }
                }
                _ => None,
            };
            if proof.is_some() {
                return proof;
            }
        }
    }
    None
}

/// An atom that must not vanish but is a multiple of an equation.
fn multiple_of_equation(state: &State<'_, '_>, fresh: &[bool]) -> Option<Argument> {
    for (j, eq) in state.atoms.iter().enumerate() {
        if eq.sign != Sign::Zero || eq.poly.is_constant() {
            continue;
        }
        for (i, a) in state.atoms.iter().enumerate() {
            if !(fresh[i] || fresh[j])
                || !matches!(a.sign, Sign::Positive | Sign::NonZero)
                || a.poly.is_constant()
                || reciprocal::is_long(&a.poly)
            {
                continue;
            }
            let Some(q) = exact_quotient(&a.poly, &eq.poly, &state.scope.fuel) else {
                continue;
            };
            // a·den = q·eq·num for positive integers num, den.
            let product = q.mul(&eq.poly, &state.scope.fuel).ok()?;
            let (_, top) = a.poly.terms().next()?;
            let (_, low) = product.terms().next()?;
            let ratio = Q::new(top.clone(), low.clone());
            let power = if a.sign == Sign::Positive { 1 } else { 2 };
            let mut cofactor = q.scale(&-ratio.numer());
            if power == 2 {
                cofactor = cofactor.mul(&a.poly, &state.scope.fuel).ok()?;
            }
            let weight = ratio.denom().clone();
            let term = Term { weight, square: Poly::one(), factors: vec![(i, power)] };
            let proof = Argument::Positive { terms: vec![term], cofactors: vec![(j, cofactor)] };
            if state.closes(&proof).is_ok() {
                return Some(proof);
            }
        }
    }
    None
}

/// Equation i divided by the non-vanishing atom j that it is a multiple of.
fn cancel_to_constant(state: &State<'_, '_>, i: usize, j: usize) -> Option<Argument> {
    let quotient = exact_quotient(&state.atoms[i].poly, &state.atoms[j].poly, &state.scope.fuel)?;
    let then = Box::new(Argument::Absurd(i));
    let proof = Argument::Cancel { atom: i, factors: vec![(j, 1)], quotient, then };
    state.closes(&proof).is_ok().then_some(proof)
}

/// Atom i contradicts the bounds of its variables, seen from the signs of coefficients.
pub(crate) fn wrong_sign(state: &State<'_, '_>, i: usize) -> Option<Argument> {
    let atom = &state.atoms[i];
    if atom.sign == Sign::NonZero || atom.poly.len() > 3000 {
        return None;
    }
    let vars = atom.poly.vars();
    let bounds: Vec<_> = vars.iter().map(|&v| (v, line::bounds(state, v))).collect();
    if bounds.iter().all(|(_, b)| b.0.is_some() || b.1.is_some()) {
        let mut bounds: Vec<_> = bounds.iter().map(|&(v, (l, u))| (v, l, u)).collect();
        // The bound itself says nothing about itself.
        for b in &mut bounds {
            if b.1 == Some(i) {
                b.1 = None;
            }
            if b.2 == Some(i) {
                b.2 = None;
            }
        }
        if let Some(proof) = one_sign_above_zero(state, i, &bounds) {
            return Some(proof);
        }
        if bounds.iter().all(|b| b.1.is_some() || b.2.is_some()) {
            let may_fit = !mixed_at_ends(state, atom, &bounds);
            let proof = Argument::Orthant { atom: i, bounds };
            if may_fit && state.closes(&proof).is_ok() {
                return Some(proof);
            }
        }
    }
    even_powers(state, i)
}

/// Atom i contradicts that its variables are not below 0, where all coefficients have one sign as they are:
/// then no upper bound is needed, and nothing is mapped, which takes long in high degrees.
fn one_sign_above_zero(
    state: &State<'_, '_>,
    i: usize,
    bounds: &[(usize, Option<usize>, Option<usize>)],
) -> Option<Argument> {
    let from_zero = |&(v, l, _): &(usize, Option<usize>, Option<usize>)| {
        l.filter(|&l| line::bound_value(state, l, v).is_zero()).map(|l| (v, Some(l), None))
    };
    common_sign(&state.atoms[i].poly)?;
    let bounds = bounds.iter().map(from_zero).collect::<Option<Vec<_>>>()?;
    let proof = Argument::Orthant { atom: i, bounds };
    state.closes(&proof).is_ok().then_some(proof)
}

/// Whether coefficients already have another sign where all variables with two ends are at their lower or
/// at their upper ones: a look that saves mapping the whole polynomial.
fn mixed_at_ends(
    state: &State<'_, '_>,
    atom: &Atom,
    bounds: &[(usize, Option<usize>, Option<usize>)],
) -> bool {
    let (mut lower, mut upper) = (Vec::new(), Vec::new());
    for &(v, l, u) in bounds {
        match (l, u) {
            (Some(l), Some(u)) => {
                lower.push((v, line::bound_value(state, l, v)));
                upper.push((v, line::bound_value(state, u, v)));
            }
            (Some(l), None) if line::bound_value(state, l, v).is_zero() => {}
            _ => return false,
        }
    }
    let ends = [specialised(&atom.poly, &lower), specialised(&atom.poly, &upper)];
    let some =
        |positive: bool| ends.iter().any(|p| p.terms().any(|(_, c)| c.is_positive() == positive));
    if atom.sign == Sign::Zero { some(true) && some(false) } else { some(true) }
}

/// Atom i is a sum of monomials of the wrong sign: even powers, and variables bounded by zero.
fn even_powers(state: &State<'_, '_>, i: usize) -> Option<Argument> {
    let atom = &state.atoms[i];
    let half_line = |v: usize| {
        state.atoms.iter().enumerate().find_map(|(j, a)| {
            let (m, c) = a.poly.terms().next()?;
            let alone = a.poly.len() == 1 && m[..] == [(v, 1)] && a.sign.is_order() && j != i;
            alone.then(|| (j, c.clone(), a.sign == Sign::Positive))
        })
    };
    let signs: &[i8] = if atom.sign == Sign::Zero { &[1, -1] } else { &[-1] };
    for &sign in signs {
        // atom·(−sign) + Σ terms = 0 with every term ≥ 0.
        let mut terms = Vec::new();
        let mut fits = true;
        let mut scale = BigInt::one();
        for (m, c) in atom.poly.terms() {
            let mut weight = if sign > 0 { c.clone() } else { -c };
            let (mut square, mut factors): (Monomial, Vec<(usize, u32)>) = (Vec::new(), Vec::new());
            for &(v, n) in m {
                let known = half_line(v);
                match known {
                    // Strict bounds keep the term visibly positive.
                    Some((j, k, true)) if k.is_one() => factors.push((j, n)),
                    _ if n % 2 == 0 => square.push((v, n / 2)),
                    Some((j, k, _)) if k.abs().is_one() => {
                        if k.is_negative() {
                            weight = -weight;
                        }
                        factors.push((j, 1));
                        if n > 1 {
                            square.push((v, n / 2));
                        }
                    }
                    _ => fits = false,
                }
            }
            fits = fits && weight.is_positive();
            if !fits {
                break;
            }
            terms.push(Term { weight, square: Poly::term(square, BigInt::one()), factors });
        }
        if !fits {
            continue;
        }
        let proof = if atom.sign == Sign::Zero {
            let cofactor = Poly::constant(if sign > 0 { -&scale } else { scale.clone() });
            Argument::Positive { terms, cofactors: vec![(i, cofactor)] }
        } else {
            scale = BigInt::one();
            terms.push(Term { weight: scale, square: Poly::one(), factors: vec![(i, 1)] });
            Argument::Positive { terms, cofactors: Vec::new() }
        };
        if state.closes(&proof).is_ok() {
            return Some(proof);
        }
    }
    None
}

/// Terms of a quotient, or nobody would follow it.
const QUOTIENT: usize = 200;

/// A target divided by a premise, target = q·h + r with q < 0 and r ≤ 0 visibly: a contradiction.
pub(crate) fn division_by_premise(state: &State<'_, '_>) -> Option<Argument> {
    for (i, target) in state.atoms.iter().enumerate().rev() {
        if !target.sign.is_order() || target.poly.len() < 2 {
            continue;
        }
        for (j, h) in state.atoms.iter().enumerate() {
            if i == j || !h.sign.is_order() || h.poly.len() < 2 {
                continue;
            }
            if let Some(proof) = divided(state, i, j) {
                return Some(proof);
            }
        }
    }
    None
}

fn divided(state: &State<'_, '_>, i: usize, j: usize) -> Option<Argument> {
    let (target, h) = (&state.atoms[i], &state.atoms[j]);
    if target.poly.len() > 80 || h.poly.len() > 16 {
        return None;
    }
    let (q, r, scale) = division(&target.poly, &h.poly, QUOTIENT, &state.scope.fuel)?;
    // Only the part of q that helps; the rest goes back into r.
    let helpful = q.terms().filter(|(_, c)| c.is_negative());
    let helpful = Poly::sum(helpful.map(|(m, c)| (m.to_vec(), c.clone())));
    let surplus = q.sub(&helpful).mul(&h.poly, &state.scope.fuel).ok()?;
    let (q, r) = (helpful, r.add(&surplus));
    if q.is_constant() {
        return None;
    }
    let end = state.atoms.len();
    let refuted = |state: &State<'_, '_>, p: &Poly, sign| {
        let next = state.with(Atom::new(p.clone(), sign));
        wrong_sign(&next, next.atoms.len() - 1).map(Box::new)
    };
    let (zero, positive) = (refuted(state, &q, Sign::Zero)?, refuted(state, &q, Sign::Positive)?);
    let negative = state.with(Atom::new(q.neg(), Sign::Positive));
    // scale·target + (−q)·h + (−r) = 0
    let term =
        |weight: &BigInt, factors| Term { weight: weight.clone(), square: Poly::one(), factors };
    let one = BigInt::one();
    let both = vec![term(&scale, vec![(i, 1)]), term(&one, vec![(end, 1), (j, 1)])];
    let then = if r.is_empty() {
        Argument::Positive { terms: both, cofactors: Vec::new() }
    } else {
        let vanishing = Argument::Positive {
            terms: both.clone(),
            cofactors: vec![(end + 1, Poly::one().neg())],
        };
        let zero = match refuted(&negative, &r, Sign::Zero) {
            Some(proof) => proof,
            None => Box::new(vanishing),
        };
        let terms = [&both[..], &[term(&one, vec![(end + 1, 1)])]].concat();
        Argument::Split {
            zero,
            positive: refuted(&negative, &r, Sign::Positive)?,
            negative: Box::new(Argument::Positive { terms, cofactors: Vec::new() }),
            poly: r,
        }
    };
    let proof = Argument::Split { poly: q, zero, positive, negative: Box::new(then) };
    state.closes(&proof).is_ok().then_some(proof)
}
