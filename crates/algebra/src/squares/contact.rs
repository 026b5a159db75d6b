//! Where an identity leaves no room: each square of it is zero there, by which a positive product is multiplied.
//!
//! Floats find the middle of the matrices that remain; that some of them are singular they tell only about.

use kane_kernel::Poly;
use num_rational::BigRational;
use num_traits::{Pow, Signed as _, Zero as _};

use super::{Q, Question, total_degree};

/// A place where P is zero, no product is negative and all equations hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Contact {
    /// a point; variables without a value are 0
    At(Vec<(usize, BigRational)>),
    /// a direction, in which this is so of what has the highest degree
    Towards(Vec<(usize, BigRational)>),
}

impl Contact {
    /// The value of a polynomial at the point, or of its terms of degree n in the direction.
    fn value(&self, p: &Poly, n: u32) -> Q {
        let (Self::At(at) | Self::Towards(at)) = self;
        let of = |v: usize| at.iter().find(|(w, _)| *w == v).map_or_else(Q::zero, |q| q.1.clone());
        let counts = |m: &[(usize, u32)]| match self {
            Self::At(_) => true,
            Self::Towards(_) => m.iter().map(|f| f.1).sum::<u32>() == n,
        };
        p.terms().filter(|(m, _)| counts(m)).fold(Q::zero(), |sum, (m, c)| {
            let power = |product: Q, &(v, n): &(usize, u32)| product * Pow::pow(of(v), n);
            sum + m.iter().fold(Q::from(c.clone()), power)
        })
    }

    /// The degree of what a product is multiplied by, if it counts here: in a direction only what reaches the degree of
    /// the whole does.
    fn room(&self, question: &Question<'_>, product: &Poly) -> Option<u32> {
        let room = question.degree.checked_sub(total_degree(product))?;
        (matches!(self, Self::At(_)) || room.is_multiple_of(2)).then_some(room)
    }

    /// Whether the question has no room here. What has few terms is looked at first.
    #[must_use]
    pub fn is_of(&self, question: &Question<'_>) -> bool {
        if matches!(self, Self::Towards(_)) && total_degree(question.positive) != question.degree {
            return false;
        }
        let products = question.products.iter().filter(|p| self.room(question, p).is_some());
        let mut all: Vec<(&Poly, bool)> = products.map(|p| (p, false)).collect();
        all.extend(question.equations.iter().chain([question.positive]).map(|p| (p, true)));
        all.sort_by_key(|(p, _)| p.len());
        all.into_iter().all(|(p, is_zero)| {
            let value = self.value(p, total_degree(p));
            if is_zero { value.is_zero() } else { !value.is_negative() }
        })
    }

    /// The degree of squares that are zero here, of a product that is positive.
    pub(super) fn closes(&self, question: &Question<'_>, product: &Poly) -> Option<u32> {
        let room = self.room(question, product)?;
        self.value(product, total_degree(product)).is_positive().then_some(room / 2)
    }

    /// Those combinations of a basis, of this degree, that are zero here.
    pub(super) fn vanishing(&self, basis: &[Poly], degree: u32) -> Vec<Poly> {
        let values: Vec<Q> = basis.iter().map(|p| self.value(p, degree)).collect();
        let Some(pivot) = values.iter().position(|q| !q.is_zero()) else { return basis.to_vec() };
        let others = basis.iter().zip(&values).enumerate().filter(|(i, _)| *i != pivot);
        let combined = others.map(|(_, (p, q))| {
            // p less so many times the pivot, in integers
            let by = q / &values[pivot];
            p.scale(by.denom()).add(&basis[pivot].scale(&-by.numer())).primitive().1
        });
        combined.collect()
    }
}
