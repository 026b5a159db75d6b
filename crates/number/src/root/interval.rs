//! The greatest root in an interval, enclosed.
#![allow(clippy::float_arithmetic, reason = "the interval's ends are floats")]

use crate::{Interval, Number, Ordered};

/// An enclosure of the greatest root in \[lower, upper\] for every choice of the coefficients and
/// ends that keeps the promise of [`Real::greatest_root`](crate::Real::greatest_root).
///
/// Two enclosures are intersected: the closed form, for degrees 1 and 2 with a leading
/// coefficient and a discriminant of certain sign; and a search, from the top of the interval
/// down, for the last place where the polynomial may be zero, then for a point below it where its
/// sign has certainly changed. Rigorous.
pub(crate) fn greatest_root(
    coefficients: &[Interval],
    lower: &Interval,
    upper: &Interval,
) -> Option<Interval> {
    let finite = coefficients.iter().chain([lower, upper]).all(Number::is_finite);
    if coefficients.len() > 4 || !finite || lower.lower() > upper.upper() {
        return None;
    }
    let zero = |c: &&Interval| c.is_point() && c.contains_zero();
    let length = coefficients.len() - coefficients.iter().rev().take_while(zero).count();
    let search = Search { f: &coefficients[..length], lower, upper };
    let domain = search.domain();
    if length <= 1 {
        return Some(domain).filter(|_| length == 0);
    }
    if let Some(roots) = closed_form(search.f, &domain) {
        let [greater, less] = roots;
        // Inside for every choice: then it is the one that is asked for.
        let certain = |x: &Interval| {
            x.compare(lower).is_at_least() == Some(true)
                && x.compare(upper).is_at_most() == Some(true)
        };
        if certain(&greater) {
            return Some(greater);
        }
        let possible = greater.intersection(&domain);
        return match (possible, less.intersection(&domain)) {
            (Some(x), Some(y)) => {
                let searched = search.enclosure()?;
                x.hull(&y).intersection(&searched)
            }
            (x, y) => x.or(y),
        };
    }
    search.enclosure()
}

/// The greater and the smaller real root (of degree 1 the root twice), if it is certain that they
/// are real and which is which.
fn closed_form(f: &[Interval], domain: &Interval) -> Option<[Interval; 2]> {
    match f {
        [c0, c1] => {
            let root = (-*c0).checked_div(c1)?.intersection(domain)?;
            Some([root; 2])
        }
        [c0, c1, c2] => {
            let half = *c1 * Interval::from(0.5);
            let discriminant = half.square() - *c2 * c0;
            if discriminant.sign().is_at_least() != Some(true) {
                return None;
            }
            let root = discriminant.sqrt()?;
            if half.is_point() && half.contains_zero() {
                let root = (-*c0).checked_div(c2)?.sqrt()?;
                return Some([root, -root]);
            }
            // Without cancellation where the sign of h is certain.
            let sum = match half.sign().is_at_most()? {
                true => root - half,
                false => -(half + root),
            };
            let (a, b) = (sum.checked_div(c2)?, c0.checked_div(&sum)?);
            // The larger of the two in magnitude is a; its sign says whether it is the greater.
            let a_is_greater = a.sign().is_greater()?;
            Some(if a_is_greater { [a, b] } else { [b, a] })
        }
        _ => None,
    }
}

/// A polynomial and where its root is wanted.
struct Search<'a> {
    f: &'a [Interval],
    lower: &'a Interval,
    upper: &'a Interval,
}

/// Pieces looked at before the search settles for what it has.
const MOST_PIECES: u32 = 4000;

impl Search<'_> {
    /// Every place where the root may be.
    fn domain(&self) -> Interval {
        Interval::between(self.lower.lower(), self.upper.upper())
    }

    fn at(&self, x: &Interval) -> Interval {
        self.f.iter().rev().fold(Interval::zero(), |sum, c| sum.mul_add(x, c))
    }

    /// Whether 0 is among the values on a piece, by the mean value form too: f(m) + f′(X)·(X − m) is narrower than
    /// Horner's scheme on short pieces.
    fn may_vanish(&self, piece: &Interval) -> bool {
        if !self.at(piece).contains_zero() {
            return false;
        }
        let middle = Interval::from(piece.midpoint());
        let slope = self.slope(piece);
        (self.at(&middle) + slope * (*piece - middle)).contains_zero()
    }

    fn slope(&self, x: &Interval) -> Interval {
        let zero = (Interval::zero(), Interval::zero());
        let step = |(value, slope): (Interval, Interval), c: &Interval| {
            (value.mul_add(x, c), slope.mul_add(x, &value))
        };
        self.f.iter().rev().fold(zero, step).1
    }

    fn enclosure(&self) -> Option<Interval> {
        let domain = self.domain();
        let top = self.extreme(&domain, true)?;
        let from = match self.certain_change(&top) {
            Some(from) => from,
            None => self.extreme(&domain, false)?.lower(),
        };
        Some(Interval::between(from.min(top.lower()), top.upper()))
    }

    /// The topmost (or lowest) piece, as small as floats allow, in which there may be a root.
    fn extreme(&self, domain: &Interval, topmost: bool) -> Option<Interval> {
        let mut left = MOST_PIECES;
        let mut todo = vec![*domain];
        while let Some(piece) = todo.pop() {
            if !self.may_vanish(&piece) {
                continue;
            }
            left = left.saturating_sub(1);
            let middle = piece.midpoint();
            let indivisible = middle <= piece.lower() || middle >= piece.upper();
            // The pieces still to be looked at lie further inside: this one bounds them.
            if indivisible || left == 0 {
                return Some(piece);
            }
            let (low, high) = piece.halves();
            let (first, second) = if topmost { (high, low) } else { (low, high) };
            todo.push(second);
            todo.push(first);
        }
        None
    }

    /// A point below the topmost piece where the sign is certainly not the one above it: then a
    /// root lies between, for every choice of coefficients, and nothing below it is the greatest.
    fn certain_change(&self, top: &Interval) -> Option<f64> {
        let (from, to) = (self.lower.upper(), self.upper.lower());
        if top.upper() > to {
            return None;
        }
        let at_end = self.at(&Interval::from(to));
        if at_end.contains_zero() {
            return None;
        }
        let above = at_end.lower().is_sign_positive();
        let step = top.upper().abs() * f64::EPSILON;
        let mut distance = top.width().max(step).max(f64::MIN_POSITIVE);
        loop {
            let x = (top.lower() - distance).max(from);
            let value = self.at(&Interval::from(x)).sign();
            let changed = if above { value.is_less() } else { value.is_greater() };
            if changed == Some(true) {
                return Some(x);
            }
            if x <= from {
                return None;
            }
            distance *= 2.0;
        }
    }
}
