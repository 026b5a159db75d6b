//! Fractions in constants and roots of constants, as coefficients of series.

use std::cell::RefCell;

use kane_algebra::ring::{cancelled, common_sign};
use kane_kernel::{Atom, Expr, Fraction, Piece, Poly, Sign, State};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed as _;

use super::factors::square_root;
use super::series::Numbers;
use super::variation;

/// Estimates of roots are multiples of one part in so many.
const ESTIMATE: u32 = 1000;
/// Terms of a numerator or a denominator.
const TERMS: usize = 60;

/// num/den
pub(super) type Quotient = (Poly, Poly);

/// Such fractions at the end of a limit along a variable.
pub(super) struct Symbols<'a, 's, 'g> {
    state: &'a State<'s, 'g>,
    x: usize,
    /// what is known without cases
    known: Vec<Atom>,
    /// roots and their radicands, which are quotients of constants and earlier roots
    roots: Vec<(usize, Quotient)>,
    /// what signs were asked of, and what was divided by: near its zeros the radius is small
    asked: RefCell<Vec<Poly>>,
    /// numbers of which roots were asked that the scope does not have
    missing: RefCell<Vec<BigRational>>,
    /// whether something near stands for a root that the scope does not have
    estimates: bool,
}

impl<'a, 's, 'g> Symbols<'a, 's, 'g> {
    pub(super) fn new(state: &'a State<'s, 'g>, x: usize) -> Self {
        let mut plain = state.clone();
        for formula in 0..state.formulas.len() {
            if let Ok(cases) = plain.assume(formula)
                && let [only] = &cases[..]
            {
                plain = only.clone();
            }
        }
        let known = plain.atoms.to_vec();
        let (asked, missing) = (RefCell::default(), RefCell::default());
        let roots = Vec::new();
        let mut out = Self { state, x, known, roots, asked, missing, estimates: false };
        for v in variation::roots(state.scope) {
            let radicand = out.radicand(v);
            out.roots.extend(radicand.map(|radicand| (v, radicand)));
        }
        out
    }

    /// What a root is the root of, if there are constants and earlier roots alone in it.
    fn radicand(&self, root: usize) -> Option<Quotient> {
        let Fraction { num, den } = radicand(self.state, root)?;
        let known = |v: &usize| {
            self.state.is_constant(*v, self.x) || self.roots.iter().any(|(root, _)| root == v)
        };
        let all_known = num.vars().iter().chain(&den.vars()).all(known);
        all_known.then_some((num, den))
    }

    /// The product of what signs were asked of and of what was divided by.
    pub(super) fn lead(&self) -> Option<Poly> {
        let asked = self.asked.borrow();
        let fuel = &self.state.scope.fuel;
        asked.iter().try_fold(Poly::one(), |product, p| product.mul(p, fuel).ok())
    }

    /// From now on estimates stand for roots that the scope does not have. They serve for slopes, near which lines are
    /// tried; a limit that is one is not found.
    pub(super) fn estimate_roots(&mut self) {
        self.estimates = true;
    }

    /// √q to three digits, and of what is no number its mean with 1.
    fn estimate(&self, (num, den): &Quotient) -> Option<Quotient> {
        if let (Some(num), Some(den)) = (num.as_constant(), den.as_constant()) {
            let digits = BigInt::from(ESTIMATE);
            let root = (num * &den * &digits * &digits).sqrt();
            return Some(self.number(&BigRational::new(root, den * digits)));
        }
        let half = self.number(&BigRational::new(1.into(), 2.into()));
        let one = (Poly::one(), Poly::one());
        self.product(&half, &self.sum(&(num.clone(), den.clone()), &one)?)
    }

    /// The numbers without whose roots there is no answer.
    pub(super) fn missing(&self) -> Vec<BigRational> {
        self.missing.take()
    }

    fn ask(&self, p: &Poly) {
        let (_, p) = p.primitive();
        let constant = |v: &usize| self.state.is_constant(*v, self.x);
        let mut asked = self.asked.borrow_mut();
        // powers of one variable shrink like itself
        let parts =
            if p.len() == 1 { p.vars().into_iter().map(Poly::var).collect() } else { vec![p] };
        for part in parts {
            let new = !asked.contains(&part) && !asked.contains(&part.neg());
            if !part.is_constant() && part.vars().iter().all(constant) && new {
                asked.push(part);
            }
        }
    }

    fn reduced(&self, num: &Poly, den: &Poly) -> Option<Quotient> {
        let (num, den) = self.without_squares(num.clone(), den.clone())?;
        if num.is_empty() {
            return Some((num, Poly::one()));
        }
        let (num, den) = lowest(&cancelled(&num, &den));
        (num.len() <= TERMS && den.len() <= TERMS && !den.is_empty()).then_some((num, den))
    }

