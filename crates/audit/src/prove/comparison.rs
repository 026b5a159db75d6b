//! What has to be told before conditions with roots can be squared: signs of what stands before roots, before their squares
//! and beside them, roots that may be zero, and which of two terms is the greater.

use kane_kernel::{Atom, Poly, Power, Sign, State, exponent};
use num_bigint::BigInt;
use num_traits::Signed as _;

use super::conjugates::{TERMS, roots, sides};
use super::factors::cannot_vanish;
use super::hints::is_told;
use super::monomial::{are_lesser, is_lesser, sign};
use super::rule::{Rule, is_pure};

/// A polynomial whose sign has to be told first, if no condition tells it.
pub(super) fn telling(state: &State<'_, '_>, rules: &[Rule]) -> Option<Poly> {
    let mut roots: Vec<usize> = roots(state).into_iter().map(|root| root.1).collect();
    roots.extend(rules.iter().filter(|rule| rule.is_root).map(|rule| rule.v));
    led(state)
        .or_else(|| unsigned(state, &roots))
        .or_else(|| vanishing(state, &roots))
        .or_else(|| unordered(state, &roots))
        .or_else(|| mixed(state, &sole(state, rules)))
}

/// What stands before the squares of variables that are not negative, where nothing tells its sign: of each equation that
/// has none before one of them, for it would reduce what is said of another.
pub(super) fn leads(state: &State<'_, '_>) -> Vec<Poly> {
    let mut out = Vec::new();
    for atom in state.atoms.iter().filter(|a| a.sign == Sign::Zero && a.decided().is_none()) {
        let p = &atom.poly;
        let is_used = |v| short(state).any(|q| q.terms().any(|(m, _)| exponent(m, v) % 2 == 1));
        let is_root = |v: &usize| is_pure(p, *v) && sign(state, *v).is_some() && is_used(*v);
        let roots = p.vars().into_iter().rev().filter(is_root);
        let leads: Vec<Poly> = roots.map(|v| p.coefficient(v, 2).primitive().1).collect();
        if leads.iter().all(|lead| !lead.is_constant() && !is_told(state, lead)) {
            out.extend(leads);
        }
    }
    out
}

/// One of those that cannot vanish, or have terms of one sign.
fn led(state: &State<'_, '_>) -> Option<Poly> {
    let is_signed = |lead: &Poly| are_lesser(state, lead).is_some();
    leads(state).into_iter().find(|lead| is_signed(lead) || cannot_vanish(state, lead))
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

/// Variables that an equation says to be the root of the rest of it; in s² + t² = 1 neither is.
fn sole(state: &State<'_, '_>, rules: &[Rule]) -> Vec<usize> {
    let mut of = roots(state);
    of.retain(|&(i, v)| {
        let p = &state.atoms[i].poly;
        let square = |w: usize| {
            is_pure(p, w).then(|| p.coefficient(w, 2).as_constant().map(|c| c.is_positive()))?
        };
        let own = square(v);
        own.is_some() && p.vars().into_iter().all(|w| w == v || square(w) != own)
    });
    let led = rules.iter().filter(|rule| rule.is_root).map(|rule| rule.v);
    of.into_iter().map(|root| root.1).chain(led).collect()
}

/// What stands in several variables beside a product of roots of which the sign is known, where nothing tells its own: only
/// where it is of one sign can both be squared.
fn mixed(state: &State<'_, '_>, roots: &[usize]) -> Option<Poly> {
    short(state).find_map(|p| {
        let (with, without): (Vec<_>, Vec<_>) =
            p.terms().partition(|(m, _)| !odd_roots(m, roots).is_empty());
        let kinds: Vec<_> =
            with.iter().map(|t| (odd_roots(t.0, roots), is_lesser(state, *t))).collect();
        if !kinds.windows(2).all(|pair| pair[0] == pair[1]) || kinds.first()?.1.is_none() {
            return None;
        }
        let beside = Poly::sum(without.iter().map(|(m, c)| (m.to_vec(), (*c).clone())));
        let beside = beside.primitive().1;
        let is_mixed = are_lesser(state, &beside).is_none();
        (beside.vars().len() > 1 && is_mixed && !is_told(state, &beside)).then_some(beside)
    })
}
