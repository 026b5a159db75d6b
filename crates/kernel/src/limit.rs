//! Limits: what holds along a germ t → 0+, and what of it is left at t = 0.

use std::borrow::Cow;
use std::cmp::Ordering;
use std::rc::Rc;

use crate::normal::regions;
use crate::state::{depends, has, varies};
use crate::{
    Approach, Atom, Atoms, Bound, Cases, Checked, Conclusion, Context, Expr, Fraction, Fuel, Germ,
    Goal, Hypothesis, Limit, Passages, Piece, Poly, Rejection, Relation, Scope, Sentence, Side,
    SideProof, Sign, State, Target, expressions, point_state, range_premise,
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

    /// x = a ± tⁿ or x·tⁿ = ±1 as an equation.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn binding(&self, (t, n): (usize, u32), fuel: &Fuel) -> Checked<Atom> {
        let step = Poly::power(t, n).scale(&if self.above { 1.into() } else { (-1).into() });
        let poly = match &self.at {
            Some(a) => Poly::in_variable(self.var, &[-a.numer(), a.denom().clone()])
                .sub(&step.scale(a.denom())),
            None => Poly::var(self.var).mul(&step, fuel)?.sub(&Poly::one()),
        };
        Ok(Atom::new(poly, Sign::Zero))
    }
}

