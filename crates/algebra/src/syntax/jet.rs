//! Numbers with infinitesimals, for derivatives without symbolic differentiation.
//!
//! f(x + ε) = f(x) + f′(x) ε with ε² = 0. Each derivative under evaluation has an ε of its own, its
//! *level*; a jet that carries no ε of a level does not depend on that level's variable at all.

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{One, Pow, Signed, ToPrimitive, Zero};

use super::no_value::NoValue;

/// Numbers above this many bits end the evaluation: a gcd takes quadratic time.
const MAX_BITS: u64 = 100_000;

/// A rational number, or value + slope·ε.
#[derive(Clone, Debug)]
pub(crate) enum Jet {
    Real(BigRational),
    Dual(Box<Dual>),
}

/// value + slope·ε, both free of the ε of this level and those above.
#[derive(Clone, Debug)]
pub(crate) struct Dual {
    level: usize,
    value: Jet,
    slope: Jet,
}

type Outcome = Result<Jet, NoValue>;

impl Jet {
    pub(crate) fn one() -> Self {
        Self::Real(BigRational::one())
    }

    pub(crate) fn zero() -> Self {
        Self::Real(BigRational::zero())
    }

    /// value + slope·ε; the caller vouches that both are below `level`.
    pub(crate) fn dual(level: usize, value: Self, slope: Self) -> Self {
        Self::Dual(Box::new(Dual { level, value, slope }))
    }

    fn level(&self) -> usize {
        match self {
            Self::Real(_) => 0,
            Self::Dual(dual) => dual.level,
        }
    }

    /// Value and, if it has one, slope at this level.
    pub(crate) fn split(self, level: usize) -> (Self, Option<Self>) {
        match self {
            Self::Dual(dual) if dual.level == level => (dual.value, Some(dual.slope)),
            other => (other, None),
        }
    }

    /// The number without any ε.
    pub(crate) fn real(&self) -> &BigRational {
        match self {
            Self::Real(value) => value,
            Self::Dual(dual) => dual.value.real(),
        }
    }

    pub(crate) fn neg(self) -> Self {
        match self {
            Self::Real(value) => Self::Real(-value),
            Self::Dual(dual) => Self::dual(dual.level, dual.value.neg(), dual.slope.neg()),
        }
    }

    pub(crate) fn add(self, other: Self) -> Outcome {
        let level = self.level().max(other.level());
        if level == 0 {
            return sized(combined(self.real(), other.real(), |a, b| a + b, |a, b| a + b));
        }
        let (a, da) = self.split(level);
        let (b, db) = other.split(level);
        let slope = match (da, db) {
            (Some(da), Some(db)) => da.add(db)?,
            (Some(slope), None) | (None, Some(slope)) => slope,
            (None, None) => Self::zero(),
        };
        Ok(Self::dual(level, a.add(b)?, slope))
    }

    pub(crate) fn mul(self, other: Self) -> Outcome {
        let level = self.level().max(other.level());
        if level == 0 {
            return sized(combined(self.real(), other.real(), |a, b| a * b, |a, b| a * b));
        }
        let (a, da) = self.split(level);
        let (b, db) = other.split(level);
        let mut slope = Self::zero();
        if let Some(da) = da {
            slope = slope.add(da.mul(b.clone())?)?;
        }
        if let Some(db) = db {
            slope = slope.add(db.mul(a.clone())?)?;
        }
        Ok(Self::dual(level, a.mul(b)?, slope))
    }

    /// 1/(a + bε) = 1/a − b/a² ε
    pub(crate) fn reciprocal(self) -> Outcome {
        match self {
            Self::Real(value) if value.is_zero() => Err(NoValue::DivisionByZero),
            Self::Real(value) => Ok(Self::Real(value.recip())),
            Self::Dual(dual) => {
                let value = dual.value.reciprocal()?;
                let slope = value.clone().mul(value.clone())?.mul(dual.slope)?.neg();
                Ok(Self::dual(dual.level, value, slope))
            }
        }
    }

    /// The integer power; 0⁰ = 1.
    pub(crate) fn pow(self, exponent: i32) -> Outcome {
        if exponent < 0 {
            return self.reciprocal()?.pow(exponent.saturating_neg());
        }
        match self {
            Self::Real(value) => {
                let bits = value.numer().bits().max(value.denom().bits());
                if bits.saturating_mul(exponent.unsigned_abs().into()) > MAX_BITS && bits > 1 {
                    return Err(NoValue::TooLarge);
                }
                Ok(Self::Real(Pow::pow(value, exponent)))
            }
            Self::Dual(_) if exponent == 0 => Ok(Self::one()),
            Self::Dual(dual) => {
                let factor = Self::Real(BigRational::from_integer(exponent.into()));
                let below = dual.value.clone().pow(exponent - 1)?;
                let slope = factor.mul(below.clone())?.mul(dual.slope)?;
                Ok(Self::dual(dual.level, below.mul(dual.value)?, slope))
            }
        }
    }

    /// √(a + bε) = √a + b/(2√a) ε, which needs a > 0.
    pub(crate) fn sqrt(self) -> Outcome {
        match self {
            Self::Real(value) if value.is_negative() => Err(NoValue::NegativeRadicand),
            Self::Real(value) => exact_root(&value).map(Self::Real),
            Self::Dual(dual) => {
                let root = dual.value.sqrt()?;
                let twice = root.clone().add(root.clone())?;
                let slope = dual.slope.mul(twice.reciprocal()?)?;
                Ok(Self::dual(dual.level, root, slope))
            }
        }
    }
}

/// A sum or a product: in machine words where both numbers leave room for it, since long integers take most of their
/// time in divisors.
fn combined(
    a: &BigRational,
    b: &BigRational,
    in_words: fn(Ratio<i128>, Ratio<i128>) -> Ratio<i128>,
    at_length: fn(&BigRational, &BigRational) -> BigRational,
) -> BigRational {
    match (short(a), short(b)) {
        (Some(a), Some(b)) => {
            let (num, den) = in_words(a, b).into_raw();
            BigRational::new_raw(num.into(), den.into())
        }
        _ => at_length(a, b),
    }
}

/// A number whose sums and products with its like fit into 128 bits.
fn short(x: &BigRational) -> Option<Ratio<i128>> {
    let part = |n: &BigInt| n.to_i64().filter(|n| n.unsigned_abs() < 1 << 62).map(i128::from);
    Some(Ratio::new_raw(part(x.numer())?, part(x.denom())?))
}

fn sized(value: BigRational) -> Outcome {
    if value.numer().bits().max(value.denom().bits()) > MAX_BITS {
        return Err(NoValue::TooLarge);
    }
    Ok(Jet::Real(value))
}

fn exact_root(value: &BigRational) -> Result<BigRational, NoValue> {
    // numerator and denominator are coprime, so the root is rational only if both are squares
    let (numer, denom) = (value.numer().sqrt(), value.denom().sqrt());
    if &(&numer * &numer) == value.numer() && &(&denom * &denom) == value.denom() {
        Ok(BigRational::new_raw(numer, denom))
    } else {
        Err(NoValue::Irrational)
    }
}
