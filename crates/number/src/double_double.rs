//! Twice the precision of binary64 with its range.
#![allow(clippy::float_arithmetic, reason = "a double-double is made of float operations")]

use std::cmp::Ordering;
use std::fmt;

use crate::decimal::significant;
use crate::error_free::{fast_two_sum, sum_of, two_product, two_sum};
use crate::operators::{operators, works_in_itself};
use crate::{
    Comparison, NotFinite, Number, Ordered, Rational, Real, Rounding, Scaled, decode, encode,
};

/// An unevaluated sum high + low of two floats, high being the float nearest to the sum.
///
/// About 106 bits of precision in the exponent range of `f64`. With u = 2^−53 and as long as
/// nothing overflows and no low part underflows (that is, results above 2^−916 or so), the
/// relative errors are bounded by
///
/// | operation | bound | source |
/// |---|---|---|
/// | a + b, a − b | 3u² + 13u³ | Joldes, Muller and Popescu 2017, algorithm 6 |
/// | a·b | 7u² | the same, algorithm 10 |
/// | a/b | 15u² + 56u³ | the same, algorithm 17 |
/// | a·b + c | 32u² | fast only where no bits cancel, otherwise by an exact sum |
/// | √a | 25/8·u² | Lefèvre, Louvet, Muller, Picot and Rideau 2023 |
///
/// (M. Joldes, J.-M. Muller, V. Popescu: Tight and rigorous error bounds for basic building
/// blocks of double-word arithmetic. ACM TOMS 44(2), 15, 2017. V. Lefèvre, N. Louvet, J.-M.
/// Muller, J. Picot, L. Rideau: Accurate calculation of Euclidean norms using double-word
/// arithmetic. ACM TOMS 49(1), 2023.) Comparison is exact. A sum or product that overflows is
/// [not finite](Number::is_finite), and compares with nothing.
///
/// ```
/// use kane_number::{DoubleDouble, Number, parse};
/// let third = DoubleDouble::from(1.0) / DoubleDouble::from(3.0);
/// let error = third.to_rational()? - parse("1/3")?;
/// assert!(error.to_string().len() > 30); // 1e-33, not 1e-17
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

/// 2^1000 and 2^−64, to divide the greatest numbers.
const NEAR_OVERFLOW: f64 = f64::from_bits((1023 + 1000) << 52);
const DOWN: f64 = f64::from_bits((1023 - 64) << 52);

impl DoubleDouble {
    /// The sum of two floats of any size. Exact, unless it overflows.
    #[must_use]
    pub fn new(a: f64, b: f64) -> Self {
        Self::of(two_sum(a, b))
    }

    /// The parts in hand; a non-finite number keeps no second part.
    pub(crate) fn of((high, low): (f64, f64)) -> Self {
        Self { high, low: if high.is_finite() { low } else { 0.0 } }
    }

    /// The float nearest to the sum.
    #[must_use]
    pub const fn high(self) -> f64 {
        self.high
    }

    /// What the nearest float leaves over; at most half an ulp of it.
    #[must_use]
    pub const fn low(self) -> f64 {
        self.low
    }

    /// The exact value.
    ///
    /// # Errors
    /// [`NotFinite`] for NaN and ±∞.
    pub fn to_rational(self) -> Result<Rational, NotFinite> {
        Ok(decode(self.high)? + decode(self.low)?)
    }

    /// √a, or `None` if a is negative or not finite. Relative error at most 25/8·u².
    #[must_use]
    pub fn sqrt(self) -> Option<Self> {
        if !self.high.is_finite() || self.high < 0.0 {
            return None;
        }
        if self.high == 0.0 {
            return Some(self);
        }
        let root = self.high.sqrt();
        let (square, error) = two_product(root, root);
        let rest = self.low + ((self.high - square) - error);
        Some(Self::of(fast_two_sum(root, rest / (2.0 * root))))
    }

    /// Both parts times a power of two: exact barring over- and underflow.
    pub(crate) fn times(self, power_of_two: f64) -> Self {
        Self { high: self.high * power_of_two, low: self.low * power_of_two }
    }

    fn opposite(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }

    /// Algorithm 6, the accurate sum: the sloppy one has no relative bound at all.
    fn sum(&self, other: &Self) -> Self {
        let (high, high_error) = two_sum(self.high, other.high);
        let (low, low_error) = two_sum(self.low, other.low);
        let (high, rest) = fast_two_sum(high, high_error + low);
        Self::checked(high, fast_two_sum(high, low_error + rest))
    }

    fn difference(&self, other: &Self) -> Self {
        self.sum(&other.opposite())
    }

    /// Algorithm 10, which needs no fused multiply-add: the product is the same on every machine.
    fn product(&self, other: &Self) -> Self {
        let (high, error) = two_product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        Self::checked(high, fast_two_sum(high, error + cross))
    }

