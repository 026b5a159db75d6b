//! Enclosures in units of 2⁻²⁵⁶: fast enough to be looked at in each state of a search.

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, Zero as _};

/// The units, in bits.
const FINE: u32 = 256;
/// What is closer to 0 than this is tried as 0, in bits.
const NEAR: u32 = 128;

/// All numbers between two multiples of the unit.
#[derive(Clone, Debug)]
pub(super) struct Enclosure {
    lower: BigInt,
    upper: BigInt,
}

impl Enclosure {
    /// An integer.
    pub(super) fn of(n: &BigInt) -> Self {
        Self { lower: n << FINE, upper: n << FINE }
    }

    /// The sums.
    pub(super) fn plus(self, other: &Self) -> Self {
        Self { lower: self.lower + &other.lower, upper: self.upper + &other.upper }
    }

    /// The products with what is not negative.
    pub(super) fn times(&self, other: &Self) -> Self {
        let least = if self.lower.is_negative() { &other.upper } else { &other.lower };
        let most = if self.upper.is_negative() { &other.lower } else { &other.upper };
        Self { lower: (&self.lower * least) >> FINE, upper: ((&self.upper * most) >> FINE) + 1 }
    }

    /// The roots of the quotients by a positive integer; `None` if what is negative may be among them.
    pub(super) fn root_over(&self, d: &BigInt) -> Option<Self> {
        if self.lower.is_negative() {
            return None;
        }
        let (lower, upper): (BigInt, BigInt) =
            (self.lower.div_floor(d) << FINE, (self.upper.div_floor(d) + 1) << FINE);
        Some(Self { lower: lower.sqrt(), upper: upper.sqrt() + 1 })
    }

    /// The sign of all of them, or 0 if they are that close to it; `None` if neither is known.
    pub(super) fn sign(&self) -> Option<i8> {
        let (lower, upper) = (kane_kernel::sign(&self.lower), kane_kernel::sign(&self.upper));
        let near = self.lower.abs().max(self.upper.abs()) < BigInt::one() << (FINE - NEAR);
        if lower == upper { Some(lower) } else { near.then_some(0) }
    }

    /// Whether one of them is between two numbers, or one of these.
    pub(super) fn meets(&self, lower: &BigRational, upper: &BigRational) -> bool {
        let unit = || BigInt::one() << FINE;
        &self.lower * upper.denom() <= upper.numer() * unit()
            && lower.numer() * unit() <= &self.upper * lower.denom()
    }
}

impl Default for Enclosure {
    fn default() -> Self {
        Self { lower: BigInt::zero(), upper: BigInt::zero() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use quickcheck::quickcheck;

    fn whole(n: i32) -> Enclosure {
        Enclosure::of(&n.into())
    }

    quickcheck! {
        fn a_root_times_itself_encloses_its_square(n: u32, d: u16) -> bool {
            let d = BigInt::from(d) + 1;
            let root = Enclosure::of(&n.into()).root_over(&d).expect("it is not negative");
            let square = root.times(&root);
            square.meets(&BigRational::new(n.into(), d.clone()), &BigRational::new(n.into(), d))
        }

        fn what_is_exact_has_the_sign_of_the_integers(a: i32, b: u16, c: i32) -> bool {
            let value = whole(a).times(&whole(b.into())).plus(&whole(c));
            let exact = i64::from(a) * i64::from(b) + i64::from(c);
            value.sign() == i8::try_from(exact.signum()).ok()
        }
    }
}
