//! Limits of rational functions in one symbol, the others being parameters.

use std::cmp::Ordering;

use kane_kernel::{Approach, Poly};
use kane_number::{Number, Rational};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use crate::rational_function::{NotRational, RationalFunction};

/// What a rational function tends to, as a function of its other symbols.
///
/// It holds where the conditions of the function inside do: among them, that the leading
/// coefficients on which the answer rests are not zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Limit {
    /// a value, free of the limit variable
    Finite(RationalFunction),
    /// ±∞, with the sign of this function
    Infinite(RationalFunction),
}

/// A limit in numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Extended {
    /// a value
    Finite(Rational),
    /// +∞
    PlusInf,
    /// −∞
    MinusInf,
}

impl Limit {
    /// The limit where symbol i has the value `point[i]`; an empty point will do when no other
    /// symbol occurs. Exact; `None` where a condition fails or a value is missing: there the limit
    /// may be another one.
    #[must_use]
    pub fn at(&self, point: &[Rational]) -> Option<Extended> {
        match self {
            Self::Finite(value) => value.eval(point).map(Extended::Finite),
            Self::Infinite(sign) => {
                let positive = sign.eval(point)?.is_positive();
                Some(if positive { Extended::PlusInf } else { Extended::MinusInf })
            }
        }
    }
}

/// The limit of f as the symbol x moves as told. Exact.
///
/// Near the place, numerator and denominator behave like their leading terms a·tᵖ and b·t^q with
/// t → 0+: the limit is 0 if p > q, a/b if p = q, and ±∞ if p < q. Every condition of f is held to
/// a leading coefficient that does not vanish either; thus f is defined beside the place.
///
/// `Ok(None)` if the sides of [`Approach::To`] tend to opposite infinities.
///
/// # Errors
/// [`NotRational::TooLarge`] if f cannot be expanded about the place.
pub fn limit(
    f: &RationalFunction,
    x: usize,
    place: &Approach,
) -> Result<Option<Limit>, NotRational> {
    let one_sided = |f: &RationalFunction, side| Germ::of(f, x, side).limit();
    Ok(match place {
        Approach::PlusInf => Some(one_sided(f, Side::PlusInf)),
        Approach::MinusInf => Some(one_sided(f, Side::MinusInf)),
        Approach::Above(a) => Some(one_sided(&about(f, x, a)?, Side::Above)),
        Approach::Below(a) => Some(one_sided(&about(f, x, a)?, Side::Below)),
        Approach::To(a) => {
            let f = about(f, x, a)?;
            let (above, below) = (one_sided(&f, Side::Above), one_sided(&f, Side::Below));
            (above == below).then_some(above)
        }
    })
}

/// The sign of f, a function of x alone, close enough to a one-sided place. Exact; `None` if other
/// symbols occur or the place has two sides.
///
/// # Errors
/// As [`limit`].
pub fn sign_beside(
    f: &RationalFunction,
    x: usize,
    place: &Approach,
) -> Result<Option<Ordering>, NotRational> {
    let germ = match place {
        Approach::PlusInf => Germ::of(f, x, Side::PlusInf),
        Approach::MinusInf => Germ::of(f, x, Side::MinusInf),
        Approach::Above(a) => Germ::of(&about(f, x, a)?, x, Side::Above),
        Approach::Below(a) => Germ::of(&about(f, x, a)?, x, Side::Below),
        Approach::To(_) => return Ok(None),
    };
    Ok(germ.lead.as_constant().map(|lead| lead.numer().cmp(&BigInt::zero())))
}

/// f(a + x)
fn about(f: &RationalFunction, x: usize, a: &Rational) -> Result<RationalFunction, NotRational> {
    if a.is_zero() {
        return Ok(f.clone());
    }
    f.substitute(&[(x, RationalFunction::symbol(x) + RationalFunction::from(a.clone()))])
}

/// t → 0+ with x = t, −t, 1/t, −1/t
#[derive(Clone, Copy)]
enum Side {
    Above,
    Below,
    PlusInf,
    MinusInf,
}

/// The leading behaviour lead·t^order, provided the conditions of `lead`.
struct Germ {
    lead: RationalFunction,
    order: i64,
}

impl Germ {
    fn of(f: &RationalFunction, x: usize, side: Side) -> Self {
        let (num, den) = f.fraction();
        let (a, p) = leading(&num, x, side);
        let (b, q) = leading(&den, x, side);
        let lead = RationalFunction::new(&a, &b);
        let mut lead = lead.expect("a leading coefficient is not zero");
        for condition in f.conditions() {
            let (c, _) = leading(&condition, x, side);
            lead = lead.provided(&c).expect("a condition is not the zero polynomial");
        }
        Self { lead, order: p - q }
    }

    fn limit(self) -> Limit {
        let Self { lead, order } = self;
        match order.cmp(&0) {
            _ if lead.is_zero() => Limit::Finite(lead),
            // zero times the lead keeps its conditions
            Ordering::Greater => Limit::Finite(lead * RationalFunction::zero()),
            Ordering::Equal => Limit::Finite(lead),
            Ordering::Less => {
                let (numerator, _) = lead.fraction();
                Limit::Infinite(lead.provided(&numerator).expect("the lead is not zero"))
            }
        }
    }
}

/// The coefficient of the lowest power of t, and that power; zero for the zero polynomial.
fn leading(p: &Poly, x: usize, side: Side) -> (Poly, i64) {
    let parts = p.coefficients(x);
    let found = match side {
        Side::Above | Side::Below => parts.iter().position(|c| !c.is_empty()),
        Side::PlusInf | Side::MinusInf => parts.iter().rposition(|c| !c.is_empty()),
    };
    let Some(power) = found else {
        return (Poly::default(), 0);
    };
    let mirrored = matches!(side, Side::Below | Side::MinusInf) && power % 2 == 1;
    let sign = if mirrored { -BigInt::one() } else { BigInt::one() };
    let order = i64::try_from(power).unwrap_or(i64::MAX);
    let order = if matches!(side, Side::PlusInf | Side::MinusInf) { -order } else { order };
    (parts[power].scale(&sign), order)
}
