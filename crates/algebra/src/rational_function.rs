//! Rational functions over ℚ in several symbols, in lowest terms, with all that must not vanish.

use std::cmp::Reverse;
use std::collections::{BTreeSet, HashMap};
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

use kane_kernel::{Context, Expr, Fuel, Monomial, Poly, Power, Rejection, Rel, Relation, Var};
use kane_number::{Number, Rational};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use polycore::Order;
use thiserror::Error;

use crate::fraction::Fraction;
use crate::ring;
use crate::syntax::Notation;

type Foreign = polycore::Poly<Rational>;

/// A rational function of the symbols of a context, and where it is defined.
///
/// The value is kept in lowest terms; every divisor ever met stays as a condition `divisor ≠ 0`,
/// so that x/x is 1 *when x ≠ 0*, and cancelling never widens the domain. All operations are
/// exact. A sum or product is defined where both operands are, a quotient where the divisor is not
/// zero besides.
///
/// Two functions are equal when they agree wherever both are defined: equality compares values in
/// lowest terms, not conditions. With it rational functions are a field, hence a [`Number`], and
/// a law written over that trait runs on symbols.
///
/// ```
/// use kane_algebra::rational_function::RationalFunction;
/// use kane_algebra::syntax::{Notation, Scope, parse_expr};
/// use kane_kernel::Var;
///
/// let mut scope = Scope::default();
/// scope.declare(Var { name: "x".to_owned(), of: None, lower: None, upper: None })?;
/// let e = parse_expr("(x^2 - 1)/(2*x - 2)", &scope).expect("well-formed");
/// let f = RationalFunction::from_expr(&e, scope.context())?;
/// assert_eq!(f.plain(scope.context()), "(x + 1)/2 when x - 1 != 0");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct RationalFunction {
    /// symbol i is variable i
    value: Fraction,
    /// none of these vanishes; the denominator divides a product of them
    conditions: BTreeSet<Poly>,
}

/// Why an expression is not a rational function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum NotRational {
    /// a root, a magnitude, a choice: named as it is written
    #[error("`{0}` is not a rational operation")]
    Operation(&'static str),
    /// a divisor vanishes identically, so the expression is defined nowhere
    #[error("division by zero everywhere")]
    DivisionByZero,
    /// the derivative of something that holds an undefined function of the symbol
    #[error("the derivative of a function that is not given")]
    NotExplicit,
    /// the context lacks a symbol or a definition
    #[error("a symbol or definition that is not declared")]
    Unknown,
    /// beyond the size up to which the polynomial libraries answer promptly
    #[error("too large to expand")]
    TooLarge,
}

impl RationalFunction {
    /// num/den in lowest terms, provided den ≠ 0; `None` if den is the zero polynomial.
    #[must_use]
    pub fn new(num: &Poly, den: &Poly) -> Option<Self> {
        let value = Fraction::new(outward(num), outward(den))?;
        Self::of(value).provided(den)
    }

    /// The symbol at this index of the context.
    #[must_use]
    pub fn symbol(index: usize) -> Self {
        Self::of(Foreign::var(index, index + 1, Order::GRevLex).into())
    }

    /// What an expression says, definitions and derivatives expanded. Undefined functions count as
    /// symbols. Recursion is as deep as the expression is high.
    ///
    /// The conditions are those under which every part of the expression is defined.
    ///
    /// # Errors
    /// When the expression is no rational function, is defined nowhere, or is too large.
    pub fn from_expr(expr: &Expr, context: &Context) -> Result<Self, NotRational> {
        Reader { context, known: HashMap::new() }.read(expr, context.lets.len())
    }

    /// Numerator and denominator in lowest terms: integer coefficients without a common divisor,
    /// that of highest degree in the denominator positive.
    #[must_use]
    pub fn fraction(&self) -> (Poly, Poly) {
        let ((num, a), (den, b)) = (inward(self.value.num()), inward(self.value.den()));
        let (num, den) = (num.scale(&b), den.scale(&a));
        let content = |p: &Poly| p.terms().fold(BigInt::zero(), |g, (_, c)| g.gcd(c));
        let common = content(&num).gcd(&content(&den));
        let common = if leads_negative(&den) { -common } else { common };
        (divided(&num, &common), divided(&den, &common))
    }

