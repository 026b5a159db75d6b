//! The cost of a method by counting: operations times weights, in additions of `f64`.

use crate::Operation;

use super::accuracy::program;
use super::method::Method;

/// The weighted count of a form's operations; `None` for a law's own code, where the operations
/// that count are not the ones of the form.
#[must_use]
pub fn cost(method: &Method) -> Option<u64> {
    if method.is_law {
        return None;
    }
    let [add, mul, div, root] = method.system.weights();
    let program = program(method)?;
    let weight = |operation: &Operation| match operation {
        Operation::Add(..) | Operation::Sub(..) => add,
        Operation::Mul(..) => mul,
        Operation::Div(..) => div,
        Operation::Sqrt(_) => root,
        Operation::Number(_) | Operation::Input(_) | Operation::Neg(_) => 0,
        Operation::Abs(_) | Operation::Min(..) | Operation::Max(..) | Operation::Cases(..) => 1,
    };
    Some(program.operations().iter().map(weight).sum())
}
