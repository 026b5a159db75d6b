//! The greatest root in an interval, in floating arithmetic of twice the precision.
#![allow(clippy::float_arithmetic, reason = "the numbers here are floating ones")]

use crate::{Number, Scaled};

/// Newton's method doubles the correct bits; halving, its fallback, adds one. Both end by here.
const MOST_STEPS: usize = 300;

/// A step below this, relatively, is the last one: 2^−103.
const LAST_STEP: i64 = -103;

/// What the evaluation of a polynomial of degree 3 may err by, relative to Σ|cᵢ||x|ⁱ: each of
/// three steps errs by 32u² = 2^−101 at most.
const EVALUATION: i64 = -98;

/// The greatest root in \[lower, upper\], see [`Real::greatest_root`](crate::Real::greatest_root).
///
/// `noise` is the binary logarithm of the relative error that the caller's coefficients carry. It
/// decides nothing while there is a change of sign, a root of the closed form inside, or an end
/// that is a root exactly; only when there is none, the highest end or critical point counts at
/// which the polynomial vanishes to within that noise.
///
/// Degree 1 by division, degree 2 by the stable formula, degree 3 on the monotone pieces between
/// the critical points, from the top. Heuristic for double roots, which no floating system tells
/// from two or none; otherwise backward stable: the root of a polynomial whose coefficients differ
/// by 2^−96 relatively. Nothing over- or underflows.
pub(crate) fn greatest_root(
    coefficients: &[Scaled],
    lower: &Scaled,
    upper: &Scaled,
    noise: i64,
) -> Option<Scaled> {
    let finite = coefficients.iter().chain([lower, upper]).all(Scaled::is_finite);
    if coefficients.len() > 4 || !finite || lower > upper {
        return None;
    }
    let degree = coefficients.iter().rposition(|c| !c.is_zero())?;
    let f = Polynomial(&coefficients[..=degree]);
    if f.at(upper).is_zero() {
        return Some(*upper);
    }
    let below = f.at(lower);
    let same_sign = !below.is_zero() && below.is_negative() == f.at(upper).is_negative();
    if same_sign && f.vanishes(upper, noise) {
        // As promised one end is a root; the upper one is the greater.
        return Some(*upper);
    }
    let inside = |x: &Scaled| lower <= x && x < upper;
    let mut ends = vec![*upper];
    let root = match f.0 {
        [c0, c1] => Some(-*c0 / c1).filter(inside),
        [c0, c1, c2] => {
            ends.extend([vertex(c1, c2)].into_iter().filter(inside));
            quadratic([c0, c1, c2]).and_then(|roots| roots.into_iter().find(inside))
        }
        [_, c1, c2, c3] => {
            let three = Scaled::from(3.0);
            let slope = [c1, &c2.double(), &(three * c3)];
            ends.extend(quadratic(slope).into_iter().flatten().filter(inside));
            ends.push(*lower);
            f.topmost_change(&ends)
        }
        _ => None,
    };
    ends.push(*lower);
    root.or_else(|| below.is_zero().then_some(*lower))
        .or_else(|| ends.into_iter().find(|end| f.vanishes(end, noise)))
}

/// Where the parabola turns.
fn vertex(c1: &Scaled, c2: &Scaled) -> Scaled {
    -c1.scaled_by(-1) / c2
}

/// Both roots of c₀ + c₁x + c₂x², the greater first, or `None` if they are not real. The leading
/// coefficient is not zero.
///
/// With h = c₁/2 the discriminant is h² − c₂c₀, the second product taken with its rounding error
/// (Kahan; error bound in Jeannerod, Louvet and Muller 2013, "Further analysis of Kahan's
/// algorithm for the accurate computation of 2×2 determinants"). The root of greater magnitude is
/// formed without cancellation, the other from the product of both.
fn quadratic([c0, c1, c2]: [&Scaled; 3]) -> Option<[Scaled; 2]> {
    let half = c1.scaled_by(-1);
    if half.is_zero() {
        let root = (-*c0 / c2).sqrt()?;
        return Some([root, -root]);
    }
    let product = *c2 * c0;
    let error = (-*c2).mul_add(c0, &product);
    let discriminant = half.mul_add(&half, &-product) + error;
    let root = discriminant.sqrt()?;
    let sum = if half.is_negative() { root - half } else { -(half + root) };
    let (first, second) = (sum / c2, *c0 / sum);
    Some(if first > second { [first, second] } else { [second, first] })
}

/// A polynomial by ascending powers, its last coefficient not zero.
struct Polynomial<'a>(&'a [Scaled]);

