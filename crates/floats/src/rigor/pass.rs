//! The forward pass: exact values, computed values, and the distance between them.
#![allow(clippy::float_arithmetic, reason = "bounds are floats, rounded upward")]

use std::fmt;

use kane_kernel::Rel;
use kane_number::{Interval, Number as _, Rational, Rounding, decode, encode};
use num_traits::{Signed as _, Zero as _};

use super::domain::{Cell, Inputs};
use super::form::Form;
use super::upward::{binade, greatest, least, over, plus, power, root, times, widened};
use crate::machine::{Machine, compares, rounded};
use crate::{Operation, Program, Test};

/// What may go wrong beside rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FaultKind {
    /// the result may be beyond the greatest float
    Overflow,
    /// the root is taken of what may be negative
    NegativeRoot,
    /// the divisor may be 0
    DivisionByZero,
}

impl fmt::Display for FaultKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Overflow => "may overflow",
            Self::NegativeRoot => "may be the root of a negative number",
            Self::DivisionByZero => "may divide by 0",
        })
    }
}

/// What is known of an operation over a box.
#[derive(Clone, Debug)]
pub(super) struct Known {
    /// the exact value
    pub(super) exact: Form,
    /// every value between the exact and the computed one
    pub(super) between: Form,
    /// what the machine holds
    pub(super) computed: Interval,
    /// |computed − exact| at most
    pub(super) error: f64,
    /// |rounded − unrounded| of this operation at most
    pub(super) own: f64,
    /// the computed value is a multiple of 2^this
    quantum: i64,
    /// whether the error of the operands passes this operation by a derivative; otherwise `error` is all
    /// that is known, and the operation stands for a number of its own
    pub(super) smooth: bool,
    pub(super) fault: Option<FaultKind>,
}

/// All operations over a box.
pub(super) struct Pass {
    pub(super) known: Vec<Known>,
}

/// A power of two that 0 is a multiple of.
const ANY: i64 = 1 << 20;

/// A constant as every box sees it.
pub(super) fn constant<M: Machine>(number: &Rational) -> Known {
    let float: M = rounded(number);
    let exact = Interval::from_rational(number);
    let computed = Interval::from(float.wide());
    let error = decode(float).map_or(f64::INFINITY, |value| {
        let distance = (value - number).abs();
        if distance.is_zero() { 0.0 } else { encode(&distance, Rounding::Up) }
    });
    let exact = Form::constant(exact);
    Known {
        between: exact.widened(error),
        exact,
        computed,
        error,
        own: error,
        quantum: quantum_of(float.wide(), float.wide(), M::PRECISION, M::LEAST_EXPONENT),
        smooth: true,
        fault: (!float.finite()).then_some(FaultKind::Overflow),
    }
}

/// The greatest q so that every float between two is known to be a multiple of 2^q.
fn quantum_of(lower: f64, upper: f64, precision: u32, least_exponent: i64) -> i64 {
    if lower == 0.0 && upper == 0.0 {
        return ANY;
    }
    if lower == upper && lower.is_finite() {
        let bits = lower.to_bits();
        let fraction = bits & ((1 << 52) - 1);
        let below = if fraction == 0 { 52 } else { i64::from(fraction.trailing_zeros()).min(52) };
        let field = i64::try_from((bits >> 52) & 0x7ff).unwrap_or(0);
        let last = if field == 0 { -1074 } else { field - 1023 - 52 };
        return last + if field == 0 { i64::from(bits.trailing_zeros()) } else { below };
    }
    let least = if lower <= 0.0 && 0.0 <= upper { 0.0 } else { lower.abs().min(upper.abs()) };
    if least == 0.0 {
        return least_exponent;
    }
    (binade(least) - i64::from(precision) + 1).max(least_exponent)
}

/// Half an ulp of the greatest result that is rounded: the most by which rounding moves a number of at most
/// this magnitude.
pub(super) fn half_ulp<M: Machine>(most: f64) -> f64 {
    if most == 0.0 {
        return 0.0;
    }
    if !most.is_finite() {
        return f64::INFINITY;
    }
    // a power of two is a float itself, and what is below it has the ulp of its own binade
    let below = if most.to_bits() & ((1 << 52) - 1) == 0 { most.next_down() } else { most };
    let unit =
        (binade(below.max(f64::from_bits(1))) - i64::from(M::PRECISION) + 1).max(M::LEAST_EXPONENT);
    power(unit - 1)
}

