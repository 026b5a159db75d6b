//! Roots of numbers, and roots of what is made of such: the sign of A + B·s with a·s² = c is that of A and B where they
//! agree, and else that of A times that of a·A² − B²·c, which has one root less.
//!
//! Which sign is the true one is read off enclosures; that the others contradict themselves is shown from the innermost
//! root outward. What is within 2⁻¹²⁸ of 0 is tried as 0. No root is left in the end, so that a false sign of up to
//! seven roots is shown to be one, as far as the work for a state reaches.

use kane_algebra::ring::common_sign;
use kane_kernel::{Atom, Fuel, Poly, Power, Sign, State, Term};
use num_bigint::BigInt;
use num_traits::{One as _, Signed as _};

use super::elimination::Factors;
use super::fixed::Enclosure;
use crate::argument::{Argument, Rules as _};

/// Roots below which other ways have shorter proofs.
const FEWEST: usize = 3;
/// Roots above which nothing is tried.
const ROOTS: usize = 7;
/// Terms of a polynomial on the way.
const TERMS: usize = 200;
/// Powers of one root in a polynomial that is looked at.
const DEGREE: u32 = 64;
/// What a look at the value of a term costs, and of each root in it, in coefficient operations.
const LOOK: u64 = 20;
/// Coefficient operations that one state may take.
const WORK: u64 = 4_000_000;

/// A variable s with a·s² = c, a > 0, and s ≥ 0.
pub(super) struct Radical {
    pub(super) s: usize,
    /// the atom that says a·s² = c, or the opposite
    equation: usize,
    /// ±1: the equation's polynomial times it is a·s² − c
    turn: i32,
    pub(super) a: BigInt,
    pub(super) c: Poly,
    /// the atom that says s ≥ 0
    order: usize,
    pub(super) value: Enclosure,
}

/// The roots of a state, each made of numbers and of those before it.
pub(super) struct Radicals(pub(super) Vec<Radical>);

impl Radicals {
    /// Those of a state, if there are so many that other ways seldom end.
    pub(super) fn of(state: &State<'_, '_>) -> Option<Self> {
        let mut all = Self(Vec::new());
        while all.0.len() < ROOTS {
            let next = (0..state.atoms.len()).find_map(|i| all.next(state, i));
            let Some(next) = next else { break };
            all.0.push(next);
        }
        (all.0.len() >= FEWEST).then_some(all)
    }

    /// Whether a variable is one of them.
    pub(super) fn has(&self, v: usize) -> bool {
        self.0.iter().any(|r| r.s == v)
    }

    /// The root of which an equation speaks, if it is made of those that are known.
    fn next(&self, state: &State<'_, '_>, equation: usize) -> Option<Radical> {
        let atom = state.atoms.get(equation)?;
        if atom.sign != Sign::Zero || atom.poly.len() > TERMS {
            return None;
        }
        let mut fresh = atom.poly.vars().into_iter().filter(|v| !self.has(*v));
        let (Some(s), None) = (fresh.next(), fresh.next()) else { return None };
        let [constant, linear, square] = &atom.poly.coefficients(s)[..] else { return None };
        let lead = square.as_constant()?;
        let order = state.atoms.iter().position(|a| a.sign.is_order() && a.poly == Poly::var(s))?;
        if !linear.is_empty() {
            return None;
        }
        let (turn, c) =
            if lead.is_positive() { (1, constant.neg()) } else { (-1, constant.clone()) };
        let a = lead.abs();
        let value = self.value(&c)?.root_over(&a)?;
        Some(Radical { s, equation, turn, a, c, order, value })
    }

    /// The value of a polynomial in roots; `None` if it has another variable.
    pub(super) fn value(&self, p: &Poly) -> Option<Enclosure> {
        let root = |v: usize| self.0.iter().find(|r| r.s == v).map(|r| &r.value);
        if !p.vars().into_iter().all(|v| self.has(v)) {
            return None;
        }
        let mut sum = Enclosure::default();
        for (m, c) in p.terms() {
            let mut product = Enclosure::of(c);
            for &(v, n) in m {
                for _ in 0..n {
                    product = product.times(root(v)?);
                }
            }
            sum = sum.plus(&product);
        }
        Some(sum)
    }

