//! Both sides of an equality, after what was replaced: one quotient.

use kane_algebra::ring::cancelled;
use kane_kernel::{Conclusion, Expr, Finding, Fraction, Fuel, Goal, Link, Poly, Rel, Scope};

use super::{At, FUEL, Step, lowest};

/// Terms of a polynomial beyond which sides are not compared.
const WIDEST: usize = 600;

/// That both sides of the claim are the same, if they are seen to be.
pub(super) fn equal(goal: &Goal, finding: Finding, at: &At<'_, '_>) -> Option<Step> {
    let Conclusion::Link(Link::Relation(r)) = &goal.conclusion else { return None };
    if r.rel != Rel::Eq || finding != Finding::Proved {
        return None;
    }
    let replaced = at.replaced.as_ref()?;
    let left = side(at.state.scope, &r.lhs, replaced)?;
    let right = side(at.state.scope, &r.rhs, replaced)?;
    let fuel = Fuel::new(FUEL);
    let cross = left.0.mul(&right.1, &fuel).ok()?.sub(&right.0.mul(&left.1, &fuel).ok()?);
    let sides = (r.lhs.clone(), r.rhs.clone());
    cross.is_empty().then_some(Step::Equal { sides, value: left })
}

/// An expression of one piece as a quotient, after the replacements.
fn side(scope: &Scope<'_>, e: &Expr, replaced: &[(usize, (Poly, Poly))]) -> Option<(Poly, Poly)> {
    let pieces = scope.pieces(e).ok()?;
    let mut values = pieces.into_iter().filter_map(|piece| piece.value);
    let Fraction { num, den } = values.next()?;
    if values.next().is_some() {
        return None;
    }
    let fuel = Fuel::new(FUEL);
    let (mut num, mut den) = (num, den);
    for (v, by) in replaced {
        let (a, b) = (at(&num, *v, by, &fuel)?, at(&den, *v, by, &fuel)?);
        // both were multiplied by the denominator as often as they have the variable
        let (more, less) = (num.degree(*v), den.degree(*v));
        let power = |n: u32| by.1.pow(n, &fuel).ok();
        num = a.mul(&power(less.saturating_sub(more))?, &fuel).ok()?;
        den = b.mul(&power(more.saturating_sub(less))?, &fuel).ok()?;
        if num.len() > WIDEST || den.len() > WIDEST {
            return None;
        }
        (num, den) = cancelled(&num, &den);
    }
    Some(lowest((num, den)))
}

/// bⁿ·p(a/b) for v, with n the degree of p in v.
fn at(p: &Poly, v: usize, (a, b): &(Poly, Poly), fuel: &Fuel) -> Option<Poly> {
    let (mut sum, mut power) = (Poly::default(), Poly::one());
    for c in p.coefficients(v).iter().rev() {
        sum = sum.mul(a, fuel).ok()?.add(&c.mul(&power, fuel).ok()?);
        power = power.mul(b, fuel).ok()?;
    }
    Some(sum)
}
