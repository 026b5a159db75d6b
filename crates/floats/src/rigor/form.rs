//! Linear forms: a value over a box as a linear function of where in the box, and a rest.
#![allow(
    clippy::float_arithmetic,
    reason = "coefficients are floats; their errors go into the rest"
)]

use kane_number::{Interval, Number as _};

use super::upward::{greatest, plus, times, widened};

/// center + Σ slopeⱼ·εⱼ + [−rest, rest] with every εⱼ in [−1, 1], and an interval that holds the value
/// besides. Rigorous: what float arithmetic loses in the coefficients is in the rest, and intervals are
/// rounded outward.
///
/// The linear part makes enclosures converge quadratically as a box shrinks (first-order Taylor models,
/// or affine forms that keep the inputs' symbols and gather all others in one); the interval is better on
/// wide boxes. Where the linear part says nothing, the rest is ∞.
#[derive(Clone, Debug)]
pub(super) struct Form {
    center: f64,
    slopes: Vec<f64>,
    rest: f64,
    pub(super) range: Interval,
}

/// More than the relative error of a few float operations.
const LOSS: f64 = f64::EPSILON * 4.0;
/// More than a few underflows lose.
const TINY: f64 = f64::from_bits(16);

impl Form {
    /// All that an interval tells.
    pub(super) const fn of(range: Interval) -> Self {
        Self { center: 0.0, slopes: Vec::new(), rest: f64::INFINITY, range }
    }

    /// One number.
    pub(super) fn point(number: f64) -> Self {
        Self { center: number, slopes: Vec::new(), rest: 0.0, range: Interval::from(number) }
    }

    /// A number that is known within an interval, of next to no width.
    pub(super) fn constant(range: Interval) -> Self {
        let center = range.midpoint();
        let rest = (range.upper() - center).max(center - range.lower());
        let rest = if rest == 0.0 { 0.0 } else { rest.next_up() };
        Self { center, slopes: Vec::new(), rest, range }
    }

    /// The input of an index, of several, between two floats.
    pub(super) fn input(index: usize, count: usize, lower: f64, upper: f64) -> Self {
        let range = Interval::between(lower, upper);
        if lower == upper {
            return Self::point(lower);
        }
        let center = range.midpoint();
        let radius = (upper - center).max(center - lower).next_up();
        let mut slopes = vec![0.0; count];
        if let Some(slope) = slopes.get_mut(index) {
            *slope = radius;
        }
        Self { center, slopes, rest: 0.0, range }
    }

    /// How much each input moves the value, at most.
    pub(super) fn slopes(&self) -> &[f64] {
        &self.slopes
    }

    /// Whether the linear part says something.
    fn is_linear(&self) -> bool {
        self.rest.is_finite() && self.center.is_finite()
    }

    /// Σ|slope| + rest, rounded up.
    fn spread(&self) -> f64 {
        self.slopes.iter().fold(self.rest, |sum, slope| plus(sum, slope.abs()))
    }

    /// The greatest magnitude.
    pub(super) fn greatest(&self) -> f64 {
        greatest(self.range)
    }

    /// With the interval made no wider than the linear part, and the linear part given up where it is
    /// no number.
    fn settled(mut self) -> Self {
        if !self.is_linear() || self.slopes.iter().any(|slope| !slope.is_finite()) {
            self.rest = f64::INFINITY;
            self.slopes.clear();
            return self;
        }
        let linear = widened(Interval::from(self.center), self.spread());
        if let Some(both) = self.range.intersection(&linear) {
            self.range = both;
        }
        self
    }

    /// With whatever is at most `by` away.
    pub(super) fn widened(&self, by: f64) -> Self {
        if by == 0.0 {
            return self.clone();
        }
        Self { rest: plus(self.rest, by), range: widened(self.range, by), ..self.clone() }
    }

    /// With an interval that holds the value besides.
    pub(super) fn within(mut self, range: Interval) -> Self {
        if let Some(both) = self.range.intersection(&range) {
            self.range = both;
        }
        self
    }

    /// −a.
    pub(super) fn neg(&self) -> Self {
        Self {
            center: -self.center,
            slopes: self.slopes.iter().map(|slope| -slope).collect(),
            rest: self.rest,
            range: -self.range,
        }
    }

