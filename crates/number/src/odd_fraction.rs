//! Exact fractions for a chain of operations.

use std::cmp::Ordering;
use std::fmt;

use num_traits::{Signed as _, Zero as _};

use crate::operators::{operators, works_in_itself};
use crate::root::rational::greatest_root;
use crate::{Comparison, Fixed, Integer, Number, Ordered, Rational, Real};

/// Words of n and of d that are copied about, and words for which a place on the heap is worth it.
const FEW: usize = 8;
const MANY: usize = 16;

/// An exact fraction n/d·2^e with odd coprime n and d > 0, or zero; without the heap while n and d
/// have at most 512 bits each, in one piece up to 1024, and a [`Rational`] beyond.
///
/// The [working system](Real::Working) of [`Rational`]. Powers of two, which are all that stands under
/// floats, cost no division, and products and sums take the greatest common divisors of their parts,
/// which are shorter than those of the result (Henrici 1956; Knuth, TAOCP 2, section 4.5.1).
///
/// ```
/// use kane_number::{Number, OddFraction, parse};
/// let sum = OddFraction::from_rational(&parse("1/3")?) + OddFraction::from_rational(&parse("1/6")?);
/// assert_eq!(sum.to_rational(), parse("1/2")?);
/// # Ok::<(), kane_number::ParseError>(())
/// ```
#[derive(Clone, Debug)]
pub struct OddFraction(Kind);

#[derive(Clone, Debug)]
enum Kind {
    Short(Odd<FEW>),
    Wide(Box<Odd<MANY>>),
    Long(Rational),
}

/// The parts, each of which fits: odd and coprime, the power of two and the sign with the first;
/// zero is 0/1.
#[derive(Clone, Copy, Debug)]
struct Odd<const LIMBS: usize> {
    numer: Fixed<LIMBS>,
    denom: Fixed<LIMBS>,
}

impl<const LIMBS: usize> Odd<LIMBS> {
    /// Parts that are odd and coprime, if they fit.
    #[inline]
    fn of(numer: Fixed<LIMBS>, denom: Fixed<LIMBS>) -> Option<Self> {
        (numer.fits() && denom.fits()).then_some(Self { numer, denom })
    }

    fn from_rational(exact: &Rational) -> Option<Self> {
        let (numer, denom) = (Fixed::of(exact.numer()).odd(), Fixed::of(exact.denom()).odd());
        let exponent = numer.exponent() - denom.exponent();
        Self::of(numer.scaled(if numer.is_zero() { 0 } else { exponent }), denom.scaled(0))
    }

    /// The same parts with room for another length, if they fit.
    fn resized<const OTHER: usize>(&self) -> Option<Odd<OTHER>> {
        Odd::of(self.numer.resized(), self.denom.resized())
    }

    fn rational(&self) -> Rational {
        let power = self.numer.exponent();
        let (up, down) = (power.max(0), (-power).max(0));
        Rational::new_raw(written_out(&self.numer, up), written_out(&self.denom, down))
    }

    fn opposite(self) -> Self {
        Self { numer: self.numer.negated(), ..self }
    }

    /// (n/g)/(d/h) · (m/h)/(c/g) with g = gcd(n, c) and h = gcd(m, d).
    #[inline]
    fn product(&self, other: &Self) -> Option<Self> {
        if self.numer.is_zero() || other.numer.is_zero() {
            return Some(Self { numer: Fixed::ZERO, denom: Fixed::ONE });
        }
        if self.denom.is_unit() && other.denom.is_unit() {
            return Self::of(self.numer.times(&other.numer), Fixed::ONE);
        }
        let (n, c, _) = without_common(&self.numer, &other.denom);
        let (m, d, _) = without_common(&other.numer, &self.denom);
        Self::of(n.times(&m), d.times(&c))
    }

    /// 1 over the number, which is not zero.
    fn inverse(&self) -> Self {
        let sign = self.numer.sign() == Some(Ordering::Less);
        let numer = self.denom.scaled(-self.numer.exponent());
        let numer = if sign { numer.negated() } else { numer };
        Self { numer, denom: self.numer.abs().scaled(0) }
    }

