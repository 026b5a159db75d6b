//! What stands before a root: from s·G > N, where neither s nor N is negative, it follows that G is positive.

use kane_algebra::quotient::exact_quotient;
use kane_kernel::{Monomial, Poly, State, Term};
use num_bigint::BigInt;
use num_traits::One as _;

use super::elimination::Factors;
use super::hints::is_told;
use super::isolated::{reduced, strict};
use super::monomial::{Known, is_lesser, known};
use super::rule::{Rule, odd};
use super::settled::Settled;
use crate::argument::Argument;

/// The sum before the one product of roots of a condition.
pub(super) fn cofactor(state: &State<'_, '_>, rules: &[Rule]) -> Option<Settled> {
    strict(state).find_map(|i| of(state, i, rules))
}

fn of(state: &State<'_, '_>, i: usize, rules: &[Rule]) -> Option<Settled> {
    let p = &state.atoms[i].poly;
    let part = |with_root: bool| {
        let terms = p.terms().filter(|(m, _)| odd(m, rules).is_empty() != with_root);
        Poly::sum(terms.map(|(m, c)| (m.to_vec(), c.clone())))
    };
    let (sum, lesser) = (part(true), part(false).neg());
    let (first, _) = sum.terms().next()?;
    let root: Monomial = odd(first, rules).into_iter().map(|v| (v, 1)).collect();
    let product = Poly::term(root.clone(), BigInt::one());
    let (content, sum) = sum.primitive();
    let poly = exact_quotient(&sum, &product, &state.scope.fuel)?;
    let all_lesser = lesser.terms().all(|term| is_lesser(state, term) == Some(false));
    if poly.len() < 2 || !all_lesser || is_told(state, &reduced(state, &poly)) {
        return None;
    }
    // p + N + s·(−G) = 0, and p + N = 0 where G is zero
    let mut terms: Vec<Term> =
        lesser.terms().map(|(m, c)| Some(Known::of(state, m)?.term(c))).collect::<Option<_>>()?;
    terms.push(Term { weight: BigInt::one(), square: Poly::one(), factors: vec![(i, 1)] });
    let fresh = state.atoms.len();
    let cofactors = vec![(fresh, product.scale(&-&content))];
    let zero = Argument::Positive { terms: terms.clone(), cofactors };
    let (square, factors) = known(state, &root)?;
    let factors: Factors = [&factors[..], &[(fresh, 1)]].concat();
    terms.push(Term { weight: content, square: Poly::term(square, BigInt::one()), factors });
    let negative = Argument::Positive { terms, cofactors: Vec::new() };
    Settled::positive(state, poly, zero, negative)
}
