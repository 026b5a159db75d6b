//! Factors of conditions: those that are known not to vanish, and those worth a case distinction.

use kane_algebra::factors::factors;
use kane_algebra::quotient::exact_quotient;
use kane_algebra::ring::{common_sign, content_in, gcd};
use kane_algebra::squares::{Question, identity, total_degree};
use kane_kernel::{Atom, Fuel, Poly, Sign, State};
use num_traits::{Signed as _, Zero};

use super::elimination::Factors;
use super::hints::is_told;
use super::{conics, tactics};

/// Terms of an equation that is factored.
const EQUATION: usize = 30;
/// Operations to see that a polynomial of degree two is a sum of squares.
const QUADRATIC: u64 = 100_000;

/// The factors of degree one in a variable, up to what is free of it, of an equation of degree two in it: as
/// (k − x)·(k + x) = 0 has two.
pub(super) fn linear_factors(atom: &Atom, v: usize, fuel: &Fuel) -> Vec<Poly> {
    if atom.sign != Sign::Zero || atom.poly.degree(v) != 2 || atom.poly.len() > EQUATION {
        return Vec::new();
    }
    let [c, b, a] = [0, 1, 2].map(|n| atom.poly.coefficient(v, n));
    let root = || -> Option<Poly> {
        let product = a.mul(&c, fuel).ok()?.scale(&4.into());
        square_root(&b.mul(&b, fuel).ok()?.sub(&product), fuel)
    };
    let line = |root: Poly| {
        let slope = a.mul(&Poly::var(v), fuel).ok()?.scale(&2.into());
        Some(slope.add(&b).add(&root).primitive().1)
    };
    root().map_or_else(Vec::new, |root| [root.neg(), root].into_iter().filter_map(line).collect())
}

/// A polynomial whose square this is.
pub(super) fn square_root(p: &Poly, fuel: &Fuel) -> Option<Poly> {
    let (constant, factors) = factors(p);
    let root = if constant.is_negative() { None } else { conics::root(&constant) }?;
    let factors = factors.into_iter().filter(|(f, _)| !f.is_constant());
    let half = |(f, n): (Poly, u32)| (n % 2 == 0).then(|| f.pow(n / 2, fuel).ok()).flatten();
    let mut halves = factors.map(half);
    halves.try_fold(Poly::constant(root), |p, half| p.mul(&half?, fuel).ok())
}

/// Atoms that are known not to vanish and whose product is ±d up to a factor; none for a constant.
pub(super) fn leading(state: &State<'_, '_>, d: &Poly) -> Option<Vec<(usize, u32)>> {
    let (mut rest, mut factors) = (d.clone(), Vec::new());
    for (i, a) in state.atoms.iter().enumerate() {
        if rest.is_constant() {
            break;
        }
        let known = matches!(a.sign, Sign::Positive | Sign::NonZero);
        if !known || a.poly.is_constant() {
            continue;
        }
        let mut n = 0;
        while let Some(q) = exact_quotient(&rest, &a.poly, &state.scope.fuel) {
            rest = q;
            n += 1;
        }
        if n > 0 {
            factors.push((i, n));
        }
    }
    rest.as_constant().is_some_and(|c| !c.is_zero()).then_some(factors)
}

/// Whether a polynomial visibly cannot vanish: known factors times a sum of positive terms.
pub(super) fn cannot_vanish(state: &State<'_, '_>, d: &Poly) -> bool {
    let mut rest = d.clone();
    for a in &state.atoms {
        if matches!(a.sign, Sign::Positive | Sign::NonZero) && !a.poly.is_constant() {
            while let Some(q) = exact_quotient(&rest, &a.poly, &state.scope.fuel) {
                rest = q;
            }
        }
    }
    if rest.is_constant() {
        return true;
    }
    let trial = state.with(Atom::new(rest.clone(), Sign::Zero));
    common_sign(&rest).is_some() && tactics::wrong_sign(&trial, trial.atoms.len() - 1).is_some()
}

/// Whether a polynomial of degree two is positive as a sum of squares with a number is.
fn is_sum_of_squares(p: &Poly, fuel: &Fuel) -> bool {
    let products = [Poly::one()];
    let positive = p.neg();
    let question = Question {
        positive: &positive,
        products: &products,
        equations: &[],
        degree: 2,
        contacts: &[],
    };
    total_degree(p) == 2 && identity(&question, fuel).is_some()
}

/// A polynomial of some kind that is said not to vanish, is seen to be positive, and divides a condition.
pub(super) fn positive_factor(
    state: &State<'_, '_>,
    is_meant: &dyn Fn(&Poly) -> bool,
) -> Option<Poly> {
    let divides = |p: &Poly| {
        let mut order = state.atoms.iter().filter(|a| a.sign.is_order());
        order.any(|a| exact_quotient(&a.poly, p, &state.scope.fuel).is_some())
    };
    let positive = |p: &Poly| {
        let trial = state.with(Atom::new(p.neg(), Sign::Positive));
        tactics::wrong_sign(&trial, trial.atoms.len() - 1).is_some()
            || is_sum_of_squares(p, &state.scope.fuel.within(QUADRATIC))
    };
    // nor in the case in which it is negative, which is to be closed
    let told = |p: &Poly| {
        let mut strict = state.atoms.iter().filter(|a| a.sign == Sign::Positive);
        strict.any(|a| a.poly == *p || a.poly == p.neg())
    };
    let said = state.atoms.iter().filter(|a| a.sign == Sign::NonZero && a.decided().is_none());
    let parts = said.map(|a| a.poly.primitive().1).filter(|p| is_meant(p) && divides(p));
    parts.flat_map(|p| [p.neg(), p]).find(|p| !told(p) && positive(p))
}

