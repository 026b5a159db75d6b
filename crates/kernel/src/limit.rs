//! Limits: what holds along a germ t → 0+, and what of it is left at t = 0.

use std::rc::Rc;

use crate::state::{depends, varies};
use crate::{
    Approach, Atom, Atoms, Cases, Expr, Fuel, Goal, Limit, Link, Poly, Rejection, Relation, Scope,
    Sentence, Side, SideProof, Sign, State, Target, exponent,
};

impl Side {
    /// Whether the domain of the limit variable contains the germ for all small t.
    #[must_use]
    pub fn is_inside(&self, scope: &Scope<'_>) -> bool {
        let Some(var) = scope.context.vars.get(self.var) else {
            return false;
        };
        let (lower, upper) = (var.lower.as_ref(), var.upper.as_ref());
        match (&self.at, self.above) {
            (None, true) => upper.is_none(),
            (None, false) => lower.is_none(),
            (Some(a), true) => {
                upper.is_none_or(|b| *a < b.value) && lower.is_none_or(|b| *a >= b.value)
            }
            (Some(a), false) => {
                lower.is_none_or(|b| *a > b.value) && upper.is_none_or(|b| *a <= b.value)
            }
        }
    }

    /// x = a ± t or x·t = ±1 as an equation.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn binding(&self, t: usize, fuel: &Fuel) -> Result<Atom, Rejection> {
        let (x, t) = (Poly::var(self.var), Poly::var(t));
        let t = if self.above { t } else { t.neg() };
        let poly = match &self.at {
            Some(a) => {
                let moved = x.sub(&t).scale(a.denom());
                moved.sub(&Poly::constant(a.numer().clone()))
            }
            None => x.mul(&t, fuel)?.sub(&Poly::one()),
        };
        Ok(Atom::new(poly, Sign::Zero))
    }
}

/// The sides from which a limit is meant, inside the domain.
#[must_use]
pub fn sides(scope: &Scope<'_>, limit: &Limit) -> Vec<Side> {
    let side = |at: Option<&num_rational::BigRational>, above| Side {
        var: limit.var,
        at: at.cloned(),
        above,
    };
    let all = match &limit.at {
        Approach::To(a) => vec![side(Some(a), true), side(Some(a), false)],
        Approach::Above(a) => vec![side(Some(a), true)],
        Approach::Below(a) => vec![side(Some(a), false)],
        Approach::PlusInf => vec![side(None, true)],
        Approach::MinusInf => vec![side(None, false)],
    };
    all.into_iter().filter(|s| s.is_inside(scope)).collect()
}

/// The limits among the premises, in order, each with its sentence.
pub fn premised(goal: &Goal) -> impl Iterator<Item = (&Sentence, &Limit)> {
    goal.hypotheses.iter().flat_map(|h| {
        let limits = h.sentence.links.iter().filter_map(|l| match l {
            Link::Limit(limit) => Some(limit),
            Link::Relation(_) => None,
        });
        limits.map(|l| (&h.sentence, l))
    })
}

/// Whether a premised limit gives a value: finite, and nothing around it varies with the variable.
fn has_value(scope: &Scope<'_>, s: &Sentence, l: &Limit) -> bool {
    let mut parts = s.when.iter().flat_map(|r| [&r.lhs, &r.rhs]);
    match &l.to {
        Target::Finite(value) => {
            !depends(scope, value, l.var) && !parts.any(|e| depends(scope, e, l.var))
        }
        _ => false,
    }
}

/// Whether a premise speaks of x without any function of x: it narrows the domain of x.
#[must_use]
pub fn narrows(scope: &Scope<'_>, s: &Sentence, x: usize) -> bool {
    let relations: Vec<_> = s.when.iter().chain(crate::normal::relations(s)).collect();
    let limits = s.links.iter().any(|l| matches!(l, Link::Limit(_)));
    let any = |test: &dyn Fn(&Expr) -> bool| relations.iter().any(|r| test(&r.lhs) || test(&r.rhs));
    !limits && any(&|e| depends(scope, e, x)) && !any(&|e| varies(scope, e, x))
}