impl Limit {
    /// What is compared along a germ: the expression f or, where the limit L has a root that f has not, f + 0·L, so
    /// that it is known of this root what it is a root of.
    #[must_use]
    pub fn compared(&self, scope: &Scope<'_>) -> Cow<'_, Expr> {
        let of_f = |e: &Expr| has(scope, &self.expr, &|part| part == e);
        match &self.to {
            Target::Finite(to) if has(scope, to, &|e| matches!(e, Expr::Sqrt(_)) && !of_f(e)) => {
                let nothing = Expr::Mul(Expr::int(0).into(), to.clone().into());
                Cow::Owned(Expr::Add(self.expr.clone().into(), nothing.into()))
            }
            _ => Cow::Borrowed(&self.expr),
        }
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

/// What a given says of x without any function of x: so it narrows the domain of x. A cited claim
/// does not.
#[must_use]
pub fn narrowing(scope: &Scope<'_>, h: &Hypothesis, x: usize) -> Sentence {
    let s = &h.sentence;
    let sides =
        |r: &Relation| [&r.lhs, &r.rhs].map(|e| (depends(scope, e, x), varies(scope, e, x)));
    let speaks = |r: &Relation| sides(r).iter().any(|(depends, _)| *depends);
    let plainly = |r: &Relation| !sides(r).iter().any(|(_, varies)| *varies);
    let conditioned = s.when.iter().any(speaks);
    let plain = s.when.iter().all(plainly);
    s.only(|r| h.given && plain && plainly(r) && (conditioned || speaks(r)))
}

/// What a premise says of constants while x varies: the items of a given's list that are free of x;
/// a cited claim as a whole, its limits too, or nothing.
fn of_constants(scope: &Scope<'_>, h: &Hypothesis, x: usize) -> Sentence {
    let free = |r: &Relation| [&r.lhs, &r.rhs].iter().all(|e| !depends(scope, e, x));
    let s = &h.sentence;
    let links = if h.given { &[] } else { &s.links[..] };
    let whole = expressions(&s.when, links).all(|e| !depends(scope, e, x));
    if whole { s.only(free) } else { Sentence::default() }
}

/// The givens, cited or behind, in whose range a germ on this side has to lie: those whose
/// relations depend on the variable. If it is taken for granted that the claimed limit is reached
/// from this side, the cited ones are not among them.
#[must_use]
pub fn owed<'g>(state: &State<'_, 'g>, side: &Side) -> Vec<&'g Sentence> {
    let cited = state.goal.hypotheses.iter().filter(|h| h.given && !state.reaches(side));
    let all = cited.map(|h| &h.sentence).chain(&state.goal.behind);
    let relations = |s: &'g Sentence| s.when.iter().chain(s.relations());
    let speaks = |r: &Relation| [&r.lhs, &r.rhs].iter().any(|e| depends(state.scope, e, side.var));
    all.filter(|s| relations(s).any(speaks)).collect()
}

/// The question whether a given holds along a germ for explicit functions of its variable: those in
/// place, what is known of constants as premises, and the given with the ranges of the functions.
///
/// # Errors
/// [`Rejection::WrongEvidence`] if a value is not one of a function of x in x and constants.
pub fn inside_goal(
    state: &State<'_, '_>,
    side: &Side,
    given: &Sentence,
    values: &[(usize, Expr)],
) -> Checked<Goal> {
    let (goal, x) = (state.goal, side.var);
    for (i, (v, e)) in values.iter().enumerate() {
        let of_x = goal.context.vars.get(*v).is_some_and(|var| var.of == Some(x));
        let twice = values[..i].iter().any(|(w, _)| w == v);
        if !of_x || twice || !is_explicit(e, &|w| w == x || state.is_constant(w, x)) {
            return Err(Rejection::WrongEvidence);
        }
    }
    let constant =
        |h: &Hypothesis| Hypothesis { sentence: of_constants(state.scope, h, x), given: h.given };
    let free = |r: &&Relation| [&r.lhs, &r.rhs].iter().all(|e| !depends(state.scope, e, x));
    Ok(Goal {
        context: Context { values: values.to_vec(), ..goal.context.clone() },
        hypotheses: goal.hypotheses.iter().map(constant).collect(),
        behind: Vec::new(),
        when: goal.when.iter().filter(free).cloned().collect(),
        conclusion: Conclusion::NotImplied(given.only(|_| true)),
    })
}

/// The state of such a question along the germ: the given fails, or a value is undefined or out of
/// the range of its function.
///
/// # Errors
/// [`Rejection::Budget`]; as [`State::along`].
pub fn inside_state<'s, 'g>(
    state: &State<'_, '_>,
    germ: &Germ,
    scope: &'s Scope<'g>,
    goal: &'g Goal,
) -> Checked<State<'s, 'g>> {
    let Conclusion::NotImplied(given) = &goal.conclusion else {
        return Err(Rejection::WrongEvidence);
    };
    let mut fails = scope.premise(given, true, false)?;
    for (v, _) in &goal.context.values {
        fails.extend(scope.premise(&range_premise(&goal.context, *v).sentence, true, false)?);
    }
    let inside = point_state(scope, goal, Some(fails))?;
    Ok(State { atoms: state.atoms_along(germ, scope)?, passages: Passages::Nowhere, ..inside })
}

/// Whether an expression mentions nothing but numbers and allowed symbols.
pub(crate) fn is_explicit(e: &Expr, allowed: &dyn Fn(usize) -> bool) -> bool {
    let fits = match e {
        Expr::Var(v) | Expr::Deriv(_, v) => allowed(*v),
        Expr::Let(_) => false,
        _ => true,
    };
    fits && e.children().into_iter().all(|part| is_explicit(part, allowed))
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
/// the value or, along a germ on its side, the function; and what of `when` does not vary there.
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
        formulas.push(match place {
            Place::Constants(x) => scope.premise(&of_constants(scope, h, x), h.given, true)?,
            Place::Point | Place::Germ(_) => scope.premise(&h.sentence, h.given, true)?,
        });
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
                let bound = scope.each(&scope.pieces(e)?, |f| {
                    let gap = gap(scope, f, (&Poly::var(z), &Poly::one()))?;
                    Ok(vec![Piece { atoms: vec![Atom::new(gap, Sign::Zero)], value: Some(true) }])
                })?;
                regions(scope.under(&s.when, &bound)?, |holds| holds == Some(true))
            }
            None => nothing(),
        });
    }
    let when = scope.all(goal.when.iter().filter(|r| free(&r.lhs) && free(&r.rhs)))?;
    formulas.push(regions(when, |holds| holds == Some(true)));
    Ok(formulas)
}

/// den·f − num, times the denominator of f.
fn gap(scope: &Scope<'_>, f: &Fraction, (num, den): (&Poly, &Poly)) -> Checked<Poly> {
    Ok(den.mul(&f.num, &scope.fuel)?.sub(&num.mul(&f.den, &scope.fuel)?))
}

