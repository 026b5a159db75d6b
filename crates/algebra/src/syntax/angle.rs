//! Angles: the sine and the cosine of a sum of angles as polynomials in those of its parts.
//!
//! An angle θ is not a number here. What stands for it is the point (cos θ, sin θ) of the unit circle, and
//! where halves or thirds of it are spoken of, the point of its finest part. So all that is said by
//! sines and cosines is algebra: addition theorems, cos² + sin² = 1, and surds at multiples of π/12.

use std::collections::BTreeMap;
use std::rc::Rc;

use kane_kernel::Expr;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::error::SyntaxErrorKind;
use super::names::PI;
use super::scope::Scope;

/// The greatest multiple of a part that is written out.
const MAX_MULTIPLE: u32 = 24;
/// The finest part of an angle.
const MAX_PARTS: u32 = 12;

/// A sum of angles with rational factors, a multiple of π, and a number.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Turn {
    /// by symbol
    pub angles: BTreeMap<usize, BigRational>,
    /// the multiple of π
    pub half_turns: BigRational,
    /// what is no angle
    pub number: BigRational,
}

impl Turn {
    /// What an expression is as a sum; `None` if it is none.
    pub(crate) fn of(e: &Expr) -> Option<Self> {
        let pair = |a: &Expr, b: &Expr| Some((Self::of(a)?, Self::of(b)?));
        Some(match e {
            Expr::Num(q) => Self { number: q.clone(), ..Self::default() },
            Expr::Var(PI) => Self { half_turns: BigRational::one(), ..Self::default() },
            Expr::Var(v) => Self { angles: [(*v, BigRational::one())].into(), ..Self::default() },
            Expr::Neg(a) => Self::of(a)?.times(&-BigRational::one()),
            Expr::Add(a, b) => pair(a, b)?.0.plus(&pair(a, b)?.1),
            Expr::Sub(a, b) => pair(a, b)?.0.plus(&pair(a, b)?.1.times(&-BigRational::one())),
            Expr::Mul(a, b) => match pair(a, b)? {
                (a, b) if a.is_number() => b.times(&a.number),
                (a, b) if b.is_number() => a.times(&b.number),
                _ => return None,
            },
            Expr::Div(a, b) => match pair(a, b)? {
                (a, b) if b.is_number() && !b.number.is_zero() => a.times(&b.number.recip()),
                _ => return None,
            },
            _ => return None,
        })
    }

    fn plus(mut self, other: &Self) -> Self {
        for (v, q) in &other.angles {
            *self.angles.entry(*v).or_default() += q;
        }
        self.angles.retain(|_, q| !q.is_zero());
        self.half_turns += &other.half_turns;
        self.number += &other.number;
        self
    }

    fn times(mut self, factor: &BigRational) -> Self {
        self.angles.values_mut().for_each(|q| *q *= factor);
        self.angles.retain(|_, q| !q.is_zero());
        self.half_turns *= factor;
        self.number *= factor;
        self
    }

    /// Whether it is a number alone.
    pub(crate) fn is_number(&self) -> bool {
        self.angles.is_empty() && self.half_turns.is_zero()
    }

    /// Cosine and sine. Exact.
    ///
    /// # Errors
    /// When a summand is no angle, an angle is not known in parts as fine, or π has a factor whose cosine
    /// is no common surd.
    pub fn direction(&self, scope: &Scope) -> Result<Direction, SyntaxErrorKind> {
        if !self.number.is_zero() {
            return Err(SyntaxErrorKind::NotAnAngle);
        }
        let mut sum = surd(&self.half_turns).ok_or(SyntaxErrorKind::NoSurd)?;
        for (v, factor) in &self.angles {
            let angle = scope.angle(*v);
            let name = scope.context().vars.get(*v).map_or("?", |var| &var.name);
            let parts = BigInt::from(angle.map_or(1, |angle| angle.parts));
            let multiple = factor * BigRational::from_integer(parts.clone());
            let Some(angle) = angle.filter(|_| multiple.is_integer()) else {
                let parts = num_integer::lcm(parts, factor.denom().clone());
                let parts = parts.to_u32().filter(|n| *n <= MAX_PARTS);
                let parts = parts.ok_or(SyntaxErrorKind::TooFine)?;
                return Err(SyntaxErrorKind::NoAngle { name: name.to_owned(), parts });
            };
            let times = multiple.numer().magnitude().to_u32().filter(|n| *n <= MAX_MULTIPLE);
            let times = times.ok_or(SyntaxErrorKind::TooOften)?;
            let (cos, sin) = (Expr::Var(angle.cos), Expr::Var(angle.sin));
            let part = multiples(&cos, &sin, times);
            sum = sum.turned(&if factor.is_negative() { part.mirrored() } else { part });
        }
        Ok(sum)
    }
}

