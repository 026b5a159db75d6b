//! Values at a point: rationals, or polynomials in one real algebraic number.

use std::cell::OnceCell;

use kane_kernel::{Fuel, Point, Poly, Root};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use polycore::Uni;

use crate::field::Field;

type Q = BigRational;

/// A point under construction.
#[derive(Clone, Debug, Default)]
pub struct Partial {
    /// θ; `None` while all values are rational
    pub generator: Option<Root>,
    /// values, reduced modulo the polynomial of θ
    pub values: std::collections::BTreeMap<usize, Uni<Q>>,
}

impl From<&Point> for Partial {
    fn from(point: &Point) -> Self {
        let values = point.values.iter().map(|(v, c)| (*v, Uni::new(c.clone())));
        Self { generator: point.generator.clone(), values: values.collect() }
    }
}

impl Partial {
    /// Gives v a rational value.
    pub fn set(&mut self, v: usize, q: Q) {
        self.values.insert(v, Uni::constant(q));
    }

    fn field(&self) -> Option<Field> {
        self.generator.as_ref().map(Field::of)
    }

    /// Value of a polynomial; `None` if a variable has none.
    #[must_use]
    pub fn eval(&self, p: &Poly) -> Option<Uni<Q>> {
        let field = self.field();
        let mut sum = Uni::constant(Q::zero());
        for (m, c) in p.terms() {
            let mut product = Uni::constant(Q::from_integer(c.clone()));
            for (v, n) in m {
                let value = self.values.get(v)?;
                for _ in 0..*n {
                    product = &product * value;
                    if let Some(field) = &field {
                        product = field.reduced(product);
                    }
                }
            }
            sum = &sum + &product;
        }
        Some(sum)
    }

    /// −e/d, `None` where d vanishes, or if the budget is spent.
    #[must_use]
    pub fn quotient(&self, e: &Poly, d: &Poly, fuel: &Fuel) -> Option<Uni<Q>> {
        let (e, d) = (self.eval(e)?, self.eval(d)?);
        if d.is_zero() {
            return None;
        }
        match self.field() {
            None => Some((-&e).scale(&d.0.first()?.recip())),
            Some(field) => Some(field.reduced(&(-&e) * &field.inverse(&d, fuel)?)),
        }
    }

    /// The value of n/d, if it is rational: exact. `None` where it is not, where d vanishes, or if the budget
    /// is spent.
    #[must_use]
    pub fn rational(&self, n: &Poly, d: &Poly, fuel: &Fuel) -> Option<Q> {
        let value = self.quotient(&n.neg(), d, fuel)?;
        (value.deg() == 0).then(|| value.0.first().cloned().unwrap_or_else(Q::zero))
    }

    /// The point as the kernel takes it.
    #[must_use]
    pub fn finish(self) -> Point {
        let rational = self.values.values().all(|u| u.deg() == 0);
        Point {
            generator: self.generator.filter(|_| !rational),
            values: self.values.into_iter().map(|(v, u)| (v, u.0)).collect(),
        }
    }
}

/// Replaces variables by rational values: Dⁿ·p(values), a positive multiple.
#[must_use]
pub fn specialised(p: &Poly, values: &[(usize, Q)]) -> Poly {
    // n^k·d^(N−k) for the k-th power of n/d in a polynomial of degree N, of which only some may occur
    let powers: Vec<(usize, Vec<OnceCell<BigInt>>)> = values
        .iter()
        .map(|(v, _)| (*v, vec![OnceCell::new(); p.degree(*v) as usize + 1]))
        .collect();
    Poly::sum(p.terms().map(|(m, c)| {
        let mut coefficient = c.clone();
        for ((v, of), (_, q)) in powers.iter().zip(values) {
            let k = kane_kernel::exponent(m, *v);
            let power =
                of[k as usize].get_or_init(|| q.numer().pow(k) * q.denom().pow(p.degree(*v) - k));
            if !power.is_one() {
                coefficient *= power;
            }
        }
        let rest = m.iter().filter(|(v, _)| powers.iter().all(|x| x.0 != *v));
        (rest.copied().collect(), coefficient)
    }))
}