    /// a·this + b·that, coefficient by coefficient, with what that loses.
    fn mixed(
        &self,
        a: f64,
        other: &Self,
        b: f64,
        center: (f64, f64),
        rest: f64,
        range: Interval,
    ) -> Self {
        let count = self.slopes.len().max(other.slopes.len());
        let mut lost = times(LOSS, center.1);
        let mut slopes = Vec::with_capacity(count);
        for index in 0..count {
            let at = |form: &Self| form.slopes.get(index).copied().unwrap_or(0.0);
            let (p, q) = (a * at(self), b * at(other));
            slopes.push(p + q);
            if p != 0.0 || q != 0.0 {
                lost = plus(lost, plus(times(LOSS, p.abs() + q.abs()), TINY));
            }
        }
        Self { center: center.0, slopes, rest: plus(rest, lost), range }.settled()
    }

    /// a + b.
    pub(super) fn add(&self, other: &Self) -> Self {
        let range = self.range + other.range;
        let center = (self.center + other.center, self.center.abs() + other.center.abs());
        self.mixed(1.0, other, 1.0, center, plus(self.rest, other.rest), range)
    }

    /// a − b.
    pub(super) fn sub(&self, other: &Self) -> Self {
        self.add(&other.neg())
    }

    /// a·b.
    pub(super) fn mul(&self, other: &Self) -> Self {
        let range = self.range * other.range;
        if !self.is_linear() || !other.is_linear() {
            return Self::of(range);
        }
        let product = self.center * other.center;
        let quadratic = times(self.spread(), other.spread());
        let rest = plus(
            plus(quadratic, TINY),
            plus(times(self.center.abs(), other.rest), times(other.center.abs(), self.rest)),
        );
        self.mixed(other.center, other, self.center, (product, product.abs()), rest, range)
    }

    /// a². Better than a·a, since the squares of the ε are not negative.
    pub(super) fn square(&self) -> Self {
        let range = self.range.square();
        if !self.is_linear() {
            return Self::of(range);
        }
        let spread = self.spread();
        let quadratic = times(0.5, times(spread, spread));
        let product = self.center * self.center;
        let center = (product + quadratic, plus(product, quadratic));
        let rest = plus(plus(quadratic, TINY), times(2.0, times(self.center.abs(), self.rest)));
        self.mixed(2.0 * self.center, &Self::point(0.0), 0.0, center, rest, range)
    }

    /// slope·this + [lower, upper], all of it rigorous.
    fn line(&self, slope: f64, over: Interval, range: Interval) -> Self {
        let middle = over.midpoint();
        let radius = (over.upper() - middle).max(middle - over.lower()).next_up();
        let product = slope * self.center;
        let center = (product + middle, product.abs() + middle.abs());
        let rest = plus(plus(radius, TINY), times(slope.abs(), self.rest));
        self.mixed(slope, &Self::point(0.0), 0.0, center, rest, range)
    }

    /// 1/a; nothing is known where a may be 0.
    ///
    /// On 0 < p ≤ a ≤ q, 1/a − s·a is convex for every slope s, so that its greatest value is at an end,
    /// and for s < 0 at least 2·√(−s).
    pub(super) fn reciprocal(&self) -> Self {
        if self.range.contains_zero() {
            return Self::of(Interval::WHOLE);
        }
        if self.range.upper() < 0.0 {
            return self.neg().reciprocal().neg();
        }
        let one = Interval::from(1.0);
        let range = one / self.range;
        let (p, q) = (self.range.lower(), self.range.upper());
        let slope = -(1.0 / p) / q;
        if !self.is_linear() || !slope.is_finite() || slope.abs() < f64::MIN_POSITIVE {
            return Self::of(range);
        }
        if p == q {
            return Self::constant(range);
        }
        let end = |x: f64| one / Interval::from(x) - Interval::from(slope) * Interval::from(x);
        let least = Interval::from(2.0) * Interval::from(-slope).sqrt().unwrap_or(Interval::WHOLE);
        let most = end(p).upper().max(end(q).upper());
        self.line(slope, Interval::between(least.lower(), most), range)
    }

