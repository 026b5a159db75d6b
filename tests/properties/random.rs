//! A source of randomness for runs too long for proptest, which a run repeats.

/// A small generator of the xorshift family (Marsaglia 2003).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// Between zero and one.
    pub(crate) fn unit(&mut self) -> f64 {
        f64::from_bits(1.0_f64.to_bits() | self.bits() >> 12) - 1.0
    }
}