/// What [`specialised`] costs beyond what is counted elsewhere, as products of two coefficients: nothing where the
/// powers of the values have a word or two, and the products of their words where they are long.
#[must_use]
pub fn burden(p: &Poly, values: &[(usize, Q)]) -> u64 {
    let words = |(v, q): &(usize, Q)| {
        let bits = q.numer().bits().max(q.denom().bits()).saturating_sub(1);
        bits.saturating_mul(u64::from(p.degree(*v))) / 64
    };
    let words = values.iter().map(words).fold(0, u64::saturating_add);
    let terms = u64::try_from(p.len()).unwrap_or(u64::MAX);
    // a product of two words takes an eighth of what one of two coefficients takes
    words.saturating_mul(words).saturating_mul(terms) / 8
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::theta;

    fn ratio(n: i64, d: i64) -> Q {
        Q::new(n.into(), d.into())
    }

    /// x = √2, y = 3/2
    fn root_of_two() -> Partial {
        let poly = [-2, 0, 1].map(BigInt::from).to_vec();
        let root = Root { poly, lo: ratio(1, 1), hi: ratio(2, 1) };
        let mut point = Partial { generator: Some(root), ..Partial::default() };
        point.values.insert(0, theta());
        point.set(1, ratio(3, 2));
        point
    }

    #[test]
    fn values_are_reduced_by_the_equation_of_the_root() {
        let point = root_of_two();
        let cube = Poly::term(vec![(0, 3), (1, 1)], 2.into());
        // 2·(√2)³·3/2 = 6·√2
        assert_eq!(point.eval(&cube), Some(Uni::new(vec![ratio(0, 1), ratio(6, 1)])));
        assert_eq!(point.eval(&Poly::var(2)), None);
    }

    #[test]
    fn a_quotient_times_its_divisor_is_the_dividend() {
        let (point, fuel) = (root_of_two(), Fuel::new(1 << 20));
        let d = Poly::var(0).add(&Poly::one());
        let e = Poly::var(1).add(&Poly::var(0));
        let q = point.quotient(&e, &d, &fuel).expect("√2 + 1 is not zero");
        let field = point.field().expect("√2 is not rational");
        let product = field.reduced(&q * &point.eval(&d).unwrap());
        assert_eq!(product, -&point.eval(&e).unwrap());
        let zero = Poly::term(vec![(0, 2)], 1.into()).sub(&Poly::constant(2.into()));
        assert_eq!(point.quotient(&e, &zero, &fuel), None);
    }

    #[test]
    fn what_is_rational_at_an_irrational_point_is_told_exactly() {
        let (point, fuel) = (root_of_two(), Fuel::new(1 << 20));
        let (x, y) = (Poly::var(0), Poly::var(1));
        let square = Poly::term(vec![(0, 2)], 1.into());
        // (√2)²/(3/2), and √2/(3/2)
        assert_eq!(point.rational(&square, &y, &fuel), Some(ratio(4, 3)));
        assert_eq!(point.rational(&x, &y, &fuel), None);
        assert_eq!(
            point.rational(&square.sub(&Poly::constant(2.into())), &x, &fuel),
            Some(ratio(0, 1))
        );
        assert_eq!(point.rational(&y, &square.sub(&Poly::constant(2.into())), &fuel), None);
    }

    #[test]
    fn a_rational_point_needs_no_root() {
        let mut point = root_of_two();
        assert!(point.clone().finish().generator.is_some());
        point.set(0, ratio(5, 1));
        assert_eq!(point.finish().generator, None);
    }

    #[test]
    fn specialising_is_evaluation_up_to_a_positive_factor() {
        // (x − y)²·z at x = 1/3, y = 1/2 is z/36
        let difference = Poly::var(0).sub(&Poly::var(1));
        let fuel = Fuel::new(1000);
        let square = difference.pow(2, &fuel).unwrap().mul(&Poly::var(2), &fuel).unwrap();
        let values = [(0, ratio(1, 3)), (1, ratio(1, 2))];
        assert_eq!(specialised(&square, &values).primitive().1, Poly::var(2));
        assert_eq!(specialised(&square, &[(0, ratio(1, 3)), (1, ratio(1, 3))]), Poly::default());
    }
}
