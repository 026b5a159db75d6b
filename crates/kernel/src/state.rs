//! The rules: a state is a conjunction of atoms, and a proof shows that no point satisfies it.

use std::collections::BTreeSet;
use std::rc::Rc;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::limit::{Place, inside_goal, inside_state, owed, premises, sides, start};
use crate::{
    Atom, Atoms, Cases, Checked, Conclusion, Expr, Fuel, Germ, Goal, Link, Poly, Proof, Rejection,
    Root, Scope, Side, Sign, Term, descartes, scope, sign, sign_at,
};

/// What is known at a point: atoms, and formulas of which one case each holds there.
#[derive(Clone, Debug)]
pub struct State<'s, 'g> {
    /// symbols, budget
    pub scope: &'s Scope<'g>,
    /// the goal, whose premises hold along germs too
    pub goal: &'g Goal,
    /// the atoms; positions are stable
    pub atoms: Atoms,
    /// the formulas
    pub formulas: Rc<Vec<Cases>>,
    /// whether it is being refuted that the domain, as the premises narrow it, reaches a limit
    pub reaching: bool,
    /// whether this is a state along a germ: there a premised limit's variable stands for the
    /// function, so nothing may be passed to its limit
    pub on_germ: bool,
}

impl<'s, 'g> State<'s, 'g> {
    /// Checks that a proof closes this state.
    ///
    /// # Errors
    /// [`Rejection`] naming the rule that does not apply.
    pub fn refute(&self, proof: &Proof) -> Checked {
        self.scope.fuel.spend(1)?;
        match proof {
            Proof::Absurd => {
                let absurd = self.atoms.iter().any(|a| a.decided() == Some(false));
                absurd.then_some(()).ok_or(Rejection::NotAbsurd)
            }
            Proof::Assume { formula, cases } => {
                let states = self.assume(*formula)?;
                if states.len() != cases.len() {
                    return Err(Rejection::CaseCount(states.len(), cases.len()));
                }
                states.iter().zip(cases).try_for_each(|(s, p)| s.refute(p))
            }
            Proof::Split { poly, zero, positive, negative } => {
                let with = |sign, p: Poly| self.with(Atom::new(p, sign));
                with(Sign::Zero, poly.clone()).refute(zero)?;
                with(Sign::Positive, poly.clone()).refute(positive)?;
                with(Sign::Positive, poly.neg()).refute(negative)
            }
            Proof::Substitute { equation, var, lead, then } => {
                self.substitute(*equation, *var, lead)?.refute(then)
            }
            Proof::Cancel { atom, factors, quotient, then } => {
                self.cancel(*atom, factors, quotient)?.refute(then)
            }
            Proof::Positive { terms, cofactors } => self.positive(terms, cofactors),
            Proof::Orthant { atom, bounds } => self.orthant(*atom, bounds),
            Proof::SignTable { var, bases, roots, atoms } => {
                self.sign_table(*var, bases, roots, atoms)
            }
            Proof::Pass { .. } if self.on_germ => Err(Rejection::OutsideDomain),
            Proof::Pass { germ, atom, along, then } => {
                self.along(germ)?.with(atom.not()).refute(along)?;
                self.with(self.at_zero(germ, atom)?).refute(then)
            }
        }
    }

    fn atom(&self, i: usize) -> Checked<&Atom> {
        self.atoms.get(i).ok_or(Rejection::NoSuchAtom(i))
    }

    /// This state and one more atom.
    #[must_use]
    pub fn with(&self, atom: Atom) -> Self {
        let mut next = self.clone();
        next.atoms.push(atom);
        next
    }

    /// This state and one more formula.
    #[must_use]
    pub fn with_cases(&self, cases: Cases) -> Self {
        Self { formulas: Rc::new([&self.formulas[..], &[cases]].concat()), ..self.clone() }
    }

    /// One state for each case of a formula.
    ///
    /// # Errors
    /// [`Rejection::NoSuchFormula`].
    pub fn assume(&self, formula: usize) -> Checked<Vec<Self>> {
        let cases = self.formulas.get(formula).ok_or(Rejection::NoSuchFormula(formula))?;
        let next = |case: &Atoms| Self { atoms: [&self.atoms[..], case].concat(), ..self.clone() };
        Ok(cases.iter().map(next).collect())
    }

