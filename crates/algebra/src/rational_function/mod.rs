//! Rational functions over ℚ in several symbols, in lowest terms, with all that must not vanish.

mod conditions;
mod expression;
mod field;
mod reader;
mod substitution;

use std::collections::{BTreeSet, HashMap};
use std::fmt;

use kane_kernel::{Context, Expr, Fuel, Poly, Rejection, Var};
use kane_number::{Number, Rational};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};
use polycore::Order;
use thiserror::Error;

use crate::fraction::Fraction;
use crate::ring;
use crate::syntax::Notation;
use conditions::{coprime, leads_negative, signed};
use reader::{Reader, affordable};
use substitution::{Replacement, composed};

pub use expression::{expression, non_zero, signed_sum, term, with_a_positive_first};

/// Coefficient operations that one substitution may take.
const MAX_STEPS: u64 = 4_000_000;

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

impl From<Rejection> for NotRational {
    fn from(_: Rejection) -> Self {
        Self::TooLarge
    }
}
