//! Limits of expressions with roots: along a power of t they lie between two quotients.

use std::cmp::Ordering;

use kane_kernel::{Expr, Germ, Limit, Poly, Side, State, Target, differs, misses};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::enclosure::Ground;
use super::search::{Outcome, Search};
use super::series::{Along, Rationals, Series, Value};
use super::variation::roots;
use crate::argument::{Argument, SideArgument};

/// Powers of t along which roots are tried.
const POWERS: [u32; 4] = [1, 2, 4, 8];
/// Terms of a root's series that its enclosure has, one try after the other.
const TERMS: [u32; 3] = [2, 4, 8];
/// Coefficients of a series that are computed.
const PRECISION: usize = 24;

/// What an expression tends to along a side, read off its series.
pub(super) fn target(state: &State<'_, '_>, limit: &Limit, side: &Side) -> Option<Target> {
    POWERS.iter().find_map(|&power| {
        let along = Along { scope: state.scope, side, power, terms: PRECISION, numbers: Rationals };
        let finite = |q| Target::Finite(Expr::Num(q));
        Some(match along.value(&limit.expr)? {
            Value::Zero => finite(BigRational::zero()),
            Value::Series(s) => match s.low.cmp(&0) {
                Ordering::Greater => finite(BigRational::zero()),
                Ordering::Equal => finite(s.coefficients[0].clone()),
                Ordering::Less if s.is_positive() => Target::PlusInf,
                Ordering::Less => Target::MinusInf,
            },
        })
    })
}

/// The first argument that is found along a germ, of those of a power of t.
pub(super) type Find<'a> =
    &'a dyn Fn(u32, &mut dyn FnMut(Germ) -> Option<SideArgument>) -> Option<SideArgument>;

/// A proof of a limit from one side by bounds.
pub(super) fn one_side(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
    steps: u64,
    germs: Find<'_>,
) -> Option<SideArgument> {
    let t = state.scope.germ();
    if roots(state.scope).is_empty() {
        return None;
    }
    POWERS.iter().find_map(|&power| {
        let along = Along { scope: state.scope, side, power, terms: PRECISION, numbers: Rationals };
        let value = along.value(&limit.expr)?;
        let bounds = bounds(&along, &value, &closed_target(&along, &limit.to)?, t)?;
        let ends = bounds
            .iter()
            .map(|b| at_zero(state, limit, side, (&b.num, &b.den, b.order), steps))
            .collect::<Option<Vec<_>>>()?;
        germs(power, &mut |germ| {
            let mut shown = bounds
                .iter()
                .zip(&ends)
                .map(|(bound, end)| bounded(state, limit, &along, &germ, bound, end))
                .collect::<Option<Vec<_>>>()?;
            let upper = (shown.len() > 1).then(|| shown.pop()).flatten().map(Box::new);
            Some(SideArgument { upper, ..shown.pop()? })
        })
    })
}

/// A target without symbols as a number.
fn closed_target(along: &Along<'_, '_>, to: &Target) -> Option<Target> {
    let Target::Finite(e) = to else {
        return Some(to.clone());
    };
    let value = match along.value(e)? {
        Value::Zero => BigRational::zero(),
        Value::Series(s) => {
            let constant = s.low == 0 && s.coefficients[1..].iter().all(Zero::is_zero);
            constant.then(|| s.coefficients[0].clone())?
        }
    };
    Some(Target::Finite(Expr::Num(value)))
}

/// A quotient beside the expression.
struct Bound {
    num: Poly,
    den: Poly,
    order: u32,
    sense: Ordering,
}

/// Quotients that bound what tends to a target: L ± c·t, or c/tⁿ.
fn bounds(along: &Along<'_, '_>, value: &Value, to: &Target, t: usize) -> Option<Vec<Bound>> {
    let integer = |q: BigRational| q.abs().floor().to_integer() + BigInt::one();
    let infinite = |s: &Series, sense| {
        let order = u32::try_from(-s.low).ok().filter(|n| *n > 0)?;
        // half of the leading coefficient is passed
        let half = &s.coefficients[0] / BigRational::from_integer(2.into());
        let den = Poly::power(t, order).scale(half.denom());
        Some(vec![Bound { num: Poly::constant(half.numer().clone()), den, order, sense }])
    };
    match (to, value) {
        (Target::PlusInf, Value::Series(s)) if s.is_positive() => infinite(s, Ordering::Greater),
        (Target::MinusInf, Value::Series(s)) if !s.is_positive() => infinite(s, Ordering::Less),
        (Target::Finite(Expr::Num(limit)), value) => {
            let slope = match value {
                Value::Series(s) if s.low >= 0 && along.coefficient(s, 0)? == *limit => {
                    along.coefficient(s, 1)?
                }
                Value::Zero if limit.is_zero() => BigRational::zero(),
                _ => return None,
            };
            let slope = Poly::term(vec![(t, 1)], integer(slope) * limit.denom());
            let at = Poly::constant(limit.numer().clone());
            let bound = |num, sense| {
                let den = Poly::constant(limit.denom().clone());
                Bound { num, den, order: 0, sense }
            };
            Some(vec![
                bound(at.sub(&slope), Ordering::Greater),
                bound(at.add(&slope), Ordering::Less),
            ])
        }
        _ => None,
    }
}

/// Why a quotient tends to the target of a limit.
pub(super) fn at_zero(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
    quotient: (&Poly, &Poly, u32),
    steps: u64,
) -> Option<Argument> {
    let any = |_: usize, _: &Poly| true;
    let ends = state.with_cases(misses(state, side, quotient, &limit.to).ok()?);
    match Search::new(steps, &any, false).solve(&ends) {
        Outcome::Closed(argument) => Some(argument),
        _ => None,
    }
}

/// The argument that an expression is bounded along a germ.
fn bounded(
    state: &State<'_, '_>,
    limit: &Limit,
    along: &Along<'_, '_>,
    germ: &Germ,
    bound: &Bound,
    end: &Argument,
) -> Option<SideArgument> {
    let Bound { num, den, order, sense } = bound;
    let wrong = differs(state.scope, &limit.compared(state.scope), (num, den), *sense).ok()?;
    let there = state.along_unproved(germ).ok()?.with_cases(wrong);
    let formula = there.formulas.len() - 1;
    let states = there.assume(formula).ok()?;
    let closed = |case, terms| {
        Ground::new(case, along, germ, there.atoms.len())?.contradiction(&there, terms)
    };
    let cases = TERMS.iter().find_map(|&terms| {
        states.iter().map(|case| closed(case, terms)).collect::<Option<Vec<_>>>()
    })?;
    Some(SideArgument {
        germ: germ.clone(),
        num: num.clone(),
        den: den.clone(),
        order: *order,
        sense: *sense,
        along: Argument::Assume { formula, cases },
        at_zero: end.clone(),
        upper: None,
    })
}
