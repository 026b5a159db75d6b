//! Where an identity leaves no room: each square of it is zero there, by which a positive product is multiplied.
//!
//! Floats find the middle of the matrices that remain; that some of them are singular they tell only about.

use kane_kernel::{Fuel, Poly, Power};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Pow, Zero as _};

use super::{Q, Question, total_degree};

/// a + b·√n for the n of a place.
pub type Surd = [BigRational; 2];

/// Coordinates; variables without a value are 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// n ≥ 0, not the square of a rational number if a coordinate has √n
    pub radicand: BigRational,
    /// the coordinates
    pub values: Vec<(usize, Surd)>,
}

impl Place {
    /// The place with these rational coordinates.
    #[must_use]
    pub fn rational(values: impl IntoIterator<Item = (usize, BigRational)>) -> Self {
        let values = values.into_iter().map(|(v, q)| (v, [q, Q::zero()]));
        Self { radicand: Q::zero(), values: values.collect() }
    }

    fn product(&self, [a, b]: &Surd, [c, d]: &Surd) -> Surd {
        [a * c + &self.radicand * (b * d), a * d + b * c]
    }

    /// c·vⁿ·…
    fn term(&self, m: &[Power], c: &BigInt) -> Surd {
        let of = |v: usize| self.values.iter().find(|(w, _)| *w == v).map(|q| &q.1);
        let term = [Q::from(c.clone()), Q::zero()];
        m.iter().fold(term, |term, &(v, n)| match of(v) {
            None => [Q::zero(), Q::zero()],
            Some([a, b]) if b.is_zero() => {
                let power = Pow::pow(a, n);
                term.map(|part| if part.is_zero() { part } else { part * &power })
            }
            Some(value) => (0..n).fold(term, |term, _| self.product(&term, value)),
        })
    }

    /// The sign of a + b·√n: that of the part whose square is greater.
    fn sign(&self, [a, b]: &Surd) -> i8 {
        let rational = kane_kernel::sign(a.numer());
        let root = if self.radicand.is_zero() { 0 } else { kane_kernel::sign(b.numer()) };
        if rational == root || root == 0 {
            return rational;
        }
        let is_greater = a * a > &self.radicand * (b * b);
        if is_greater { rational } else { root }
    }
}

/// A place where P is zero, no product is negative and all equations hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Contact {
    /// a point
    At(Place),
    /// a direction, in which this is so of what has the highest degree
    Towards(Place),
}

impl Contact {
    fn place(&self) -> &Place {
        let (Self::At(place) | Self::Towards(place)) = self;
        place
    }

    /// Whether a coordinate has a square root.
    #[must_use]
    pub fn is_irrational(&self) -> bool {
        self.place().values.iter().any(|(_, [_, b])| !b.is_zero())
    }

    /// The value of a polynomial at the point, or of its terms of degree n in the direction.
    fn value(&self, p: &Poly, n: u32) -> Surd {
        let counts = |m: &[Power]| match self {
            Self::At(_) => true,
            Self::Towards(_) => m.iter().map(|f| f.1).sum::<u32>() == n,
        };
        let terms = p.terms().filter(|(m, _)| counts(m));
        terms.fold([Q::zero(), Q::zero()], |[x, y], (m, c)| {
            let [a, b] = self.place().term(m, c);
            [x + a, if b.is_zero() { y } else { y + b }]
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
            let sign = self.place().sign(&self.value(p, total_degree(p)));
            if is_zero { sign == 0 } else { sign >= 0 }
        })
    }

    /// Whether P does not change its sign here as far as slopes tell: it has none along the variables of which no equation
    /// speaks, or a product that is zero here has another one.
    #[must_use]
    pub fn is_flat(&self, question: &Question<'_>, fuel: &Fuel) -> bool {
        let place = self.place();
        let value = |p: &Poly| self.value(p, total_degree(p));
        let spoken = |v: usize| question.equations.iter().any(|p| p.degree(v) > 0);
        let vars: Vec<usize> =
            question.positive.vars().into_iter().filter(|v| !spoken(*v)).collect();
        let slopes = |p: &Poly| -> Option<Vec<Surd>> {
            vars.iter().map(|v| Some(value(&p.derivative(*v, fuel).ok()?))).collect()
        };
        let Some(own) = slopes(question.positive) else { return true };
        let Some(steep) = own.iter().position(|slope| place.sign(slope) != 0) else { return true };
        // along the slope of P, or without one
        let along = |other: &[Surd]| {
            let is_parallel = own
                .iter()
                .zip(other)
                .all(|(a, b)| place.product(a, &other[steep]) == place.product(b, &own[steep]));
            is_parallel && place.sign(&own[steep]) * place.sign(&other[steep]) >= 0
        };
        let active = question.products.iter().filter(|p| place.sign(&value(p)) == 0);
        active.filter_map(slopes).any(|other| !along(&other))
    }

    /// The degree of squares that are zero here, of a product that is positive.
    pub(super) fn closes(&self, question: &Question<'_>, product: &Poly) -> Option<u32> {
        let room = self.room(question, product)?;
        let value = self.value(product, total_degree(product));
        (self.place().sign(&value) > 0).then_some(room / 2)
    }

    /// Those combinations of a basis, of this degree, that are zero here: a + b·√n is zero where both a and b are.
    pub(super) fn vanishing(&self, basis: &[Poly], degree: u32) -> Vec<Poly> {
        let part = |basis: &[Poly], i: usize| {
            let values = basis.iter().map(|p| self.value(p, degree)[i].clone());
            without_pivot(basis, &values.collect::<Vec<Q>>())
        };
        part(&part(basis, 0), 1)
    }
}

/// The combinations of a basis that are zero where its members have these values.
fn without_pivot(basis: &[Poly], values: &[Q]) -> Vec<Poly> {
    let Some(pivot) = values.iter().position(|q| !q.is_zero()) else { return basis.to_vec() };
    let others = basis.iter().zip(values).enumerate().filter(|(i, _)| *i != pivot);
    let combined = others.map(|(_, (p, q))| {
        // p less so many times the pivot, in integers
        let by = q / &values[pivot];
        p.scale(by.denom()).add(&basis[pivot].scale(&-by.numer())).primitive().1
    });
    combined.collect()
}
