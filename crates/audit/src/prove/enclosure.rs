//! Roots between polynomials in t, and the signs that follow for all small t > 0.
//!
//! A root s is enclosed by polynomials in t that its series gives. With s = lo + g, g > 0, what is
//! left of any inequality is a polynomial in t and small quantities, whose first power of t decides
//! its sign: that is written out as a sum of products of t, 1/D − t, g and the rest of the width.

use std::collections::BTreeMap;

use kane_algebra::linear_program::common_denominator;
use kane_kernel::{Atom, Fuel, Germ, Poly, Sign, State, Term};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::series::{Along, Value};
use super::variation::roots;
use crate::argument::Argument;

/// Steps that the polynomials of one case may take.
const FUEL: u64 = 20_000_000;

/// weight · Π atomsᵢ^eᵢ
type Product = (BigRational, BTreeMap<usize, u32>);

/// scale · t^power · p = Σ products + binding · cofactor, so that p is positive.
struct Shown {
    scale: BigInt,
    power: u32,
    products: Vec<Product>,
    cofactor: Poly,
}

/// A root s between two polynomials: above = scale·t^shift·s − low, below = low + width − scale·t^shift·s.
struct Enclosed {
    root: usize,
    scale: BigInt,
    shift: u32,
    low: Poly,
    width: (BigInt, u32),
    above: usize,
    below: usize,
}

/// The place of a germ: its atoms, and what is known of roots there.
pub(super) struct Ground<'a, 's, 'g> {
    state: &'a State<'s, 'g>,
    along: &'a Along<'a, 'g>,
    fuel: Fuel,
    t: usize,
    t_atom: usize,
    near_atom: usize,
    binding_atom: usize,
    /// 1/D is the radius
    radius: BigInt,
    enclosed: Vec<Enclosed>,
}

impl<'a, 's, 'g> Ground<'a, 's, 'g> {
    /// The last three atoms along a germ, before those of a case, are 0 < t, t < radius and x.
    pub(super) fn new(
        state: &'a State<'s, 'g>,
        along: &'a Along<'a, 'g>,
        germ: &Germ,
        before: usize,
    ) -> Option<Self> {
        let radius = (germ.radius.0 == Poly::one()).then(|| germ.radius.1.as_constant())??;
        let [t_atom, near_atom, binding_atom] = [before.checked_sub(3)?, before - 2, before - 1];
        let (fuel, t) = (state.scope.fuel.beside(FUEL), state.scope.germ());
        let enclosed = Vec::new();
        Some(Self { state, along, fuel, t, t_atom, near_atom, binding_atom, radius, enclosed })
    }

    fn mul(&self, a: &Poly, b: &Poly) -> Option<Poly> {
        a.mul(b, &self.fuel).ok()
    }

    fn pow(&self, a: &Poly, n: u32) -> Option<Poly> {
        a.pow(n, &self.fuel).ok()
    }

    /// c·tⁿ
    fn monomial(&self, c: &BigInt, n: u32) -> Poly {
        Poly::term(vec![(self.t, n)], c.clone())
    }

    /// Closes a case: its roots are enclosed, then one of its atoms has the wrong sign.
    pub(super) fn contradiction(mut self, there: &State<'_, '_>, terms: u32) -> Option<Argument> {
        let mut splits = Vec::new();
        let mut left: Vec<usize> = roots(there.scope).collect();
        let mut atoms = self.state.atoms.len();
        loop {
            // Only those whose radicand is enclosed already.
            let known = |e: &Poly, s: usize| {
                e.vars().iter().all(|v| *v == s || !left.contains(v)) && e.degree(s) == 2
            };
            let next = left.iter().enumerate().find_map(|(i, &s)| {
                let q = self
                    .state
                    .atoms
                    .iter()
                    .position(|a| a.sign == Sign::Zero && known(&a.poly, s))?;
                Some((i, s, q))
            });
            let Some((i, s, q)) = next else {
                break;
            };
            left.remove(i);
            splits.push(self.enclose(s, q, terms, atoms)?);
            atoms += 2;
        }
        let end = (there.atoms.len()..self.state.atoms.len()).find_map(|i| self.wrong(i))?;
        Some(splits.into_iter().rev().fold(end, |then, [lower, upper]| {
            let nest = |(poly, zero, negative): (Poly, Argument, Argument), then| Argument::Split {
                poly,
                zero: Box::new(zero),
                positive: Box::new(then),
                negative: Box::new(negative),
            };
            nest(lower, nest(upper, then))
        }))
    }

