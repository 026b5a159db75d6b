//! Quotients of exact integers that are never reduced.

use std::cmp::Ordering;

use kane_number::{Fixed, Integer, Rational, Rounding, encode};

use super::dyadic::Dyadic;

/// An exact quotient of two integers times a power of two, not in lowest terms.
///
/// The integers have at most 1024 bits each if that suffices, and are of any size otherwise. Nothing
/// is rounded, and no gcd is taken until [`to_rational`](Self::to_rational) asks for one.
#[derive(Clone, Debug)]
pub struct Fraction(Terms);

#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "the large variant is there to avoid the heap")]
enum Terms {
    Fixed { numer: Fixed, denom: Fixed },
    Big { numer: Dyadic, denom: Dyadic },
}

impl Fraction {
    /// numer/denom with denom > 0, or `None` if one of them did not fit.
    pub(crate) fn fixed(numer: Fixed, denom: Fixed) -> Option<Self> {
        (numer.fits() && denom.sign() == Some(Ordering::Greater))
            .then_some(Self(Terms::Fixed { numer, denom }))
    }

    /// numer/denom with denom > 0.
    pub(crate) const fn big(numer: Dyadic, denom: Dyadic) -> Self {
        Self(Terms::Big { numer, denom })
    }

    /// Whether 1024 bits sufficed.
    #[must_use]
    pub const fn is_fixed(&self) -> bool {
        matches!(self.0, Terms::Fixed { .. })
    }

    /// The same number in lowest terms. Exact; the only place where a gcd is taken.
    #[must_use]
    pub fn to_rational(&self) -> Rational {
        let (numer, denom) = self.integers();
        Rational::new(numer, denom)
    }

    /// The nearest float; halfway, the one whose last bit is 0. Correctly rounded for every
    /// exponent; beyond the range ±∞.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        if let Terms::Fixed { numer, denom } = &self.0
            && let Some(float) = nearest(numer, denom)
        {
            return float;
        }
        let (numer, denom) = self.integers();
        // `encode` looks at the quotient alone
        encode(&Rational::new_raw(numer, denom), Rounding::NearestEven)
    }

    /// Numerator and denominator with the powers of two multiplied in.
    fn integers(&self) -> (Integer, Integer) {
        let ((numer, up), (denom, down)) = match &self.0 {
            Terms::Fixed { numer, denom } => {
                ((numer.to_integer(), numer.exponent()), (denom.to_integer(), denom.exponent()))
            }
            Terms::Big { numer, denom } => {
                ((numer.integer.clone(), numer.exponent), (denom.integer.clone(), denom.exponent))
            }
        };
        let (shift, places) = (up - down, up.abs_diff(down));
        if shift >= 0 { (numer << places, denom) } else { (numer, denom << places) }
    }
}

/// The float nearest to numer/denom, or `None` if the division has no room.
fn nearest(numer: &Fixed, denom: &Fixed) -> Option<f64> {
    if numer.is_zero() {
        return Some(0.0);
    }
    // With the exponents left out, numer·2^up / denom·2^down is between 2⁶² and 2⁶⁴.
    let shift = i64::from(denom.bits()) + 63 - i64::from(numer.bits());
    let (up, down) = (shift.max(0), (-shift).max(0));
    let dividend = numer.abs().scaled(up).with_exponent(0);
    let divisor = denom.scaled(down).with_exponent(0);
    if !(dividend.fits() && divisor.fits()) {
        return None;
    }
    let (quotient, exact) = divide(&dividend, &divisor)?;
    let exponent = numer.exponent() - denom.exponent() - shift;
    let (_, negative, _) = numer.integer();
    Some(round(negative, quotient, exact, exponent))
}

/// The integer part of a quotient between 2⁶² and 2⁶⁴, and whether nothing is left.
fn divide(dividend: &Fixed, divisor: &Fixed) -> Option<(u64, bool)> {
    // The divisor's leading 64 bits, and as much of the dividend: off by at most 2 either way.
    let cut = i64::from(divisor.bits()) - 64;
    let guess = leading(dividend, cut) / leading(divisor, cut);
    let mut quotient = u64::try_from(guess).unwrap_or(u64::MAX);
    let mut rest = dividend.minus(&Fixed::new(false, quotient, 0).times(divisor));
    while rest.sign()? == Ordering::Less {
        (quotient, rest) = (quotient - 1, rest.plus(divisor));
    }
    loop {
        let less = rest.minus(divisor);
        if less.sign()? == Ordering::Less {
            return Some((quotient, rest.is_zero()));
        }
        (quotient, rest) = (quotient + 1, less);
    }
}

/// The integer over 2^cut without its fraction, of which at most 127 bits are left.
fn leading(fixed: &Fixed, cut: i64) -> u128 {
    let (limbs, ..) = fixed.integer();
    let limb = |index: usize| u128::from(limbs.get(index).copied().unwrap_or(0));
    let Ok(cut) = u32::try_from(cut) else {
        return (limb(0) | limb(1) << 64) << cut.unsigned_abs();
    };
    let (whole, part) = ((cut / 64) as usize, cut % 64);
    let low = (limb(whole) | limb(whole + 1) << 64) >> part;
    if part == 0 { low } else { low | limb(whole + 2) << (128 - part) }
}

/// The float nearest to ±(integer + something below 1 unless exact)·2^exponent, where the integer
/// has at least 62 bits.
fn round(negative: bool, integer: u64, exact: bool, exponent: i64) -> f64 {
    let binade = exponent + 63 - i64::from(integer.leading_zeros());
    let magnitude = if binade > 1023 {
        f64::INFINITY.to_bits()
    } else {
        let unit = (binade - 52).max(-1074);
        // what is below a quarter of a unit rounds to 0 whatever its size
        let drop = (unit - exponent).min(67);
        let (wide, half) = (u128::from(integer), 1_u128 << (drop - 1));
        let (floor, rest) = (wide >> drop, wide & (2 * half - 1));
        let up = match rest.cmp(&half) {
            Ordering::Less => false,
            Ordering::Equal => !exact || floor % 2 == 1,
            Ordering::Greater => true,
        };
        // the hidden bit and a carry both land in the exponent field
        let steps = (unit + 1074).unsigned_abs() << 52;
        steps + u64::try_from(floor).unwrap_or(0) + u64::from(up)
    };
    f64::from_bits(magnitude | u64::from(negative) << 63)
}
