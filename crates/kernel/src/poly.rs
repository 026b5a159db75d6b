//! Sparse integer polynomials in several variables, expanded by nothing but sums and products.

use std::cell::Cell;
use std::cmp::Ordering;
use std::hash::{Hash, Hasher};
use std::rc::Rc;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::{Checked, Rejection, sign};

/// A budget of coefficient operations; what needs more is rejected, never waited for. Clones share
/// it.
#[derive(Clone, Debug)]
pub struct Fuel {
    left: Rc<Cell<u64>>,
    whole: Option<Rc<Self>>,
}

/// Terms and powers of one product, of each factor multiplied; words and powers of one power of two terms.
const WIDEST: usize = 8_000_000;
/// From this exponent on, a sum of two terms is raised by its binomial coefficients.
const BINOMIAL: u32 = 8;

impl Fuel {
    /// A budget of this many word-sized coefficient operations.
    #[must_use]
    pub fn new(steps: u64) -> Self {
        Self { left: Rc::new(Cell::new(steps)), whole: None }
    }

    /// A budget of its own, which is part of this one: what is spent of it is spent of both.
    #[must_use]
    pub fn within(&self, steps: u64) -> Self {
        Self { whole: Some(Rc::new(self.clone())), ..Self::new(steps) }
    }

    /// Takes `steps` from the budget of which this one is a part, if it is: work that this one does
    /// not count.
    ///
    /// # Errors
    /// [`Rejection::Budget`] when fewer are left there.
    pub fn spend_beyond(&self, steps: u64) -> Checked {
        self.whole.as_ref().map_or(Ok(()), |whole| whole.spend(steps))
    }

    /// Another budget beside this one, a part of the same whole if there is one.
    #[must_use]
    pub fn beside(&self, steps: u64) -> Self {
        Self { whole: self.whole.clone(), ..Self::new(steps) }
    }

    /// Operations that are left of this budget, and of all that it is part of.
    #[must_use]
    pub fn left(&self) -> u64 {
        let own = self.left.get();
        self.whole.as_ref().map_or(own, |whole| own.min(whole.left()))
    }

    /// Takes `steps` from the budget.
    ///
    /// # Errors
    /// [`Rejection::Budget`] when fewer are left.
    pub fn spend(&self, steps: u64) -> Checked {
        let (mut asked, mut is_short, mut budget) = (steps, false, Some(self));
        while let Some(Self { left, whole }) = budget {
            let spent = asked.min(left.get());
            left.set(left.get() - spent);
            is_short |= spent < asked;
            (asked, budget) = (spent, whole.as_deref());
        }
        if is_short { Err(Rejection::Budget) } else { Ok(()) }
    }
}

/// A variable and its exponent, which is ≥ 1 where it stands in a polynomial.
pub type Power = (usize, u32);

/// A product of powers: variables ascending.
pub type Monomial = Vec<Power>;

/// A polynomial with integer coefficients; no zero coefficient is stored. Exact. Clones share it:
/// regions and states repeat the same few polynomials many times.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Poly(Rc<Terms>);

/// Terms, monomials ascending: the powers of one after those of the other, and for each where its
/// own end and its coefficient.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Terms {
    powers: Vec<Power>,
    ends: Vec<(usize, BigInt)>,
}

impl Terms {
    fn with_room(powers: usize, terms: usize) -> Self {
        Self { powers: Vec::with_capacity(powers), ends: Vec::with_capacity(terms) }
    }
}

/// The sum of terms in any order.
fn sum(all: Terms) -> Poly {
    let all = Poly(Rc::new(all));
    if all.terms().is_sorted_by(|a, b| a.0 < b.0) && !all.terms().any(|t| t.1.is_zero()) {
        return all;
    }
    summed(all.terms().collect())
}

fn summed(mut terms: Vec<(&[Power], &BigInt)>) -> Poly {
    terms.sort_by_key(|t| t.0);
    let mut sum = Terms::with_room(terms.iter().map(|t| t.0.len()).sum(), terms.len());
    for same in terms.chunk_by(|a, b| a.0 == b.0) {
        let c = same[1..].iter().fold(same[0].1.clone(), |sum, t| sum + t.1);
        if !c.is_zero() {
            sum.powers.extend_from_slice(same[0].0);
            sum.ends.push((sum.powers.len(), c));
        }
    }
    Poly(Rc::new(sum))
}

impl Ord for Poly {
    fn cmp(&self, other: &Self) -> Ordering {
        self.terms().cmp(other.terms())
    }
}

