//! Formulas over columns of inputs: one operation at a time over all rows, so that what is timed is arithmetic
//! and not the choice of the next operation.

use std::cell::RefCell;
use std::hint::black_box;

use kane_floats::{Core, Operation, Program, Test};
use kane_kernel::Rel;

use crate::chart::FormNumber;
use crate::{Arithmetic, Plain};

/// A formula in one number system, with room for the results of its operations.
pub(super) struct Columns<'a, N> {
    program: &'a Program,
    root: usize,
    needed: Vec<bool>,
    inputs: Vec<Vec<N>>,
    results: RefCell<Vec<Vec<N>>>,
    /// by row, whether every operation had a result
    valid: RefCell<Vec<bool>>,
}

impl<'a, N: FormNumber> Columns<'a, N> {
    /// Takes the inputs, a column an argument, and forms the constants.
    pub(super) fn new(core: &'a Core, inputs: &[Vec<f64>]) -> Self {
        let rows = inputs.first().map_or(1, Vec::len);
        let column = |operation: &Operation| match operation {
            Operation::Number(number) => vec![N::from_rational(number); rows],
            _ => vec![N::small(0); rows],
        };
        Self {
            program: &core.program,
            root: core.root,
            needed: core.program.needed(core.root),
            inputs: inputs.iter().map(|x| x.iter().map(|x| N::of(*x)).collect()).collect(),
            results: RefCell::new(core.program.operations().iter().map(column).collect()),
            valid: RefCell::new(vec![true; rows]),
        }
    }

    /// Evaluates all rows.
    pub(super) fn run(&self) {
        let mut results = self.results.borrow_mut();
        let mut valid = self.valid.borrow_mut();
        valid.fill(true);
        for (index, operation) in self.program.operations().iter().enumerate() {
            if self.needed.get(index) != Some(&true) {
                continue;
            }
            let Some(mut out) = results.get_mut(index).map(std::mem::take) else { continue };
            self.operation(operation, &results, &mut out, &mut valid);
            if let Some(place) = results.get_mut(index) {
                *place = out;
            }
        }
        black_box(&*results);
    }

    fn operation(
        &self,
        operation: &Operation,
        results: &[Vec<N>],
        out: &mut [N],
        valid: &mut [bool],
    ) {
        let arithmetic = Plain::<N>::new();
        let at = |index: usize| results.get(index).map_or(&[][..], Vec::as_slice);
        let is_less =
            |a: &N, b: &N| arithmetic.compare(a, b).is_some_and(std::cmp::Ordering::is_lt);
        match *operation {
            Operation::Number(_) => {}
            Operation::Input(input) => {
                let from = self.inputs.get(input).map_or(&[][..], Vec::as_slice);
                out.iter_mut().zip(from).for_each(|(out, x)| *out = x.clone());
            }
            Operation::Neg(a) => one(out, at(a), |a| arithmetic.neg(a)),
            Operation::Abs(a) => {
                let zero = N::small(0);
                one(out, at(a), |a| if is_less(a, &zero) { arithmetic.neg(a) } else { a.clone() });
            }
            Operation::Add(a, b) => two(out, at(a), at(b), |a, b| arithmetic.add(a, b)),
            Operation::Sub(a, b) => two(out, at(a), at(b), |a, b| arithmetic.sub(a, b)),
            Operation::Mul(a, b) => two(out, at(a), at(b), |a, b| arithmetic.mul(a, b)),
            Operation::Min(a, b) => {
                two(out, at(a), at(b), |a, b| if is_less(b, a) { b.clone() } else { a.clone() });
            }
            Operation::Max(a, b) => {
                two(out, at(a), at(b), |a, b| if is_less(a, b) { b.clone() } else { a.clone() });
            }
            Operation::Div(a, b) => {
                let rows = out.iter_mut().zip(valid).zip(at(a).iter().zip(at(b)));
                for ((out, valid), (a, b)) in rows {
                    match arithmetic.div(a, b) {
                        Some(quotient) => *out = quotient,
                        None => *valid = false,
                    }
                }
            }
            Operation::Sqrt(a) => {
                for ((out, valid), a) in out.iter_mut().zip(valid).zip(at(a)) {
                    match arithmetic.sqrt(a) {
                        Some(root) => *out = root,
                        None => *valid = false,
                    }
                }
            }
            Operation::Fma(a, b, c) => {
                let rows = out.iter_mut().zip(at(a)).zip(at(b).iter().zip(at(c)));
                rows.for_each(|((out, a), (b, c))| *out = a.mul_add(b, c));
            }
            Operation::If(ref test, a, b) => {
                for (row, out) in out.iter_mut().enumerate() {
                    let chosen = if holds(&arithmetic, test, results, row) { a } else { b };
                    if let Some(value) = at(chosen).get(row) {
                        *out = value.clone();
                    }
                }
            }
        }
    }

    /// The values by row, `None` where an operation had none.
    pub(super) fn values(&self) -> Vec<Option<N>> {
        let results = self.results.borrow();
        let values = results.get(self.root).map_or(&[][..], Vec::as_slice);
        let valid = self.valid.borrow();
        values.iter().zip(&*valid).map(|(value, valid)| valid.then(|| value.clone())).collect()
    }
}

fn one<N>(out: &mut [N], a: &[N], of: impl Fn(&N) -> N) {
    out.iter_mut().zip(a).for_each(|(out, a)| *out = of(a));
}

fn two<N>(out: &mut [N], a: &[N], b: &[N], of: impl Fn(&N, &N) -> N) {
    out.iter_mut().zip(a.iter().zip(b)).for_each(|(out, (a, b))| *out = of(a, b));
}

/// Whether a test holds in a row; what a system cannot tell does not.
fn holds<N: FormNumber>(
    arithmetic: &Plain<N>,
    test: &Test,
    results: &[Vec<N>],
    row: usize,
) -> bool {
    let compare = |rel: Rel, a: usize, b: usize| {
        let (a, b) = (results.get(a)?.get(row)?, results.get(b)?.get(row)?);
        let order = arithmetic.compare(a, b);
        Some(order.is_some_and(|order| kane_algebra::syntax::compares(rel, order)))
    };
    test.holds(&compare) == Some(true)
}

#[cfg(test)]
mod tests {
    use super::*;
    use kane_floats::{Runner, fpcore};

    /// Columns and the machine's own runner agree bit by bit.
    #[test]
    fn columns_give_what_the_machine_gives() {
        let texts = [
            "(/ (- (sqrt (+ x 1)) (sqrt y)) (fma x y 1/3))",
            "(if (and (< x y) (not (== y 0))) (fmin x (fabs (- y x))) (fmax y (* x x)))",
        ];
        let x = vec![0.0, 0.1, 1.0, 2.5, 1e10, 3.0];
        let y = vec![0.2, 0.1, 0.0, 7.5, 1e-3, 4.0];
        for text in texts {
            let core = fpcore::read("t", &format!("(FPCore (x y) {text})")).unwrap().remove(0);
            let columns = Columns::<f64>::new(&core, &[x.clone(), y.clone()]);
            columns.run();
            let runner = Runner::<f64>::new(&core.program);
            for ((value, x), y) in columns.values().into_iter().zip(&x).zip(&y) {
                let expected = runner.value(core.root, &[*x, *y]).unwrap();
                assert_eq!(value.map(f64::to_bits), Some(expected.to_bits()), "{text} at {x}, {y}");
            }
        }
    }
}
