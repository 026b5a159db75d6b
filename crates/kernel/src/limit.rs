//! Limits: what holds along a germ t → 0+, and what of it is left at t = 0.

use std::rc::Rc;

use crate::normal::regions;
use crate::state::{depends, varies};
use crate::{
    Approach, Atom, Atoms, Bound, Cases, Checked, Expr, Fuel, Goal, Limit, Piece, Poly, Rejection,
    Scope, Sentence, Side, SideProof, Sign, State, Target, expressions,
};

impl Side {
    /// Whether the domain of the limit variable contains the germ for all small t.
    #[must_use]
    pub fn is_inside(&self, scope: &Scope<'_>) -> bool {
        let Some(var) = scope.context.vars.get(self.var) else {
            return false;
        };
        match (&self.at, self.above) {
            (None, true) => var.upper.is_none(),
            (None, false) => var.lower.is_none(),
            (Some(a), above) => {
                let over = |b: &Bound| *a > b.value || (above && *a == b.value);
                let under = |b: &Bound| *a < b.value || (!above && *a == b.value);
                var.lower.as_ref().is_none_or(over) && var.upper.as_ref().is_none_or(under)
            }
        }
    }

    /// The approach from this side alone.
    #[must_use]
    pub fn approach(&self) -> Approach {
        match (self.at.clone(), self.above) {
            (Some(a), true) => Approach::Above(a),
            (Some(a), false) => Approach::Below(a),
            (None, true) => Approach::PlusInf,
            (None, false) => Approach::MinusInf,
        }
    }

    /// x = a ± t or x·t = ±1 as an equation.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn binding(&self, t: usize, fuel: &Fuel) -> Checked<Atom> {
        let step = Poly::var(t).scale(&if self.above { 1.into() } else { (-1).into() });
        let poly = match &self.at {
            Some(a) => Poly::in_variable(self.var, &[-a.numer(), a.denom().clone()])
                .sub(&step.scale(a.denom())),
            None => Poly::var(self.var).mul(&step, fuel)?.sub(&Poly::one()),
        };
        Ok(Atom::new(poly, Sign::Zero))
    }
}

/// The sides from which a limit is meant, inside the domain.
#[must_use]
pub fn sides(scope: &Scope<'_>, limit: &Limit) -> Vec<Side> {
    let (at, directions): (_, &[bool]) = match &limit.at {
        Approach::To(a) => (Some(a), &[true, false]),
        Approach::Above(a) => (Some(a), &[true]),
        Approach::Below(a) => (Some(a), &[false]),
        Approach::PlusInf => (None, &[true]),
        Approach::MinusInf => (None, &[false]),
    };
    let side = |above: &bool| Side { var: limit.var, at: at.cloned(), above: *above };
    directions.iter().map(side).filter(|s| s.is_inside(scope)).collect()
}

/// The limits among the premises, in order, each with its sentence.
pub fn premised(goal: &Goal) -> impl Iterator<Item = (&Sentence, &Limit)> {
    goal.hypotheses.iter().flat_map(|h| h.sentence.limits().map(|l| (&h.sentence, l)))
}

/// The value of a premised limit: finite, if nothing around it varies with the variable.
fn value<'g>(scope: &Scope<'_>, s: &Sentence, l: &'g Limit) -> Option<&'g Expr> {
    let Target::Finite(value) = &l.to else {
        return None;
    };
    let mut around = expressions(&s.when, &[]).chain([value]);
    (!around.any(|e| depends(scope, e, l.var))).then_some(value)
}

/// Whether a premise speaks of x without any function of x: it narrows the domain of x.
#[must_use]
pub fn narrows(scope: &Scope<'_>, s: &Sentence, x: usize) -> bool {
    s.limits().next().is_none()
        && expressions(&s.when, &s.links).any(|e| depends(scope, e, x))
        && !expressions(&s.when, &s.links).any(|e| varies(scope, e, x))
}

/// Formulas that hold where a germ leaves the narrowed domain: what is known of constants, and one
/// of the narrowing premises fails.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn leaves(scope: &Scope<'_>, goal: &Goal, x: usize) -> Checked<Vec<Cases>> {
    let mut formulas = premises(scope, goal, Place::Constants(x))?;
    let mut outside = Cases::new();
    for h in goal.hypotheses.iter().filter(|h| narrows(scope, &h.sentence, x)) {
        outside.extend(scope.premise(&h.sentence, h.given, false)?);
    }
    formulas.push(outside);
    Ok(formulas)
}

/// Where premises are read.
#[derive(Clone, Copy, Debug)]
pub enum Place<'a> {
    /// at a point
    Point,
    /// in the constants of a limit along this variable: only what is free of it
    Constants(usize),
    /// along a germ on this side
    Germ(&'a Side),
}

