//! A point at which both sides of a claim agree, and the tangent planes there.
//!
//! Where a premise says what a sum of powers is, as a² + b² + c² = 3, planes are those in the powers.

use std::collections::BTreeMap;

use kane_algebra::linear_program::common_denominator;
use kane_algebra::point::specialised;
use kane_kernel::{Fraction, Fuel, Monomial, Poly, Sign, State, exponent, sign};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Pow, Signed as _, Zero as _};

use super::conics;

type Q = BigRational;

/// Terms of a polynomial that is evaluated, and its degree in a symbol.
const TERMS: usize = 200;
const DEGREE: u32 = 30;
/// What it costs to evaluate a term, in coefficient operations.
const TERM: u64 = 10;

/// The value of a root: q, or q·s with a root s of a number m.
enum Value {
    Rational(Q),
    Surd(Q, usize, Q),
}

/// What stands in the place of a root or a quotient.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Plane {
    /// its tangent plane
    Linear,
    /// the same in powers of the symbols
    InPowers,
    /// its numerator times the tangent plane of what it is multiplied by
    OfReciprocal,
}

/// A claim, cut at its tangent planes.
pub(super) struct Tangents {
    /// denominators, to be positive
    pub(super) denominators: Vec<Poly>,
    /// not to be negative: a root, or a quotient times its denominator, less its plane
    pub(super) gaps: Vec<Gap>,
    /// not to be negative: the claim with planes for its roots and quotients
    pub(super) rest: Poly,
    /// a condition that the point meets at its edge, as the opposite of the claim is
    pub(super) at_edge: Vec<usize>,
}

/// What is to lie above a plane.
pub(super) struct Gap {
    pub(super) poly: Poly,
    /// the place of the denominator by which it is multiplied
    pub(super) by: Option<usize>,
}

/// A root and its radicand.
pub(super) struct Root {
    pub(super) v: usize,
    pub(super) radicand: Fraction,
}

/// A point.
pub(super) struct Point<'a> {
    fuel: &'a Fuel,
    symbols: Vec<(usize, Q)>,
    /// the powers of symbols in which planes are taken
    powers: BTreeMap<usize, u32>,
    /// roots of numbers
    numbers: &'a [(usize, Q)],
    roots: Vec<(&'a Root, Value)>,
    /// the symbols, and the roots that are rational
    values: BTreeMap<usize, Q>,
}

impl<'a> Point<'a> {
    pub(super) fn new(
        symbols: Vec<(usize, Q)>,
        numbers: &'a [(usize, Q)],
        roots: &'a [Root],
        fuel: &'a Fuel,
    ) -> Option<Self> {
        let values = symbols.iter().cloned().collect();
        let powers = BTreeMap::new();
        let mut point = Self { fuel, symbols, powers, numbers, roots: Vec::new(), values };
        for root in roots {
            let square = point.quotient(&root.radicand)?;
            let value = match square_root(&square) {
                Some(value) => {
                    point.values.insert(root.v, value.clone());
                    Value::Rational(value)
                }
                None => point.numbers.iter().find_map(|(s, m)| {
                    Some(Value::Surd(square_root(&(&square / m))?, *s, m.clone()))
                })?,
            };
            point.roots.push((root, value));
        }
        Some(point)
    }

    fn eval(&self, p: &Poly) -> Option<Q> {
        let is_small = p.len() <= TERMS && p.terms().all(|(m, _)| m.iter().all(|f| f.1 <= DEGREE));
        if !is_small || self.fuel.spend(TERM * p.len() as u64).is_err() {
            return None;
        }
        p.terms().try_fold(Q::zero(), |sum, (m, c)| {
            let power = |product: Q, &(v, n): &(usize, u32)| {
                Some(product * Pow::pow(self.values.get(&v)?, n))
            };
            Some(sum + m.iter().try_fold(Q::from(c.clone()), power)?)
        })
    }

    fn quotient(&self, f: &Fraction) -> Option<Q> {
        let den = self.eval(&f.den).filter(|d| !d.is_zero())?;
        Some(self.eval(&f.num)? / den)
    }

    /// The value of a sum, if all in it is rational.
    pub(super) fn sum(&self, summands: &[Fraction], rest: &Fraction) -> Option<Q> {
        let mut all = summands.iter().chain([rest]);
        all.try_fold(Q::zero(), |sum, f| Some(sum + self.quotient(f)?))
    }

