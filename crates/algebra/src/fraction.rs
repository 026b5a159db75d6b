//! Quotients of polynomials in lowest terms.

use std::ops::{Add, Div, Mul, Neg, Sub};

use kane_number::Rational;
use num_traits::One;
use polycore::{Monomial, Order};

type Poly = polycore::Poly<Rational>;

/// num/den without a common factor, the first coefficient of den being 1.
///
/// Operands are in lowest terms, so that only divisors of their denominators can cancel: sums and
/// products take greatest common divisors of these, never of what was multiplied out. Source: P. Henrici,
/// J. ACM 3 (1956) 6–9; D. E. Knuth, *The Art of Computer Programming* 2, 4.5.1.
#[derive(Clone, Debug)]
pub(crate) struct Fraction {
    num: Poly,
    den: Poly,
}

impl Fraction {
    /// num/den in lowest terms; `None` if den is zero.
    pub(crate) fn new(num: Poly, den: Poly) -> Option<Self> {
        if den.is_zero() {
            return None;
        }
        let (num, den) = aligned(num, den);
        if num.is_zero() {
            return Some(num.into());
        }
        let (_, num, den) = cofactors(&num, &den);
        Some(Self::monic(num, den))
    }

    pub(crate) const fn num(&self) -> &Poly {
        &self.num
    }

    pub(crate) const fn den(&self) -> &Poly {
        &self.den
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.num.is_zero()
    }

    /// Of polynomials without a common factor.
    fn monic(num: Poly, den: Poly) -> Self {
        if num.is_zero() {
            return Self::from(num);
        }
        match den.lc() {
            Some(lead) if !lead.is_one() => {
                let by = lead.recip();
                Self { num: num.scale(&by), den: den.scale(&by) }
            }
            _ => Self { num, den },
        }
    }
}

impl From<Poly> for Fraction {
    fn from(num: Poly) -> Self {
        let den = Poly::constant(Rational::one(), num.nvars, num.order.clone());
        Self { num, den }
    }
}

impl From<Rational> for Fraction {
    fn from(constant: Rational) -> Self {
        Poly::constant(constant, 0, Order::GRevLex).into()
    }
}

/// A polynomial in n variables, the new ones last.
fn widened(p: Poly, n: usize) -> Poly {
    if p.nvars == n {
        return p;
    }
    let terms = p.terms.into_iter().map(|(m, c)| {
        let mut exponents = m.exps().to_vec();
        exponents.resize(n, 0);
        (Monomial::new(exponents), c)
    });
    Poly::new(terms.collect(), n, p.order)
}

fn aligned(a: Poly, b: Poly) -> (Poly, Poly) {
    let n = a.nvars.max(b.nvars);
    (widened(a, n), widened(b, n))
}

/// g, a/g and b/g for a greatest common divisor g of polynomials that are not zero.
fn cofactors(a: &Poly, b: &Poly) -> (Poly, Poly, Poly) {
    let one = || Poly::constant(Rational::one(), a.nvars, a.order.clone());
    if a.is_constant() || b.is_constant() {
        return (one(), a.clone(), b.clone());
    }
    if a == b {
        return (a.clone(), one(), one());
    }
    if a.terms.len() == 1 || b.terms.len() == 1 {
        return by_monomial(a, b);
    }
    zippel_gcd::cofactors(a, b)
}

/// The same where one of the two is a single term.
fn by_monomial(a: &Poly, b: &Poly) -> (Poly, Poly, Poly) {
    let all = || a.terms.iter().chain(&b.terms).map(|(m, _)| m.exps());
    let least: Vec<_> =
        (0..a.nvars).map(|v| all().map(|exponents| exponents[v]).min().unwrap_or(0)).collect();
    let lowered = |p: &Poly| {
        let terms = p.terms.iter().map(|(m, c)| {
            let rest: Vec<u32> = m.exps().iter().zip(&least).map(|(e, l)| e - l).collect();
            (Monomial::new(rest), c.clone())
        });
        Poly::new(terms.collect(), p.nvars, p.order.clone())
    };
    let (num, den) = (lowered(a), lowered(b));
    let g =
        Poly::new(vec![(Monomial::new(least.clone()), Rational::one())], a.nvars, a.order.clone());
    (g, num, den)
}