    /// Algorithm 17: one float quotient and its correction.
    fn quotient(&self, other: &Self) -> Self {
        if self.high.abs() > NEAR_OVERFLOW && self.is_finite() {
            // The product with the rounded quotient could overflow though the quotient does not.
            let quotient = self.times(DOWN).quotient(other);
            return Self::of((quotient.high / DOWN, quotient.low / DOWN));
        }
        let quotient = self.high / other.high;
        if !quotient.is_finite() || other.high.is_infinite() {
            return Self::of((quotient, 0.0));
        }
        let covered = other.times_float(quotient);
        let rest = (self.high - covered.high) + (self.low - covered.low);
        Self::of(fast_two_sum(quotient, rest / other.high))
    }

    /// Algorithm 7, for the division: relative error at most 3/2·u² + 4u³.
    fn times_float(self, factor: f64) -> Self {
        let (high, error) = two_product(self.high, factor);
        let (sum, rest) = fast_two_sum(high, self.low * factor);
        Self::checked(high, fast_two_sum(sum, rest + error))
    }

    /// The parts, unless the leading one has overflowed: then the error terms are NaN.
    fn checked(leading: f64, parts: (f64, f64)) -> Self {
        Self::of(if leading.is_finite() { parts } else { (leading, 0.0) })
    }

    /// a·b + c from all ten terms of the products: right to 2^−104 whatever cancels.
    fn exact_mul_add(&self, factor: &Self, addend: &Self) -> Self {
        let mut terms = [0.0; 10];
        let pairs = [
            (self.low, factor.low),
            (self.low, factor.high),
            (self.high, factor.low),
            (self.high, factor.high),
        ];
        for (index, (a, b)) in pairs.into_iter().enumerate() {
            let (product, error) = two_product(a, b);
            terms[2 * index] = error;
            terms[2 * index + 1] = product;
        }
        terms[8] = addend.low;
        terms[9] = addend.high;
        Self::of(sum_of(&terms))
    }
}

operators!(DoubleDouble);

impl From<f64> for DoubleDouble {
    fn from(float: f64) -> Self {
        Self { high: float, low: 0.0 }
    }
}

impl PartialOrd for DoubleDouble {
    /// Exact; `None` if either is not finite.
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        if !self.is_finite() || !other.is_finite() {
            return None;
        }
        // The high part is the rounded sum, and rounding is monotone.
        let high = self.high.partial_cmp(&other.high)?;
        Some(high.then(self.low.partial_cmp(&other.low)?))
    }
}

impl fmt::Display for DoubleDouble {
    /// 31 significant digits: every decimal of so many comes back as it was written.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self.to_rational() {
            Ok(exact) => f.write_str(&significant(&exact, 31)),
            Err(_) => write!(f, "{}", self.high),
        }
    }
}

impl Number for DoubleDouble {
    type Wide = Scaled;

    /// Exact, unless the parts lie more than 2^1000 apart.
    fn widen(&self) -> Scaled {
        Scaled::from(*self)
    }

    fn narrow(wide: &Scaled) -> Self {
        wide.to_double_double()
    }

    fn zero() -> Self {
        Self::from(0.0)
    }

    fn one() -> Self {
        Self::from(1.0)
    }

    /// The nearest float, and the float nearest to the rest: relative error at most u²/2 unless
    /// the rest underflows. Beyond the range of `f64` not finite.
    fn from_rational(exact: &Rational) -> Self {
        let high: f64 = encode(exact, Rounding::NearestEven);
        match decode(high) {
            // Near a tie the rest may round to the tie itself, and then the other float is high.
            Ok(taken) => {
                Self::of(fast_two_sum(high, encode(&(exact - taken), Rounding::NearestEven)))
            }
            Err(_) => Self::from(high),
        }
    }

    /// To the working precision, relative error at most 32u², whatever cancels; not one rounding.
    ///
    /// Where the sum keeps a quarter of the product, the two bounds above give
    /// 4·7u² + 3u² + …; where it does not, all the terms are added without error.
    fn mul_add(&self, factor: &Self, addend: &Self) -> Self {
        let product = self.product(factor);
        let sum = product.sum(addend);
        if sum.high.abs() >= 0.25 * product.high.abs() || !sum.is_finite() {
            return sum;
        }
        self.exact_mul_add(factor, addend)
    }

    fn checked_div(&self, divisor: &Self) -> Option<Self> {
        (divisor.high != 0.0).then(|| self.quotient(divisor))
    }

    fn is_finite(&self) -> bool {
        self.high.is_finite()
    }
}

impl Ordered for DoubleDouble {
    fn compare(&self, other: &Self) -> Comparison {
        self.partial_cmp(other).into()
    }
}

impl Real for DoubleDouble {
    type WideReal = Scaled;

    works_in_itself!();

    /// Solved in [`Scaled`] and rounded.
    fn greatest_root(coefficients: &[Self], lower: &Self, upper: &Self) -> Option<Self> {
        let wide: Vec<Scaled> = coefficients.iter().map(Number::widen).collect();
        Scaled::greatest_root(&wide, &lower.widen(), &upper.widen()).map(|root| Self::narrow(&root))
    }
}
