//! Laurent series along a germ: what an expression with roots is for small t > 0.
//!
//! They only guide the search: [`super::bounds`] and [`super::envelope`] prove what is read off here.

use std::cmp::Ordering;
use std::fmt::Debug;

use kane_kernel::{Expr, Poly, Rel, Relation, Scope, Side};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// What coefficients are made of.
pub(super) trait Numbers {
    type Number: Clone + Debug;

    fn number(&self, q: &BigRational) -> Self::Number;
    /// A symbol of the statement that does not vary, if it is one of these numbers.
    fn symbol(&self, v: usize) -> Option<Self::Number>;
    /// A variable of polynomials in these numbers that does not vary.
    fn variable(&self, v: usize) -> Option<Self::Number> {
        self.symbol(v)
    }
    fn sum(&self, a: &Self::Number, b: &Self::Number) -> Option<Self::Number>;
    fn product(&self, a: &Self::Number, b: &Self::Number) -> Option<Self::Number>;
    /// 1/a, of what is not zero.
    fn inverse(&self, a: &Self::Number) -> Option<Self::Number>;
    /// √a, of what is positive, if it is one of these numbers.
    fn root(&self, a: &Self::Number) -> Option<Self::Number>;
    fn is_zero(&self, a: &Self::Number) -> bool;
    /// The sign of what is not zero, if it is known.
    fn is_positive(&self, a: &Self::Number) -> Option<bool>;
}

/// Rational numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rationals;

impl Numbers for Rationals {
    type Number = BigRational;

    fn number(&self, q: &BigRational) -> BigRational {
        q.clone()
    }

    fn symbol(&self, _: usize) -> Option<BigRational> {
        None
    }

    fn sum(&self, a: &BigRational, b: &BigRational) -> Option<BigRational> {
        Some(a + b)
    }

    fn product(&self, a: &BigRational, b: &BigRational) -> Option<BigRational> {
        Some(a * b)
    }

    fn inverse(&self, a: &BigRational) -> Option<BigRational> {
        (!a.is_zero()).then(|| a.recip())
    }

    fn root(&self, a: &BigRational) -> Option<BigRational> {
        let root = |n: &BigInt| (!n.is_negative()).then(|| n.sqrt()).filter(|r| r * r == *n);
        Some(BigRational::new(root(a.numer())?, root(a.denom())?))
    }

    fn is_zero(&self, a: &BigRational) -> bool {
        a.is_zero()
    }

    fn is_positive(&self, a: &BigRational) -> Option<bool> {
        Some(a.is_positive())
    }
}

/// Σ cᵢ·t^(low + i), known up to the length of its list; the first coefficient is not 0.
#[derive(Clone, Debug)]
pub(super) struct Series<N = BigRational> {
    pub(super) low: i64,
    pub(super) coefficients: Vec<N>,
    /// whether all further coefficients are 0
    is_whole: bool,
}

impl Series {
    /// Its sign for small t.
    pub(super) fn is_positive(&self) -> bool {
        self.coefficients[0].is_positive()
    }
}

impl<N: Clone> Series<N> {
    /// The coefficient of tⁿ: `Err` if it is not known, `Ok(None)` if it is 0 as it lies below the first.
    fn at(&self, n: i64) -> Result<Option<&N>, ()> {
        match usize::try_from(n - self.low) {
            Ok(i) => self.coefficients.get(i).map(Some).ok_or(()),
            Err(_) => Ok(None),
        }
    }
}

/// A number that is 0 has no series with a first coefficient.
#[derive(Clone, Debug)]
pub(super) enum Value<N = BigRational> {
    Zero,
    Series(Series<N>),
}

/// The series of expressions in one variable along x = a ± tⁿ or ±1/tⁿ.
pub(super) struct Along<'a, 'g, F = Rationals> {
    pub(super) scope: &'a Scope<'g>,
    pub(super) side: &'a Side,
    pub(super) power: u32,
    pub(super) terms: usize,
    pub(super) numbers: F,
}

