//! The comparisons of a formula.

use kane_kernel::Rel;

use crate::{Core, Operation, Program, text};

/// A comparison of a formula that rounding may turn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decision {
    /// how they are compared
    pub rel: Rel,
    /// what is compared, as operations of the program
    pub operands: (usize, usize),
}

impl Decision {
    /// Both sides in the usual notation.
    #[must_use]
    pub fn text(&self, core: &Core) -> String {
        let (a, b) = self.operands;
        let side = |index: usize| text::infix(core, index);
        format!("{} {} {}", side(a), text::sign(self.rel), side(b))
    }
}

/// The comparisons on which a formula's value depends, those of inputs with each other and with numbers left
/// out where the machine compares exactly: in order, each once.
#[must_use]
pub fn decisions(core: &Core) -> Vec<Decision> {
    let mut found: Vec<Decision> = Vec::new();
    let (needed, exact) = (core.program.needed(core.root), exact(&core.program));
    let is_exact = |index: usize| exact.get(index) == Some(&true);
    for (operation, _) in core.program.operations().iter().zip(needed).filter(|(_, used)| *used) {
        let Operation::If(test, ..) = operation else { continue };
        for (rel, a, b) in test.compared() {
            let decision = Decision { rel, operands: (a, b) };
            let rounded = !is_exact(a) || !is_exact(b);
            if rounded && !found.contains(&decision) {
                found.push(decision);
            }
        }
    }
    found
}

/// Of which results the machine holds the exact value in every format: inputs, their magnitudes and opposites,
/// small integers, and choices between such. Each is looked at once, however often it is used.
fn exact(program: &Program) -> Vec<bool> {
    let mut exact = Vec::with_capacity(program.operations().len());
    for operation in program.operations() {
        let is_exact = match operation {
            Operation::Input(_) => true,
            Operation::Number(number) => number.is_integer() && number.numer().bits() <= 24,
            Operation::Neg(_) | Operation::Abs(_) | Operation::Min(..) | Operation::Max(..) => {
                operation.operands().iter().all(|index| exact.get(*index) == Some(&true))
            }
            _ => false,
        };
        exact.push(is_exact);
    }
    exact
}
