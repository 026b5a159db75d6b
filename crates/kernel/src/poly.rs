//! Sparse integer polynomials in several variables, expanded by nothing but sums and products.

use std::cell::Cell;
use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::Rejection;

/// A budget of coefficient operations; what needs more is rejected, never waited for.
#[derive(Debug)]
pub struct Fuel(Cell<u64>);

impl Fuel {
    /// A budget of this many word-sized coefficient operations.
    #[must_use]
    pub fn new(steps: u64) -> Self {
        Self(Cell::new(steps))
    }

    /// Steps left.
    #[must_use]
    pub fn left(&self) -> u64 {
        self.0.get()
    }

    /// Takes `steps` from the budget.
    ///
    /// # Errors
    /// [`Rejection::Budget`] when fewer are left.
    pub fn spend(&self, steps: u64) -> Result<(), Rejection> {
        match self.0.get().checked_sub(steps) {
            Some(left) => {
                self.0.set(left);
                Ok(())
            }
            None => {
                self.0.set(0);
                Err(Rejection::Budget)
            }
        }
    }
}

/// A product of powers: (variable, exponent ≥ 1), variables ascending.
pub type Monomial = Vec<(usize, u32)>;

/// A polynomial with integer coefficients; no zero coefficient is stored. Exact.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Poly(BTreeMap<Monomial, BigInt>);

impl Poly {
    /// The constant polynomial c.
    #[must_use]
    pub fn constant(c: BigInt) -> Self {
        Self::term(Vec::new(), c)
    }

    /// 1
    #[must_use]
    pub fn one() -> Self {
        Self::constant(BigInt::one())
    }

    /// The variable v.
    #[must_use]
    pub fn var(v: usize) -> Self {
        Self::term(vec![(v, 1)], BigInt::one())
    }

    /// c·m, the zero polynomial if c = 0. The monomial must be ascending in its variables.
    #[must_use]
    pub fn term(m: Monomial, c: BigInt) -> Self {
        let mut p = Self::default();
        p.add_term(m, c);
        p
    }

    /// Adds c·m in place.
    pub fn add_term(&mut self, m: Monomial, c: BigInt) {
        if c.is_zero() {
            return;
        }
        match self.0.entry(m) {
            std::collections::btree_map::Entry::Vacant(e) => {
                e.insert(c);
            }
            std::collections::btree_map::Entry::Occupied(mut e) => {
                *e.get_mut() += c;
                if e.get().is_zero() {
                    e.remove();
                }
            }
        }
    }

    /// Its terms, in a fixed order.
    pub fn terms(&self) -> impl Iterator<Item = (&Monomial, &BigInt)> {
        self.0.iter()
    }

    /// Number of terms.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether it is the zero polynomial.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Its value if it is a constant.
    #[must_use]
    pub fn as_constant(&self) -> Option<BigInt> {
        match self.0.len() {
            0 => Some(BigInt::zero()),
            1 => self.0.get(&Vec::new()).cloned(),
            _ => None,
        }
    }

    /// Variables that occur, ascending.
    #[must_use]
    pub fn vars(&self) -> Vec<usize> {
        let mut vars: Vec<usize> = self.0.keys().flatten().map(|&(v, _)| v).collect();
        vars.sort_unstable();
        vars.dedup();
        vars
    }

    /// Degree in the variable v.
    #[must_use]
    pub fn degree(&self, v: usize) -> u32 {
        self.0.keys().map(|m| exponent(m, v)).max().unwrap_or(0)
    }

    /// Bits of the largest coefficient.
    #[must_use]
    pub fn bits(&self) -> u64 {
        self.0.values().map(BigInt::bits).max().unwrap_or(0)
    }

    /// Sum.
    #[must_use]
    pub fn add(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (m, c) in &other.0 {
            sum.add_term(m.clone(), c.clone());
        }
        sum
    }

    /// Difference.
    #[must_use]
    pub fn sub(&self, other: &Self) -> Self {
        self.add(&other.neg())
    }

    /// The opposite.
    #[must_use]
    pub fn neg(&self) -> Self {
        Self(self.0.iter().map(|(m, c)| (m.clone(), -c)).collect())
    }

    /// Product with an integer.
    #[must_use]
    pub fn scale(&self, k: &BigInt) -> Self {
        if k.is_zero() {
            return Self::default();
        }
        Self(self.0.iter().map(|(m, c)| (m.clone(), c * k)).collect())
    }

