//! Laurent series along a germ: what an expression with roots is for small t > 0.
//!
//! They only guide the search: [`super::bounds`] proves what is read off here.

use std::cmp::Ordering;

use kane_kernel::{Expr, Poly, Rel, Relation, Scope, Side};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// Σ cᵢ·t^(low + i), known up to the length of its list; the first coefficient is not 0.
#[derive(Clone, Debug)]
pub(super) struct Series {
    pub(super) low: i64,
    pub(super) coefficients: Vec<BigRational>,
}

impl Series {
    fn new(mut low: i64, mut coefficients: Vec<BigRational>) -> Option<Self> {
        let zeros = coefficients.iter().take_while(|c| c.is_zero()).count();
        coefficients.drain(..zeros);
        low += i64::try_from(zeros).ok()?;
        (!coefficients.is_empty()).then_some(Self { low, coefficients })
    }

    fn power_of_t(n: i64, terms: usize) -> Self {
        let mut coefficients = vec![BigRational::zero(); terms];
        coefficients[0] = BigRational::one();
        Self { low: n, coefficients }
    }

    /// The coefficient of tⁿ, if it is known.
    pub(super) fn coefficient(&self, n: i64) -> Option<BigRational> {
        match usize::try_from(n - self.low) {
            Ok(i) => self.coefficients.get(i).cloned(),
            Err(_) => Some(BigRational::zero()),
        }
    }

    /// Its sign for small t.
    pub(super) fn is_positive(&self) -> bool {
        self.coefficients[0].is_positive()
    }

    fn neg(&self) -> Self {
        Self { low: self.low, coefficients: self.coefficients.iter().map(|c| -c).collect() }
    }

    /// The sum, unless nothing of it is known but that it is small.
    fn add(&self, other: &Self) -> Option<Self> {
        let end = |s: &Self| s.low + i64::try_from(s.coefficients.len()).unwrap_or(i64::MAX);
        let low = self.low.min(other.low);
        let sum = (low..end(self).min(end(other)))
            .map(|n| Some(self.coefficient(n)? + other.coefficient(n)?))
            .collect::<Option<Vec<_>>>()?;
        Self::new(low, sum)
    }

    fn mul(&self, other: &Self) -> Self {
        let terms = self.coefficients.len().min(other.coefficients.len());
        let product = (0..terms)
            .map(|n| (0..=n).map(|i| &self.coefficients[i] * &other.coefficients[n - i]).sum())
            .collect();
        Self { low: self.low + other.low, coefficients: product }
    }

    fn recip(&self) -> Self {
        let lead = self.coefficients[0].recip();
        let mut out = vec![lead.clone()];
        for n in 1..self.coefficients.len() {
            let sum: BigRational = (1..=n).map(|i| &self.coefficients[i] * &out[n - i]).sum();
            out.push(-sum * &lead);
        }
        Self { low: -self.low, coefficients: out }
    }

    /// The root, where its powers of t and its coefficients are whole and rational.
    fn sqrt(&self) -> Option<Self> {
        let lead = &self.coefficients[0];
        if self.low % 2 != 0 || !lead.is_positive() {
            return None;
        }
        let root = |n: &BigInt| Some(n.sqrt()).filter(|r| r * r == *n);
        let first = BigRational::new(root(lead.numer())?, root(lead.denom())?);
        let twice = &first + &first;
        let mut out = vec![first];
        for n in 1..self.coefficients.len() {
            let sum: BigRational = (1..n).map(|i| &out[i] * &out[n - i]).sum();
            out.push((&self.coefficients[n] - sum) / &twice);
        }
        Some(Self { low: self.low / 2, coefficients: out })
    }

    fn pow(&self, n: u32) -> Self {
        let mut out = Self::power_of_t(0, self.coefficients.len());
        for _ in 0..n {
            out = out.mul(self);
        }
        out
    }
}

/// A number that is 0 has no series with a first coefficient.
#[derive(Clone, Debug)]
pub(super) enum Value {
    Zero,
    Series(Series),
}

impl Value {
    fn sign(&self) -> Ordering {
        match self {
            Self::Zero => Ordering::Equal,
            Self::Series(s) if s.is_positive() => Ordering::Greater,
            Self::Series(_) => Ordering::Less,
        }
    }
}

/// The series of expressions in one variable along x = a ± tⁿ or ±1/tⁿ.
pub(super) struct Along<'a, 'g> {
    pub(super) scope: &'a Scope<'g>,
    pub(super) side: &'a Side,
    pub(super) power: u32,
    pub(super) terms: usize,
}