    /// Whether all conditions hold at the point, or nearly: the places of those that it meets at their edge. Which powers
    /// of the symbols their equations are made of is kept.
    pub(super) fn meets(&mut self, state: &State<'_, '_>) -> Option<Vec<usize>> {
        let mut at_edge = Vec::new();
        for (i, atom) in state.atoms.iter().enumerate() {
            match self.eval(&atom.poly).map(|value| sign(value.numer())) {
                Some(0) if atom.sign == Sign::Positive => at_edge.push(i),
                Some(sign) if !atom.sign.admits(sign) => return None,
                _ => {}
            }
            let is_sum = atom.sign == Sign::Zero
                && atom.poly.terms().all(|(m, _)| m.len() <= 1)
                && atom.poly.vars().iter().all(|v| self.symbols.iter().any(|(x, _)| x == v));
            if is_sum {
                self.powers.extend(atom.poly.terms().flat_map(|(m, _)| m.iter().copied()));
            }
        }
        (at_edge.len() <= 1).then_some(at_edge)
    }

    /// The planes that there are, the simplest first.
    pub(super) fn planes(&self) -> impl Iterator<Item = Plane> {
        let has_powers = self.powers.values().any(|n| *n > 1);
        let all = [Plane::Linear, Plane::InPowers, Plane::OfReciprocal];
        all.into_iter().filter(move |plane| *plane != Plane::InPowers || has_powers)
    }

    /// ∂f/∂x at the point.
    fn slope(&self, f: &Fraction, x: usize) -> Option<Q> {
        let (num, den) = (self.eval(&f.num)?, self.eval(&f.den)?);
        let (of_num, of_den) = (self.total(&f.num, x)?, self.total(&f.den, x)?);
        Some((of_num * &den - num * of_den) / (&den * &den))
    }

    /// dp/dx, roots along.
    fn total(&self, p: &Poly, x: usize) -> Option<Q> {
        let mut sum = self.eval(&p.derivative(x, self.fuel).ok()?)?;
        for (root, value) in self.roots.iter().filter(|(root, _)| p.degree(root.v) > 0) {
            let Value::Rational(value) = value else { return None };
            let by_root = self.eval(&p.derivative(root.v, self.fuel).ok()?)?;
            sum += by_root * self.slope(&root.radicand, x)? / (value + value);
        }
        Some(sum)
    }

    /// value + Σ slope·(x − x₀), or the same in powers.
    fn plane(
        &self,
        plane: Plane,
        value: Q,
        slope: impl Fn(usize) -> Option<Q>,
    ) -> Option<Fraction> {
        let mut terms = vec![(Monomial::new(), value)];
        for (x, at) in &self.symbols {
            let n = self.powers.get(x).copied().filter(|_| plane == Plane::InPowers).unwrap_or(1);
            let by_power = Q::from(BigInt::from(n)) * Pow::pow(at, n - 1);
            let slope = slope(*x)?;
            if slope.is_zero() {
                continue;
            }
            if by_power.is_zero() {
                return None;
            }
            let slope = slope / by_power;
            terms[0].1 -= &slope * Pow::pow(at, n);
            terms.push((vec![(*x, n)], slope));
        }
        Some(with_denominator(terms))
    }

    /// What stands in the place of a summand.
    fn tangent(&self, plane: Plane, f: &Fraction) -> Option<Fraction> {
        if let Some((c, root, value)) = self.lone_root(f)
            && c.is_negative()
            && root.radicand.den.is_constant()
        {
            // √R₀ = q·s, and (R + R₀)/(2·√R₀) = (R + R₀)·s/(2·q·m)
            let (scale, number) = match value {
                Value::Rational(q) => (q.clone(), Poly::one()),
                Value::Surd(q, s, m) => (q * m, Poly::var(*s)),
            };
            let weight = c / (&scale + &scale);
            let square = Fraction::rational(&self.quotient(&root.radicand)?);
            let by = with_weight(number, &weight);
            return root.radicand.add(&square, self.fuel).ok()?.mul(&by, self.fuel).ok();
        }
        if let Some((root, value, is_above, g)) = self.irrational(f) {
            // √R·g has the slopes √R₀·(g' + g·R'/(2·R₀)), and g/√R those of 1/√R₀·(g' − g·R'/(2·R₀))
            let Value::Surd(q, s, m) = value else { return None };
            let (of_g, square) = (self.quotient(&g)?, self.quotient(&root.radicand)?);
            let by_root = &of_g / (&square + &square);
            let slope = |x: usize| {
                let of_root = &by_root * self.slope(&root.radicand, x)?;
                let own = self.slope(&g, x)?;
                Some(if is_above { own + of_root } else { own - of_root })
            };
            let weight = if is_above { q.clone() } else { (q * m).recip() };
            let plane = self.plane(plane, of_g.clone(), slope)?;
            return plane.mul(&with_weight(Poly::var(*s), &weight), self.fuel).ok();
        }
        if plane == Plane::OfReciprocal && !f.den.is_constant() {
            let by = Fraction { num: Poly::one(), den: f.den.clone() };
            let reciprocal = self.plane(plane, self.quotient(&by)?, |x| self.slope(&by, x))?;
            return Fraction::whole(f.num.clone()).mul(&reciprocal, self.fuel).ok();
        }
        self.plane(plane, self.quotient(f)?, |x| self.slope(f, x))
    }

