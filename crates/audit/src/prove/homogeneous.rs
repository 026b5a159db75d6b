//! Homogeneous conditions. Where an equation says what a sum of terms of one degree is, as a + b + c = 1 does, the others
//! can be multiplied by powers of that sum until all their terms have one degree. Then the equation is not needed any
//! more, and what was alike stays alike: with c = 1 − a − b it would not.

use kane_algebra::squares::total_degree;
use kane_kernel::{Atom, Fuel, Poly, Sign, State, Term};
use num_bigint::BigInt;
use num_traits::{One as _, Pow as _, Signed as _};

use super::idle::nothing;
use super::search::{Search, has_root};
use crate::argument::Argument;

/// Terms of a condition after it is multiplied, and powers of the sum.
const TERMS: usize = 400;
const POWER: u32 = 8;
/// One part in so many of what is left of the budget is for these products.
const SHARE: u64 = 16;

/// The equation sum = number.
struct Sum {
    /// its place
    at: usize,
    sum: Poly,
    number: BigInt,
    degree: u32,
    /// whether the condition is written the other way round
    turned: bool,
}

/// A condition, multiplied: scale·condition = poly + by·equation.
struct Multiplied {
    at: usize,
    poly: Poly,
    scale: BigInt,
    by: Poly,
}

fn degree(m: &[(usize, u32)]) -> u32 {
    m.iter().map(|power| power.1).sum()
}

/// The degree of all terms, if it is one.
fn common_degree(p: &Poly) -> Option<u32> {
    let mut all = p.terms().map(|(m, _)| degree(m));
    let first = all.next()?;
    all.all(|d| d == first).then_some(first)
}

impl Sum {
    /// The equation at a place, if it is of this kind.
    fn of(state: &State<'_, '_>, at: usize) -> Option<Self> {
        let atom = &state.atoms[at];
        let constant = atom.poly.terms().find(|(m, _)| m.is_empty()).map(|t| t.1.clone())?;
        if atom.sign != Sign::Zero || atom.poly.len() < 3 {
            return None;
        }
        let turned = constant.is_positive();
        let poly = if turned { atom.poly.neg() } else { atom.poly.clone() };
        let number = constant.abs();
        let sum = poly.add(&Poly::constant(number.clone()));
        let degree = common_degree(&sum)?;
        Some(Self { at, sum, number, degree, turned })
    }

    /// A condition of which all terms have one degree.
    fn multiplied(&self, state: &State<'_, '_>, at: usize, fuel: &Fuel) -> Option<Multiplied> {
        let poly = &state.atoms[at].poly;
        let top = total_degree(poly);
        let missing = |m: &[(usize, u32)]| {
            let less = top - degree(m);
            less.is_multiple_of(self.degree).then(|| less / self.degree)
        };
        let powers: Vec<u32> = poly.terms().map(|(m, _)| missing(m)).collect::<Option<_>>()?;
        let most = powers.iter().copied().max().filter(|most| *most <= POWER)?;
        let number = |n: u32| self.number.clone().pow(n);
        let (mut whole, mut by) = (Poly::default(), Poly::default());
        for n in 0..=most {
            let terms = poly.terms().zip(&powers).filter(|(_, power)| **power == n);
            let part = Poly::sum(terms.map(|((m, c), _)| (m.to_vec(), c * number(most - n))));
            whole = whole.add(&part.mul(&self.sum.pow(n, fuel).ok()?, fuel).ok()?);
            for i in 0..n {
                // numberⁿ − sumⁿ = −(sum − number)·Σ sumⁱ·numberⁿ⁻¹⁻ⁱ
                let step = self.sum.pow(i, fuel).ok()?.scale(&number(n - 1 - i));
                by = by.sub(&part.mul(&step, fuel).ok()?);
            }
        }
        let by = if self.turned { by.neg() } else { by };
        (whole.len() <= TERMS).then(|| Multiplied { at, poly: whole, scale: number(most), by })
    }
}

impl Search<'_> {
    /// A proof without an equation by which the conditions are made homogeneous.
    pub(super) fn by_homogeneous(&self, state: &State<'_, '_>) -> Option<Argument> {
        if !self.tangents {
            return None;
        }
        (0..state.atoms.len()).find_map(|at| self.without(state, &Sum::of(state, at)?))
    }

    fn without(&self, state: &State<'_, '_>, sum: &Sum) -> Option<Argument> {
        let mut bare = state.clone();
        let mut all = Vec::new();
        let fuel = state.scope.fuel.within(state.scope.fuel.left() / SHARE);
        for (i, atom) in state.atoms.iter().enumerate() {
            if i != sum.at && common_degree(&atom.poly).is_some() {
                continue;
            }
            bare.atoms[i] = nothing();
            if i != sum.at && atom.sign.is_order() && !has_root(state, &atom.poly) {
                all.extend(sum.multiplied(state, i, &fuel));
            }
        }
        // of what is not strict two cases are looked at, and so of one alone
        let weak = |m: &Multiplied| state.atoms[m.at].sign == Sign::NonNegative;
        let last = all.last()?.at;
        all.retain(|m| !weak(m) || m.at == last);
        self.multiplied(state, &bare, sum, &all, state.atoms.len())
    }

    /// A split for each condition that is multiplied, and a proof by all of them.
    fn multiplied(
        &self,
        state: &State<'_, '_>,
        bare: &State<'_, '_>,
        sum: &Sum,
        left: &[Multiplied],
        place: usize,
    ) -> Option<Argument> {
        let Some((m, others)) = left.split_first() else {
            return self.closed_aside(bare);
        };
        let next = |sign| {
            let bare = bare.with(Atom::new(m.poly.clone(), sign));
            self.multiplied(state, &bare, sum, others, place + 1)
        };
        let term = |at: usize, weight: BigInt| Term {
            weight,
            square: Poly::one(),
            factors: vec![(at, 1)],
        };
        let own = (sum.at, m.by.neg());
        let negative = Argument::Positive {
            terms: vec![term(m.at, m.scale.clone()), term(place, BigInt::one())],
            cofactors: vec![own.clone()],
        };
        let zero = if state.atoms[m.at].sign == Sign::Positive {
            Argument::Positive {
                terms: vec![term(m.at, m.scale.clone())],
                cofactors: vec![own, (place, Poly::one().neg())],
            }
        } else {
            next(Sign::Zero)?
        };
        let positive = next(Sign::Positive)?;
        let [zero, positive, negative] = [zero, positive, negative].map(Box::new);
        Some(Argument::Split { poly: m.poly.clone(), zero, positive, negative })
    }
}