/// Powers above this have no series here: their coefficients would be too large.
const MAX_POWER: u32 = 64;

impl Along<'_, '_> {
    fn x(&self) -> Option<Value> {
        let n = i64::from(self.power);
        let step = Series::power_of_t(if self.side.at.is_some() { n } else { -n }, self.terms);
        let step = if self.side.above { step } else { step.neg() };
        match &self.side.at {
            Some(a) => add(&self.number(a), &Value::Series(step)),
            None => Some(Value::Series(step)),
        }
    }

    fn number(&self, q: &BigRational) -> Value {
        if q.is_zero() {
            return Value::Zero;
        }
        let mut s = Series::power_of_t(0, self.terms);
        s.coefficients[0] = q.clone();
        Value::Series(s)
    }

    /// The series of an expression; `None` if it has none that is seen, or is not defined there.
    pub(super) fn value(&self, e: &Expr) -> Option<Value> {
        let v = |e: &Expr| self.value(e);
        match e {
            Expr::Num(q) => Some(self.number(q)),
            Expr::Var(v) => match self.scope.context.value(*v) {
                Some(value) => self.value(value),
                None if *v == self.side.var => self.x(),
                None => None,
            },
            Expr::Let(i) => v(&self.scope.context.lets.get(*i)?.body),
            Expr::Neg(a) => Some(neg(&v(a)?)),
            Expr::Add(a, b) => add(&v(a)?, &v(b)?),
            Expr::Sub(a, b) => add(&v(a)?, &neg(&v(b)?)),
            Expr::Mul(a, b) => Some(mul(&v(a)?, &v(b)?)),
            Expr::Div(a, b) => match v(b)? {
                Value::Zero => None,
                Value::Series(b) => Some(mul(&v(a)?, &Value::Series(b.recip()))),
            },
            Expr::Pow(a, n) => match v(a)? {
                Value::Zero if *n < 0 => None,
                Value::Zero if *n == 0 => Some(self.number(&BigRational::one())),
                Value::Zero => Some(Value::Zero),
                Value::Series(_) if n.unsigned_abs() > MAX_POWER => None,
                Value::Series(s) => {
                    let power = s.pow(n.unsigned_abs());
                    Some(Value::Series(if *n < 0 { power.recip() } else { power }))
                }
            },
            Expr::Sqrt(a) => match v(a)? {
                Value::Zero => Some(Value::Zero),
                Value::Series(s) => Some(Value::Series(s.sqrt()?)),
            },
            Expr::Abs(a) => {
                let a = v(a)?;
                Some(if a.sign() == Ordering::Less { neg(&a) } else { a })
            }
            Expr::Min(a, b) | Expr::Max(a, b) => {
                let (a, b) = (v(a)?, v(b)?);
                let greater = add(&a, &neg(&b))?.sign() == Ordering::Greater;
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
        let sign = add(&self.value(&r.lhs)?, &neg(&self.value(&r.rhs)?))?.sign();
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
    pub(super) fn polynomial(&self, p: &Poly) -> Option<Value> {
        let t = self.scope.germ();
        let mut sum = Value::Zero;
        for (monomial, c) in p.terms() {
            let mut product = self.number(&c.clone().into());
            for &(v, n) in monomial {
                let factor = if v == t {
                    Value::Series(Series::power_of_t(1, self.terms))
                } else if v == self.side.var {
                    self.x()?
                } else {
                    self.value(self.scope.root(v)?)?
                };
                for _ in 0..n.min(MAX_POWER) {
                    product = mul(&product, &factor);
                }
                if n > MAX_POWER {
                    return None;
                }
            }
            sum = add(&sum, &product)?;
        }
        Some(sum)
    }
}

fn neg(a: &Value) -> Value {
    match a {
        Value::Zero => Value::Zero,
        Value::Series(s) => Value::Series(s.neg()),
    }
}

fn add(a: &Value, b: &Value) -> Option<Value> {
    match (a, b) {
        (Value::Zero, other) | (other, Value::Zero) => Some(other.clone()),
        (Value::Series(a), Value::Series(b)) => Some(Value::Series(a.add(b)?)),
    }
}

fn mul(a: &Value, b: &Value) -> Value {
    match (a, b) {
        (Value::Series(a), Value::Series(b)) => Value::Series(a.mul(b)),
        _ => Value::Zero,
    }
}
