//! Ranges: functions with which a given holds at each point near a limit.
//!
//! What is looked for is a witness that the given *can* hold there; what the functions of the
//! document really are does not matter. So an equation is solved for any function in it, and the
//! others are tried as simple ones.

use std::rc::Rc;

use kane_algebra::syntax::rebuild;
use kane_kernel::{
    Atom, Context, Expr, Germ, Inside, Poly, Rel, Sentence, Sign, State, inside_goal, inside_state,
    scope,
};
use num_rational::BigRational as Q;

use super::diagonal::diagonal;
use super::elimination::Elimination;
use super::search::{Outcome, Search};
use super::variation::{determined, varies};
use crate::argument::expand;

/// Tuples of simple functions that are tried for a given.
const TRIES: usize = 24;
/// Search steps for one of them.
const STEPS: u64 = 400;
/// Definitions inside definitions, followed at most this deep.
const MAX_DEPTH: usize = 64;

/// Functions of the limit variable, as expressions in it and in constants.
pub(super) type Values = Vec<(usize, Expr)>;

/// A proof that a given can hold along a germ.
pub(super) fn inside(state: &State<'_, '_>, germ: &Germ, given: &Sentence) -> Option<Inside> {
    let x = germ.side.var;
    let functions = mentioned(state, given, x);
    let proved = |values: Values| proved(state, germ, given, values);
    if functions.is_empty() {
        return proved(Vec::new());
    }
    let lists: Vec<Vec<Expr>> = functions.iter().map(|_| simple(x)).collect();
    let choices = diagonal(&lists, TRIES);
    let solved = Solved::of(&state.goal.context, given, &functions);
    let boundaries = boundaries(&state.goal.context, given, &functions);
    for choice in choices {
        let chosen: Values = functions.iter().copied().zip(choice).collect();
        let on = |bounds: &[(usize, Expr)]| {
            let mut values = chosen.clone();
            for (f, at) in bounds {
                let at = placed(at, &chosen)?;
                values.iter_mut().filter(|v| v.0 == *f).for_each(|v| v.1 = at.clone());
            }
            proved(values)
        };
        let alone = boundaries.iter().map(std::slice::from_ref);
        if let Some(found) = alone.chain([&boundaries[..]]).find_map(on) {
            return Some(found);
        }
        // what the author of the given may have meant first, then the simple functions themselves
        let determined = [solved.with(&chosen), eliminated(state, germ, given, &chosen)];
        let chosen = (!boundaries.is_empty()).then_some(chosen);
        for values in determined.into_iter().chain([chosen]).flatten() {
            if let Some(found) = proved(values) {
                return Some(found);
            }
        }
    }
    None
}

/// A proof that a given holds along a germ with these functions.
pub(super) fn proved(
    state: &State<'_, '_>,
    germ: &Germ,
    given: &Sentence,
    values: Values,
) -> Option<Inside> {
    let goal = inside_goal(state, &germ.side, given, &values).ok()?;
    let scope = scope(&goal, state.scope.fuel.clone()).ok()?;
    let along = inside_state(state, germ, &scope, &goal).ok()?;
    let may = varies(&along, germ.side.var);
    let mut search = Search::new(STEPS, &may, false);
    // To cut ranges takes long, and has not been needed near a limit.
    search.cuts = false;
    match search.solve(&along) {
        Outcome::Closed(argument) => {
            Some(Inside { values, proof: expand(&along, &argument).ok()? })
        }
        _ => None,
    }
}

/// The functions of x that a given mentions, ascending.
fn mentioned(state: &State<'_, '_>, given: &Sentence, x: usize) -> Vec<usize> {
    let context = &state.goal.context;
    let relations = given.when.iter().chain(given.relations());
    let mut todo: Vec<&Expr> = relations.flat_map(|r| [&r.lhs, &r.rhs]).collect();
    let (mut out, mut lets) = (Vec::new(), Vec::new());
    while let Some(e) = todo.pop() {
        match e {
            Expr::Var(v) if context.vars.get(*v).is_some_and(|var| var.of == Some(x)) => {
                out.push(*v);
            }
            Expr::Let(i) if !lets.contains(i) => {
                lets.push(*i);
                todo.extend(context.lets.get(*i).map(|d| &d.body));
            }
            _ => {}
        }
        todo.extend(e.children());
    }
    out.sort_unstable();
    out.dedup();
    out
}

/// Simple functions of x, simplest first.
fn simple(x: usize) -> Vec<Expr> {
    let var = || Rc::new(Expr::Var(x));
    let number = |n: i64, d: i64| Expr::Num(Q::new(n.into(), d.into()));
    vec![
        number(1, 1),
        number(0, 1),
        Expr::Var(x),
        number(-1, 1),
        Expr::Neg(var()),
        number(1, 2),
        Expr::Div(number(1, 1).into(), var()),
        number(2, 1),
        Expr::Pow(var(), 2),
        number(3, 1),
        number(-2, 1),
    ]
}

/// Equations of a given that have a function alone on one side, and the other side.
struct Solved(Vec<(usize, Expr)>);