    /// The sign that a value seems to have.
    pub(super) fn sign(&self, p: &Poly) -> Option<i8> {
        self.value(p)?.sign()
    }

    /// The same where it is not too much to look at, paid for by what the budget is a part of.
    pub(super) fn seen(&self, p: &Poly, fuel: &Fuel) -> Option<i8> {
        let high = |v: usize| p.degree(v) > DEGREE;
        if p.len() > TERMS || p.vars().into_iter().any(|v| !self.has(v) || high(v)) {
            return None;
        }
        let factors = p.terms().map(|(m, _)| 1 + m.iter().map(|(_, n)| u64::from(*n)).sum::<u64>());
        fuel.spend_beyond(LOOK * factors.sum::<u64>()).ok()?;
        self.sign(p)
    }

    /// Whether all terms of a polynomial have one sign, and one of them is a number.
    fn shows(&self, p: &Poly) -> bool {
        let number = |(m, _): (&[Power], &BigInt)| m.is_empty();
        common_sign(p).is_some() && p.terms().any(number)
    }
}

/// A contradiction of what is said of these roots, if something false is.
pub(super) fn contradiction(state: &State<'_, '_>, radicals: &Radicals) -> Option<Argument> {
    let fuel = state.scope.fuel.within(WORK);
    (0..state.atoms.len()).find_map(|i| {
        let atom = &state.atoms[i];
        if atom.sign.admits(radicals.seen(&atom.poly, &state.scope.fuel)?) {
            return None;
        }
        let proof = refuted(state, radicals, i, &fuel)?;
        state.closes(&proof).is_ok().then_some(proof)
    })
}

/// Why an atom is false, whose sign is not that of its value.
fn refuted(state: &State<'_, '_>, radicals: &Radicals, i: usize, fuel: &Fuel) -> Option<Argument> {
    fuel.spend(1000).ok()?;
    let atom = state.atoms.get(i)?;
    if atom.decided() == Some(false) {
        return Some(Argument::Absurd(i));
    }
    if atom.sign.admits(radicals.sign(&atom.poly)?) {
        return None;
    }
    let (parts, last) = Parts::of(&atom.poly, radicals, fuel)?;
    let refutation =
        Refutation { radicals, fuel, i, last, radical: radicals.0.get(last)?, parts: &parts };
    refutation.after(state, &refutation.facts()?, &Vec::new())
}

/// scale·p = left + Σ cofactorⱼ·(aⱼ·sⱼ² − cⱼ), with no square of a root left.
pub(super) struct Reduced {
    pub(super) scale: BigInt,
    pub(super) left: Poly,
    /// by root
    cofactors: Vec<Poly>,
}

impl Reduced {
    pub(super) fn of(p: &Poly, radicals: &Radicals, fuel: &Fuel) -> Option<Self> {
        let cofactors = vec![Poly::default(); radicals.0.len()];
        let mut out = Self { scale: BigInt::one(), left: p.clone(), cofactors };
        for (j, Radical { s, a, c, .. }) in radicals.0.iter().enumerate().rev() {
            let equation = Poly::power(*s, 2).scale(a).sub(c);
            while out.left.degree(*s) >= 2 {
                let top = out.left.coefficients(*s).pop()?;
                let by = top.mul(&Poly::power(*s, out.left.degree(*s) - 2), fuel).ok()?;
                out.left = out.left.scale(a).sub(&by.mul(&equation, fuel).ok()?);
                if out.left.len() > TERMS {
                    return None;
                }
                out.scale *= a;
                for cofactor in &mut out.cofactors {
                    *cofactor = cofactor.scale(a);
                }
                out.cofactors[j] = out.cofactors[j].add(&by);
            }
        }
        Some(out)
    }
}

