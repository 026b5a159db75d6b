//! A formula with its products fused into the sums that use them.

use crate::{Core, Operation, Program};

/// The formula in which every product that one sum or difference uses, and nothing else, is fused with it, as
/// compilers contract them: a·b + c as fma(a, b, c), a·b − c as fma(a, b, −c), c − a·b as fma(−a, b, c); of two
/// products the first. The same value in exact arithmetic, by definition of the fused operation. `None` if
/// there is none to fuse.
#[must_use]
pub fn fused(core: &Core) -> Option<Core> {
    let operations = core.program.operations();
    let needed = core.program.needed(core.root);
    // what is assumed is not computed
    let uses = core.program.uses(core.root);
    let product = |index: usize| match operations.get(index) {
        Some(&Operation::Mul(a, b)) if uses.get(index) == Some(&1) => Some((a, b)),
        _ => None,
    };
    let mut program = Program::new();
    let mut moved: Vec<usize> = Vec::new();
    let mut any = false;
    for (index, operation) in operations.iter().enumerate() {
        let at = |index: usize| moved.get(index).copied().unwrap_or(0);
        let span = core.program.span(index);
        let is_used = needed.get(index) == Some(&true);
        let fused = match *operation {
            Operation::Add(x, y) if is_used => match (product(x), product(y)) {
                (Some((a, b)), _) => Some(Operation::Fma(at(a), at(b), at(y))),
                (None, Some((a, b))) => Some(Operation::Fma(at(a), at(b), at(x))),
                _ => None,
            },
            Operation::Sub(x, y) if is_used => match (product(x), product(y)) {
                (Some((a, b)), _) => {
                    let c = program.push(Operation::Neg(at(y)), span.clone());
                    Some(Operation::Fma(at(a), at(b), c))
                }
                (None, Some((a, b))) => {
                    let a = program.push(Operation::Neg(at(a)), span.clone());
                    Some(Operation::Fma(a, at(b), at(x)))
                }
                _ => None,
            },
            _ => None,
        };
        any = any || fused.is_some();
        let next = fused.unwrap_or_else(|| operation.moved(&at));
        moved.push(program.push(next, span));
    }
    let at = |index: usize| moved.get(index).copied().unwrap_or(0);
    any.then(|| Core {
        assumed: core.assumed.iter().map(|test| test.moved(&at)).collect(),
        root: at(core.root),
        program,
        ..core.clone()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fpcore;

    fn of(text: &str) -> Option<String> {
        let core = fpcore::read("t", &format!("(FPCore (x y z) {text})")).unwrap().remove(0);
        fused(&core).map(|core| core.text())
    }

    #[test]
    fn products_are_fused_where_one_sum_uses_them() {
        assert_eq!(of("(+ (* x y) z)").unwrap(), "fma(x, y, z)");
        assert_eq!(of("(- (* x y) z)").unwrap(), "fma(x, y, -z)");
        assert_eq!(of("(- z (* x y))").unwrap(), "fma(-x, y, z)");
        assert_eq!(of("(+ (* x y) (* y z))").unwrap(), "fma(x, y, y*z)");
        assert_eq!(of("(let ([t (* x y)]) (/ (+ t z) t))"), None);
        assert_eq!(of("(+ x y)"), None);
    }
}
