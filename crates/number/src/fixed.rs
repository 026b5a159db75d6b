//! Exact numbers without allocation: integers of some words times a power of two.

mod gcd;
#[cfg(test)]
mod model;

use std::cmp::Ordering;

use num_bigint::{BigUint, Sign};

use crate::Integer;

/// An integer of at most `LIMBS` words of 64 bits, times 2^exponent, or the admission that it does not
/// fit; 1024 bits unless it is said.
///
/// Exact: each operation checks that its result has room before it writes, and gives up for good if
/// not. Nothing is ever dropped, so no bound on the exponents of the inputs has to be believed.
/// The integer is not normalised: 4·2⁰ and 1·2² are one number.
#[derive(Clone, Copy, Debug)]
pub struct Fixed<const LIMBS: usize = 16> {
    negative: bool,
    fits: bool,
    /// Limbs in use: the last of them is not 0, and those beyond are.
    len: usize,
    exponent: i64,
    limbs: [u64; LIMBS],
}

/// a + b + carry: the low half, and what is carried on.
const fn carrying_add(a: u64, b: u64, carry: bool) -> (u64, bool) {
    let (sum, first) = a.overflowing_add(b);
    let (sum, second) = sum.overflowing_add(carry as u64);
    (sum, first | second)
}

const fn borrowing_sub(a: u64, b: u64, borrow: bool) -> (u64, bool) {
    let (difference, first) = a.overflowing_sub(b);
    let (difference, second) = difference.overflowing_sub(borrow as u64);
    (difference, first | second)
}

/// a·b + c + d, which fits: the low half and the high half.
#[expect(clippy::cast_possible_truncation, reason = "the halves of a wide number are meant")]
const fn multiply_add(a: u64, b: u64, c: u64, d: u64) -> (u64, u64) {
    let wide = a as u128 * b as u128 + c as u128 + d as u128;
    (wide as u64, (wide >> 64) as u64)
}

impl<const LIMBS: usize> Fixed<LIMBS> {
    pub(crate) const ZERO: Self =
        Self { negative: false, fits: true, len: 0, exponent: 0, limbs: [0; LIMBS] };
    pub(crate) const ONE: Self = {
        let mut one = Self { len: 1, ..Self::ZERO };
        one.limbs[0] = 1;
        one
    };
    const LOST: Self = Self { fits: false, ..Self::ZERO };

    /// ±mantissa·2^exponent.
    #[must_use]
    pub fn new(negative: bool, mantissa: u64, exponent: i64) -> Self {
        let mut limbs = [0; LIMBS];
        limbs[0] = mantissa;
        let len = usize::from(mantissa != 0);
        Self { negative: negative && mantissa != 0, fits: true, len, exponent, limbs }
    }

    /// An integer, which may be too long.
    #[must_use]
    pub fn of(integer: &Integer) -> Self {
        let digits = integer.magnitude().iter_u64_digits();
        if digits.len() > LIMBS {
            return Self::LOST;
        }
        let negative = integer.sign() == Sign::Minus;
        let mut fixed = Self { negative, len: digits.len(), ..Self::ZERO };
        fixed.limbs.iter_mut().zip(digits).for_each(|(limb, digit)| *limb = digit);
        fixed
    }

    /// The same number with room for another length, if it fits.
    pub(crate) fn resized<const OTHER: usize>(&self) -> Fixed<OTHER> {
        let Self { negative, fits, len, exponent, limbs } = self;
        if !fits || *len > OTHER {
            return Fixed::LOST;
        }
        let mut resized =
            Fixed { negative: *negative, len: *len, exponent: *exponent, ..Fixed::ZERO };
        resized.limbs[..*len].copy_from_slice(&limbs[..*len]);
        resized
    }

    /// The integer without its power of two.
    #[must_use]
    pub fn to_integer(&self) -> Integer {
        let halves = |limb: &u64| [*limb & u64::from(u32::MAX), *limb >> 32];
        let digits = self.limbs[..self.len].iter().flat_map(halves);
        let digits = digits.map(|half| u32::try_from(half).unwrap_or(0)).collect();
        let sign = if self.negative { Sign::Minus } else { Sign::Plus };
        Integer::from_biguint(sign, BigUint::new(digits))
    }