impl Pass {
    /// The forward pass over a box; `constants` are those of [`constant`], by operation.
    pub(super) fn over<M: Machine>(
        program: &Program,
        constants: &[Option<Known>],
        cell: &Cell,
        inputs: Inputs,
    ) -> Self {
        let mut pass = Self { known: Vec::with_capacity(program.operations().len()) };
        for (index, operation) in program.operations().iter().enumerate() {
            let known = match operation {
                Operation::Number(_) => constants.get(index).cloned().flatten(),
                Operation::Input(input) => Some(input_of::<M>(cell, *input, inputs)),
                other => pass.apply::<M>(other),
            };
            pass.known.push(known.unwrap_or_else(|| Known::unknown(FaultKind::Overflow)));
        }
        pass
    }

    pub(super) fn at(&self, index: usize) -> Option<&Known> {
        self.known.get(index)
    }

    fn apply<M: Machine>(&self, operation: &Operation) -> Option<Known> {
        Some(match *operation {
            Operation::Number(_) | Operation::Input(_) => return None,
            Operation::Neg(a) => {
                let a = self.at(a)?;
                Known {
                    exact: a.exact.neg(),
                    between: a.between.neg(),
                    computed: -a.computed,
                    own: 0.0,
                    smooth: true,
                    fault: None,
                    ..*a
                }
            }
            Operation::Abs(a) => {
                let a = self.at(a)?;
                let computed = Form::of(a.computed).abs().range;
                Known {
                    exact: a.exact.abs(),
                    between: a.between.abs(),
                    computed,
                    own: 0.0,
                    smooth: true,
                    fault: None,
                    ..*a
                }
            }
            Operation::Min(a, b) => {
                let (a, b) = (self.at(a)?, self.at(b)?);
                Known {
                    exact: a.exact.min(&b.exact),
                    between: a.between.min(&b.between),
                    computed: Form::of(a.computed).min(&Form::of(b.computed)).range,
                    error: a.error.max(b.error),
                    own: 0.0,
                    quantum: a.quantum.min(b.quantum),
                    smooth: true,
                    fault: None,
                }
            }
            Operation::Max(a, b) => {
                let (a, b) = (self.at(a)?, self.at(b)?);
                Known {
                    exact: a.exact.max(&b.exact),
                    between: a.between.max(&b.between),
                    computed: Form::of(a.computed).max(&Form::of(b.computed)).range,
                    error: a.error.max(b.error),
                    own: 0.0,
                    quantum: a.quantum.min(b.quantum),
                    smooth: true,
                    fault: None,
                }
            }
            Operation::Add(a, b) => self.sum::<M>(self.at(a)?, self.at(b)?, false),
            Operation::Sub(a, b) => self.sum::<M>(self.at(a)?, self.at(b)?, true),
            Operation::Mul(a, b) => {
                let (same, a, b) = (a == b, self.at(a)?, self.at(b)?);
                let (exact, unrounded) = product(a, b, same);
                let carried = carried_by_product(a, b);
                let shift = power_of_two(a).or_else(|| power_of_two(b));
                let quantum = a.quantum + b.quantum;
                rounded_result::<M>(exact, unrounded, carried, quantum, shift)
            }
            Operation::Div(a, b) => quotient::<M>(self.at(a)?, self.at(b)?),
            Operation::Sqrt(a) => square_root::<M>(self.at(a)?),
            Operation::Fma(a, b, c) => {
                let (same, a, b, c) = (a == b, self.at(a)?, self.at(b)?, self.at(c)?);
                let (exact, unrounded) = product(a, b, same);
                let carried = plus(carried_by_product(a, b), c.error);
                let exact = exact.add(&c.exact);
                let quantum = (a.quantum + b.quantum).min(c.quantum);
                rounded_result::<M>(exact, unrounded + c.computed, carried, quantum, None)
            }
            Operation::If(ref test, a, b) => self.choice(test, self.at(a)?, self.at(b)?),
        })
    }

    fn sum<M: Machine>(&self, a: &Known, b: &Known, minus: bool) -> Known {
        let (exact, unrounded) = if minus {
            (a.exact.sub(&b.exact), a.computed - b.computed)
        } else {
            (a.exact.add(&b.exact), a.computed + b.computed)
        };
        let carried = plus(a.error, b.error);
        rounded_result::<M>(exact, unrounded, carried, a.quantum.min(b.quantum), None)
    }

    /// What a comparison gives, exactly and as computed; `None` where that depends on the input. The third
    /// says that both agree at every input.
    fn compare(&self, rel: Rel, a: usize, b: usize) -> Option<(Option<bool>, Option<bool>, bool)> {
        let (a, b) = (self.at(a)?, self.at(b)?);
        let difference = a.exact.sub(&b.exact).range;
        let errors = plus(a.error, b.error);
        let as_computed = (a.computed - b.computed)
            .intersection(&widened(difference, errors))
            .unwrap_or(Interval::WHOLE);
        Some((decided(rel, difference), decided(rel, as_computed), errors == 0.0))
    }

