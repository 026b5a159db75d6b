//! The sign of a monomial, where conditions tell those of its variables.

use kane_kernel::{Atom, Monomial, Poly, Power, State, Term};
use num_bigint::BigInt;
use num_traits::{One as _, Signed as _};

use super::elimination::Factors;

/// A monomial, or its opposite, as a square times conditions.
pub(super) struct Known {
    pub(super) square: Monomial,
    pub(super) factors: Factors,
    /// whether it is the opposite
    pub(super) is_opposite: bool,
}

impl Known {
    /// The variables with odd powers are known not to be negative, or not to be positive.
    pub(super) fn of(state: &State<'_, '_>, m: &[Power]) -> Option<Self> {
        let (mut square, mut factors) = (Monomial::new(), Factors::new());
        let mut is_opposite = false;
        for &(v, n) in m {
            if n > 1 {
                square.push((v, n / 2));
            }
            if n % 2 == 1 {
                let (atom, is_negative) = sign(state, v)?;
                factors.push((atom, 1));
                is_opposite ^= is_negative;
            }
        }
        factors.sort_unstable();
        Some(Self { square, factors, is_opposite })
    }

    /// c times the monomial, which is not to be negative.
    pub(super) fn term(self, c: &BigInt) -> Term {
        let weight = if self.is_opposite { -c } else { c.clone() };
        Term { weight, square: Poly::term(self.square, BigInt::one()), factors: self.factors }
    }
}

/// A condition that says that v is not negative, or that it is not positive, and which of the two.
pub(super) fn sign(state: &State<'_, '_>, v: usize) -> Option<(usize, bool)> {
    let (up, down) = (Poly::var(v), Poly::var(v).neg());
    let tells = |a: &Atom| a.sign.is_order() && (a.poly == up || a.poly == down);
    let atom = state.atoms.iter().position(tells)?;
    Some((atom, state.atoms[atom].poly == down))
}

/// A monomial as a square times conditions, if it is not negative.
pub(super) fn known(state: &State<'_, '_>, m: &[Power]) -> Option<(Monomial, Factors)> {
    let known = Known::of(state, m)?;
    (!known.is_opposite).then_some((known.square, known.factors))
}

/// Whether a term is known not to be positive; `None` if nothing is known of its sign.
pub(super) fn is_lesser(state: &State<'_, '_>, (m, c): (&[Power], &BigInt)) -> Option<bool> {
    Some(Known::of(state, m)?.is_opposite != c.is_negative())
}

/// Whether all terms of a polynomial are known not to be positive, or all not to be negative; `None` if neither is known.
pub(super) fn are_lesser(state: &State<'_, '_>, p: &Poly) -> Option<bool> {
    let mut signs = p.terms().map(|term| is_lesser(state, term));
    let first = signs.next()??;
    signs.all(|sign| sign == Some(first)).then_some(first)
}
