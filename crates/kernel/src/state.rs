//! The rules: a state is a conjunction of atoms, and a proof shows that no point satisfies it.

use std::rc::Rc;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::{
    Atom, Atoms, Cases, Expr, Germ, Goal, Poly, Proof, Rejection, Root, Scope, Sign, Term,
    descartes, exponent, sign, sign_at,
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
}

impl<'s, 'g> State<'s, 'g> {
    /// Checks that a proof closes this state.
    ///
    /// # Errors
    /// [`Rejection`] naming the rule that does not apply.
    pub fn refute(&self, proof: &Proof) -> Result<(), Rejection> {
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
            Proof::Nonzero { factors, cofactors } => {
                let known = self.product(factors, false)?;
                let sum = self.combination(cofactors)?;
                (known == sum).then_some(()).ok_or(Rejection::NotAnIdentity)
            }
            Proof::Orthant { atom, bounds } => self.orthant(*atom, bounds),
            Proof::SignTable { var, bases, roots, atoms } => {
                self.sign_table(*var, bases, roots, atoms)
            }
            Proof::Pass { germ, atom, along, then } => {
                let state = self.along(germ)?;
                state.with(atom.not()).refute(along)?;
                self.with(self.at_zero(germ, atom)?).refute(then)
            }
        }
    }

    fn atom(&self, i: usize) -> Result<&Atom, Rejection> {
        self.atoms.get(i).ok_or(Rejection::NoSuchAtom(i))
    }

    /// This state and one more atom.
    #[must_use]
    pub fn with(&self, atom: Atom) -> Self {
        let mut next = self.clone();
        next.atoms.push(atom);
        next
    }

    /// One state for each case of a formula.
    ///
    /// # Errors
    /// [`Rejection::NoSuchFormula`].
    pub fn assume(&self, formula: usize) -> Result<Vec<Self>, Rejection> {
        let cases = self.formulas.get(formula).ok_or(Rejection::NoSuchFormula(formula))?;
        let next = |case: &Atoms| {
            let mut state = self.clone();
            state.atoms.extend(case.iter().cloned());
            state
        };
        Ok(cases.iter().map(next).collect())
    }

    /// Reduces all other atoms by an equation, as polynomials in a variable; one that is linear in
    /// it eliminates it, and goes.
    ///
    /// # Errors
    /// [`Rejection`] if it is no such equation or its leading coefficient may vanish.
    pub fn substitute(
        &self,
        equation: usize,
        var: usize,
        lead: &[(usize, u32)],
    ) -> Result<Self, Rejection> {
        let eq = self.atom(equation)?;
        let parts = eq.poly.coefficients(var);
        let Some(top) = parts.last().filter(|_| parts.len() > 1 && eq.sign == Sign::Zero) else {
            return Err(Rejection::NotAnEquation(equation));
        };
        // The sign of the leading coefficient decides whether odd powers of it may stand below an
        // inequality.
        let (want, have) = (self.product(lead, false)?.primitive().1, top.primitive().1);
        let flip = have == want.neg();
        if have.is_empty() || !(have == want || flip) {
            return Err(Rejection::MayVanish);
        }
        let even = |&(i, n): &(usize, u32)| n % 2 == 0 || self.atoms[i].sign == Sign::Positive;
        let positive = lead.iter().all(even);
        let parts: Vec<Poly> = if flip { parts.iter().map(Poly::neg).collect() } else { parts };
        let mut next = self.clone();
        for (i, atom) in next.atoms.iter_mut().enumerate() {
            if i == equation {
                if parts.len() == 2 {
                    *atom = Atom::new(Poly::default(), Sign::Zero);
                }
                continue;
            }
            let order = matches!(atom.sign, Sign::Positive | Sign::NonNegative);
            let even = order && !positive;
            let poly = atom.poly.remainder(var, &parts, even, &self.scope.fuel)?;
            atom.poly = poly.primitive().1;
        }
        Ok(next)
    }

    /// Divides an atom by factors that do not vanish.
    ///
    /// # Errors
    /// [`Rejection`] if a factor may vanish or the product does not give back the atom.
    pub fn cancel(
        &self,
        atom: usize,
        factors: &[(usize, u32)],
        quotient: &Poly,
    ) -> Result<Self, Rejection> {
        let old = self.atom(atom)?;
        let order = matches!(old.sign, Sign::Positive | Sign::NonNegative);
        if factors.iter().any(|f| f.0 == atom) {
            return Err(Rejection::MayVanish);
        }
        let known = self.product(factors, order)?;
        let product = known.mul(quotient, &self.scope.fuel)?;
        // Equal up to a positive rational factor.
        if product.primitive().1 != old.poly.primitive().1 {
            return Err(Rejection::NotAnIdentity);
        }
        let mut next = self.clone();
        next.atoms[atom].poly = quotient.clone();
        Ok(next)
    }

    /// Product of powers of atoms that do not vanish; with `order`, of a positive product.
    fn product(&self, factors: &[(usize, u32)], order: bool) -> Result<Poly, Rejection> {
        let mut product = Poly::one();
        for &(i, n) in factors {
            let atom = self.atom(i)?;
            match atom.sign {
                Sign::Positive => {}
                Sign::NonZero if !order || n % 2 == 0 => {}
                _ => return Err(Rejection::MayVanish),
            }
            let power = atom.poly.pow(n, &self.scope.fuel)?;
            product = product.mul(&power, &self.scope.fuel)?;
        }
        Ok(product)
    }

    fn combination(&self, cofactors: &[(usize, Poly)]) -> Result<Poly, Rejection> {
        let mut sum = Poly::default();
        for (i, c) in cofactors {
            let atom = self.atom(*i)?;
            if atom.sign != Sign::Zero {
                return Err(Rejection::NotAnEquation(*i));
            }
            sum = sum.add(&atom.poly.mul(c, &self.scope.fuel)?);
        }
        Ok(sum)
    }

    fn positive(&self, terms: &[Term], cofactors: &[(usize, Poly)]) -> Result<(), Rejection> {
        let fuel = &self.scope.fuel;
        let (mut sum, mut strict) = (self.combination(cofactors)?, false);
        for t in terms {
            if !t.weight.is_positive() {
                return Err(Rejection::NotPositive);
            }
            let mut visible = t.square.as_constant().is_some_and(|c| !c.is_zero());
            let mut product = t.square.mul(&t.square, fuel)?.scale(&t.weight);
            for &(i, n) in &t.factors {
                let atom = self.atom(i)?;
                match atom.sign {
                    Sign::Positive => {}
                    Sign::NonZero if n % 2 == 0 => {}
                    Sign::NonNegative => visible &= n == 0,
                    _ => return Err(Rejection::NotPositive),
                }
                product = product.mul(&atom.poly.pow(n, fuel)?, fuel)?;
            }
            strict |= visible;
            sum = sum.add(&product);
        }
        if !sum.is_empty() {
            return Err(Rejection::NotAnIdentity);
        }
        strict.then_some(()).ok_or(Rejection::NotPositive)
    }

    fn orthant(
        &self,
        atom: usize,
        bounds: &[(usize, Option<usize>, Option<usize>)],
    ) -> Result<(), Rejection> {
        let fuel = &self.scope.fuel;
        let target = self.atom(atom)?;
        if bounds.iter().enumerate().any(|(i, b)| bounds[..i].iter().any(|c| c.0 == b.0)) {
            return Err(Rejection::NotABound(atom));
        }
        let mut p = target.poly.clone();
        // For each variable: its degree, and which ends of [0, ∞] belong to the region.
        let mut ends = Vec::new();
        for &(v, lower, upper) in bounds {
            let bound = |i: Option<usize>, side: i8| match i {
                Some(i) => self.bound(i, v, side).map(Some),
                None => Ok(None),
            };
            let degree = p.degree(v);
            let y = Poly::var(v);
            let q = |c: &BigInt| Poly::constant(c.clone());
            // v = num/den with den > 0 on the orthant.
            let (num, den) = match (bound(lower, 1)?, bound(upper, -1)?) {
                (Some((l, open)), None) => {
                    ends.push((v, degree, !open, false));
                    (y.scale(l.denom()).add(&q(l.numer())), q(l.denom()))
                }
                (None, Some((u, open))) => {
                    ends.push((v, degree, !open, false));
                    (q(u.numer()).sub(&y.scale(u.denom())), q(u.denom()))
                }
                (Some((l, open_l)), Some((u, open_u))) => {
                    ends.push((v, degree, !open_l, !open_u));
                    let low = q(&(l.numer() * u.denom()));
                    let high = y.scale(&(u.numer() * l.denom()));
                    (low.add(&high), y.add(&Poly::one()).scale(&(l.denom() * u.denom())))
                }
                (None, None) => return Err(Rejection::NotABound(atom)),
            };
            let mut sum = Poly::default();
            let mut power = Poly::one();
            for c in p.coefficients(v).iter().rev() {
                sum = sum.mul(&num, fuel)?.add(&c.mul(&power, fuel)?);
                power = power.mul(&den, fuel)?;
            }
            p = sum;
        }
        if p.vars().iter().any(|v| !bounds.iter().any(|b| b.0 == *v)) {
            return Err(Rejection::NotABound(atom));
        }
        let side = |positive: bool| p.terms().all(|(_, c)| c.is_positive() == positive);
        // Whether some term is non-zero on every face that belongs to the region.
        let strict = || -> Result<bool, Rejection> {
            let mut faces: Vec<Vec<Option<u32>>> = vec![Vec::new()];
            for &(_, degree, low, high) in &ends {
                fuel.spend(u64::try_from(faces.len()).unwrap_or(u64::MAX))?;
                faces = faces
                    .iter()
                    .flat_map(|f| {
                        let options =
                            [Some(None), low.then_some(Some(0)), high.then_some(Some(degree))];
                        options.into_iter().flatten().map(|o| [&f[..], &[o]].concat())
                    })
                    .collect();
            }
            let count = faces.len().saturating_mul(p.len());
            fuel.spend(u64::try_from(count).unwrap_or(u64::MAX))?;
            Ok(faces.iter().all(|face| {
                p.terms().any(|(m, _)| {
                    let fits = |(&(v, ..), want): (&(usize, u32, bool, bool), &Option<u32>)| {
                        want.is_none_or(|e| exponent(m, v) == e)
                    };
                    ends.iter().zip(face).all(fits)
                })
            }))
        };
        let contradicts = match target.sign {
            Sign::Positive => side(false),
            Sign::NonNegative => side(false) && strict()?,
            Sign::Zero => (side(false) || side(true)) && strict()?,
            Sign::NonZero => p.is_empty(),
        };
        contradicts.then_some(()).ok_or(Rejection::WrongSign)
    }

    /// Reads atom i as a lower (side 1) or upper (side −1) bound of v: its value, and if it is open.
    fn bound(&self, i: usize, v: usize, side: i8) -> Result<(BigRational, bool), Rejection> {
        let atom = self.atom(i)?;
        let parts = atom.poly.univariate(v);
        let (Some([c, k]), true) =
            (parts.as_deref(), matches!(atom.sign, Sign::Positive | Sign::NonNegative))
        else {
            return Err(Rejection::NotABound(i));
        };
        if sign(k) != side {
            return Err(Rejection::NotABound(i));
        }
        Ok((BigRational::new(-c, k.clone()), atom.sign == Sign::Positive))
    }

    fn sign_table(
        &self,
        var: usize,
        bases: &[Vec<BigInt>],
        roots: &[Root],
        atoms: &[(usize, BigRational, Vec<u32>)],
    ) -> Result<(), Rejection> {
        let fuel = &self.scope.fuel;
        for (i, constant, powers) in atoms {
            let mut product = Poly::constant(constant.numer().clone());
            for (base, n) in bases.iter().zip(powers) {
                product = product.mul(&in_variable(base, var).pow(*n, fuel)?, fuel)?;
            }
            let atom = self.atom(*i)?;
            if !constant.denom().is_positive()
                || product != atom.poly.scale(constant.denom())
                || powers.len() != bases.len()
            {
                return Err(Rejection::NotAnIdentity);
            }
        }
        for signs in cells(bases, roots, self.scope)? {
            let refuted = atoms.iter().any(|(i, constant, powers)| {
                let value =
                    signs.iter().zip(powers).fold(sign(constant.numer()), |s, (b, n)| {
                        match (n, b) {
                            (0, _) => s,
                            (n, -1) if n % 2 == 1 => -s,
                            (_, 0) => 0,
                            _ => s,
                        }
                    });
                !self.atoms[*i].sign.admits(value)
            });
            if !refuted {
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
    pub fn along(&self, germ: &Germ) -> Result<Self, Rejection> {
        let along = self.along_unproved(germ)?;
        if !self.reaching {
            let leaves = crate::limit::leaves(self.scope, self.goal, germ.side.var)?;
            let inside = Self { formulas: Rc::new(leaves), ..along.clone() };
            inside.refute(&germ.inside)?;
        }
        Ok(along)
    }

    /// The state along a germ, without the proof that the germ lies in the narrowed domain: for
    /// those who look for that proof.
    ///
    /// # Errors
    /// As [`State::along`].
    pub fn along_unproved(&self, germ: &Germ) -> Result<Self, Rejection> {
        let x = germ.side.var;
        let (num, den) = &germ.radius;
        if !germ.side.is_inside(self.scope) {
            return Err(Rejection::OutsideDomain);
        }
        if [num, den].iter().any(|p| p.vars().iter().any(|&v| !self.is_constant(v, x))) {
            return Err(Rejection::NotConstant);
        }
        let positive = |p: &Poly| vec![Atom::new(p.clone(), Sign::Positive).not()];
        let mut radius = self.clone();
        let vanishing = vec![positive(num), positive(den)];
        radius.formulas = Rc::new([&self.formulas[..], &[vanishing]].concat());
        radius.refute(&germ.positive)?;
        let t = self.scope.germ();
        let gap = num.sub(&den.mul(&Poly::var(t), &self.scope.fuel)?);
        let mut atoms = self.scope.ranges();
        if !self.scope.mentioned.contains(&x) {
            atoms.extend(self.scope.range(x));
        }
        let constant = |a: &&Atom| a.poly.vars().iter().all(|&v| self.is_constant(v, x));
        atoms.extend(self.atoms.iter().filter(constant).cloned());
        atoms.push(Atom::new(Poly::var(t), Sign::Positive));
        atoms.push(Atom::new(gap, Sign::Positive));
        atoms.push(germ.side.binding(t, &self.scope.fuel)?);
        Ok(Self {
            scope: self.scope,
            goal: self.goal,
            atoms,
            formulas: Rc::new(crate::limit::along(self.scope, self.goal, &germ.side)?),
            reaching: self.reaching,
        })
    }

    /// The atom that an atom along the germ leaves behind at t = 0.
    ///
    /// # Errors
    /// [`Rejection`] if it mentions what has no premised limit, or its sign does not pass.
    pub fn at_zero(&self, germ: &Germ, atom: &Atom) -> Result<Atom, Rejection> {
        if !matches!(atom.sign, Sign::Zero | Sign::NonNegative) {
            return Err(Rejection::NotAnEquation(0));
        }
        let poly = crate::limit::start(self, &germ.side, &atom.poly)?;
        Ok(Atom::new(poly, atom.sign))
    }
}

/// Coefficients as a polynomial in v.
#[must_use]
pub fn in_variable(coefficients: &[BigInt], v: usize) -> Poly {
    let mut p = Poly::default();
    for (i, c) in (0u32..).zip(coefficients) {
        let monomial = if i == 0 { Vec::new() } else { vec![(v, i)] };
        p.add_term(monomial, c.clone());
    }
    p
}

/// The sign vectors of the bases on every cell of the line: gaps and roots, from left to right.
///
/// # Errors
/// [`Rejection::RootCount`] if Descartes' rule does not confirm the roots.
pub fn cells(
    bases: &[Vec<BigInt>],
    roots: &[Root],
    scope: &Scope<'_>,
) -> Result<Vec<Vec<i8>>, Rejection> {
    let bad = || Err(Rejection::RootCount);
    let mut out = Vec::new();
    let mut left: Option<&Root> = None;
    for right in roots.iter().map(Some).chain(std::iter::once(None)) {
        // The gap between two roots.
        let (lo, hi) = (left.map(|r| &r.hi), right.map(|r| &r.lo));
        if let (Some(a), Some(b)) = (lo, hi) {
            if a > b
                || (a == b && left.is_some_and(Root::is_exact) && right.is_some_and(Root::is_exact))
            {
                return bad();
            }
        }
        let inside = match (lo, hi) {
            (Some(a), Some(b)) => (a + b) / BigRational::from_integer(2.into()),
            (Some(a), None) => a + BigRational::one(),
            (None, Some(b)) => b - BigRational::one(),
            (None, None) => BigRational::zero(),
        };
        let mut signs = Vec::new();
        for p in bases {
            let s = sign_at(p, &inside);
            // The ends of the gap belong to it unless they are themselves the roots.
            let vanishes = [(left, lo), (right, hi)].into_iter().any(|(root, end)| {
                let closed = root.is_some_and(|r| !r.is_exact());
                closed && end.is_some_and(|x| sign_at(p, x) != s)
            });
            if s == 0 || vanishes || crate::descartes(p, lo, hi, &scope.fuel)? != 0 {
                return bad();
            }
            signs.push(s);
        }
        out.push(signs.clone());
        // The root that follows.
        if let Some(root) = right {
            if root.is_exact() {
                out.push(bases.iter().map(|p| sign_at(p, &root.lo)).collect());
            } else {
                if root.lo > root.hi {
                    return bad();
                }
                let mut own = 0;
                for (p, s) in bases.iter().zip(&mut signs) {
                    match descartes(p, Some(&root.lo), Some(&root.hi), &scope.fuel)? {
                        0 => {}
                        1 if *p == root.poly => {
                            own += 1;
                            *s = 0;
                        }
                        _ => return bad(),
                    }
                }
                if own != 1 {
                    return bad();
                }
                out.push(signs);
            }
        }
        left = right;
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

/// Whether an expression mentions a symbol with a property, through definitions too.
#[must_use]
fn mentions(scope: &Scope<'_>, e: &Expr, wanted: impl Fn(usize) -> bool) -> bool {
    let mut seen = std::collections::HashSet::new();
    let mut todo = vec![e];
    while let Some(e) = todo.pop() {
        match e {
            Expr::Var(v) if wanted(*v) => return true,
            Expr::Deriv(_, x) if wanted(*x) => return true,
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
#[must_use]
pub(crate) fn varies(scope: &Scope<'_>, e: &Expr, x: usize) -> bool {
    mentions(scope, e, |v| scope.context.vars.get(v).is_none_or(|w| w.of == Some(x)))
}

/// Whether an expression depends on x or on a function of x.
#[must_use]
pub fn depends(scope: &Scope<'_>, e: &Expr, x: usize) -> bool {
    mentions(scope, e, |v| v == x) || varies(scope, e, x)
}
