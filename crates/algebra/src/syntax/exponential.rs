//! Exponentials and logarithms, written out by their functional equations.
//!
//! exp(u) of a product u of symbols is a symbol of its own, that of the finest part of u which is spoken of,
//! and so is log(x) of a symbol. So exp(a + b) is exp(a)·exp(b), exp(0) is 1, log(a·b) is log(a) + log(b), and
//! log(exp(x)) is x.

use std::collections::BTreeMap;

use kane_kernel::{Bound, Expr};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed as _, ToPrimitive as _, Zero as _};

use super::angle::{product, sum};
use super::error::SyntaxErrorKind;
use super::exponential_symbol::Exponential;
use super::monomial::Monomial;
use super::scope::Scope;

/// The greatest power of the exponential of a part.
const MAX_POWER: i32 = 24;
/// The finest part of an exponent.
const MAX_PARTS: u32 = 12;
/// Summands that an exponent may be written out to.
const MAX_SUMMANDS: usize = 64;

/// A sum of products of symbols, with rational factors.
type Summands = BTreeMap<Monomial, BigRational>;

/// exp of a sum of products of symbols with rational factors. Exact.
///
/// # Errors
/// When it is no such sum, a symbol under a fraction bar may be 0, or an exponential has no symbol yet.
pub(crate) fn exponential(e: &Expr, scope: &Scope) -> Result<Expr, SyntaxErrorKind> {
    let mut whole = Expr::int(1);
    for (of, factor) in summands(e, scope)? {
        // exp(log(x))
        let of_logarithm = of.as_symbol().and_then(|v| scope.exponential_at(v));
        let (base, times) = match of_logarithm.filter(|known| known.parts == 0) {
            Some(known) => (known.of.as_symbol().ok_or(SyntaxErrorKind::NotAnExponent)?, factor),
            None => symbol_for(&of, &factor, scope)?,
        };
        let times = times.is_integer().then(|| times.numer().to_i32()).flatten();
        let times = times.filter(|n| n.abs() <= MAX_POWER).ok_or(SyntaxErrorKind::TooFinePower)?;
        let power = match times {
            1 => Expr::Var(base),
            n => Expr::Pow(Expr::Var(base).into(), n),
        };
        whole = product(whole, power);
    }
    Ok(whole)
}

/// What stands for the exponential of the finest part of a product, and how many parts there are.
fn symbol_for(
    of: &Monomial,
    factor: &BigRational,
    scope: &Scope,
) -> Result<(usize, BigRational), SyntaxErrorKind> {
    if of.powers().is_empty() || !of.symbols().all(|v| scope.is_exponent(v)) {
        return Err(SyntaxErrorKind::NotAnExponent);
    }
    scope.variable_of(of)?;
    let known = scope.exponential(of);
    let parts = BigInt::from(known.map_or(1, |known| known.parts));
    let times = factor * BigRational::from_integer(parts.clone());
    let Some(known) = known.filter(|_| times.is_integer()) else {
        let parts = num_integer::lcm(parts, factor.denom().clone());
        let parts = parts.to_u32().filter(|n| *n <= MAX_PARTS);
        let parts = parts.ok_or(SyntaxErrorKind::TooFinePower)?;
        return Err(SyntaxErrorKind::NoExponential { of: scope.named(of), parts });
    };
    Ok((known.symbol, times))
}

/// log of a product of powers of positive symbols. Exact.
///
/// # Errors
/// When it is no such product, or a logarithm has no symbol yet.
pub(crate) fn logarithm(e: &Expr, scope: &Scope) -> Result<Expr, SyntaxErrorKind> {
    let mut powers = BTreeMap::new();
    factors(e, &BigRational::one(), &mut powers)?;
    let mut whole = Expr::int(0);
    for (v, n) in powers {
        let (base, times) = match scope.exponential_at(v) {
            Some(Exponential { parts: 0, .. }) => return Err(SyntaxErrorKind::NotALogarithm),
            // log(exp(x))
            Some(Exponential { of, parts, .. }) => {
                (of.expr(), n / BigRational::from_integer((*parts).into()))
            }
            None => {
                let var = scope.context().vars.get(v).filter(|_| scope.is_exponent(v));
                let var = var.ok_or(SyntaxErrorKind::NotALogarithm)?;
                let positive = |b: &Bound| b.value.is_positive() || (b.strict && b.value.is_zero());
                if !var.lower.as_ref().is_some_and(positive) {
                    return Err(SyntaxErrorKind::NotPositive(var.name.clone()));
                }
                let known = scope.logarithm(&Monomial::symbol(v));
                let known = known.ok_or_else(|| SyntaxErrorKind::NoLogarithm(var.name.clone()))?;
                (Expr::Var(known.symbol), n)
            }
        };
        // what cancels has to be positive as well
        whole = sum(whole, product(Expr::Num(times), base));
    }
    Ok(whole)
}

