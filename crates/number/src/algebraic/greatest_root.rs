//! The greatest root of a polynomial with algebraic coefficients.

use polycore::Uni;

use super::Algebraic;
use super::roots::square_free;
use crate::operators::works_in_itself;
use crate::sturm::Sturm;
use crate::{Integer, Number, Rational, Real};

impl Real for Algebraic {
    type WideReal = Self;

    works_in_itself!();

    /// Exact, always. With rational coefficients by isolation; of degree 2 by a square root; a
    /// cubic with coefficients in a field of degree n by a polynomial of degree 3n, among whose
    /// roots the cubic's are found by evaluation.
    fn greatest_root(coefficients: &[Self], lower: &Self, upper: &Self) -> Option<Self> {
        if coefficients.len() > 4 || lower > upper {
            return None;
        }
        let degree = coefficients.iter().rposition(|c| *c != Self::zero());
        let Some(degree) = degree else { return Some(upper.clone()) };
        let f = &coefficients[..=degree];
        let inside = |x: &Self| lower <= x && x <= upper;
        let rational: Option<Vec<Rational>> = f.iter().map(|c| c.as_rational().cloned()).collect();
        if let Some(rational) = rational {
            return Self::roots(&rational).into_iter().rfind(inside);
        }
        match f {
            [c0, c1] => Some(-c0.clone() / c1).filter(inside),
            [c0, c1, c2] => {
                let half = c1.clone() * Self::from(Rational::new(1.into(), 2.into()));
                let discriminant = half.square() - c2.clone() * c0;
                let root = discriminant.sqrt()?;
                let mut roots = [(root.clone() - &half) / c2, (-root - half) / c2];
                roots.sort();
                roots.into_iter().rfind(inside)
            }
            _ => {
                // A conjugate's root lies elsewhere: where the norm has one root, the cubic has
                // that one or none, and its own Sturm chain, over its own field, tells which.
                let norm = square_free(&norm(f));
                let (sturm, all) = (Sturm::with(f, |member| member), Sturm::new(&norm));
                let is_root = |x: &Self| {
                    x.settle(|low, high| {
                        if low == high {
                            return Some(value(f, x) == Self::zero());
                        }
                        all.has_one(low, high)
                            .then(|| sturm.count(&low.clone().into(), &high.clone().into()) == 1)
                    })
                };
                let candidates = Self::roots(&norm.0).into_iter().rev();
                candidates.filter(inside).find(is_root)
            }
        }
    }
}

fn value(f: &[Algebraic], x: &Algebraic) -> Algebraic {
    f.iter().rev().fold(Algebraic::zero(), |sum, c| sum.mul_add(x, c))
}

/// The product of the polynomial's conjugates: rational, and zero at each of its roots.
///
/// Over ℚ(θ), with m(t) the polynomial of θ, it is the resultant of m(t) and f(t, x) by t, here
/// by interpolation at integers, some more than the degree asks for.
fn norm(f: &[Algebraic]) -> Uni<Rational> {
    let Some((field, residues)) = Algebraic::in_common_field(f) else { return Uni::zero() };
    let count = field.modulus().deg() * f.len();
    let at = (0_i64..).take(count).map(|x| Rational::from_integer(Integer::from(x)));
    let points: Vec<Rational> = at.collect();
    let value = |x: &Rational| {
        let sum = residues.iter().rev().fold(Uni::zero(), |sum, c| &sum.scale(x) + c);
        field.modulus().resultant(&sum)
    };
    let values: Vec<Rational> = points.iter().map(value).collect();
    Uni::interpolate(&points, &values)
}
