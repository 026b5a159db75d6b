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

/// Terms of both of two polynomials from which on a division is tried before a greatest common divisor is looked for.
const LONG: usize = 6;
/// Steps of such a division for each of their terms.
const STEPS: usize = 4;

fn aligned(a: Poly, b: Poly) -> (Poly, Poly) {
    let n = a.nvars.max(b.nvars);
    (widened(a, n), widened(b, n))
}

/// 1 in the variables of p.
fn one(p: &Poly) -> Poly {
    Poly::constant(Rational::one(), p.nvars, p.order.clone())
}

/// g, a/g and b/g for a greatest common divisor g of polynomials that are not zero.
fn cofactors(a: &Poly, b: &Poly) -> (Poly, Poly, Poly) {
    let shares = |v: usize| [a, b].iter().all(|p| p.terms.iter().any(|(m, _)| m.exps()[v] > 0));
    if !(0..a.nvars).any(shares) {
        return (one(a), a.clone(), b.clone());
    }
    if a == b {
        return (a.clone(), one(a), one(a));
    }
    if a.terms.len() == 1 || b.terms.len() == 1 {
        let (least, common) = monomial(&[a, b]);
        return (common, lowered(a, &least), lowered(b, &least));
    }
    by_division(a, b).unwrap_or_else(|| zippel_gcd::cofactors(a, b))
}

/// The same where, but for monomials, one of the two divides the other or has no factors of its own. Where they are
/// long the former is often so: denominators are products of the same few factors. `None` where neither is, or the
/// division takes long.
fn by_division(a: &Poly, b: &Poly) -> Option<(Poly, Poly, Poly)> {
    let (least, common) = monomial(&[a, b]);
    let (p, q) = (lowered(a, &monomial(&[a]).0), lowered(b, &monomial(&[b]).0));
    let (short, long) = if p.terms.len() < q.terms.len() { (p, q) } else { (q, p) };
    let steps = STEPS * (short.terms.len() + long.terms.len());
    let (x, y) = (lowered(a, &least), lowered(b, &least));
    let g = if short.terms.len() == 1 {
        None
    } else if is_prime(&short) {
        long.exact(&short).map(|_| short)
    } else if short.terms.len() < LONG {
        return None;
    } else if long.exact_with_budget(&short, steps).is_some() {
        Some(short)
    } else {
        Some(short.exact_with_budget(&long, steps).map(|_| long)?)
    };
    match g {
        Some(g) => Some((&g * &common, x.exact(&g)?, y.exact(&g)?)),
        None => Some((common, x, y)),
    }
}

/// Whether a polynomial that no monomial divides visibly has no factors: it is linear in a variable whose coefficient
/// is a monomial.
fn is_prime(p: &Poly) -> bool {
    let is_linear = |v: usize| {
        let mut with_it = p.terms.iter().map(|(m, _)| m.exps()[v]).filter(|e| *e > 0);
        with_it.next() == Some(1) && with_it.next().is_none()
    };
    (0..p.nvars).any(is_linear)
}

/// The exponents of the greatest monomial that divides all of these polynomials, and the monomial.
fn monomial(all: &[&Poly]) -> (Vec<u32>, Poly) {
    let terms = || all.iter().flat_map(|p| &p.terms).map(|(m, _)| m.exps());
    let of = |v: usize| terms().map(|exponents| exponents[v]).min().unwrap_or(0);
    let least: Vec<u32> = (0..all[0].nvars).map(of).collect();
    let one = vec![(Monomial::new(least.clone()), Rational::one())];
    (least, Poly::new(one, all[0].nvars, all[0].order.clone()))
}

/// A polynomial over a monomial that divides it.
fn lowered(p: &Poly, by: &[u32]) -> Poly {
    if by.iter().all(|e| *e == 0) {
        return p.clone();
    }
    let terms = p.terms.iter().map(|(m, c)| {
        let rest: Vec<u32> = m.exps().iter().zip(by).map(|(e, l)| e - l).collect();
        (Monomial::new(rest), c.clone())
    });
    Poly::new(terms.collect(), p.nvars, p.order.clone())
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
        let all = &sum + &z;
        let cube = &(&all * &all) * &all;
        let some = [
            // long polynomials that divide each other but for a monomial, and that do not
            f(&cube * &x, &(&cube * &y) * &(&x + &(&y * &y))),
            f(y.clone(), &cube * &x),
            f(&all * &sum, &(&all * &all) * &(&sum * &z)),
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
