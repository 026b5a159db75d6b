//! Roots of products and of quotients: where neither side is negative, s = r₁·r₂ from s² = c₁·c₂ and rᵢ² = cᵢ, and
//! s·r₂ = r₁ from s²·c₂ = c₁.

use kane_algebra::quotient::exact_quotient;
use kane_kernel::{Atom, Fuel, Monomial, Poly, Sign, State, Term};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, Zero as _};

use super::colon::{TERMS, is_told};
use super::conics;
use super::elimination::Factors;
use super::monomial::known;
use super::settled::Settled;
use crate::argument::{Argument, Rules as _};

/// Roots whose product is the root of a product.
const FACTORS: usize = 4;

/// A monomial with a coefficient whose square is a polynomial, by what else is added to it.
struct SquareRoot {
    monomial: Monomial,
    coefficient: BigInt,
    /// square − polynomial, as multiples of equations
    beside: Vec<(usize, Poly)>,
}

impl SquareRoot {
    /// Of one term.
    fn of_term((m, c): (Monomial, BigInt)) -> Option<Self> {
        let (monomial, coefficient) = root((m, c))?;
        Some(Self { monomial, coefficient, beside: Vec::new() })
    }

    /// Of a term, or of a product of what equations but this one say to be squares of roots.
    fn of(state: &State<'_, '_>, p: &Poly, equation: usize, factors: usize) -> Option<Self> {
        if let (1, Some((m, c))) = (p.len(), p.terms().next())
            && let Some(root) = Self::of_term((m.to_vec(), c.clone()))
        {
            return Some(root);
        }
        let left = factors.checked_sub(1)?;
        (0..state.atoms.len()).filter(|i| *i != equation).find_map(|i| {
            let (v, square, turn) = radicand(state, i).filter(|(v, ..)| p.degree(*v) == 0)?;
            let quotient = quotient(p, &square, &state.scope.fuel)?;
            // v²·q − p = q·(v² − square)
            let mut root = Self::of(state, &quotient, equation, left)?.times(v, state)?;
            root.beside.push((i, quotient.scale(&turn.into())));
            Some(root)
        })
    }

    /// Times a variable.
    fn times(mut self, v: usize, state: &State<'_, '_>) -> Option<Self> {
        let product = Poly::term(self.monomial, self.coefficient.clone());
        let product = product.mul(&Poly::var(v), &state.scope.fuel).ok()?;
        self.monomial = product.terms().next()?.0.to_vec();
        for (_, cofactor) in &mut self.beside {
            *cofactor = cofactor.mul(&Poly::power(v, 2), &state.scope.fuel).ok()?;
        }
        Some(self)
    }

    fn poly(&self) -> Poly {
        Poly::term(self.monomial.clone(), self.coefficient.clone())
    }
}

/// The quotient of p by d, if it has no remainder and its coefficients are integers.
fn quotient(p: &Poly, d: &Poly, fuel: &Fuel) -> Option<Poly> {
    let quotient = exact_quotient(p, d, fuel)?;
    let product = quotient.mul(d, fuel).ok()?;
    let (lead, found) = (p.terms().next()?.1, product.terms().next()?.1);
    let (ratio, rest) = lead.div_rem(found);
    rest.is_zero().then(|| quotient.scale(&ratio))
}

/// A root, what an equation says to be its square, and the factor that makes it root² − square.
fn radicand(state: &State<'_, '_>, i: usize) -> Option<(usize, Poly, i32)> {
    let atom = &state.atoms[i];
    if atom.sign != Sign::Zero || atom.poly.len() > TERMS {
        return None;
    }
    let is_square = |v: &usize| state.scope.root(*v).is_some() && atom.poly.degree(*v) == 2;
    let mut roots = atom.poly.vars().into_iter().rev().filter(is_square);
    roots.find_map(|v| {
        let [rest, linear, lead] = &atom.poly.coefficients(v)[..] else { return None };
        let lead = lead.as_constant().filter(|c| c.magnitude().is_one())?;
        let turn = if lead.is_negative() { -1 } else { 1 };
        let square = rest.scale(&(-turn).into());
        let is_one = square.as_constant().is_some_and(|c| c.magnitude().is_one());
        (linear.is_empty() && !square.is_empty() && !is_one).then_some((v, square, turn))
    })
}

