//! The binary interchange formats, seen as bits.

/// An IEEE 754 binary format of at most 64 bits: `f32` (binary32) or `f64` (binary64).
///
/// A finite value is ±M·2^E with an integer M < 2^[`PRECISION`](Self::PRECISION) and
/// E ≥ [`LEAST_EXPONENT`](Self::LEAST_EXPONENT). Everything here moves bits; nothing rounds.
pub trait Binary: Copy {
    /// Bits of the significand, the hidden one included: 24 or 53.
    const PRECISION: u32;
    /// Exponent of the least subnormal, 2^−149 or 2^−1074; the unit of every subnormal.
    const LEAST_EXPONENT: i64;
    /// Exponent of the last binade, 127 or 1023: finite values are below 2^(this + 1).
    const GREATEST_EXPONENT: i64;

    /// The bit pattern of the magnitude, that is with the sign bit cleared, in the low bits.
    fn magnitude_bits(self) -> u64;

    /// Whether the sign bit is set; true for −0.
    fn is_negative(self) -> bool;

    /// The float with this sign and this magnitude pattern.
    fn from_magnitude_bits(negative: bool, bits: u64) -> Self;

    /// The magnitude pattern of infinity; larger patterns are NaN, smaller ones are finite.
    #[must_use]
    fn infinity_bits() -> u64 {
        let exponents = Self::GREATEST_EXPONENT.unsigned_abs() * 2 + 1;
        exponents << (Self::PRECISION - 1)
    }
}

impl Binary for f32 {
    const PRECISION: u32 = 24;
    const LEAST_EXPONENT: i64 = -149;
    const GREATEST_EXPONENT: i64 = 127;

    fn magnitude_bits(self) -> u64 {
        u64::from(self.to_bits() & (u32::MAX >> 1))
    }

    fn is_negative(self) -> bool {
        self.is_sign_negative()
    }

    fn from_magnitude_bits(negative: bool, bits: u64) -> Self {
        let bits = u32::try_from(bits).expect("a binary32 magnitude has 31 bits");
        Self::from_bits(bits | (u32::from(negative) << 31))
    }
}

impl Binary for f64 {
    const PRECISION: u32 = 53;
    const LEAST_EXPONENT: i64 = -1074;
    const GREATEST_EXPONENT: i64 = 1023;

    fn magnitude_bits(self) -> u64 {
        self.to_bits() & (u64::MAX >> 1)
    }

    fn is_negative(self) -> bool {
        self.is_sign_negative()
    }

    fn from_magnitude_bits(negative: bool, bits: u64) -> Self {
        Self::from_bits(bits | (u64::from(negative) << 63))
    }
}
