//! Sparse integer polynomials in several variables, expanded by nothing but sums and products.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::rc::Rc;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::{Checked, Rejection, sign};

/// A budget of coefficient operations; what needs more is rejected, never waited for. Clones share
/// it.
#[derive(Clone, Debug)]
pub struct Fuel(Rc<Cell<u64>>);

impl Fuel {
    /// A budget of this many word-sized coefficient operations.
    #[must_use]
    pub fn new(steps: u64) -> Self {
        Self(Rc::new(Cell::new(steps)))
    }

    /// Takes `steps` from the budget.
    ///
    /// # Errors
    /// [`Rejection::Budget`] when fewer are left.
    pub fn spend(&self, steps: u64) -> Checked {
        let left = self.0.get().checked_sub(steps);
        self.0.set(left.unwrap_or(0));
        left.map(|_| ()).ok_or(Rejection::Budget)
    }
}

/// A product of powers: (variable, exponent ≥ 1), variables ascending.
pub type Monomial = Vec<(usize, u32)>;

/// A polynomial with integer coefficients; no zero coefficient is stored. Exact. Clones share it:
/// regions and states repeat the same few polynomials many times.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Poly(Rc<BTreeMap<Monomial, BigInt>>);

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
        Self::power(v, 1)
    }

    /// vⁿ
    #[must_use]
    pub fn power(v: usize, n: u32) -> Self {
        Self::term(if n == 0 { Vec::new() } else { vec![(v, n)] }, BigInt::one())
    }

    /// Coefficients, from v⁰ up, as a polynomial in v.
    #[must_use]
    pub fn in_variable(v: usize, coefficients: &[BigInt]) -> Self {
        let powers = (0..).zip(coefficients).map(|(n, c)| Self::power(v, n).scale(c));
        powers.fold(Self::default(), |sum, power| sum.add(&power))
    }

    /// c·m, the zero polynomial if c = 0; the monomial in any order.
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
        match Rc::make_mut(&mut self.0).entry(canonical(m)) {
            Entry::Vacant(e) => {
                e.insert(c);
            }
            Entry::Occupied(mut e) => {
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
        match self.0.first_key_value() {
            None => Some(BigInt::zero()),
            Some((m, c)) if m.is_empty() && self.len() == 1 => Some(c.clone()),
            Some(_) => None,
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
        sum.add_all(other);
        sum
    }

    /// Adds another polynomial in place.
    pub fn add_all(&mut self, other: &Self) {
        for (m, c) in other.terms() {
            self.add_term(m.clone(), c.clone());
        }
    }

    /// Difference.
    #[must_use]
    pub fn sub(&self, other: &Self) -> Self {
        self.add(&other.neg())
    }

    /// The opposite.
    #[must_use]
    pub fn neg(&self) -> Self {
        self.scale(&-BigInt::one())
    }

    /// Product with an integer.
    #[must_use]
    pub fn scale(&self, k: &BigInt) -> Self {
        let terms = self.0.iter().filter(|_| !k.is_zero());
        Self(Rc::new(terms.map(|(m, c)| (m.clone(), c * k)).collect()))
    }

    /// Product.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn mul(&self, other: &Self, fuel: &Fuel) -> Checked<Self> {
        let size = |p: &Self| u64::try_from(p.len()).unwrap_or(u64::MAX);
        let words = |p: &Self| 1 + p.bits() / 64;
        let pairs = size(self).saturating_mul(size(other));
        fuel.spend(pairs.saturating_mul(words(self)).saturating_mul(words(other)))?;
        let mut product = Self::default();
        for (m, c) in self.terms() {
            for (n, d) in other.terms() {
                product.add_term(times(m, n)?, c * d);
            }
        }
        Ok(product)
    }

    /// Power by repeated squaring.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn pow(&self, mut n: u32, fuel: &Fuel) -> Checked<Self> {
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
        for (m, c) in self.terms() {
            let e = usize::try_from(exponent(m, v)).unwrap_or(usize::MAX);
            let rest = m.iter().copied().filter(|&(w, _)| w != v).collect();
            out[e].add_term(rest, c.clone());
        }
        out
    }

    /// Coefficient of vⁿ; free of v. However large n is, it takes no more room than the polynomial.
    #[must_use]
    pub fn coefficient(&self, v: usize, n: u32) -> Self {
        let mut out = Self::default();
        for (m, c) in self.terms().filter(|(m, _)| exponent(m, v) == n) {
            out.add_term(m.iter().copied().filter(|&(w, _)| w != v).collect(), c.clone());
        }
        out
    }

    /// ∂p/∂v
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn derivative(&self, v: usize, fuel: &Fuel) -> Checked<Self> {
        fuel.spend(u64::try_from(self.len()).unwrap_or(u64::MAX))?;
        let mut sum = Self::default();
        for (m, c) in self.terms().filter(|(m, _)| exponent(m, v) > 0) {
            let lower = |&(w, n): &(usize, u32)| (w, if w == v { n - 1 } else { n });
            sum.add_term(m.iter().map(lower).collect(), c * exponent(m, v));
        }
        Ok(sum)
    }

    /// Splits off the largest non-negative integer that divides all coefficients: (content, rest).
    #[must_use]
    pub fn primitive(&self) -> (BigInt, Self) {
        let content = self.0.values().fold(BigInt::zero(), |g, c| g.gcd(c));
        if content.is_zero() || content.is_one() {
            return (BigInt::one(), self.clone());
        }
        let rest = self.0.iter().map(|(m, c)| (m.clone(), c / &content)).collect();
        (content, Self(Rc::new(rest)))
    }

    /// As a polynomial in v alone, if no other variable occurs.
    #[must_use]
    pub fn univariate(&self, v: usize) -> Option<Vec<BigInt>> {
        self.coefficients(v).iter().map(Self::as_constant).collect()
    }

    /// Remainder of leadⁿ·p by an equation lead·vᵈ + … with d ≥ 1: its degree in v is below d, and it
    /// is zero where p and the equation are. With `even`, n is even, so that the sign survives.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn remainder(&self, v: usize, equation: &Self, even: bool, fuel: &Fuel) -> Checked<Self> {
        let degree = equation.degree(v);
        let lead = equation.coefficient(v, degree);
        let (mut rest, mut odd) = (self.clone(), false);
        while degree > 0 && rest.degree(v) >= degree {
            // lead·p − top·vᵏ·equation loses the top power.
            let shift = Self::power(v, rest.degree(v) - degree);
            let top = rest.coefficient(v, rest.degree(v)).mul(&shift, fuel)?;
            rest = rest.mul(&lead, fuel)?.sub(&top.mul(equation, fuel)?);
            odd = !odd;
        }
        if even && odd { rest.mul(&lead, fuel) } else { Ok(rest) }
    }
}

