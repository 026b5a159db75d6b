//! The field operations of algebraic numbers.

use std::sync::Arc;

use num_traits::Zero;
use polycore::Uni;

use super::compositum::{Compositum, compositum};
use super::field::NumberField;
use super::roots::real_roots;
use super::surd::Surd;
use super::{Algebraic, Element, Kind};
use crate::operators::operators;
use crate::{Integer, Number, Rational};

operators!(Algebraic);

/// Two numbers brought to one field.
struct Shared {
    field: Arc<NumberField>,
    a: Uni<Rational>,
    b: Uni<Rational>,
    /// Whether the field is a new one, in which the result may be of lower degree.
    is_new: bool,
}

impl Algebraic {
    fn opposite(&self) -> Self {
        match &self.0 {
            Kind::Rational(exact) => Self::from(-exact),
            Kind::Surd(Surd { a, b, d }) => Self(Kind::Surd(Surd { a: -a, b: -b, d: d.clone() })),
            Kind::Element(Element { field, residue }) => {
                Self(Kind::Element(Element { field: field.clone(), residue: -residue }))
            }
        }
    }

    fn sum(&self, other: &Self) -> Self {
        match (&self.0, &other.0) {
            (Kind::Rational(p), Kind::Rational(q)) => Self::from(p + q),
            (Kind::Rational(p), Kind::Surd(s)) | (Kind::Surd(s), Kind::Rational(p)) => {
                Self::surd(&s.a + p, s.b.clone(), &s.d)
            }
            (Kind::Rational(p), Kind::Element(e)) | (Kind::Element(e), Kind::Rational(p)) => {
                Self::element(e.field.clone(), &e.residue + &Uni::constant(p.clone()))
            }
            _ => match self.in_surd_field(other) {
                Some((s, t)) => Self::surd(s.a + t.a, s.b + t.b, &s.d),
                None => self.in_shared_field(other, |_, a, b| a + b),
            },
        }
    }

    fn difference(&self, other: &Self) -> Self {
        self.sum(&other.opposite())
    }

    fn product(&self, other: &Self) -> Self {
        match (&self.0, &other.0) {
            (Kind::Rational(p), Kind::Rational(q)) => Self::from(p * q),
            (Kind::Rational(p), Kind::Surd(s)) | (Kind::Surd(s), Kind::Rational(p)) => {
                Self::surd(&s.a * p, &s.b * p, &s.d)
            }
            (Kind::Rational(p), Kind::Element(e)) | (Kind::Element(e), Kind::Rational(p)) => {
                Self::element(e.field.clone(), e.residue.scale(p))
            }
            _ => match self.in_surd_field(other) {
                Some((s, t)) => {
                    let rational = &s.a * &t.a + &s.b * &t.b * &s.d;
                    Self::surd(rational, &s.a * t.b + s.b * t.a, &s.d)
                }
                None => self.in_shared_field(other, NumberField::multiply),
            },
        }
    }

    fn quotient(&self, other: &Self) -> Self {
        self.checked_div(other).expect("a division by zero is the caller's to exclude")
    }

    /// 1/a, or `None` for 0.
    fn reciprocal(&self) -> Option<Self> {
        match &self.0 {
            Kind::Rational(exact) => (!exact.is_zero()).then(|| Self::from(exact.recip())),
            Kind::Surd(s) => {
                let norm = s.norm();
                Some(Self::surd(&s.a / &norm, -&s.b / &norm, &s.d))
            }
            Kind::Element(Element { field, residue }) => {
                let (field, inverse) = field.invert(residue)?;
                Some(Self::element(field, inverse))
            }
        }
    }

    fn surd(a: Rational, b: Rational, d: &Integer) -> Self {
        if b.is_zero() { Self::from(a) } else { Self(Kind::Surd(Surd { a, b, d: d.clone() })) }
    }

    /// Both as surds over one radicand, if they are.
    fn in_surd_field(&self, other: &Self) -> Option<(Surd, Surd)> {
        match (&self.0, &other.0) {
            (Kind::Surd(s), Kind::Surd(t)) => Some((s.clone(), t.over(&s.d)?)),
            _ => None,
        }
    }