/// What decides the sign of p = A + B·s, after reduction.
struct Parts {
    reduced: Reduced,
    a: Poly,
    b: Poly,
    /// N, the reduced a·A² − B²·c
    norm: Reduced,
}

impl Parts {
    fn of(p: &Poly, radicals: &Radicals, fuel: &Fuel) -> Option<(Self, usize)> {
        let reduced = Reduced::of(p, radicals, fuel)?;
        // a number, where no root is left
        let last = radicals.0.iter().rposition(|r| reduced.left.degree(r.s) > 0).unwrap_or(0);
        let radical = radicals.0.get(last)?;
        let [a, b] = [0, 1].map(|n| reduced.left.coefficient(radical.s, n));
        let square = |p: &Poly| p.mul(p, fuel).ok();
        let norm = square(&a)?.scale(&radical.a).sub(&square(&b)?.mul(&radical.c, fuel).ok()?);
        let norm = Reduced::of(&norm, radicals, fuel)?;
        Some((Self { reduced, a, b, norm }, last))
    }
}

/// Something whose sign is told: a primitive polynomial, and its true sign.
struct Fact {
    poly: Poly,
    sign: i8,
}

/// Facts that a state tells, and the atoms that do.
type Told = Vec<(Poly, usize)>;

/// What refutes one atom.
struct Refutation<'a> {
    radicals: &'a Radicals,
    fuel: &'a Fuel,
    /// the atom
    i: usize,
    /// the place of the last root in it
    last: usize,
    radical: &'a Radical,
    parts: &'a Parts,
}

/// A sum of weights times conditions.
type Products = Vec<(BigInt, Factors)>;

/// Σ terms + turn·p·factor + Σ cofactors·equations = 0, where p is the atom's polynomial, and factor = Σ products.
struct Sum {
    terms: Products,
    turn: i8,
    factor: Poly,
    products: Products,
    cofactors: Vec<(usize, Poly)>,
}

