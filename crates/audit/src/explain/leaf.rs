//! The last step of a branch: why what is known there cannot all hold.

use kane_algebra::quotient::exact_quotient;
use kane_kernel::{Atom, Finding, Fuel, Goal, Poly, Sign, State, Term};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _};

use super::{At, FUEL, Source, Step, Summand, sides, witness};
use crate::argument::{Argument, bounded_sum};

/// The step; nothing for an argument that goes on.
pub(super) fn step(
    goal: &Goal,
    finding: Finding,
    at: &At<'_, '_>,
    argument: &Argument,
) -> Option<Step> {
    let state = &at.state;
    let atom = |i: usize| state.atoms.get(i).cloned();
    match argument {
        Argument::Absurd(i) => {
            let absurd = atom(*i)?;
            let is_claim = at.origins.get(*i) == Some(&Some(Source::Failure));
            let equal = absurd.sign == Sign::NonZero && is_claim;
            let sides = equal.then(|| sides::equal(goal, finding, at)).flatten();
            Some(sides.unwrap_or(Step::Absurd(absurd)))
        }
        Argument::Cancel { atom: i, factors, .. } => {
            let factors = factors.iter().map(|(i, n)| Some((atom(*i)?, *n)));
            Some(Step::Factors { atom: atom(*i)?, factors: factors.collect::<Option<_>>()? })
        }
        Argument::Positive { terms, cofactors } => {
            let short = clash(state, terms, cofactors);
            let short = short.or_else(|| multiple(state, terms, cofactors));
            short.or_else(|| positive(state, terms, cofactors))
        }
        Argument::Orthant { atom: i, bounds } => {
            let used = bounds.iter().flat_map(|(_, l, u)| [*l, *u]).flatten();
            let used: Vec<usize> = used.collect();
            let all = used.iter().map(|i| atom(*i)).collect::<Option<Vec<_>>>()?;
            let is_plain = all.iter().all(|bound| is_variable(&bound.poly));
            let sum = (!is_plain).then(|| bounded_sum(state, *i, bounds)).flatten();
            let told = used.iter().filter(|i| **i >= at.ranges).map(|i| atom(*i));
            let bounds = told.collect::<Option<Vec<_>>>()?;
            let ranges = bounds.len() < used.len();
            Some(Step::SignsOfCoefficients { atom: atom(*i)?, bounds, ranges, sum })
        }
        Argument::SignTable { var, roots, atoms, .. } => {
            let atoms = atoms.iter().map(|(i, ..)| atom(*i)).collect::<Option<_>>()?;
            let cuts = roots.iter().map(witness::shown).collect();
            Some(Step::SignTable { variable: *var, cuts, atoms })
        }
        Argument::Assume { .. } | Argument::Split { .. } | Argument::Substitute { .. } => None,
    }
}

/// Whether a polynomial is a positive multiple of a variable.
fn is_variable(p: &Poly) -> bool {
    matches!(p.vars()[..], [v] if p.primitive().1 == Poly::var(v))
}

/// All that is used speaks of one polynomial.
fn clash(state: &State<'_, '_>, terms: &[Term], cofactors: &[(usize, Poly)]) -> Option<Step> {
    let used = terms.iter().flat_map(|t| &t.factors).map(|f| f.0);
    let mut used: Vec<usize> = used.chain(cofactors.iter().map(|c| c.0)).collect();
    used.sort_unstable();
    used.dedup();
    let atoms = used.iter().map(|i| state.atoms.get(*i).cloned()).collect::<Option<Vec<_>>>()?;
    let base = atoms.first()?.poly.primitive().1;
    let same = |atom: &Atom| {
        let p = atom.poly.primitive().1;
        p == base || p == base.neg()
    };
    (atoms.len() > 1 && atoms.iter().all(same)).then_some(Step::Clash(atoms))
}

/// w·P² = −Σ cofactor·equation with P in every cofactor: w·P is a sum of multiples of the equations.
fn multiple(state: &State<'_, '_>, terms: &[Term], cofactors: &[(usize, Poly)]) -> Option<Step> {
    let [Term { weight, square, factors }] = terms else { return None };
    let [(i, 2)] = factors[..] else { return None };
    if square.as_constant()?.abs() != BigInt::one() || cofactors.is_empty() {
        return None;
    }
    let p = &state.atoms.get(i)?.poly;
    let mut scaled: Vec<(BigRational, Poly, Poly)> = Vec::new();
    for (j, cofactor) in cofactors {
        let quotient = exact_quotient(cofactor, p, &Fuel::new(FUEL).within(FUEL))?;
        let fuel = Fuel::new(FUEL);
        let product = quotient.mul(p, &fuel).ok()?;
        let lead = |p: &Poly| p.terms().last().map(|(_, c)| c.clone());
        let scale = BigRational::new(-lead(cofactor)?, lead(&product)?);
        scaled.push((scale, quotient, state.atoms.get(*j)?.poly.clone()));
    }
    let common = scaled.iter().fold(BigInt::one(), |l, (s, ..)| l.lcm(s.denom()));
    let whole = |s: &BigRational| s.numer() * (&common / s.denom());
    let weight = weight * &common;
    let divisor = scaled.iter().fold(weight.clone(), |g, (s, ..)| g.gcd(&whole(s)));
    let weight = weight / &divisor;
    let scaled = scaled.iter().map(|(s, q, e)| (q.scale(&(whole(s) / &divisor)), e.clone()));
    let multiples: Vec<(Poly, Poly)> = scaled.collect();
    // what is told is held against the polynomials once more
    let (fuel, mut rest) = (Fuel::new(FUEL), p.scale(&weight));
    for (q, e) in &multiples {
        rest = rest.sub(&q.mul(e, &fuel).ok()?);
    }
    rest.is_empty().then(|| Step::Multiple { atom: (weight, p.clone()), multiples })
}

/// A sum of terms that are not negative.
fn positive(state: &State<'_, '_>, terms: &[Term], cofactors: &[(usize, Poly)]) -> Option<Step> {
    let poly = |i: usize| state.atoms.get(i).map(|atom| atom.poly.clone());
    let term = |t: &Term| {
        let factors = t.factors.iter().map(|(i, n)| Some((poly(*i)?, *n)));
        let factors = factors.collect::<Option<_>>()?;
        Some(Summand { weight: t.weight.clone(), square: t.square.clone(), factors })
    };
    let multiple = |(i, c): &(usize, Poly)| Some((c.clone(), poly(*i)?));
    let multiples = cofactors.iter().map(multiple).collect::<Option<_>>()?;
    Some(Step::Positive { terms: terms.iter().map(term).collect::<Option<_>>()?, multiples })
}
