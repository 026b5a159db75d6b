//! The sign of a polynomial for small t > 0, by its lowest power of t: written out as a sum of products.

use std::collections::BTreeMap;

use kane_algebra::quotient::exact_quotient;
use kane_algebra::ring::content_in;
use kane_kernel::{Monomial, Poly, exponent};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, Zero as _};

use super::ground::{Enclosed, Equation, Ground, SMALL, Shown, TERMS, add};
use super::nearness::Rest;
use super::summands::{Sum, Summand, common_powers, joined, one, over};

impl Ground<'_> {
    /// Shows that a polynomial in x, t, symbols and enclosed roots is positive.
    pub(super) fn positive(&self, p: &Poly) -> Option<Shown> {
        let mut it = Shown::new(p.clone());
        for Enclosed { equation, .. } in self.enclosed.iter().rev() {
            if !equation.of_beta.is_empty() {
                self.substitute(&mut it, equation)?;
            }
        }
        self.substitute(&mut it, self.binding.as_ref()?)?;
        for (i, e) in self.enclosed.iter().enumerate() {
            let top = it.poly.degree(e.root);
            if top == 0 {
                continue;
            }
            let before = it.poly.clone();
            let mut of_scale = one();
            for _ in 0..top {
                of_scale = self.product(&of_scale, &e.of_scale)?;
            }
            self.multiply(&mut it, &self.pow(&e.scale, top)?, &of_scale)?;
            let value = e.low.add(&Poly::var(SMALL + i));
            it.poly = Poly::default();
            for n in 0..=top {
                let c = self.mul(&before.coefficient(e.root, n), &self.pow(&e.scale, top - n)?)?;
                it.poly = it.poly.add(&self.mul(&c, &self.pow(&value, n)?)?);
            }
        }
        for equation in self.constants.iter().rev() {
            self.substitute(&mut it, equation)?;
        }
        for cofactor in it.cofactors.values_mut() {
            *cofactor = self.spelt_out(cofactor)?;
        }
        self.without_small(&mut it)?;
        for equation in self.constants.iter().rev() {
            self.substitute(&mut it, equation)?;
        }
        let lowest = self.lead(&mut it)?;
        self.without_roots(&mut it, lowest)?;
        self.outweigh(&mut it, lowest)?;
        Some(it)
    }

    /// The small quantities of roots become products, or their widths where they are subtracted.
    fn without_small(&self, it: &mut Shown) -> Option<()> {
        let mut left = BTreeMap::new();
        let mut work: Vec<(BigRational, Monomial, Vec<usize>)> = Vec::new();
        for (m, c) in it.poly.terms() {
            let is_small = |power: &&(usize, u32)| power.0 >= SMALL;
            let small = m.iter().filter(is_small);
            let small = small.flat_map(|&(v, n)| (0..n).map(move |_| v - SMALL)).collect();
            let rest = m.iter().filter(|power| !is_small(power)).copied().collect();
            work.push((c.clone().into(), rest, small));
        }
        while let Some((c, m, mut small)) = work.pop() {
            let above = |small: &[usize]| {
                let factors: Vec<_> = small.iter().map(|&i| (self.enclosed[i].above, 1)).collect();
                Summand::new(BigRational::one(), &factors)
            };
            if small.is_empty() {
                *left.entry(m).or_insert_with(BigRational::zero) += c;
            } else if let Some((square, others)) = self.apart(&c, &m) {
                it.products.push(square?.times(&above(&small), &self.fuel)?);
                work.extend(others.into_iter().map(|(c, m)| (c, m, small.clone())));
            } else if c.is_positive() {
                let product = self.signs.monomial(c, &m)?;
                it.products.push(product.times(&above(&small), &self.fuel)?);
            } else if let Some(last) = small.pop() {
                let Enclosed { width, below, .. } = &self.enclosed[last];
                let below = Summand::new(BigRational::one(), &[(*below, 1)]);
                let product =
                    self.signs.monomial(-c.clone(), &m)?.times(&above(&small), &self.fuel)?;
                it.products.push(product.times(&below, &self.fuel)?);
                for (of_width, weight) in width.terms() {
                    let weight = &c * BigRational::from(weight.clone());
                    work.push((weight, joined(&m, of_width), small.clone()));
                }
            }
            if it.products.len() > TERMS {
                return None;
            }
        }
        self.set(it, left)
    }

    /// Terms with variables of either sign become squares and what is left of them, where that is asked for.
    fn with_squares(&self, it: &mut Shown, of: impl Fn(&[(usize, u32)]) -> bool) -> Option<()> {
        let mut left = BTreeMap::new();
        let mut work: Vec<(BigRational, Monomial)> =
            it.poly.terms().map(|(m, c)| (c.clone().into(), m.to_vec())).collect();
        while let Some((c, m)) = work.pop() {
            match self.apart(&c, &m).filter(|_| of(&m)) {
                Some((square, others)) => {
                    it.products.push(square?);
                    work.extend(others);
                }
                None => *left.entry(m).or_insert_with(BigRational::zero) += c,
            }
        }
        self.set(it, left)
    }

    /// The lowest power of t, with a coefficient that is plainly positive and has no roots; what else stands there
    /// becomes products.
    fn lead(&self, it: &mut Shown) -> Option<u32> {
        let t = self.places.t;
        let roots = |m: &[(usize, u32)]| -> Vec<usize> {
            let own = |v: &usize| self.constants.iter().any(|e| e.var == *v);
            m.iter().map(|power| power.0).filter(own).collect()
        };
        for _ in 0..=2 * self.constants.len() + 1 {
            let lowest = it.poly.terms().map(|(m, _)| exponent(m, t)).min()?;
            let first = it.poly.coefficient(t, lowest);
            let mut sets: Vec<Vec<usize>> = first.terms().map(|(m, _)| roots(m)).collect();
            sets.sort_by_key(|set| (set.len(), set.clone()));
            sets.dedup();
            let of = |set: &[usize]| {
                let own = |(m, _): &(&[(usize, u32)], &BigInt)| roots(m) == set;
                Poly::sum(first.terms().filter(own).map(|(m, c)| (m.to_vec(), c.clone())))
            };
            let serves = |set: &Vec<usize>| {
                let plain: Monomial = set.iter().map(|&v| (v, 1)).collect();
                let group = of(set);
                let others = first.sub(&group);
                self.signs.positive(&over(&group, &plain)).is_some()
                    && others.terms().all(|(m, c)| {
                        c.is_positive() && self.signs.monomial(BigRational::one(), m).is_some()
                    })
            };
            let Some(set) = sets.into_iter().find(serves) else {
                let unsigned =
                    |(m, _): (&[(usize, u32)], &BigInt)| !self.signs.unsigned(m).is_empty();
                if first.terms().any(unsigned) {
                    self.with_squares(it, |m| exponent(m, t) == lowest)?;
                } else {
                    self.with_means(it, lowest)?;
                }
                continue;
            };
            if set.is_empty() {
                let others = first.sub(&of(&set));
                let power = Poly::power(t, lowest);
                let others = self.mul(&others, &power)?;
                for (m, c) in others.terms() {
                    it.products.push(self.signs.monomial(c.clone().into(), m)?);
                }
                it.poly = it.poly.sub(&others);
                return Some(lowest);
            }
            let monomial: Monomial = set.iter().map(|&v| (v, 1)).collect();
            let once = self.signs.monomial(BigRational::one(), &monomial)?;
            self.multiply(it, &Poly::term(monomial, BigInt::one()), &[once])?;
            for equation in self.constants.iter().rev() {
                self.substitute(it, equation)?;
            }
        }
        None
    }

    /// A root in the first coefficient becomes a mean, from which something else may be subtracted: r·(d + n) is 2·n and
    /// d·r·(1 − r)², for d·r² = n.
    fn with_means(&self, it: &mut Shown, lowest: u32) -> Option<()> {
        let t = self.places.t;
        let own = |e: &&Equation| {
            let first = it.poly.coefficient(t, lowest);
            first.terms().any(|(m, c)| exponent(m, e.var) == 1 && c.is_positive())
        };
        let equation = self.constants.iter().rev().find(own)?;
        let Equation { atom, var, beta, of_beta, gamma, is_opposite, .. } = equation;
        let (one, root) = (Poly::one(), Poly::var(*var));
        let sum = beta.add(gamma);
        self.multiply(it, &sum, &self.signs.positive(&sum)?)?;
        // what is a multiple of the root before was that of the sum
        let own = |(m, c): &(&[(usize, u32)], &BigInt)| {
            exponent(m, *var) == 1 && exponent(m, t) == lowest && c.is_positive()
        };
        let by = Poly::sum(it.poly.terms().filter(own).map(|(m, c)| (m.to_vec(), c.clone())));
        let (by, rest) = kane_algebra::ring::cancelled(&over(&by, &[(*var, 1)]), &sum);
        if rest != Poly::one() {
            return None;
        }
        let less = self.mul(&by, &self.mul(&root, &sum)?)?;
        it.poly = it.poly.sub(&less).add(&self.mul(&by, &gamma.scale(&2.into()))?);
        let root_atom = self.signs.told(&root)?;
        let squared = Summand {
            square: one.sub(&root),
            ..Summand::new(BigRational::one(), &[(root_atom, 1)])
        };
        let of_by = by.terms().map(|(m, c)| self.signs.monomial(c.clone().into(), m));
        let of_by = self.product(&of_by.collect::<Option<Sum>>()?, &[squared])?;
        it.products.extend(self.product(&of_by, of_beta)?);
        let c = self.mul(&by, &Poly::constant(2.into()).sub(&root))?;
        add(&mut it.cofactors, *atom, &if *is_opposite { c.neg() } else { c });
        Some(())
    }

    /// Roots that are subtracted after the lowest power become means: 2·d·r is d + n less d·(1 − r)², for d·r² = n.
    fn without_roots(&self, it: &mut Shown, lowest: u32) -> Option<()> {
        let t = self.places.t;
        for equation in self.constants.iter().rev() {
            let Equation { atom, var, beta, of_beta, gamma, is_opposite, .. } = equation;
            let later = |m: &[(usize, u32)]| exponent(m, *var) > 0 && exponent(m, t) > lowest;
            self.with_squares(it, later)?;
            let own = |(m, c): &(&[(usize, u32)], &BigInt)| c.is_negative() && later(m);
            let terms = it.poly.terms().filter(own);
            let by = Poly::sum(terms.map(|(m, c)| (m.to_vec(), c.abs())));
            if by.is_empty() {
                continue;
            }
            let less = over(&by, &[(*var, 1)]);
            let two = BigInt::from(2);
            it.poly = it.poly.add(&by);
            let twice = [Summand::new(two.clone().into(), &[])];
            self.multiply(it, &beta.scale(&two), &self.product(of_beta, &twice)?)?;
            it.poly = it.poly.sub(&self.mul(&less, &beta.add(gamma))?);
            let square = Poly::one().sub(&Poly::var(*var));
            let squared = Summand { square, ..Summand::new(BigRational::one(), &[]) };
            let of_less = less.terms().map(|(m, c)| self.signs.monomial(c.clone().into(), m));
            let of_less = self.product(&of_less.collect::<Option<Sum>>()?, &[squared])?;
            it.products.extend(self.product(&of_less, of_beta)?);
            add(&mut it.cofactors, *atom, &if *is_opposite { less } else { less.neg() });
        }
        Some(())
    }

    /// The first coefficient outweighs what is subtracted later, near enough; what all have in common is left out of that.
    fn outweigh(&self, it: &mut Shown, lowest: u32) -> Option<()> {
        let t = self.places.t;
        self.with_squares(it, |m| exponent(m, t) > lowest)?;
        let content = content_in(&it.poly, t);
        let common = over(&content, &common_powers(&content));
        let plain = self.signs.positive(&common).filter(|_| !common.is_constant());
        let (poly, of_common) = match plain {
            Some(sum) => {
                let (content, whole) = it.poly.primitive();
                (exact_quotient(&whole, &common, &self.fuel)?.scale(&content), sum)
            }
            None => (it.poly.clone(), one()),
        };
        let outweighed = self.outweighed(&poly, lowest)?;
        it.products.extend(self.product(&outweighed, &of_common)?);
        it.poly = Poly::default();
        Some(())
    }

    /// A polynomial whose first coefficient outweighs what is subtracted later, as a sum.
    fn outweighed(&self, poly: &Poly, lowest: u32) -> Option<Sum> {
        let t = self.places.t;
        let mut out = Sum::new();
        let first = poly.coefficient(t, lowest);
        let later = poly.sub(&self.mul(&first, &Poly::power(t, lowest))?);
        let sized = |(m, c): (&[(usize, u32)], &BigInt)| (m.to_vec(), BigRational::from(c.abs()));
        let of =
            |positive| later.terms().filter(move |(_, c)| c.is_positive() == positive).map(sized);
        let added: Vec<(Monomial, BigRational)> = of(true).collect();
        let subtracted: BTreeMap<Monomial, BigRational> = of(false).collect();
        for (m, c) in added {
            out.push(self.signs.monomial(c, &m)?);
        }
        let t_power = |n: u32| Summand::new(BigRational::one(), &[(self.places.t_atom, n)]);
        if subtracted.is_empty() {
            out.extend(self.product(&self.signs.positive(&first)?, &[t_power(lowest)])?);
            return Some(out);
        }
        // in lowest terms, so that the same is asked for once
        let (content, plain) = first.primitive();
        let strict =
            |v: usize| self.signs.told(&Poly::var(v)).is_some_and(|a| self.signs.is_strict(a));
        let mut common = common_powers(&plain);
        common.retain(|power| strict(power.0));
        for power in &mut common {
            let own = subtracted.keys().map(|m| exponent(m, power.0)).min().unwrap_or(0);
            power.1 = own.min(power.1);
        }
        let plain = over(&plain, &common);
        let content = BigRational::from(content);
        let factor = self.signs.monomial(content.clone(), &common)?;
        let mut rest = Rest::new();
        for (m, c) in &subtracted {
            let lower =
                |&(v, n): &(usize, u32)| (v, if v == t { 0 } else { n - exponent(&common, v) });
            let m: Monomial = m.iter().map(lower).filter(|power| power.1 > 0).collect();
            *rest.entry(m).or_insert_with(BigRational::zero) += c / &content;
        }
        let unit = (Poly::one(), Rest::from([(Monomial::new(), BigRational::one())]));
        let is_far = |m: &Monomial| exponent(m, t) > lowest + 1;
        if !self.is_near {
            let mut nearness = self.nearness.borrow_mut();
            nearness.ask(&plain, &rest);
            if subtracted.keys().any(is_far) {
                nearness.ask(&unit.0, &unit.1);
            }
            out.push(t_power(1));
            return Some(out);
        }
        let nearness = self.nearness.borrow();
        let place = (self.places, &self.signs);
        let outweighed = nearness.sum(&plain, &rest, place, &self.fuel)?;
        let by = [factor.times(&t_power(lowest), &self.fuel)?];
        out.extend(self.product(&outweighed, &by)?);
        for (m, c) in subtracted.iter().filter(|(m, _)| is_far(m)) {
            // tⁿ is t less t·(1 − t)·(1 + t + … + tⁿ⁻²)
            let unit = nearness.sum(&unit.0, &unit.1, place, &self.fuel)?;
            let over = exponent(m, t) - lowest - 1;
            let lower = |&(v, n): &(usize, u32)| (v, if v == t { lowest + 1 } else { n });
            let once = self.signs.monomial(c.clone(), &m.iter().map(lower).collect::<Vec<_>>())?;
            let powers: Sum = (0..over).map(t_power).collect();
            out.extend(self.product(&self.product(&unit, &[once])?, &powers)?);
        }
        Some(out)
    }
}