/// d f / d x, where f has exponentials or logarithms of which x is a factor and no function of x:
/// ∂f/∂x + Σ ∂f/∂E·E·∂u/∂x over these, E = exp(u). Exact.
///
/// Where all parts have a value f is one differentiable expression in x and the E near the point, and
/// the chain rule holds.
pub(crate) fn by_factor(f: &Expr, x: usize, scope: &Scope) -> Expr {
    let known = scope.symbols(f);
    let mut total = Expr::Deriv(f.clone().into(), x);
    for e in scope.exponentials().filter(|e| known.contains(&e.symbol) && e.of.contains(x)) {
        let slope = slope_of(e, e.of.slope(x));
        total = sum(total, product(Expr::Deriv(f.clone().into(), e.symbol), slope));
    }
    total
}

/// The derivative of an exponential or a logarithm, given that of what is in it. Exact.
pub(crate) fn slope_of(e: &Exponential, inside: Expr) -> Expr {
    match e.parts {
        0 => Expr::Div(inside.into(), e.of.expr().into()),
        1 => product(Expr::Var(e.symbol), inside),
        n => Expr::Div(product(Expr::Var(e.symbol), inside).into(), Expr::int(n.into()).into()),
    }
}

/// The symbols of a product, with their powers.
fn factors(
    e: &Expr,
    power: &BigRational,
    found: &mut BTreeMap<usize, BigRational>,
) -> Result<(), SyntaxErrorKind> {
    match e {
        Expr::Num(q) if q.is_one() => Ok(()),
        Expr::Var(v) => {
            *found.entry(*v).or_default() += power;
            Ok(())
        }
        Expr::Mul(a, b) => {
            factors(a, power, found)?;
            factors(b, power, found)
        }
        Expr::Div(a, b) => {
            factors(a, power, found)?;
            factors(b, &-power.clone(), found)
        }
        Expr::Pow(a, n) => factors(a, &(power * BigRational::from_integer((*n).into())), found),
        _ => Err(SyntaxErrorKind::NotALogarithm),
    }
}

/// What an expression is as a sum of products, definitions written out.
///
/// # Errors
/// When it is none or has too many, or when a symbol that divides may be 0, cancelled or not.
fn summands(e: &Expr, scope: &Scope) -> Result<Summands, SyntaxErrorKind> {
    let go = |e: &Expr| summands(e, scope);
    let minus_one = -BigRational::one();
    let found = match e {
        Expr::Num(q) => Some([(Monomial::default(), q.clone())].into()),
        Expr::Var(v) => Some([(Monomial::symbol(*v), BigRational::one())].into()),
        Expr::Let(i) => match scope.context().lets.get(*i) {
            Some(definition) => Some(go(&definition.body)?),
            None => None,
        },
        Expr::Neg(a) => Some(scaled(go(a)?, &minus_one)),
        Expr::Add(a, b) => Some(added(go(a)?, go(b)?)),
        Expr::Sub(a, b) => Some(added(go(a)?, scaled(go(b)?, &minus_one))),
        Expr::Mul(a, b) => multiplied(&go(a)?, &go(b)?),
        Expr::Div(a, b) => match divisor(&go(b)?, -1, scope)? {
            Some(under) => multiplied(&go(a)?, &under),
            None => None,
        },
        Expr::Pow(a, n) if *n < 0 => divisor(&go(a)?, *n, scope)?,
        Expr::Pow(a, n) => raised(&go(a)?, *n),
        _ => None,
    };
    let small = |m: &Monomial| m.powers().iter().all(|(_, n)| n.abs() <= MAX_POWER);
    found
        .filter(|found| found.len() <= MAX_SUMMANDS && found.keys().all(small))
        .ok_or(SyntaxErrorKind::NotAnExponent)
}

/// A negative power of one product whose symbols are not 0; nothing of a sum.
fn divisor(a: &Summands, n: i32, scope: &Scope) -> Result<Option<Summands>, SyntaxErrorKind> {
    let (1, Some((m, q))) = (a.len(), a.iter().next()) else { return Ok(None) };
    if let Some(v) = m.symbols().find(|v| !scope.never_vanishes(&Expr::Var(*v))) {
        let name = scope.context().vars.get(v).map_or("?", |var| &var.name);
        return Err(SyntaxErrorKind::VanishingExponent(name.to_owned()));
    }
    let power = (n >= -MAX_POWER && !q.is_zero()).then(|| num_traits::Pow::pow(q, n));
    Ok(power.map(|q| [(m.raised(n), q)].into()))
}

fn added(mut a: Summands, b: Summands) -> Summands {
    for (m, q) in b {
        *a.entry(m).or_default() += q;
    }
    a.retain(|_, q| !q.is_zero());
    a
}

fn scaled(mut a: Summands, by: &BigRational) -> Summands {
    a.values_mut().for_each(|q| *q *= by);
    a.retain(|_, q| !q.is_zero());
    a
}

fn multiplied(a: &Summands, b: &Summands) -> Option<Summands> {
    if a.len().checked_mul(b.len())? > MAX_SUMMANDS {
        return None;
    }
    let mut whole = Summands::new();
    for (m, p) in a {
        for (n, q) in b {
            *whole.entry(m.times(n)).or_default() += p * q;
        }
    }
    whole.retain(|_, q| !q.is_zero());
    Some(whole)
}

/// A natural power.
fn raised(a: &Summands, n: i32) -> Option<Summands> {
    let one: Summands = [(Monomial::default(), BigRational::one())].into();
    (0..n).try_fold(one, |whole, _| multiplied(&whole, a)).filter(|_| n <= MAX_POWER)
}
