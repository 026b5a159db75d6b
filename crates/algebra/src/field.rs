//! ℚ(θ): the field of one algebraic number, whose elements are polynomials in θ over ℚ.

use kane_kernel::{Fuel, Root};
use num_rational::BigRational;
use num_traits::{One, Zero};
use polycore::Uni;

type Q = BigRational;

/// ℚ(θ), by a polynomial that has θ among its roots. Where that polynomial has factors, an element may
/// have no inverse though it is not zero: what was to be divided is then given up.
pub(crate) struct Field {
    modulus: Uni<Q>,
}

impl Field {
    /// The field of a root.
    pub(crate) fn of(root: &Root) -> Self {
        Self { modulus: Uni::new(root.poly.iter().cloned().map(Q::from_integer).collect()) }
    }

    /// The polynomial of θ.
    pub(crate) fn modulus(&self) -> &Uni<Q> {
        &self.modulus
    }

    /// The remainder of an element.
    pub(crate) fn reduced(&self, p: Uni<Q>) -> Uni<Q> {
        if p.deg() >= self.modulus.deg() { &p % &self.modulus } else { p }
    }

    /// 1/p; what it takes is estimated and spent before, because coefficients grow with each division.
    pub(crate) fn inverse(&self, p: &Uni<Q>, fuel: &Fuel) -> Option<Uni<Q>> {
        let degree = u64::try_from(self.modulus.deg()).ok()?;
        let words = 1 + degree.saturating_mul(bits(p) + bits(&self.modulus)) / 32;
        let cost = (degree * degree).saturating_mul(words).saturating_mul(words);
        fuel.spend(cost).and_then(|()| fuel.spend_beyond(cost.saturating_mul(4))).ok()?;
        let (s, _, g) = p.bezout(&self.modulus);
        (g.deg() == 0 && !g.is_zero()).then(|| s.scale(&g.0[0].recip()))
    }

    /// The product of two polynomials over the field, coefficients from the constant one up.
    pub(crate) fn product(&self, a: &[Uni<Q>], b: &[Uni<Q>]) -> Vec<Uni<Q>> {
        let mut out = vec![Uni::constant(Q::zero()); a.len() + b.len() - 1];
        for (i, x) in a.iter().enumerate() {
            for (j, y) in b.iter().enumerate() {
                out[i + j] = &out[i + j] + &self.reduced(x * y);
            }
        }
        out
    }

    /// The greatest common divisor of two polynomials over the field (Euclid).
    pub(crate) fn gcd(
        &self,
        mut a: Vec<Uni<Q>>,
        mut b: Vec<Uni<Q>>,
        fuel: &Fuel,
    ) -> Option<Vec<Uni<Q>>> {
        trim(&mut a);
        trim(&mut b);
        while !b.is_empty() {
            let lead = self.inverse(b.last()?, fuel)?;
            while a.len() >= b.len() {
                let degree = self.modulus.deg();
                let size = u64::try_from(b.len() * degree * degree).ok()?;
                let words = 1 + (bits(&lead) + a.iter().map(bits).max().unwrap_or(0)) / 64;
                let cost = size.saturating_mul(10).saturating_mul(words);
                fuel.spend(cost).and_then(|()| fuel.spend_beyond(cost.saturating_mul(4))).ok()?;
                let factor = self.reduced(a.last()? * &lead);
                let at = a.len() - b.len();
                for (i, c) in b.iter().enumerate() {
                    a[at + i] = &a[at + i] - &self.reduced(&factor * c);
                }
                a.pop();
                trim(&mut a);
            }
            std::mem::swap(&mut a, &mut b);
        }
        Some(a)
    }
}

/// θ itself as an element.
#[must_use]
pub fn theta() -> Uni<Q> {
    Uni::new(vec![Q::zero(), Q::one()])
}

/// Bits of the largest coefficient.
fn bits(p: &Uni<Q>) -> u64 {
    p.0.iter().map(|c| c.numer().bits() + c.denom().bits()).max().unwrap_or(0)
}

fn trim(p: &mut Vec<Uni<Q>>) {
    while p.last().is_some_and(|u| u.is_zero()) {
        p.pop();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn element(coefficients: &[i64]) -> Uni<Q> {
        Uni::new(coefficients.iter().map(|c| Q::from_integer((*c).into())).collect())
    }

    /// ℚ(√2)
    fn field() -> Field {
        let poly = vec![(-2).into(), 0.into(), 1.into()];
        Field::of(&Root { poly, lo: Q::one(), hi: Q::from_integer(2.into()) })
    }

    #[test]
    fn an_element_times_its_inverse_is_one() {
        let (field, fuel) = (field(), Fuel::new(1 << 20));
        for p in [element(&[1, 1]), element(&[0, 3]), element(&[-7, 5]), element(&[4])] {
            let inverse = field.inverse(&p, &fuel).expect("√2 is not rational");
            assert_eq!(field.reduced(&p * &inverse), element(&[1]));
        }
        assert_eq!(field.inverse(&element(&[]), &fuel), None);
        assert_eq!(
            field.inverse(&element(&[1, 1]), &Fuel::new(1)),
            None,
            "the budget is spent first"
        );
    }

    #[test]
    fn a_common_divisor_over_the_field_is_found() {
        // x² − 2 = (x − √2)·(x + √2) and x² + √2·x = x·(x + √2)
        let (field, fuel) = (field(), Fuel::new(1 << 20));
        let a = vec![element(&[-2]), element(&[]), element(&[1])];
        let b = vec![element(&[]), element(&[0, 1]), element(&[1])];
        let common = field.gcd(a, b, &fuel).expect("a divisor");
        let [c, d] = <[Uni<Q>; 2]>::try_from(common).expect("of degree one");
        let inverse = field.inverse(&d, &fuel).expect("not zero");
        assert_eq!(field.reduced(&c * &inverse), element(&[0, 1]));
    }
}