/// Formulas that hold where a germ leaves the narrowed domain: what is known of constants, and one
/// of the narrowing premises fails.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn leaves(scope: &Scope<'_>, goal: &Goal, x: usize) -> Result<Vec<Cases>, Rejection> {
    let mut formulas = at_point(scope, goal, Some(x))?;
    let mut outside = Cases::new();
    for h in &goal.hypotheses {
        if narrows(scope, &h.sentence, x) {
            outside.extend(scope.premise_fails(&h.sentence, h.given)?);
        }
    }
    formulas.push(outside);
    Ok(formulas)
}

/// A formula that says nothing.
fn nothing() -> Cases {
    vec![Atoms::new()]
}

/// `den·z = num` on each piece where e is defined, under the sentence's `when`.
fn bound_to(scope: &Scope<'_>, s: &Sentence, e: &Expr, z: usize) -> Result<Cases, Rejection> {
    let when = scope.all(&s.when)?;
    let mut values = Cases::new();
    for mut piece in scope.pieces(e)? {
        if let Some(v) = piece.value {
            let gap = v.den.mul(&Poly::var(z), &scope.fuel)?.sub(&v.num);
            piece.atoms.push(Atom::new(gap, Sign::Zero));
            values.push(piece.atoms);
        }
    }
    let mut cases = when.not();
    cases.extend(scope.meet(&when.holds, &values)?);
    Ok(cases)
}

/// Formulas along a germ: the premises, then for each premised limit on this side the function
/// behind its variable, then `when` if nothing in it varies.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn along(scope: &Scope<'_>, goal: &Goal, side: &Side) -> Result<Vec<Cases>, Rejection> {
    let mut formulas = Vec::new();
    for h in &goal.hypotheses {
        formulas.push(scope.premise(&h.sentence, h.given)?);
    }
    for (z, (s, l)) in (scope.germ() + 1..).zip(premised(goal)) {
        formulas.push(if has_value(scope, s, l) && sides(scope, l).contains(side) {
            bound_to(scope, s, &l.expr, z)?
        } else {
            nothing()
        });
    }
    let mut parts = goal.when.iter().flat_map(|r| [&r.lhs, &r.rhs]);
    let varies = parts.any(|e| depends(scope, e, side.var));
    formulas.push(if varies { nothing() } else { scope.all(&goal.when)?.holds });
    Ok(formulas)
}

/// Formulas at a point: the premises, then the value behind each premised finite limit. For a
/// limit claim along x only what is free of x.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn at_point(scope: &Scope<'_>, goal: &Goal, x: Option<usize>) -> Result<Vec<Cases>, Rejection> {
    let free = |relations: &[Relation]| {
        let dependent = |e: &Expr| x.is_some_and(|x| depends(scope, e, x));
        !relations.iter().any(|r| dependent(&r.lhs) || dependent(&r.rhs))
    };
    let mut formulas = Vec::new();
    for h in &goal.hypotheses {
        let relations: Vec<_> = crate::normal::relations(&h.sentence).cloned().collect();
        let speaks = free(&h.sentence.when) && free(&relations);
        formulas.push(if speaks { scope.premise(&h.sentence, h.given)? } else { nothing() });
    }
    for (z, (s, l)) in (scope.germ() + 1..).zip(premised(goal)) {
        formulas.push(match &l.to {
            Target::Finite(value) if free(&s.when) && has_value(scope, s, l) => {
                bound_to(scope, s, value, z)?
            }
            _ => nothing(),
        });
    }
    let when = free(&goal.when).then(|| scope.all(&goal.when)).transpose()?;
    formulas.push(when.map_or_else(nothing, |truth| truth.holds));
    Ok(formulas)
}

/// A polynomial along a germ at t = 0; it may mention t, constants, and limits premised on this
/// side.
///
/// # Errors
/// [`Rejection::NotConstant`] if it mentions anything else.
pub fn start(state: &State<'_, '_>, side: &Side, poly: &Poly) -> Result<Poly, Rejection> {
    let t = state.scope.germ();
    let premised: Vec<_> = premised(state.goal).collect();
    let known = |v: usize| match v.checked_sub(t + 1).and_then(|i| premised.get(i)) {
        Some((s, l)) => has_value(state.scope, s, l) && sides(state.scope, l).contains(side),
        None => v == t || state.is_constant(v, side.var),
    };
    if !poly.vars().into_iter().all(known) {
        return Err(Rejection::NotConstant);
    }
    Ok(poly.coefficients(t).swap_remove(0))
}