fn both(a: Fraction, b: Fraction) -> (Fraction, Fraction) {
    let n = a.num.nvars.max(b.num.nvars);
    let widened = |f: Fraction| Fraction { num: widened(f.num, n), den: widened(f.den, n) };
    (widened(a), widened(b))
}

impl PartialEq for Fraction {
    fn eq(&self, other: &Self) -> bool {
        let (a, b) = both(self.clone(), other.clone());
        a.num == b.num && a.den == b.den
    }
}

impl Neg for Fraction {
    type Output = Self;

    fn neg(self) -> Self {
        Self { num: -&self.num, ..self }
    }
}

impl Add for Fraction {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (a, b) = both(self, other);
        if a.is_zero() {
            return b;
        }
        if b.is_zero() {
            return a;
        }
        // a/(g·x) + b/(g·y) = (a·y + b·x)/(g·x·y), where only divisors of g can cancel
        let (g, x, y) = cofactors(&a.den, &b.den);
        let sum = &(&a.num * &y) + &(&b.num * &x);
        let (_, num, g) = if sum.is_zero() { (g.clone(), sum, g) } else { cofactors(&sum, &g) };
        Self::monic(num, &(&x * &y) * &g)
    }
}

impl Sub for Fraction {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Fraction {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (a, b) = both(self, other);
        if a.is_zero() {
            return a;
        }
        if b.is_zero() {
            return b;
        }
        let (_, a_num, b_den) = cofactors(&a.num, &b.den);
        let (_, b_num, a_den) = cofactors(&b.num, &a.den);
        Self::monic(&a_num * &b_num, &a_den * &b_den)
    }
}

impl Div for Fraction {
    type Output = Self;

    /// # Panics
    /// If the divisor is zero.
    fn div(self, other: Self) -> Self {
        assert!(!other.is_zero(), "division by zero");
        self * Self::monic(other.den, other.num)
    }
}

#[cfg(test)]
mod tests {
    use num_traits::Zero as _;

    use super::*;

    fn var(v: usize) -> Poly {
        Poly::var(v, v + 1, Order::GRevLex)
    }

    /// The library's own arithmetic, which takes the divisor of everything multiplied out.
    fn plain(f: &Fraction) -> zippel_gcd::Frac {
        zippel_gcd::Frac::new(f.num.clone(), f.den.clone()).expect("not zero")
    }

    #[test]
    fn arithmetic_is_that_of_the_library() {
        let f = |num: Poly, den: Poly| Fraction::new(num, den).expect("not zero");
        let (x, y, z) = (widened(var(0), 3), widened(var(1), 3), var(2));
        let sum = &x + &y;
        let some = [
            f(var(0), var(1)),
            f(sum.clone(), &sum * &z),
            f(&x * &x, &(&x + &z) * &y),
            f(&sum * &(&x + &z), &sum * &sum),
            f(-&(&y * &z), &(&x + &z) * &sum),
            Fraction::from(Rational::new(2.into(), 3.into())),
            Fraction::from(Rational::zero()),
            Fraction::from(&sum * &z),
        ];
        for a in &some {
            for b in &some {
                let (p, q) = (plain(a), plain(b));
                let same = |f: Fraction, g: zippel_gcd::Frac| {
                    assert_eq!(plain(&f), g);
                    // already in lowest terms, and normal
                    let (num, den) = aligned(f.num.clone(), f.den.clone());
                    assert!(cofactors(&num, &den).0.is_constant() || num.is_zero());
                    assert!(den.lc().is_some_and(One::is_one));
                    assert!(f == Fraction::new(num, den).expect("not zero"));
                };
                same(a.clone() + b.clone(), p.clone() + q.clone());
                same(a.clone() - b.clone(), p.clone() - q.clone());
                same(a.clone() * b.clone(), p.clone() * q.clone());
                if !b.is_zero() {
                    same(a.clone() / b.clone(), p / q);
                }
            }
        }
    }
}
