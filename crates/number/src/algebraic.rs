//! Exact real algebraic numbers.

mod arithmetic;
mod compositum;
mod field;
mod greatest_root;
pub mod linear;
mod order;
mod roots;
mod surd;

use std::fmt;
use std::sync::Arc;

use num_traits::{One, Signed, Zero};
use polycore::Uni;

use crate::decimal::significant;
use crate::root::rational::square_root;
use crate::sturm::Sturm;
use crate::{Binary, Integer, Rational, Rounding, encode};
use field::NumberField;
use roots::{Root, real_roots};
use surd::{Surd, simplified};

/// A real root of a polynomial with rational coefficients; all of them form an ordered field.
///
/// Everything is exact: arithmetic, sign, order and equality. There are three representations,
/// of which the first that fits is taken: a rational; a surd a + b√d; and a polynomial in one
/// real root θ of an irreducible polynomial, with an interval that isolates θ.
///
/// Cost: numbers that come from one root by field operations share its field, and cost little
/// more than polynomials of that degree. Numbers of different fields, of degrees n and m, meet in
/// a field of degree up to n·m, found by a linear system of that size: fine up to a degree of
/// about 12, slow beyond 20, and nothing limits it. Signs are found by refinement, after a test
/// for zero, so they take as long as the number is close to zero.
///
/// ```
/// use kane_number::{Algebraic, parse};
/// let two = Algebraic::from(parse("2")?);
/// let root = two.sqrt().expect("2 is not negative");
/// assert_eq!(root.clone() * &root, two);
/// let number = Algebraic::from(parse("1")?) - root;
/// assert_eq!(number.to_string(), "1 - sqrt(2)");
/// assert_eq!(number.to_f64(), -0.41421356237309503);
/// # Ok::<(), kane_number::ParseError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Algebraic(Kind);

#[derive(Clone, Debug)]
enum Kind {
    Rational(Rational),
    Surd(Surd),
    Element(Element),
}

/// r(θ) of a field ℚ(θ).
#[derive(Clone, Debug)]
struct Element {
    field: Arc<NumberField>,
    residue: Uni<Rational>,
}

impl Algebraic {
    /// The distinct real roots of c\[0\] + c\[1\]·x + …, ascending; none if all coefficients are
    /// zero. Exact.
    ///
    /// ```
    /// use kane_number::{Algebraic, parse};
    /// let cubic = [parse("47")?, parse("140")?, parse("-3")?, parse("20")?];
    /// let roots = Algebraic::roots(&cubic);
    /// assert_eq!(roots.len(), 1);
    /// assert_eq!(roots[0].to_string(), "root of 20*x^3 - 3*x^2 + 140*x + 47 near -0.3283");
    /// # Ok::<(), kane_number::ParseError>(())
    /// ```
    #[must_use]
    pub fn roots(coefficients: &[Rational]) -> Vec<Self> {
        let polynomial = Uni::new(coefficients.to_vec());
        real_roots(&polynomial).into_iter().map(Self::from_root).collect()
    }

    /// The square root that is not negative, or `None` of a negative number. Exact.
    #[must_use]
    pub fn sqrt(&self) -> Option<Self> {
        if let Kind::Rational(radicand) = &self.0 {
            return (!radicand.is_negative()).then(|| Self::root_of_rational(radicand));
        }
        if self.is_negative() {
            return None;
        }
        // √ keeps the order: as many roots of p(y²) are greater as there are of p.
        let p = Uni::new(self.polynomial().into_iter().map(Rational::from_integer).collect());
        let greater = self.roots_above(&p);
        let mut even = vec![Rational::zero(); 2 * p.deg() + 1];
        for (power, c) in p.0.into_iter().enumerate() {
            even[2 * power] = c;
        }
        real_roots(&Uni::new(even)).into_iter().nth_back(greater).map(Self::from_root)
    }

    /// The number if it is rational.
    #[must_use]
    pub fn as_rational(&self) -> Option<&Rational> {
        match &self.0 {
            Kind::Rational(exact) => Some(exact),
            Kind::Surd(_) | Kind::Element(_) => None,
        }
    }

