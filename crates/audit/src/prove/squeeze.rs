//! Limits between bounds: an expression in functions that premises bound lies between what it is on the
//! bounds, and tends to what both of these tend to.

use std::cmp::Ordering;

use kane_algebra::ring::cancelled;
use kane_kernel::{
    Atom, Fraction, Fuel, Germ, Limit, Poly, Rejection, Side, State, Target, differs, exponent,
    scope,
};
use num_bigint::BigInt;

use super::bounds::at_zero;
use super::factors::linear_factors;
use super::germs::Germs;
use super::search::{Outcome, Search};
use super::variation::{substituted, varies};
use crate::argument::{Argument, SideArgument};

/// Bounds of one function that are tried.
const BOUNDS: usize = 4;
/// Functions that are put on their bounds.
const FUNCTIONS: usize = 2;
/// Quotients that are tried along a germ.
const QUOTIENTS: usize = 16;
/// Coefficient operations of a search for sums of squares.
const SQUARES: u64 = 10_000_000;
/// Germs that are tried.
const GERMS: usize = 2;
/// One part in so many of the work that is left is for one quotient.
const SHARE: u64 = 2;

/// A quotient beside an expression, and why it tends to the limit.
pub(super) struct Beside {
    pub(super) num: Poly,
    pub(super) den: Poly,
    pub(super) order: u32,
    pub(super) end: Argument,
}

/// A proof of a limit from one side by quotients between which the expression lies.
pub(super) fn one_side(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
    steps: u64,
) -> Option<SideArgument> {
    let germs = Germs::new(state, side, steps);
    germs.all().take(GERMS).find_map(|germ| along(state, limit, side, &germ, steps))
}

fn along(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
    germ: &Germ,
    steps: u64,
) -> Option<SideArgument> {
    let mut found = Vec::new();
    for (num, den) in quotients(state, limit, germ, steps) {
        let t = state.scope.germ();
        let order = den.terms().map(|(m, _)| exponent(m, t)).min().unwrap_or(0);
        if let Some(end) = at_zero(state, limit, side, (&num, &den, order), steps) {
            found.push(Beside { num, den, order, end });
        }
    }
    let shown = |sense: Ordering| {
        found.iter().find_map(|beside| bounded(state, limit, germ, beside, sense, steps))
    };
    between(&limit.to, &shown)
}

/// The argument that an expression tends to a target by quotients beside it: on both sides of it, or below or above where
/// the target is infinite.
pub(super) fn between(
    to: &Target,
    shown: &dyn Fn(Ordering) -> Option<SideArgument>,
) -> Option<SideArgument> {
    match to {
        Target::PlusInf => shown(Ordering::Greater),
        Target::MinusInf => shown(Ordering::Less),
        Target::Finite(_) => {
            let lower = shown(Ordering::Greater)?;
            Some(SideArgument { upper: Some(Box::new(shown(Ordering::Less)?)), ..lower })
        }
    }
}

/// The argument that the expression is on one side of a quotient along a germ.
fn bounded(
    state: &State<'_, '_>,
    limit: &Limit,
    germ: &Germ,
    beside: &Beside,
    sense: Ordering,
    steps: u64,
) -> Option<SideArgument> {
    let Beside { num, den, order, end } = beside;
    let any = |_: usize, _: &Poly| true;
    let fuel = &state.scope.fuel;
    let scope = scope(state.goal, fuel.within(fuel.left() / SHARE)).ok()?;
    let state = State { scope: &scope, ..state.clone() };
    let wrong = differs(state.scope, &limit.compared(state.scope), (num, den), sense).ok()?;
    let there = state.along_unproved(germ).ok()?.with_cases(wrong);
    let mut search = Search::new(steps, &any, false);
    search.squares = state.scope.fuel.within(SQUARES);
    let Outcome::Closed(along) = search.solve(&there) else { return None };
    Some(SideArgument {
        germ: germ.clone(),
        num: num.clone(),
        den: den.clone(),
        order: *order,
        sense,
        along,
        at_zero: end.clone(),
        upper: None,
    })
}

