//! Exact arithmetic on floats without fractions: every float is an integer times a power of two.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use kane_number::{Integer, Rational, decode};

/// n·2^e. Sums and products are exact and need no gcd, which is what makes 10⁵ cases affordable.
#[derive(Clone, Debug)]
pub(crate) struct Dyadic {
    integer: Integer,
    exponent: i64,
}

impl Dyadic {
    pub(crate) fn of(float: f64) -> Self {
        let exact = decode(float).expect("a finite float");
        let halvings = exact.denom().bits() - 1;
        Self { integer: exact.numer().clone(), exponent: -bits(halvings) }
    }

    fn aligned(&self, exponent: i64) -> Integer {
        &self.integer << u64::try_from(self.exponent - exponent).expect("aligned downwards")
    }

    fn together(&self, other: &Self) -> (Integer, Integer, i64) {
        let exponent = self.exponent.min(other.exponent);
        (self.aligned(exponent), other.aligned(exponent), exponent)
    }

    pub(crate) fn sign(&self) -> Ordering {
        self.integer.cmp(&Integer::from(0))
    }

    fn size(&self) -> Self {
        if self.sign() == Ordering::Less { -self.clone() } else { self.clone() }
    }

    fn two_to(exponent: i64) -> Self {
        Self { integer: Integer::from(1), exponent }
    }

    /// The largest b with 2^b ≤ |self|; not for zero.
    fn binade(&self) -> i64 {
        bits(self.integer.bits()) - 1 + self.exponent
    }
}

fn bits(count: u64) -> i64 {
    i64::try_from(count).expect("no such long numbers")
}

impl Add for Dyadic {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (a, b, exponent) = self.together(&other);
        Self { integer: a + b, exponent }
    }
}

impl Sub for Dyadic {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Dyadic {
    type Output = Self;
    fn neg(self) -> Self {
        Self { integer: -self.integer, ..self }
    }
}

impl Mul<&Dyadic> for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: &Dyadic) -> Dyadic {
        Dyadic { integer: &self.integer * &other.integer, exponent: self.exponent + other.exponent }
    }
}

/// Whether a float is within `bound` ulps of numer/denom, where denom > 0: the ulp of
/// [`kane_number::ulp`], of the exact value, in double precision.
pub(crate) fn within_ulps(
    computed: f64,
    (numer, denom): (&Dyadic, &Dyadic),
    bound: &Rational,
) -> bool {
    let error = (&Dyadic::of(computed) * denom - numer.clone()).size();
    let binade = if numer.sign() == Ordering::Equal {
        i64::MIN / 2
    } else {
        // 2^b ≤ numer/denom < 2^(b + 1): b or b − 1 by the leading bits
        let guess = numer.binade() - denom.binade();
        let above = (&Dyadic::two_to(guess) * denom - numer.size()).sign() == Ordering::Greater;
        if above { guess - 1 } else { guess }
    };
    let ulp = Dyadic::two_to((binade - 52).max(-1074));
    let scale = |x: &Integer| Dyadic { integer: x.clone(), exponent: 0 };
    let allowed = &(&ulp * denom) * &scale(bound.numer());
    (&error * &scale(bound.denom()) - allowed).sign() != Ordering::Greater
}