    /// Reduces all other atoms by an equation, as polynomials in a variable; one that is linear in
    /// it eliminates it, and goes.
    ///
    /// # Errors
    /// [`Rejection`] if it is no such equation or its leading coefficient may vanish.
    pub fn substitute(&self, equation: usize, var: usize, lead: &[(usize, u32)]) -> Checked<Self> {
        let eq = self.atom(equation)?;
        let degree = eq.poly.degree(var);
        if eq.sign != Sign::Zero || degree == 0 {
            return Err(Rejection::NotAnEquation(equation));
        }
        // The sign of the leading coefficient decides whether odd powers of it may stand below an
        // inequality.
        let nonzero = |sign, _| matches!(sign, Sign::Positive | Sign::NonZero);
        let want = self.product(lead, nonzero)?.primitive().1;
        let have = eq.poly.coefficients(var).pop().unwrap_or_default().primitive().1;
        let flip = have == want.neg();
        if !(flip || have == want) {
            return Err(Rejection::MayVanish);
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

    /// Divides an atom by factors that do not vanish.
    ///
    /// # Errors
    /// [`Rejection`] if a factor may vanish or the product does not give back the atom.
    pub fn cancel(&self, atom: usize, factors: &[(usize, u32)], quotient: &Poly) -> Checked<Self> {
        let old = self.atom(atom)?;
        if factors.iter().any(|f| f.0 == atom) {
            return Err(Rejection::MayVanish);
        }
        let allowed = |sign, even| match sign {
            Sign::Positive => true,
            Sign::NonZero => even || !old.sign.is_order(),
            Sign::Zero | Sign::NonNegative => false,
        };
        let product = self.product(factors, allowed)?.mul(quotient, &self.scope.fuel)?;
        // Equal up to a positive rational factor.
        if product.primitive().1 != old.poly.primitive().1 {
            return Err(Rejection::NotAnIdentity);
        }
        let mut next = self.clone();
        next.atoms[atom].poly = quotient.clone();
        Ok(next)
    }

    /// Product of powers of atoms whose sign, with an even power or not, is allowed.
    fn product(
        &self,
        factors: &[(usize, u32)],
        allowed: impl Fn(Sign, bool) -> bool,
    ) -> Checked<Poly> {
        let mut product = Poly::one();
        for &(i, n) in factors {
            let atom = self.atom(i)?;
            if !allowed(atom.sign, n % 2 == 0) {
                return Err(Rejection::MayVanish);
            }
            let power = atom.poly.pow(n, &self.scope.fuel)?;
            product = product.mul(&power, &self.scope.fuel)?;
        }
        Ok(product)
    }

    fn positive(&self, terms: &[Term], cofactors: &[(usize, Poly)]) -> Checked {
        let fuel = &self.scope.fuel;
        let (mut sum, mut strict) = (Poly::default(), false);
        for (i, cofactor) in cofactors {
            let equation = self.atom(*i)?;
            if equation.sign != Sign::Zero {
                return Err(Rejection::NotAnEquation(*i));
            }
            sum = sum.add(&equation.poly.mul(cofactor, fuel)?);
        }
        for t in terms {
            let allowed = |sign: Sign, even| sign.is_order() || (sign == Sign::NonZero && even);
            let known = self.product(&t.factors, allowed)?;
            let square = t.square.mul(&t.square, fuel)?;
            sum = sum.add(&square.mul(&known, fuel)?.scale(&t.weight));
            if !t.weight.is_positive() {
                return Err(Rejection::NotPositive);
            }
            let may_vanish = |f: &(usize, u32)| self.atoms[f.0].sign == Sign::NonNegative;
            let constant = square.as_constant().is_some_and(|c| c.is_positive());
            strict |= constant && !t.factors.iter().any(may_vanish);
        }
        if !sum.is_empty() {
            return Err(Rejection::NotAnIdentity);
        }
        strict.then_some(()).ok_or(Rejection::NotPositive)
    }

    fn orthant(&self, atom: usize, bounds: &[(usize, Option<usize>, Option<usize>)]) -> Checked {
        let fuel = &self.scope.fuel;
        let target = self.atom(atom)?;
        let mut p = target.poly.clone();
        // For each variable: its degree, and which ends of [0, ∞] belong to the region.
        let mut ends = Vec::new();
        for (i, &(v, lower, upper)) in bounds.iter().enumerate() {
            if bounds[..i].iter().any(|b| b.0 == v) {
                return Err(Rejection::NotABound(atom));
            }
            let lower = lower.map(|i| self.bound(i, v, 1)).transpose()?;
            let upper = upper.map(|i| self.bound(i, v, -1)).transpose()?;
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
                (None, None) => return Err(Rejection::NotABound(atom)),
            };
            p = p.compose(v, &num, &den, fuel)?;
        }
        if p.vars().iter().any(|v| !bounds.iter().any(|b| b.0 == *v)) {
            return Err(Rejection::NotABound(atom));
        }
        let side = |positive: bool| p.terms().all(|(_, c)| c.is_positive() == positive);
        let contradicts = match target.sign {
            Sign::Positive => side(false),
            Sign::NonNegative => side(false) && survives(&p, &ends, fuel)?,
            Sign::Zero => (side(false) || side(true)) && survives(&p, &ends, fuel)?,
            Sign::NonZero => p.is_empty(),
        };
        contradicts.then_some(()).ok_or(Rejection::WrongSign)
    }

    /// Reads atom i as a lower (side 1) or upper (side −1) bound of v: its value, and if it is open.
    fn bound(&self, i: usize, v: usize, side: i8) -> Checked<(BigRational, bool)> {
        let atom = self.atom(i)?;
        match (atom.poly.univariate(v).as_deref(), atom.sign.is_order()) {
            (Some([c, k]), true) if sign(k) == side => {
                Ok((BigRational::new(-c, k.clone()), atom.sign == Sign::Positive))
            }
            _ => Err(Rejection::NotABound(i)),
        }
    }

    fn sign_table(
        &self,
        var: usize,
        bases: &[Vec<BigInt>],
        roots: &[Root],
        atoms: &[(usize, BigRational, Vec<u32>)],
    ) -> Checked {
        let fuel = &self.scope.fuel;
        for (i, constant, powers) in atoms {
            let mut product = Poly::constant(constant.numer().clone());
            for (base, n) in bases.iter().zip(powers) {
                let power = Poly::in_variable(var, base).pow(*n, fuel)?;
                product = product.mul(&power, fuel)?;
            }
            // A rational number as it is made has a positive denominator.
            let whole = self.atom(*i)?.poly.scale(constant.denom());
            if !constant.denom().is_positive() || product != whole || powers.len() != bases.len() {
                return Err(Rejection::NotAnIdentity);
            }
        }
        for signs in cells(bases, roots, fuel)? {
            let admitted = |(i, constant, powers): &(usize, BigRational, Vec<u32>)| {
                let power = |(s, n): (&i8, &u32)| match n {
                    0 => 1,
                    n if n % 2 == 0 => s * s,
                    _ => *s,
                };
                let factors: i8 = signs.iter().zip(powers).map(power).product();
                self.atoms[*i].sign.admits(sign(constant.numer()) * factors)
            };
            if atoms.iter().all(admitted) {
                return Err(Rejection::OpenCell);
            }
        }
        Ok(())
    }

    /// Whether a variable keeps its value while x varies.
    #[must_use]
    pub fn is_constant(&self, v: usize, x: usize) -> bool {
        v != x && self.scope.context.vars.get(v).is_some_and(|var| var.of != Some(x))
    }

    /// The state along a germ: what is known of constants, 0 < t < radius, x, and the premises.
    ///
    /// # Errors
    /// [`Rejection`] if the side does not lie in the domain or the radius may not be positive.
    pub fn along(&self, germ: &Germ) -> Checked<Self> {
        let along = self.along_unproved(germ)?;
        let owed = owed(self, &germ.side);
        if owed.len() != germ.inside.len() {
            return Err(Rejection::CaseCount(owed.len(), germ.inside.len()));
        }
        for (given, inside) in owed.into_iter().zip(&germ.inside) {
            let goal = inside_goal(self, &germ.side, given, &inside.values)?;
            let scope = scope(&goal, self.scope.fuel.clone())?;
            inside_state(self, germ, &scope, &goal)?.refute(&inside.proof)?;
        }
        Ok(along)
    }

    /// Whether the state takes for granted that the cited givens let the variable reach the limit
    /// from this side: it is one of the sides of a limit claim whose vacuity is to be shown.
    #[must_use]
    pub fn reaches(&self, side: &Side) -> bool {
        let claimed = match &self.goal.conclusion {
            Conclusion::Link(Link::Limit(l)) if self.reaching => sides(self.scope, l),
            _ => Vec::new(),
        };
        claimed.contains(side)
    }

    /// The state along a germ, without the proof that the germ lies in the range of the givens: for
    /// those who look for that proof.
    ///
    /// # Errors
    /// As [`State::along`].
    pub fn along_unproved(&self, germ: &Germ) -> Checked<Self> {
        let x = germ.side.var;
        let (num, den) = &germ.radius;
        if !germ.side.is_inside(self.scope) {
            return Err(Rejection::OutsideDomain);
        }
        if [num, den].iter().any(|p| p.vars().iter().any(|&v| !self.is_constant(v, x))) {
            return Err(Rejection::NotConstant);
        }
        let positive = |p: &Poly| vec![Atom::new(p.clone(), Sign::Positive).not()];
        self.with_cases(vec![positive(num), positive(den)]).refute(&germ.positive)?;
        let atoms = self.atoms_along(germ, self.scope)?;
        let formulas = Rc::new(premises(self.scope, self.goal, Place::Germ(&germ.side))?);
        Ok(Self { atoms, formulas, on_germ: true, ..self.clone() })
    }

    /// The conditions along a germ of a scope with the same constants: ranges, what is known of
    /// constants here, 0 < t < radius, and x.
    pub(crate) fn atoms_along(&self, germ: &Germ, scope: &Scope<'_>) -> Checked<Atoms> {
        let (x, t, (num, den)) = (germ.side.var, scope.germ(), &germ.radius);
        let mut atoms = scope.ranges();
        if !scope.mentioned.contains(&x) {
            atoms.extend(scope.range(x));
        }
        let constant = |a: &&Atom| a.poly.vars().iter().all(|&v| self.is_constant(v, x));
        atoms.extend(self.atoms.iter().filter(constant).cloned());
        atoms.push(Atom::new(Poly::var(t), Sign::Positive));
        atoms.push(Atom::new(num.sub(&den.mul(&Poly::var(t), &scope.fuel)?), Sign::Positive));
        atoms.push(germ.side.binding(t, &scope.fuel)?);
        Ok(atoms)
    }

    /// The atom that an atom along the germ leaves behind at t = 0.
    ///
    /// # Errors
    /// [`Rejection`] if it mentions what has no premised limit, or its sign does not pass.
    pub fn at_zero(&self, germ: &Germ, atom: &Atom) -> Checked<Atom> {
        if !matches!(atom.sign, Sign::Zero | Sign::NonNegative) {
            return Err(Rejection::NotAnEquation(0));
        }
        Ok(Atom::new(start(self, &germ.side, &atom.poly, 0)?, atom.sign))
    }
}

/// Whether some term of a polynomial whose terms have one sign is not zero on each face of the
/// orthant: for each variable its degree there, and whether 0 and ∞ belong to the region.
fn survives(p: &Poly, ends: &[(usize, u32, bool, bool)], fuel: &Fuel) -> Checked<bool> {
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
fn cells(bases: &[Vec<BigInt>], roots: &[Root], fuel: &Fuel) -> Checked<Vec<Vec<i8>>> {
    let mut out = Vec::new();
    let mut left: Option<&BigRational> = None;
    for root in roots.iter().map(Some).chain([None]) {
        // The gap between two roots.
        let right = root.map(|r| &r.lo);
        let inside = match (left, right) {
            (Some(a), Some(b)) if a > b => return Err(Rejection::RootCount),
            (Some(a), Some(b)) => (a + b) / BigRational::from_integer(2.into()),
            (Some(a), None) => a + BigRational::one(),
            (None, Some(b)) => b - BigRational::one(),
            (None, None) => BigRational::zero(),
        };
        for p in bases {
            if descartes(p, left, right, fuel)? != 0 {
                return Err(Rejection::RootCount);
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
                _ => return Err(Rejection::RootCount),
            });
        }
        out.push(signs);
        left = Some(&root.hi);
    }
    Ok(out)
}

impl Root {
    /// Whether the interval is a single rational point.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.lo == self.hi
    }
}

/// Whether an expression mentions a symbol with a property, through definitions and values too.
fn mentions(scope: &Scope<'_>, e: &Expr, wanted: impl Fn(usize) -> bool) -> bool {
    let mut seen = BTreeSet::new();
    let mut todo = vec![e];
    while let Some(e) = todo.pop() {
        match e {
            Expr::Var(v) | Expr::Deriv(_, v) => match scope.context.value(*v) {
                Some(value) => todo.push(value),
                None if wanted(*v) => return true,
                None => {}
            },
            Expr::Let(i) if seen.insert(*i) => {
                todo.extend(scope.context.lets.get(*i).map(|d| &d.body));
            }
            _ => {}
        }
        todo.extend(e.children());
    }
    false
}

/// Whether an expression depends on a function of x.
pub(crate) fn varies(scope: &Scope<'_>, e: &Expr, x: usize) -> bool {
    mentions(scope, e, |v| scope.context.vars.get(v).is_none_or(|w| w.of == Some(x)))
}

/// Whether an expression depends on x or on a function of x.
pub(crate) fn depends(scope: &Scope<'_>, e: &Expr, x: usize) -> bool {
    mentions(scope, e, |v| v == x) || varies(scope, e, x)
}