/// What is known at a place: the premises; for each premised limit what its variable stands for,
/// the value or, along a germ on its side, the function; and `when`, unless it varies there.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn premises(scope: &Scope<'_>, goal: &Goal, place: Place<'_>) -> Checked<Vec<Cases>> {
    let (x, side) = match place {
        Place::Point => (None, None),
        Place::Constants(x) => (Some(x), None),
        Place::Germ(side) => (Some(side.var), Some(side)),
    };
    let free = |e: &Expr| x.is_none_or(|x| !depends(scope, e, x));
    let nothing = || vec![Atoms::new()];
    let mut formulas = Vec::new();
    for h in &goal.hypotheses {
        let mut relations = h.sentence.when.iter().chain(h.sentence.relations());
        let speaks = side.is_some() || relations.all(|r| free(&r.lhs) && free(&r.rhs));
        formulas.push(if speaks { scope.premise(&h.sentence, h.given, true)? } else { nothing() });
    }
    for (z, (s, l)) in (scope.germ() + 1..).zip(premised(goal)) {
        let end = value(scope, s, l).filter(|_| expressions(&s.when, &[]).all(free));
        let behind = match side {
            None => end,
            Some(side) => {
                let along = sides(scope, l).contains(side);
                value(scope, s, l).filter(|_| along).map(|_| &l.expr)
            }
        };
        formulas.push(match behind {
            Some(e) => {
                let bound = quotient(scope, e, (&Poly::var(z), &Poly::one()), Sign::Zero)?;
                regions(scope.under(&s.when, &bound)?, |holds| holds == Some(true))
            }
            None => nothing(),
        });
    }
    let speaks = expressions(&goal.when, &[]).all(free);
    let when = scope.all(goal.when.iter().filter(|_| speaks))?;
    formulas.push(regions(when, |holds| holds == Some(true)));
    Ok(formulas)
}

/// `den·e − num` with a sign, on each piece where e is defined.
fn quotient(
    scope: &Scope<'_>,
    e: &Expr,
    (num, den): (&Poly, &Poly),
    sign: Sign,
) -> Checked<Vec<Piece<bool>>> {
    scope.each(&scope.pieces(e)?, |v| {
        let gap = den.mul(&v.num, &scope.fuel)?.sub(&num.mul(&v.den, &scope.fuel)?);
        Ok(vec![Piece { atoms: vec![Atom::new(gap, sign)], value: Some(true) }])
    })
}

/// Where e is undefined, or den·e ≠ num.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn differs(scope: &Scope<'_>, e: &Expr, ends: (&Poly, &Poly)) -> Checked<Cases> {
    Ok(regions(quotient(scope, e, ends, Sign::NonZero)?, |_| true))
}

/// The coefficient of t^order of a polynomial along a germ, all lower ones being zero; it may
/// mention t, constants, and limits premised on this side.
///
/// # Errors
/// [`Rejection::NotConstant`] if it mentions anything else, [`Rejection::WrongOrder`].
pub(crate) fn start(state: &State<'_, '_>, side: &Side, poly: &Poly, order: u32) -> Checked<Poly> {
    let (scope, t) = (state.scope, state.scope.germ());
    let known = |v: usize| match v.checked_sub(t + 1) {
        Some(i) => premised(state.goal)
            .nth(i)
            .is_some_and(|(s, l)| value(scope, s, l).is_some() && sides(scope, l).contains(side)),
        None => v == t || state.is_constant(v, side.var),
    };
    if !poly.vars().into_iter().all(known) {
        return Err(Rejection::NotConstant);
    }
    let lower = poly.terms().any(|(m, _)| crate::exponent(m, t) < order);
    let mut powers = (0..).zip(poly.coefficients(t));
    match powers.find(|(n, _)| *n == order) {
        Some((_, coefficient)) if !lower => Ok(coefficient),
        _ => Err(Rejection::WrongOrder),
    }
}

/// The state in which the ends of a limit claim along x are compared: what is known of constants.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn constants<'s, 'g>(scope: &'s Scope<'g>, goal: &'g Goal, x: usize) -> Checked<State<'s, 'g>> {
    let formulas = Rc::new(premises(scope, goal, Place::Constants(x))?);
    let atoms = Atoms::new();
    let mut state = State { scope, goal, atoms, formulas, reaching: false, on_germ: false };
    let constants = scope.mentioned.iter().filter(|v| state.is_constant(**v, x));
    state.atoms = constants.flat_map(|v| scope.range(*v)).collect();
    Ok(state)
}

/// Where num and den at t = 0 do not show the limit to be the target.
///
/// # Errors
/// [`Rejection`] if den lacks the power of t that an infinite limit needs.
pub fn misses(
    state: &State<'_, '_>,
    side: &Side,
    (num, den, order): (&Poly, &Poly, u32),
    target: &Target,
) -> Checked<Cases> {
    let num = start(state, side, num, 0)?;
    let den = start(state, side, den, order)?;
    let signed = match target {
        Target::Finite(value) if order == 0 => {
            let mut cases = differs(state.scope, value, (&num, &den))?;
            cases.push(vec![Atom::new(den, Sign::Zero)]);
            return Ok(cases);
        }
        Target::PlusInf if order > 0 => num.mul(&den, &state.scope.fuel)?,
        Target::MinusInf if order > 0 => num.mul(&den, &state.scope.fuel)?.neg(),
        _ => return Err(Rejection::WrongOrder),
    };
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
) -> Checked {
    if proof.germ.side != *side {
        return Err(Rejection::OutsideDomain);
    }
    let along = state.along(&proof.germ)?;
    let wrong = differs(state.scope, &limit.expr, (&proof.num, &proof.den))?;
    along.with_cases(wrong).refute(&proof.along)?;
    let parts = (&proof.num, &proof.den, proof.order);
    state.with_cases(misses(state, side, parts, &limit.to)?).refute(&proof.at_zero)
}
