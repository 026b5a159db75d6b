//! Limits of expressions with roots where symbols are about: near its end such an expression lies between lines
//! beside its tangent, whose coefficients are fractions in constants and their roots.

use std::cmp::Ordering;

use kane_kernel::{Expr, Limit, Poly, Side, State, Target};
use num_rational::BigRational;

use super::bounds::at_zero;
use super::germs::Germs;
use super::round::Round;
use super::series::{Along, Numbers as _, Series, Value};
use super::squeeze::{Beside, between, bounded};
use super::symbols::{Quotient, Symbols, polynomial};
use super::variation::{ratio_in, roots};
use crate::argument::SideArgument;

/// Powers of t along which roots are tried.
const POWERS: [u32; 2] = [1, 2];
/// Coefficients of a series that are computed.
const TERMS: usize = 6;
/// Germs that are tried.
const GERMS: usize = 3;
/// Quotients that are tried on each side in a brief round.
const FEW: usize = 3;

/// A quotient beside the expression: its parts, and the order of its denominator.
type Candidate = (Quotient, u32);

/// A proof of a limit from one side by lines.
pub(super) fn one_side(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
    round: Round,
) -> Option<SideArgument> {
    let steps = round.steps;
    if roots(state.scope).is_empty() && !has_cases(state, &limit.expr) {
        return None;
    }
    POWERS.iter().find_map(|&power| {
        let mut along = along(state, side, power);
        let exact = along.value(&limit.expr);
        let value = exact.or_else(|| {
            along.numbers.estimate_roots();
            along.value(&limit.expr)
        })?;
        let lead = along.numbers.lead()?;
        let is_positive = along.numbers.sign(&lead) == Some(true);
        let most = if round.is_brief { FEW } else { usize::MAX };
        let lines = Lines { state, limit, side, steps, along: &along };
        let tried = |sense: Ordering| -> Option<Vec<Beside>> {
            Some(lines.beside(&value, sense)?.into_iter().filter_map(|c| lines.ending(c)).collect())
        };
        let (above, below) = (tried(Ordering::Greater)?, tried(Ordering::Less)?);
        let germs = Germs::new(state, side, steps).along(power);
        germs.near(lead, round.is_brief && is_positive).take(GERMS).find_map(|germ| {
            let shown = |sense: Ordering| {
                let beside = if sense == Ordering::Greater { &above } else { &below };
                beside.iter().take(most).find_map(|b| bounded(state, limit, &germ, b, sense, round))
            };
            between(&limit.to, &shown)
        })
    })
}

/// Series with fractions in constants and their roots.
fn along<'a, 's, 'g>(
    state: &'a State<'s, 'g>,
    side: &'a Side,
    power: u32,
) -> Along<'a, 'g, Symbols<'a, 's, 'g>> {
    let numbers = Symbols::new(state, side.var);
    Along { scope: state.scope, side, power, terms: TERMS, numbers }
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
        let along = along(state, side, power);
        let found = along.value(&limit.expr);
        missing.extend(along.numbers.missing());
        let target = found.and_then(|found| match found {
            Value::Series(s) if s.low < 0 => {
                let is_positive = along.numbers.is_positive(&s.coefficients[0])?;
                Some(if is_positive { Target::PlusInf } else { Target::MinusInf })
            }
            Value::Series(s) if s.low == 0 => {
                let (num, den) = &s.coefficients[0];
                Some(Target::Finite(ratio_in((num, den), &root)))
            }
            Value::Series(_) | Value::Zero => Some(Target::Finite(Expr::int(0))),
        });
        if let Some(target) = target {
            return Ok(target);
        }
    }
    Err(missing)
}

/// Whether an expression is no quotient of polynomials, definitions followed.
fn has_cases(state: &State<'_, '_>, e: &Expr) -> bool {
    state
        .scope
        .pieces(e)
        .is_ok_and(|pieces| pieces.iter().filter(|p| p.value.is_some()).count() > 1)
}

struct Lines<'a, 's, 'g> {
    state: &'a State<'s, 'g>,
    limit: &'a Limit,
    side: &'a Side,
    steps: u64,
    along: &'a Along<'a, 'g, Symbols<'a, 's, 'g>>,
}

impl Lines<'_, '_, '_> {
    fn number(&self, n: i32) -> Quotient {
        self.along.numbers.number(&BigRational::from_integer(n.into()))
    }

    /// What may lie below the expression, for `Greater`, or above it.
    fn beside(&self, value: &Value<Quotient>, sense: Ordering) -> Option<Vec<Candidate>> {
        let zero = (Poly::default(), Poly::one());
        match (&self.limit.to, value) {
            (Target::Finite(_), Value::Zero) => Some(vec![(zero, 0)]),
            (Target::Finite(_), Value::Series(s)) if s.low >= 0 => self.lines(s, sense),
            (Target::Finite(_), _) | (_, Value::Zero) => None,
            (to, Value::Series(s)) => {
                let order = u32::try_from(-s.low).ok().filter(|n| *n > 0)?;
                let (num, den) = &s.coefficients[0];
                let positive = self.along.numbers.is_positive(&s.coefficients[0])?;
                if positive != (*to == Target::PlusInf) {
                    return None;
                }
                // half of it is passed
                let fuel = &self.state.scope.fuel;
                let den = den.scale(&2.into());
                let power = Poly::power(self.state.scope.germ(), order);
                Some(vec![((num.clone(), den.mul(&power, fuel).ok()?), order)])
            }
        }
    }

    /// The limit and the tangent, where the next coefficient tells the side; what bends twice as much; and what has twice its
    /// slope, the next coefficient more, or one more.
    fn lines(&self, s: &Series<Quotient>, sense: Ordering) -> Option<Vec<Candidate>> {
        let numbers = &self.along.numbers;
        let side = |c: &Quotient| {
            let sign = || numbers.is_positive(c).or_else(|| numbers.leans(c));
            let sign = if numbers.is_zero(c) { None } else { sign() };
            sign.map(|positive| positive == (sense == Ordering::Greater))
        };
        let [start, slope, bend] = [0, 1, 2].map(|n| self.along.coefficient(s, n));
        let (start, slope) = (start?, slope?);
        let bent = |by: &Quotient| Some((polynomial(self.state, &[&start, by])?, 0));
        let mut out = Vec::new();
        let flat = numbers.is_zero(&slope) && bend.as_ref().is_none_or(|b| numbers.is_zero(b));
        if side(&slope) == Some(true) || flat {
            out.push((start.clone(), 0));
        }
        let bend = bend.and_then(|bend| Some((side(&bend)?, bend)));
        if let Some((true, _)) = &bend {
            out.push(bent(&slope)?);
        }
        if let Some((false, bend)) = &bend {
            let twice = numbers.sum(bend, bend)?;
            out.push((polynomial(self.state, &[&start, &slope, &twice])?, 0));
        }
        if side(&slope) == Some(false) {
            out.push(bent(&numbers.sum(&slope, &slope)?)?);
        }
        if let Some((false, bend)) = &bend {
            out.push(bent(&numbers.sum(&slope, bend)?)?);
        }
        let away = self.number(if sense == Ordering::Greater { -1 } else { 1 });
        out.push(bent(&numbers.sum(&slope, &away)?)?);
        Some(out)
    }

    /// A quotient with the argument that it tends to the limit.
    fn ending(&self, ((num, den), order): Candidate) -> Option<Beside> {
        let end = at_zero(self.state, self.limit, self.side, (&num, &den, order), self.steps)?;
        Some(Beside { num, den, order, end })
    }
}
