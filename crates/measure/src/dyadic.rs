//! The reference: binary floats of any precision without bounds on the exponent.

use std::cmp::Ordering;

use kane_number::{Binary, Integer, NotFinite, Rational, Rounding, decode, encode};
use num_traits::{Signed, ToPrimitive, Zero};

use crate::{Arithmetic, Format};

/// Arithmetic with this many bits, each operation within one unit of the last of them.
///
/// Sums and products are exact as long as they fit. There is no over- or underflow, so what a
/// formula loses here is what cancels in it. Every number carries a bound on its error.
#[derive(Clone, Copy, Debug)]
pub struct Dyadic {
    /// Bits that are kept.
    pub bits: u64,
}

/// mantissa · 2^exponent, within 2^doubt of the exact result.
#[derive(Clone, Debug)]
pub struct DyadicNumber {
    mantissa: Integer,
    exponent: i64,
    doubt: i64,
}

/// The doubt of what is exact.
const NONE: i64 = i64::MIN / 4;

fn length(n: &Integer) -> i64 {
    i64::try_from(n.bits()).unwrap_or(i64::MAX)
}

impl Dyadic {
    fn rounded(self, mantissa: Integer, exponent: i64, doubt: i64) -> DyadicNumber {
        let excess = mantissa.bits().saturating_sub(self.bits);
        if excess == 0 {
            return DyadicNumber { mantissa, exponent, doubt };
        }
        let exponent = exponent + i64::try_from(excess).unwrap_or(i64::MAX);
        DyadicNumber { mantissa: mantissa >> excess, exponent, doubt: doubt.max(exponent) + 1 }
    }

    fn target(self) -> i64 {
        i64::try_from(self.bits).unwrap_or(i64::MAX)
    }
}

impl DyadicNumber {
    /// The exact value of a float.
    ///
    /// # Errors
    /// [`NotFinite`] for NaN and ±∞.
    pub fn of<F: Binary>(float: F) -> Result<Self, NotFinite> {
        let exact = decode(float)?;
        // a float's denominator is a power of two
        let exponent = 1 - length(exact.denom());
        Ok(Self { mantissa: exact.numer().clone(), exponent, doubt: NONE })
    }

    /// How many leading bits are certainly right; none if the number cannot be told from 0.
    #[must_use]
    pub fn certain_bits(&self) -> i64 {
        if self.doubt == NONE { i64::MAX } else { self.binade() - self.doubt }
    }

    /// Exactly 0.
    #[must_use]
    pub fn zero() -> Self {
        Self { mantissa: Integer::ZERO, exponent: 0, doubt: NONE }
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.mantissa.is_zero()
    }