    /// Polynomials in t around a root, and why it lies between them: for each, what is positive, and
    /// the arguments if it is zero or negative.
    fn enclose(
        &mut self,
        s: usize,
        q: usize,
        terms: u32,
        atoms: usize,
    ) -> Option<[(Poly, Argument, Argument); 2]> {
        let Value::Series(series) = self.along.value(self.state.scope.root(s)?)? else {
            return None;
        };
        let at_least_zero = Atom::new(Poly::var(s), Sign::NonNegative);
        let s_atom = self.state.atoms.iter().position(|a| *a == at_least_zero)?;
        let shift = u32::try_from((-series.low).max(0)).ok()?;
        let start = series.low + i64::from(shift);
        let cut = u32::try_from(start).ok()? + terms;
        let coefficient = |n: u32| self.along.coefficient(&series, i64::from(n) - i64::from(shift));
        let known = (0..cut).map(coefficient).collect::<Option<Vec<_>>>()?;
        let scale = common_denominator(&known);
        let whole = |c: &BigRational| (c * BigRational::from_integer(scale.clone())).to_integer();
        let margin = (coefficient(cut)?.abs().floor().to_integer() + BigInt::one()) * &scale;
        let middle = Poly::in_variable(self.t, &known.iter().map(whole).collect::<Vec<_>>());
        let low = middle.sub(&self.monomial(&margin, cut));
        let high = middle.add(&self.monomial(&margin, cut));
        let scaled = self.mul(&self.monomial(&scale, shift), &Poly::var(s))?;
        let parts = self.state.atoms[q].poly.coefficients(s);
        let (n, d) = (parts[0].neg(), parts[2].clone());
        let positive = match self.along.polynomial(&d)? {
            Value::Series(d) => d.is_positive(),
            Value::Zero => return None,
        };
        // The equation with the sign with which its leading coefficient is positive.
        let (n, d, sense) = if positive { (n, d, 1) } else { (n.neg(), d.neg(), -1) };
        let square = self.monomial(&(&scale * &scale), 2 * shift);
        let of_q = square.scale(&sense.into());
        let radicand = self.mul(&square, &n)?;
        let shown_d = self.positive(&d)?;
        let times = |products: &[Product], factor: &Product| {
            products.iter().map(|p| product(p, factor)).collect::<Vec<_>>()
        };
        let factor = |weight: &BigInt, of: &[(usize, u32)]| -> Product {
            (weight.clone().into(), factors(of.iter().copied()))
        };
        // The lower one: low² is less than what the square of the root is.
        let gap = self.positive(&radicand.sub(&self.mul(&self.mul(&low, &low)?, &d)?))?;
        let lead = self.monomial(&gap.scale, gap.power);
        let g = scaled.sub(&low);
        let zero = closed(
            gap.products.clone(),
            vec![
                (self.binding_atom, gap.cofactor.clone()),
                (q, self.mul(&lead, &of_q)?),
                (atoms, self.mul(&self.mul(&lead, &d)?, &low.add(&scaled))?.neg()),
            ],
        );
        let k = g.neg();
        let twice = &scale + &scale;
        let mut products =
            times(&shown_d.products, &factor(&gap.scale, &[(self.t_atom, gap.power), (atoms, 2)]));
        let with_root = [(self.t_atom, gap.power + shift), (s_atom, 1), (atoms, 1)];
        products.extend(times(&shown_d.products, &factor(&(&twice * &gap.scale), &with_root)));
        products
            .extend(times(&gap.products, &factor(&shown_d.scale, &[(self.t_atom, shown_d.power)])));
        let lead_d = self.monomial(&shown_d.scale, shown_d.power);
        let around = self.mul(&k, &k)?.add(&self.mul(&scaled, &k)?.scale(&2.into()));
        let of_binding = self.mul(&self.mul(&lead, &shown_d.cofactor)?, &around)?;
        let of_binding = of_binding.add(&self.mul(&lead_d, &gap.cofactor)?);
        let negative = closed(
            products,
            vec![
                (self.binding_atom, of_binding),
                (q, self.mul(&self.mul(&lead, &lead_d)?, &of_q)?),
            ],
        );
        let lower = (g, zero, negative);
        // The upper one, with the lower one known.
        let gap = self.positive(&self.mul(&self.mul(&high, &high)?, &d)?.sub(&radicand))?;
        let lead = self.monomial(&gap.scale, gap.power);
        let h = high.sub(&scaled);
        let here = atoms + 1;
        let zero = closed(
            gap.products.clone(),
            vec![
                (self.binding_atom, gap.cofactor.clone()),
                (q, self.mul(&lead, &of_q)?.neg()),
                (here, self.mul(&self.mul(&lead, &d)?, &high.add(&scaled))?.neg()),
            ],
        );
        let shown_high = self.positive(&high)?;
        let lead_high = self.monomial(&shown_high.scale, shown_high.power);
        let both = self.mul(&lead, &lead_high)?;
        let weight = &gap.scale * &shown_high.scale;
        let power = gap.power + shown_high.power;
        let with_root = [(self.t_atom, power + shift), (s_atom, 1), (here, 1)];
        let mut products = times(&shown_d.products, &factor(&(&weight * &scale), &with_root));
        let once = factor(&gap.scale, &[(self.t_atom, gap.power), (here, 1)]);
        for of_high in times(&shown_high.products, &once) {
            products.extend(times(&shown_d.products, &of_high));
        }
        let over = [(self.t_atom, shown_d.power + shown_high.power)];
        products
            .extend(times(&gap.products, &factor(&(&shown_d.scale * &shown_high.scale), &over)));
        let k = h.neg();
        let around = self.mul(&scaled.add(&high), &k)?;
        let of_binding = self.mul(&self.mul(&both, &shown_d.cofactor)?, &around)?;
        let rest = self.mul(&self.mul(&lead_d, &lead_high)?, &gap.cofactor)?;
        let negative = closed(
            products,
            vec![
                (self.binding_atom, of_binding.add(&rest)),
                (q, self.mul(&self.mul(&both, &lead_d)?, &of_q)?.neg()),
            ],
        );
        let width = (&margin + &margin, cut);
        let (above, below) = (atoms, here);
        self.enclosed.push(Enclosed { root: s, scale, shift, low, width, above, below });
        Some([lower, (h, zero, negative)])
    }