/// An equation that is new, from one that says that two monomials have equal squares, neither of which is negative.
pub(super) fn equal_roots(state: &State<'_, '_>) -> Option<Settled> {
    let is_short =
        |i: &usize| state.atoms[*i].sign == Sign::Zero && state.atoms[*i].poly.len() <= TERMS;
    let mut equations = (0..state.atoms.len()).filter(is_short);
    equations.find_map(|i| {
        let p = &state.atoms[i].poly;
        let found = two_terms(p).and_then(|(m, n, turn)| settled(state, i, (&m, &n), turn));
        found.or_else(|| p.vars().into_iter().find_map(|v| of_quotient(state, i, v)))
    })
}

/// Two monomials of which an equation says that their squares are equal: it is their difference, or its opposite.
fn two_terms(p: &Poly) -> Option<(SquareRoot, SquareRoot, i32)> {
    if p.len() != 2 {
        return None;
    }
    let mut terms = p.terms();
    let (one, other) = (terms.next()?, terms.next()?);
    let turn = if one.1.is_negative() { -1 } else { 1 };
    let m = SquareRoot::of_term((one.0.to_vec(), one.1 * turn))?;
    let n = SquareRoot::of_term((other.0.to_vec(), -other.1 * turn))?;
    Some((m, n, turn))
}

/// From s²·b = a, where a and b are squares: s is the quotient of their roots.
fn of_quotient(state: &State<'_, '_>, i: usize, v: usize) -> Option<Settled> {
    let [rest, linear, lead] = &state.atoms[i].poly.coefficients(v)[..] else { return None };
    if !linear.is_empty() || state.scope.root(v).is_none() {
        return None;
    }
    [1, -1].into_iter().find_map(|turn| {
        let scaled = |p: &Poly| p.scale(&turn.into());
        let m = SquareRoot::of(state, &scaled(lead), i, FACTORS)?.times(v, state)?;
        let n = SquareRoot::of(state, &scaled(rest).neg(), i, FACTORS)?;
        settled(state, i, (&m, &n), turn)
    })
}

/// M = N, where neither is negative and turn times an equation, with what stands beside, is M² − N².
fn settled(
    state: &State<'_, '_>,
    i: usize,
    (m, n): (&SquareRoot, &SquareRoot),
    turn: i32,
) -> Option<Settled> {
    let (first, second) = (known(state, &m.monomial)?, known(state, &n.monomial)?);
    let poly = m.poly().sub(&n.poly());
    if poly.is_constant() || is_told(state, &poly) || is_told(state, &poly.neg()) {
        return None;
    }
    let mut gap = vec![(i, Poly::constant(turn.into()))];
    gap.extend(m.beside.iter().cloned());
    gap.extend(n.beside.iter().map(|(k, c)| (*k, c.neg())));
    let all = gap.iter().map(|(k, _)| k);
    if all.clone().enumerate().any(|(at, k)| all.clone().take(at).any(|l| l == k)) {
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
        let cofactors = gap.iter().map(|(k, c)| (*k, c.scale(&turn.into()))).collect();
        Argument::Positive { terms, cofactors }
    };
    let positive = argument(&n.coefficient, second, -1);
    let negative = argument(&m.coefficient, first, 1);
    let closes = |poly: Poly, proof: &Argument| {
        state.with(Atom::new(poly, Sign::Positive)).closes(proof).is_ok()
    };
    let sure = closes(poly.clone(), &positive) && closes(poly.neg(), &negative);
    sure.then_some(Settled { poly, sign: Sign::Zero, other: positive, negative })
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
