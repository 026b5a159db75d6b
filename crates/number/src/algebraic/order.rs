//! The order of algebraic numbers.

use std::cmp::Ordering;

use num_traits::{Signed, Zero};
use polycore::Uni;

use super::{Algebraic, Element, Kind};
use crate::sturm::Sturm;
use crate::{Comparison, Ordered, Rational};

impl Algebraic {
    /// Whether the number is below zero. Exact.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        self.signum() == Ordering::Less
    }

    /// The order of the number and zero. Exact: by refinement, once it is known not to be zero.
    fn signum(&self) -> Ordering {
        match &self.0 {
            Kind::Rational(exact) => exact.cmp(&Rational::zero()),
            Kind::Surd(surd) if surd.is_negative() => Ordering::Less,
            Kind::Surd(_) => Ordering::Greater,
            Kind::Element(Element { field, residue }) => {
                if field.vanishes(residue) {
                    return Ordering::Equal;
                }
                self.settle(|low, high| {
                    let certain = low.is_positive() || high.is_negative();
                    certain.then(|| low.cmp(&Rational::zero()))
                })
            }
        }
    }

    /// The order if a first enclosure tells it, which is the common case.
    fn compare_enclosures(&self, other: &Self, bits: u32) -> Option<Ordering> {
        let ((low, high), (from, to)) = (self.enclose(bits), other.enclose(bits));
        if high < from {
            return Some(Ordering::Less);
        }
        (to < low).then_some(Ordering::Greater)
    }

    /// The order of numbers of different fields: equal if they are one common root of their
    /// polynomials, otherwise told by refinement. No field that contains both is formed.
    fn order_by_polynomials(&self, other: &Self) -> Ordering {
        if let Some(order) = self.compare_enclosures(other, 64) {
            return order;
        }
        let polynomial = |number: &Self| {
            Uni::new(number.polynomial().into_iter().map(Rational::from_integer).collect())
        };
        let common = polynomial(self).gcd(&polynomial(other));
        let sturm = Sturm::new(&common);
        // A number is the only root of its polynomial in its isolating interval, and the common
        // divisor has a root there only if it is that one.
        let is_root = |number: &Self| {
            let (low, high) = number.isolating_interval();
            sturm.count(&low, &high) == 1
        };
        let meet = [self, other].into_iter().all(is_root);
        let mut bits = 64;
        loop {
            if let Some(order) = self.compare_enclosures(other, bits) {
                return order;
            }
            let ((low, high), (from, to)) = (self.enclose(bits), other.enclose(bits));
            let (low, high) = (low.min(from), high.max(to));
            if meet && sturm.has_one(&low, &high) {
                return Ordering::Equal;
            }
            bits *= 2;
        }
    }

    /// The order of two algebraic numbers. Exact.
    pub(super) fn order(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Kind::Rational(p), Kind::Rational(q)) => p.cmp(q),
            (Kind::Element(e), Kind::Element(g)) if !e.field.is_same(&g.field) => {
                self.order_by_polynomials(other)
            }
            (Kind::Element(_), Kind::Surd(_)) | (Kind::Surd(_), Kind::Element(_)) => {
                self.order_by_polynomials(other)
            }
            (Kind::Surd(s), Kind::Surd(t)) if s.over(&t.d).is_none() => {
                // Irrational parts of different fields cannot cancel.
                self.order_by_polynomials(other)
            }
            // One field: the difference is in it.
            _ => (self.clone() - other).signum(),
        }
    }
}

impl PartialEq for Algebraic {
    /// Equality of the values. Exact.
    fn eq(&self, other: &Self) -> bool {
        self.order(other) == Ordering::Equal
    }
}

impl Eq for Algebraic {}

impl PartialOrd for Algebraic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Algebraic {
    fn cmp(&self, other: &Self) -> Ordering {
        self.order(other)
    }
}

impl Ordered for Algebraic {
    fn compare(&self, other: &Self) -> Comparison {
        self.order(other).into()
    }
}