    fn difference(&self, other: &Self) -> Option<Self> {
        self.sum(&other.opposite())
    }

    /// `None` also by zero.
    fn quotient(&self, other: &Self) -> Option<Self> {
        if other.numer.is_zero() { None } else { self.product(&other.inverse()) }
    }

    /// With g = gcd(d, c), the sum is t/(d·c/g) for t = n·c/g + m·d/g, and what t has in common with
    /// d·c/g divides g.
    #[inline]
    fn sum(&self, other: &Self) -> Option<Self> {
        if self.numer.is_zero() || other.numer.is_zero() {
            return Some(if self.numer.is_zero() { *other } else { *self });
        }
        if self.denom.is_unit() && other.denom.is_unit() {
            return Self::of(self.numer.plus(&other.numer).odd(), Fixed::ONE);
        }
        let (d, c, common) = without_common(&self.denom, &other.denom);
        let sum = self.numer.times(&c).plus(&other.numer.times(&d)).odd();
        match sum.sign()? {
            Ordering::Equal => Some(Self { numer: Fixed::ZERO, denom: Fixed::ONE }),
            _ if common.is_unit() => Self::of(sum, d.times(&c)),
            _ => {
                let (numer, common, _) = without_common(&sum, &common);
                Self::of(numer, d.times(&c).times(&common))
            }
        }
    }
}

/// Both without their greatest common divisor, and that; both are odd, and none of them zero.
#[inline]
fn without_common<const LIMBS: usize>(
    a: &Fixed<LIMBS>,
    b: &Fixed<LIMBS>,
) -> (Fixed<LIMBS>, Fixed<LIMBS>, Fixed<LIMBS>) {
    if a.is_unit() || b.is_unit() {
        return (*a, *b, Fixed::ONE);
    }
    let common = a.gcd(b);
    (a.exact_quotient(&common), b.exact_quotient(&common), common)
}

/// An integer times a power of two.
fn written_out<const LIMBS: usize>(integer: &Fixed<LIMBS>, power: i64) -> Integer {
    let whole = integer.scaled(power).with_exponent(0);
    if whole.fits() { whole.to_integer() } else { integer.to_integer() << power.unsigned_abs() }
}

impl OddFraction {
    /// The same number with both integers written out. Exact.
    #[must_use]
    pub fn to_rational(&self) -> Rational {
        match &self.0 {
            Kind::Short(short) => short.rational(),
            Kind::Wide(wide) => wide.rational(),
            Kind::Long(long) => long.clone(),
        }
    }

    /// The result in the shortest form that both operands and the result have room in.
    #[inline]
    fn either(
        &self,
        other: &Self,
        short: impl Fn(&Odd<FEW>, &Odd<FEW>) -> Option<Odd<FEW>>,
        wide: impl Fn(&Odd<MANY>, &Odd<MANY>) -> Option<Odd<MANY>>,
        long: impl Fn(Rational, Rational) -> Rational,
    ) -> Self {
        if let (Kind::Short(a), Kind::Short(b)) = (&self.0, &other.0)
            && let Some(result) = short(a, b)
        {
            return Self(Kind::Short(result));
        }
        if let (Some(a), Some(b)) = (self.wide(), other.wide())
            && let Some(result) = wide(&a, &b)
        {
            return Self::of_wide(result);
        }
        Self::from_rational(&long(self.to_rational(), other.to_rational()))
    }

    fn wide(&self) -> Option<Odd<MANY>> {
        match &self.0 {
            Kind::Short(short) => short.resized(),
            Kind::Wide(wide) => Some(**wide),
            Kind::Long(_) => None,
        }
    }

    fn of_wide(wide: Odd<MANY>) -> Self {
        Self(wide.resized().map_or_else(|| Kind::Wide(Box::new(wide)), Kind::Short))
    }

    fn sum(&self, other: &Self) -> Self {
        self.either(other, Odd::sum, Odd::sum, |a, b| a + b)
    }