    /// Whether this is below 0.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        self.mantissa.is_negative()
    }

    /// The integer b with 2^b ≤ |x| < 2^(b+1); far below every format for 0. Exact.
    #[must_use]
    pub fn binade(&self) -> i64 {
        if self.is_zero() { NONE } else { length(&self.mantissa) - 1 + self.exponent }
    }

    /// The binade of the greatest magnitude that the exact result may have: of √x·√x at x = 2 it is that of 2, though
    /// what is held is less.
    #[must_use]
    pub fn greatest_binade(&self) -> i64 {
        if self.is_zero() || self.doubt == NONE {
            return self.binade();
        }
        let unit = self.exponent.min(self.doubt);
        let at = |exponent: i64| Integer::from(1) << (exponent - unit).unsigned_abs();
        length(&(self.mantissa.abs() * at(self.exponent) + at(self.doubt))) - 1 + unit
    }

    /// log₂|x| in hundredths, rounded down to what its leading 16 bits tell; `None` for 0.
    #[must_use]
    pub fn hundredths_of_log2(&self) -> Option<i64> {
        if self.is_zero() {
            return None;
        }
        let shift = length(&self.mantissa) - 31;
        let magnitude = self.mantissa.magnitude();
        let scale = shift.unsigned_abs();
        let top = if shift >= 0 { magnitude >> scale } else { magnitude << scale };
        // by repeated squaring of a fixed-point number in [1, 2), the same on every machine
        let mut x = top.to_u64()?;
        let mut fraction = 0_i64;
        for _ in 0..14 {
            x = (x * x) >> 30;
            fraction *= 2;
            if x >> 31 == 1 {
                fraction += 1;
                x >>= 1;
            }
        }
        Some(self.binade() * 100 + ((fraction * 100) >> 14))
    }

    /// The nearest float of a format, as its shortest decimal.
    #[must_use]
    pub fn rounded_to<F: Format>(&self) -> String {
        let limit = F::GREATEST_EXPONENT + 2;
        if self.binade() > limit {
            return if self.is_negative() { "-inf" } else { "inf" }.to_owned();
        }
        if self.binade() < F::LEAST_EXPONENT - 2 {
            return "0".to_owned();
        }
        // the value is within the range, so the shift is small
        let scale = self.exponent.unsigned_abs();
        let exact = if self.exponent >= 0 {
            Rational::from_integer(&self.mantissa << scale)
        } else {
            Rational::new(self.mantissa.clone(), Integer::from(1) << scale)
        };
        let float: F = encode(&exact, Rounding::NearestEven);
        format!("{float:e}")
    }

    /// Whether the nearest float of a format is ±∞: from half a step beyond the greatest one on.
    #[must_use]
    pub fn rounds_to_infinity<F: Format>(&self) -> bool {
        let above = F::GREATEST_EXPONENT + 1;
        if self.binade() != F::GREATEST_EXPONENT {
            return self.binade() >= above;
        }
        let sign = if self.is_negative() { -1 } else { 1 };
        let limit = Self { mantissa: Integer::from(sign), exponent: above, doubt: NONE };
        let half_step = F::GREATEST_EXPONENT - i64::from(F::PRECISION);
        limit.minus(self).compare_magnitude(half_step) != Ordering::Greater
    }

    /// self − other, exactly.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        Dyadic { bits: u64::MAX }.sub(self, other)
    }

    /// How the magnitude compares with 2^exponent. Exact.
    #[must_use]
    pub fn compare_magnitude(&self, exponent: i64) -> Ordering {
        if self.is_zero() {
            return Ordering::Less;
        }
        let is_power = self.mantissa.magnitude().count_ones() == 1;
        self.binade().cmp(&exponent).then(if is_power {
            Ordering::Equal
        } else {
            Ordering::Greater
        })
    }
}

impl Arithmetic for Dyadic {
    type Value = DyadicNumber;

    fn number(&self, exact: &Rational) -> DyadicNumber {
        let of = |n: &Integer| DyadicNumber { mantissa: n.clone(), exponent: 0, doubt: NONE };
        let (numer, denom) = (of(exact.numer()), of(exact.denom()));
        if exact.is_integer() {
            return numer;
        }
        self.div(&numer, &denom).unwrap_or(numer)
    }

    fn neg(&self, a: &DyadicNumber) -> DyadicNumber {
        DyadicNumber { mantissa: -&a.mantissa, ..*a }
    }

    fn add(&self, a: &DyadicNumber, b: &DyadicNumber) -> DyadicNumber {
        // both errors add up
        let doubt = if a.doubt.max(b.doubt) == NONE { NONE } else { a.doubt.max(b.doubt) + 1 };
        if a.is_zero() {
            return DyadicNumber { doubt, ..b.clone() };
        }
        if b.is_zero() {
            return DyadicNumber { doubt, ..a.clone() };
        }
        let (low, high) = if a.exponent <= b.exponent { (a, b) } else { (b, a) };
        let gap = (high.exponent - low.exponent).unsigned_abs();
        let sum = &low.mantissa + (&high.mantissa << gap);
        self.rounded(sum, low.exponent, doubt)
    }

    fn sub(&self, a: &DyadicNumber, b: &DyadicNumber) -> DyadicNumber {
        self.add(a, &self.neg(b))
    }

    fn mul(&self, a: &DyadicNumber, b: &DyadicNumber) -> DyadicNumber {
        // |xy − ab| ≤ |a|·δb + |b|·δa + δa·δb with |a| < 2^(binade + 1)
        let (m, n) = (a.binade().max(a.doubt), b.binade().max(b.doubt));
        let doubt = match (a.doubt, b.doubt) {
            (NONE, NONE) => NONE,
            _ => (m.saturating_add(b.doubt)).max(n.saturating_add(a.doubt)) + 3,
        };
        self.rounded(&a.mantissa * &b.mantissa, a.exponent.saturating_add(b.exponent), doubt)
    }

