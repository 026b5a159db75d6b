//! The rules: a state is a conjunction of atoms, and a proof shows that no point satisfies it.

use std::collections::BTreeSet;
use std::rc::Rc;

use num_traits::Signed;

use crate::limit::{Place, inside_goal, inside_state, owed, premises, sides, start};
use crate::{
    Atom, Atoms, Case, Cases, Checked, Conclusion, Expr, Germ, Goal, Link, Poly, Proof, Rejection,
    Root, Scope, Side, Sign, Term, scope,
};

/// Along which variables something may be passed to a limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passages {
    /// along any: at a point where the premises hold
    Anywhere,
    /// along this one: among what is constant while it varies
    Along(usize),
    /// along none: not along a germ, where a premised limit's variable stands for the function; not
    /// for explicit functions; not where no limit is spoken of, and statements speak of one point
    Nowhere,
}

impl Passages {
    /// Whether along x.
    #[must_use]
    pub fn allow(self, x: usize) -> bool {
        match self {
            Self::Anywhere => true,
            Self::Along(along) => along == x,
            Self::Nowhere => false,
        }
    }
}

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
    /// where something may be passed to a limit
    pub passages: Passages,
}

impl<'s, 'g> State<'s, 'g> {
    /// Checks that a proof closes this state.
    ///
    /// # Errors
    /// [`Rejection`] naming the rule that does not apply.
    pub fn refute(&self, proof: &Proof) -> Checked {
        self.scope.fuel.spend(1)?;
        match proof {
            Proof::Assume { formula, cases } => {
                let states = self.assume(*formula)?;
                if states.len() != cases.len() {
                    return Err(Rejection::CaseCount(states.len(), cases.len()));
                }
                states.iter().zip(cases).try_for_each(|(s, p)| s.refute(p))
            }
            Proof::Split { poly, cases } => self.split(poly, cases, &Self::refute),
            Proof::Positive { terms, cofactors } => self.positive(terms, cofactors),
            Proof::Pass { germ, .. } if !self.passages.allow(germ.side.var) => {
                Err(Rejection::OutsideDomain)
            }
            Proof::Pass { germ, atom, along, then } => {
                self.along(germ)?.with(atom.not()).refute(along)?;
                self.with(self.at_zero(germ, atom)?).refute(then)
            }
        }
    }

    /// Checks what there is for each case of the sign of a polynomial.
    pub(crate) fn split<P>(
        &self,
        poly: &Poly,
        cases: &[Case<P>],
        check: &dyn Fn(&Self, &P) -> Checked,
    ) -> Checked {
        let sided = |c: &Case<P>, s: i8| if c.opposite { -s } else { s };
        let admitted = |s: i8| cases.iter().any(|c| c.sign.admits(sided(c, s)));
        if ![-1, 0, 1].into_iter().all(admitted) {
            return Err(Rejection::SignLeftOut);
        }
        cases.iter().try_for_each(|c| {
            let side = if c.opposite { poly.neg() } else { poly.clone() };
            check(&self.with(Atom::new(side, c.sign)), &c.then)
        })
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
        if germ.power == 0 || !germ.side.is_inside(self.scope) {
            return Err(Rejection::OutsideDomain);
        }
        if [num, den].iter().any(|p| p.vars().iter().any(|&v| !self.is_constant(v, x))) {
            return Err(Rejection::NotConstant);
        }
        let positive = |p: &Poly| vec![Atom::new(p.clone(), Sign::Positive).not()];
        self.with_cases(vec![positive(num), positive(den)]).refute(&germ.positive)?;
        let atoms = self.atoms_along(germ, self.scope)?;
        let formulas = Rc::new(premises(self.scope, self.goal, Place::Germ(&germ.side))?);
        Ok(Self { atoms, formulas, passages: Passages::Nowhere, ..self.clone() })
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
        atoms.push(germ.side.binding((t, germ.power), &scope.fuel)?);
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

impl Root {
    /// Whether the interval is a single rational point.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.lo == self.hi
    }
}

/// Whether an expression has a part with a property, through definitions too.
pub(crate) fn has(scope: &Scope<'_>, e: &Expr, wanted: &dyn Fn(&Expr) -> bool) -> bool {
    let mut seen = BTreeSet::new();
    let mut todo = vec![e];
    while let Some(e) = todo.pop() {
        match e {
            Expr::Let(i) if seen.insert(*i) => {
                todo.extend(scope.context.lets.get(*i).map(|d| &d.body));
            }
            e if wanted(e) => return true,
            _ => {}
        }
        todo.extend(e.children());
    }
    false
}

/// Whether an expression mentions a symbol with a property, through definitions and values too.
fn mentions(scope: &Scope<'_>, e: &Expr, wanted: &dyn Fn(usize) -> bool) -> bool {
    has(scope, e, &|e| match e {
        Expr::Var(v) | Expr::Deriv(_, v) => match scope.context.value(*v) {
            Some(value) => mentions(scope, value, wanted),
            None => wanted(*v),
        },
        _ => false,
    })
}

/// Whether an expression depends on a function of x.
pub(crate) fn varies(scope: &Scope<'_>, e: &Expr, x: usize) -> bool {
    mentions(scope, e, &|v| scope.context.vars.get(v).is_none_or(|w| w.of == Some(x)))
}

/// Whether an expression depends on x or on a function of x.
pub(crate) fn depends(scope: &Scope<'_>, e: &Expr, x: usize) -> bool {
    mentions(scope, e, &|v| v == x) || varies(scope, e, x)
}