    /// a/b.
    pub(super) fn div(&self, other: &Self) -> Self {
        if other.range.contains_zero() {
            return Self::of(Interval::WHOLE);
        }
        self.mul(&other.reciprocal()).within(self.range / other.range)
    }

    /// √a of what is not negative.
    ///
    /// √a − s·a is concave, so that its least value is at an end, and for s > 0 at most 1/(4s).
    pub(super) fn sqrt(&self) -> Self {
        let range = self.range.sqrt().unwrap_or(Interval::WHOLE);
        let (p, q) = (self.range.lower().max(0.0), self.range.upper());
        let slope = 1.0 / (p.sqrt() + q.sqrt());
        if !self.is_linear() || !slope.is_finite() || slope < 1e-150 {
            return Self::of(range);
        }
        if p == q {
            return Self::constant(range);
        }
        let end = |x: f64| {
            let root = Interval::from(x).sqrt().unwrap_or(Interval::WHOLE);
            root - Interval::from(slope) * Interval::from(x)
        };
        let most = Interval::from(0.25) / Interval::from(slope);
        let least = end(p).lower().min(end(q).lower());
        self.line(slope, Interval::between(least, most.upper()), range)
    }

    /// |a|.
    pub(super) fn abs(&self) -> Self {
        if self.range.lower() >= 0.0 {
            self.clone()
        } else if self.range.upper() <= 0.0 {
            self.neg()
        } else {
            Self::of(Interval::between(0.0, self.greatest()))
        }
    }

    /// The smaller of two.
    pub(super) fn min(&self, other: &Self) -> Self {
        if self.range.upper() <= other.range.lower() {
            return self.clone();
        }
        if other.range.upper() <= self.range.lower() {
            return other.clone();
        }
        let lower = self.range.lower().min(other.range.lower());
        Self::of(Interval::between(lower, self.range.upper().min(other.range.upper())))
    }

    /// The larger of two.
    pub(super) fn max(&self, other: &Self) -> Self {
        self.neg().min(&other.neg()).neg()
    }

    /// Either of two.
    pub(super) fn either(&self, other: &Self) -> Self {
        Self::of(self.range.hull(&other.range))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a grid of points of a box, the form of a function holds what the function gives.
    #[test]
    fn forms_hold_their_functions() {
        let (lower, upper) = ([0.5, -2.0], [0.75, -1.0]);
        let [x, y] = [0, 1].map(|j| Form::input(j, 2, lower[j], upper[j]));
        type Function = fn(f64, f64) -> f64;
        let cases: [(Form, Function); 8] = [
            (x.add(&y), |x, y| x + y),
            (x.sub(&y), |x, y| x - y),
            (x.mul(&y), |x, y| x * y),
            (y.square(), |_, y| y * y),
            (x.div(&y), |x, y| x / y),
            (y.reciprocal(), |_, y| 1.0 / y),
            (x.sqrt(), |x, _| x.sqrt()),
            (x.mul(&x).sub(&x.div(&y).abs()), |x, y| x * x - (x / y).abs()),
        ];
        for (form, function) in cases {
            assert!(form.is_linear());
            for i in 0..=16 {
                for j in 0..=16 {
                    let e = [f64::from(i) / 8.0 - 1.0, f64::from(j) / 8.0 - 1.0];
                    let value = function(0.625 + 0.125 * e[0], -1.5 + 0.5 * e[1]);
                    let linear: f64 =
                        form.center + form.slopes.iter().zip(e).map(|(s, e)| s * e).sum::<f64>();
                    assert!((value - linear).abs() <= form.rest + 1e-14, "{form:?}");
                    let range = widened(form.range, 1e-14);
                    assert!(range.lower() <= value && value <= range.upper());
                }
            }
        }
    }

    /// What cancels in x/(1 + x) + 1/(1 + x) cancels in the form, up to the square of the width.
    #[test]
    fn the_rest_shrinks_with_the_square_of_the_box() {
        let rest = |width: f64| {
            let x = Form::input(0, 1, 1.0, 1.0 + width);
            let sum = x.add(&Form::point(1.0));
            let one = x.div(&sum).add(&sum.reciprocal());
            one.range.width()
        };
        let (wide, narrow) = (rest(1e-2), rest(1e-3));
        assert!(narrow < wide / 50.0, "{wide} {narrow}");
    }
}