    fn difference(&self, other: &Self) -> Self {
        self.either(other, Odd::difference, Odd::difference, |a, b| a - b)
    }

    fn product(&self, other: &Self) -> Self {
        self.either(other, Odd::product, Odd::product, |a, b| a * b)
    }

    /// Panics on a division by zero, as [`Rational`] does.
    fn quotient(&self, other: &Self) -> Self {
        self.either(other, Odd::quotient, Odd::quotient, |a, b| a / b)
    }

    fn opposite(self) -> Self {
        Self(match self.0 {
            Kind::Short(short) => Kind::Short(short.opposite()),
            Kind::Wide(wide) => Kind::Wide(Box::new(wide.opposite())),
            Kind::Long(long) => Kind::Long(-long),
        })
    }

    /// How it compares with zero.
    fn signum(&self) -> Ordering {
        match &self.0 {
            Kind::Short(short) => short.numer.sign().unwrap_or(Ordering::Equal),
            Kind::Wide(wide) => wide.numer.sign().unwrap_or(Ordering::Equal),
            Kind::Long(long) if long.is_negative() => Ordering::Less,
            Kind::Long(long) if long.is_zero() => Ordering::Equal,
            Kind::Long(_) => Ordering::Greater,
        }
    }
}

operators!(OddFraction);

impl PartialEq for OddFraction {
    fn eq(&self, other: &Self) -> bool {
        self.difference(other).signum().is_eq()
    }
}

impl fmt::Display for OddFraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.to_rational().fmt(f)
    }
}

impl Number for OddFraction {
    type Wide = Self;

    const IS_EXACT: bool = true;

    fn widen(&self) -> Self {
        self.clone()
    }

    fn narrow(wide: &Self) -> Self {
        wide.clone()
    }

    fn zero() -> Self {
        Self(Kind::Short(Odd { numer: Fixed::ZERO, denom: Fixed::ONE }))
    }

    fn one() -> Self {
        Self(Kind::Short(Odd { numer: Fixed::ONE, denom: Fixed::ONE }))
    }

    fn from_rational(exact: &Rational) -> Self {
        if let Some(short) = Odd::from_rational(exact) {
            return Self(Kind::Short(short));
        }
        let wide = Odd::from_rational(exact);
        wide.map_or_else(|| Self(Kind::Long(exact.clone())), Self::of_wide)
    }

    fn mul_add(&self, factor: &Self, addend: &Self) -> Self {
        self.product(factor).sum(addend)
    }

    fn checked_div(&self, divisor: &Self) -> Option<Self> {
        divisor.signum().is_ne().then(|| self.quotient(divisor))
    }

    fn is_finite(&self) -> bool {
        true
    }

    fn double(&self) -> Self {
        match &self.0 {
            Kind::Short(short) => Self(Kind::Short(Odd { numer: short.numer.doubled(), ..*short })),
            _ => self.sum(self),
        }
    }
}

impl Ordered for OddFraction {
    fn compare(&self, other: &Self) -> Comparison {
        self.difference(other).signum().into()
    }

    fn sign(&self) -> Comparison {
        self.signum().into()
    }
}

impl Real for OddFraction {
    type WideReal = Self;

    works_in_itself!();

    /// Exact; `None` if the root is irrational.
    fn greatest_root(coefficients: &[Self], lower: &Self, upper: &Self) -> Option<Self> {
        let coefficients: Vec<Rational> = coefficients.iter().map(Self::to_rational).collect();
        let (lower, upper) = (lower.to_rational(), upper.to_rational());
        let root = Rational::greatest_root(&coefficients, &lower, &upper)?;
        Some(Self::from_rational(&root))
    }
}

impl Real for Rational {
    type WideReal = Self;
    type Working = OddFraction;

    fn to_working(&self) -> OddFraction {
        OddFraction::from_rational(self)
    }

    fn from_working(working: &OddFraction) -> Self {
        working.to_rational()
    }

    /// Exact; `None` if the root is irrational.
    fn greatest_root(coefficients: &[Self], lower: &Self, upper: &Self) -> Option<Self> {
        greatest_root(coefficients, lower, upper)
    }
}
