//! Tangent planes. Where both sides of an inequality agree at a point, each of its roots and quotients is set against its
//! tangent plane there: that it is above (or below), and that what is left with the planes in their places is not
//! negative, are smaller questions. A root that is to be bounded from above is set against the tangent in its radicand,
//! √R ≤ (R + R₀)/(2·√R₀), which always bounds it.

use std::collections::BTreeMap;

use kane_kernel::{Conclusion, Expr, Fraction, Fuel, Link, Monomial, Poly, Rel, Scope, State};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed as _, Zero as _};

use super::hints::expanded;
use super::touching::{Point, Root, Tangents};

type Q = BigRational;

/// Roots and quotients of a claim.
const FEWEST: usize = 2;
const MOST: usize = 4;
/// Numerators and denominators of the value that all symbols have at a point.
const LARGEST: i64 = 6;
/// Values that symbols have at a point where they differ, and so many symbols do.
const VALUES: [(i64, i64); 8] = [(1, 1), (2, 1), (3, 1), (1, 2), (4, 1), (1, 3), (0, 1), (-1, 1)];
const DIFFERENT: u32 = 3;
/// What it costs to look at such a point, in coefficient operations.
const LOOK: u64 = 200;

/// The ways in which a claim can be cut, where its sides agree at a simple point.
pub(super) fn tangents(state: &State<'_, '_>) -> Option<Vec<Tangents>> {
    let Conclusion::Link(Link::Relation(relation)) = &state.goal.conclusion else {
        return None;
    };
    if !matches!(relation.rel, Rel::Le | Rel::Ge) {
        return None;
    }
    let (greater, less) = relation.greater_first();
    let mut parts = Vec::new();
    for (side, sense) in [(greater, true), (less, false)] {
        summands(&expanded(side, &state.goal.context)?, sense, &mut parts);
    }
    let scope = state.scope;
    let fractions: Option<Vec<Fraction>> = parts
        .iter()
        .map(|(e, sense)| {
            let value = fraction(scope, e)?;
            Some(if *sense { value } else { value.neg() })
        })
        .collect();
    let fractions = fractions?;
    let mut vars: Vec<usize> =
        fractions.iter().flat_map(|f| [f.num.vars(), f.den.vars()]).flatten().collect();
    let mut roots: Vec<Root> = Vec::new();
    let mut numbers = Vec::new();
    let mut place = 0;
    while let Some(&v) = vars.get(place) {
        place += 1;
        let Some(Expr::Sqrt(inner)) = scope.root(v) else { continue };
        if roots.iter().any(|r| r.v == v) || numbers.iter().any(|(s, _)| *s == v) {
            continue;
        }
        let radicand = fraction(scope, &expanded(inner, &state.goal.context)?)?;
        if let (Some(n), Some(d)) = (radicand.num.as_constant(), radicand.den.as_constant()) {
            let number = (!d.is_zero()).then(|| Q::new(n, d)).filter(Q::is_positive)?;
            numbers.push((v, number));
            continue;
        }
        vars.extend(radicand.num.vars().into_iter().chain(radicand.den.vars()));
        roots.push(Root { v, radicand });
    }
    let mut symbols: Vec<usize> = vars.into_iter().filter(|v| scope.root(*v).is_none()).collect();
    symbols.sort_unstable();
    symbols.dedup();
    let (summands, rest) = grouped(fractions, &roots, &scope.fuel)?;
    if !(FEWEST..=MOST).contains(&summands.len()) || symbols.len() < 2 {
        return None;
    }
    let point = |at: Vec<Q>| {
        let symbols = symbols.iter().copied().zip(at).collect();
        Point::new(symbols, &numbers, &roots, &scope.fuel)
    };
    let cut = |mut point: Point<'_>| -> Option<Vec<Tangents>> {
        let at_edge = point.meets(state)?;
        let cut = |plane| point.tangents(plane, &summands, &rest, &at_edge);
        let all: Vec<Tangents> = point.planes().filter_map(cut).collect();
        (!all.is_empty()).then_some(all)
    };
    let equal = values().map(|at| vec![at; symbols.len()]);
    let found = equal.filter_map(point).find_map(cut);
    found.or_else(|| {
        let agree =
            |point: &Point<'_>| point.sum(&summands, &rest).is_some_and(|gap| gap.is_zero());
        let paid = |_: &Vec<Q>| scope.fuel.spend(LOOK).is_ok();
        grid(symbols.len()).take_while(paid).filter_map(point).filter(agree).find_map(cut)
    })
}

