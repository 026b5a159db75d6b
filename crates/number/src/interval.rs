//! Enclosures: what is certain in spite of rounding.
#![allow(clippy::float_arithmetic, reason = "the ends are floats, rounded outward")]

use std::fmt;

use crate::directed::{Outward, power_range, product, quotient, root, sum};
use crate::operators::{operators, works_in_itself};
use crate::{Comparison, NotFinite, Number, Ordered, Rational, Real, Rounding, decode, encode};

/// The real numbers between two floats, both included: lower ≤ x ≤ upper.
///
/// Every operation returns an interval that holds the result for every choice of operands from
/// the given ones; its ends are the exact ends rounded outward, and stay exact where they are
/// floats, so small integers and halves do not widen. (Products and quotients below 2^−960 may be a
/// step wider, since a rounding error may underflow there, and quotients next to the greatest float, where a product may
/// overflow; a fused product and sum rounds twice.)
///
/// The lower end may be −∞ and the upper +∞. Where nothing is known, as at a division by an
/// interval that contains 0 or from NaN, the interval is the whole line. It is never empty.
///
/// Comparison is three-valued: `[0, 1] ≥ 0` is certain, `[0, 1] > 0` is open, and equality is
/// certain for two equal points only.
///
/// ```
/// use kane_number::{Interval, Number, Ordered, parse};
/// let tenth = Interval::from_rational(&parse("0.1")?);
/// let sum = tenth + tenth + tenth;
/// assert!(sum.contains(&parse("0.3")?));
/// assert_eq!(sum.compare(&Interval::from(0.3)).is_equal(), None);
/// assert_eq!((sum + Interval::from(1.0)).sign().is_greater(), Some(true));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    lower: f64,
    upper: f64,
}

impl Interval {
    /// Every real number.
    pub const WHOLE: Self = Self { lower: f64::NEG_INFINITY, upper: f64::INFINITY };

    /// The interval between two floats in either order; the whole line if one is NaN. Exact.
    #[must_use]
    pub fn between(a: f64, b: f64) -> Self {
        if a.is_nan() || b.is_nan() {
            return Self::WHOLE;
        }
        // An infinite end is a bound that is never reached: a point there means "beyond MAX".
        let (lower, upper) = if a <= b { (a, b) } else { (b, a) };
        Self { lower: lower.min(f64::MAX), upper: upper.max(f64::MIN) }
    }

    /// The lower end.
    #[must_use]
    pub const fn lower(self) -> f64 {
        self.lower
    }

    /// The upper end.
    #[must_use]
    pub const fn upper(self) -> f64 {
        self.upper
    }

    /// Whether an exact number lies inside. Exact.
    #[must_use]
    pub fn contains(&self, exact: &Rational) -> bool {
        let above = match decode(self.lower) {
            Ok(lower) => lower <= *exact,
            Err(_) => true,
        };
        let below = match decode(self.upper) {
            Ok(upper) => *exact <= upper,
            Err(_) => true,
        };
        above && below
    }

    /// The exact ends.
    ///
    /// # Errors
    /// [`NotFinite`] if an end is infinite.
    pub fn ends(&self) -> Result<(Rational, Rational), NotFinite> {
        Ok((decode(self.lower)?, decode(self.upper)?))
    }

    /// upper − lower, rounded up; ∞ for an unbounded interval.
    #[must_use]
    pub fn width(&self) -> f64 {
        sum(self.upper, -self.lower, Outward::Up)
    }

    /// A float inside, near the middle: (lower + upper)/2 rounded where both are finite, 0 for
    /// the whole line, the greatest float in magnitude on a half line.
    #[must_use]
    pub fn midpoint(&self) -> f64 {
        f64::midpoint(self.lower.max(f64::MIN), self.upper.min(f64::MAX))
    }

    /// Whether this is a single float.
    #[must_use]
    pub fn is_point(&self) -> bool {
        self.lower == self.upper
    }

    /// Whether 0 is inside.
    #[must_use]
    pub fn contains_zero(&self) -> bool {
        self.lower <= 0.0 && 0.0 <= self.upper
    }

    /// The common part, or `None` if there is none. Exact.
    #[must_use]
    pub fn intersection(&self, other: &Self) -> Option<Self> {
        let (lower, upper) = (self.lower.max(other.lower), self.upper.min(other.upper));
        (lower <= upper).then_some(Self { lower, upper })
    }

    /// The least interval that holds both. Exact.
    #[must_use]
    pub fn hull(&self, other: &Self) -> Self {
        Self { lower: self.lower.min(other.lower), upper: self.upper.max(other.upper) }
    }

