//! The backward pass: how much of each operation's rounding reaches the result.
#![allow(clippy::float_arithmetic, reason = "bounds are floats, rounded upward")]

use kane_number::Interval;

use super::form::Form;
use super::pass::Pass;
use super::upward::{plus, times};
use crate::{Operation, Program};

/// A bound on the error of a result over a box, and how much each input has to do with it.
pub(super) struct Reached {
    /// Σ |∂f/∂vᵢ|·hᵢ, rounded up
    pub(super) error: f64,
    /// per input, by how much it changes the bound, roughly; nothing depends on this but where boxes split
    pub(super) influence: Vec<f64>,
}

/// The mean-value bound. Every derivative is taken over all values between the exact and the computed ones;
/// where there is none, as at the border of cases, an operation counts by its whole error instead of its own
/// rounding.
pub(super) fn reached(program: &Program, pass: &Pass, root: usize, inputs: usize) -> Reached {
    let mut slopes: Vec<Option<Form>> = vec![None; root + 1];
    if let Some(slope) = slopes.get_mut(root) {
        *slope = Some(Form::point(1.0));
    }
    let mut reached = Reached { error: 0.0, influence: vec![0.0; inputs] };
    for index in (0..=root).rev() {
        let Some(slope) = slopes.get_mut(index).and_then(Option::take) else { continue };
        let (Some(known), Some(operation)) = (pass.at(index), program.get(index)) else { continue };
        let own = if known.smooth { known.own } else { known.error };
        if own != 0.0 {
            reached.error = plus(reached.error, times(slope.greatest(), own));
            for (influence, slope) in reached.influence.iter_mut().zip(slope.slopes()) {
                *influence += slope.abs() * own;
            }
        }
        if known.smooth {
            for (operand, factor) in factors(pass, operation, index) {
                let further = match factor {
                    Factor::One => slope.clone(),
                    Factor::MinusOne => slope.neg(),
                    Factor::By(form) => slope.mul(&form),
                };
                if let Some(known) = slopes.get_mut(operand) {
                    *known = Some(match known.take() {
                        Some(before) => before.add(&further),
                        None => further,
                    });
                }
            }
        }
    }
    reached
}

enum Factor {
    One,
    MinusOne,
    By(Form),
}

/// The derivative of an operation by each of its operands.
fn factors(pass: &Pass, operation: &Operation, index: usize) -> Vec<(usize, Factor)> {
    let value = |index: usize| {
        pass.at(index).map_or_else(|| Form::of(Interval::WHOLE), |known| known.between.clone())
    };
    // operands that are known exactly need no derivative
    let mut found = match *operation {
        Operation::Number(_) | Operation::Input(_) => vec![],
        Operation::Neg(a) => vec![(a, Factor::MinusOne)],
        Operation::Add(a, b) => vec![(a, Factor::One), (b, Factor::One)],
        Operation::Sub(a, b) => vec![(a, Factor::One), (b, Factor::MinusOne)],
        Operation::Mul(a, b) => vec![(a, Factor::By(value(b))), (b, Factor::By(value(a)))],
        Operation::Div(a, b) => {
            let reciprocal = value(b).reciprocal();
            // −(a/b)/b
            let quotient = value(index).mul(&reciprocal).neg();
            vec![(a, Factor::By(reciprocal)), (b, Factor::By(quotient))]
        }
        Operation::Sqrt(a) => {
            // 1/(2·√a)
            let root = value(index).within(value(a).sqrt().range);
            vec![(a, Factor::By(root.reciprocal().mul(&Form::point(0.5))))]
        }
        Operation::Fma(a, b, c) => {
            vec![(a, Factor::By(value(b))), (b, Factor::By(value(a))), (c, Factor::One)]
        }
        Operation::Abs(a) => {
            let range = value(a).range;
            let factor = if range.lower() >= 0.0 {
                Factor::One
            } else if range.upper() <= 0.0 {
                Factor::MinusOne
            } else {
                Factor::By(Form::of(Interval::between(-1.0, 1.0)))
            };
            vec![(a, factor)]
        }
        Operation::Min(a, b) | Operation::Max(a, b) => {
            let (first, second) = (value(a).range, value(b).range);
            let is_min = matches!(operation, Operation::Min(..));
            if (first.upper() < second.lower()) == is_min && first.intersection(&second).is_none() {
                vec![(a, Factor::One)]
            } else if first.intersection(&second).is_none() {
                vec![(b, Factor::One)]
            } else {
                let some = || Factor::By(Form::of(Interval::between(0.0, 1.0)));
                vec![(a, some()), (b, some())]
            }
        }
        Operation::If(ref test, a, b) => {
            // smooth, so that the test is decided
            let (exact, ..) = pass.test(test);
            vec![(if exact == Some(true) { a } else { b }, Factor::One)]
        }
    };
    found.retain(|(operand, _)| pass.at(*operand).is_some_and(|known| known.error != 0.0));
    found
}