/// Powers above this have no series here: their coefficients would be too large.
const MAX_POWER: u32 = 64;

type SeriesOf<F> = Series<<F as Numbers>::Number>;
type ValueOf<F> = Value<<F as Numbers>::Number>;

impl<F: Numbers> Along<'_, '_, F> {
    /// The coefficient of tⁿ, if it is known.
    pub(super) fn coefficient(&self, s: &SeriesOf<F>, n: i64) -> Option<F::Number> {
        let zero = || self.numbers.number(&BigRational::zero());
        s.at(n).ok().map(|c| c.cloned().unwrap_or_else(zero))
    }

    /// A series without zeros in front; `None` if nothing of it is known but that it is small.
    fn normalised(&self, mut s: SeriesOf<F>) -> Option<ValueOf<F>> {
        let zeros = s.coefficients.iter().take_while(|c| self.numbers.is_zero(c)).count();
        s.coefficients.drain(..zeros);
        s.low += i64::try_from(zeros).ok()?;
        if s.coefficients.is_empty() {
            return s.is_whole.then_some(Value::Zero);
        }
        Some(Value::Series(s))
    }

    /// c·tⁿ with a c that is not 0.
    fn monomial(&self, c: F::Number, n: i64) -> SeriesOf<F> {
        let mut coefficients = vec![self.numbers.number(&BigRational::zero()); self.terms];
        coefficients[0] = c;
        Series { low: n, coefficients, is_whole: true }
    }

    /// A number as a series.
    fn constant(&self, c: F::Number) -> ValueOf<F> {
        if self.numbers.is_zero(&c) { Value::Zero } else { Value::Series(self.monomial(c, 0)) }
    }

    /// Coefficients up to the last that is not 0.
    fn length(&self, s: &SeriesOf<F>) -> usize {
        s.coefficients.iter().rposition(|c| !self.numbers.is_zero(c)).map_or(0, |last| last + 1)
    }

    fn power_of_t(&self, n: i64) -> SeriesOf<F> {
        self.monomial(self.numbers.number(&BigRational::one()), n)
    }

    fn neg(&self, a: &ValueOf<F>) -> Option<ValueOf<F>> {
        let minus = self.numbers.number(&-BigRational::one());
        Some(match a {
            Value::Zero => Value::Zero,
            Value::Series(s) => {
                let negated = s.coefficients.iter().map(|c| self.numbers.product(&minus, c));
                Value::Series(Series { coefficients: negated.collect::<Option<_>>()?, ..*s })
            }
        })
    }

    /// The sum, unless nothing of it is known but that it is small.
    fn add(&self, a: &ValueOf<F>, b: &ValueOf<F>) -> Option<ValueOf<F>> {
        let (a, b) = match (a, b) {
            (Value::Zero, other) | (other, Value::Zero) => return Some(other.clone()),
            (Value::Series(a), Value::Series(b)) => (a, b),
        };
        let end =
            |s: &SeriesOf<F>, length: usize| s.low + i64::try_from(length).unwrap_or(i64::MAX);
        let known = |s: &SeriesOf<F>| end(s, s.coefficients.len());
        let low = a.low.min(b.low);
        let end_of_both = known(a).min(known(b));
        let coefficients = (low..end_of_both)
            .map(|n| self.numbers.sum(&self.coefficient(a, n)?, &self.coefficient(b, n)?))
            .collect::<Option<Vec<_>>>()?;
        let is_within = |s: &SeriesOf<F>| s.is_whole && end(s, self.length(s)) <= end_of_both;
        let is_whole = is_within(a) && is_within(b);
        self.normalised(Series { low, coefficients, is_whole })
    }

    /// Σ aᵢ·b₍ₙ₋ᵢ₎ over a range of i.
    fn convolved(
        &self,
        a: &[F::Number],
        b: &[F::Number],
        range: std::ops::Range<usize>,
        n: usize,
    ) -> Option<F::Number> {
        let zero = self.numbers.number(&BigRational::zero());
        range.into_iter().try_fold(zero, |sum, i| {
            self.numbers.sum(&sum, &self.numbers.product(&a[i], &b[n - i])?)
        })
    }