    /// num/den with radicands in the place of squares of their roots.
    fn without_squares(&self, mut num: Poly, mut den: Poly) -> Option<Quotient> {
        let fuel = &self.state.scope.fuel;
        for (root, (n, d)) in self.roots.iter().rev() {
            let squares = num.degree(*root).max(den.degree(*root)) / 2;
            if squares == 0 {
                continue;
            }
            // r^(2i + j) times dˢ is nⁱ·d^(s − i)·rʲ
            let put = |p: &Poly| -> Option<Poly> {
                let mut sum = Poly::default();
                for power in 0..=p.degree(*root) {
                    let (i, j) = (power / 2, power % 2);
                    let scale = n.pow(i, fuel).ok()?.mul(&d.pow(squares - i, fuel).ok()?, fuel);
                    let part = p.coefficient(*root, power).mul(&scale.ok()?, fuel).ok()?;
                    sum = sum.add(&part.mul(&Poly::power(*root, j), fuel).ok()?);
                }
                Some(sum)
            };
            (num, den) = (put(&num)?, put(&den)?);
        }
        Some((num, den))
    }

    fn is_strict(&self, v: usize) -> bool {
        let radicand = self.roots.iter().find(|(root, _)| *root == v);
        match radicand {
            Some((_, (num, den))) => {
                self.sign(num).is_some_and(|sign| self.sign(den) == Some(sign))
            }
            None => self.known.contains(&Atom::new(Poly::var(v), Sign::Positive)),
        }
    }

    /// Whether a number is positive, or else not negative, and so for the opposite, if that is plain.
    pub(super) fn leans(&self, a: &Quotient) -> Option<bool> {
        let weak = |v: usize| {
            let known = |sign| self.known.contains(&Atom::new(Poly::var(v), sign));
            self.roots.iter().any(|root| root.0 == v) || known(Sign::NonNegative)
        };
        let leans = |p: &Poly| {
            let has_sign = |&(v, n): &(usize, u32)| n % 2 == 0 || self.is_strict(v) || weak(v);
            let all = p.terms().all(|(m, _)| m.iter().all(has_sign));
            if all { common_sign(p) } else { self.sign(p) }
        };
        Some(leans(&a.0)? == self.sign(&a.1)?)
    }

    /// Whether a polynomial is positive or negative, if that is plain.
    pub(super) fn sign(&self, p: &Poly) -> Option<bool> {
        if let Some(positive) = common_sign(p) {
            let strict = |m: &[(usize, u32)]| m.iter().all(|&(v, _)| self.is_strict(v));
            let square =
                |m: &[(usize, u32)]| m.iter().all(|&(v, n)| n % 2 == 0 || self.is_strict(v));
            if p.terms().all(|(m, _)| square(m)) && p.terms().any(|(m, _)| strict(m)) {
                return Some(positive);
            }
        }
        let (content, p) = p.primitive();
        let told = |p: &Poly| {
            self.known.iter().any(|a| a.sign == Sign::Positive && a.poly.primitive().1 == *p)
        };
        let sign = if told(&p) { true } else { told(&p.neg()).then_some(false)? };
        Some(sign == content.is_positive())
    }
}

