//! Values at a point: rationals, or polynomials in one real algebraic number.

use kane_kernel::{Point, Poly, Root};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use polycore::Uni;

type Q = BigRational;

/// A point under construction.
#[derive(Clone, Debug, Default)]
pub struct Partial {
    /// θ; `None` while all values are rational
    pub generator: Option<Root>,
    /// values, reduced modulo the polynomial of θ
    pub values: std::collections::BTreeMap<usize, Uni<Q>>,
}

impl Partial {
    /// Gives v a rational value.
    pub fn set(&mut self, v: usize, q: Q) {
        self.values.insert(v, Uni::constant(q));
    }

    fn modulus(&self) -> Option<Uni<Q>> {
        let root = self.generator.as_ref()?;
        Some(Uni::new(root.poly.iter().cloned().map(Q::from_integer).collect()))
    }

    fn reduce(&self, p: Uni<Q>) -> Uni<Q> {
        match self.modulus() {
            Some(m) if p.deg() >= m.deg() => &p % &m,
            _ => p,
        }
    }

    /// Value of a polynomial; `None` if a variable has none.
    #[must_use]
    pub fn eval(&self, p: &Poly) -> Option<Uni<Q>> {
        let mut sum = Uni::constant(Q::zero());
        for (m, c) in p.terms() {
            let mut product = Uni::constant(Q::from_integer(c.clone()));
            for (v, n) in m {
                let value = self.values.get(v)?;
                for _ in 0..*n {
                    product = self.reduce(&product * value);
                }
            }
            sum = &sum + &product;
        }
        Some(sum)
    }

    /// −e/d, `None` where d vanishes.
    #[must_use]
    pub fn quotient(&self, e: &Poly, d: &Poly) -> Option<Uni<Q>> {
        let (e, d) = (self.eval(e)?, self.eval(d)?);
        if d.is_zero() {
            return None;
        }
        let inverse = match self.modulus() {
            None => Uni::constant(d.0.first()?.recip()),
            Some(m) => {
                let (g, s, _) = d.bezout(&m);
                if g.deg() != 0 {
                    return None;
                }
                s.scale(&g.0.first()?.recip())
            }
        };
        Some(self.reduce(&(-&e) * &inverse))
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

/// θ itself as a value.
#[must_use]
pub fn theta() -> Uni<Q> {
    Uni::new(vec![Q::zero(), Q::one()])
}

/// Replaces variables by rational values: Dⁿ·p(values), a positive multiple.
#[must_use]
pub fn specialised(p: &Poly, values: &[(usize, Q)]) -> Poly {
    let mut out: Vec<(kane_kernel::Monomial, Q)> = Vec::new();
    for (m, c) in p.terms() {
        let mut coefficient = Q::from_integer(c.clone());
        let mut rest = Vec::new();
        for &(v, n) in m {
            match values.iter().find(|x| x.0 == v) {
                Some((_, q)) => {
                    let n = i32::try_from(n).unwrap_or(i32::MAX);
                    coefficient *= q.pow(n);
                }
                None => rest.push((v, n)),
            }
        }
        out.push((rest, coefficient));
    }
    let common =
        out.iter().fold(BigInt::one(), |l, (_, q)| num_integer::Integer::lcm(&l, q.denom()));
    let mut poly = Poly::default();
    for (m, q) in out {
        poly.add_term(m, q.numer() * (&common / q.denom()));
    }
    poly
}
