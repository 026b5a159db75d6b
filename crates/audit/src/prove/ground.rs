//! What is known along a germ, and sums of products made of it.

use std::cell::RefCell;
use std::collections::BTreeMap;

use kane_algebra::linear_program::common_denominator;
use kane_kernel::{Fuel, Monomial, Poly, exponent};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _};

use super::nearness::{Nearness, Places};
use super::summands::{Signs, Sum, Summand, joined, one, product};

/// Terms of a polynomial beyond which nothing is tried.
pub(super) const TERMS: usize = 400;
/// Small quantities stand for variables from here on.
pub(super) const SMALL: usize = 1 << 20;

/// A root s between two polynomials: above = scale·s − low, below = low + width − scale·s.
pub(super) struct Enclosed {
    pub(super) root: usize,
    pub(super) equation: Equation,
    pub(super) scale: Poly,
    pub(super) of_scale: Sum,
    pub(super) low: Poly,
    pub(super) width: Poly,
    pub(super) above: usize,
    pub(super) below: usize,
}

/// β·vᵖ − γ, or its opposite, is the polynomial of an equation.
pub(super) struct Equation {
    pub(super) atom: usize,
    pub(super) var: usize,
    pub(super) period: u32,
    pub(super) beta: Poly,
    /// β as a sum, where it is plainly positive
    pub(super) of_beta: Sum,
    pub(super) gamma: Poly,
    pub(super) is_opposite: bool,
}

pub(super) type Cofactors = BTreeMap<usize, Poly>;

/// scale·p = poly + Σ products + Σ cofactors·equations, where scale is a sum of products, too.
pub(super) struct Shown {
    pub(super) poly: Poly,
    pub(super) scale: Poly,
    pub(super) of_scale: Sum,
    pub(super) products: Sum,
    pub(super) cofactors: Cofactors,
}

/// A case along a germ: what is known of signs there, of constants that are roots, and of roots that are enclosed.
pub(super) struct Ground<'a> {
    pub(super) signs: Signs,
    pub(super) nearness: &'a RefCell<Nearness>,
    /// whether the radius is known already
    pub(super) is_near: bool,
    pub(super) fuel: Fuel,
    pub(super) places: Places,
    /// x as it depends on t
    pub(super) binding: Option<Equation>,
    /// roots of constants
    pub(super) constants: Vec<Equation>,
    pub(super) enclosed: Vec<Enclosed>,
}

impl Shown {
    /// A polynomial as it is.
    pub(super) fn new(poly: Poly) -> Self {
        let (products, cofactors) = (Sum::new(), Cofactors::new());
        Self { poly, scale: Poly::one(), of_scale: one(), products, cofactors }
    }
}