    /// The field that the number is written in, and the number there.
    pub(super) fn in_own_field(&self) -> Option<(Arc<NumberField>, Uni<Rational>)> {
        match &self.0 {
            Kind::Rational(_) => None,
            Kind::Surd(surd) => {
                // √d lies between 0 and d.
                let (low, high) = (Rational::default(), Rational::from_integer(surd.d.clone()));
                let field = NumberField::new(&surd.modulus(), low, high);
                Some((Arc::new(field), Uni::new(vec![surd.a.clone(), surd.b.clone()])))
            }
            Kind::Element(e) => Some((e.field.clone(), e.residue.clone())),
        }
    }

    fn share(&self, other: &Self) -> Option<Shared> {
        let ((field, a), (second, b)) = (self.in_own_field()?, other.in_own_field()?);
        if field.is_same(&second) {
            return Some(Shared { field, a, b, is_new: false });
        }
        let Compositum { field: common, first, second } = compositum(&field, &second);
        let a = &a.compose(&first) % common.modulus();
        let b = &b.compose(&second) % common.modulus();
        Some(Shared { field: common, a, b, is_new: true })
    }

    /// One field that holds all the numbers, and the numbers in it; `None` if all are rational.
    pub(super) fn in_common_field(
        numbers: &[Self],
    ) -> Option<(Arc<NumberField>, Vec<Uni<Rational>>)> {
        let (mut field, _) = numbers.iter().find_map(Self::in_own_field)?;
        let mut residues: Vec<Uni<Rational>> = Vec::new();
        for number in numbers {
            let Some((own, residue)) = number.in_own_field() else {
                let rational = number.as_rational().cloned().unwrap_or_default();
                residues.push(Uni::constant(rational));
                continue;
            };
            if field.is_same(&own) {
                residues.push(residue);
                continue;
            }
            let Compositum { field: common, first, second } = compositum(&field, &own);
            for earlier in &mut residues {
                *earlier = &earlier.compose(&first) % common.modulus();
            }
            residues.push(&residue.compose(&second) % common.modulus());
            field = common;
        }
        Some((field, residues))
    }

    /// An operation on two numbers neither of which is rational.
    fn in_shared_field(
        &self,
        other: &Self,
        operation: impl Fn(&NumberField, &Uni<Rational>, &Uni<Rational>) -> Uni<Rational>,
    ) -> Self {
        let Some(Shared { field, a, b, is_new }) = self.share(other) else {
            // Rational operands are dealt with before.
            return self.clone();
        };
        let result = Self::element(field.clone(), operation(&field, &a, &b));
        if is_new { result.reduced() } else { result }
    }

    /// The same number as the generator of a field of its own if that is of lower degree: what
    /// two fields share should not grow when they part again.
    fn reduced(self) -> Self {
        let Kind::Element(Element { field, residue }) = &self.0 else { return self };
        let polynomial = field.polynomial_of(residue);
        if polynomial.deg() == field.modulus().deg() {
            return self;
        }
        let greater = self.roots_above(&polynomial);
        real_roots(&polynomial).into_iter().nth_back(greater).map_or(self, Self::from_root)
    }
}

impl Number for Algebraic {
    type Wide = Self;

    const IS_EXACT: bool = true;

    fn widen(&self) -> Self {
        self.clone()
    }

    fn narrow(wide: &Self) -> Self {
        wide.clone()
    }

    fn zero() -> Self {
        Self::from(Rational::default())
    }

    fn one() -> Self {
        Self::from(Rational::from_integer(1.into()))
    }

    fn from_rational(exact: &Rational) -> Self {
        Self::from(exact.clone())
    }

    fn mul_add(&self, factor: &Self, addend: &Self) -> Self {
        self.product(factor).sum(addend)
    }

    fn checked_div(&self, divisor: &Self) -> Option<Self> {
        Some(self.product(&divisor.reciprocal()?))
    }

    fn is_finite(&self) -> bool {
        true
    }
}