impl PartialOrd for Poly {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Hash for Poly {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.len().hash(state);
        self.terms().for_each(|term| term.hash(state));
    }
}

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
        Self::term(vec![(v, n)], BigInt::one())
    }

    /// Coefficients, from v⁰ up, as a polynomial in v.
    #[must_use]
    pub fn in_variable(v: usize, coefficients: &[BigInt]) -> Self {
        Self::sum((0..).zip(coefficients).map(|(n, c)| (vec![(v, n)], c.clone())))
    }

    /// c·m, the zero polynomial if c = 0; the monomial in any order.
    #[must_use]
    pub fn term(m: Monomial, c: BigInt) -> Self {
        let powers = canonical(m);
        sum(Terms { ends: vec![(powers.len(), c)], powers })
    }

    /// The sum of c·m over all (m, c); monomials in any order.
    #[must_use]
    pub fn sum(terms: impl IntoIterator<Item = (Monomial, BigInt)>) -> Self {
        let mut all = Terms::default();
        for (m, c) in terms {
            all.powers.extend(canonical(m));
            all.ends.push((all.powers.len(), c));
        }
        sum(all)
    }

    /// Its terms, in a fixed order.
    pub fn terms(&self) -> impl Iterator<Item = (&[Power], &BigInt)> {
        let mut start = 0;
        let mut own = move |end: usize| std::mem::replace(&mut start, end)..end;
        self.0.ends.iter().map(move |(end, c)| (&self.0.powers[own(*end)], c))
    }

    /// Number of terms.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.ends.len()
    }

    /// Whether it is the zero polynomial.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.ends.is_empty()
    }

    /// Its value if it is a constant.
    #[must_use]
    pub fn as_constant(&self) -> Option<BigInt> {
        self.is_constant().then(|| self.0.ends.first().map_or_else(BigInt::zero, |t| t.1.clone()))
    }

    /// Whether it is a constant.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        self.0.powers.is_empty()
    }

    /// Variables that occur, ascending.
    #[must_use]
    pub fn vars(&self) -> Vec<usize> {
        let mut vars: Vec<usize> = self.0.powers.iter().map(|p| p.0).collect();
        vars.sort_unstable();
        vars.dedup();
        vars
    }

    /// Degree in the variable v.
    #[must_use]
    pub fn degree(&self, v: usize) -> u32 {
        self.0.powers.iter().filter(|p| p.0 == v).map(|p| p.1).max().unwrap_or(0)
    }

    /// Bits of the largest coefficient.
    #[must_use]
    pub fn bits(&self) -> u64 {
        self.0.ends.iter().map(|(_, c)| c.bits()).max().unwrap_or(0)
    }

    /// Sum.
    #[must_use]
    pub fn add(&self, other: &Self) -> Self {
        if self.is_empty() {
            return other.clone();
        }
        summed(self.terms().chain(other.terms()).collect())
    }

    /// Difference.
    #[must_use]
    pub fn sub(&self, other: &Self) -> Self {
        self.add(&other.neg())
    }

    /// The opposite.
    #[must_use]
    pub fn neg(&self) -> Self {
        self.each(|c| -c)
    }

    /// Product with an integer.
    #[must_use]
    pub fn scale(&self, k: &BigInt) -> Self {
        if k.is_zero() { Self::default() } else { self.each(|c| c * k) }
    }

    /// With every coefficient changed, none to zero.
    fn each(&self, change: impl Fn(&BigInt) -> BigInt) -> Self {
        let ends = self.0.ends.iter().map(|(end, c)| (*end, change(c))).collect();
        Self(Rc::new(Terms { powers: self.0.powers.clone(), ends }))
    }

    /// Product.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn mul(&self, other: &Self, fuel: &Fuel) -> Checked<Self> {
        let words = |p: &Self| 1 + p.bits() / 64;
        let pairs = (self.len() as u64).saturating_mul(other.len() as u64);
        // what is held before like terms are added up: memory, where `pairs` is time
        let held = |p: &Self| p.len() + p.0.powers.len();
        if held(self).saturating_mul(held(other)) > WIDEST {
            return Err(Rejection::Budget);
        }
        fuel.spend(pairs.saturating_mul(words(self)).saturating_mul(words(other)))?;
        // terms are as long as they have powers, and are sorted, which its own budget does not count
        let long = self.0.powers.len() * other.len() + other.0.powers.len() * self.len();
        fuel.spend_beyond(long as u64 * (1 + u64::from(pairs.max(1).ilog2())) / 8)?;
        let one = |p: &Self| matches!(&p.0.ends[..], [(0, c)] if c.is_one());
        if one(self) || one(other) {
            return Ok(if one(self) { other } else { self }.clone());
        }
        let mut product = Terms::with_room(long, self.len() * other.len());
        for (m, c) in self.terms() {
            for (n, d) in other.terms() {
                times(m, n, &mut product.powers)?;
                product.ends.push((product.powers.len(), c * d));
            }
        }
        Ok(sum(product))
    }

    /// Power: by repeated squaring, or, of two terms, by the binomial theorem.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn pow(&self, mut n: u32, fuel: &Fuel) -> Checked<Self> {
        if self.len() == 2 && n >= BINOMIAL {
            return self.binomial(n, fuel);
        }
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

    /// (a + b)ⁿ = Σ (n over k)·aⁿ⁻ᵏ·bᵏ for two terms a and b.
    fn binomial(&self, n: u32, fuel: &Fuel) -> Checked<Self> {
        // a coefficient is below 2^(n·(bits + 1)); each is held with its powers
        let words = (self.bits() + 1).saturating_mul(n.into()) / 64 + 1;
        let held = words.saturating_add(self.0.powers.len() as u64).saturating_mul(n.into());
        if held > WIDEST as u64 {
            return Err(Rejection::Budget);
        }
        fuel.spend(8 * held)?;
        let parts = self.terms().map(|(m, c)| Self::term(m.to_vec(), c.clone()));
        let [a, b] = <[Self; 2]>::try_from(parts.collect::<Vec<_>>()).unwrap_or_default();
        let (mut choices, mut all) = (BigInt::one(), Vec::new());
        for k in 0..=n {
            let term = a.pow(n - k, fuel)?.mul(&b.pow(k, fuel)?, fuel)?.scale(&choices);
            all.extend(term.terms().map(|(m, c)| (m.to_vec(), c.clone())));
            choices = choices * (n - k) / (k + 1);
        }
        Ok(Self::sum(all))
    }

    /// Coefficients of the powers of v, from v⁰ up; each free of v.
    #[must_use]
    pub fn coefficients(&self, v: usize) -> Vec<Self> {
        (0..=self.degree(v)).map(|n| self.coefficient(v, n)).collect()
    }

    /// Coefficient of vⁿ; free of v. However large n is, it takes no more room than the polynomial.
    #[must_use]
    pub fn coefficient(&self, v: usize, n: u32) -> Self {
        let mut out = Terms::with_room(self.0.powers.len(), self.len());
        for (m, c) in self.terms().filter(|(m, _)| exponent(m, v) == n) {
            out.powers.extend(m.iter().filter(|p| p.0 != v));
            out.ends.push((out.powers.len(), c.clone()));
        }
        sum(out)
    }

    /// ∂p/∂v
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn derivative(&self, v: usize, fuel: &Fuel) -> Checked<Self> {
        fuel.spend(u64::try_from(self.len()).unwrap_or(u64::MAX))?;
        let lower = |&(w, n): &Power| (w, if w == v { n - 1 } else { n });
        let terms = self.terms().filter(|(m, _)| exponent(m, v) > 0);
        Ok(Self::sum(terms.map(|(m, c)| (m.iter().map(lower).collect(), c * exponent(m, v)))))
    }

    /// Splits off the largest non-negative integer that divides all coefficients: (content, rest).
    #[must_use]
    pub fn primitive(&self) -> (BigInt, Self) {
        let gcd = |g: BigInt, (_, c): &(_, BigInt)| if g.is_one() { g } else { g.gcd(c) };
        let content = self.0.ends.iter().fold(BigInt::zero(), gcd);
        if content.is_zero() || content.is_one() {
            return (BigInt::one(), self.clone());
        }
        let rest = self.each(|c| c / &content);
        (content, rest)
    }

    /// As a polynomial in v alone, if no other variable occurs.
    #[must_use]
    pub fn univariate(&self, v: usize) -> Option<Vec<BigInt>> {
        let alone = self.0.powers.iter().all(|p| p.0 == v);
        let mut out = alone.then(|| vec![BigInt::zero(); self.degree(v) as usize + 1])?;
        self.terms().for_each(|(m, c)| out[exponent(m, v) as usize] = c.clone());
        Some(out)
    }

    /// Remainder of leadⁿ·p by an equation lead·vᵈ + … with d ≥ 1: its degree in v is below d, and it
    /// is zero where p and the equation are. With `even`, n is even, so that the sign survives.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn remainder(&self, v: usize, equation: &Self, even: bool, fuel: &Fuel) -> Checked<Self> {
        let degree = equation.degree(v);
        let lead = || equation.coefficient(v, degree);
        let (mut rest, mut odd) = (self.clone(), false);
        while degree > 0 && rest.degree(v) >= degree {
            // lead·p − top·vᵏ·equation loses the top power.
            let shift = Self::power(v, rest.degree(v) - degree);
            let top = rest.coefficient(v, rest.degree(v)).mul(&shift, fuel)?;
            rest = rest.mul(&lead(), fuel)?.sub(&top.mul(equation, fuel)?);
            odd = !odd;
        }
        if even && odd { rest.mul(&lead(), fuel) } else { Ok(rest) }
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
pub fn exponent(m: &[Power], v: usize) -> u32 {
    m.iter().find(|p| p.0 == v).map_or(0, |p| p.1)
}

/// Puts the powers of a product of monomials at the end.
fn times<'a>(mut a: &'a [Power], mut b: &'a [Power], out: &mut Vec<Power>) -> Checked {
    while let ([x, rest @ ..], [y, others @ ..]) = (a, b) {
        if x.0 == y.0 {
            out.push((x.0, x.1.checked_add(y.1).ok_or(Rejection::Budget)?));
            (a, b) = (rest, others);
        } else if x.0 < y.0 {
            out.push(*x);
            a = rest;
        } else {
            (a, b) = (b, a);
        }
    }
    out.extend(a.iter().chain(b));
    Ok(())
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
