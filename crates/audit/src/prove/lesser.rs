//! The lesser side of a condition with roots: what is taken away, as far as its sign is known.

use std::collections::BTreeMap;

use kane_algebra::quotient::exact_quotient;
use kane_kernel::{Monomial, Poly, Power, State, Term};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, Zero as _};

use super::monomial::{Known, is_lesser, known};
use super::rule::{Rule, odd};

/// What may stand on the lesser side of a condition, and twice that as terms that are not negative.
pub(super) struct Lesser {
    pub(super) side: Poly,
    pub(super) twice: Vec<Term>,
}

/// Of what is taken away the terms with roots, all, or those without; and what a condition says of either part.
pub(super) fn lesser(state: &State<'_, '_>, p: &Poly, rules: &[Rule]) -> Vec<Lesser> {
    let part = |of: &dyn Fn(&[Power], &BigInt) -> bool| {
        let terms = p.terms().filter(|(m, c)| of(m, c));
        Poly::sum(terms.map(|(m, c)| (m.to_vec(), -c)))
    };
    let taken = |m: &[Power], c: &BigInt| is_lesser(state, (m, c)).unwrap_or(c.is_negative());
    let has_root = |m: &[Power]| !odd(m, rules).is_empty();
    let mut sides = vec![
        part(&|m, c| taken(m, c) && has_root(m)),
        part(&taken),
        part(&|m, c| taken(m, c) && !has_root(m)),
    ];
    sides.dedup();
    let termwise = sides.into_iter().filter_map(|side| {
        let twice = twice(state, &side)?;
        Some(Lesser { side, twice })
    });
    let said = [None, Some(true), Some(false)];
    let said = said.into_iter().map(|rooted| by_parts(state, p, rules, rooted));
    let mut out: Vec<Lesser> = Vec::new();
    for found in termwise.chain(said) {
        if !found.side.is_empty() && out.iter().all(|known| known.side != found.side) {
            out.push(found);
        }
    }
    out
}

/// Of what is taken away the parts that belong to a product of roots, with or without one or both, as far as conditions
/// tell their signs: the coefficient of a root may be 1 − t, of which a condition says that it is not negative.
fn by_parts(state: &State<'_, '_>, p: &Poly, rules: &[Rule], rooted: Option<bool>) -> Lesser {
    let mut parts: BTreeMap<Vec<usize>, Vec<(&[Power], &BigInt)>> = BTreeMap::new();
    for term in p.terms() {
        parts.entry(odd(term.0, rules)).or_default().push(term);
    }
    let mut found = Lesser { side: Poly::default(), twice: Vec::new() };
    for (roots, terms) in
        parts.iter().filter(|(roots, _)| rooted.is_none_or(|r| r != roots.is_empty()))
    {
        let side = Poly::sum(terms.iter().map(|(m, c)| (m.to_vec(), -*c)));
        let said = || said(state, &side, roots).map(|term| vec![term]);
        if let Some(twice) = twice(state, &side).or_else(said) {
            found.side = found.side.add(&side);
            found.twice.extend(twice);
        }
    }
    found
}

/// Twice a polynomial of which each term is known not to be negative.
fn twice(state: &State<'_, '_>, side: &Poly) -> Option<Vec<Term>> {
    let twice = |(m, c): (&[Power], &BigInt)| {
        let is_lesser = is_lesser(state, (m, c))?;
        if is_lesser { None } else { Some(Known::of(state, m)?.term(&(c * 2))) }
    };
    side.terms().map(twice).collect()
}

/// Twice a product of roots and a polynomial, of which a condition says that it is not negative.
fn said(state: &State<'_, '_>, side: &Poly, roots: &[usize]) -> Option<Term> {
    let mut roots: Monomial = roots.iter().map(|&v| (v, 1)).collect();
    roots.sort_unstable();
    let before =
        exact_quotient(side, &Poly::term(roots.clone(), BigInt::one()), &state.scope.fuel)?;
    let (content, before) = before.primitive();
    let (atom, size) = state.atoms.iter().enumerate().find_map(|(k, a)| {
        let (size, poly) = a.poly.primitive();
        (a.sign.is_order() && before.len() > 1 && poly == before).then_some((k, size))
    })?;
    let (_, mut factors) = known(state, &roots)?;
    factors.push((atom, 1));
    factors.sort_unstable();
    let (weight, rest) = (content * BigInt::from(2)).div_rem(&size);
    rest.is_zero().then(|| Term { weight, square: Poly::one(), factors })
}