    fn div(&self, a: &DyadicNumber, b: &DyadicNumber) -> Option<DyadicNumber> {
        // a divisor that may be 0 has no reciprocal
        if b.certain_bits() < 2 || b.is_zero() {
            return None;
        }
        // |a/b − x/y| ≤ (δa + |a/b|·δb)/|y| with |y| > |b|/2
        let ratio = a.binade() - b.binade() + 1;
        let doubt = match (a.doubt, b.doubt) {
            (NONE, NONE) => NONE,
            _ => (a.doubt - b.binade()).max(ratio + b.doubt - b.binade()) + 3,
        };
        let shift = (self.target() + 1 + length(&b.mantissa) - length(&a.mantissa)).max(0);
        let quotient = (&a.mantissa << shift.unsigned_abs()) / &b.mantissa;
        let last = a.exponent - b.exponent - shift;
        Some(self.rounded(quotient, last, doubt.max(last) + 1))
    }

    fn sqrt(&self, a: &DyadicNumber) -> Option<DyadicNumber> {
        if a.is_negative() && a.certain_bits() > 0 {
            return None;
        }
        if a.certain_bits() <= 0 || a.is_zero() {
            let doubt = if a.doubt == NONE { NONE } else { a.doubt / 2 + 1 };
            return Some(DyadicNumber { doubt, ..DyadicNumber::zero() });
        }
        // |√a − √x| ≤ δa/√a
        let doubt = if a.doubt == NONE { NONE } else { a.doubt - a.binade() / 2 + 1 };
        let mut shift = (2 * self.target() + 2 - length(&a.mantissa)).max(0);
        shift += (a.exponent - shift).rem_euclid(2);
        let root = (&a.mantissa << shift.unsigned_abs()).sqrt();
        let last = (a.exponent - shift) / 2;
        Some(self.rounded(root, last, doubt.max(last) + 1))
    }

    fn compare(&self, a: &DyadicNumber, b: &DyadicNumber) -> Option<Ordering> {
        let difference = a.minus(b);
        if difference.certain_bits() <= 0 {
            return Some(Ordering::Equal);
        }
        Some(difference.mantissa.cmp(&Integer::ZERO))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kane_number::parse;

    #[test]
    fn roots_and_quotients_are_right_to_the_last_bits() {
        let arithmetic = Dyadic { bits: 200 };
        for text in ["2", "1/3", "7", "1e-40", "1e40"] {
            let a = arithmetic.number(&parse(text).unwrap());
            let root = arithmetic.sqrt(&a).unwrap();
            let rest = arithmetic.mul(&root, &root).minus(&a);
            assert!(rest.is_zero() || rest.binade() < a.binade() - 195, "{text}");
        }
        let third = arithmetic.number(&parse("1/3").unwrap());
        let rest = arithmetic
            .mul(&third, &arithmetic.number(&parse("3").unwrap()))
            .minus(&arithmetic.number(&parse("1").unwrap()));
        assert!(rest.binade() < -198);
    }

    #[test]
    fn a_power_of_two_by_way_of_roots_has_its_own_ulp() {
        let arithmetic = Dyadic { bits: 200 };
        let two = DyadicNumber::of(2.0).unwrap();
        let root = arithmetic.sqrt(&two).unwrap();
        let square = arithmetic.mul(&root, &root);
        assert_eq!((square.binade(), square.greatest_binade()), (0, 1));
        assert_eq!((two.greatest_binade(), DyadicNumber::zero().greatest_binade()), (1, NONE));
        let next = crate::judge(2.0_f64.next_up(), &square);
        assert_eq!((next.fault, next.lost), (None, 0));
    }

    #[test]
    fn logarithms_come_in_hundredths() {
        let log = |x: f64| DyadicNumber::of(x).unwrap().hundredths_of_log2();
        assert_eq!(log(1.0), Some(0));
        assert_eq!(log(f64::from_bits(1)), Some(-107_400));
        assert_eq!(log(3.0), Some(158));
        assert_eq!(log(0.0), None);
    }
}
