//! Limits of expressions with roots where symbols are about, between L − c·t and L + c·t, or beyond c/tⁿ: by envelopes,
//! without a search.

use std::cell::RefCell;
use std::cmp::Ordering;

use kane_kernel::{Expr, Germ, Limit, Poly, Side, State, Target, differs};
use num_rational::BigRational;
use num_traits::Zero as _;

use super::bounds::at_zero;
use super::envelope::{Both, Envelope};
use super::germs::Germs;
use super::nearness::Nearness;
use super::series::{Along, Numbers as _, Value};
use super::squeeze::{Beside, between};
use super::symbols::{Quotient, Rough, Symbols, polynomial};
use super::variation::{ratio_in, roots};
use crate::argument::{Argument, Rules as _, SideArgument};

/// Powers of t along which roots are tried.
const POWERS: [u32; 2] = [1, 2];
/// Terms of a root's series that its enclosure has, one try after the other.
const TERMS: [u32; 4] = [1, 2, 3, 4];
/// Summands of a proof that a quotient lies on one side: with more, it takes the kernel seconds.
const MOST: usize = 10_000;
/// Roots that the scope does not have, but coefficients may.
const ADJOINED: usize = 3;
/// Coefficients of a series that are computed.
const PRECISION: usize = 6;

/// A proof of a limit from one side by what lies beside it.
pub(super) fn one_side(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
    steps: u64,
) -> Option<SideArgument> {
    if roots(state.scope).is_empty() && !has_cases(state, &limit.expr) {
        return None;
    }
    POWERS.iter().find_map(|&power| {
        let germs = Germs::new(state, side, steps).along(power);
        let exact = series(state, side, power);
        if let Some(value) = exact.value(&limit.expr) {
            return within(limit, side, &value, [&exact, &exact], &germs, steps);
        }
        let mut adjoined = series(state, side, power);
        for _ in 0..ADJOINED {
            if adjoined.value(&limit.expr).is_some() || !adjoined.numbers.adjoin() {
                break;
            }
        }
        let formal = adjoined.value(&limit.expr);
        let formal = formal
            .and_then(|value| within(limit, side, &value, [&adjoined, &exact], &germs, steps));
        formal.or_else(|| {
            [Rough::Above, Rough::Below].into_iter().find_map(|rough| {
                let mut estimated = series(state, side, power);
                estimated.numbers.estimate_roots(rough);
                let value = estimated.value(&limit.expr)?;
                within(limit, side, &value, [&estimated, &exact], &germs, steps)
            })
        })
    })
}

/// A proof by quotients that the series of an expression shows, along a germ that is short enough.
fn within(
    limit: &Limit,
    side: &Side,
    value: &Value<Quotient>,
    both: Both<'_, '_, '_, '_>,
    germs: &Germs<'_, '_, '_>,
    steps: u64,
) -> Option<SideArgument> {
    let along = both[0];
    let state = along.numbers.state();
    let senses = match limit.to {
        Target::PlusInf => vec![Ordering::Greater],
        Target::MinusInf => vec![Ordering::Less],
        Target::Finite(_) => vec![Ordering::Greater, Ordering::Less],
    };
    let beside = |&sense: &Ordering| -> Option<(Ordering, Beside)> {
        let (found, order) = quotient(along, limit, value, sense)?;
        let (num, den) = along.numbers.outward(&found)?;
        let end = at_zero(state, limit, side, (&num, &den, order), steps)?;
        Some((sense, Beside { num, den, order, end }))
    };
    let all = senses.iter().map(beside).collect::<Option<Vec<_>>>()?;
    TERMS.iter().find_map(|&terms| {
        let nearness = RefCell::new(Nearness::default());
        let first = germs.within((Poly::one(), Poly::one()))?;
        for (sense, beside) in &all {
            closed(both, limit, &first, beside, *sense, (&nearness, terms), false)?;
        }
        let radius = nearness.borrow().radius(&state.scope.fuel)?;
        let germ = germs.within(along.numbers.outward(&radius)?)?;
        let shown = |sense: Ordering| {
            let beside = &all.iter().find(|one| one.0 == sense)?.1;
            let along = closed(both, limit, &germ, beside, sense, (&nearness, terms), true)?;
            let Beside { num, den, order, end } = beside;
            let (num, den, at_zero) = (num.clone(), den.clone(), end.clone());
            let (germ, order, upper) = (germ.clone(), *order, None);
            Some(SideArgument { germ, num, den, order, sense, along, at_zero, upper })
        };
        between(&limit.to, &shown)
    })
}

/// Series with fractions in constants and their roots.
fn series<'a, 's, 'g>(
    state: &'a State<'s, 'g>,
    side: &'a Side,
    power: u32,
) -> Along<'a, 'g, Symbols<'a, 's, 'g>> {
    let numbers = Symbols::new(state, side.var);
    Along { scope: state.scope, side, power, terms: PRECISION, numbers }
}

/// What an expression of x tends to from one side, as a number in roots that the scope has.
///
/// # Errors
/// The numbers whose roots it takes beside these; none if it does not depend on that.
pub(super) fn value(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
) -> Result<Target, Vec<BigRational>> {
    let mut missing = Vec::new();
    let root = |v: usize| state.scope.root(v).cloned().unwrap_or(Expr::Var(v));
    for power in POWERS {
        let along = series(state, side, power);
        let found = along.value(&limit.expr);
        missing.extend(along.numbers.missing());
        let target = found.and_then(|found| match found {
            Value::Series(s) if s.low < 0 => {
                let is_positive = along.numbers.is_positive(&s.coefficients[0])?;
                Some(if is_positive { Target::PlusInf } else { Target::MinusInf })
            }
            Value::Series(s) if s.low == 0 => {
                let (num, den) = along.numbers.outward(&s.coefficients[0])?;
                Some(Target::Finite(ratio_in((&num, &den), &root)))
            }
            Value::Series(_) | Value::Zero => Some(Target::Finite(Expr::int(0))),
        });
        if let Some(target) = target {
            return Ok(target);
        }
    }
    Err(missing)
}

