//! The exact stage without allocation: integers of at most 1024 bits times a power of two.

use std::cmp::Ordering;

use super::arithmetic::Arithmetic;

const LIMBS: usize = 16;
const BITS: i64 = 1024;

/// An integer n with |n| < 2^1024 times 2^exponent, or the admission that it does not fit.
///
/// Exact: each operation checks that its result has room before it writes, and gives up for good if
/// not. Nothing is ever dropped, so no bound on the exponents of the inputs has to be believed.
/// There is no division and no gcd.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fixed {
    negative: bool,
    fits: bool,
    /// Limbs in use: the last of them is not 0, and those beyond are.
    len: usize,
    exponent: i64,
    limbs: [u64; LIMBS],
}

/// (M, E) with |float| = M·2^E and M odd or 0, and whether the sign bit is set. For finite floats.
pub(super) const fn parts(float: f64) -> (bool, u64, i64) {
    let bits = float.to_bits();
    let (fraction, biased) = (bits & ((1 << 52) - 1), (bits >> 52 & 0x7ff).cast_signed());
    let (mantissa, exponent) =
        if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
    if mantissa == 0 {
        return (false, 0, 0);
    }
    let twos = mantissa.trailing_zeros();
    (bits >> 63 == 1, mantissa >> twos, exponent + twos as i64)
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

impl Fixed {
    const ZERO: Self = Self { negative: false, fits: true, len: 0, exponent: 0, limbs: [0; LIMBS] };
    const LOST: Self = Self { fits: false, ..Self::ZERO };

    /// Whether every operation so far had room.
    pub(super) const fn fits(&self) -> bool {
        self.fits
    }

    /// The integer's limbs with the least first, whether it is negative, and the exponent of two.
    pub(super) fn integer(&self) -> (&[u64], bool, i64) {
        (&self.limbs[..self.len], self.negative, self.exponent)
    }

    /// A positive integer.
    pub(super) fn integral(value: u64) -> Self {
        let mut limbs = [0; LIMBS];
        limbs[0] = value;
        Self { len: usize::from(value != 0), limbs, ..Self::ZERO }
    }

    /// The same integer with another exponent.
    pub(super) fn scaled(&self, exponent: i64) -> Self {
        Self { exponent, ..*self }
    }

    pub(super) fn is_zero(&self) -> bool {
        self.len == 0
    }

    /// How many bits the integer has.
    pub(super) fn bits(&self) -> u32 {
        let Some(top) = self.limbs[..self.len].last() else { return 0 };
        64 * u32::try_from(self.len).unwrap_or(u32::MAX) - top.leading_zeros()
    }

    /// The same number with the integer shifted up to a smaller exponent.
    pub(super) fn with_exponent(&self, exponent: i64) -> Self {
        let shift = self.exponent - exponent;
        if shift == 0 {
            return *self;
        }
        let room = BITS - i64::from(self.bits());
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

    fn negated(&self) -> Self {
        Self { negative: !self.negative && self.len > 0, ..*self }
    }
}

impl Arithmetic for Fixed {
    fn number(input: f64) -> Self {
        let (negative, mantissa, exponent) = parts(input);
        let mut limbs = [0; LIMBS];
        limbs[0] = mantissa;
        Self { negative, fits: true, len: usize::from(mantissa != 0), exponent, limbs }
    }

    fn plus(&self, other: &Self) -> Self {
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

    fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    fn times(&self, other: &Self) -> Self {
        if !(self.fits && other.fits) || self.len + other.len > LIMBS {
            return Self::LOST;
        }
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
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
            negative: self.negative != other.negative,
            fits: true,
            len: if limbs[full - 1] == 0 { full - 1 } else { full },
            exponent: self.exponent + other.exponent,
            limbs,
        }
    }

    fn abs(&self) -> Self {
        Self { negative: false, ..*self }
    }

    fn double(&self) -> Self {
        if self.is_zero() { *self } else { Self { exponent: self.exponent + 1, ..*self } }
    }

    fn sign(&self) -> Option<Ordering> {
        self.fits.then_some(match (self.is_zero(), self.negative) {
            (true, _) => Ordering::Equal,
            (false, true) => Ordering::Less,
            (false, false) => Ordering::Greater,
        })
    }
}
