//! Intervals with as many digits as asked for.

use std::cmp::Ordering;

use kane_number::{Binary, Integer, Rational, Rounding, decode, encode};
use num_integer::Integer as _;
use num_traits::{Signed, Zero};

/// m·2^e.
#[derive(Clone, Debug)]
struct Dyadic {
    m: Integer,
    e: i64,
}

/// Every number between two dyadic fractions; rigorous, rounded outward to a number of bits.
#[derive(Clone, Debug)]
pub struct Enclosure {
    lower: Dyadic,
    upper: Dyadic,
}

fn bits(m: &Integer) -> i64 {
    i64::try_from(m.bits()).unwrap_or(i64::MAX)
}

fn shift(by: i64) -> u64 {
    by.max(0).unsigned_abs()
}

impl Dyadic {
    fn integer(m: Integer) -> Self {
        Self { m, e: 0 }
    }

    /// With no more than `precision` bits, toward −∞ or +∞.
    fn rounded(self, precision: u32, up: bool) -> Self {
        let excess = bits(&self.m) - i64::from(precision);
        if excess <= 0 {
            return self;
        }
        // a shift of a signed integer rounds toward −∞
        let m = if up { -(-self.m >> shift(excess)) } else { self.m >> shift(excess) };
        Self { m, e: self.e + excess }
    }

    fn plus(&self, other: &Self) -> Self {
        let (low, high) = if self.e <= other.e { (self, other) } else { (other, self) };
        Self { m: &low.m + (&high.m << shift(high.e - low.e)), e: low.e }
    }

    fn times(&self, other: &Self) -> Self {
        Self { m: &self.m * &other.m, e: self.e + other.e }
    }

    fn opposite(&self) -> Self {
        Self { m: -&self.m, e: self.e }
    }

    fn quotient(&self, other: &Self, precision: u32, up: bool) -> Self {
        let scale = (i64::from(precision) + 2 + bits(&other.m) - bits(&self.m)).max(0);
        let numerator = &self.m << shift(scale);
        let m = if up { -(-numerator).div_floor(&other.m) } else { numerator.div_floor(&other.m) };
        Self { m, e: self.e - other.e - scale }.rounded(precision, up)
    }

    fn root(&self, precision: u32, up: bool) -> Self {
        let mut scale = (2 * i64::from(precision) + 2 - bits(&self.m)).max(0);
        scale += (self.e - scale).rem_euclid(2);
        let scaled = &self.m << shift(scale);
        let mut m = scaled.sqrt();
        if up && &m * &m < scaled {
            m += 1;
        }
        Self { m, e: (self.e - scale) / 2 }.rounded(precision, up)
    }

    fn order(&self, other: &Self) -> Ordering {
        self.plus(&other.opposite()).m.cmp(&Integer::ZERO)
    }

    fn least(self, other: Self) -> Self {
        if self.order(&other) == Ordering::Greater { other } else { self }
    }

    fn greatest(self, other: Self) -> Self {
        if self.order(&other) == Ordering::Less { other } else { self }
    }

    fn is_zero(&self) -> bool {
        self.m.is_zero()
    }

    fn to_rational(&self) -> Rational {
        if self.e >= 0 {
            Rational::from_integer(&self.m << shift(self.e))
        } else {
            Rational::new(self.m.clone(), Integer::from(1) << shift(-self.e))
        }
    }

    /// The exponent b with 2^b ≤ |x| < 2^(b+1); far below every float for 0.
    fn binade(&self) -> i64 {
        if self.is_zero() { i64::MIN / 4 } else { bits(&self.m) - 1 + self.e }
    }

    /// The next `f64` in a direction.
    fn to_f64(&self, rounding: Rounding) -> f64 {
        // far beyond every float a power of two stands for the number
        if self.binade() > 1_100 || (!self.is_zero() && self.binade() < -1_200) {
            let power = Integer::from(self.m.signum());
            let e = if self.binade() > 0 { 1_100 } else { -1_200 };
            return encode(&Self { m: power, e }.to_rational(), rounding);
        }
        encode(&self.to_rational(), rounding)
    }
}

