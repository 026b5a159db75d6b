//! Polynomials, and conditions on them, as expressions.

use kane_kernel::{Expr, Poly, Power, Rel, Relation};
use kane_number::Rational;
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use super::conditions::ordered;

/// Relations p ≠ 0, for printing.
#[must_use]
pub fn non_zero(conditions: &[Poly]) -> Vec<Relation> {
    let zero = || Expr::Num(Zero::zero());
    let relation = |p| Relation { lhs: expression(p), rel: Rel::Ne, rhs: zero() };
    conditions.iter().map(relation).collect()
}

/// A polynomial as a sum by falling degree; a positive term comes first where there is one.
#[must_use]
pub fn expression(p: &Poly) -> Expr {
    let signed = |(m, c): (&[Power], &BigInt)| (term(m, c, &Expr::Var), c.is_negative());
    let terms = ordered(p).into_iter().map(signed).collect();
    signed_sum(with_a_positive_first(terms))
}

/// The terms, of which the first that is not negative, if there is one, was moved to the front.
#[must_use]
pub fn with_a_positive_first(mut terms: Vec<(Expr, bool)>) -> Vec<(Expr, bool)> {
    if let Some(first) = terms.iter().position(|(_, negative)| !negative) {
        terms[..=first].rotate_right(1);
    }
    terms
}

/// The sum of terms, those with `true` with their signs changed; 0 of none.
#[must_use]
pub fn signed_sum(terms: impl IntoIterator<Item = (Expr, bool)>) -> Expr {
    let mut terms = terms.into_iter();
    let first = match terms.next() {
        None => return Expr::Num(Zero::zero()),
        Some((term, true)) => Expr::Neg(term.into()),
        Some((term, false)) => term,
    };
    terms.fold(first, |sum, (term, negative)| match negative {
        true => Expr::Sub(sum.into(), term.into()),
        false => Expr::Add(sum.into(), term.into()),
    })
}

/// |c|·m, in what stands for the variables.
#[must_use]
pub fn term(m: &[Power], c: &BigInt, symbol: &dyn Fn(usize) -> Expr) -> Expr {
    let number = Expr::Num(Rational::from_integer(c.abs()));
    let power = |&(v, e): &(usize, u32)| match i32::try_from(e) {
        Ok(1) => symbol(v),
        Ok(e) => Expr::Pow(symbol(v).into(), e),
        Err(_) => Expr::Pow(symbol(v).into(), i32::MAX),
    };
    let powers = m.iter().map(power);
    let product = |a: Expr, b: Expr| Expr::Mul(a.into(), b.into());
    if c.magnitude().is_one() {
        powers.reduce(product).unwrap_or(number)
    } else {
        powers.fold(number, product)
    }
}
