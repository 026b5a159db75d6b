//! Multiples of m = ±1 for a monomial m, as x·tⁿ = 1 along a germ to infinity: by m^2 = 1, m^4 = 1, …, so that the
//! cofactors of a polynomial of n terms have n·log n, and not n².

use std::collections::BTreeMap;

use kane_kernel::{Atom, Monomial, Poly, Power, Sign, State, Term, exponent};
use num_bigint::BigInt;
use num_traits::{One as _, Signed as _, Zero as _};

use crate::argument::{Argument, Rules as _};

/// Terms from which on a polynomial is long.
const LONG: usize = 200;

/// A long polynomial that is said to be positive, and is a multiple of such an equation.
pub(super) fn multiple(state: &State<'_, '_>, fresh: &[bool]) -> Option<Argument> {
    let long = |i: &usize| {
        let a = &state.atoms[*i];
        fresh[*i] && a.sign == Sign::Positive && is_long(&a.poly)
    };
    let equations: Vec<(usize, Unit)> =
        (0..state.atoms.len()).filter_map(|i| Some((i, Unit::of(&state.atoms[i])?))).collect();
    (0..state.atoms.len()).filter(long).find_map(|i| {
        equations.iter().find_map(|(equation, unit)| unit.closed(state, i, *equation))
    })
}

/// Whether a polynomial has so many terms that its products are not formed.
pub(super) fn is_long(p: &Poly) -> bool {
    p.len() > LONG
}

/// m = 1 or m = −1.
struct Unit {
    m: Monomial,
    is_one: bool,
    /// what the equation has before m, 1 or −1
    sign: BigInt,
}

impl Unit {
    fn of(atom: &Atom) -> Option<Self> {
        let mut terms = atom.poly.terms();
        let (Some((m, c)), Some((p, d)), None) = (terms.next(), terms.next(), terms.next()) else {
            return None;
        };
        let (m, c, d) = if m.is_empty() { (p, d, c) } else { (m, c, d) };
        let is_free = m.is_empty() || !(m == p || p.is_empty());
        let is_unit = atom.sign == Sign::Zero && !is_free && c.abs().is_one() && d.abs().is_one();
        is_unit.then(|| Self { m: m.to_vec(), is_one: c != d, sign: c.clone() })
    }

    /// The power of m in a monomial, and what is left of it.
    fn split(&self, monomial: &[Power]) -> (u32, Monomial) {
        let power = |&(v, e): &Power| exponent(monomial, v) / e;
        let k = self.m.iter().map(power).min().unwrap_or(0);
        let rest = |&(v, e): &Power| (v, e - k * exponent(&self.m, v));
        (k, monomial.iter().map(rest).filter(|p| p.1 > 0).collect())
    }

    fn power(&self, k: u32) -> Monomial {
        self.m.iter().map(|&(v, e)| (v, e * k)).collect()
    }

    /// The argument that an atom, said to be positive, is a multiple of the equation.
    fn closed(&self, state: &State<'_, '_>, atom: usize, equation: usize) -> Option<Argument> {
        let mut parts: Vec<(u32, Monomial, BigInt)> = Vec::new();
        let mut sum: BTreeMap<Monomial, BigInt> = BTreeMap::new();
        for (monomial, c) in state.atoms[atom].poly.terms() {
            let (k, rest) = self.split(monomial);
            let signed = if self.is_one || k % 2 == 0 { c.clone() } else { -c };
            *sum.entry(rest.clone()).or_default() += signed;
            parts.push((k, rest, c.clone()));
        }
        if sum.values().any(|c| !c.is_zero()) {
            return None;
        }
        // m^(2^j) = 1 for each j, and the first as it is given
        let steps = parts.iter().map(|p| p.0).max()?.checked_ilog2()?;
        let known = state.atoms.len();
        let index = |j: u32| if j == 0 { equation } else { known + j as usize - 1 };
        let along = |j: u32, p: Poly| if j == 0 { p.scale(&self.sign) } else { p };
        let mut cofactors: Vec<(usize, Poly)> = Vec::new();
        for j in (0..=steps).rev() {
            let mut moved: Vec<(Monomial, BigInt)> = Vec::new();
            for (k, rest, c) in parts.iter_mut().filter(|p| p.0 >= 1 << j) {
                // m^k = (m^(2^j) ∓ 1)·m^(k − 2^j) ± m^(k − 2^j)
                *k -= 1 << j;
                moved.push(([self.power(*k), rest.clone()].concat(), -&*c));
                if j == 0 && !self.is_one {
                    *c = -&*c;
                }
            }
            cofactors.push((index(j), along(j, Poly::sum(moved))));
        }
        let term =
            |atom| Term { weight: BigInt::one(), square: Poly::one(), factors: vec![(atom, 1)] };
        let end = Argument::Positive { terms: vec![term(atom)], cofactors };
        let double = |then: Argument, j: u32| {
            // m^(2^(j + 1)) − 1 = (m^(2^j) ∓ 1)·(m^(2^j) ± 1)
            let power = |j: u32| Poly::term(self.power(1 << j), BigInt::one());
            let is_one = j > 0 || self.is_one;
            let other = power(j).add(&if is_one { Poly::one() } else { Poly::one().neg() });
            let closed = |by: Poly| {
                let cofactors = vec![(index(j), along(j, by))];
                Box::new(Argument::Positive { terms: vec![term(index(j + 1))], cofactors })
            };
            Argument::Split {
                poly: power(j + 1).sub(&Poly::one()),
                zero: Box::new(then),
                positive: closed(other.neg()),
                negative: closed(other),
            }
        };
        let argument = (0..steps).rev().fold(end, double);
        state.closes(&argument).is_ok().then_some(argument)
    }
}