    /// c·r with a number c.
    fn lone_root(&self, f: &Fraction) -> Option<(Q, &Root, &Value)> {
        let den = f.den.as_constant().filter(|den| !den.is_zero())?;
        let mut terms = f.num.terms();
        let (Some(([(v, 1)], c)), None) = (terms.next(), terms.next()) else { return None };
        let (root, value) = self.roots.iter().find(|(root, _)| root.v == *v)?;
        Some((Q::new(c.clone(), den), root, value))
    }

    /// A quotient as r·g, or as g/r, with a root r that is not rational.
    fn irrational(&self, f: &Fraction) -> Option<(&Root, &Value, bool, Fraction)> {
        let (root, value) = self.roots.iter().find(|(root, value)| {
            let stands = f.num.degree(root.v) > 0 || f.den.degree(root.v) > 0;
            stands && matches!(value, Value::Surd(..))
        })?;
        let over = |p: &Poly| {
            let is_linear = p.terms().all(|(m, _)| exponent(m, root.v) == 1);
            is_linear.then(|| p.coefficient(root.v, 1))
        };
        let (num, den) = (f.num.clone(), f.den.clone());
        if f.den.degree(root.v) == 0 {
            Some((*root, value, true, Fraction { num: over(&num)?, den }))
        } else if f.num.degree(root.v) == 0 {
            Some((*root, value, false, Fraction { num, den: over(&den)? }))
        } else {
            None
        }
    }

    /// The claim, cut at its planes, if both sides agree at the point.
    pub(super) fn tangents(
        &self,
        plane: Plane,
        summands: &[Fraction],
        rest: &Fraction,
        at_edge: &[usize],
    ) -> Option<Tangents> {
        let mut rest = rest.clone();
        let (mut denominators, mut gaps): (Vec<Poly>, Vec<Gap>) = (Vec::new(), Vec::new());
        let turned = |p: &Poly, by: i8| if by < 0 { p.neg() } else { p.clone() }.primitive().1;
        for f in summands {
            let plane = self.tangent(plane, f)?;
            rest = rest.add(&plane, self.fuel).ok()?;
            let gap = f.add(&plane.neg(), self.fuel).ok()?;
            // what a denominator with an irrational root has is its sign, which is that of the other factor
            let sign = |p: &Poly| match self.eval(p) {
                Some(value) => Some(sign(value.numer())),
                None => {
                    let own = Fraction { num: p.clone(), den: Poly::one() };
                    let (_, _, _, other) = self.irrational(&own)?;
                    Some(sign(self.quotient(&other)?.numer()))
                }
            };
            let by = match f.den.is_constant() {
                true => None,
                false => {
                    denominators.push(turned(&f.den, sign(&f.den)?));
                    Some(denominators.len() - 1)
                }
            };
            gaps.push(Gap { poly: turned(&gap.num, sign(&gap.den)?), by });
        }
        let poly = turned(&rest.num, sign(&rest.den.as_constant()?));
        let agree = specialised(&poly, &self.symbols).is_empty();
        let at_edge = at_edge.to_vec();
        agree.then_some(Tangents { denominators, gaps, rest: poly, at_edge })
    }
}

fn with_weight(p: Poly, weight: &Q) -> Fraction {
    Fraction { num: p.scale(weight.numer()), den: Poly::constant(weight.denom().clone()) }
}

/// A polynomial with rational coefficients, over their common denominator.
fn with_denominator(terms: Vec<(Monomial, Q)>) -> Fraction {
    let den = common_denominator(terms.iter().map(|t| &t.1));
    let whole = |c: Q| (c * Q::from(den.clone())).to_integer();
    let num = Poly::sum(terms.into_iter().map(|(m, c)| (m, whole(c))));
    Fraction { num, den: Poly::constant(den) }
}

fn square_root(q: &Q) -> Option<Q> {
    if !q.is_positive() {
        return None;
    }
    Some(Q::new(conics::root(q.numer())?, conics::root(q.denom())?))
}