impl Solved {
    fn of(context: &Context, given: &Sentence, functions: &[usize]) -> Self {
        let mut out: Vec<(usize, Expr)> = Vec::new();
        for r in given.relations().filter(|r| r.rel == Rel::Eq) {
            for (one, other) in [(&r.lhs, &r.rhs), (&r.rhs, &r.lhs)] {
                if let Expr::Var(f) = one
                    && functions.contains(f)
                    && !out.iter().any(|known| known.0 == *f)
                    && let Some(other) = expanded(other, context, MAX_DEPTH)
                {
                    out.push((*f, other));
                    break;
                }
            }
        }
        Self(out)
    }

    /// The chosen functions, with those in place of which an equation stands.
    fn with(&self, chosen: &Values) -> Option<Values> {
        let mut values = chosen.clone();
        // The last equation first: those before it may use what it says.
        for (f, other) in self.0.iter().rev() {
            let placed = placed(other, &values)?;
            values.iter_mut().filter(|known| known.0 == *f).for_each(|known| {
                known.1 = placed.clone();
            });
        }
        (!self.0.is_empty()).then_some(values)
    }
}

/// Functions alone on one side of an inequality, or times something, and what they are where both sides are
/// equal.
fn boundaries(context: &Context, given: &Sentence, functions: &[usize]) -> Vec<(usize, Expr)> {
    let mut out = Vec::new();
    for r in given.relations().filter(|r| !matches!(r.rel, Rel::Eq | Rel::Ne)) {
        for (one, other) in [(&r.lhs, &r.rhs), (&r.rhs, &r.lhs)] {
            let (f, at) = match one {
                Expr::Var(f) => (*f, other.clone()),
                Expr::Mul(a, b) => match (&**a, &**b) {
                    (Expr::Var(f), by) | (by, Expr::Var(f)) if functions.contains(f) => {
                        (*f, Expr::Div(other.clone().into(), by.clone().into()))
                    }
                    _ => continue,
                },
                _ => continue,
            };
            if functions.contains(&f)
                && let Some(at) = expanded(&at, context, MAX_DEPTH)
            {
                out.push((f, at));
            }
        }
    }
    out
}

/// An expression without definitions.
fn expanded(e: &Expr, context: &Context, depth: usize) -> Option<Expr> {
    let replace = &mut |part: &Expr| match part {
        Expr::Let(i) => {
            let body = &context.lets.get(*i).ok_or(())?.body;
            let depth = depth.checked_sub(1).ok_or(())?;
            expanded(body, context, depth).map(Some).ok_or(())
        }
        _ => Ok(None),
    };
    rebuild(e, replace).ok()
}

/// An expression with the values in place of their functions.
fn placed(e: &Expr, values: &Values) -> Option<Expr> {
    let replace = &mut |part: &Expr| match part {
        Expr::Var(v) => Ok(values.iter().find(|known| known.0 == *v).map(|known| known.1.clone())),
        Expr::Deriv(..) => Err(()),
        _ => Ok(None),
    };
    rebuild(e, replace).ok()
}

/// What a given says along a germ, with its equations solved for the variables that may go.
fn reduced<T>(
    state: &State<'_, '_>,
    germ: &Germ,
    given: &Sentence,
    may: &dyn Fn(usize, &Poly) -> bool,
    next: impl FnOnce(&State<'_, '_>, &[Elimination]) -> Option<T>,
) -> Option<T> {
    let goal = inside_goal(state, &germ.side, given, &[]).ok()?;
    let scope = scope(&goal, state.scope.fuel.clone()).ok()?;
    let along = inside_state(state, germ, &scope, &goal).ok()?;
    let holds = scope.premise(given, true, true).ok()?;
    let formulas = along.formulas.split_last().map(|(_, known)| known.to_vec())?;
    let along = State { formulas: Rc::new([formulas, vec![holds]].concat()), ..along };
    let (rest, trail) = Search::new(STEPS, may, false).reduced(&along)?;
    next(&rest, &trail)
}

/// The chosen functions, but for those that the equations of the given determine.
fn eliminated(
    state: &State<'_, '_>,
    germ: &Germ,
    given: &Sentence,
    chosen: &Values,
) -> Option<Values> {
    let x = germ.side.var;
    let may = |v: usize, _: &Poly| chosen.iter().any(|known| known.0 == v);
    reduced(state, germ, given, &may, |rest, trail| {
        if trail.is_empty() {
            return None;
        }
        let free = chosen.iter().filter(|known| !trail.iter().any(|e| e.var == known.0));
        let constants: Vec<usize> =
            (0..state.goal.context.vars.len()).filter(|v| state.is_constant(*v, x)).collect();
        determined(rest, (x, &constants), free.cloned().collect(), trail, false)
    })
}

/// What, in constants, a polynomial begins with in t that a given says is not zero.
pub(super) fn leads(state: &State<'_, '_>, germ: &Germ, given: &Sentence) -> Vec<Poly> {
    let x = germ.side.var;
    let may = varies(state, x);
    let found = reduced(state, germ, given, &may, |rest, _| {
        let t = rest.scope.germ();
        let begins = |atom: &Atom| {
            let moves = atom.sign != Sign::Zero && atom.poly.degree(t) > 0;
            let first = || atom.poly.coefficients(t).into_iter().find(|c| !c.is_empty());
            moves.then(first).flatten()
        };
        let leads = rest.atoms.iter().filter_map(begins);
        let constant = |p: &Poly| p.vars().iter().all(|v| state.is_constant(*v, x));
        Some(leads.filter(constant).collect())
    });
    found.unwrap_or_default()
}
