//! Roots on one side: A > N, where N is not negative, says that A² > N², in which the roots are squared that stood
//! alone on their side.

use std::collections::BTreeSet;

use kane_algebra::quotient::exact_quotient;
use kane_kernel::{Poly, Sign, State, Term};
use num_bigint::BigInt;
use num_traits::One;

use super::elimination::Factors;
use super::factors::squared_factor;
use super::hints::is_told;
use super::lesser::{Lesser, lesser};
use super::rule::{Rule, odd};
use super::search::{MAX_SPLITS, Outcome, Search, has_root};
use super::settled::{NotNegative, Settled};
use crate::argument::Argument;

/// Terms of a condition that is squared, and of its square.
const TERMS: usize = 16;
const SQUARE: usize = 150;
/// Rules that are used one after the other.
const PASSES: usize = 12;

impl Search<'_> {
    /// What is left once sides are squared, or the sign is known of what a condition has as a square: where a condition has
    /// several roots, or one of something in several variables.
    pub(super) fn by_squaring(&self, state: &State<'_, '_>, splits: u32) -> Option<Outcome> {
        // along a germ conditions have many roots
        let t = state.scope.germ();
        if !self.squares_first && state.atoms.iter().any(|a| a.poly.degree(t) > 0) {
            return None;
        }
        let with_root = |i: usize| has_root(state, &state.atoms[i].poly);
        if !self.proofs || !self.products || splits >= MAX_SPLITS || !strict(state).any(with_root) {
            return None;
        }
        let rules = Rule::all(state);
        let wide = |r: &&Rule| r.is_root && state.atoms[r.equation].poly.vars().len() > 2;
        let wide: Vec<usize> = rules.iter().filter(wide).map(|r| r.v).collect();
        let is_worth = |i: usize| {
            let roots: Vec<usize> =
                products(&state.atoms[i].poly, &rules).into_iter().flatten().collect();
            roots.len() > 1 || roots.iter().any(|v| wide.contains(v))
        };
        if !strict(state).any(is_worth) {
            return None;
        }
        if let Some(settled) = isolated(state, &rules) {
            return Some(self.by_settled(state, settled, &[], splits + 1));
        }
        let factor = squared_factor(state)?;
        Some(self.split(state, factor, &[], splits + 1))
    }
}

/// A > N with squares that have fewer roots than the condition has: A² − N² is positive.
pub(super) fn isolated(state: &State<'_, '_>, rules: &[Rule]) -> Option<Settled> {
    strict(state).find_map(|i| {
        let Squared { poly, zero, negative } = fewest(state, i, rules)?;
        Settled::positive(state, poly, zero, negative)
    })
}

/// A ≥ N with such squares: A² − N² is not negative.
pub(super) fn isolated_weakly(state: &State<'_, '_>, rules: &[Rule]) -> Option<NotNegative> {
    short(state, Sign::NonNegative).find_map(|i| {
        let Squared { poly, negative, .. } = fewest(state, i, rules)?;
        NotNegative::new(state, poly, None, negative)
    })
}

/// The squares of condition i with the fewest products of roots.
fn fewest(state: &State<'_, '_>, i: usize, rules: &[Rule]) -> Option<Squared> {
    let sides = lesser(state, &state.atoms[i].poly, rules).into_iter();
    let squares = sides.filter_map(|side| squared(state, i, &side, rules));
    squares.min_by_key(|found| products(&found.poly, rules).len())
}

/// Short conditions that something is positive, the last ones first.
pub(super) fn strict(state: &State<'_, '_>) -> impl Iterator<Item = usize> {
    short(state, Sign::Positive)
}

/// Short conditions with a sign, the last ones first.
fn short(state: &State<'_, '_>, sign: Sign) -> impl Iterator<Item = usize> {
    let short = move |i: &usize| {
        let atom = &state.atoms[*i];
        atom.sign == sign && atom.decided().is_none() && atom.poly.len() <= TERMS
    };
    (0..state.atoms.len()).rev().filter(short)
}

/// The products of roots in a polynomial.
fn products(p: &Poly, rules: &[Rule]) -> BTreeSet<Vec<usize>> {
    p.terms().map(|(m, _)| odd(m, rules)).filter(|product| !product.is_empty()).collect()
}

/// What the squares of two sides differ by, why it is not zero if the condition is strict, and why it is not negative.
struct Squared {
    poly: Poly,
    zero: Argument,
    negative: Argument,
}