    /// The value, if no symbol is left in it; conditions may remain.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        let (num, den) = self.fraction();
        Some(Rational::new(num.as_constant()?, den.as_constant()?))
    }

    /// Whether the value is 0 wherever it is defined.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.value.is_zero()
    }

    /// The symbols of the value and of the conditions, ascending.
    #[must_use]
    pub fn symbols(&self) -> Vec<usize> {
        let (num, den) = self.fraction();
        let all = self.conditions.iter().chain([&num, &den]);
        all.flat_map(Poly::vars).collect::<BTreeSet<_>>().into_iter().collect()
    }

    /// The polynomials that must not vanish: without repeated or common factors, primitive, the
    /// first coefficient by degree positive, simple ones first. The function is defined exactly where all are non-zero.
    #[must_use]
    pub fn conditions(&self) -> Vec<Poly> {
        let (_, den) = self.fraction();
        coprime(self.conditions.iter().chain([&den]))
    }

    /// Those conditions that the denominator does not show: the factors that were cancelled.
    #[must_use]
    pub fn cancelled(&self) -> Vec<Poly> {
        let (_, den) = self.fraction();
        let mut hidden = self.conditions();
        hidden.retain(|c| ring::gcd(c, &den).is_constant());
        hidden
    }

    /// The same value with one more condition p ≠ 0; `None` if p is the zero polynomial.
    #[must_use]
    pub fn provided(mut self, p: &Poly) -> Option<Self> {
        if p.is_empty() {
            return None;
        }
        if !p.is_constant() {
            self.conditions.insert(signed(p));
        }
        Some(self)
    }

    /// selfⁿ, with 0⁰ = 1; a negative n divides. `None` for a negative power of zero.
    #[must_use]
    pub fn powi(&self, n: i32) -> Option<Self> {
        let power = |p: &Foreign| p.pow(n.unsigned_abs());
        let value = Fraction::new(power(self.value.num()), power(self.value.den()))?;
        let power = Self { value, conditions: self.conditions.clone() };
        if n < 0 { Self::one().checked_div(&power) } else { Some(power) }
    }

    /// The partial derivative ∂/∂x, (n′d − nd′)/d²; other symbols, functions of x included, are
    /// held fixed. Defined where the function is.
    #[must_use]
    pub fn derivative(&self, x: usize) -> Self {
        let (n, d) = (self.value.num(), self.value.den());
        let by_x = |p: &Foreign| {
            if x < p.nvars { p.derivative(x) } else { Foreign::zero(p.nvars, p.order.clone()) }
        };
        let top = &(&by_x(n) * d) - &(n * &by_x(d));
        let value = Fraction::new(top, d * d).expect("a denominator is not zero");
        Self { value, conditions: self.conditions.clone() }
    }

    /// Replaces symbols by rational functions, all at once.
    ///
    /// Defined where all replacements are, and where the function is at their values: hence
    /// substitution commutes with [evaluation](Self::eval).
    ///
    /// # Errors
    /// [`NotRational::DivisionByZero`] if some condition then fails everywhere,
    /// [`NotRational::TooLarge`] beyond the budget.
    pub fn substitute(&self, replacements: &[(usize, Self)]) -> Result<Self, NotRational> {
        let fuel = Fuel::new(MAX_STEPS);
        let parts: Vec<Replacement> = replacements
            .iter()
            .map(|(symbol, by)| {
                let (num, den) = by.fraction();
                Replacement { symbol: *symbol, num, den }
            })
            .collect();
        let (num, den) = self.fraction();
        let degrees: Vec<u32> =
            parts.iter().map(|r| num.degree(r.symbol).max(den.degree(r.symbol))).collect();
        let top = composed(&num, &parts, &degrees, &fuel)?;
        let bottom = composed(&den, &parts, &degrees, &fuel)?;
        if !affordable(&top, &bottom) {
            return Err(NotRational::TooLarge);
        }
        let mut out = Self::new(&top, &bottom).ok_or(NotRational::DivisionByZero)?;
        for condition in &self.conditions {
            let degrees: Vec<u32> = parts.iter().map(|r| condition.degree(r.symbol)).collect();
            let condition = composed(condition, &parts, &degrees, &fuel)?;
            out = out.provided(&condition).ok_or(NotRational::DivisionByZero)?;
        }
        for (_, by) in replacements {
            out.conditions.extend(by.conditions.iter().cloned());
        }
        Ok(out)
    }

    /// The exact value where symbol i has the value `point[i]`; `None` where a condition fails, or
    /// a symbol that occurs has no value.
    #[must_use]
    pub fn eval(&self, point: &[Rational]) -> Option<Rational> {
        for condition in &self.conditions {
            if value(condition, point)?.is_zero() {
                return None;
            }
        }
        let (num, den) = self.fraction();
        Some(value(&num, point)? / value(&den, point)?)
    }

    /// The value as an expression; its own denominator shows some of the conditions, and
    /// [`cancelled`](Self::cancelled) holds the others.
    #[must_use]
    pub fn to_expr(&self) -> Expr {
        let (num, den) = self.fraction();
        let num = expression(&num);
        match den.as_constant() {
            Some(c) if c.is_one() => num,
            _ => Expr::Div(num.into(), expression(&den).into()),
        }
    }

    /// The function n/d, provided d ≠ 0.
    fn of(value: Fraction) -> Self {
        let (den, _) = inward(value.den());
        let conditions = BTreeSet::from([signed(&den)]);
        let conditions = conditions.into_iter().filter(|d| !d.is_constant()).collect();
        Self { value, conditions }
    }

    fn with_conditions_of(mut self, other: &Self) -> Self {
        self.conditions.extend(other.conditions.iter().cloned());
        self
    }
}