impl<'a> Ground<'a> {
    pub(super) fn new(
        signs: Signs,
        (nearness, is_near): (&'a RefCell<Nearness>, bool),
        fuel: Fuel,
        places: Places,
    ) -> Self {
        let (binding, constants, enclosed) = (None, Vec::new(), Vec::new());
        Self { signs, nearness, is_near, fuel, places, binding, constants, enclosed }
    }

    pub(super) fn mul(&self, a: &Poly, b: &Poly) -> Option<Poly> {
        a.mul(b, &self.fuel).ok().filter(|p| p.len() <= TERMS)
    }

    pub(super) fn pow(&self, a: &Poly, n: u32) -> Option<Poly> {
        (0..n).try_fold(Poly::one(), |product, _| self.mul(&product, a))
    }

    pub(super) fn product(&self, a: &[Summand], b: &[Summand]) -> Option<Sum> {
        product(a, b, &self.fuel)
    }

    pub(super) fn triple(&self, a: &Poly, b: &Poly, c: &Poly) -> Option<Poly> {
        self.mul(&self.mul(a, b)?, c)
    }

    /// Cofactors times a polynomial.
    pub(super) fn times(&self, cofactors: &Cofactors, by: &Poly) -> Option<Cofactors> {
        cofactors.iter().map(|(i, c)| Some((*i, self.mul(c, by)?))).collect()
    }

    /// Multiplies what is reduced by a sum.
    pub(super) fn multiply(&self, it: &mut Shown, by: &Poly, of_by: &[Summand]) -> Option<()> {
        it.poly = self.mul(&it.poly, by)?;
        it.scale = self.mul(&it.scale, by)?;
        it.of_scale = self.product(&it.of_scale, of_by)?;
        it.products = self.product(&it.products, of_by)?;
        it.cofactors = self.times(&it.cofactors, by)?;
        Some(())
    }

    /// Puts γ in the place of β·vᵖ.
    pub(super) fn substitute(&self, it: &mut Shown, equation: &Equation) -> Option<()> {
        let Equation { atom, var, period, beta, of_beta, gamma, is_opposite } = equation;
        let top = it.poly.degree(*var) / period;
        if top == 0 {
            return Some(());
        }
        let before = it.poly.clone();
        let mut of_beta_top = one();
        for _ in 0..top {
            of_beta_top = self.product(&of_beta_top, of_beta)?;
        }
        self.multiply(it, &self.pow(beta, top)?, &of_beta_top)?;
        let (mut rest, mut cofactor) = (Poly::default(), Poly::default());
        for n in 0..=before.degree(*var) {
            let (i, left) = (n / period, Poly::power(*var, n % period));
            let c = self.mul(&before.coefficient(*var, n), &self.pow(beta, top - i)?)?;
            let c = self.mul(&c, &left)?;
            rest = rest.add(&self.mul(&c, &self.pow(gamma, i)?)?);
            // (βvᵖ)ⁱ − γⁱ = (βvᵖ − γ)·Σ (βvᵖ)ʲ·γ^(i−1−j)
            for j in 0..i {
                let power = self.mul(&self.pow(beta, j)?, &Poly::power(*var, j * period))?;
                let part = self.mul(&power, &self.pow(gamma, i - 1 - j)?)?;
                cofactor = cofactor.add(&self.mul(&c, &part)?);
            }
        }
        it.poly = rest;
        add(&mut it.cofactors, *atom, &if *is_opposite { cofactor.neg() } else { cofactor });
        Some(())
    }

    /// A polynomial with what small quantities are in their place.
    pub(super) fn spelt_out(&self, p: &Poly) -> Option<Poly> {
        let mut out = p.clone();
        for (i, e) in self.enclosed.iter().enumerate() {
            let g = self.mul(&e.scale, &Poly::var(e.root))?.sub(&e.low);
            let mut sum = Poly::default();
            for n in 0..=out.degree(SMALL + i) {
                let c = out.coefficient(SMALL + i, n);
                sum = sum.add(&self.mul(&c, &self.pow(&g, n)?)?);
            }
            out = sum;
        }
        Some(out)
    }

    /// c·u·m as a square and what is left, for a product u of variables of either sign:
    /// ½|c|·m·(1 ± u)² − ½|c|·m − ½|c|·m·u².
    #[expect(clippy::type_complexity, reason = "a square, and two terms")]
    pub(super) fn apart(
        &self,
        c: &BigRational,
        m: &[(usize, u32)],
    ) -> Option<(Option<Summand>, [(BigRational, Monomial); 2])> {
        let unsigned = self.signs.unsigned(m);
        if unsigned.is_empty() {
            return None;
        }
        let half = c.abs() / BigRational::from_integer(2.into());
        let rest: Monomial =
            m.iter().map(|&(v, n)| (v, n - exponent(&unsigned, v))).filter(|p| p.1 > 0).collect();
        let u = Poly::term(unsigned.clone(), BigInt::one());
        let one = Poly::one();
        let square = if c.is_positive() { one.add(&u) } else { one.sub(&u) };
        let product = self.signs.monomial(half.clone(), &rest);
        let squared = |s: Summand| {
            let square = s.square.mul(&square, &self.fuel).ok()?;
            Some(Summand { square, ..s })
        };
        let more = joined(&rest, &joined(&unsigned, &unsigned));
        Some((product.and_then(squared), [(-half.clone(), rest), (-half, more)]))
    }

    /// Takes terms in the place of the polynomial, times what makes them whole.
    pub(super) fn set(&self, it: &mut Shown, terms: BTreeMap<Monomial, BigRational>) -> Option<()> {
        let scale = common_denominator(terms.values());
        let whole = |c: BigRational| (c * BigRational::from(scale.clone())).to_integer();
        let poly = Poly::sum(terms.into_iter().map(|(m, c)| (m, whole(c))));
        let weight = Summand::new(scale.clone().into(), &[]);
        self.multiply(it, &Poly::constant(scale), &[weight])?;
        it.poly = poly;
        Some(())
    }
}

/// Adds a cofactor of an equation.
pub(super) fn add(cofactors: &mut Cofactors, equation: usize, c: &Poly) {
    let own = cofactors.entry(equation).or_default();
    *own = own.add(c);
}
