//! How near the end of a limit is near enough: where first coefficients outweigh t times the rest.

use std::collections::BTreeMap;

use kane_algebra::linear_program::common_denominator;
use kane_kernel::{Fuel, Monomial, Poly};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _};

use super::summands::{Signs, Sum, Summand, closed, common_powers, over, product};
use crate::argument::Argument;

/// Σ weight·monomial in constants, none of it negative
pub(super) type Rest = BTreeMap<Monomial, BigRational>;

/// That first − t·rest is positive.
struct Demand {
    /// a polynomial in constants that is plainly positive, in lowest whole numbers
    first: Poly,
    rest: Rest,
}

/// What is demanded along a germ, and the radius that is small enough for all of it.
#[derive(Default)]
pub(super) struct Nearness(Vec<Demand>);

/// What is positive, and why it is not zero and not negative.
pub(super) type Cut = (Poly, Argument, Argument);

/// Where the radius is known: the places of 0 < t, of t < radius, and of the first demand.
#[derive(Clone, Copy)]
pub(super) struct Places {
    pub(super) t: usize,
    pub(super) t_atom: usize,
    pub(super) radius_atom: usize,
    pub(super) first: usize,
}

impl Nearness {
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// Asks that first − t·rest be positive; more is asked where that was asked of the same first coefficient before.
    pub(super) fn ask(&mut self, first: &Poly, rest: &Rest) {
        let known = self.0.iter().position(|demand| demand.first == *first);
        let demand = known.unwrap_or_else(|| {
            self.0.push(Demand { first: first.clone(), rest: Rest::new() });
            self.0.len() - 1
        });
        for (m, weight) in rest {
            let own = self.0[demand].rest.entry(m.clone()).or_default();
            *own = own.clone().max(weight.clone());
        }
    }

    /// The monomial and the other factors of what all first coefficients divide.
    fn common(&self) -> (Monomial, Vec<Poly>) {
        let (mut powers, mut cores) = (BTreeMap::new(), Vec::new());
        for Demand { first, .. } in &self.0 {
            let monomial = common_powers(first);
            let core = over(first, &monomial);
            for (v, n) in monomial {
                let most = powers.entry(v).or_insert(0);
                *most = n.max(*most);
            }
            if core != Poly::one() && !cores.contains(&core) {
                cores.push(core);
            }
        }
        (powers.into_iter().collect(), cores)
    }

    /// The quotient of that by one of the first coefficients: its monomial, and its other factors.
    fn cofactor(&self, i: usize) -> (Monomial, Vec<Poly>) {
        let ((monomial, mut cores), first) = (self.common(), &self.0[i].first);
        let own = common_powers(first);
        cores.retain(|core| *core != over(first, &own));
        let less = |(v, n): (usize, u32)| (v, n - kane_kernel::exponent(&own, v));
        (monomial.into_iter().map(less).filter(|power| power.1 > 0).collect(), cores)
    }

    /// What makes weights whole.
    fn scale(&self) -> BigInt {
        common_denominator(self.0.iter().flat_map(|demand| demand.rest.values()))
    }

    /// A radius within which all that is demanded holds.
    pub(super) fn radius(&self, fuel: &Fuel) -> Option<(Poly, Poly)> {
        Some(self.radius_over(fuel)?.0)
    }

    /// The same, and what was divided out of both of its polynomials.
    fn radius_over(&self, fuel: &Fuel) -> Option<((Poly, Poly), BigInt)> {
        let scale = self.scale();
        let whole = |(monomial, cores): (Monomial, Vec<Poly>)| -> Option<Poly> {
            let monomial = Poly::term(monomial, BigInt::one());
            cores.iter().try_fold(monomial, |product, core| product.mul(core, fuel).ok())
        };
        let num = whole(self.common())?.scale(&scale);
        let mut den = Poly::default();
        for (i, demand) in self.0.iter().enumerate() {
            let rest = polynomial(&demand.rest, &scale);
            den = den.add(&whole(self.cofactor(i))?.mul(&rest, fuel).ok()?);
        }
        // nothing is demanded
        if den.is_empty() {
            return Some(((Poly::one(), Poly::one()), BigInt::one()));
        }
        // an atom that is changed by an equation is one without a common factor
        let [(of_num, num), (of_den, den)] = [num.primitive(), den.primitive()];
        let common = of_num.gcd(&of_den);
        let [num, den] = [num.scale(&(of_num / &common)), den.scale(&(of_den / &common))];
        Some(((num, den), common))
    }