/// Relations p ≠ 0, for printing.
#[must_use]
pub fn non_zero(conditions: &[Poly]) -> Vec<Relation> {
    let zero = || Expr::Num(Zero::zero());
    let relation = |p| Relation { lhs: expression(p), rel: Rel::Ne, rhs: zero() };
    conditions.iter().map(relation).collect()
}

impl From<Rational> for RationalFunction {
    fn from(constant: Rational) -> Self {
        Self::of(constant.into())
    }
}

impl PartialEq for RationalFunction {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl Eq for RationalFunction {}

impl Neg for RationalFunction {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl Add<&Self> for RationalFunction {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        let value = self.value.clone() + other.value.clone();
        Self { value, ..self }.with_conditions_of(other)
    }
}

impl Sub<&Self> for RationalFunction {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        let value = self.value.clone() - other.value.clone();
        Self { value, ..self }.with_conditions_of(other)
    }
}

impl Mul<&Self> for RationalFunction {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        let value = self.value.clone() * other.value.clone();
        Self { value, ..self }.with_conditions_of(other)
    }
}

impl Div<&Self> for RationalFunction {
    type Output = Self;

    /// # Panics
    /// If the divisor is zero everywhere.
    fn div(self, other: &Self) -> Self {
        self.checked_div(other).expect("division by the zero function")
    }
}

macro_rules! by_value {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for RationalFunction {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                $operator::$method(self, &other)
            }
        }
    )*};
}

by_value!(Add add, Sub sub, Mul mul, Div div);

impl Number for RationalFunction {
    type Wide = Self;

    fn widen(&self) -> Self {
        self.clone()
    }

    fn narrow(wide: &Self) -> Self {
        wide.clone()
    }

    fn zero() -> Self {
        <Rational as Zero>::zero().into()
    }

    fn one() -> Self {
        <Rational as One>::one().into()
    }