/// A point of the unit circle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Direction {
    /// the cosine of its angle
    pub cos: Expr,
    /// the sine of its angle
    pub sin: Expr,
}

impl Direction {
    fn mirrored(self) -> Self {
        Self { sin: negative(self.sin), ..self }
    }

    /// cos(a + b) and sin(a + b)
    fn turned(&self, by: &Self) -> Self {
        let product = |a: &Expr, b: &Expr| product(a.clone(), b.clone());
        Self {
            cos: sum(product(&self.cos, &by.cos), negative(product(&self.sin, &by.sin))),
            sin: sum(product(&self.sin, &by.cos), product(&self.cos, &by.sin)),
        }
    }
}

/// cos(nφ) and sin(nφ) from the powers of cos φ + i·sin φ.
fn multiples(c: &Expr, s: &Expr, n: u32) -> Direction {
    let (mut cos, mut sin) = (Expr::int(0), Expr::int(0));
    let mut binomial = BigInt::one();
    for k in 0..=n {
        let power = |e: &Expr, n: u32| match i32::try_from(n) {
            Ok(0) | Err(_) => Expr::int(1),
            Ok(1) => e.clone(),
            Ok(n) => Expr::Pow(e.clone().into(), n),
        };
        let term = product(power(c, n - k), power(s, k));
        let term = product(Expr::Num(binomial.clone().into()), term);
        let term = if k % 4 < 2 { term } else { negative(term) };
        if k % 2 == 0 {
            cos = sum(cos, term);
        } else {
            sin = sum(sin, term);
        }
        binomial = binomial * (n - k) / (k + 1);
    }
    Direction { cos, sin }
}

/// Cosine and sine of a multiple of π/12.
fn surd(half_turns: &BigRational) -> Option<Direction> {
    let twelfths = half_turns * BigRational::from_integer(12.into());
    if !twelfths.is_integer() {
        return None;
    }
    let k = num_integer::mod_floor(twelfths.numer().clone(), BigInt::from(24)).to_u32()?;
    let cosine = |k: u32| {
        let k = k % 24;
        let k = if k > 12 { 24 - k } else { k };
        let acute = |k: u32| -> Expr {
            let root = |n| Expr::Sqrt(Expr::int(n).into());
            let over = |e: Expr, n| Expr::Div(e.into(), Expr::int(n).into());
            match k {
                0 => Expr::int(1),
                1 => over(Expr::Add(root(6).into(), root(2).into()), 4),
                2 => over(root(3), 2),
                3 => over(root(2), 2),
                4 => over(Expr::int(1), 2),
                5 => over(Expr::Sub(root(6).into(), root(2).into()), 4),
                _ => Expr::int(0),
            }
        };
        if k > 6 { negative(acute(12 - k)) } else { acute(k) }
    };
    Some(Direction { cos: cosine(k), sin: cosine(k + 18) })
}

fn is_whole(e: &Expr, n: i64) -> bool {
    *e == Expr::int(n)
}

pub(crate) fn sum(a: Expr, b: Expr) -> Expr {
    match (a, b) {
        (a, b) if is_whole(&a, 0) => b,
        (a, b) if is_whole(&b, 0) => a,
        (a, Expr::Neg(b)) => Expr::Sub(a.into(), b),
        (a, b) => Expr::Add(a.into(), b.into()),
    }
}

pub(crate) fn product(a: Expr, b: Expr) -> Expr {
    match (a, b) {
        (a, b) if is_whole(&a, 0) || is_whole(&b, 0) => Expr::int(0),
        (a, b) if is_whole(&a, 1) => b,
        (a, b) if is_whole(&b, 1) => a,
        (Expr::Neg(a), b) | (b, Expr::Neg(a)) => negative(product(Rc::unwrap_or_clone(a), b)),
        (a, b) => Expr::Mul(a.into(), b.into()),
    }
}

pub(crate) fn negative(a: Expr) -> Expr {
    match a {
        Expr::Neg(a) => Rc::unwrap_or_clone(a),
        a if is_whole(&a, 0) => a,
        a => Expr::Neg(a.into()),
    }
}