    /// first − t·rest in whole numbers, and the weight of that.
    fn atom(&self, i: usize, t: usize, fuel: &Fuel) -> Option<(Poly, BigInt)> {
        let Demand { first, rest } = &self.0[i];
        let scale = common_denominator(rest.values());
        let rest = polynomial(rest, &scale).mul(&Poly::var(t), fuel).ok()?;
        Some((first.scale(&scale).sub(&rest), scale))
    }

    /// first − t·rest, where no more of it is needed than was asked, as a sum.
    pub(super) fn sum(
        &self,
        first: &Poly,
        rest: &Rest,
        (places, signs): (Places, &Signs),
        fuel: &Fuel,
    ) -> Option<Sum> {
        let i = self.0.iter().position(|demand| demand.first == *first)?;
        let (_, scale) = self.atom(i, places.t, fuel)?;
        let near = Summand::new(BigRational::new(BigInt::one(), scale), &[(places.first + i, 1)]);
        let mut out = vec![near];
        for (m, weight) in &self.0[i].rest {
            let more = rest.get(m).map_or_else(|| weight.clone(), |used| weight - used);
            if more.is_positive() {
                let t = Summand::new(BigRational::one(), &[(places.t_atom, 1)]);
                out.push(signs.monomial(more, m)?.times(&t, fuel)?);
            }
        }
        Some(out)
    }

    /// What is demanded, one after the other, with the arguments that it is neither zero nor negative.
    pub(super) fn cuts(&self, (places, signs): (Places, &Signs), fuel: &Fuel) -> Option<Vec<Cut>> {
        let cofactor = |i: usize| -> Option<(Sum, Poly)> {
            let (monomial, cores) = self.cofactor(i);
            let mut sum = vec![signs.monomial(BigRational::one(), &monomial)?];
            let mut poly = Poly::term(monomial, BigInt::one());
            for core in cores {
                sum = product(&sum, &signs.positive(&core)?, fuel)?;
                poly = poly.mul(&core, fuel).ok()?;
            }
            Some((sum, poly))
        };
        let cofactors = (0..self.len()).map(cofactor).collect::<Option<Vec<_>>>()?;
        let (_, common) = self.radius_over(fuel)?;
        let weight = BigRational::new(common, self.scale());
        let radius = Summand::new(weight, &[(places.radius_atom, 1)]);
        let t = Summand::new(BigRational::one(), &[(places.t_atom, 1)]);
        let cut = |i: usize| {
            // cofactorᵢ·(firstᵢ − t·restᵢ) is radius − t·δ and t·Σ restₖ·cofactorₖ of the others
            let mut others = vec![radius.clone()];
            for (k, Demand { rest, .. }) in self.0.iter().enumerate().filter(|(k, _)| *k != i) {
                for (m, weight) in rest {
                    let once = [signs.monomial(weight.clone(), m)?.times(&t, fuel)?];
                    others.extend(product(&once, &cofactors[k].0, fuel)?);
                }
            }
            let (poly, scale) = self.atom(i, places.t, fuel)?;
            let here = places.first + i;
            let of_atom =
                Summand::new(BigRational::new(BigInt::one(), scale.clone()), &[(here, 1)]);
            let mut negative = product(&[of_atom], &cofactors[i].0, fuel)?;
            negative.extend(others.iter().cloned());
            // all of it times the weight, so that the cofactor is whole
            for summand in &mut others {
                summand.weight *= BigRational::from(scale.clone());
            }
            let zero = closed(others, [(here, cofactors[i].1.neg())]);
            Some((poly, zero, closed(negative, [])))
        };
        (0..self.len()).map(cut).collect()
    }
}

/// Σ weight·monomial times what makes that whole.
fn polynomial(rest: &Rest, scale: &BigInt) -> Poly {
    let whole = |weight: &BigRational| (weight * BigRational::from(scale.clone())).to_integer();
    Poly::sum(rest.iter().map(|(m, weight)| (m.clone(), whole(weight))))
}