    fn from_rational(exact: &Rational) -> Self {
        exact.clone().into()
    }

    fn mul_add(&self, factor: &Self, addend: &Self) -> Self {
        self.clone() * factor + addend
    }

    fn checked_div(&self, divisor: &Self) -> Option<Self> {
        if divisor.is_zero() {
            return None;
        }
        let value = self.value.clone() / divisor.value.clone();
        let quotient = Self { value, conditions: self.conditions.clone() };
        quotient.with_conditions_of(divisor).provided(&divisor.fraction().0)
    }

    fn is_finite(&self) -> bool {
        true
    }
}

impl Notation for RationalFunction {
    /// `value when p != 0, …`, with the [cancelled](RationalFunction::cancelled) conditions only.
    fn plain(&self, context: &Context) -> String {
        let value = self.to_expr().plain(context);
        match &non_zero(&self.cancelled())[..] {
            [] => value,
            hidden => format!("{value} when {}", hidden.plain(context)),
        }
    }

    fn latex(&self, context: &Context) -> String {
        let value = self.to_expr().latex(context);
        match &non_zero(&self.cancelled())[..] {
            [] => value,
            hidden => format!("{value} \\quad\\text{{when }} {}", hidden.latex(context)),
        }
    }
}

impl fmt::Display for RationalFunction {
    /// As [`Notation::plain`], symbol i written as `xi`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let last = self.symbols().last().map_or(0, |v| v + 1);
        let name = |i| Var { name: format!("x{i}"), of: None, lower: None, upper: None };
        let context = Context { vars: (0..last).map(name).collect(), ..Context::default() };
        f.write_str(&self.plain(&context))
    }
}

/// Bounds on what is handed to the gcd: terms, degree in a symbol, bits of a coefficient. The worst
/// measured within them took 0.1 s, and its conditions 0.8 s.
const MAX_TERMS: usize = 10_000;
const MAX_DEGREE: u32 = 256;
const MAX_BITS: u64 = 1 << 16;
/// Coefficient operations that one substitution may take.
const MAX_STEPS: u64 = 4_000_000;

/// An upper bound on the size of a polynomial.
struct Size {
    terms: usize,
    /// in each symbol
    degrees: Vec<u32>,
    bits: u64,
}

impl Size {
    fn of(p: &Foreign) -> Self {
        let bits = p.terms.iter().map(|(_, c)| c.numer().bits() + c.denom().bits()).max();
        Self {
            terms: p.terms.len(),
            degrees: (0..p.nvars).map(|v| p.degree(v)).collect(),
            bits: bits.unwrap_or(0),
        }
    }

    fn times(&self, other: &Self) -> Self {
        let (long, short) = if self.degrees.len() < other.degrees.len() {
            (&other.degrees, &self.degrees)
        } else {
            (&self.degrees, &other.degrees)
        };
        let mut degrees = long.clone();
        for (sum, degree) in degrees.iter_mut().zip(short) {
            *sum = sum.saturating_add(*degree);
        }
        Self {
            terms: self.terms.saturating_mul(other.terms),
            degrees,
            bits: self.bits.saturating_add(other.bits),
        }
    }

    /// Of the n-th power: as many terms as there are products of n terms, order aside.
    fn power(self, n: u32) -> Self {
        let most = usize::try_from(n).unwrap_or(usize::MAX);
        let products = (1..self.terms).try_fold(1usize, |count, i| {
            let count = count.checked_mul(most.checked_add(i)?)? / i;
            (count <= MAX_TERMS).then_some(count)
        });
        let growth = self.bits + u64::from(usize::BITS - self.terms.leading_zeros());
        Self {
            terms: products.unwrap_or(usize::MAX),
            degrees: self.degrees.iter().map(|d| d.saturating_mul(n)).collect(),
            bits: growth.saturating_mul(n.into()),
        }
    }

