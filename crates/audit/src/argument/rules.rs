//! The rules of arguments: what each step leaves of a state, or why it does not apply.

use kane_algebra::descartes::descartes;
use kane_kernel::{Atom, Fuel, Poly, Proof, Rejection, Root, Sign, State, sign, sign_at};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::{Argument, Bounds, Factored};

/// Why a step does not apply.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Flaw {
    /// what the kernel says
    Kernel(Rejection),
    /// the atom with this index is no false constant
    NotAbsurd(usize),
    /// the atom with this index is no bound of the variable
    NotABound(usize),
    /// the coefficients do not have the sign that contradicts the atom
    WrongSign,
    /// on some cell of the line all atoms hold
    OpenCell,
}

impl From<Rejection> for Flaw {
    fn from(why: Rejection) -> Self {
        Self::Kernel(why)
    }
}

/// What a step leaves.
pub(crate) type Step<T = ()> = Result<T, Flaw>;

/// The steps of arguments on the kernel's states.
pub(crate) trait Rules: Sized {
    /// Checks that an argument closes this state.
    fn closes(&self, argument: &Argument) -> Step;
    /// Reduces all other atoms by an equation, as polynomials in a variable; one that is linear in
    /// it eliminates it, and goes.
    fn substitute(&self, equation: usize, var: usize, lead: &[(usize, u32)]) -> Step<Self>;
    /// Divides an atom by factors that do not vanish.
    fn cancel(&self, atom: usize, factors: &[(usize, u32)], quotient: &Poly) -> Step<Self>;
}

impl Rules for State<'_, '_> {
    fn closes(&self, argument: &Argument) -> Step {
        self.scope.fuel.spend(1)?;
        match argument {
            Argument::Absurd(i) => {
                let absurd = atom(self, *i)?.decided() == Some(false);
                absurd.then_some(()).ok_or(Flaw::NotAbsurd(*i))
            }
            Argument::Assume { formula, cases } => {
                let states = self.assume(*formula)?;
                if states.len() != cases.len() {
                    return Err(Rejection::CaseCount(states.len(), cases.len()).into());
                }
                states.iter().zip(cases).try_for_each(|(s, a)| s.closes(a))
            }
            Argument::Split { poly, zero, positive, negative } => {
                let with = |sign, p: Poly| self.with(Atom::new(p, sign));
                with(Sign::Zero, poly.clone()).closes(zero)?;
                with(Sign::Positive, poly.clone()).closes(positive)?;
                with(Sign::Positive, poly.neg()).closes(negative)
            }
            Argument::Substitute { equation, var, lead, then } => {
                self.substitute(*equation, *var, lead)?.closes(then)
            }
            Argument::Cancel { atom, factors, quotient, then } => {
                self.cancel(*atom, factors, quotient)?.closes(then)
            }
            Argument::Positive { terms, cofactors } => {
                let (terms, cofactors) = (terms.clone(), cofactors.clone());
                Ok(self.refute(&Proof::Positive { terms, cofactors })?)
            }
            Argument::Orthant { atom, bounds } => orthant(self, *atom, bounds),
            Argument::SignTable { var, bases, roots, atoms } => {
                sign_table(self, *var, bases, roots, atoms)
            }
        }
    }

    fn substitute(&self, equation: usize, var: usize, lead: &[(usize, u32)]) -> Step<Self> {
        let eq = atom(self, equation)?;
        let degree = eq.poly.degree(var);
        if eq.sign != Sign::Zero || degree == 0 {
            return Err(Rejection::NotAnEquation(equation).into());
        }
        // The sign of the leading coefficient decides whether odd powers of it may stand below an
        // inequality.
        let nonzero = |sign, _| matches!(sign, Sign::Positive | Sign::NonZero);
        let want = product(self, lead, nonzero)?.primitive().1;
        let have = eq.poly.coefficient(var, degree).primitive().1;
        let flip = have == want.neg();
        if !(flip || have == want) {
            return Err(Rejection::MayVanish.into());
        }
        let even = |&(i, n): &(usize, u32)| n % 2 == 0 || self.atoms[i].sign == Sign::Positive;
        let positive = lead.iter().all(even);
        let rule = if flip { eq.poly.neg() } else { eq.poly.clone() };
        let mut next = self.clone();
        for (i, atom) in next.atoms.iter_mut().enumerate() {
            if i == equation {
                continue;
            }
            let even = atom.sign.is_order() && !positive;
            let rest = atom.poly.remainder(var, &rule, even, &self.scope.fuel)?;
            *atom = Atom::new(rest.primitive().1, atom.sign);
        }
        if degree == 1 {
            next.atoms[equation].poly = Poly::default();
        }
        Ok(next)
    }

