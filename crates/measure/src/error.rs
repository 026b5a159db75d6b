//! What went wrong at one input, and how many bits it cost.

use std::cmp::Ordering;
use std::fmt;

use crate::{DyadicNumber, Format};

/// How a computed value fails its exact one. The order is that of severity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Fault {
    /// More than half of the format's digits are wrong.
    Lost,
    /// 0, though the exact value rounds to another float.
    Vanishes,
    /// The wrong sign.
    WrongSign,
    /// ±∞, though the exact value rounds to a finite float.
    Infinite,
    /// Not a number, though the exact value is one.
    Nan,
}

impl Fault {
    /// All of them, worst first.
    pub const ALL: [Self; 5] =
        [Self::Nan, Self::Infinite, Self::WrongSign, Self::Vanishes, Self::Lost];

    /// The name for programs.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Nan => "nan",
            Self::Infinite => "infinite",
            Self::WrongSign => "wrong-sign",
            Self::Vanishes => "zero",
            Self::Lost => "digits-lost",
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Nan => "NaN",
            Self::Infinite => "infinite",
            Self::WrongSign => "wrong sign",
            Self::Vanishes => "0 instead",
            Self::Lost => "digits lost",
        })
    }
}

/// The judgement on one computed value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sample {
    /// What is wrong, if more than rounding.
    pub fault: Option<Fault>,
    /// Bits lost in hundredths: 100·log₂ of the error in ulps of the exact value, at least 0 and at
    /// most the precision of the format, which is where nothing is right.
    pub lost: i64,
}

/// Compares a computed value with the exact one.
///
/// An ulp is that of the exact value and never below the least subnormal, so a correctly rounded
/// subnormal loses nothing. A value beyond the range of the format loses nothing if it comes out as
/// the infinity or the zero to which it rounds.
#[must_use]
pub fn judge<F: Format>(computed: F, exact: &DyadicNumber) -> Sample {
    let all = 100 * i64::from(F::PRECISION);
    let worst = |fault| Sample { fault: Some(fault), lost: all };
    let fine = Sample { fault: None, lost: 0 };
    let magnitude = computed.magnitude_bits();
    if magnitude > F::infinity_bits() {
        return worst(Fault::Nan);
    }
    let precision = i64::from(F::PRECISION);
    // the exact value rounds to infinity from half a step beyond the greatest float on
    let overflows = exact.rounds_to_infinity::<F>();
    let same_sign = computed.is_negative() == exact.is_negative();
    if magnitude == F::infinity_bits() {
        return if overflows && same_sign { fine } else { worst(Fault::Infinite) };
    }
    let underflows = exact.compare_magnitude(F::LEAST_EXPONENT - 1) != Ordering::Greater;
    if magnitude == 0 {
        return if underflows { fine } else { worst(Fault::Vanishes) };
    }
    if !exact.is_zero() && !same_sign {
        return worst(Fault::WrongSign);
    }
    let Some(value) = computed.exactly() else { return worst(Fault::Nan) };
    let ulp = (exact.greatest_binade() - precision + 1).max(F::LEAST_EXPONENT);
    let lost = match value.minus(exact).hundredths_of_log2() {
        None => 0,
        Some(error) => (error - 100 * ulp).clamp(0, all),
    };
    let fault = (2 * lost > all).then_some(Fault::Lost);
    Sample { fault, lost }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn against(computed: f64, exact: f64) -> Sample {
        judge(computed, &DyadicNumber::of(exact).unwrap())
    }

    #[test]
    fn each_fault_has_its_name() {
        assert_eq!(against(f64::NAN, 1.0).fault, Some(Fault::Nan));
        assert_eq!(against(f64::INFINITY, 1.0).fault, Some(Fault::Infinite));
        assert_eq!(against(-1e-300, 1e-300).fault, Some(Fault::WrongSign));
        assert_eq!(against(0.0, 1e-300).fault, Some(Fault::Vanishes));
        assert_eq!(against(1.0 + 1e-7, 1.0).fault, Some(Fault::Lost));
        assert_eq!(against(1.0 + 1e-9, 1.0).fault, None);
        assert_eq!(against(1.0, 1.0).lost, 0);
        assert_eq!(against(1.0 + 4.0 * f64::EPSILON, 1.0).lost, 200);
    }
}
