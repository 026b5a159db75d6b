//! Why a limit is not decided, where it is of something that is undefined near its point, or claimed to be.

use kane_algebra::syntax::{NoValue, eval};
use kane_kernel::{Approach, Context, Expr, Goal, Limit, Target};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, Zero as _};

use super::functions::is_within;
use crate::Open;
use crate::spoken::within;

type Q = BigRational;

/// Distances from the point, as powers of two, at both of which something is undefined.
const NEAR: [u32; 2] = [10, 20];
/// Values of symbols that are tried.
const VALUES: [i64; 3] = [1, 2, -1];
/// Symbols that are tried at 0.
const ZEROS: usize = 16;

/// The place, if one is found among simple values; nothing of a goal with premises or conditions, which may exclude it.
pub(super) fn undefined(goal: &Goal, limit: &Limit) -> Option<Open> {
    if !goal.hypotheses.is_empty() || !goal.when.is_empty() {
        return None;
    }
    let context = &goal.context;
    let places = places(context);
    let of_target = |at: &Vec<Q>| match &limit.to {
        Target::Finite(value) => {
            let why = fault(value, context, at)?;
            Some(Open::NoTarget { at: said(value, context, at), why })
        }
        _ => None,
    };
    places.iter().find_map(of_target).or_else(|| {
        let near = |at: &Vec<Q>| {
            points(context, limit).into_iter().find_map(|near| {
                let there = |x: &Q| {
                    let mut at = at.clone();
                    *at.get_mut(limit.var)? = x.clone();
                    Some((fault(&limit.expr, context, &at)?, at))
                };
                let [far, close] = near.map(|x| there(&x));
                let ((_, _), (why, at)) = (far?, close?);
                Some(Open::UndefinedNear { at: said(&limit.expr, context, &at), why })
            })
        };
        places.iter().find_map(near)
    })
}

/// Why an expression has no value, if that is the point's fault.
fn fault(e: &Expr, context: &Context, at: &[Q]) -> Option<NoValue> {
    let is_the_point = |why: &NoValue| {
        matches!(why, NoValue::DivisionByZero | NoValue::NegativeRadicand | NoValue::NoCase)
    };
    eval(e, context, at).err().filter(is_the_point)
}

/// Simple values of all symbols: equal ones, and those of which one is 0.
fn places(context: &Context) -> Vec<Vec<Q>> {
    let admits = |v: usize, q: &Q| context.vars.get(v).is_some_and(|var| is_within(var, q));
    let inside = |v: usize, q: &Q| -> Q {
        let var = context.vars.get(v);
        let (lower, upper) =
            var.map_or((None, None), |var| (var.lower.as_ref(), var.upper.as_ref()));
        match (lower, upper) {
            _ if admits(v, q) => q.clone(),
            (Some(a), Some(b)) => (&a.value + &b.value) / (Q::one() + Q::one()),
            (Some(a), None) => &a.value + Q::one(),
            (None, Some(b)) => &b.value - Q::one(),
            (None, None) => q.clone(),
        }
    };
    let symbols = context.vars.len();
    let equal = VALUES.map(|n| {
        let q = Q::from(BigInt::from(n));
        (0..symbols).map(|v| inside(v, &q)).collect::<Vec<Q>>()
    });
    let zeros = (0..symbols).filter(|v| admits(*v, &Q::zero())).take(ZEROS).map(|v| {
        let mut at = equal[0].clone();
        at[v] = Q::zero();
        at
    });
    equal.iter().cloned().chain(zeros).collect()
}

/// Two points near the limit, on each of its sides that is in the domain.
fn points(context: &Context, limit: &Limit) -> Vec<[Q; 2]> {
    let near = |n: u32| Q::new(BigInt::one(), BigInt::one() << n);
    let (at, senses): (Option<&Q>, &[i64]) = match &limit.at {
        Approach::To(a) => (Some(a), &[-1, 1]),
        Approach::Above(a) => (Some(a), &[1]),
        Approach::Below(a) => (Some(a), &[-1]),
        Approach::PlusInf => (None, &[1]),
        Approach::MinusInf => (None, &[-1]),
    };
    let point = |sense: i64, n: u32| {
        let sense = Q::from(BigInt::from(sense));
        match at {
            Some(a) => a + sense * near(n),
            None => sense / near(n),
        }
    };
    let Some(var) = context.vars.get(limit.var) else { return Vec::new() };
    let inside = |x: &Q| {
        var.lower.as_ref().is_none_or(|b| *x > b.value)
            && var.upper.as_ref().is_none_or(|b| *x < b.value)
    };
    let all = senses.iter().map(|sense| NEAR.map(|n| point(*sense, n)));
    all.filter(|near| near.iter().all(inside)).collect()
}

/// The values of the symbols in an expression: `h = -1/1024`.
fn said(e: &Expr, context: &Context, at: &[Q]) -> String {
    let (symbols, _) = within(context, vec![e]);
    let value = |v: usize| Some(format!("{} = {}", context.vars.get(v)?.name, at.get(v)?));
    symbols.into_iter().filter_map(value).collect::<Vec<_>>().join(", ")
}