    fn cancel(&self, atom: usize, factors: &[(usize, u32)], quotient: &Poly) -> Step<Self> {
        let old = self::atom(self, atom)?;
        if factors.iter().any(|f| f.0 == atom) {
            return Err(Rejection::MayVanish.into());
        }
        let allowed = |sign, even| match sign {
            Sign::Positive => true,
            Sign::NonZero => even || !old.sign.is_order(),
            Sign::Zero | Sign::NonNegative => false,
        };
        let product = product(self, factors, allowed)?.mul(quotient, &self.scope.fuel)?;
        // Equal up to a positive rational factor.
        if product.primitive().1 != old.poly.primitive().1 {
            return Err(Rejection::NotAnIdentity.into());
        }
        let mut next = self.clone();
        next.atoms[atom].poly = quotient.clone();
        Ok(next)
    }
}

fn atom<'a>(state: &'a State<'_, '_>, i: usize) -> Step<&'a Atom> {
    state.atoms.get(i).ok_or(Flaw::Kernel(Rejection::NoSuchAtom(i)))
}

/// Product of powers of atoms whose sign, with an even power or not, is allowed.
fn product(
    state: &State<'_, '_>,
    factors: &[(usize, u32)],
    allowed: impl Fn(Sign, bool) -> bool,
) -> Step<Poly> {
    let mut product = Poly::one();
    for &(i, n) in factors {
        let atom = atom(state, i)?;
        if !allowed(atom.sign, n % 2 == 0) {
            return Err(Rejection::MayVanish.into());
        }
        let power = atom.poly.pow(n, &state.scope.fuel)?;
        product = product.mul(&power, &state.scope.fuel)?;
    }
    Ok(product)
}

fn orthant(state: &State<'_, '_>, atom: usize, bounds: &[Bounds]) -> Step {
    let fuel = &state.scope.fuel;
    let target = self::atom(state, atom)?;
    let mut p = target.poly.clone();
    // For each variable: its degree, and which ends of [0, ∞] belong to the region.
    let mut ends = Vec::new();
    for (i, &(v, lower, upper)) in bounds.iter().enumerate() {
        if bounds[..i].iter().any(|b| b.0 == v) {
            return Err(Flaw::NotABound(atom));
        }
        let lower = lower.map(|i| bound(state, i, v, 1)).transpose()?;
        let upper = upper.map(|i| bound(state, i, v, -1)).transpose()?;
        let degree = p.degree(v);
        // v = (a + b·y)/den with y ≥ 0 and den > 0.
        let line = |a: BigInt, b: BigInt| Poly::in_variable(v, &[a, b]);
        let (num, den) = match (lower, upper) {
            (Some((l, open)), None) => {
                ends.push((v, degree, !open, false));
                (line(l.numer().clone(), l.denom().clone()), Poly::constant(l.denom().clone()))
            }
            (None, Some((u, open))) => {
                ends.push((v, degree, !open, false));
                (line(u.numer().clone(), -u.denom()), Poly::constant(u.denom().clone()))
            }
            (Some((l, open_l)), Some((u, open_u))) => {
                ends.push((v, degree, !open_l, !open_u));
                let scale = l.denom() * u.denom();
                let num = line(l.numer() * u.denom(), u.numer() * l.denom());
                (num, line(scale.clone(), scale))
            }
            (None, None) => return Err(Flaw::NotABound(atom)),
        };
        p = composed(&p, v, &num, &den, fuel)?;
    }
    if p.vars().iter().any(|v| !bounds.iter().any(|b| b.0 == *v)) {
        return Err(Flaw::NotABound(atom));
    }
    let side = |positive: bool| p.terms().all(|(_, c)| c.is_positive() == positive);
    let contradicts = match target.sign {
        Sign::Positive => side(false),
        Sign::NonNegative => side(false) && survives(&p, &ends, fuel)?,
        Sign::Zero => (side(false) || side(true)) && survives(&p, &ends, fuel)?,
        Sign::NonZero => p.is_empty(),
    };
    contradicts.then_some(()).ok_or(Flaw::WrongSign)
}

/// Reads atom i as a lower (side 1) or upper (side −1) bound of v: its value, and if it is open.
fn bound(state: &State<'_, '_>, i: usize, v: usize, side: i8) -> Step<(BigRational, bool)> {
    let atom = atom(state, i)?;
    match super::bound(atom, v) {
        Some((value, k)) if sign(k) == side => Ok((value, atom.sign == Sign::Positive)),
        _ => Err(Flaw::NotABound(i)),
    }
}