impl Enclosure {
    fn new(lower: Dyadic, upper: Dyadic, precision: u32) -> Self {
        Self { lower: lower.rounded(precision, false), upper: upper.rounded(precision, true) }
    }

    fn point(point: Dyadic) -> Self {
        Self { lower: point.clone(), upper: point }
    }

    /// The exact value of a float; `None` for NaN and ±∞.
    #[must_use]
    pub fn of<B: Binary>(float: B) -> Option<Self> {
        let exact = decode(float).ok()?;
        let e = 1 - bits(exact.denom());
        Some(Self::point(Dyadic { m: exact.numer().clone(), e }))
    }

    /// The tightest enclosure of a rational.
    #[must_use]
    pub fn of_rational(number: &Rational, precision: u32) -> Self {
        let numer = Self::point(Dyadic::integer(number.numer().clone()));
        if number.is_integer() {
            return numer;
        }
        let denom = Dyadic::integer(number.denom().clone());
        Self {
            lower: numer.lower.quotient(&denom, precision, false),
            upper: numer.lower.quotient(&denom, precision, true),
        }
    }

    /// −a.
    #[must_use]
    pub fn neg(&self) -> Self {
        Self { lower: self.upper.opposite(), upper: self.lower.opposite() }
    }

    /// a + b.
    #[must_use]
    pub fn add(&self, other: &Self, precision: u32) -> Self {
        Self::new(self.lower.plus(&other.lower), self.upper.plus(&other.upper), precision)
    }

    /// a − b.
    #[must_use]
    pub fn sub(&self, other: &Self, precision: u32) -> Self {
        self.add(&other.neg(), precision)
    }

    /// a·b.
    #[must_use]
    pub fn mul(&self, other: &Self, precision: u32) -> Self {
        let corner = |a: &Dyadic, b: &Dyadic| a.times(b);
        self.corners(other, &corner, &corner, precision)
    }

    fn corners(
        &self,
        other: &Self,
        down: &impl Fn(&Dyadic, &Dyadic) -> Dyadic,
        up: &impl Fn(&Dyadic, &Dyadic) -> Dyadic,
        precision: u32,
    ) -> Self {
        let ends = [
            (&self.lower, &other.lower),
            (&self.lower, &other.upper),
            (&self.upper, &other.lower),
            (&self.upper, &other.upper),
        ];
        let (mut lower, mut upper) = (down(ends[0].0, ends[0].1), up(ends[0].0, ends[0].1));
        for (a, b) in ends.into_iter().skip(1) {
            lower = lower.least(down(a, b));
            upper = upper.greatest(up(a, b));
        }
        Self::new(lower, upper, precision)
    }

    /// a/b; `None` if the divisor may be 0.
    #[must_use]
    pub fn div(&self, other: &Self, precision: u32) -> Option<Self> {
        if other.sign().is_none_or(|sign| sign == Ordering::Equal) {
            return None;
        }
        let down = |a: &Dyadic, b: &Dyadic| a.quotient(b, precision, false);
        let up = |a: &Dyadic, b: &Dyadic| a.quotient(b, precision, true);
        Some(self.corners(other, &down, &up, precision))
    }

    /// √a; `None` if a may be negative.
    #[must_use]
    pub fn sqrt(&self, precision: u32) -> Option<Self> {
        (!self.lower.m.is_negative()).then(|| Self {
            lower: self.lower.root(precision, false),
            upper: self.upper.root(precision, true),
        })
    }

    /// |a|.
    #[must_use]
    pub fn abs(&self) -> Self {
        match self.sign() {
            Some(Ordering::Less) => self.neg(),
            Some(_) => self.clone(),
            None => Self {
                lower: Dyadic::integer(Integer::ZERO),
                upper: self.upper.clone().greatest(self.lower.opposite()),
            },
        }
    }

    /// The smaller of two.
    #[must_use]
    pub fn min(&self, other: &Self) -> Self {
        Self {
            lower: self.lower.clone().least(other.lower.clone()),
            upper: self.upper.clone().least(other.upper.clone()),
        }
    }

    /// The larger of two.
    #[must_use]
    pub fn max(&self, other: &Self) -> Self {
        self.neg().min(&other.neg()).neg()
    }

