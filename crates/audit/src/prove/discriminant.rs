//! A quadratic with a negative leading coefficient that is positive somewhere has a positive discriminant: from
//! p = a·v² + b·v + c > 0 and a < 0 it follows that b² − 4ac = (2a·v + b)² − 4a·p > 0, in which v does not stand. From
//! p ≥ 0, or from p = 0, it follows that it is not negative.

use kane_kernel::{Atom, Poly, Sign, State, Term};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::Signed as _;

use super::elimination::Factors;
use super::factors::leading;
use super::hints::is_told;
use super::isolated::reduced;
use super::settled::NotNegative;
use crate::argument::Argument;

/// Terms of a quadratic, and of its discriminant.
const TERMS: usize = 24;
const WIDEST: usize = 60;

/// The discriminant of a condition in a variable that no simpler condition has. Its leading coefficient is no number:
/// of those sums of squares know more.
pub(super) fn discriminant(state: &State<'_, '_>) -> Option<NotNegative> {
    let short = |i: &usize| {
        let atom = &state.atoms[*i];
        atom.sign != Sign::NonZero && atom.decided().is_none() && atom.poly.len() <= TERMS
    };
    (0..state.atoms.len()).rev().filter(short).find_map(|i| {
        let vars = state.atoms[i].poly.vars();
        vars.iter().filter(|&&v| is_last(state, i, v)).find_map(|&v| of(state, i, v))
    })
}

/// Whether a variable stands in no other condition but in those that have all variables of condition i, and more, and in
/// those that have none of its leading coefficient.
fn is_last(state: &State<'_, '_>, i: usize, v: usize) -> bool {
    let vars = state.atoms[i].poly.vars();
    let lead = state.atoms[i].poly.coefficient(v, 2).vars();
    state.atoms.iter().enumerate().filter(|(j, a)| *j != i && a.poly.degree(v) > 0).all(|(_, a)| {
        let others = a.poly.vars();
        let has = |w: &usize| others.contains(w);
        others.len() > vars.len() && vars.iter().all(has) || !lead.iter().any(has)
    })
}

/// That of condition i in v.
fn of(state: &State<'_, '_>, i: usize, v: usize) -> Option<NotNegative> {
    let fuel = &state.scope.fuel;
    let Atom { poly: p, sign } = &state.atoms[i];
    if p.degree(v) != 2 {
        return None;
    }
    let [c, b, a] = [0, 1, 2].map(|n| p.coefficient(v, n));
    let (lead, scale, weight) = negative(state, &a)?;
    let slope = a.mul(&Poly::var(v), fuel).ok()?.scale(&2.into()).add(&b);
    let whole = b.mul(&b, fuel).ok()?.sub(&a.mul(&c, fuel).ok()?.scale(&4.into()));
    let (content, poly) = whole.primitive();
    let known = |p: &Poly| is_told(state, p) || state.atoms.iter().any(|a| a.poly == *p);
    if poly.len() > WIDEST || known(&poly) || known(&reduced(state, &poly)) {
        return None;
    }
    // scale·(2a·v + b)² + 4·weight·Π lead·p = scale·(b² − 4ac)
    let mut factors = [&lead[..], &[(i, 1)]].concat();
    factors.sort_unstable();
    let one = Poly::one();
    let mut terms = vec![
        Term { weight: scale.clone(), square: slope, factors: Factors::new() },
        Term { weight: weight * 4, square: one.clone(), factors },
    ];
    let fresh = state.atoms.len();
    let of_it = scale * content;
    let cofactors = vec![(fresh, Poly::constant(-&of_it))];
    let zero = Argument::Positive { terms: terms.clone(), cofactors };
    terms.push(Term { weight: of_it, square: one, factors: vec![(fresh, 1)] });
    let negative = Argument::Positive { terms, cofactors: Vec::new() };
    let zero = (*sign == Sign::Positive).then_some(zero);
    NotNegative::new(state, poly, zero, negative)
}

/// A negative polynomial, no number, as −scale·a = weight·Π conditions that are positive: the conditions, scale and
/// weight.
fn negative(state: &State<'_, '_>, a: &Poly) -> Option<(Factors, BigInt, BigInt)> {
    if a.is_constant() {
        return None;
    }
    let lead = leading(state, a)?;
    if lead.iter().any(|&(j, _)| state.atoms[j].sign != Sign::Positive) {
        return None;
    }
    let product = |product: Poly, &(j, n): &(usize, u32)| {
        let fuel = &state.scope.fuel;
        product.mul(&state.atoms[j].poly.pow(n, fuel).ok()?, fuel).ok()
    };
    let product = lead.iter().try_fold(Poly::one(), product)?;
    let ((_, of_a), (_, of_product)) = (a.terms().next()?, product.terms().next()?);
    let common = of_a.gcd(of_product);
    let (weight, scale) = (-of_a / &common * of_product.signum(), of_product.abs() / &common);
    weight.is_positive().then_some((lead, scale, weight))
}
