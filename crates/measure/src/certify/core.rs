//! Formulas of a document as float programs.

use std::ops::Range;

use kane_floats::{Argument, Core, Operation as Floats, Program as FloatProgram, Test};
use kane_number::Rational;

use crate::{Formula, Operation, Program};

const NOWHERE: Range<usize> = 0..0;

/// The formula with its inputs, ranges and conditions.
pub(super) fn core(formula: &Formula) -> Core {
    let mut program = FloatProgram::new();
    let arguments: Vec<Argument> = formula
        .inputs
        .iter()
        .map(|input| Argument {
            name: input.name.clone(),
            lower: input.lower.clone(),
            upper: input.upper.clone(),
        })
        .collect();
    for index in 0..arguments.len() {
        program.push(Floats::Input(index), NOWHERE);
    }
    let mut assumed = Vec::new();
    let root = copy(&formula.program, &mut program, &mut assumed);
    for condition in &formula.conditions {
        let (lhs, rel, rhs) = condition.sides();
        let (lhs, rhs) =
            (copy(lhs, &mut program, &mut assumed), copy(rhs, &mut program, &mut assumed));
        assumed.push(Test::Compare(rel, lhs, rhs));
    }
    Core {
        name: Some(formula.quantity.clone()),
        arguments,
        assumed,
        precision: None,
        program,
        root,
        properties: Vec::new(),
    }
}

/// Adds the operations of a program, and gives the place of its value. Where no case applies there is no
/// value: that one applies is assumed.
fn copy(from: &Program, to: &mut FloatProgram, assumed: &mut Vec<Test>) -> usize {
    let mut moved: Vec<usize> = Vec::new();
    for operation in from.operations() {
        let at = |index: &usize| moved.get(*index).copied().unwrap_or(0);
        let copied = match operation {
            Operation::Number(number) => Floats::Number(number.clone()),
            Operation::Input(input) => Floats::Input(*input),
            Operation::Neg(a) => Floats::Neg(at(a)),
            Operation::Add(a, b) => Floats::Add(at(a), at(b)),
            Operation::Sub(a, b) => Floats::Sub(at(a), at(b)),
            Operation::Mul(a, b) => Floats::Mul(at(a), at(b)),
            Operation::Div(a, b) => Floats::Div(at(a), at(b)),
            Operation::Sqrt(a) => Floats::Sqrt(at(a)),
            Operation::Abs(a) => Floats::Abs(at(a)),
            Operation::Min(a, b) => Floats::Min(at(a), at(b)),
            Operation::Max(a, b) => Floats::Max(at(a), at(b)),
            Operation::Cases(branches, otherwise) => {
                let tests: Vec<(Test, usize)> = branches
                    .iter()
                    .map(|(guards, value)| {
                        let guard =
                            |(rel, a, b): &(_, usize, usize)| Test::Compare(*rel, at(a), at(b));
                        (Test::All(guards.iter().map(guard).collect()), at(value))
                    })
                    .collect();
                let mut value = otherwise.as_ref().map(at);
                if value.is_none() {
                    assumed.push(Test::Any(tests.iter().map(|(test, _)| test.clone()).collect()));
                }
                for (test, branch) in tests.into_iter().rev() {
                    value = Some(match value {
                        None => branch,
                        Some(other) => to.push(Floats::If(test, branch, other), NOWHERE),
                    });
                }
                let none = || Floats::Number(Rational::from_integer(0.into()));
                moved.push(value.unwrap_or_else(|| to.push(none(), NOWHERE)));
                continue;
            }
        };
        moved.push(to.push(copied, NOWHERE));
    }
    moved.last().copied().unwrap_or(0)
}