/// Points of few symbols with simple values, which are not all equal.
fn grid(symbols: usize) -> impl Iterator<Item = Vec<Q>> {
    let n = u32::try_from(symbols).ok().filter(|n| *n <= DIFFERENT);
    let count = n.map_or(0, |n| VALUES.len().pow(n));
    let value = |(n, d): (i64, i64)| Q::new(n.into(), d.into());
    let digit = |index: usize, k: u32| index / VALUES.len().pow(k) % VALUES.len();
    let at = move |index| (0..n.unwrap_or(0)).map(|k| value(VALUES[digit(index, k)])).collect();
    (0..count).map(at).filter(|at: &Vec<Q>| at.iter().any(|q| *q != at[0]))
}

/// Simple numbers, the simplest first.
fn values() -> impl Iterator<Item = Q> {
    (2..=2 * LARGEST).flat_map(|sum| (1..sum).map(move |n| (n, sum - n))).filter_map(|(n, d)| {
        let q = Q::new(n.into(), d.into());
        (n <= LARGEST && d <= LARGEST && *q.denom() == d.into()).then_some(q)
    })
}

/// The summands of a sum, and whether they are added.
fn summands(e: &Expr, sense: bool, out: &mut Vec<(Expr, bool)>) {
    match e {
        Expr::Add(a, b) => [a, b].into_iter().for_each(|part| summands(part, sense, out)),
        Expr::Sub(a, b) => {
            summands(a, sense, out);
            summands(b, !sense, out);
        }
        Expr::Neg(a) => summands(a, !sense, out),
        _ => out.push((e.clone(), sense)),
    }
}

/// What has one value wherever it has any.
fn fraction(scope: &Scope<'_>, e: &Expr) -> Option<Fraction> {
    let mut values = scope.pieces(e).ok()?.into_iter().filter_map(|piece| piece.value);
    let value = values.next()?;
    values.next().is_none().then_some(value)
}

/// Sums with one denominator, or with one product of roots, each; and the sum of what has neither.
fn grouped(
    fractions: Vec<Fraction>,
    roots: &[Root],
    fuel: &Fuel,
) -> Option<(Vec<Fraction>, Fraction)> {
    let mut rest = Fraction::whole(Poly::default());
    let mut quotients: Vec<Fraction> = Vec::new();
    let mut by_roots: BTreeMap<Monomial, Fraction> = BTreeMap::new();
    for f in fractions {
        if !f.den.is_constant() {
            match quotients.iter_mut().find(|known| known.den == f.den) {
                Some(known) => known.num = known.num.add(&f.num),
                None => quotients.push(f),
            }
            continue;
        }
        let mut parts: BTreeMap<Monomial, Vec<(Monomial, BigInt)>> = BTreeMap::new();
        for (m, c) in f.num.terms() {
            let of_roots =
                m.iter().filter(|(v, _)| roots.iter().any(|r| r.v == *v)).copied().collect();
            parts.entry(of_roots).or_default().push((m.to_vec(), c.clone()));
        }
        for (of_roots, terms) in parts {
            let part = Fraction { num: Poly::sum(terms), den: f.den.clone() };
            let sum = if of_roots.is_empty() {
                &mut rest
            } else {
                by_roots.entry(of_roots).or_insert_with(|| Fraction::whole(Poly::default()))
            };
            *sum = sum.add(&part, fuel).ok()?;
        }
    }
    quotients.extend(by_roots.into_values().filter(|f| !f.num.is_empty()));
    Some((quotients, rest))
}