    fn fits(&self) -> bool {
        let degrees = self.degrees.iter().map(|d| usize::try_from(*d).unwrap_or(usize::MAX));
        let monomials = degrees.fold(1usize, |count, d| count.saturating_mul(d.saturating_add(1)));
        self.terms.min(monomials) <= MAX_TERMS
            && self.degrees.iter().all(|d| *d <= MAX_DEGREE)
            && self.bits <= MAX_BITS
    }
}

fn affordable(num: &Poly, den: &Poly) -> bool {
    let fits = |p: &Poly| p.len() <= MAX_TERMS && p.bits() <= MAX_BITS;
    let low = |p: &Poly| p.terms().all(|(m, _)| m.iter().all(|&(_, e)| e <= MAX_DEGREE));
    [num, den].into_iter().all(|p| fits(p) && low(p))
}

struct Reader<'a> {
    context: &'a Context,
    /// definitions read so far
    known: HashMap<usize, RationalFunction>,
}

impl Reader<'_> {
    /// What an expression says that may use the definitions below an index.
    fn read(&mut self, expr: &Expr, below: usize) -> Result<RationalFunction, NotRational> {
        Ok(match expr {
            Expr::Num(q) => q.clone().into(),
            Expr::Var(v) if *v < self.context.vars.len() => RationalFunction::symbol(*v),
            Expr::Let(i) if *i < below => self.definition(*i)?,
            Expr::Var(_) | Expr::Let(_) => return Err(NotRational::Unknown),
            Expr::Neg(a) => -self.read(a, below)?,
            Expr::Add(a, b) => {
                let (a, b) = self.both(a, b, below)?;
                a + b
            }
            Expr::Sub(a, b) => {
                let (a, b) = self.both(a, b, below)?;
                a - b
            }
            Expr::Mul(a, b) => {
                let (a, b) = self.both(a, b, below)?;
                a * b
            }
            Expr::Div(a, b) => {
                let (a, b) = self.both(a, b, below)?;
                a.checked_div(&b).ok_or(NotRational::DivisionByZero)?
            }
            Expr::Pow(a, n) => {
                let a = self.read(a, below)?;
                let fits = |p: &Foreign| Size::of(p).power(n.unsigned_abs()).fits();
                if !fits(a.value.num()) || !fits(a.value.den()) {
                    return Err(NotRational::TooLarge);
                }
                a.powi(*n).ok_or(NotRational::DivisionByZero)?
            }
            Expr::Deriv(f, x) => {
                let f = self.read(f, below)?;
                let of_x = |v: &usize| self.context.vars.get(*v).is_some_and(|v| v.of == Some(*x));
                if f.symbols().iter().any(of_x) {
                    return Err(NotRational::NotExplicit);
                }
                f.derivative(*x)
            }
            Expr::Abs(_) => return Err(NotRational::Operation("abs")),
            Expr::Min(..) => return Err(NotRational::Operation("min")),
            Expr::Max(..) => return Err(NotRational::Operation("max")),
            Expr::Sqrt(_) => return Err(NotRational::Operation("sqrt")),
            Expr::Cases(..) => return Err(NotRational::Operation("cases")),
        })
    }

    /// Both operands, small enough to be combined.
    fn both(
        &mut self,
        a: &Expr,
        b: &Expr,
        below: usize,
    ) -> Result<(RationalFunction, RationalFunction), NotRational> {
        let (a, b) = (self.read(a, below)?, self.read(b, below)?);
        let size = |f: &RationalFunction| (Size::of(f.value.num()), Size::of(f.value.den()));
        let ((n, d), (m, e)) = (size(&a), size(&b));
        let crossed = [n.times(&e), m.times(&d), n.times(&m), d.times(&e)];
        if crossed.iter().all(Size::fits) { Ok((a, b)) } else { Err(NotRational::TooLarge) }
    }

    fn definition(&mut self, index: usize) -> Result<RationalFunction, NotRational> {
        if let Some(known) = self.known.get(&index) {
            return Ok(known.clone());
        }
        let context = self.context;
        let definition = context.lets.get(index).ok_or(NotRational::Unknown)?;
        let read = self.read(&definition.body, index)?;
        self.known.insert(index, read.clone());
        Ok(read)
    }
}