/// Quotients in t and constants that may lie beside an expression: the limit itself, what the expression
/// is where its functions are on their bounds, and, if the limit is 0, multiples of that.
fn quotients(state: &State<'_, '_>, limit: &Limit, germ: &Germ, steps: u64) -> Vec<(Poly, Poly)> {
    let x = germ.side.var;
    let fuel = &state.scope.fuel;
    let of_x = |v: &usize| match state.scope.context.vars.get(*v) {
        Some(var) => var.of == Some(x),
        None => state.scope.root(*v).is_some() && !state.is_constant(*v, x),
    };
    let mut out = Vec::new();
    let (Ok(along), Ok(pieces)) = (state.along_unproved(germ), state.scope.pieces(&limit.expr))
    else {
        return out;
    };
    let may = varies(state, x);
    let search = Search::new(steps, &may, false);
    for piece in pieces {
        let Some(value) = &piece.value else { continue };
        let Some((rest, trail)) = search.reduced(&along.with_cases(vec![piece.atoms])) else {
            continue;
        };
        let Ok((num, den)) = substituted(&along, value, &trail) else { continue };
        let mut functions: Vec<usize> = num.vars().into_iter().chain(den.vars()).collect();
        functions.retain(of_x);
        functions.sort_unstable();
        functions.dedup();
        if functions.is_empty() || functions.len() > FUNCTIONS {
            continue;
        }
        let mut on_bounds = vec![(num, den)];
        for f in functions {
            let bounds: Vec<(Poly, Poly)> = rest
                .atoms
                .iter()
                .flat_map(|a| linear_in(a, f, fuel))
                .map(|p| (p.coefficient(f, 1), p.coefficient(f, 0)))
                .filter(|(_, b)| !b.is_empty())
                .take(BOUNDS)
                // as for sines and cosines
                .chain([1, -1].map(|n| (Poly::one(), Poly::constant(BigInt::from(n)))))
                .collect();
            let put = |(num, den): &(Poly, Poly)| -> Vec<(Poly, Poly)> {
                bounds.iter().filter_map(|at| put_in(num, den, f, at, fuel).ok()).collect()
            };
            on_bounds = on_bounds.iter().flat_map(put).take(QUOTIENTS).collect();
        }
        on_bounds.retain(|(num, den)| {
            !den.is_empty() && !num.vars().into_iter().chain(den.vars()).any(|v| of_x(&v))
        });
        out.extend(on_bounds);
    }
    if out.is_empty() {
        return out;
    }
    if let Target::Finite(to) = &limit.to
        && let Ok(pieces) = state.scope.pieces(to)
    {
        let of = |f: Fraction| (f.num, f.den);
        let ends: Vec<(Poly, Poly)> = pieces.into_iter().filter_map(|p| p.value).map(of).collect();
        if ends.iter().all(|(num, _)| num.is_empty()) {
            let wide: Vec<_> =
                out.iter().flat_map(|q| wider(q, state.scope.germ(), fuel)).collect();
            out.extend(wide);
        }
        out.splice(0..0, ends);
    }
    out.dedup();
    out.truncate(QUOTIENTS);
    out
}

/// What is of degree one in a function: the polynomial of an inequality, or factors of an equation.
fn linear_in(atom: &Atom, f: usize, fuel: &Fuel) -> Vec<Poly> {
    if atom.sign.is_order() && atom.poly.degree(f) == 1 {
        return vec![atom.poly.clone()];
    }
    linear_factors(atom, f, fuel)
}

/// num/den with −b/a in the place of a variable.
fn put_in(
    num: &Poly,
    den: &Poly,
    v: usize,
    (a, b): &(Poly, Poly),
    fuel: &Fuel,
) -> Result<(Poly, Poly), Rejection> {
    let degree = num.degree(v).max(den.degree(v));
    let put = |p: &Poly| -> Result<Poly, Rejection> {
        let (mut sum, minus) = (Poly::default(), b.neg());
        for i in 0..=degree {
            let power = minus.pow(i, fuel)?.mul(&a.pow(degree - i, fuel)?, fuel)?;
            sum = sum.add(&p.coefficient(v, i).mul(&power, fuel)?);
        }
        Ok(sum)
    };
    Ok(cancelled(&put(num)?, &put(den)?))
}

/// ±(Σ (1 + c²)·tⁿ)/den for a numerator Σ c·tⁿ, so that the signs of constants do not matter.
fn wider((num, den): &(Poly, Poly), t: usize, fuel: &Fuel) -> Vec<(Poly, Poly)> {
    let wide = || -> Result<Poly, Rejection> {
        let mut sum = Poly::default();
        for n in 0..=num.degree(t) {
            let c = num.coefficient(t, n);
            if !c.is_empty() {
                let more = c.mul(&c, fuel)?.add(&Poly::constant(BigInt::from(1)));
                sum = sum.add(&more.mul(&Poly::power(t, n), fuel)?);
            }
        }
        Ok(sum)
    };
    let both = |p: Poly| [(p.neg(), den.clone()), (p, den.clone())];
    wide().map(both).into_iter().flatten().collect()
}