    /// Whether a test holds for exact values, and for computed ones, and whether both always agree.
    pub(super) fn test(&self, test: &Test) -> (Option<bool>, Option<bool>, bool) {
        let exact = test.holds(&|rel, a, b| self.compare(rel, a, b)?.0);
        let computed = test.holds(&|rel, a, b| self.compare(rel, a, b)?.1);
        let agree = test
            .compared()
            .into_iter()
            .all(|(rel, a, b)| self.compare(rel, a, b).is_some_and(|(.., agree)| agree));
        (exact, computed, agree)
    }

    /// The result of a test and two operands. Where computed and exact values may choose differently, their
    /// distance counts as an error.
    fn choice(&self, test: &Test, a: &Known, b: &Known) -> Known {
        let (exact, computed, agree) = self.test(test);
        let one = |chosen: &Known| Known { own: 0.0, smooth: true, fault: None, ..chosen.clone() };
        if exact.is_some() && exact == computed {
            return one(if exact == Some(true) { a } else { b });
        }
        let apart = if agree { 0.0 } else { a.exact.sub(&b.exact).greatest() };
        let error = plus(a.error.max(b.error), apart);
        let exact = match exact {
            Some(true) => a.exact.clone(),
            Some(false) => b.exact.clone(),
            None => a.exact.either(&b.exact),
        };
        Known {
            between: exact.widened(error),
            exact,
            computed: a.computed.hull(&b.computed),
            error,
            own: error,
            quantum: a.quantum.min(b.quantum),
            smooth: false,
            fault: None,
        }
    }

    /// Operations that can go wrong on the way to a result, the first of them, branches that are never taken
    /// left out.
    pub(super) fn fault(&self, program: &Program, root: usize) -> Option<(usize, FaultKind)> {
        let mut reached = vec![false; self.known.len()];
        let mut todo = vec![root];
        let mut first: Option<(usize, FaultKind)> = None;
        while let Some(index) = todo.pop() {
            let Some(seen) = reached.get_mut(index).filter(|seen| !**seen) else { continue };
            *seen = true;
            if let Some(kind) = self.at(index).and_then(|known| known.fault)
                && first.is_none_or(|(known, _)| index < known)
            {
                first = Some((index, kind));
            }
            match program.get(index) {
                Some(Operation::If(test, a, b)) => {
                    todo.extend(test.compared().into_iter().flat_map(|(_, a, b)| [a, b]));
                    let (exact, computed, _) = self.test(test);
                    if exact.is_none() || computed.is_none() || exact != computed {
                        todo.extend([*a, *b]);
                    } else {
                        todo.push(if exact == Some(true) { *a } else { *b });
                    }
                }
                Some(operation) => todo.extend(operation.operands()),
                None => {}
            }
        }
        first
    }
}

impl Known {
    fn unknown(fault: FaultKind) -> Self {
        Self {
            exact: Form::of(Interval::WHOLE),
            between: Form::of(Interval::WHOLE),
            computed: Interval::WHOLE,
            error: f64::INFINITY,
            own: f64::INFINITY,
            quantum: -ANY,
            smooth: false,
            fault: Some(fault),
        }
    }
}

fn input_of<M: Machine>(cell: &Cell, input: usize, inputs: Inputs) -> Known {
    let &(lower, upper) = cell.ends.get(input).unwrap_or(&(0.0, 0.0));
    let exact = Form::input(input, cell.ends.len(), lower, upper);
    let error = match inputs {
        Inputs::Floats => 0.0,
        Inputs::Reals => half_ulp::<M>(lower.abs().max(upper.abs())),
    };
    Known {
        computed: exact.range,
        between: exact.widened(error),
        exact,
        error,
        own: error,
        quantum: quantum_of(lower, upper, M::PRECISION, M::LEAST_EXPONENT),
        smooth: true,
        fault: None,
    }
}

/// The exponent of a constant power of two that is computed exactly.
fn power_of_two(known: &Known) -> Option<i64> {
    let value = known.computed.lower();
    let is_power = value.is_normal() && value.to_bits() & ((1 << 52) - 1) == 0;
    (known.computed.is_point() && known.error == 0.0 && is_power).then(|| binade(value))
}

fn product(a: &Known, b: &Known, same: bool) -> (Form, Interval) {
    if same {
        (a.exact.square(), a.computed.square())
    } else {
        (a.exact.mul(&b.exact), a.computed * b.computed)
    }
}

