//! Ideals of equations divided by what does not vanish: if f·g is in the ideal of e₁ and e₂ and f is not 0, then g = 0.
//! From s² = c and y² = c, with s + y not 0, follows s = y.

use kane_algebra::quotient::exact_quotient;
use kane_kernel::{Atom, Poly, Sign, State, Term};

use super::settled::Settled;
use crate::argument::{Argument, Rules as _};

/// Terms of an equation that is combined.
pub(super) const TERMS: usize = 24;
/// Equations above which none are combined.
const EQUATIONS: usize = 16;

/// An equation that is new, from two equations without the highest power of a variable in which both have the same
/// degree.
pub(super) fn divided(state: &State<'_, '_>) -> Option<Settled> {
    let short = |a: &Atom, sign: &[Sign]| {
        sign.contains(&a.sign) && a.decided().is_none() && a.poly.len() <= TERMS
    };
    let all = |sign: &[Sign]| -> Vec<usize> {
        (0..state.atoms.len()).filter(|&i| short(&state.atoms[i], sign)).collect()
    };
    let equations = all(&[Sign::Zero]);
    let known = all(&[Sign::NonZero, Sign::Positive]);
    if equations.len() > EQUATIONS {
        return None;
    }
    for (n, &i) in equations.iter().enumerate() {
        for &j in &equations[..n] {
            for (difference, cofactors) in differences(state, i, j) {
                let new = known.iter().find_map(|&k| by(state, &difference, &cofactors, k));
                if new.is_some() {
                    return new;
                }
            }
        }
    }
    None
}

/// What two equations leave without the highest power of a variable, and their cofactors in it.
fn differences(state: &State<'_, '_>, i: usize, j: usize) -> Vec<(Poly, [(usize, Poly); 2])> {
    let fuel = &state.scope.fuel;
    let (p, q) = (&state.atoms[i].poly, &state.atoms[j].poly);
    let one = |v: usize| {
        let degree = p.degree(v);
        if degree < 2 || q.degree(v) != degree {
            return None;
        }
        let (a, b) = (p.coefficients(v).pop()?, q.coefficients(v).pop()?.neg());
        let left = p.mul(&b, fuel).ok()?.add(&q.mul(&a, fuel).ok()?);
        (left.len() > 1 && left.len() <= TERMS).then_some((left, [(i, b), (j, a)]))
    };
    p.vars().into_iter().filter_map(one).collect()
}

/// The quotient by a condition that does not vanish, as an equation.
fn by(
    state: &State<'_, '_>,
    difference: &Poly,
    cofactors: &[(usize, Poly)],
    k: usize,
) -> Option<Settled> {
    let fuel = &state.scope.fuel;
    let (content, quotient) = exact_quotient(difference, &state.atoms[k].poly, fuel)?.primitive();
    if quotient.is_constant() || is_told(state, &quotient) || is_told(state, &quotient.neg()) {
        return None;
    }
    // content²·f²·g² − (content·f·g)² = 0, and the latter is in the ideal
    let product = difference.neg();
    let cofactors: Vec<(usize, Poly)> = cofactors
        .iter()
        .map(|(i, c)| Some((*i, c.mul(&product, fuel).ok()?)))
        .collect::<Option<_>>()?;
    let argument = |sign: &Poly| {
        let next = state.with(Atom::new(sign.clone(), Sign::Positive));
        let factors = vec![(k, 2), (next.atoms.len() - 1, 2)];
        let term = Term { weight: &content * &content, square: Poly::one(), factors };
        let argument = Argument::Positive { terms: vec![term], cofactors: cofactors.clone() };
        next.closes(&argument).is_ok().then_some(argument)
    };
    let (positive, negative) = (argument(&quotient)?, argument(&quotient.neg())?);
    Some(Settled { poly: quotient, sign: Sign::Zero, other: positive, negative })
}

/// Whether an equation is known.
pub(super) fn is_told(state: &State<'_, '_>, p: &Poly) -> bool {
    state.atoms.iter().any(|a| a.sign == Sign::Zero && a.poly == *p)
}