impl Refutation<'_> {
    fn sign(&self, p: &Poly) -> Option<i8> {
        if p.is_empty() { Some(0) } else { self.radicals.sign(p) }
    }

    /// What has to be told, the innermost first.
    fn facts(&self) -> Option<Vec<Fact>> {
        let Parts { a, b, norm, .. } = self.parts;
        let (alpha, beta) = (self.sign(a)?, self.sign(b)?);
        let s = Poly::var(self.radical.s);
        let mut told = vec![a, b];
        if alpha == 0 && beta != 0 {
            told.extend([&self.radical.c, &s]);
        } else if alpha * beta < 0 {
            told.push(&norm.left);
        }
        let fact = |p: &Poly| {
            let poly = p.primitive().1;
            Some(Fact { sign: self.sign(&poly)?, poly })
        };
        told.into_iter().filter(|p| !p.is_constant() && !self.radicals.shows(p)).map(fact).collect()
    }

    /// The argument, with one split for each fact that is left.
    fn after(&self, state: &State<'_, '_>, facts: &[Fact], told: &Told) -> Option<Argument> {
        let Some((fact, others)) = facts.split_first() else {
            return self.sum(told)?.argument(state, self.i, self.fuel);
        };
        let fresh = state.atoms.len();
        let branch = |sign: i8| {
            let poly = if sign < 0 { fact.poly.neg() } else { fact.poly.clone() };
            let next = Atom::new(poly, if sign == 0 { Sign::Zero } else { Sign::Positive });
            let next = state.with(next);
            if sign == fact.sign {
                let told = [&told[..], &[(fact.poly.clone(), fresh)]].concat();
                self.after(&next, others, &told)
            } else if fact.poly == Poly::var(self.radical.s) {
                self.another_root(fresh, sign, told)
            } else {
                refuted(&next, self.radicals, fresh, self.fuel)
            }
            .map(Box::new)
        };
        let (zero, positive, negative) = (branch(0)?, branch(1)?, branch(-1)?);
        Some(Argument::Split { poly: fact.poly.clone(), zero, positive, negative })
    }

    /// Why the root has not this sign, which an atom says, where that of its radicand is told.
    fn another_root(&self, atom: usize, sign: i8, told: &Told) -> Option<Argument> {
        let Radical { s, order, a, c, .. } = self.radical;
        let one = BigInt::one;
        let (terms, cofactors) = match sign {
            // s + (−s) = 0
            -1 => (vec![(one(), vec![(*order, 1)]), (one(), vec![(atom, 1)])], Vec::new()),
            // c − a·s·s + (a·s² − c) = 0
            0 => {
                let by = (atom, Poly::var(*s).scale(&-a));
                (self.magnitude(c, told)?, vec![by, self.equation(self.last, &Poly::one())?])
            }
            // a·s² − c − (a·s² − c) = 0
            _ => {
                let minus = Poly::one().neg();
                let mut cofactors = vanishing(c, &minus, told)?;
                cofactors.push(self.equation(self.last, &minus)?);
                (vec![(a.clone(), vec![(atom, 2)])], cofactors)
            }
        };
        Some(Argument::Positive { terms: terms.into_iter().map(term).collect(), cofactors })
    }

    /// A cofactor of a·s² − c, for the equation that says that it is 0.
    fn equation(&self, root: usize, cofactor: &Poly) -> Option<(usize, Poly)> {
        let radical = self.radicals.0.get(root)?;
        Some((radical.equation, cofactor.scale(&radical.turn.into())))
    }

    /// Cofactors of the equations of all roots, each times a polynomial.
    fn equations(&self, cofactors: &[Poly], times: &Poly) -> Option<Vec<(usize, Poly)>> {
        let one = |(root, cofactor): (usize, &Poly)| {
            self.equation(root, &cofactor.mul(times, self.fuel).ok()?)
        };
        cofactors.iter().enumerate().map(one).collect()
    }

    /// |p| as a sum of products of conditions, one of them positive.
    fn magnitude(&self, p: &Poly, told: &Told) -> Option<Products> {
        if !p.is_constant() && !self.radicals.shows(p) {
            let (content, poly) = p.primitive();
            let (_, atom) = told.iter().find(|(known, _)| *known == poly)?;
            return Some(vec![(content.abs(), vec![(*atom, 1)])]);
        }
        let order = |&(v, n): &Power| {
            let radical = self.radicals.0.iter().find(|r| r.s == v)?;
            Some((radical.order, n))
        };
        let product = |(m, c): (&[Power], &BigInt)| {
            Some((c.abs(), m.iter().map(order).collect::<Option<_>>()?))
        };
        p.terms().map(product).collect()
    }

    /// The sum that is 0 once all is told.
    fn sum(&self, told: &Told) -> Option<Sum> {
        let Parts { reduced, a, b, norm } = self.parts;
        let (alpha, beta, fuel) = (self.sign(a)?, self.sign(b)?, self.fuel);
        let number = |sign: i8| Poly::constant(i32::from(sign).into());
        let s = Poly::var(self.radical.s);
        let times_root = |products: Products, root: usize| -> Products {
            let more = |(w, factors): (BigInt, Factors)| (w, [&factors[..], &[(root, 1)]].concat());
            products.into_iter().map(more).collect()
        };
        if alpha * beta < 0 {
            // k·a·scale·p·(A − B·s) = N + Σ …
            let nu = self.sign(&norm.left)?;
            let conjugate = a.sub(&b.mul(&s, fuel).ok()?);
            let weight = &norm.scale * &self.radical.a;
            let second = times_root(self.magnitude(b, told)?, self.radical.order);
            let both = [self.magnitude(a, told)?, second].concat();
            let weighted = &reduced.scale * &weight;
            let products = both.into_iter().map(|(w, f)| (w * &weighted, f)).collect();
            let factor = conjugate.scale(&(&weighted * i32::from(alpha)));
            let (terms, turn, mut cofactors) = if nu == 0 {
                (Vec::new(), 1, vanishing(&norm.left, &number(-alpha), told)?)
            } else {
                (self.magnitude(&norm.left, told)?, -alpha * nu, Vec::new())
            };
            let turned = number(-alpha * turn);
            let by = conjugate.scale(&weight).mul(&turned, fuel).ok()?;
            cofactors.extend(self.equations(&reduced.cofactors, &by)?);
            cofactors.extend(self.equations(&norm.cofactors, &turned)?);
            let square = b.mul(b, fuel).ok()?.scale(&norm.scale).mul(&turned, fuel).ok()?;
            cofactors.push(self.equation(self.last, &square.neg())?);
            return Some(Sum { terms, turn, factor, products, cofactors });
        }
        // scale·p = A + B·s + Σ …
        let zero_root = told.iter().find(|(p, _)| *p == s).filter(|_| self.sign(&s) == Some(0));
        let sign = match if alpha != 0 { alpha } else { beta } {
            sign if sign != 0 && zero_root.is_none() => sign,
            _ => -1,
        };
        let (mut terms, mut cofactors) = (Vec::new(), Vec::new());
        if alpha == 0 {
            cofactors.extend(vanishing(a, &number(sign), told)?);
        } else {
            terms.extend(self.magnitude(a, told)?);
        }
        match zero_root {
            Some((_, atom)) => cofactors.push((*atom, b.mul(&number(sign), fuel).ok()?)),
            None if beta == 0 => {
                cofactors.extend(vanishing(b, &s.mul(&number(sign), fuel).ok()?, told)?);
            }
            None => {
                let positive = told.iter().find(|(p, _)| *p == s).map(|(_, atom)| *atom);
                let root = positive.unwrap_or(self.radical.order);
                terms.extend(times_root(self.magnitude(b, told)?, root));
            }
        }
        cofactors.extend(self.equations(&reduced.cofactors, &number(sign))?);
        let scale = reduced.scale.clone();
        let (factor, products) = (Poly::constant(scale.clone()), vec![(scale, Vec::new())]);
        Some(Sum { terms, turn: -sign, factor, products, cofactors })
    }
}