/// |a′b′ − ab| ≤ |a′|·|b′ − b| + |b|·|a′ − a|, and the same with a and b exchanged.
fn carried_by_product(a: &Known, b: &Known) -> f64 {
    let one = |a: &Known, b: &Known| {
        plus(times(a.between.greatest(), b.error), times(b.exact.greatest(), a.error))
    };
    one(a, b).min(one(b, a))
}

/// a/b: |a′/b′ − a/b| ≤ (|a′ − a| + |a/b|·|b′ − b|)/|b′|.
fn quotient<M: Machine>(a: &Known, b: &Known) -> Known {
    if b.exact.range.contains_zero() || b.computed.contains_zero() {
        return Known::unknown(FaultKind::DivisionByZero);
    }
    let exact = a.exact.div(&b.exact);
    // a path from the exact to the computed divisor may pass 0 though neither end is 0
    let smooth = !b.between.range.contains_zero();
    let divisor = least(if smooth { b.between.range } else { b.computed });
    let carried = over(plus(a.error, times(exact.greatest(), b.error)), divisor);
    let shift = power_of_two(b).map(|exponent| -exponent);
    let quantum = shift.map_or(-ANY, |shift| a.quantum + shift);
    let mut result = rounded_result::<M>(exact, a.computed / b.computed, carried, quantum, shift);
    result.smooth = smooth;
    result
}

/// √a: |√a′ − √a| ≤ |a′ − a|/(√a′ + √a), and ≤ √|a′ − a|.
fn square_root<M: Machine>(a: &Known) -> Known {
    if a.exact.range.lower() < 0.0 || a.computed.lower() < 0.0 {
        return Known::unknown(FaultKind::NegativeRoot);
    }
    let exact = a.exact.sqrt();
    let least_between = a.between.range.lower();
    let smooth = least_between > 0.0;
    let least_root = |x: f64| Interval::from(x.max(0.0)).sqrt().map_or(0.0, |root| root.lower());
    let roots = (least_root(least_between) + least_root(a.exact.range.lower())).next_down();
    let carried = over(a.error, roots.max(0.0)).min(root(a.error));
    let unrounded = a.computed.sqrt().unwrap_or(Interval::WHOLE);
    let mut result = rounded_result::<M>(exact, unrounded, carried, -ANY, None);
    result.smooth = smooth;
    result
}

/// An operation's result, rounded. `carried` is the error that the operands bring, `quantum` says of what
/// power of two the unrounded result is a multiple, and `shift` that the operation is a multiplication by
/// such a power.
fn rounded_result<M: Machine>(
    exact: Form,
    unrounded: Interval,
    carried: f64,
    quantum: i64,
    shift: Option<i64>,
) -> Known {
    let most = greatest(unrounded);
    let precision = i64::from(M::PRECISION);
    let fits = quantum >= M::LEAST_EXPONENT && most <= power(quantum.min(2_000) + precision);
    let own = match shift {
        _ if fits => 0.0,
        Some(shift) if shift >= 0 => 0.0,
        // only subnormal results are rounded
        Some(_) => half_ulp::<M>(most).min(power(M::LEAST_EXPONENT - 1)),
        None => half_ulp::<M>(most),
    };
    let error = plus(carried, own);
    // rounding is monotone, so the ends round to the ends
    let (lower, upper) = (M::nearest(unrounded.lower()), M::nearest(unrounded.upper()));
    let overflows = !lower.finite() || !upper.finite();
    let mut computed = Interval::between(lower.wide(), upper.wide());
    if let Some(both) = computed.intersection(&widened(exact.range, error)) {
        computed = both;
    }
    let after = quantum_of(computed.lower(), computed.upper(), M::PRECISION, M::LEAST_EXPONENT);
    Known {
        between: exact.widened(error),
        exact,
        computed,
        error,
        own,
        // a multiple of a power of two that is rounded stays one
        quantum: if computed.is_point() { after } else { after.max(quantum) },
        smooth: true,
        fault: overflows.then_some(FaultKind::Overflow),
    }
}

/// Whether `difference ⋈ 0` for all, none or some numbers of an interval.
fn decided(rel: Rel, difference: Interval) -> Option<bool> {
    use std::cmp::Ordering;
    let mut possible = Vec::with_capacity(3);
    if difference.lower() < 0.0 {
        possible.push(Ordering::Less);
    }
    if difference.contains_zero() {
        possible.push(Ordering::Equal);
    }
    if difference.upper() > 0.0 {
        possible.push(Ordering::Greater);
    }
    let mut outcomes = possible.into_iter().map(|order| compares(rel, Some(order)));
    let first = outcomes.next()?;
    outcomes.all(|other| other == first).then_some(first)
}