    /// The number written out, `3/2` or `1 - sqrt(2)`, where a fraction and one square root of an integer can; exact.
    /// `None` for others, which [`Display`](fmt::Display) names by a polynomial.
    #[must_use]
    pub fn written_out(&self) -> Option<String> {
        match &self.0 {
            Kind::Rational(exact) => Some(exact.to_string()),
            Kind::Surd(surd) => Some(surd.to_string()),
            Kind::Element(_) => None,
        }
    }

    /// A square-free polynomial that is zero here, by ascending powers: coprime integers, the
    /// last one positive. The minimal polynomial, unless a factorisation remained incomplete.
    #[must_use]
    pub fn polynomial(&self) -> Vec<Integer> {
        let polynomial = match &self.0 {
            Kind::Rational(exact) => Uni::new(vec![-exact, Rational::one()]),
            Kind::Surd(surd) => {
                Uni::new(vec![surd.norm(), -&surd.a * Integer::from(2), Rational::one()])
            }
            Kind::Element(Element { field, residue }) if *residue == Uni::x() => {
                field.modulus().clone()
            }
            Kind::Element(Element { field, residue }) => field.polynomial_of(residue),
        };
        polynomial.primitive().0.iter().map(Rational::to_integer).collect()
    }

    /// The ends of an interval that holds this and no other root of
    /// [`polynomial`](Self::polynomial); both ends are the number itself if it is rational.
    #[must_use]
    pub fn isolating_interval(&self) -> (Rational, Rational) {
        let polynomial = self.polynomial().into_iter().map(Rational::from_integer).collect();
        let sturm = Sturm::new(&Uni::new(polynomial));
        self.settle(|low, high| {
            let alone = low == high || sturm.has_one(low, high);
            alone.then(|| (low.clone(), high.clone()))
        })
    }

    /// The nearest `f64`, ties to even: correctly rounded.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.encode(Rounding::NearestEven)
    }

    /// The float for this number under the given rounding, as [`encode`] gives it for rationals:
    /// correctly rounded.
    #[must_use]
    pub fn encode<F: Binary>(&self, rounding: Rounding) -> F {
        // An irrational number is never halfway between floats, nor one of them.
        self.settle(|low, high| {
            let (below, above): (F, F) = (encode(low, rounding), encode(high, rounding));
            let same = below.magnitude_bits() == above.magnitude_bits()
                && below.is_negative() == above.is_negative();
            same.then_some(below)
        })
    }

    /// An enclosure, the narrower the more bits: exact numbers in, exact ends out.
    #[must_use]
    pub fn enclose(&self, bits: u32) -> (Rational, Rational) {
        match &self.0 {
            Kind::Rational(exact) => (exact.clone(), exact.clone()),
            Kind::Surd(surd) => surd.enclose(bits),
            Kind::Element(Element { field, residue }) => field.enclose(residue, bits),
        }
    }

    /// Narrows the enclosure until it answers a question, which it must do in the end.
    fn settle<T>(&self, question: impl Fn(&Rational, &Rational) -> Option<T>) -> T {
        let mut bits = 64;
        loop {
            let (low, high) = self.enclose(bits);
            if let Some(answer) = question(&low, &high) {
                return answer;
            }
            bits *= 2;
        }
    }

    /// How many roots of a square-free polynomial are greater than this one of them, which is irrational.
    fn roots_above(&self, polynomial: &Uni<Rational>) -> usize {
        let sturm = Sturm::new(polynomial);
        self.settle(|low, high| sturm.has_one(low, high).then(|| sturm.count_above(high)))
    }

    fn root_of_rational(radicand: &Rational) -> Self {
        if let Some(root) = square_root(radicand) {
            return root.into();
        }
        let (b, d) = simplified(radicand);
        Self(Kind::Surd(Surd { a: Rational::zero(), b, d }))
    }

    fn from_root(root: Root) -> Self {
        match root {
            Root::Rational(exact) => exact.into(),
            Root::Irrational(polynomial, low, high) => {
                let field = Arc::new(NumberField::new(&polynomial, low, high));
                Self::element(field, Uni::x())
            }
        }
    }

    /// r(θ) in the simplest representation that shows without work.
    fn element(field: Arc<NumberField>, residue: Uni<Rational>) -> Self {
        if residue.deg() == 0 {
            return residue.0.into_iter().next().unwrap_or_default().into();
        }
        if let [q, p, _] = &field.modulus().0[..] {
            return Self::from_quadratic_field(&field, [p, q], &residue);
        }
        Self(Kind::Element(Element { field, residue }))
    }

    /// r₀ + r₁θ for θ² + pθ + q = 0.
    fn from_quadratic_field(
        field: &NumberField,
        [p, q]: [&Rational; 2],
        residue: &Uni<Rational>,
    ) -> Self {
        let middle = -p / Integer::from(2);
        let root = Self::root_of_rational(&(&middle * &middle - q));
        // Halfway between the two roots, and the field's interval holds one of them.
        let mut bits = 32;
        let above = loop {
            let (low, high) = field.generator(bits);
            if low >= middle {
                break true;
            }
            if high <= middle {
                break false;
            }
            bits *= 2;
        };
        let root = if above { root } else { -root };
        let generator = Self::from(middle) + root;
        Self::from(residue.0[1].clone()) * generator + Self::from(residue.0[0].clone())
    }
}