    /// Product.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn mul(&self, other: &Self, fuel: &Fuel) -> Result<Self, Rejection> {
        let words = |p: &Self| 1 + p.bits() / 64;
        let count = |p: &Self| u64::try_from(p.len()).unwrap_or(u64::MAX);
        fuel.spend(
            count(self)
                .saturating_mul(count(other))
                .saturating_mul(words(self).saturating_mul(words(other))),
        )?;
        let mut product = Self::default();
        for (m, c) in &self.0 {
            for (n, d) in &other.0 {
                product.add_term(times(m, n)?, c * d);
            }
        }
        Ok(product)
    }

    /// Power by repeated squaring.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn pow(&self, mut n: u32, fuel: &Fuel) -> Result<Self, Rejection> {
        let (mut power, mut base) = (Self::one(), self.clone());
        while n > 0 {
            if n & 1 == 1 {
                power = power.mul(&base, fuel)?;
            }
            n >>= 1;
            if n > 0 {
                base = base.mul(&base, fuel)?;
            }
        }
        Ok(power)
    }

    /// Coefficients of the powers of v, from v⁰ up; each free of v.
    #[must_use]
    pub fn coefficients(&self, v: usize) -> Vec<Self> {
        let degree = usize::try_from(self.degree(v)).unwrap_or(usize::MAX);
        let mut out = vec![Self::default(); degree + 1];
        for (m, c) in &self.0 {
            let e = usize::try_from(exponent(m, v)).unwrap_or(usize::MAX);
            let rest = m.iter().copied().filter(|&(w, _)| w != v).collect();
            out[e].add_term(rest, c.clone());
        }
        out
    }

    /// Splits off the largest non-negative integer that divides all coefficients: (content, rest).
    #[must_use]
    pub fn primitive(&self) -> (BigInt, Self) {
        let content = self.0.values().fold(BigInt::zero(), |g, c| g.gcd(c));
        if content.is_zero() || content.is_one() {
            return (BigInt::one(), self.clone());
        }
        let rest = self.0.iter().map(|(m, c)| (m.clone(), c / &content));
        (content.clone(), Self(rest.collect()))
    }

    /// As a polynomial in v alone, if no other variable occurs.
    #[must_use]
    pub fn univariate(&self, v: usize) -> Option<Vec<BigInt>> {
        self.coefficients(v).iter().map(Self::as_constant).collect()
    }

    /// Remainder of leadⁿ·p by an equation Σ eqᵢ·vⁱ of degree d ≥ 1 in v: degree below d, zero where
    /// p and the equation are. With `even`, n is even, so that the sign survives.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn remainder(
        &self,
        v: usize,
        equation: &[Self],
        even: bool,
        fuel: &Fuel,
    ) -> Result<Self, Rejection> {
        let Some((lead, lower)) = equation.split_last() else {
            return Ok(self.clone());
        };
        let mut parts = self.coefficients(v);
        let mut odd = false;
        while parts.len() > lower.len() {
            // lead·p − top·v^k·equation loses the top power.
            let top = parts.pop().unwrap_or_default();
            if top.is_empty() {
                continue;
            }
            let shift = parts.len() - lower.len();
            for (i, part) in parts.iter_mut().enumerate() {
                *part = part.mul(lead, fuel)?;
                if let Some(c) = i.checked_sub(shift).and_then(|j| lower.get(j)) {
                    *part = part.sub(&top.mul(c, fuel)?);
                }
            }
            odd = !odd;
        }
        let mut sum = Self::default();
        for (n, part) in (0u32..).zip(&parts) {
            let power = Self::term(if n == 0 { Vec::new() } else { vec![(v, n)] }, BigInt::one());
            sum = sum.add(&part.mul(&power, fuel)?);
        }
        if even && odd { sum.mul(lead, fuel) } else { Ok(sum) }
    }
}

/// Exponent of v in m.
#[must_use]
pub fn exponent(m: &Monomial, v: usize) -> u32 {
    m.iter().find(|p| p.0 == v).map_or(0, |p| p.1)
}

fn times(a: &Monomial, b: &Monomial) -> Result<Monomial, Rejection> {
    let mut out = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        match a[i].0.cmp(&b[j].0) {
            std::cmp::Ordering::Less => {
                out.push(a[i]);
                i += 1;
            }
            std::cmp::Ordering::Greater => {
                out.push(b[j]);
                j += 1;
            }
            std::cmp::Ordering::Equal => {
                let e = a[i].1.checked_add(b[j].1).ok_or(Rejection::Budget)?;
                out.push((a[i].0, e));
                i += 1;
                j += 1;
            }
        }
    }
    out.extend_from_slice(&a[i..]);
    out.extend_from_slice(&b[j..]);
    Ok(out)
}

/// A rational function as numerator and denominator, never cancelled.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fraction {
    /// numerator
    pub num: Poly,
    /// denominator; whoever holds a fraction also holds the condition that this is not zero
    pub den: Poly,
}

impl Fraction {
    /// p / 1
    #[must_use]
    pub fn whole(num: Poly) -> Self {
        Self { num, den: Poly::one() }
    }

    /// The constant q.
    #[must_use]
    pub fn rational(q: &BigRational) -> Self {
        Self { num: Poly::constant(q.numer().clone()), den: Poly::constant(q.denom().clone()) }
    }

    /// Sum; equal denominators are kept, others multiplied.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn add(&self, o: &Self, fuel: &Fuel) -> Result<Self, Rejection> {
        if self.den == o.den {
            return Ok(Self { num: self.num.add(&o.num), den: self.den.clone() });
        }
        Ok(Self {
            num: self.num.mul(&o.den, fuel)?.add(&o.num.mul(&self.den, fuel)?),
            den: self.den.mul(&o.den, fuel)?,
        })
    }

    /// The opposite.
    #[must_use]
    pub fn neg(&self) -> Self {
        Self { num: self.num.neg(), den: self.den.clone() }
    }

    /// Product.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn mul(&self, o: &Self, fuel: &Fuel) -> Result<Self, Rejection> {
        Ok(Self { num: self.num.mul(&o.num, fuel)?, den: self.den.mul(&o.den, fuel)? })
    }

    /// A polynomial with the sign of the fraction wherever the denominator is not zero.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn sign_poly(&self, fuel: &Fuel) -> Result<Poly, Rejection> {
        match self.den.as_constant() {
            Some(c) if c.is_negative() => Ok(self.num.neg()),
            Some(_) => Ok(self.num.clone()),
            None => self.num.mul(&self.den, fuel),
        }
    }
}
