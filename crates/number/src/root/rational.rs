//! The greatest root if it is rational: exact.

use std::cmp::Ordering;

use num_traits::{Signed, Zero};
use polycore::Uni;

use crate::sturm::Sturm;
use crate::{Integer, Rational};

/// The greatest root in \[lower, upper\] of a polynomial of degree 3 at most, if that root is
/// rational; see [`Real::greatest_root`](crate::Real::greatest_root). Exact.
///
/// By the rational root theorem the leading coefficient times a root is an integer, so an
/// isolating interval narrower than its inverse leaves one candidate.
pub(crate) fn greatest_root(
    coefficients: &[Rational],
    lower: &Rational,
    upper: &Rational,
) -> Option<Rational> {
    if coefficients.len() > 4 || lower > upper {
        return None;
    }
    let f = Uni::new(coefficients.to_vec());
    if f.eval(upper).is_zero() {
        return Some(upper.clone());
    }
    match &f.0[..] {
        [c0, c1] => Some(-c0 / c1).filter(|x| lower <= x && x <= upper),
        [c0, c1, c2] => quadratic([c0, c1, c2], lower, upper),
        [_, _, _, _] => {
            let f = &f / &f.gcd(&f.derivative());
            let (low, high) = topmost(&f, lower, upper)?;
            rational_in(&f, &low, &high)
        }
        _ => None,
    }
}

fn quadratic([c0, c1, c2]: [&Rational; 3], lower: &Rational, upper: &Rational) -> Option<Rational> {
    let half = c1 / Integer::from(2);
    let discriminant = &half * &half - c0 * c2;
    if discriminant.is_negative() {
        return None;
    }
    let Some(root) = square_root(&discriminant) else {
        // Both roots are irrational, or there is none in the interval.
        return None;
    };
    let mut roots = [(&root - &half) / c2, (-&root - &half) / c2];
    roots.sort();
    roots.into_iter().rfind(|x| lower <= x && x <= upper)
}

/// The square root of a rational if it is one.
pub(crate) fn square_root(square: &Rational) -> Option<Rational> {
    if square.is_negative() {
        return None;
    }
    let exact = |n: &Integer| Some(n.sqrt()).filter(|root| root * root == *n);
    Some(Rational::new_raw(exact(square.numer())?, exact(square.denom())?))
}

/// An interval (low, high] that holds the greatest root in \[lower, upper\] and no other, for a
/// square-free polynomial. A root at `lower` itself is given as (lower, lower].
fn topmost(f: &Uni<Rational>, lower: &Rational, upper: &Rational) -> Option<(Rational, Rational)> {
    let (mut low, mut high) = (lower.clone(), upper.clone());
    let sturm = Sturm::new(f);
    let mut count = sturm.count(&low, &high);
    if count == 0 {
        return f.eval(lower).is_zero().then(|| (lower.clone(), lower.clone()));
    }
    while count > 1 {
        let middle = (&low + &high) / Integer::from(2);
        let above = sturm.count(&middle, &high);
        if above > 0 {
            (low, count) = (middle, above);
        } else {
            high = middle;
        }
    }
    Some((low, high))
}

/// The rational root in an interval (low, high] that holds one root of a square-free polynomial.
///
/// With a the leading coefficient and n the degree, aⁿ⁻¹·f(y/a) has integer coefficients and the
/// leading one 1, so its rational roots are integers: they are sought by halving.
pub(crate) fn rational_in(f: &Uni<Rational>, low: &Rational, high: &Rational) -> Option<Rational> {
    let integers = integer_coefficients(f);
    let (leading, rest) = integers.split_last()?;
    let above = sign_at(&integers, high);
    if above == Ordering::Equal {
        return Some(high.clone());
    }
    let value = |y: &Integer| {
        let (mut sum, mut power) = (Integer::from(1), Integer::from(1));
        for c in rest.iter().rev() {
            sum = sum * y + c * &power;
            power *= leading;
        }
        sum
    };
    let scaled = |x: &Rational| (x * leading).floor().to_integer();
    // Every integer strictly between the two is a candidate in (low, high].
    let (mut below, mut beyond) = (scaled(low), scaled(high) + 1);
    while &beyond - &below > Integer::from(1) {
        let middle: Integer = (&below + &beyond) >> 1;
        match value(&middle).cmp(&Integer::ZERO) {
            Ordering::Equal => return Some(Rational::new(middle, leading.clone())),
            sign if sign == above => beyond = middle,
            _ => below = middle,
        }
    }
    None
}

/// The coefficients of the primitive polynomial: coprime integers, the last one positive.
pub(crate) fn integer_coefficients(f: &Uni<Rational>) -> Vec<Integer> {
    f.primitive().0.iter().map(Rational::to_integer).collect()
}

/// The sign of an integer polynomial at x.
pub(crate) fn sign_at(coefficients: &[Integer], x: &Rational) -> Ordering {
    sign_at_quotient(coefficients, (x.numer(), x.denom()))
}

/// The same at n/d with d > 0, as that of Σ cᵢ·nⁱ·dᵏ⁻ⁱ: without a fraction to reduce.
pub(crate) fn sign_at_quotient(coefficients: &[Integer], (n, d): (&Integer, &Integer)) -> Ordering {
    let (mut sum, mut power) = (Integer::ZERO, Integer::from(1));
    for c in coefficients.iter().rev() {
        sum = sum * n + c * &power;
        power *= d;
    }
    sum.cmp(&Integer::ZERO)
}
