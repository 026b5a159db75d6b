//! Values through roots, enclosed between fractions, so that they can be shown as decimals.

use std::collections::HashMap;

use kane_algebra::syntax::compares;
use kane_kernel::{Context, Expr, Rel, Relation};
use kane_number::power_of;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, Zero as _};

type Q = BigRational;

/// Significant bits to which ends are rounded outward.
const BITS: u64 = 192;
/// Bits that a power may have before it is not worth a decimal.
const MOST_BITS: u64 = 1 << 16;

/// Every number from one fraction to another, the ends included.
#[derive(Clone, Debug)]
pub(super) struct Span {
    lower: Q,
    upper: Q,
}

impl Span {
    /// One number.
    pub(super) fn at(q: Q) -> Self {
        Self { lower: q.clone(), upper: q }
    }

    /// From one number to another, which is not below it.
    pub(super) fn between(lower: Q, upper: Q) -> Self {
        Self { lower: fewer(lower, false), upper: fewer(upper, true) }
    }

    /// Whether it is one number.
    pub(super) fn is_number(&self) -> bool {
        self.lower == self.upper
    }

    /// Whether the ends agree to 40 bits.
    pub(super) fn is_close(&self) -> bool {
        let width = &self.upper - &self.lower;
        let least = self.lower.abs().min(self.upper.abs());
        self.is_number() || width * Q::from_integer(BigInt::one() << 40_u8) <= least
    }

    /// The middle.
    pub(super) fn middle(&self) -> Q {
        (&self.lower + &self.upper) / Q::from_integer(2.into())
    }

    /// Whether a relation holds of all pairs, or of none; `None` if of some.
    fn compare(&self, rel: Rel, other: &Self) -> Option<bool> {
        let first = self.lower.cmp(&other.upper);
        let second = self.upper.cmp(&other.lower);
        // apart, or a number each
        (first.is_gt() || second.is_lt() || first == second)
            .then(|| compares(rel, if first.is_gt() { first } else { second }))
    }

    fn neg(self) -> Self {
        Self { lower: -self.upper, upper: -self.lower }
    }

    /// The sums.
    pub(super) fn plus(self, other: Self) -> Self {
        Self::between(self.lower + other.lower, self.upper + other.upper)
    }

    /// The products.
    pub(super) fn times(&self, other: &Self) -> Self {
        let corners = [&self.lower, &self.upper].into_iter();
        let mut corners =
            corners.flat_map(|a| [&other.lower, &other.upper].map(|b| a * b)).collect::<Vec<_>>();
        corners.sort_unstable();
        let upper = corners.pop().unwrap_or_default();
        Self::between(corners.into_iter().next().unwrap_or_default(), upper)
    }

    /// One over each; `None` if 0 is among them.
    fn reciprocal(self) -> Option<Self> {
        let apart = self.lower.is_positive() || self.upper.is_negative();
        apart.then(|| Self::between(self.upper.recip(), self.lower.recip()))
    }

    fn magnitude(self) -> Self {
        if self.lower.is_negative() && self.upper.is_positive() {
            return Self { upper: self.upper.max(-self.lower), lower: Q::zero() };
        }
        if self.upper.is_positive() { self } else { self.neg() }
    }

    fn pow(self, exponent: i32) -> Option<Self> {
        let size = self.lower.numer().bits().max(self.upper.numer().bits());
        let size = size.max(self.lower.denom().bits()).max(self.upper.denom().bits());
        if size.saturating_mul(exponent.unsigned_abs().into()) > MOST_BITS {
            return None;
        }
        let base = if exponent % 2 == 0 { self.magnitude() } else { self };
        let power = |q: &Q| num_traits::pow::Pow::pow(q, exponent.unsigned_abs());
        let power = Self::between(power(&base.lower), power(&base.upper));
        if exponent < 0 { power.reciprocal() } else { Some(power) }
    }

    /// The roots; `None` if a number below 0 is among them.
    fn sqrt(self) -> Option<Self> {
        if self.lower.is_negative() {
            return None;
        }
        Some(Self { lower: root(&self.lower, false), upper: root(&self.upper, true) })
    }
}

/// A fraction of fewer bits, not above it, or with `up` not below.
fn fewer(q: Q, up: bool) -> Q {
    let (n, d) = (q.numer().bits(), q.denom().bits());
    if n.max(d) <= 2 * BITS || q.is_zero() {
        return q;
    }
    // |q| is between 2^(n − d − 1) and 2^(n − d + 1)
    let (n, d) = (i64::try_from(n).unwrap_or(i64::MAX), i64::try_from(d).unwrap_or(i64::MAX));
    let unit = power_of(2, n - d - i64::try_from(BITS).unwrap_or_default());
    let places = q / &unit;
    (if up { places.ceil() } else { places.floor() }) * unit
}

/// The root of what is not negative, to `BITS` bits below or, with `up`, above; exact where it is rational.
fn root(q: &Q, up: bool) -> Q {
    let (n, d) = (q.numer().sqrt(), q.denom().sqrt());
    if &(&n * &n) == q.numer() && &(&d * &d) == q.denom() {
        return Q::new(n, d);
    }
    let (n, d) = (q.numer().bits(), q.denom().bits());
    let shift = BITS + d.saturating_sub(n).div_ceil(2);
    let scaled = (q.numer() << (2 * shift)) / q.denom();
    let whole = scaled.sqrt() + BigInt::from(u8::from(up));
    Q::new(whole, BigInt::one() << shift)
}