impl From<Rational> for Algebraic {
    fn from(exact: Rational) -> Self {
        Self(Kind::Rational(exact))
    }
}

impl fmt::Display for Algebraic {
    /// `3/2`, `1 - sqrt(2)`, `root of x^3 - 2 near 1.26`.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match &self.0 {
            Kind::Rational(exact) => write!(f, "{exact}"),
            Kind::Surd(surd) => write!(f, "{surd}"),
            Kind::Element(_) => {
                let place = self.settle(|low, high| {
                    let [below, above] = [low, high].map(|end| significant(end, 4));
                    (below == above).then_some(below)
                });
                write!(f, "root of {} near {place}", Written(&self.polynomial()))
            }
        }
    }
}

/// A polynomial in x, from the highest power down.
struct Written<'a>(&'a [Integer]);

impl fmt::Display for Written<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let mut first = true;
        for (power, c) in self.0.iter().enumerate().rev().filter(|(_, c)| !c.is_zero()) {
            let sign = match (first, c.is_negative()) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            first = false;
            let c = c.abs();
            match (power, c.is_one()) {
                (0, _) => write!(f, "{sign}{c}")?,
                (1, true) => write!(f, "{sign}x")?,
                (1, false) => write!(f, "{sign}{c}*x")?,
                (_, true) => write!(f, "{sign}x^{power}")?,
                (_, false) => write!(f, "{sign}{c}*x^{power}")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// φ and −1/φ, the roots of x² − x − 1, in a field of each.
    #[test]
    fn an_element_of_a_quadratic_field_is_the_surd() {
        let number = |n: i64| Rational::from_integer(n.into());
        let golden = Uni::new([-1, -1, 1].map(number).to_vec());
        for (low, high, sign) in [(1, 2, ""), (-1, 0, "-")] {
            let field = Arc::new(NumberField::new(&golden, number(low), number(high)));
            for (constant, slope) in [(3, 2), (0, 2), (-1, -4), (7, 6)] {
                let residue = Uni::new(vec![number(constant), number(slope)]);
                let element = Algebraic::element(field.clone(), residue);
                let Kind::Surd(surd) = &element.0 else { panic!("{element} is a surd") };
                // r₀ + r₁(1 ± √5)/2
                let half = number(slope) / Integer::from(2);
                let b = if sign.is_empty() { half.clone() } else { -&half };
                assert_eq!((&surd.a, &surd.b), (&(number(constant) + &half), &b), "{element}");
                assert_eq!(surd.d, 5.into());
            }
            let constant = Algebraic::element(field, Uni::constant(number(7)));
            assert_eq!(constant.as_rational(), Some(&number(7)));
        }
    }
}