impl Polynomial<'_> {
    fn at(&self, x: &Scaled) -> Scaled {
        self.0.iter().rev().fold(Scaled::zero(), |sum, c| sum.mul_add(x, c))
    }

    /// The value and the slope.
    fn with_slope(&self, x: &Scaled) -> (Scaled, Scaled) {
        let zero = (Scaled::zero(), Scaled::zero());
        self.0
            .iter()
            .rev()
            .fold(zero, |(value, slope), c| (value.mul_add(x, c), slope.mul_add(x, &value)))
    }

    /// Whether the value is zero to within 2^noise·Σ|cᵢ||x|ⁱ.
    fn vanishes(&self, x: &Scaled, noise: i64) -> bool {
        let magnitudes = |sum: Scaled, c: &Scaled| sum.mul_add(&x.abs(), &c.abs());
        let most = self.0.iter().rev().fold(Scaled::zero(), magnitudes);
        self.at(x).abs() <= most.scaled_by(noise)
    }

    /// The root in the topmost piece between two points, given from the top, in which the sign
    /// changes; or the topmost inner point at which the polynomial vanishes.
    fn topmost_change(&self, points: &[Scaled]) -> Option<Scaled> {
        for (index, pair) in points.windows(2).enumerate() {
            let [upper, lower] = pair else { continue };
            let (above, below) = (self.at(upper), self.at(lower));
            if index > 0 && self.vanishes(upper, EVALUATION) {
                return Some(*upper);
            }
            if below.is_zero() {
                return Some(*lower);
            }
            if above.is_negative() != below.is_negative() {
                return Some(self.between(*lower, *upper, above.is_negative()));
            }
        }
        None
    }

    /// The root in an interval in which the polynomial is monotone and changes sign.
    fn between(&self, lower: Scaled, upper: Scaled, negative_above: bool) -> Scaled {
        let mut bracket = Bracket { lower, upper, negative_above };
        if lower.is_negative() && !upper.is_negative() && !upper.is_zero() {
            let zero = Scaled::zero();
            let at_zero = self.0[0];
            if at_zero.is_zero() {
                return zero;
            }
            bracket.shrink(zero, &at_zero);
        }
        self.keep_off_zero(&mut bracket);
        while let Some(middle) = bracket.middle_of_exponents() {
            bracket.shrink(middle, &self.at(&middle));
        }
        self.newton(bracket, MOST_STEPS)
    }

    /// Replaces an end that is zero by a bound below which there is no root: every root but zero
    /// is at least |c₀|/(|c₀| + max|cᵢ|) in magnitude (Cauchy). The root in the bracket is beyond it,
    /// and so is the other end.
    fn keep_off_zero(&self, bracket: &mut Bracket) {
        let exponents = self.0.iter().filter(|c| !c.is_zero()).map(|c| c.exponent());
        let Some(greatest) = exponents.max().filter(|_| !self.0[0].is_zero()) else { return };
        let least = Scaled::one().scaled_by(self.0[0].exponent() - greatest - 3);
        if bracket.lower.is_zero() {
            bracket.lower = least;
        }
        if bracket.upper.is_zero() {
            bracket.upper = -least;
        }
    }

    /// Newton's method that never leaves the bracket, and halves it where the steps do not shrink
    /// to a half each (Press, Teukolsky, Vetterling and Flannery: Numerical Recipes, section 9.4).
    fn newton(&self, mut bracket: Bracket, most_steps: usize) -> Scaled {
        let mut x = bracket.middle();
        let mut last = bracket.width();
        for _ in 0..most_steps {
            let (value, slope) = self.with_slope(&x);
            if value.is_zero() {
                break;
            }
            bracket.shrink(x, &value);
            let newton = value.checked_div(&slope);
            let next = newton
                .filter(|step| step.abs().double() <= last.abs())
                .map(|step| x - step)
                .filter(|next| bracket.lower <= *next && *next <= bracket.upper)
                .unwrap_or_else(|| bracket.middle());
            last = next - x;
            x = next;
            if last.abs() <= x.abs().scaled_by(LAST_STEP) {
                break;
            }
        }
        x
    }
}

/// An interval with opposite signs at its ends.
#[derive(Clone, Copy)]
struct Bracket {
    lower: Scaled,
    upper: Scaled,
    negative_above: bool,
}

impl Bracket {
    /// Puts a point of known value in place of the end of the same sign.
    fn shrink(&mut self, x: Scaled, value: &Scaled) {
        if value.is_negative() == self.negative_above {
            self.upper = x;
        } else {
            self.lower = x;
        }
    }

    fn width(&self) -> Scaled {
        self.upper - self.lower
    }

    fn middle(&self) -> Scaled {
        (self.lower + self.upper).scaled_by(-1)
    }

    /// A power of two between the ends, which are of one sign, halfway in the exponent, if they are binades
    /// apart: by the arithmetic middle a root near zero would take a step for each binade.
    fn middle_of_exponents(&self) -> Option<Scaled> {
        let [a, b] = [self.lower, self.upper].map(Scaled::exponent);
        let middle = Scaled::one().scaled_by(i64::midpoint(a, b));
        let middle = if self.lower.is_negative() { -middle } else { middle };
        (a.abs_diff(b) > 2).then_some(middle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(x: i32) -> Scaled {
        Scaled::from(f64::from(x))
    }

    /// (x − r)((x − a)² + b) for r next to 1 and a, b that keep the other roots away: from a bracket of a quarter each
    /// step doubles the bits that are right, after 2, 4, 8, …, so that ten of them have all.
    #[test]
    fn the_steps_near_a_simple_root_double_its_bits() {
        let mut tried = 0;
        for thirds in 5..12 {
            let r = number(thirds) / number(7);
            for a in [-5, -1, 3] {
                for b in [1, 4, 30] {
                    for sign in [1, -1] {
                        let (a, b) = (number(a), number(b));
                        let square = a.square() + b;
                        let f = [
                            -(r * square),
                            square + r * a.double(),
                            -(a.double() + r),
                            Scaled::one(),
                        ];
                        let f = f.map(|c| c * number(sign));
                        let bracket = Bracket {
                            lower: r * number(3) / number(4),
                            upper: r * number(9) / number(8),
                            negative_above: sign < 0,
                        };
                        // and they end by themselves
                        for most in [10, usize::MAX] {
                            let found = Polynomial(&f).newton(bracket, most);
                            let off = (found - r).abs();
                            assert!(off <= r.scaled_by(-95), "{r}, {a}, {b}: {off}");
                        }
                        tried += 1;
                    }
                }
            }
        }
        assert_eq!(tried, 7 * 3 * 3 * 2);
    }
}