/// Encloses values of expressions at one point.
pub(super) struct Enclosure<'a> {
    context: &'a Context,
    at: &'a [Span],
    known: HashMap<usize, Option<Span>>,
}

impl<'a> Enclosure<'a> {
    /// At the point where symbol i is within `at[i]`.
    pub(super) fn new(context: &'a Context, at: &'a [Span]) -> Self {
        Self { context, at, known: HashMap::new() }
    }

    /// Where the value is, if there is one and the cases are settled. Derivatives have none here.
    pub(super) fn value(&mut self, e: &Expr) -> Option<Span> {
        match e {
            Expr::Num(q) => Some(Span::at(q.clone())),
            Expr::Var(v) => self.at.get(*v).cloned(),
            Expr::Let(i) => self.definition(*i),
            Expr::Neg(a) => Some(self.value(a)?.neg()),
            Expr::Add(a, b) => Some(self.value(a)?.plus(self.value(b)?)),
            Expr::Sub(a, b) => Some(self.value(a)?.plus(self.value(b)?.neg())),
            Expr::Mul(a, b) => Some(self.value(a)?.times(&self.value(b)?)),
            Expr::Div(a, b) => Some(self.value(a)?.times(&self.value(b)?.reciprocal()?)),
            Expr::Pow(a, exponent) => self.value(a)?.pow(*exponent),
            Expr::Abs(a) => Some(self.value(a)?.magnitude()),
            Expr::Min(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                Some(Span { lower: a.lower.min(b.lower), upper: a.upper.min(b.upper) })
            }
            Expr::Max(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                Some(Span { lower: a.lower.max(b.lower), upper: a.upper.max(b.upper) })
            }
            Expr::Sqrt(a) => self.value(a)?.sqrt(),
            Expr::Cases(branches, otherwise) => {
                for (guards, value) in branches {
                    if self.all_hold(guards)? {
                        return self.value(value);
                    }
                }
                self.value(otherwise.as_deref()?)
            }
            Expr::Deriv(..) => None,
        }
    }

    /// Whether all relations hold; `None` if that is not settled.
    fn all_hold(&mut self, guards: &[Relation]) -> Option<bool> {
        for guard in guards {
            if !self.holds(guard)? {
                return Some(false);
            }
        }
        Some(true)
    }

    /// Whether a relation holds; `None` if that is not settled.
    pub(super) fn holds(&mut self, r: &Relation) -> Option<bool> {
        self.value(&r.lhs)?.compare(r.rel, &self.value(&r.rhs)?)
    }

    fn definition(&mut self, i: usize) -> Option<Span> {
        if let Some(known) = self.known.get(&i) {
            return known.clone();
        }
        let value = self.value(&self.context.lets.get(i)?.body);
        self.known.insert(i, value.clone());
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kane_kernel::Rel;
    use proptest::prelude::*;

    fn q(n: i64, d: i64) -> Q {
        Q::new(n.into(), d.into())
    }

    fn fraction() -> impl Strategy<Value = Q> {
        let small = (-20_i64..=20, 1_i64..=12).prop_map(|(n, d)| q(n, d));
        let long = (any::<i64>(), any::<i64>(), 1_u8..=9).prop_map(|(n, d, k)| {
            let d = BigInt::from(d).abs() + 1_u8;
            num_traits::pow::Pow::pow(Q::new(n.into(), d), u32::from(k))
        });
        prop_oneof![small, long]
    }

    proptest! {
        #[test]
        fn fewer_bits_enclose_what_they_stand_for(x in fraction()) {
            prop_assert!(fewer(x.clone(), false) <= x && x <= fewer(x.clone(), true));
            prop_assert!(Span::between(x.clone(), x).is_close());
        }

        #[test]
        fn roots_are_between_their_ends(x in fraction()) {
            let x = x.abs();
            let root = Span::at(x.clone()).sqrt().expect("not negative");
            prop_assert!(&root.lower * &root.lower <= x && x <= &root.upper * &root.upper);
            prop_assert!(root.is_close());
        }

        #[test]
        fn a_product_holds_the_products(a in fraction(), b in fraction(), c in fraction(), d in fraction()) {
            let span = |a: &Q, b: &Q| Span::between(a.clone().min(b.clone()), a.clone().max(b.clone()));
            let whole = span(&a, &b).times(&span(&c, &d));
            for p in [&a * &c, &a * &d, &b * &c, &b * &d] {
                prop_assert!(whole.lower <= p && p <= whole.upper);
            }
        }

        #[test]
        fn what_is_settled_holds_at_the_ends(
            a in fraction(), b in fraction(), c in fraction(), d in fraction(),
            rel in prop::sample::select(vec![Rel::Eq, Rel::Ne, Rel::Lt, Rel::Le, Rel::Gt, Rel::Ge]),
        ) {
            let (one, other) = (
                Span { lower: a.clone().min(b.clone()), upper: a.clone().max(b.clone()) },
                Span { lower: c.clone().min(d.clone()), upper: c.clone().max(d.clone()) },
            );
            if let Some(holds) = one.compare(rel, &other) {
                for x in [&a, &b] {
                    for y in [&c, &d] {
                        prop_assert_eq!(compares(rel, x.cmp(y)), holds);
                    }
                }
            }
        }
    }
}
