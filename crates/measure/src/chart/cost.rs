//! The cost of a method by counting: operations times weights, in additions of `f64`.

use crate::Operation;

use super::accuracy::program;
use super::method::{Method, System};

/// What an addition, a multiplication, a division and a root cost in each system, in additions of
/// `f64`. Set once, by the operations of floats that the system's own algorithms are made of; not
/// measured, so that a rank does not depend on a machine.
#[must_use]
pub const fn weights(system: System) -> [u64; 4] {
    match system {
        System::F32 | System::F64 => [1, 1, 4, 5],
        System::DoubleDouble => [20, 25, 45, 50],
        System::Interval => [14, 40, 50, 30],
        System::Rational => [1500, 1500, 1500, 3000],
    }
}

/// The weighted count of a form's operations; `None` for a law's own code, where the operations
/// that count are not the ones of the form.
#[must_use]
pub fn cost(method: &Method) -> Option<u64> {
    if method.is_law {
        return None;
    }
    let [add, mul, div, root] = weights(method.system);
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