    /// How the number compares with 0, if that is known.
    #[must_use]
    pub fn sign(&self) -> Option<Ordering> {
        let (lower, upper) = (self.lower.m.cmp(&Integer::ZERO), self.upper.m.cmp(&Integer::ZERO));
        match (lower, upper) {
            (Ordering::Greater, _) => Some(Ordering::Greater),
            (_, Ordering::Less) => Some(Ordering::Less),
            (Ordering::Equal, Ordering::Equal) => Some(Ordering::Equal),
            _ => None,
        }
    }

    /// Bits by which the enclosure is narrower than its numbers are large; negative if it may hold 0
    /// and is no point.
    #[must_use]
    pub fn sharpness(&self) -> i64 {
        let width = self.upper.plus(&self.lower.opposite());
        if width.is_zero() {
            return i64::MAX;
        }
        match self.sign() {
            None => -1,
            Some(_) => self.lower.binade().min(self.upper.binade()) - width.binade(),
        }
    }

    /// a·2^exponent, which loses nothing.
    #[must_use]
    pub fn scaled(&self, exponent: i64) -> Self {
        let scaled = |end: &Dyadic| Dyadic { m: end.m.clone(), e: end.e + exponent };
        Self { lower: scaled(&self.lower), upper: scaled(&self.upper) }
    }

    /// The ends as floats, rounded outward.
    #[must_use]
    pub fn ends(&self) -> (f64, f64) {
        (self.lower.to_f64(Rounding::Down), self.upper.to_f64(Rounding::Up))
    }

    /// A number inside, near the middle.
    #[must_use]
    pub fn middle(&self) -> Rational {
        let sum = self.lower.plus(&self.upper);
        Dyadic { m: sum.m, e: sum.e - 1 }.to_rational()
    }

    /// The exponents b with 2^b ≤ |x| < 2^(b+1) for the smallest and the greatest magnitude; the first is far
    /// below every float if 0 may be among them.
    #[must_use]
    pub fn binades(&self) -> (i64, i64) {
        let (a, b) = (self.lower.binade(), self.upper.binade());
        match self.sign() {
            None => (i64::MIN / 4, a.max(b)),
            Some(_) => (a.min(b), a.max(b)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kane_number::parse;

    fn of(text: &str) -> Enclosure {
        Enclosure::of_rational(&parse(text).unwrap(), 100)
    }

    fn holds(enclosure: &Enclosure, text: &str) -> bool {
        let exact = parse(text).unwrap();
        enclosure.lower.to_rational() <= exact && exact <= enclosure.upper.to_rational()
    }

    #[test]
    fn enclosures_hold_what_rationals_give() {
        assert!(holds(&of("1/3").add(&of("1/7"), 60), "10/21"));
        assert!(holds(&of("1/3").mul(&of("-1/7"), 60), "-1/21"));
        assert!(holds(&of("1/3").div(&of("-1/7"), 60).unwrap(), "-7/3"));
        assert!(holds(&of("4/9").sqrt(60).unwrap(), "2/3"));
        assert!(holds(&of("-4/9").abs(), "4/9"));
        assert!(of("1/3").sharpness() > 95);
        assert!(of("1/3").sub(&of("1/3"), 60).sharpness() < 0);
        assert!(of("1").sub(&of("1"), 60).sign() == Some(Ordering::Equal));
        assert!(of("1").div(&of("1/3").sub(&of("1/3"), 60), 60).is_none());
        assert!(of("-1/3").sqrt(60).is_none());
    }

    #[test]
    fn ends_are_floats_beyond_the_number() {
        let (lower, upper) = of("1/10").ends();
        assert!(lower < upper && lower <= 0.1 && 0.1 <= upper && lower.next_up() == upper);
        let tiny = Enclosure::of(f64::from_bits(1)).unwrap();
        let square = tiny.mul(&tiny, 60);
        assert_eq!(square.ends(), (0.0, f64::from_bits(1)));
        let huge = Enclosure::of(f64::MAX).unwrap();
        assert_eq!(huge.mul(&huge, 60).ends(), (f64::MAX, f64::INFINITY));
    }
}