/// A symbol and what takes its place.
struct Replacement {
    symbol: usize,
    num: Poly,
    den: Poly,
}

impl From<Rejection> for NotRational {
    fn from(_: Rejection) -> Self {
        Self::TooLarge
    }
}

/// p(n/d)·Π dᵢ^degreeᵢ, a polynomial.
fn composed(
    p: &Poly,
    parts: &[Replacement],
    degrees: &[u32],
    fuel: &Fuel,
) -> Result<Poly, Rejection> {
    let mut powers: HashMap<(usize, u32), Poly> = HashMap::new();
    let mut sum = Poly::default();
    for (m, c) in p.terms() {
        let replaced = |v: usize| parts.iter().any(|r| r.symbol == v);
        let kept: Monomial = m.iter().copied().filter(|&(v, _)| !replaced(v)).collect();
        let mut product = Poly::term(kept, c.clone());
        for (i, (part, degree)) in parts.iter().zip(degrees).enumerate() {
            let e = kane_kernel::exponent(m, part.symbol);
            let power = match powers.get(&(i, e)) {
                Some(known) => known.clone(),
                None => {
                    let power =
                        part.num.pow(e, fuel)?.mul(&part.den.pow(degree - e, fuel)?, fuel)?;
                    powers.insert((i, e), power.clone());
                    power
                }
            };
            product = product.mul(&power, fuel)?;
        }
        sum = sum.add(&product);
    }
    Ok(sum)
}

fn outward(p: &Poly) -> Foreign {
    let size = p.vars().last().map_or(0, |v| v + 1);
    let terms = p.terms().map(|(m, c)| {
        let mut exponents = vec![0; size];
        for &(v, e) in m {
            exponents[v] = e;
        }
        (polycore::Monomial::new(exponents), Rational::from_integer(c.clone()))
    });
    Foreign::new(terms.collect(), size, Order::GRevLex)
}

/// A polynomial times its common denominator, and that denominator.
fn inward(p: &Foreign) -> (Poly, BigInt) {
    let common = p.terms.iter().fold(BigInt::one(), |l, (_, c)| l.lcm(c.denom()));
    let terms = p.terms.iter().map(|(m, c)| {
        let powers = m.exps().iter().copied().enumerate().filter(|&(_, e)| e > 0);
        (powers.collect(), c.numer() * (&common / c.denom()))
    });
    (Poly::sum(terms), common)
}

/// The value at a point, if every symbol has one there.
fn value(p: &Poly, point: &[Rational]) -> Option<Rational> {
    let mut sum: Rational = num_traits::zero();
    for (m, c) in p.terms() {
        let mut product = Rational::from_integer(c.clone());
        for &(v, e) in m {
            product *= num_traits::pow(point.get(v)?.clone(), usize::try_from(e).ok()?);
        }
        sum += product;
    }
    Some(sum)
}

fn divided(p: &Poly, by: &BigInt) -> Poly {
    Poly::sum(p.terms().map(|(m, c)| (m.to_vec(), c / by)))
}

fn total(m: &[Power]) -> u32 {
    m.iter().map(|p| p.1).fold(0, u32::saturating_add)
}

/// Terms by falling degree, then by falling powers of the first symbols.
fn ordered(p: &Poly) -> Vec<(&[Power], &BigInt)> {
    let mut terms: Vec<_> = p.terms().collect();
    terms.sort_by_cached_key(|(m, _)| {
        let powers: Vec<_> = m.iter().map(|&(v, e)| (v, Reverse(e))).collect();
        (Reverse(total(m)), powers)
    });
    terms
}

fn leads_negative(p: &Poly) -> bool {
    ordered(p).first().is_some_and(|(_, c)| c.is_negative())
}

/// The primitive polynomial with the same zeros whose coefficient of highest degree is positive.
fn signed(p: &Poly) -> Poly {
    let (_, p) = p.primitive();
    if leads_negative(&p) { p.neg() } else { p }
}