/// A polynomial in constants whose sign decides how an expression, or the limit that is claimed of it, behaves there.
pub(super) fn undetermined(state: &State<'_, '_>, limit: &Limit, side: &Side) -> Option<Poly> {
    POWERS.iter().find_map(|&power| {
        let along = series(state, side, power);
        if let Target::Finite(to) = &limit.to {
            along.value(to);
        }
        let value = along.value(&limit.expr);
        along.numbers.undetermined().or_else(|| {
            let Some(Value::Series(series)) = value else { return None };
            series.coefficients.iter().take(2).find_map(|c| along.numbers.unsigned(c))
        })
    })
}

/// Whether an expression is no quotient of polynomials, definitions followed.
fn has_cases(state: &State<'_, '_>, e: &Expr) -> bool {
    state
        .scope
        .pieces(e)
        .is_ok_and(|pieces| pieces.iter().filter(|p| p.value.is_some()).count() > 1)
}

/// What may lie below the expression, for `Greater`, or above it, and the order of its denominator.
fn quotient(
    along: &Along<'_, '_, Symbols<'_, '_, '_>>,
    limit: &Limit,
    value: &Value<Quotient>,
    sense: Ordering,
) -> Option<(Quotient, u32)> {
    let numbers = &along.numbers;
    let state = numbers.state();
    let Value::Series(series) = value else {
        return matches!(limit.to, Target::Finite(_))
            .then(|| (numbers.number(&BigRational::zero()), 0));
    };
    if let Target::Finite(_) = limit.to {
        let [start, slope] = [0, 1].map(|n| along.coefficient(series, n));
        let (start, slope) = (start?, slope?);
        if series.low < 0 || !numbers.is_known(&start) {
            return None;
        }
        let margin = numbers.above_adjoined(&numbers.majorant(&slope)?)?;
        let is_known = numbers.is_known(&slope);
        let slope = if is_known { slope } else { numbers.number(&BigRational::zero()) };
        let down = if sense == Ordering::Greater { -1 } else { 1 };
        // twice as much, of estimates
        let down = if numbers.estimates() || !is_known { 2 * down } else { down };
        let minus = numbers.number(&BigRational::from_integer(down.into()));
        let slope = numbers.sum(&slope, &numbers.product(&margin, &minus)?)?;
        return Some((polynomial(state, &[&start, &slope])?, 0));
    }
    let order = u32::try_from(-series.low).ok().filter(|n| *n > 0)?;
    let lead = &series.coefficients[0];
    if numbers.is_positive(lead)? != (sense == Ordering::Greater) {
        return None;
    }
    // nothing is known of roots where it is asked whether that is positive
    let (num, den) = numbers.below_roots(lead)?;
    let power = Poly::power(state.scope.germ(), order);
    let den = den.scale(&2.into()).mul(&power, &state.scope.fuel).ok()?;
    Some(((num, den), order))
}

/// The argument that the expression lies on one side of a quotient along a germ; before the radius is known, what it asks
/// of that.
fn closed(
    both: Both<'_, '_, '_, '_>,
    limit: &Limit,
    germ: &Germ,
    Beside { num, den, .. }: &Beside,
    sense: Ordering,
    (nearness, terms): (&RefCell<Nearness>, u32),
    is_near: bool,
) -> Option<Argument> {
    let state = both[0].numbers.state();
    let wrong = differs(state.scope, &limit.compared(state.scope), (num, den), sense).ok()?;
    let mut there = state.along_unproved(germ).ok()?;
    let before = there.atoms.len();
    let begun = there.with_cases(wrong.clone());
    let mut assumed = Vec::new();
    for formula in 0..there.formulas.len() {
        if let Ok(cases) = there.assume(formula)
            && let [only] = &cases[..]
        {
            assumed.push(formula);
            there = only.clone();
        }
    }
    let own = there.atoms.len();
    let there = there.with_cases(wrong);
    let formula = there.formulas.len() - 1;
    let change = &both[0].numbers.change;
    let close = |case: &State<'_, '_>| {
        let (case, by) = change.case(case)?;
        let envelope = Envelope::new(&case, both, (nearness, is_near), (before, terms))?;
        change.argument(state, envelope.contradiction(own)?, &by)
    };
    let cases = there.assume(formula).ok()?.iter().map(close).collect::<Option<Vec<_>>>()?;
    let end = Argument::Assume { formula, cases };
    let only = |then, formula: usize| Argument::Assume { formula, cases: vec![then] };
    let argument = assumed.into_iter().rev().fold(end, only);
    let proof = summands(&argument) <= MOST && (!is_near || begun.closes(&argument).is_ok());
    proof.then_some(argument)
}

/// Summands of all sums in an argument.
fn summands(argument: &Argument) -> usize {
    match argument {
        Argument::Positive { terms, .. } => terms.len(),
        Argument::Assume { cases, .. } => cases.iter().map(summands).sum(),
        Argument::Split { zero, positive, negative, .. } => {
            [zero, positive, negative].into_iter().map(|then| summands(then)).sum()
        }
        _ => 0,
    }
}
