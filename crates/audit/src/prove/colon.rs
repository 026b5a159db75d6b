//! Ideals of equations divided by what does not vanish: if f·g is in the ideal of e₁ and e₂ and f is not 0, then g = 0.
//! From s² = c and y² = c, with s + y not 0, follows s = y. And from s² = y² where neither is negative, without more.

use kane_algebra::quotient::exact_quotient;
use kane_kernel::{Atom, Monomial, Poly, Power, Sign, State, Term};
use num_bigint::BigInt;
use num_traits::{One as _, Signed as _};

use super::conics;
use super::conjugates::known;
use super::elimination::Factors;
use super::settled::Settled;
use crate::argument::{Argument, Rules as _};

/// Terms of an equation that is combined.
const TERMS: usize = 24;
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

/// An equation that is new, from one that says that two monomials have equal squares, neither of which is negative.
pub(super) fn rooted(state: &State<'_, '_>) -> Option<Settled> {
    (0..state.atoms.len()).find_map(|i| {
        let atom = &state.atoms[i];
        if atom.sign != Sign::Zero || atom.poly.len() != 2 {
            return None;
        }
        let mut terms = atom.poly.terms();
        let (one, other) = (terms.next()?, terms.next()?);
        let negated = |(m, c): (&[Power], &BigInt)| (m.to_vec(), -c);
        let (m, c) = root((one.0.to_vec(), one.1.clone())).or_else(|| root(negated(one)))?;
        let turn = if one.1.is_negative() { 1 } else { -1 };
        let (n, d) = root((other.0.to_vec(), other.1 * turn))?;
        let (first, second) = (known(state, &m)?, known(state, &n)?);
        let poly = Poly::term(m, c.clone()).sub(&Poly::term(n, d.clone()));
        if poly.is_constant() || is_told(state, &poly) || is_told(state, &poly.neg()) {
            return None;
        }
        // (M − N)² + 2·(M − N)·N = M² − N² = 0, and the same with M and N in each other's place
        let fresh = state.atoms.len();
        let argument = |weight: &BigInt, (square, factors): (Monomial, Factors), turn: i32| {
            let term = |weight, square, factors| Term { weight, square, factors };
            let square = Poly::term(square, BigInt::one());
            let mixed = [&factors[..], &[(fresh, 1)]].concat();
            let terms = vec![
                term(BigInt::one(), Poly::one(), vec![(fresh, 2)]),
                term(weight * 2, square, mixed),
            ];
            Argument::Positive { terms, cofactors: vec![(i, Poly::constant(turn.into()))] }
        };
        let positive = argument(&d, second, turn);
        let negative = argument(&c, first, -turn);
        let closes = |poly: Poly, proof: &Argument| {
            state.with(Atom::new(poly, Sign::Positive)).closes(proof).is_ok()
        };
        let sure = closes(poly.clone(), &positive) && closes(poly.neg(), &negative);
        sure.then_some(Settled { poly, sign: Sign::Zero, other: positive, negative })
    })
}

/// Whether a variable is a root, and an equation says that its square is a product of variables.
pub(super) fn is_root_of_product(state: &State<'_, '_>, v: usize) -> bool {
    let root = state.scope.root(v).is_some();
    root && state.atoms.iter().any(|a| {
        a.sign == Sign::Zero
            && a.poly.len() == 2
            && a.poly.vars().len() > 2
            && a.poly.coefficients(v).iter().map(Poly::len).eq([1, 0, 1])
    })
}

/// The root of a term, if it is a square.
fn root((m, c): (Monomial, BigInt)) -> Option<(Monomial, BigInt)> {
    let root = if c.is_negative() { None } else { conics::root(&c) }?;
    let even = m.iter().all(|(_, n)| n % 2 == 0);
    even.then(|| (m.into_iter().map(|(v, n)| (v, n / 2)).collect(), root))
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
fn is_told(state: &State<'_, '_>, p: &Poly) -> bool {
    state.atoms.iter().any(|a| a.sign == Sign::Zero && a.poly == *p)
}
