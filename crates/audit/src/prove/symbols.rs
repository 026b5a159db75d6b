//! Fractions in constants and roots of constants, as coefficients of series.

use std::cell::RefCell;

use kane_algebra::factors::factors;
use kane_algebra::ring::{cancelled, common_sign};
use kane_kernel::{Atom, Expr, Fraction, Piece, Poly, Sign, State, exponent};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed as _;

use super::change::Change;
use super::factors::square_root;
use super::series::Numbers;
use super::variation;

/// Estimates of roots are multiples of one part in so many.
const ESTIMATE: u32 = 1000;
/// Roots that the scope does not have are variables from here on.
const ADJOINED: usize = 1 << 19;
/// Terms of a numerator or a denominator.
const TERMS: usize = 60;

/// On which side of a root its estimate lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rough {
    Above,
    Below,
}

/// num/den
pub(super) type Quotient = (Poly, Poly);

/// Such fractions at the end of a limit along a variable.
pub(super) struct Symbols<'a, 's, 'g> {
    state: &'a State<'s, 'g>,
    x: usize,
    /// what of these symbols stands for another than in the statement
    pub(super) change: Change,
    /// what is known without cases
    known: Vec<Atom>,
    /// roots and their radicands, which are quotients of constants and earlier roots
    roots: Vec<(usize, Quotient)>,
    /// numbers of which roots were asked that the scope does not have
    missing: RefCell<Vec<BigRational>>,
    /// positive quotients of which roots were asked that there are not
    asked: RefCell<Vec<Quotient>>,
    /// polynomials of which a sign was asked that is not known
    open: RefCell<Vec<Poly>>,
    /// what stands for a root that the scope does not have
    estimates: Option<Rough>,
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
        let change = Change::new(state, &plain.atoms, x).unwrap_or_default();
        let inward =
            |a: &Atom| Some(Atom::new(change.inward(state, &a.poly)?.primitive().1, a.sign));
        let known = plain.atoms.iter().filter_map(inward).collect();
        let (missing, asked, open) = Default::default();
        let roots = Vec::new();
        let mut out =
            Self { state, x, change, known, roots, missing, asked, open, estimates: None };
        for v in variation::roots(state.scope) {
            let radicand = out.radicand(v);
            out.roots.extend(radicand.map(|radicand| (v, radicand)));
        }
        out
    }

    /// Where these numbers are.
    pub(super) fn state(&self) -> &'a State<'s, 'g> {
        self.state
    }

    /// What a root is the root of, if there are constants and earlier roots alone in it.
    fn radicand(&self, root: usize) -> Option<Quotient> {
        let Expr::Sqrt(radicand) = self.state.scope.root(root)? else { return None };
        // of its pieces those that what is known does not exclude
        let may_hold = |a: &Atom| {
            let sign = self.change.inward(self.state, &a.poly).and_then(|p| self.asked_sign(&p));
            let wrong = if a.sign == Sign::Zero { sign.is_some() } else { sign == Some(false) };
            !wrong
        };
        let pieces = self.state.scope.pieces(radicand).ok()?;
        let left = pieces.into_iter().filter(|piece| piece.atoms.iter().all(may_hold));
        let mut values = left.filter_map(|piece| piece.value);
        let Fraction { num, den } = values.next().filter(|_| values.next().is_none())?;
        let known = |v: &usize| {
            self.state.is_constant(*v, self.x) || self.roots.iter().any(|(root, _)| root == v)
        };
        let all_known = num.vars().iter().chain(&den.vars()).all(known);
        let inward = |p: &Poly| self.change.inward(self.state, p);
        if all_known { inward(&num).zip(inward(&den)) } else { None }
    }

    /// A quotient in the symbols of the statement.
    pub(super) fn outward(&self, (num, den): &Quotient) -> Option<Quotient> {
        let outward = |p| self.change.outward(self.state, p);
        outward(num).zip(outward(den))
    }

    /// A polynomial in constants whose sign would tell one that was asked for and is not known: the first of these, or one
    /// of its factors, or a variable of a sum of squares.
    pub(super) fn undetermined(&self) -> Option<Poly> {
        let is_constant =
            |p: &&Poly| p.vars().into_iter().all(|v| self.state.is_constant(v, self.x));
        let either = |p: &Poly| {
            let factors = factors(p).1.into_iter().map(|(factor, _)| factor);
            let open = factors.into_iter().find(|f| !f.is_constant() && self.sign(f).is_none())?;
            let plain = |(v, n): &(usize, u32)| n % 2 == 0 || self.is_signed(*v);
            let is_sum =
                common_sign(&open).is_some() && open.terms().all(|(m, _)| m.iter().all(plain));
            let first = open.vars().into_iter().find(|v| !self.is_strict(*v));
            Some(first.filter(|_| is_sum).map_or(open, Poly::var))
        };
        let open = self.open.borrow();
        let found = open.iter().filter(is_constant).find_map(either)?;
        self.change.outward(self.state, &found)
    }

    /// A factor of a number, or a constant in it, that may have either sign.
    pub(super) fn unsigned(&self, (num, den): &Quotient) -> Option<Poly> {
        let is_constant = |v: &usize| self.state.is_constant(*v, self.x);
        let factors = factors(num).1.into_iter().map(|(factor, _)| factor);
        let of_constants = |f: &Poly| {
            !f.is_constant() && f.vars().iter().all(is_constant) && self.sign(f).is_none()
        };
        let vars = num.vars().into_iter().chain(den.vars());
        let mut open = vars.into_iter().filter(|v| is_constant(v) && !self.is_signed(*v));
        let found =
            factors.into_iter().find(of_constants).or_else(|| open.next().map(Poly::var))?;
        self.change.outward(self.state, &found)
    }

    /// The sign of what is not zero, remembered where it is not known.
    fn asked_sign(&self, p: &Poly) -> Option<bool> {
        let sign = self.sign(p).or_else(|| self.sign_of_factors(p));
        if sign.is_none() {
            self.open.borrow_mut().push(p.clone());
        }
        sign
    }

    /// The sign of a product, of whose factors those with odd powers have known signs and none vanishes.
    fn sign_of_factors(&self, p: &Poly) -> Option<bool> {
        let (content, factors) = factors(p);
        let is_positive = content.is_positive();
        factors.into_iter().filter(|(f, _)| !f.is_constant()).try_fold(
            is_positive,
            |sign, (f, n)| {
                let own = self.sign(&f)?;
                Some(sign == (own || n % 2 == 0))
            },
        )
    }

    /// From now on estimates stand for roots that the scope does not have. They serve for slopes; a limit that is one is
    /// not found.
    pub(super) fn estimate_roots(&mut self, rough: Rough) {
        self.estimates = Some(rough);
    }

    /// From now on the first root that was asked for is a number, too, of which the scope knows nothing; false if there
    /// was none.
    pub(super) fn adjoin(&mut self) -> bool {
        let asked = self.asked.take();
        let root = ADJOINED + self.roots.len();
        self.roots.extend(asked.into_iter().take(1).map(|q| (root, q)));
        self.roots.iter().any(|known| known.0 == root)
    }

    /// Whether a number has no root in it that the scope does not have.
    pub(super) fn is_known(&self, (num, den): &Quotient) -> bool {
        !num.vars().into_iter().chain(den.vars()).any(|v| v >= ADJOINED)
    }

    /// A sum of positive terms with something above each root in its place that the scope does not have.
    pub(super) fn above_adjoined(&self, (num, den): &Quotient) -> Option<Quotient> {
        self.beside_roots((num.clone(), den.clone()), |v| v >= ADJOINED, Rough::Above)
    }

    /// Whether estimates stand for roots.
    pub(super) fn estimates(&self) -> bool {
        self.estimates.is_some()
    }

    /// Numbers below and above the root of a positive one: q/(1 + q) and 1 + q, or three digits of a rational one.
    pub(super) fn around_root(&self, (num, den): &Quotient) -> Option<(Quotient, Quotient)> {
        if let (Some(num), Some(den)) = (num.as_constant(), den.as_constant()) {
            let digits = BigInt::from(ESTIMATE);
            let root = (num * &den * &digits * &digits).sqrt();
            let of = |root: BigInt| self.number(&BigRational::new(root, &den * &digits));
            return Some((of(root.clone()), of(root + 1)));
        }
        let is_positive = self.sign(den)?;
        let (num, den) =
            if is_positive { (num.clone(), den.clone()) } else { (num.neg(), den.neg()) };
        let sum = num.add(&den);
        Some(((num, sum.clone()), (sum, den)))
    }

    /// A number with something below each root in its place, where all of its terms have one sign.
    pub(super) fn below_roots(&self, a: &Quotient) -> Option<Quotient> {
        common_sign(&a.0)?;
        self.beside_roots(a.clone(), |_| true, Rough::Below)
    }

    /// A quotient with something on one side of these roots in their place in the numerator.
    fn beside_roots(
        &self,
        (mut num, mut den): Quotient,
        of: impl Fn(usize) -> bool,
        rough: Rough,
    ) -> Option<Quotient> {
        for (root, q) in self.roots.iter().rev().filter(|root| of(root.0)) {
            let (below, above) = self.around_root(q)?;
            let beside = if rough == Rough::Above { above } else { below };
            let mut sum = (Poly::default(), Poly::one());
            for n in 0..=num.degree(*root) {
                let mut term = (num.coefficient(*root, n), Poly::one());
                for _ in 0..n {
                    term = self.product(&term, &beside)?;
                }
                sum = self.sum(&sum, &term)?;
            }
            num = sum.0;
            den = den.mul(&sum.1, &self.state.scope.fuel).ok()?;
        }
        Some((num, den))
    }

    /// The numbers without whose roots there is no answer.
    pub(super) fn missing(&self) -> Vec<BigRational> {
        self.missing.take()
    }

    fn reduced(&self, num: &Poly, den: &Poly) -> Option<Quotient> {
        let (num, den) = self.without_squares(num.clone(), den.clone())?;
        let reduced = |p| self.change.reduced(self.state, p);
        let (num, den) = reduced(num).zip(reduced(den))?;
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

    /// Something plainly positive that is at least as large as a number of either sign: its terms without their signs, and
    /// 1 + u² for what may have either sign; 1 for zero.
    pub(super) fn majorant(&self, (num, den): &Quotient) -> Option<Quotient> {
        if num.is_empty() {
            return Some((Poly::one(), Poly::one()));
        }
        let mut out = Poly::default();
        for (m, c) in num.terms() {
            let either = |&&(v, n): &&(usize, u32)| n % 2 == 1 && !self.is_signed(v);
            let unsigned: Vec<_> = m.iter().filter(either).map(|&(v, _)| (v, 1)).collect();
            let less = |&(v, n): &(usize, u32)| (v, n - exponent(&unsigned, v));
            let size = Poly::term(m.iter().map(less).collect(), c.abs());
            out = out.add(&size);
            if !unsigned.is_empty() {
                let squared = unsigned.iter().map(|&(v, _)| (v, 2)).collect();
                let squared = Poly::term(squared, BigInt::from(1));
                out = out.add(&size.mul(&squared, &self.state.scope.fuel).ok()?);
            }
        }
        let den = if self.sign(den)? { den.clone() } else { den.neg() };
        // b² alone may vanish
        if self.sign(&out).is_none() {
            out = out.add(&den);
        }
        Some((out, den))
    }

    fn is_signed(&self, v: usize) -> bool {
        let known = |sign| self.known.contains(&Atom::new(Poly::var(v), sign));
        let is_root = self.roots.iter().any(|root| root.0 == v);
        is_root || known(Sign::Positive) || known(Sign::NonNegative)
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
        let value = self.change.inward(self.state, &Poly::var(v)).map(|p| (p, Poly::one()));
        value.filter(|_| self.state.is_constant(v, self.x))
    }

    fn variable(&self, v: usize) -> Option<Quotient> {
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
        let (mut num, mut den) = a.clone();
        for (root, _) in self.roots.iter().rev() {
            let [rest, part] = [0, 1].map(|n| num.coefficient(*root, n));
            if !part.is_empty() {
                let conjugate = rest.sub(&part.mul(&Poly::var(*root), fuel).ok()?);
                let product = num.mul(&conjugate, fuel).ok()?;
                (num, den) = self.reduced(&product, &den.mul(&conjugate, fuel).ok()?)?;
            }
        }
        // where it may be 0 its sign is one to be told apart
        self.asked_sign(&num);
        (!num.is_empty()).then_some((den, num))
    }

    /// √(N/D²) = S·√R/(R·D) with N·R = S², where R is 1, the radicand of a root, or a product of two.
    fn root(&self, a: &Quotient) -> Option<Quotient> {
        let fuel = &self.state.scope.fuel;
        let square = a.0.mul(&a.1, fuel).ok()?;
        let absolute = |p: Poly| {
            let is_positive = self.asked_sign(&p)?;
            Some(if is_positive { p } else { p.neg() })
        };
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
            let is_positive = self.is_positive(a)?;
            if is_positive {
                self.asked.borrow_mut().push(a.clone());
            }
            let rough = self.estimates?;
            let (below, above) = is_positive.then(|| self.around_root(a))??;
            Some(if rough == Rough::Above { above } else { below })
        })
    }

    fn is_zero(&self, a: &Quotient) -> bool {
        a.0.is_empty()
    }

    fn is_positive(&self, a: &Quotient) -> Option<bool> {
        let is_positive = self.asked_sign(&a.0)? == self.asked_sign(&a.1)?;
        Some(is_positive)
    }
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