    /// The contradiction in an atom whose polynomial has another sign for small t.
    fn wrong(&self, atom: usize) -> Option<Argument> {
        let Atom { poly, sign } = &self.state.atoms[atom];
        let Value::Series(series) = self.along.polynomial(poly)? else {
            return None;
        };
        let positive = series.is_positive();
        let shown = match (sign, positive) {
            (Sign::NonNegative | Sign::Positive, false) | (Sign::Zero, false) => poly.neg(),
            (Sign::Zero, true) => poly.clone(),
            _ => return None,
        };
        let Shown { scale, power, mut products, cofactor } = self.positive(&shown)?;
        let mut cofactors = vec![(self.binding_atom, cofactor)];
        if *sign == Sign::Zero {
            let sense = if positive { -1 } else { 1 };
            cofactors.push((atom, self.monomial(&(scale * BigInt::from(sense)), power)));
        } else {
            products.push((scale.into(), factors([(self.t_atom, power), (atom, 1)])));
        }
        Some(closed(products, cofactors))
    }

    /// Shows that a polynomial in x, t and enclosed roots is positive.
    fn positive(&self, p: &Poly) -> Option<Shown> {
        let x = self.along.side.var;
        // x = γ/β
        let binding = &self.state.atoms[self.binding_atom].poly;
        let (gamma, beta) = (binding.coefficient(x, 0).neg(), binding.coefficient(x, 1));
        let top = p.degree(x);
        let (mut rest, mut cofactor) = (Poly::default(), Poly::default());
        for i in 0..=top {
            let c = self.mul(&p.coefficient(x, i), &self.pow(&beta, top - i)?)?;
            rest = rest.add(&self.mul(&c, &self.pow(&gamma, i)?)?);
            for j in 0..i {
                let power = self.mul(&self.pow(&beta, j)?, &Poly::power(x, j))?;
                let part = self.mul(&power, &self.pow(&gamma, i - 1 - j)?)?;
                cofactor = cofactor.add(&self.mul(&c, &part)?);
            }
        }
        let factor = self.pow(&beta, top)?;
        let mut terms = factor.terms();
        let (monomial, c) = terms.next()?;
        let (mut scale, mut power) = (c.abs(), kane_kernel::exponent(monomial, self.t));
        if c.is_negative() {
            (rest, cofactor) = (rest.neg(), cofactor.neg());
        }
        // each root from its lower bound up
        let small = self.t + 1;
        for (i, e) in self.enclosed.iter().enumerate() {
            let top = rest.degree(e.root);
            if top == 0 {
                continue;
            }
            let lead = self.monomial(&e.scale, e.shift);
            let value = e.low.add(&Poly::var(small + i));
            let mut next = Poly::default();
            for n in 0..=top {
                let c = self.mul(&rest.coefficient(e.root, n), &self.pow(&lead, top - n)?)?;
                next = next.add(&self.mul(&c, &self.pow(&value, n)?)?);
            }
            cofactor = self.mul(&cofactor, &self.pow(&lead, top)?)?;
            scale *= num_traits::pow(e.scale.clone(), usize::try_from(top).ok()?);
            power += e.shift * top;
            rest = next;
        }
        let products = self.products(&rest, small)?;
        Some(Shown { scale, power, products, cofactor })
    }

