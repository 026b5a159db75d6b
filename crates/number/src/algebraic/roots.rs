//! The real roots of a rational polynomial, one by one.

use num_traits::{One, Signed, Zero};
use polycore::Uni;
use polyfactor::factor;

use crate::root::rational::rational_in;
use crate::sturm::Sturm;
use crate::{Integer, Rational};

/// A real root of a polynomial with rational coefficients.
pub(super) enum Root {
    /// One that is rational.
    Rational(Rational),
    /// One that is not: a factor that is zero there, and the ends of an open interval in which
    /// that factor has no other root and opposite signs at the ends.
    Irrational(Uni<Rational>, Rational, Rational),
}

/// All distinct real roots, ascending; none for the zero polynomial. Exact.
pub(super) fn real_roots(polynomial: &Uni<Rational>) -> Vec<Root> {
    let free = square_free(polynomial);
    let sturm = Sturm::new(&free);
    let isolated = sturm.isolate();
    let factors = if isolated.is_empty() { Vec::new() } else { factors(&free) };
    isolated.into_iter().map(|(low, high)| root_in(&free, &sturm, &factors, low, high)).collect()
}

pub(super) fn square_free(polynomial: &Uni<Rational>) -> Uni<Rational> {
    if polynomial.deg() == 0 {
        return Uni::constant(Rational::one());
    }
    polynomial / &polynomial.gcd(&polynomial.derivative())
}

/// The one root of a square-free polynomial in (low, high].
fn root_in(
    free: &Uni<Rational>,
    sturm: &Sturm<Rational>,
    factors: &[Uni<Rational>],
    mut low: Rational,
    mut high: Rational,
) -> Root {
    if let Some(root) = rational_in(free, &low, &high) {
        return Root::Rational(root);
    }
    // The upper end is no root, but the lower one may be: another one.
    while free.eval(&low).is_zero() {
        let middle = (&low + &high) / Integer::from(2);
        if sturm.count(&low, &middle) == 1 { high = middle } else { low = middle }
    }
    Root::Irrational(factor_at(free, factors, &low, &high), low, high)
}

/// The factors of a square-free polynomial, as far as factoring finds them.
pub(super) fn factors(free: &Uni<Rational>) -> Vec<Uni<Rational>> {
    if free.deg() <= 2 {
        return Vec::new();
    }
    factor(free).into_iter().map(|(factor, _)| factor).collect()
}

/// The irreducible factor that is zero at the one root in (low, high); the ends are no roots.
///
/// That it divides, and where it changes sign, is checked here; if factoring is ever incomplete,
/// the factor is merely larger than need be.
pub(super) fn factor_at(
    free: &Uni<Rational>,
    factors: &[Uni<Rational>],
    low: &Rational,
    high: &Rational,
) -> Uni<Rational> {
    let changes = |f: &Uni<Rational>| f.eval(low).is_negative() != f.eval(high).is_negative();
    let divides = |f: &&Uni<Rational>| f.deg() > 1 && changes(f) && free.exact(f).is_some();
    factors.iter().find(divides).unwrap_or(free).clone()
}