/// The squares of the sides of condition i.
fn squared(state: &State<'_, '_>, i: usize, lesser: &Lesser, rules: &[Rule]) -> Option<Squared> {
    let fuel = &state.scope.fuel;
    let p = &state.atoms[i].poly;
    let square = p.pow(2, fuel).ok()?.add(&p.mul(&lesser.side.scale(&2.into()), fuel).ok()?);
    if square.len() > SQUARE {
        return None;
    }
    let rest = Divided::of(state, &square, rules)?;
    let (content, poly) = rest.left.primitive();
    // a number is told by nothing, and decides
    let is_known = |p: &Poly| !p.is_constant() && is_told(state, p);
    if products(&poly, rules).len() >= products(p, rules).len()
        || is_known(&poly)
        || is_known(&reduced(state, &poly))
    {
        return None;
    }
    // scale·Π lead·(p² + 2·p·N) − Σ cofactor·premise − (what is left) = 0, whose first summand is positive
    let whole = Term { weight: BigInt::one(), square: Poly::one(), factors: vec![(i, 1)] };
    let times_p = |term: Term| {
        let mut factors = [&term.factors[..], &rest.lead[..]].concat();
        match factors.iter_mut().find(|factor| factor.0 == i) {
            Some(factor) => factor.1 += 1,
            None => factors.push((i, 1)),
        }
        factors.sort_unstable();
        Term { weight: term.weight * &rest.scale, factors, ..term }
    };
    let mut terms: Vec<Term> =
        std::iter::once(whole).chain(lesser.twice.iter().cloned()).map(times_p).collect();
    let fresh = state.atoms.len();
    let premises: Vec<(usize, Poly)> = rest.cofactors.iter().map(|(j, c)| (*j, c.neg())).collect();
    let by_zero = [&premises[..], &[(fresh, Poly::constant(-&content))]].concat();
    let zero = Argument::Positive { terms: terms.clone(), cofactors: by_zero };
    terms.push(Term { weight: content, square: Poly::one(), factors: vec![(fresh, 1)] });
    let negative = Argument::Positive { terms, cofactors: premises };
    Some(Squared { poly, zero, negative })
}

/// A polynomial without the factors that conditions say not to vanish, as the search cancels them.
pub(super) fn reduced(state: &State<'_, '_>, p: &Poly) -> Poly {
    let mut rest = p.clone();
    for atom in state.atoms.iter().filter(|a| a.sign == Sign::Positive && !a.poly.is_constant()) {
        if atom.poly == *p || atom.poly.len() > TERMS {
            continue;
        }
        while let Some(q) = exact_quotient(&rest, &atom.poly, &state.scope.fuel)
            && !q.is_constant()
        {
            rest = q;
        }
    }
    rest.primitive().1
}

/// scale·Π lead·p = Σ cofactor·premise + what is left of p.
struct Divided {
    scale: BigInt,
    lead: Factors,
    cofactors: Vec<(usize, Poly)>,
    left: Poly,
}

impl Divided {
    /// p without the powers that rules reduce; `None` where that goes on.
    fn of(state: &State<'_, '_>, p: &Poly, rules: &[Rule]) -> Option<Self> {
        let mut out = Self {
            scale: BigInt::one(),
            lead: Factors::new(),
            cofactors: Vec::new(),
            left: p.clone(),
        };
        for _ in 0..PASSES {
            let high = |rule: &&Rule| out.left.degree(rule.v) >= rule.degree;
            // the last are made of the others
            let Some(rule) = rules.iter().rev().find(high) else { return Some(out) };
            out = out.by(state, rule)?;
        }
        None
    }

    /// The same without high powers of one variable.
    fn by(mut self, state: &State<'_, '_>, rule: &Rule) -> Option<Self> {
        let fuel = &state.scope.fuel;
        let equation = &state.atoms[rule.equation].poly;
        // the equation with what is positive before the power
        let turn = BigInt::from(if rule.is_up { 1 } else { -1 });
        let equation = equation.scale(&turn);
        let lead = equation.coefficient(rule.v, rule.degree);
        let (size, _) = lead.primitive();
        let (mut n, mut cofactor) = (0, Poly::default());
        while self.left.degree(rule.v) >= rule.degree {
            let top = self.left.coefficients(rule.v).pop()?;
            let rest = Poly::power(rule.v, self.left.degree(rule.v) - rule.degree);
            let by = top.mul(&rest, fuel).ok()?;
            self.left = self.left.mul(&lead, fuel).ok()?.sub(&by.mul(&equation, fuel).ok()?);
            if self.left.len() > SQUARE {
                return None;
            }
            cofactor = cofactor.mul(&lead, fuel).ok()?.add(&by);
            n += 1;
        }
        let scaled = lead.pow(n, fuel).ok()?;
        for (_, known) in &mut self.cofactors {
            *known = known.mul(&scaled, fuel).ok()?;
        }
        let cofactor = cofactor.scale(&turn);
        match self.cofactors.iter_mut().find(|known| known.0 == rule.equation) {
            Some((_, known)) => *known = known.add(&cofactor),
            None => self.cofactors.push((rule.equation, cofactor)),
        }
        self.scale *= size.pow(n);
        if let Some((atom, power)) = rule.lead {
            match self.lead.iter_mut().find(|known| known.0 == atom) {
                Some((_, known)) => *known += power * n,
                None => self.lead.push((atom, power * n)),
            }
        }
        Some(self)
    }
}
