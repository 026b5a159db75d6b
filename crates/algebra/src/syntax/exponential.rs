//! Exponentials and logarithms, written out by their functional equations.
//!
//! exp(x) of a symbol x is a symbol of its own, that of the finest part of x which is spoken of, and so is
//! log(x). So exp(a + b) is exp(a)·exp(b), exp(0) is 1, log(a·b) is log(a) + log(b), and log(exp(x)) is x.

use std::collections::BTreeMap;

use kane_kernel::{Bound, Expr};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed as _, ToPrimitive as _, Zero as _};

use super::angle::{Turn, product, sum};
use super::error::SyntaxErrorKind;
use super::exponential_symbol::Exponential;
use super::scope::Scope;

/// The greatest power of the exponential of a part.
const MAX_POWER: i32 = 24;
/// The finest part of an exponent.
const MAX_PARTS: u32 = 12;

/// exp of a sum of symbols with rational factors. Exact.
///
/// # Errors
/// When it is no such sum, or an exponential has no symbol yet.
pub(crate) fn exponential(e: &Expr, scope: &Scope) -> Result<Expr, SyntaxErrorKind> {
    let turn = Turn::of(e).filter(|turn| turn.half_turns.is_zero() && turn.number.is_zero());
    let mut whole = Expr::int(1);
    for (v, factor) in turn.ok_or(SyntaxErrorKind::NotAnExponent)?.angles {
        let (base, times) = match scope.exponential_at(v) {
            // exp(log(x))
            Some(Exponential { of, parts: 0, .. }) => (of, factor),
            Some(_) => return Err(SyntaxErrorKind::NotAnExponent),
            None => {
                let name = scope.constant(v).ok_or(SyntaxErrorKind::NotAnExponent)?;
                let known = scope.exponential(v);
                let parts = BigInt::from(known.map_or(1, |known| known.parts));
                let times = &factor * BigRational::from_integer(parts.clone());
                let Some(known) = known.filter(|_| times.is_integer()) else {
                    let parts = num_integer::lcm(parts, factor.denom().clone());
                    let parts = parts.to_u32().filter(|n| *n <= MAX_PARTS);
                    let parts = parts.ok_or(SyntaxErrorKind::TooFinePower)?;
                    return Err(SyntaxErrorKind::NoExponential { name: name.to_owned(), parts });
                };
                (known.symbol, times)
            }
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
                (of, n / BigRational::from_integer(parts.into()))
            }
            None => {
                let name = scope.constant(v).ok_or(SyntaxErrorKind::NotALogarithm)?;
                let vars = &scope.context().vars;
                let lower = vars.get(v).and_then(|var| var.lower.as_ref());
                let positive = |b: &Bound| b.value.is_positive() || (b.strict && b.value.is_zero());
                if !lower.is_some_and(positive) {
                    return Err(SyntaxErrorKind::NotPositive(name.to_owned()));
                }
                let known = scope.logarithm(v);
                (known.ok_or_else(|| SyntaxErrorKind::NoLogarithm(name.to_owned()))?.symbol, n)
            }
        };
        // what cancels has to be positive as well
        whole = sum(whole, product(Expr::Num(times), Expr::Var(base)));
    }
    Ok(whole)
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
