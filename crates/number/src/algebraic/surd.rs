//! a + b√d, the fast case of an algebraic number.

use std::fmt;

use num_traits::{One, Signed, Zero};
use polycore::Uni;

use crate::root::rational::square_root;
use crate::{Integer, Rational};

/// a + b√d with b ≠ 0 and an integer d > 1 that is no square. Irrational, therefore.
#[derive(Clone, Debug)]
pub(super) struct Surd {
    pub(super) a: Rational,
    pub(super) b: Rational,
    pub(super) d: Integer,
}

/// Squares of primes below this are taken out of a radicand. For the eye only: fields are told
/// apart by their radicands' product, not by the radicands.
const TRIAL_LIMIT: u32 = 1000;

/// √radicand as s·√d with d an integer free of small squares, for a positive radicand.
pub(super) fn simplified(radicand: &Rational) -> (Rational, Integer) {
    // √(p/q) = √(pq)/q.
    let mut d = radicand.numer() * radicand.denom();
    let mut outside = Rational::new(Integer::one(), radicand.denom().clone());
    for candidate in 2..TRIAL_LIMIT {
        let square = Integer::from(candidate * candidate);
        if square > d {
            break;
        }
        while (&d % &square).is_zero() {
            d /= &square;
            outside *= Integer::from(candidate);
        }
    }
    (outside, d)
}

impl Surd {
    /// The generator's polynomial x² − d.
    pub(super) fn modulus(&self) -> Uni<Rational> {
        let minus_d = Rational::from_integer(-self.d.clone());
        Uni::new(vec![minus_d, Rational::zero(), Rational::one()])
    }

    /// The same number over another radicand, if both generate the same field: that is if the
    /// product of the radicands is a square, since √e = √(de)/d·√d.
    pub(super) fn over(&self, d: &Integer) -> Option<Self> {
        if *d == self.d {
            return Some(self.clone());
        }
        let product = Rational::from_integer(d * &self.d);
        let b = &self.b * square_root(&product)? / d;
        Some(Self { a: self.a.clone(), b, d: d.clone() })
    }

    /// The conjugate's product with this: a² − b²d, never zero.
    pub(super) fn norm(&self) -> Rational {
        &self.a * &self.a - &self.b * &self.b * &self.d
    }

    pub(super) fn is_negative(&self) -> bool {
        match (self.a.is_negative(), self.b.is_negative()) {
            (false, false) => false,
            (true, true) => true,
            // |a| against |b|√d: the larger one has the sign.
            (a_negative, b_negative) => {
                if self.norm().is_positive() {
                    a_negative
                } else {
                    b_negative
                }
            }
        }
    }

    /// An enclosure; √d is known to 2^−bits.
    pub(super) fn enclose(&self, bits: u32) -> (Rational, Rational) {
        let root = (&self.d << (2 * bits)).sqrt();
        let unit = Integer::one() << bits;
        let next = &root + 1;
        let ends = [root, next].map(|n| &self.a + &self.b * Rational::new(n, unit.clone()));
        let [p, q] = ends;
        if self.b.is_negative() { (q, p) } else { (p, q) }
    }
}

impl fmt::Display for Surd {
    /// `1 - sqrt(2)`, `3/2 + 1/2*sqrt(5)`, `-sqrt(3)`.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match (self.a.is_zero(), self.b.is_negative()) {
            (true, false) => {}
            (true, true) => f.write_str("-")?,
            (false, false) => write!(f, "{} + ", self.a)?,
            (false, true) => write!(f, "{} - ", self.a)?,
        }
        let b = self.b.abs();
        if !b.is_one() {
            write!(f, "{b}*")?;
        }
        write!(f, "sqrt({})", self.d)
    }
}