/// The state in which the ends of a limit claim along x are compared: what is known of constants.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn constants<'s, 'g>(
    scope: &'s Scope<'g>,
    goal: &'g Goal,
    x: usize,
) -> Result<State<'s, 'g>, Rejection> {
    let mut state = State {
        scope,
        goal,
        atoms: Atoms::new(),
        formulas: Rc::new(at_point(scope, goal, Some(x))?),
        reaching: false,
    };
    for &v in &scope.mentioned {
        if state.is_constant(v, x) {
            state.atoms.extend(scope.range(v));
        }
    }
    Ok(state)
}

/// Where f is undefined along a germ, or den·f ≠ num.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn differs(
    scope: &Scope<'_>,
    f: &Expr,
    (num, den): (&Poly, &Poly),
) -> Result<Cases, Rejection> {
    let mut cases = Cases::new();
    for mut piece in scope.pieces(f)? {
        if let Some(v) = piece.value {
            let gap = den.mul(&v.num, &scope.fuel)?.sub(&num.mul(&v.den, &scope.fuel)?);
            piece.atoms.push(Atom::new(gap, Sign::NonZero));
        }
        cases.push(piece.atoms);
    }
    Ok(cases)
}

/// Where num and den at t = 0 do not show the limit to be the target.
///
/// # Errors
/// [`Rejection`] if den lacks the power of t that an infinite limit needs.
pub fn misses(
    state: &State<'_, '_>,
    side: &Side,
    proof: (&Poly, &Poly, u32),
    target: &Target,
) -> Result<Cases, Rejection> {
    let (scope, (num, den, order)) = (state.scope, proof);
    let num = start(state, side, num)?;
    let mut cases = Cases::new();
    if let Target::Finite(value) = target {
        if order != 0 {
            return Err(Rejection::WrongOrder);
        }
        let den = start(state, side, den)?;
        cases.push(vec![Atom::new(den.clone(), Sign::Zero)]);
        for mut piece in scope.pieces(value)? {
            if let Some(v) = piece.value {
                let left = num.mul(&v.den, &scope.fuel)?;
                let gap = left.sub(&den.mul(&v.num, &scope.fuel)?);
                piece.atoms.push(Atom::new(gap, Sign::NonZero));
            }
            cases.push(piece.atoms);
        }
        return Ok(cases);
    }
    let t = scope.germ();
    let mut rest = Poly::default();
    for (m, c) in den.terms() {
        let e = exponent(m, t).checked_sub(order).ok_or(Rejection::WrongOrder)?;
        let mut lower: Vec<_> = m.iter().copied().filter(|p| p.0 != t).collect();
        if e > 0 {
            lower.push((t, e));
            lower.sort_unstable();
        }
        rest.add_term(lower, c.clone());
    }
    if order == 0 {
        return Err(Rejection::WrongOrder);
    }
    let product = num.mul(&start(state, side, &rest)?, &scope.fuel)?;
    let up = matches!(target, Target::PlusInf);
    let signed = if up { product } else { product.neg() };
    Ok(vec![vec![Atom::new(signed, Sign::Positive).not()]])
}

/// Checks a limit proof from one side.
///
/// # Errors
/// [`Rejection`] naming what does not hold.
pub(crate) fn check(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
    proof: &SideProof,
) -> Result<(), Rejection> {
    if proof.germ.side != *side {
        return Err(Rejection::OutsideDomain);
    }
    let wrong =
        |state: &State<'_, '_>, cases: Cases| Rc::new([&state.formulas[..], &[cases]].concat());
    let mut along = state.along(&proof.germ)?;
    let ends = (&proof.num, &proof.den);
    along.formulas = wrong(&along, differs(state.scope, &limit.expr, ends)?);
    along.refute(&proof.along)?;
    let parts = (&proof.num, &proof.den, proof.order);
    let mut at_zero = state.clone();
    at_zero.formulas = wrong(state, misses(state, side, parts, &limit.to)?);
    at_zero.refute(&proof.at_zero)
}
