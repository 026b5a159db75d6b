//! Between the kernel's integer polynomials and the polynomial libraries that the search stands on.

use kane_kernel::{Monomial, Poly};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use polycore::{Monomial as Exponents, Order};

type Foreign = polycore::Poly<BigRational>;

/// The variables of a few polynomials, numbered densely for the libraries.
#[derive(Clone, Debug)]
pub struct Ring {
    vars: Vec<usize>,
}

impl Ring {
    /// The smallest ring that contains all of these.
    #[must_use]
    pub fn of(polys: &[&Poly]) -> Self {
        let mut vars: Vec<usize> = polys.iter().flat_map(|p| p.vars()).collect();
        vars.sort_unstable();
        vars.dedup();
        Self { vars }
    }

    /// Number of variables.
    #[must_use]
    pub fn len(&self) -> usize {
        self.vars.len()
    }

    /// Whether no variable occurs.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.vars.is_empty()
    }

    /// Into the library, in graded reverse lexicographic order. Exact.
    #[must_use]
    pub fn outward(&self, p: &Poly) -> Foreign {
        let terms = p.terms().map(|(m, c)| {
            let mut exponents = vec![0u32; self.vars.len()];
            for (v, e) in m {
                if let Ok(i) = self.vars.binary_search(v) {
                    exponents[i] = *e;
                }
            }
            (Exponents::new(exponents), BigRational::from_integer(c.clone()))
        });
        Foreign::new(terms.collect(), self.vars.len(), Order::GRevLex)
    }

    /// Out of the library: the polynomial times its common denominator, and that denominator.
    #[must_use]
    pub fn inward(&self, p: &Foreign) -> (Poly, BigInt) {
        let common =
            p.terms.iter().fold(BigInt::one(), |l, (_, c)| num_integer::lcm(l, c.denom().clone()));
        let terms = p.terms.iter().map(|(m, c)| {
            let powers = self.vars.iter().zip(m.exps()).filter(|(_, e)| **e > 0);
            let monomial: Monomial = powers.map(|(v, e)| (*v, *e)).collect();
            (monomial, c.numer() * (&common / c.denom()))
        });
        (Poly::sum(terms), common)
    }
}

/// p/g and q/g for the greatest common divisor g, as primitive polynomials up to a common rational
/// factor: returns (p′, q′) with p·q′ = p′·q.
#[must_use]
pub fn cancelled(p: &Poly, q: &Poly) -> (Poly, Poly) {
    if q.is_constant() || p.is_empty() {
        return (p.clone(), q.clone());
    }
    let ring = Ring::of(&[p, q]);
    let (_, a, b) = zippel_gcd::cofactors(&ring.outward(p), &ring.outward(q));
    let ((a, da), (b, db)) = (ring.inward(&a), ring.inward(&b));
    (a.scale(&db), b.scale(&da))
}

/// The greatest common divisor, primitive.
#[must_use]
pub fn gcd(p: &Poly, q: &Poly) -> Poly {
    let ring = Ring::of(&[p, q]);
    let g = zippel_gcd::gcd(&ring.outward(p), &ring.outward(q));
    ring.inward(&g).0.primitive().1
}

/// The content of p as a polynomial in v: the common factor of its coefficients.
#[must_use]
pub fn content_in(p: &Poly, v: usize) -> Poly {
    let parts = p.coefficients(v);
    let mut parts = parts.iter().filter(|c| !c.is_empty());
    let Some(first) = parts.next() else {
        return Poly::one();
    };
    let first = first.primitive().1;
    parts.fold(first, |g, c| if g.is_constant() { Poly::one() } else { gcd(&g, c) })
}

/// Whether all terms of p have coefficients of one sign: Some(true) for positive.
#[must_use]
pub fn common_sign(p: &Poly) -> Option<bool> {
    let mut signs = p.terms().map(|(_, c)| c.is_positive());
    let first = signs.next()?;
    signs.all(|s| s == first).then_some(first)
}

/// p as a polynomial in v alone with rational coefficients, if it is one.
#[must_use]
pub fn univariate(p: &Poly, v: usize) -> Option<Vec<BigInt>> {
    let mut coefficients = p.univariate(v)?;
    while coefficients.last().is_some_and(Zero::is_zero) {
        coefficients.pop();
    }
    Some(coefficients)
}

/// A Gröbner basis of a few polynomials, with the way back to them.
#[derive(Debug)]
pub struct Ideal {
    ring: Ring,
    basis: groebner::LiftBasis<BigRational>,
}

/// Sizes up to which an ideal is computed: (equations, variables, total degree, terms, coefficient
/// bits). The library has no budget, so the size has to bound its time; the tests measure it.
pub const IDEAL_GATE: [(usize, usize, u32, usize, u64); 2] = [(2, 5, 4, 8, 16), (3, 4, 2, 5, 8)];

/// Whether generators are small enough for a basis, together with `others` in the same ring.
#[must_use]
pub fn within_gate(generators: &[&Poly], others: &[&Poly]) -> bool {
    let degree =
        |p: &Poly| p.terms().map(|(m, _)| m.iter().map(|x| x.1).sum::<u32>()).max().unwrap_or(0);
    let vars = Ring::of(&[generators, others].concat()).len();
    IDEAL_GATE.iter().any(|&(count, most, top, terms, bits)| {
        let small = |p: &&Poly| degree(p) <= top && p.len() <= terms && p.bits() <= bits;
        generators.len() <= count && vars <= most && generators.iter().all(small)
    })
}