/// Where e is undefined, or den·e ≠ num. With `Greater` in place of `Equal`: or e < num/den; with
/// `Less`: or e > num/den (nothing is said where den = 0).
///
/// # Errors
/// [`Rejection::Budget`].
pub fn differs(
    scope: &Scope<'_>,
    e: &Expr,
    ends: (&Poly, &Poly),
    sense: Ordering,
) -> Checked<Cases> {
    let wrong = scope.each(&scope.pieces(e)?, |f| {
        let gap = gap(scope, f, ends)?;
        let order = |gap: &Poly| ends.1.mul(&f.den, &scope.fuel)?.mul(gap, &scope.fuel);
        let atom = match sense {
            Ordering::Equal => Atom::new(gap, Sign::NonZero),
            Ordering::Less => Atom::new(order(&gap)?, Sign::Positive),
            Ordering::Greater => Atom::new(order(&gap)?.neg(), Sign::Positive),
        };
        Ok(vec![Piece { atoms: vec![atom], value: Some(true) }])
    })?;
    Ok(regions(wrong, |_| true))
}

/// The coefficient of t^order of a polynomial along a germ, all lower ones being zero; it may
/// mention t, constants, roots of constants, and limits premised on this side.
///
/// # Errors
/// [`Rejection::NotConstant`] if it mentions anything else, [`Rejection::WrongOrder`].
pub(crate) fn start(state: &State<'_, '_>, side: &Side, poly: &Poly, order: u32) -> Checked<Poly> {
    let (scope, t) = (state.scope, state.scope.germ());
    let fixed = |root: &Expr| !depends(scope, root, side.var);
    let known = |v: usize| match v.checked_sub(t + 1) {
        Some(i) => premised(state.goal)
            .nth(i)
            .is_some_and(|(s, l)| value(scope, s, l).is_some() && sides(scope, l).contains(side)),
        None => v == t || state.is_constant(v, side.var) || scope.root(v).is_some_and(fixed),
    };
    if !poly.vars().into_iter().all(known) {
        return Err(Rejection::NotConstant);
    }
    let lower = poly.terms().any(|(m, _)| crate::exponent(m, t) < order);
    let fits = !lower && order <= poly.degree(t);
    fits.then(|| poly.coefficient(t, order)).ok_or(Rejection::WrongOrder)
}

/// The state in which the ends of a limit claim along x are compared: what is known of constants.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn constants<'s, 'g>(scope: &'s Scope<'g>, goal: &'g Goal, x: usize) -> Checked<State<'s, 'g>> {
    let formulas = Rc::new(premises(scope, goal, Place::Constants(x))?);
    let atoms = Atoms::new();
    let passages = Passages::Along(x);
    let mut state = State { scope, goal, atoms, formulas, reaching: false, passages };
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
            let mut cases = differs(state.scope, value, (&num, &den), Ordering::Equal)?;
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
    match (&limit.to, proof.sense, &proof.upper) {
        (_, Ordering::Equal, None)
        | (Target::PlusInf, Ordering::Greater, None)
        | (Target::MinusInf, Ordering::Less, None) => bound(state, limit, side, proof),
        (Target::Finite(_), Ordering::Greater, Some(upper))
            if upper.sense == Ordering::Less && upper.upper.is_none() =>
        {
            bound(state, limit, side, proof)?;
            bound(state, limit, side, upper)
        }
        _ => Err(Rejection::WrongEvidence),
    }
}

/// Checks how an expression compares along the germ, and what it is compared with at t = 0.
fn bound(state: &State<'_, '_>, limit: &Limit, side: &Side, proof: &SideProof) -> Checked {
    if proof.germ.side != *side {
        return Err(Rejection::OutsideDomain);
    }
    let along = state.along(&proof.germ)?;
    let (compared, ends) = (limit.compared(state.scope), (&proof.num, &proof.den));
    let wrong = differs(state.scope, &compared, ends, proof.sense)?;
    along.with_cases(wrong).refute(&proof.along)?;
    let parts = (&proof.num, &proof.den, proof.order);
    state.with_cases(misses(state, side, parts, &limit.to)?).refute(&proof.at_zero)
}