fn sign_table(
    state: &State<'_, '_>,
    var: usize,
    bases: &[Vec<BigInt>],
    roots: &[Root],
    atoms: &[Factored],
) -> Step {
    let fuel = &state.scope.fuel;
    for (i, constant, powers) in atoms {
        let mut product = Poly::constant(constant.numer().clone());
        for (base, n) in bases.iter().zip(powers) {
            let power = Poly::in_variable(var, base).pow(*n, fuel)?;
            product = product.mul(&power, fuel)?;
        }
        // A rational number as it is made has a positive denominator.
        let whole = atom(state, *i)?.poly.scale(constant.denom());
        if !constant.denom().is_positive() || product != whole || powers.len() != bases.len() {
            return Err(Rejection::NotAnIdentity.into());
        }
    }
    for signs in cells(bases, roots, fuel)? {
        let admitted = |(i, constant, powers): &Factored| {
            let power = |(s, n): (&i8, &u32)| match n {
                0 => 1,
                n if n % 2 == 0 => s * s,
                _ => *s,
            };
            let factors: i8 = signs.iter().zip(powers).map(power).product();
            state.atoms[*i].sign.admits(sign(constant.numer()) * factors)
        };
        if atoms.iter().all(admitted) {
            return Err(Flaw::OpenCell);
        }
    }
    Ok(())
}

/// Whether some term of a polynomial whose terms have one sign is not zero on each face of the
/// orthant: for each variable its degree there, and whether 0 and ∞ belong to the region.
fn survives(p: &Poly, ends: &[(usize, u32, bool, bool)], fuel: &Fuel) -> Step<bool> {
    fuel.spend(1 + u64::try_from(p.len()).unwrap_or(u64::MAX))?;
    let Some((&(v, degree, low, high), rest)) = ends.split_first() else {
        return Ok(!p.is_empty());
    };
    let face = |n: u32| (0..).zip(p.coefficients(v)).find(|(i, _)| *i == n).unwrap_or_default().1;
    Ok(survives(p, rest, fuel)?
        && (!low || survives(&face(0), rest, fuel)?)
        && (!high || survives(&face(degree), rest, fuel)?))
}

/// The sign vectors of the bases on all cells of the line: gaps and roots, from left to right. An
/// isolating interval has no cells of its own but the root: off it, it continues the gaps.
fn cells(bases: &[Vec<BigInt>], roots: &[Root], fuel: &Fuel) -> Step<Vec<Vec<i8>>> {
    let mut out = Vec::new();
    let mut left: Option<&BigRational> = None;
    for root in roots.iter().map(Some).chain([None]) {
        // The gap between two roots.
        let right = root.map(|r| &r.lo);
        let inside = match (left, right) {
            (Some(a), Some(b)) if a > b => return Err(Rejection::RootCount.into()),
            (Some(a), Some(b)) => (a + b) / BigRational::from_integer(2.into()),
            (Some(a), None) => a + BigRational::one(),
            (None, Some(b)) => b - BigRational::one(),
            (None, None) => BigRational::zero(),
        };
        for p in bases {
            if descartes(p, left, right, fuel)? != 0 {
                return Err(Rejection::RootCount.into());
            }
        }
        out.push(bases.iter().map(|p| sign_at(p, &inside)).collect());
        // The root that follows.
        let Some(root) = root else {
            break;
        };
        let mut signs = Vec::new();
        for p in bases {
            let ends = [sign_at(p, &root.lo), sign_at(p, &root.hi)];
            signs.push(match descartes(p, Some(&root.lo), Some(&root.hi), fuel)? {
                0 if root.is_exact() || !ends.contains(&0) => ends[0],
                1 if *p == root.poly && !ends.contains(&0) => 0,
                _ => return Err(Rejection::RootCount.into()),
            });
        }
        out.push(signs);
        left = Some(&root.hi);
    }
    Ok(out)
}

/// denⁿ·p(num/den) for v, with n the degree of p in v.
pub(crate) fn composed(p: &Poly, v: usize, num: &Poly, den: &Poly, fuel: &Fuel) -> Step<Poly> {
    // a bound at 0 moves nothing
    if *den == Poly::one() && *num == Poly::power(v, 1) {
        return Ok(p.clone());
    }
    let (mut sum, mut power) = (Poly::default(), Poly::one());
    for c in p.coefficients(v).iter().rev() {
        sum = sum.mul(num, fuel)?.add(&c.mul(&power, fuel)?);
        power = power.mul(den, fuel)?;
    }
    Ok(sum)
}
