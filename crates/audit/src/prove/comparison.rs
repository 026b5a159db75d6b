//! What has to be told before conditions with roots can be squared: signs of what stands before roots, roots that may be
//! zero, and which of two terms is the greater.

use kane_kernel::{Atom, Poly, Power, State};
use num_bigint::BigInt;

use super::conjugates::{TERMS, roots, sides};
use super::hints::is_told;
use super::isolated::Rule;
use super::monomial::{is_lesser, sign};

/// A polynomial whose sign has to be told first, if no condition tells it.
pub(super) fn telling(state: &State<'_, '_>, rules: &[Rule]) -> Option<Poly> {
    let mut roots: Vec<usize> = roots(state).into_iter().map(|root| root.1).collect();
    roots.extend(rules.iter().filter(|rule| rule.is_root).map(|rule| rule.v));
    unsigned(state, &roots)
        .or_else(|| vanishing(state, &roots))
        .or_else(|| unordered(state, &roots))
}

/// Which of the roots have odd powers in a monomial.
fn odd_roots(m: &[Power], roots: &[usize]) -> Vec<usize> {
    m.iter().filter(|(v, n)| n % 2 == 1 && roots.contains(v)).map(|x| x.0).collect()
}

/// Conditions of order with few terms.
fn short<'a>(state: &'a State<'_, '_>) -> impl Iterator<Item = &'a Poly> {
    let short = |a: &&Atom| a.sign.is_order() && a.decided().is_none() && a.poly.len() <= TERMS;
    state.atoms.iter().filter(short).map(|a| &a.poly)
}

/// A variable before a root whose sign nothing tells.
fn unsigned(state: &State<'_, '_>, roots: &[usize]) -> Option<Poly> {
    let mut monomials = short(state).flat_map(|p| p.terms().map(|(m, _)| m));
    monomials.find_map(|m| {
        let odd = odd_roots(m, roots);
        let before = |x: &&Power| !odd.is_empty() && x.1 % 2 == 1 && !odd.contains(&x.0);
        let mut before = m.iter().filter(before).map(|x| x.0);
        before.find(|&v| sign(state, v).is_none()).map(Poly::var)
    })
}

/// A root that may be zero as far as is told, where all terms of a condition stand on its lesser side.
fn vanishing(state: &State<'_, '_>, roots: &[usize]) -> Option<Poly> {
    let lesser = |p: &Poly| p.terms().all(|term| is_lesser(state, term) == Some(true));
    short(state).filter(|p| lesser(p)).find_map(|p| {
        let mut here = roots.iter().filter(|v| p.degree(**v) > 0).map(|v| Poly::var(*v));
        here.find(|root| !is_told(state, root))
    })
}

/// The difference of two terms, each with something before another root, that stand on two sides with other terms beside
/// them: √(1 + y²)·x − √(1 + x²)·y in x + √(1 + y²)·x ≥ y + √(1 + x²)·y.
fn unordered(state: &State<'_, '_>, roots: &[usize]) -> Option<Poly> {
    let with_roots = |p: &Poly| -> Vec<(Vec<usize>, Poly)> {
        let long = p.terms().filter(|(m, _)| m.len() > 1);
        let term =
            |(m, c): (&[Power], &BigInt)| (odd_roots(m, roots), Poly::term(m.to_vec(), c.clone()));
        long.map(term).filter(|(odd, _)| !odd.is_empty()).collect()
    };
    short(state).filter(|p| p.len() > 2).find_map(|p| {
        let (greater, lesser) = sides(state, p)?;
        let (greater, lesser) = (with_roots(&greater), with_roots(&lesser));
        let pairs = greater.iter().flat_map(|p| lesser.iter().map(move |q| (p, q)));
        let mut apart = pairs.filter(|(p, q)| p.0 != q.0).map(|(p, q)| p.1.sub(&q.1).primitive().1);
        apart.find(|difference| !is_told(state, difference))
    })
}