    /// The square roots of the numbers inside that are not negative, or `None` if all are.
    #[must_use]
    pub fn sqrt(&self) -> Option<Self> {
        (self.upper >= 0.0).then(|| Self {
            lower: root(self.lower.max(0.0), Outward::Down),
            upper: root(self.upper, Outward::Up),
        })
    }

    /// Halves the interval at its midpoint.
    pub(crate) fn halves(&self) -> (Self, Self) {
        let middle = self.midpoint();
        (Self { upper: middle, ..*self }, Self { lower: middle, ..*self })
    }

    fn opposite(self) -> Self {
        Self { lower: -self.upper, upper: -self.lower }
    }

    fn sum(&self, other: &Self) -> Self {
        Self {
            lower: sum(self.lower, other.lower, Outward::Down),
            upper: sum(self.upper, other.upper, Outward::Up),
        }
    }

    fn difference(&self, other: &Self) -> Self {
        self.sum(&other.opposite())
    }

    fn product(&self, other: &Self) -> Self {
        self.extremes(other, product)
    }

    fn quotient(&self, other: &Self) -> Self {
        if other.contains_zero() { Self::WHOLE } else { self.extremes(other, quotient) }
    }

    /// The extremes of an operation that is monotone in each operand: they are at the corners.
    fn extremes(&self, other: &Self, operation: fn(f64, f64, Outward) -> f64) -> Self {
        let corners = [
            (self.lower, other.lower),
            (self.lower, other.upper),
            (self.upper, other.lower),
            (self.upper, other.upper),
        ];
        let along = |direction| corners.map(|(a, b)| operation(a, b, direction));
        Self {
            lower: along(Outward::Down).into_iter().fold(f64::INFINITY, f64::min),
            upper: along(Outward::Up).into_iter().fold(f64::NEG_INFINITY, f64::max),
        }
    }
}

operators!(Interval);

impl From<f64> for Interval {
    /// The point; for ±∞ the half line beyond every finite float, for NaN the whole line.
    fn from(float: f64) -> Self {
        Self::between(float, float)
    }
}

impl fmt::Display for Interval {
    /// `[lower, upper]`, each end by the fewest digits that identify it.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let end = |float: f64| {
            let plain = float == 0.0 || (1e-5..1e17).contains(&float.abs());
            if plain || !float.is_finite() { format!("{float}") } else { format!("{float:e}") }
        };
        write!(f, "[{}, {}]", end(self.lower), end(self.upper))
    }
}

impl Number for Interval {
    type Wide = Self;

    fn widen(&self) -> Self {
        *self
    }

    fn narrow(wide: &Self) -> Self {
        *wide
    }

    fn zero() -> Self {
        Self::from(0.0)
    }

    fn one() -> Self {
        Self::from(1.0)
    }

    /// The tightest interval with float ends: a point where the rational is a float.
    fn from_rational(exact: &Rational) -> Self {
        Self { lower: encode(exact, Rounding::Down), upper: encode(exact, Rounding::Up) }
    }

    /// Product and sum, each rounded outward: an enclosure, wider than one rounding by a step.
    fn mul_add(&self, factor: &Self, addend: &Self) -> Self {
        self.product(factor).sum(addend)
    }

    /// `None` if the divisor contains 0.
    fn checked_div(&self, divisor: &Self) -> Option<Self> {
        (!divisor.contains_zero()).then(|| self.quotient(divisor))
    }

    /// Whether both ends are finite.
    fn is_finite(&self) -> bool {
        self.lower.is_finite() && self.upper.is_finite()
    }

    /// The squares of the numbers inside: never negative, as x·x of an unknown x might seem.
    fn square(&self) -> Self {
        let (least, most) = power_range(self.lower, self.upper);
        Self {
            lower: product(least, least, Outward::Down),
            upper: product(most, most, Outward::Up),
        }
    }
}

impl Ordered for Interval {
    fn compare(&self, other: &Self) -> Comparison {
        let (less, greater) = (self.lower < other.upper, self.upper > other.lower);
        let meet = self.intersection(other).is_some();
        Comparison::possible(less, meet, greater)
    }
}

impl Real for Interval {
    type WideReal = Self;

    works_in_itself!();

    /// An enclosure of the greatest root for every choice of coefficients and ends that keeps
    /// the promise; `None` if no root can lie between the ends.
    ///
    /// Rigorous, but wide where it cannot be told which of several roots is the greatest: about a
    /// double root the enclosure may reach from the lowest root to it.
    fn greatest_root(coefficients: &[Self], lower: &Self, upper: &Self) -> Option<Self> {
        crate::root::interval::greatest_root(coefficients, lower, upper)
    }
}