    /// Whether every operation so far had room.
    #[must_use]
    pub const fn fits(&self) -> bool {
        self.fits
    }

    /// The integer's limbs with the least first, whether it is negative, and the exponent of two.
    #[must_use]
    pub fn integer(&self) -> (&[u64], bool, i64) {
        (&self.limbs[..self.len], self.negative, self.exponent)
    }

    /// The exponent of the power of two.
    #[must_use]
    pub const fn exponent(&self) -> i64 {
        self.exponent
    }

    /// The same integer with another exponent.
    #[must_use]
    pub fn scaled(&self, exponent: i64) -> Self {
        Self { exponent, ..*self }
    }

    /// Whether it is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.len == 0
    }

    /// How many bits the integer has.
    #[must_use]
    pub fn bits(&self) -> u32 {
        let Some(top) = self.limbs[..self.len].last() else { return 0 };
        64 * u32::try_from(self.len).unwrap_or(u32::MAX) - top.leading_zeros()
    }

    /// The same number with the integer shifted up to a smaller exponent; zero has any exponent.
    #[must_use]
    pub fn with_exponent(&self, exponent: i64) -> Self {
        let shift = self.exponent - exponent;
        if shift == 0 || self.is_zero() {
            return self.scaled(exponent);
        }
        let room = 64 * i64::try_from(LIMBS).unwrap_or(0) - i64::from(self.bits());
        let (Ok(places), true) = (usize::try_from(shift), shift <= room) else {
            return Self::LOST;
        };
        let (whole, part) = (places / 64, places % 64);
        let mut shifted = Self { exponent, len: self.len + whole, ..*self };
        shifted.limbs = [0; LIMBS];
        if part == 0 {
            shifted.limbs[whole..whole + self.len].copy_from_slice(&self.limbs[..self.len]);
            return shifted;
        }
        let mut carried = 0;
        for (limb, out) in self.limbs[..self.len].iter().zip(&mut shifted.limbs[whole..]) {
            *out = limb << part | carried;
            carried = limb >> (64 - part);
        }
        if carried != 0 {
            shifted.limbs[shifted.len] = carried;
            shifted.len += 1;
        }
        shifted
    }

    fn compare_magnitudes(&self, other: &Self) -> Ordering {
        self.len.cmp(&other.len).then_with(|| {
            let (mine, its) = (&self.limbs[..self.len], &other.limbs[..self.len]);
            mine.iter().rev().cmp(its.iter().rev())
        })
    }

    /// |self| + |other| with the sign of self; equal exponents.
    fn add_magnitudes(&self, other: &Self) -> Self {
        let mut sum = *self;
        sum.len = self.len.max(other.len);
        let mut carry = false;
        for (limb, addend) in sum.limbs[..sum.len].iter_mut().zip(&other.limbs) {
            (*limb, carry) = carrying_add(*limb, *addend, carry);
        }
        if carry {
            let Some(next) = sum.limbs.get_mut(sum.len) else { return Self::LOST };
            *next = 1;
            sum.len += 1;
        }
        sum
    }

    /// |self| − |other| with the sign of self; equal exponents, |self| > |other|.
    fn subtract_magnitudes(&self, other: &Self) -> Self {
        let mut difference = *self;
        let mut borrow = false;
        for (limb, part) in difference.limbs[..self.len].iter_mut().zip(&other.limbs) {
            (*limb, borrow) = borrowing_sub(*limb, *part, borrow);
        }
        let used = difference.limbs[..self.len].iter().rposition(|&limb| limb != 0);
        difference.len = used.map_or(0, |top| top + 1);
        difference
    }

    /// The same number with an odd integer, or zero.
    pub(crate) fn odd(&self) -> Self {
        if !self.fits {
            return Self::LOST;
        }
        let used = &self.limbs[..self.len];
        let Some(whole) = used.iter().position(|&limb| limb != 0) else { return Self::ZERO };
        let part = used[whole].trailing_zeros();
        if whole == 0 && part == 0 {
            return *self;
        }
        let twos = 64 * i64::try_from(whole).unwrap_or(0) + i64::from(part);
        let mut odd = Self { limbs: [0; LIMBS], exponent: self.exponent + twos, ..*self };
        let above = used[whole..].iter().skip(1).chain([&0]);
        for ((out, &limb), &next) in odd.limbs.iter_mut().zip(&used[whole..]).zip(above) {
            *out = if part == 0 { limb } else { limb >> part | next << (64 - part) };
        }
        odd.len = self.len - whole;
        odd.trim();
        odd
    }

    /// Forgets limbs at the top that are 0.
    fn trim(&mut self) {
        let top = self.limbs[..self.len].iter().rposition(|limb| *limb != 0);
        self.len = top.map_or(0, |top| top + 1);
    }

    /// The integer alone, without sign and exponent.
    fn magnitude(&self) -> Self {
        Self { negative: false, exponent: 0, ..*self }
    }

    /// The greatest common divisor of two odd integers, positive. Exact.
    pub(crate) fn gcd(&self, other: &Self) -> Self {
        gcd::greatest_common_divisor(self, other)
    }

    /// The integer over an odd one that divides it, with the same sign and exponent. Exact.
    pub(crate) fn exact_quotient(&self, divisor: &Self) -> Self {
        gcd::exact_quotient(self, divisor)
    }

    /// Whether the integer is 1 or −1.
    pub(crate) fn is_unit(&self) -> bool {
        self.len == 1 && self.limbs[0] == 1
    }

    /// The number with the other sign. Exact.
    #[must_use]
    pub fn negated(&self) -> Self {
        Self { negative: !self.negative && self.len > 0, ..*self }
    }

    /// The sum. Exact, if it fits.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        if !(self.fits && other.fits) {
            return Self::LOST;
        }
        if self.is_zero() {
            return *other;
        }
        if other.is_zero() {
            return *self;
        }
        let exponent = self.exponent.min(other.exponent);
        let (a, b) = (self.with_exponent(exponent), other.with_exponent(exponent));
        if !(a.fits && b.fits) {
            return Self::LOST;
        }
        if a.negative == b.negative {
            return a.add_magnitudes(&b);
        }
        match a.compare_magnitudes(&b) {
            Ordering::Greater => a.subtract_magnitudes(&b),
            Ordering::Less => b.subtract_magnitudes(&a),
            Ordering::Equal => Self::ZERO,
        }
    }

    /// The difference. Exact, if it fits.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// The product. Exact, if it fits.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        if !(self.fits && other.fits) {
            return Self::LOST;
        }
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        let (negative, exponent) =
            (self.negative != other.negative, self.exponent + other.exponent);
        if self.is_unit() || other.is_unit() {
            let factor = if self.is_unit() { other } else { self };
            return Self { negative, exponent, ..*factor };
        }
        if self.len + other.len > LIMBS {
            return Self::LOST;
        }
        let mut limbs = [0; LIMBS];
        for (at, &factor) in self.limbs[..self.len].iter().enumerate() {
            let mut carry = 0;
            let (row, above) = limbs[at..].split_at_mut(other.len);
            for (out, &limb) in row.iter_mut().zip(&other.limbs[..other.len]) {
                (*out, carry) = multiply_add(factor, limb, *out, carry);
            }
            above[0] = carry; // at + other.len < self.len + other.len ≤ LIMBS
        }
        let full = self.len + other.len;
        Self {
            negative,
            fits: true,
            len: if limbs[full - 1] == 0 { full - 1 } else { full },
            exponent,
            limbs,
        }
    }

    /// The absolute value. Exact.
    #[must_use]
    pub fn abs(&self) -> Self {
        Self { negative: false, ..*self }
    }

    /// Twice the number. Exact.
    #[must_use]
    pub fn doubled(&self) -> Self {
        if self.is_zero() { *self } else { Self { exponent: self.exponent + 1, ..*self } }
    }

    /// How it compares with zero, or `None` if it did not fit. Exact.
    #[must_use]
    pub fn sign(&self) -> Option<Ordering> {
        self.fits.then_some(match (self.is_zero(), self.negative) {
            (true, _) => Ordering::Equal,
            (false, true) => Ordering::Less,
            (false, false) => Ordering::Greater,
        })
    }
}