/// A monomial with each variable once, ascending, and no power 0.
fn canonical(mut m: Monomial) -> Monomial {
    if m.windows(2).any(|w| w[0].0 >= w[1].0) || m.iter().any(|p| p.1 == 0) {
        m.sort_unstable();
        // What a caller adds up beyond the range of powers stays a monomial, if another one.
        m.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            kept.1 = if same { kept.1.saturating_add(next.1) } else { kept.1 };
            same
        });
        m.retain(|p| p.1 > 0);
    }
    m
}

/// Exponent of v in m.
#[must_use]
pub fn exponent(m: &Monomial, v: usize) -> u32 {
    m.iter().find(|p| p.0 == v).map_or(0, |p| p.1)
}

fn times(a: &Monomial, b: &Monomial) -> Checked<Monomial> {
    let mut out = a.clone();
    for &(v, e) in b {
        match out.binary_search_by_key(&v, |p| p.0) {
            Ok(i) => out[i].1 = out[i].1.checked_add(e).ok_or(Rejection::Budget)?,
            Err(i) => out.insert(i, (v, e)),
        }
    }
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
    pub fn add(&self, o: &Self, fuel: &Fuel) -> Checked<Self> {
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
    pub fn mul(&self, o: &Self, fuel: &Fuel) -> Checked<Self> {
        Ok(Self { num: self.num.mul(&o.num, fuel)?, den: self.den.mul(&o.den, fuel)? })
    }

    /// Quotient; the other must not be zero.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn over(&self, o: &Self, fuel: &Fuel) -> Checked<Self> {
        Ok(Self { num: self.num.mul(&o.den, fuel)?, den: self.den.mul(&o.num, fuel)? })
    }

    /// Power.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn pow(&self, n: u32, fuel: &Fuel) -> Checked<Self> {
        Ok(Self { num: self.num.pow(n, fuel)?, den: self.den.pow(n, fuel)? })
    }

    /// A polynomial with the sign of the fraction wherever the denominator is not zero.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn sign_poly(&self, fuel: &Fuel) -> Checked<Poly> {
        match self.den.as_constant() {
            Some(c) => Ok(self.num.scale(&BigInt::from(sign(&c)))),
            None => self.num.mul(&self.den, fuel),
        }
    }
}