    /// A polynomial in t and small quantities as a sum of positive products.
    fn products(&self, p: &Poly, small: usize) -> Option<Vec<Product>> {
        let mut out = Vec::new();
        let mut alone: BTreeMap<u32, BigRational> = BTreeMap::new();
        for (monomial, c) in p.terms() {
            let c = BigRational::from_integer(c.clone());
            let mut power = kane_kernel::exponent(monomial, self.t);
            let mut quantities = Vec::new();
            for &(v, n) in monomial.iter().filter(|(v, _)| *v != self.t) {
                let e = self.enclosed.get(v.checked_sub(small)?)?;
                quantities.extend((0..n).map(|_| e));
            }
            let above = |of: &[&Enclosed]| of.iter().map(|e| (e.above, 1)).collect::<Vec<_>>();
            if quantities.is_empty() {
                *alone.entry(power).or_default() += c;
            } else if c.is_positive() {
                let all = above(&quantities).into_iter().chain([(self.t_atom, power)]);
                out.push((c, factors(all)));
            } else {
                // one after the other becomes its width; the difference is its other part
                let mut c = c;
                while let Some(e) = quantities.pop() {
                    let rest = [(e.below, 1), (self.t_atom, power)];
                    out.push((-c.clone(), factors(above(&quantities).into_iter().chain(rest))));
                    c *= BigRational::from_integer(e.width.0.clone());
                    power += e.width.1;
                }
                *alone.entry(power).or_default() += c;
            }
        }
        alone.retain(|_, c| !c.is_zero());
        let radius = BigRational::new(BigInt::one(), self.radius.clone());
        let mut numbers = alone.into_iter();
        if let Some((first, mut lead)) = numbers.next() {
            for (n, c) in numbers {
                if c.is_positive() {
                    out.push((c, factors([(self.t_atom, n)])));
                    continue;
                }
                // −tⁿ is (rⁿ − tⁿ) − rⁿ
                let over = n - first;
                let power =
                    |n: u32| num_traits::pow(radius.clone(), usize::try_from(n).unwrap_or(0));
                for i in 0..over {
                    let weight = -&c * power(over - 1 - i) * &radius;
                    let near = [(self.t_atom, first + i), (self.near_atom, 1)];
                    out.push((weight, factors(near)));
                }
                lead += &c * power(over);
            }
            if !lead.is_positive() {
                return None;
            }
            out.push((lead, factors([(self.t_atom, first)])));
        }
        (!out.is_empty()).then_some(out)
    }
}

/// Atoms with their powers, those of one atom together and none without one.
fn factors(of: impl IntoIterator<Item = (usize, u32)>) -> BTreeMap<usize, u32> {
    let mut all = BTreeMap::new();
    for (atom, n) in of.into_iter().filter(|(_, n)| *n > 0) {
        *all.entry(atom).or_insert(0) += n;
    }
    all
}

/// The product of two products.
fn product(a: &Product, b: &Product) -> Product {
    let both = a.1.iter().chain(&b.1).map(|(atom, n)| (*atom, *n));
    (&a.0 * &b.0, factors(both))
}

/// Σ products + Σ cofactors·equations = 0, in whole numbers.
fn closed(products: Vec<Product>, cofactors: Vec<(usize, Poly)>) -> Argument {
    let scale = common_denominator(products.iter().map(|product| &product.0));
    let term = |(weight, factors): Product| Term {
        weight: (weight * BigRational::from_integer(scale.clone())).to_integer(),
        square: Poly::one(),
        factors: factors.into_iter().collect(),
    };
    let cofactors = cofactors.into_iter().map(|(i, p)| (i, p.scale(&scale)));
    Argument::Positive {
        cofactors: cofactors.filter(|(_, p)| !p.is_empty()).collect(),
        terms: products.into_iter().map(term).collect(),
    }
}