/// An atom with factors that are known not to vanish, and what is left of it.
pub(super) fn cancellation(state: &State<'_, '_>) -> Option<(usize, Factors, Poly)> {
    let known: Vec<usize> = (0..state.atoms.len())
        .filter(|&j| {
            let a = &state.atoms[j];
            matches!(a.sign, Sign::Positive | Sign::NonZero) && !a.poly.is_constant()
        })
        .collect();
    for (i, atom) in state.atoms.iter().enumerate() {
        if atom.poly.is_constant() {
            continue;
        }
        let order = matches!(atom.sign, Sign::Positive | Sign::NonNegative);
        let (mut rest, mut factors) = (atom.poly.clone(), Vec::new());
        for &j in known.iter().filter(|&&j| j != i) {
            let by = &state.atoms[j].poly;
            let mut n = 0;
            let mut before = rest.clone();
            while let Some(q) = exact_quotient(&rest, by, &state.scope.fuel) {
                before = std::mem::replace(&mut rest, q);
                n += 1;
            }
            if order && state.atoms[j].sign == Sign::NonZero && n % 2 == 1 {
                rest = before;
                n -= 1;
            }
            if n > 0 {
                factors.push((j, n));
            }
        }
        // What would only become trivially true may still serve as a leading coefficient.
        let trivial = Atom::new(rest.clone(), atom.sign).decided() == Some(true);
        if !factors.is_empty() && !trivial {
            return Some((i, factors, rest));
        }
    }
    None
}

/// A polynomial that two atoms allow to be nothing but 0.
pub(super) fn pinched(state: &State<'_, '_>) -> Option<Poly> {
    let weak: Vec<Poly> = state
        .atoms
        .iter()
        .filter(|a| a.sign == Sign::NonNegative && !a.poly.is_constant())
        .map(|a| a.poly.primitive().1)
        .collect();
    let pair = weak.iter().enumerate().find(|(i, p)| weak[..*i].contains(&p.neg()));
    let known =
        |p: &Poly| state.atoms.iter().any(|a| a.sign == Sign::Zero && a.poly.primitive().1 == *p);
    pair.map(|(_, p)| p.clone()).filter(|p| !known(p) && !known(&p.neg()))
}

/// A factor of an atom that depends on fewer variables, worth a case distinction.
pub(super) fn content_to_split(state: &State<'_, '_>) -> Option<Poly> {
    for a in &state.atoms {
        let vars = a.poly.vars();
        if vars.len() < 2 || a.poly.len() < 2 || a.poly.len() > 60 || a.sign == Sign::NonZero {
            continue;
        }
        for &v in &vars {
            let content = content_in(&a.poly, v);
            if !content.is_constant() {
                // A power splits like its base.
                let base = content.vars()[0];
                return Some(if content.len() == 1 { Poly::var(base) } else { content });
            }
        }
    }
    None
}

/// Conditions in several variables with as many terms, or with more, but not too many to be factored.
fn long<'a>(state: &'a State<'_, '_>, least: usize) -> impl DoubleEndedIterator<Item = &'a Poly> {
    let long = move |a: &&Atom| {
        let (p, several) = (&a.poly, a.poly.vars().len() > 1);
        a.sign != Sign::NonZero && several && (least..=EQUATION).contains(&p.len())
    };
    state.atoms.iter().filter(long).map(|a| &a.poly)
}

/// A factor that stands squared in a condition, worth a case distinction: where it is not zero only the rest counts.
pub(super) fn squared_factor(state: &State<'_, '_>) -> Option<Poly> {
    long(state, 3).rev().find_map(|p| {
        let (_, factors) = factors(p);
        let squared = factors.into_iter().find(|(f, n)| *n > 1 && f.len() > 1)?.0;
        (!is_told(state, &squared)).then_some(squared)
    })
}

/// A factor that two conditions have in common, worth a case distinction.
pub(super) fn common_factor(state: &State<'_, '_>) -> Option<Poly> {
    let long: Vec<&Poly> = long(state, 2).collect();
    let pairs = long.iter().enumerate().flat_map(|(n, p)| long[..n].iter().map(move |q| (*p, *q)));
    pairs.filter(|(p, q)| p.len().max(q.len()) > 2).find_map(|(p, q)| {
        let common = gcd(p, q).primitive().1;
        let is_part = common.len() > 1 && common.len() < p.len().max(q.len());
        (is_part && !is_told(state, &common)).then_some(common)
    })
}