    fn times(&self, a: &SeriesOf<F>, b: &SeriesOf<F>) -> Option<SeriesOf<F>> {
        let terms = a.coefficients.len().min(b.coefficients.len());
        let one = |n: usize| self.convolved(&a.coefficients, &b.coefficients, 0..n + 1, n);
        let coefficients = (0..terms).map(one).collect::<Option<_>>()?;
        let is_whole = a.is_whole && b.is_whole && self.length(a) + self.length(b) <= terms + 1;
        Some(Series { low: a.low + b.low, coefficients, is_whole })
    }

    fn mul(&self, a: &ValueOf<F>, b: &ValueOf<F>) -> Option<ValueOf<F>> {
        match (a, b) {
            (Value::Series(a), Value::Series(b)) => self.times(a, b).map(Value::Series),
            _ => Some(Value::Zero),
        }
    }

    fn recip(&self, s: &SeriesOf<F>) -> Option<SeriesOf<F>> {
        let lead = self.numbers.inverse(&s.coefficients[0])?;
        let minus = self.numbers.product(&self.numbers.number(&-BigRational::one()), &lead)?;
        let mut out = vec![lead];
        for n in 1..s.coefficients.len() {
            let sum = self.convolved(&s.coefficients, &out, 1..n + 1, n)?;
            out.push(self.numbers.product(&sum, &minus)?);
        }
        Some(Series { low: -s.low, coefficients: out, is_whole: s.is_whole && self.length(s) == 1 })
    }

    /// The root, where its powers of t are whole and its coefficients are numbers of the kind.
    fn sqrt(&self, s: &SeriesOf<F>) -> Option<SeriesOf<F>> {
        let lead = &s.coefficients[0];
        if s.low % 2 != 0 || self.numbers.is_positive(lead) != Some(true) {
            return None;
        }
        let first = self.numbers.root(lead)?;
        let half = self.numbers.inverse(&self.numbers.sum(&first, &first)?)?;
        let minus = self.numbers.number(&-BigRational::one());
        let mut out = vec![first];
        for n in 1..s.coefficients.len() {
            let sum = self.numbers.product(&minus, &self.convolved(&out, &out, 1..n, n)?)?;
            let rest = self.numbers.sum(&s.coefficients[n], &sum)?;
            out.push(self.numbers.product(&rest, &half)?);
        }
        let is_whole = s.is_whole && self.length(s) == 1;
        Some(Series { low: s.low / 2, coefficients: out, is_whole })
    }

    fn pow(&self, s: &SeriesOf<F>, n: u32) -> Option<SeriesOf<F>> {
        let one = self.numbers.number(&BigRational::one());
        let mut start = vec![self.numbers.number(&BigRational::zero()); s.coefficients.len()];
        start[0] = one;
        let start = Series { low: 0, coefficients: start, is_whole: true };
        (0..n).try_fold(start, |out, _| self.times(&out, s))
    }

    fn sign(&self, a: &ValueOf<F>) -> Option<Ordering> {
        Some(match a {
            Value::Zero => Ordering::Equal,
            Value::Series(s) if self.numbers.is_positive(&s.coefficients[0])? => Ordering::Greater,
            Value::Series(_) => Ordering::Less,
        })
    }

    fn x(&self) -> Option<ValueOf<F>> {
        let n = i64::from(self.power);
        let step = Value::Series(self.power_of_t(if self.side.at.is_some() { n } else { -n }));
        let step = if self.side.above { step } else { self.neg(&step)? };
        match &self.side.at {
            Some(a) => self.add(&self.number(a), &step),
            None => Some(step),
        }
    }

    fn number(&self, q: &BigRational) -> ValueOf<F> {
        self.constant(self.numbers.number(q))
    }