impl Ideal {
    /// The ideal of `generators` in a ring that also holds `others`. Nothing bounds the time of the
    /// library: the caller bounds the size.
    #[must_use]
    pub fn new(generators: &[&Poly], others: &[&Poly]) -> Option<Self> {
        let ring = Ring::of(&[generators, others].concat());
        let outward: Vec<_> = generators.iter().map(|p| ring.outward(p)).collect();
        let basis = groebner::LiftBasis::new(&outward).ok()?;
        Some(Self { ring, basis })
    }

    /// Cofactors h and a positive integer c with c·p = Σ hᵢ·generatorᵢ, if p is in the ideal.
    #[must_use]
    pub fn lift(&self, p: &Poly) -> Option<(Vec<Poly>, BigInt)> {
        let lift = self.basis.lift(&self.ring.outward(p)).ok()??;
        let parts: Vec<(Poly, BigInt)> = lift.iter().map(|h| self.ring.inward(h)).collect();
        let common = parts.iter().fold(BigInt::one(), |l, (_, d)| num_integer::lcm(l, d.clone()));
        let whole = parts.iter().map(|(p, d)| p.scale(&(&common / d)));
        Some((whole.collect(), common))
    }
}

#[cfg(test)]
mod tests {
    use kane_kernel::Fuel;
    use proptest::prelude::*;

    use super::*;

    /// Polynomials in up to three symbols, not zero.
    fn poly() -> impl Strategy<Value = Poly> {
        let term = (prop::collection::vec(0u32..3, 3), -3i64..=3);
        let sum = |terms: Vec<(Vec<u32>, i64)>| {
            let mut p = Poly::default();
            for (exponents, c) in terms {
                let powers = [2, 5, 7].into_iter().zip(exponents).filter(|p| p.1 > 0);
                p = p.add(&Poly::term(powers.collect(), c.into()));
            }
            p
        };
        let sums = prop::collection::vec(term, 1..5).prop_map(sum);
        sums.prop_filter("not zero", |p| !p.is_empty())
    }

    fn times(p: &Poly, q: &Poly) -> Poly {
        p.mul(q, &Fuel::new(u64::MAX)).expect("fuel without end")
    }

    /// Whether d divides p: what is left of d without their common factor is constant.
    fn divides(d: &Poly, p: &Poly) -> bool {
        cancelled(d, p).0.is_constant()
    }

    /// Equal up to a rational factor.
    fn proportional(p: &Poly, q: &Poly) -> bool {
        let (p, q) = (p.primitive().1, q.primitive().1);
        p == q || p == q.neg()
    }

    proptest! {
        #[test]
        fn a_planted_common_factor_divides_the_gcd(p in poly(), q in poly(), g in poly()) {
            let (p, q) = (times(&p, &g), times(&q, &g));
            let found = gcd(&p, &q);
            prop_assert!(divides(&g, &found));
            for (whole, rest) in [(&p, cancelled(&p, &q).0), (&q, cancelled(&p, &q).1)] {
                prop_assert!(proportional(&times(&rest, &found), whole));
            }
        }

        #[test]
        fn cancelling_keeps_the_ratio_and_leaves_nothing_in_common(p in poly(), q in poly(), g in poly()) {
            let (p, q) = (times(&p, &g), times(&q, &g));
            let (a, b) = cancelled(&p, &q);
            prop_assert_eq!(times(&p, &b), times(&a, &q));
            prop_assert!(gcd(&a, &b).is_constant() || q.is_constant());
        }

        #[test]
        fn a_planted_content_is_found(p in poly(), c in poly()) {
            // free of the symbol 2
            let c = c.coefficients(2).into_iter().find(|c| !c.is_empty()).expect("not zero");
            prop_assert!(divides(&c, &content_in(&times(&p, &c), 2)));
        }

        #[test]
        fn members_of_an_ideal_are_lifted(f in poly(), g in poly(), h in poly(), k in poly()) {
            let member = times(&f, &h).add(&times(&g, &k));
            let ideal = Ideal::new(&[&f, &g], &[&member]).expect("generators");
            let (cofactors, c) = ideal.lift(&member).expect("a member");
            let sum = times(&cofactors[0], &f).add(&times(&cofactors[1], &g));
            prop_assert_eq!(member.scale(&c), sum);
        }

        #[test]
        fn polynomials_pass_the_border_unchanged(p in poly()) {
            let ring = Ring::of(&[&p]);
            prop_assert_eq!(ring.inward(&ring.outward(&p)), (p, BigInt::one()));
        }
    }

    #[test]
    fn a_common_sign_is_that_of_every_coefficient() {
        let p = Poly::var(0).add(&Poly::one());
        assert_eq!(common_sign(&p), Some(true));
        assert_eq!(common_sign(&p.neg()), Some(false));
        assert_eq!(common_sign(&Poly::var(0).sub(&Poly::one())), None);
        assert_eq!(common_sign(&Poly::default()), None);
    }
}
