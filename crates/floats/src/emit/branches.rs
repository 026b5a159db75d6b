//! Choices as statements: what one branch needs is computed in that branch.
//!
//! In Python a root of a negative number and a division by 0 raise, so that what is not chosen must not be computed.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::Writer;
use crate::{Operation, Test};

impl Writer<'_> {
    /// The lines of the operations that a function's value needs and the value, choices as statements. `None` if
    /// that would repeat operations without end.
    pub(super) fn by_branches(&self) -> Option<(String, String)> {
        let mut lines = Lines { writer: self, text: String::new(), count: 0 };
        lines.need(self.core.root, &mut BTreeSet::new(), "    ")?;
        Some((lines.text, self.at(self.core.root)))
    }
}

struct Lines<'a> {
    writer: &'a Writer<'a>,
    text: String,
    count: usize,
}

impl Lines<'_> {
    /// Writes what an operation needs, and the operation, unless that is known.
    fn need(&mut self, index: usize, known: &mut BTreeSet<usize>, indent: &str) -> Option<()> {
        let program = &self.writer.core.program;
        let operation = program.get(index)?;
        if matches!(operation, Operation::Number(_) | Operation::Input(_)) || known.contains(&index)
        {
            return Some(());
        }
        self.count += 1;
        if self.count > 4 * program.operations().len() + 100 {
            return None;
        }
        if let Operation::If(test, a, b) = operation {
            self.compared(test, known, indent)?;
            // what both branches need is needed anyway
            let both = program.needed(*a).into_iter().zip(program.needed(*b));
            let both: Vec<usize> =
                both.enumerate().filter(|(_, (a, b))| *a && *b).map(|(index, _)| index).collect();
            for shared in both {
                self.need(shared, known, indent)?;
            }
            let guard = self.writer.guard(test);
            let inner = format!("{indent}    ");
            for (head, branch) in [(format!("if {guard}:"), *a), ("else:".to_owned(), *b)] {
                writeln!(self.text, "{indent}{head}").ok()?;
                self.need(branch, &mut known.clone(), &inner)?;
                let value = self.writer.at(branch);
                writeln!(self.text, "{inner}t{index} = {value}").ok()?;
            }
        } else {
            for operand in operation.operands() {
                self.need(operand, known, indent)?;
            }
            let value = self.writer.operation(operation);
            writeln!(self.text, "{indent}t{index} = {value}").ok()?;
        }
        known.insert(index);
        Some(())
    }

    /// Writes what a test compares, unless a function does.
    fn compared(&mut self, test: &Test, known: &mut BTreeSet<usize>, indent: &str) -> Option<()> {
        for (rel, a, b) in test.compared() {
            if (self.writer.named)(rel, a, b).is_none() {
                self.need(a, known, indent)?;
                self.need(b, known, indent)?;
            }
        }
        Some(())
    }
}