impl Sum {
    /// The sum as an argument, by what the atom says of its polynomial.
    fn argument(self, state: &State<'_, '_>, i: usize, fuel: &Fuel) -> Option<Argument> {
        let Self { mut terms, turn, factor, products, mut cofactors } = self;
        let atom = state.atoms.get(i)?;
        let times = |power: u32| {
            let product = move |(weight, factors): (BigInt, Factors)| {
                (weight, [&[(i, power)], &factors[..]].concat())
            };
            products.into_iter().map(product)
        };
        match atom.sign {
            Sign::Zero => cofactors.push((i, factor.scale(&i32::from(turn).into()))),
            Sign::Positive | Sign::NonNegative if turn > 0 => terms.extend(times(1)),
            Sign::NonZero if turn > 0 && terms.is_empty() => {
                terms.extend(times(2));
                for (_, cofactor) in &mut cofactors {
                    *cofactor = cofactor.mul(&atom.poly, fuel).ok()?;
                }
            }
            _ => return None,
        }
        cofactors.retain(|(_, cofactor)| !cofactor.is_empty());
        Some(Argument::Positive { terms: terms.into_iter().map(term).collect(), cofactors })
    }
}

fn term((weight, mut factors): (BigInt, Factors)) -> Term {
    factors.sort_unstable();
    Term { weight, square: Poly::one(), factors }
}

/// cofactor·p, where p is told to be 0, as a multiple of the equation that says so.
fn vanishing(p: &Poly, cofactor: &Poly, told: &Told) -> Option<Vec<(usize, Poly)>> {
    if p.is_empty() {
        return Some(Vec::new());
    }
    let (content, poly) = p.primitive();
    let (_, atom) = told.iter().find(|(known, _)| *known == poly)?;
    Some(vec![(*atom, cofactor.scale(&content))])
}