/// Pairwise coprime polynomials without repeated factors whose product has the zeros of all.
fn coprime<'a>(polys: impl Iterator<Item = &'a Poly>) -> Vec<Poly> {
    let mut todo: Vec<Poly> = polys.flat_map(radical).collect();
    let mut base: Vec<Poly> = Vec::new();
    while let Some(p) = todo.pop() {
        if p.is_constant() || base.contains(&p) {
            continue;
        }
        let shares = |b: &Poly| !ring::gcd(b, &p).is_constant();
        match base.iter().position(shares) {
            None => base.push(p),
            Some(i) => {
                let b = base.swap_remove(i);
                let (p_rest, b_rest) = ring::cancelled(&p, &b);
                todo.extend([signed(&ring::gcd(&p, &b)), signed(&p_rest), signed(&b_rest)]);
            }
        }
    }
    let degree = |p: &Poly| p.terms().map(|(m, _)| total(m)).max();
    base.sort_by_cached_key(|p| (degree(p), p.len(), p.clone()));
    base
}

/// Its symbols that divide it, and the rest without repeated factors.
fn radical(p: &Poly) -> Vec<Poly> {
    let mut rest = p.clone();
    let mut parts = Vec::new();
    for v in p.vars() {
        let least = p.terms().map(|(m, _)| kane_kernel::exponent(m, v)).min().unwrap_or(0);
        if least > 0 {
            parts.push(Poly::var(v));
            rest = ring::cancelled(&rest, &Poly::term(vec![(v, least)], BigInt::one())).0;
        }
    }
    // what all derivatives share with it are the repeats
    let mut repeats = rest.clone();
    for v in rest.vars() {
        repeats = ring::gcd(&repeats, &derivative(&rest, v));
        if repeats.is_constant() {
            break;
        }
    }
    if !repeats.is_constant() {
        rest = ring::cancelled(&rest, &repeats).0;
    }
    parts.push(signed(&rest));
    parts
}

fn derivative(p: &Poly, v: usize) -> Poly {
    let terms = p.terms().filter(|(m, _)| kane_kernel::exponent(m, v) > 0);
    Poly::sum(terms.map(|(m, c)| {
        let lowered = m.iter().map(|&(w, n)| (w, if w == v { n - 1 } else { n }));
        (lowered.collect(), c * kane_kernel::exponent(m, v))
    }))
}

/// A polynomial as a sum by falling degree; a positive term comes first where there is one.
#[must_use]
pub fn expression(p: &Poly) -> Expr {
    let mut terms = ordered(p);
    if let Some(first) = terms.iter().position(|(_, c)| c.is_positive()) {
        terms[..=first].rotate_right(1);
    }
    let mut terms = terms.into_iter();
    let Some((m, c)) = terms.next() else {
        return Expr::Num(Zero::zero());
    };
    let first = term(m, c);
    let first = if c.is_negative() { Expr::Neg(first.into()) } else { first };
    terms.fold(first, |sum, (m, c)| {
        let term = term(m, c).into();
        if c.is_negative() { Expr::Sub(sum.into(), term) } else { Expr::Add(sum.into(), term) }
    })
}

/// |c|·m
fn term(m: &[Power], c: &BigInt) -> Expr {
    let number = Expr::Num(Rational::from_integer(c.abs()));
    let power = |&(v, e): &(usize, u32)| match i32::try_from(e) {
        Ok(1) => Expr::Var(v),
        Ok(e) => Expr::Pow(Expr::Var(v).into(), e),
        Err(_) => Expr::Pow(Expr::Var(v).into(), i32::MAX),
    };
    let powers = m.iter().map(power);
    let product = |a: Expr, b: Expr| Expr::Mul(a.into(), b.into());
    if c.magnitude().is_one() {
        powers.reduce(product).unwrap_or(number)
    } else {
        powers.fold(number, product)
    }
}