impl Numbers for Symbols<'_, '_, '_> {
    type Number = Quotient;

    fn number(&self, q: &BigRational) -> Quotient {
        (Poly::constant(q.numer().clone()), Poly::constant(q.denom().clone()))
    }

    fn symbol(&self, v: usize) -> Option<Quotient> {
        self.state.is_constant(v, self.x).then(|| (Poly::var(v), Poly::one()))
    }

    fn sum(&self, a: &Quotient, b: &Quotient) -> Option<Quotient> {
        let fuel = &self.state.scope.fuel;
        let num = a.0.mul(&b.1, fuel).ok()?.add(&b.0.mul(&a.1, fuel).ok()?);
        self.reduced(&num, &a.1.mul(&b.1, fuel).ok()?)
    }

    fn product(&self, a: &Quotient, b: &Quotient) -> Option<Quotient> {
        let fuel = &self.state.scope.fuel;
        self.reduced(&a.0.mul(&b.0, fuel).ok()?, &a.1.mul(&b.1, fuel).ok()?)
    }

    /// Without roots in the denominator: nothing is known of them where it is asked whether that vanishes.
    fn inverse(&self, a: &Quotient) -> Option<Quotient> {
        let fuel = &self.state.scope.fuel;
        self.ask(&a.0);
        let (mut num, mut den) = a.clone();
        for (root, _) in self.roots.iter().rev() {
            let [rest, part] = [0, 1].map(|n| num.coefficient(*root, n));
            if !part.is_empty() {
                let conjugate = rest.sub(&part.mul(&Poly::var(*root), fuel).ok()?);
                let product = num.mul(&conjugate, fuel).ok()?;
                (num, den) = self.reduced(&product, &den.mul(&conjugate, fuel).ok()?)?;
            }
        }
        (!num.is_empty()).then_some((den, num))
    }

    /// √(N/D²) = S·√R/(R·D) with N·R = S², where R is 1, the radicand of a root, or a product of two.
    fn root(&self, a: &Quotient) -> Option<Quotient> {
        let fuel = &self.state.scope.fuel;
        let square = a.0.mul(&a.1, fuel).ok()?;
        let absolute =
            |p: Poly| self.sign(&p).map(|positive| if positive { p.clone() } else { p.neg() });
        let den = absolute(a.1.clone())?;
        let one = vec![(Poly::one(), Poly::one())];
        // √(n/d)·d is the root of n·d
        let whole = |(root, (n, d)): &(usize, Quotient)| {
            let d = absolute(d.clone())?;
            Some((Poly::var(*root).mul(&d, fuel).ok()?, n.mul(&d, fuel).ok()?))
        };
        let single: Vec<(Poly, Poly)> = self.roots.iter().filter_map(whole).collect();
        let both = single.iter().enumerate().flat_map(|(i, a)| {
            let pair = move |b: &(Poly, Poly)| {
                Some((a.0.mul(&b.0, fuel).ok()?, a.1.mul(&b.1, fuel).ok()?))
            };
            single[..i].iter().filter_map(pair)
        });
        let mut among = one.into_iter().chain(single.iter().cloned()).chain(both);
        let found = among.find_map(|(roots, radicands)| {
            let root = square_root(&square.mul(&radicands, fuel).ok()?, fuel)?;
            let num = absolute(root)?.mul(&roots, fuel).ok()?;
            self.reduced(&num, &radicands.mul(&den, fuel).ok()?)
        });
        if let (None, Some(num), Some(den)) = (&found, a.0.as_constant(), a.1.as_constant()) {
            self.missing.borrow_mut().push(BigRational::new(num, den));
        }
        found.or_else(|| {
            let positive = self.estimates && self.is_positive(a) == Some(true);
            positive.then(|| self.estimate(a)).flatten()
        })
    }

    fn is_zero(&self, a: &Quotient) -> bool {
        a.0.is_empty()
    }

    fn is_positive(&self, a: &Quotient) -> Option<bool> {
        let is_positive = self.sign(&a.0)? == self.sign(&a.1)?;
        self.ask(&a.0);
        Some(is_positive)
    }
}

/// What a root is the root of, if that is one fraction wherever it is defined.
pub(super) fn radicand(state: &State<'_, '_>, root: usize) -> Option<Fraction> {
    let Expr::Sqrt(radicand) = state.scope.root(root)? else { return None };
    let pieces = state.scope.pieces(radicand).ok()?;
    let mut values = pieces.into_iter().filter_map(|piece| piece.value);
    values.next().filter(|_| values.next().is_none())
}

/// A polynomial with radicands in the place of squares of their roots, so that it shows what is left at t = 0.
pub(super) fn without_squares(state: &State<'_, '_>, mut p: Poly) -> Poly {
    let scope = state.scope;
    for v in p.vars() {
        let Some(Expr::Sqrt(radicand)) = scope.root(v) else { continue };
        let Ok(pieces) = scope.pieces(radicand) else { continue };
        if let [Piece { value: Some(Fraction { num, den }), .. }] = &pieces[..]
            && *den == Poly::one()
            && let Ok(rest) = p.remainder(v, &Poly::power(v, 2).sub(num), false, &scope.fuel)
        {
            p = rest;
        }
    }
    p
}

/// A quotient without common factors of its coefficients, those of the denominator mostly positive.
fn lowest((num, den): &Quotient) -> Quotient {
    let ((n, num), (d, den)) = (num.primitive(), den.primitive());
    let q = BigRational::new(n, d);
    let minus = common_sign(&den) == Some(false);
    let turn = |p: Poly| if minus { p.neg() } else { p };
    (turn(num.scale(q.numer())), turn(den.scale(q.denom())))
}

/// Σ cᵢ·tⁱ as one quotient.
pub(super) fn polynomial(state: &State<'_, '_>, coefficients: &[&Quotient]) -> Option<Quotient> {
    let fuel = &state.scope.fuel;
    let t = Poly::var(state.scope.germ());
    let (mut num, mut den) = (Poly::default(), Poly::one());
    for c in coefficients.iter().rev() {
        // c + t·num/den
        num = c.0.mul(&den, fuel).ok()?.add(&num.mul(&t, fuel).ok()?.mul(&c.1, fuel).ok()?);
        den = den.mul(&c.1, fuel).ok()?;
        (num, den) = cancelled(&num, &den);
    }
    Some(lowest(&(num, den)))
}
