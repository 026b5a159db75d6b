//! Lower bounds of what is not negative by those of its square: from v² ≥ m² it follows that v ≥ m.

use kane_kernel::{Atom, Poly, Sign, State, Term};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, Zero as _};

use super::conics::root;
use super::settled::NotNegative;
use crate::argument::Argument;

/// A bound that no condition says as it stands, of what an equation has as a square beside other squares.
pub(super) fn bound(state: &State<'_, '_>) -> Option<NotNegative> {
    (0..state.atoms.len()).find_map(|i| of(state, i))
}

fn of(state: &State<'_, '_>, i: usize) -> Option<NotNegative> {
    let atom = &state.atoms[i];
    let [v] = atom.poly.vars()[..] else { return None };
    let [c, b, a] = <[BigInt; 3]>::try_from(atom.poly.univariate(v)?).ok()?;
    if !atom.sign.is_order() || !b.is_zero() || !a.is_positive() || !c.is_negative() {
        return None;
    }
    // atom = common·(q²·v² − p²) for the bound p/q
    let common = a.gcd(&c);
    let (p, q) = (root(&(-c / &common))?, root(&(a / &common))?);
    let not_negative =
        state.atoms.iter().position(|b| b.poly == Poly::var(v) && b.sign.is_order())?;
    let poly = Poly::in_variable(v, &[-&p, q.clone()]);
    let is_replaced =
        |e: &Atom| e.sign == Sign::Zero && e.poly.degree(v) == 2 && e.poly.vars().len() > 1;
    if !state.atoms.iter().any(is_replaced) {
        return None;
    }
    // nor in the case in which it is reached
    let says = |b: &Atom| b.poly == poly || b.sign == Sign::Zero && b.poly == poly.neg();
    let is_told = state.atoms.iter().any(|b| b.sign != Sign::NonZero && says(b));
    if is_told {
        return None;
    }
    let fresh = state.atoms.len();
    let one = BigInt::one;
    let term = |weight, factors| Term { weight, square: Poly::one(), factors };
    // atom + common·(q·v + p)·(what is negative) = 0
    let negative = Argument::Positive {
        terms: vec![
            term(one(), vec![(i, 1)]),
            term(&common * &q, vec![(not_negative, 1), (fresh, 1)]),
            term(&common * &p, vec![(fresh, 1)]),
        ],
        cofactors: Vec::new(),
    };
    let cofactor = Poly::in_variable(v, &[-(&common * &p), -(&common * &q)]);
    let zero = Argument::Positive {
        terms: vec![term(one(), vec![(i, 1)])],
        cofactors: vec![(fresh, cofactor)],
    };
    let zero = (atom.sign == Sign::Positive).then_some(zero);
    NotNegative::new(state, poly, zero, negative)
}