    /// The series of an expression; `None` if it has none that is seen, or is not defined there.
    pub(super) fn value(&self, e: &Expr) -> Option<ValueOf<F>> {
        let v = |e: &Expr| self.value(e);
        match e {
            Expr::Num(q) => Some(self.number(q)),
            Expr::Var(v) => match self.scope.context.value(*v) {
                Some(value) => self.value(value),
                None if *v == self.side.var => self.x(),
                None => Some(self.constant(self.numbers.symbol(*v)?)),
            },
            Expr::Let(i) => v(&self.scope.context.lets.get(*i)?.body),
            Expr::Neg(a) => self.neg(&v(a)?),
            Expr::Add(a, b) => self.add(&v(a)?, &v(b)?),
            Expr::Sub(a, b) => self.add(&v(a)?, &self.neg(&v(b)?)?),
            Expr::Mul(a, b) => self.mul(&v(a)?, &v(b)?),
            Expr::Div(a, b) => match v(b)? {
                Value::Zero => None,
                Value::Series(b) => self.mul(&v(a)?, &Value::Series(self.recip(&b)?)),
            },
            Expr::Pow(a, n) => match v(a)? {
                Value::Zero if *n < 0 => None,
                Value::Zero if *n == 0 => Some(self.number(&BigRational::one())),
                Value::Zero => Some(Value::Zero),
                Value::Series(_) if n.unsigned_abs() > MAX_POWER => None,
                Value::Series(s) => {
                    let power = self.pow(&s, n.unsigned_abs())?;
                    Some(Value::Series(if *n < 0 { self.recip(&power)? } else { power }))
                }
            },
            Expr::Sqrt(a) => match v(a)? {
                Value::Zero => Some(Value::Zero),
                Value::Series(s) => Some(Value::Series(self.sqrt(&s)?)),
            },
            Expr::Abs(a) => {
                let a = v(a)?;
                if self.sign(&a)? == Ordering::Less { self.neg(&a) } else { Some(a) }
            }
            Expr::Min(a, b) | Expr::Max(a, b) => {
                let (a, b) = (v(a)?, v(b)?);
                let greater = self.sign(&self.add(&a, &self.neg(&b)?)?)? == Ordering::Greater;
                Some(if greater == matches!(e, Expr::Max(..)) { a } else { b })
            }
            Expr::Cases(branches, otherwise) => {
                for (guards, body) in branches {
                    let holds = guards.iter().map(|g| self.holds(g)).collect::<Option<Vec<_>>>()?;
                    if holds.iter().all(|holds| *holds) {
                        return v(body);
                    }
                }
                v(otherwise.as_deref()?)
            }
            Expr::Deriv(..) => None,
        }
    }

    fn holds(&self, r: &Relation) -> Option<bool> {
        let difference = self.add(&self.value(&r.lhs)?, &self.neg(&self.value(&r.rhs)?)?)?;
        let sign = self.sign(&difference)?;
        Some(match r.rel {
            Rel::Eq => sign == Ordering::Equal,
            Rel::Ne => sign != Ordering::Equal,
            Rel::Lt => sign == Ordering::Less,
            Rel::Le => sign != Ordering::Greater,
            Rel::Gt => sign == Ordering::Greater,
            Rel::Ge => sign != Ordering::Less,
        })
    }

    /// The value of a polynomial in x, t and roots.
    pub(super) fn polynomial(&self, p: &Poly) -> Option<ValueOf<F>> {
        let t = self.scope.germ();
        let mut sum = Value::Zero;
        for (monomial, c) in p.terms() {
            let mut product = self.number(&c.clone().into());
            for &(v, n) in monomial {
                let factor = if v == t {
                    Value::Series(self.power_of_t(1))
                } else if v == self.side.var {
                    self.x()?
                } else if let Some(c) = self.numbers.variable(v) {
                    self.constant(c)
                } else {
                    self.value(self.scope.root(v).unwrap_or(&Expr::Var(v)))?
                };
                for _ in 0..n.min(MAX_POWER) {
                    product = self.mul(&product, &factor)?;
                }
                if n > MAX_POWER {
                    return None;
                }
            }
            sum = self.add(&sum, &product)?;
        }
        Some(sum)
    }
}
