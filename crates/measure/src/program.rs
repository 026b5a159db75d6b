//! A formula as the sequence of operations that its author wrote.

use std::cmp::Ordering;
use std::collections::{BTreeMap, HashMap};

use kane_algebra::syntax::{Notation, compares};
use kane_kernel::{Context, Expr, Rel, Relation};
use kane_number::Rational;

use crate::Arithmetic;

/// The greatest power that is multiplied out.
const MAX_POWER: u32 = 64;

/// One operation on the results of earlier ones, named by their index.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// A constant, rounded once.
    Number(Rational),
    /// The input of this index.
    Input(usize),
    /// −a
    Neg(usize),
    /// a + b
    Add(usize, usize),
    /// a − b
    Sub(usize, usize),
    /// a · b
    Mul(usize, usize),
    /// a / b
    Div(usize, usize),
    /// √a
    Sqrt(usize),
    /// |a|
    Abs(usize),
    /// the smaller of two
    Min(usize, usize),
    /// the larger of two
    Max(usize, usize),
    /// the first branch whose guards all hold, otherwise the last
    Cases(Vec<Branch>, Option<usize>),
}

/// The guards of a branch, as a comparison of two results each, and its value.
pub type Branch = (Vec<(Rel, usize, usize)>, usize);

/// A straight line of operations, the last of which is the value.
///
/// Operations stand as written and in the order of writing; nothing is simplified. A definition is
/// evaluated once and used by name, as its author would, and so is an operation that is repeated
/// literally, which changes no value. aⁿ is formed by repeated squaring, a⁻ⁿ as 1/aⁿ.
#[derive(Clone, Debug)]
pub struct Program {
    operations: Vec<Operation>,
    texts: Vec<String>,
    inputs: usize,
}

/// Why an expression is no straight line of operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unsupported {
    /// a derivative
    Derivative,
    /// a symbol that is neither an input nor given by a formula
    Symbol(usize),
    /// an exponent that is too large to be multiplied out
    Power,
}

impl Program {
    /// Translates an expression, in which `values` stand for symbols and the symbols `inputs` are
    /// the inputs in this order.
    ///
    /// # Errors
    /// [`Unsupported`] for what is no arithmetic.
    pub fn new(
        expr: &Expr,
        context: &Context,
        values: &BTreeMap<usize, Expr>,
        inputs: &[usize],
    ) -> Result<Self, Unsupported> {
        let mut builder = Builder {
            context,
            values,
            inputs,
            operations: vec![],
            texts: vec![],
            known: HashMap::new(),
        };
        let last = builder.expr(expr)?;
        let (mut operations, mut texts) = (builder.operations, builder.texts);
        if last + 1 != operations.len() {
            // the value was formed earlier: say so by an operation that does nothing
            operations.push(Operation::Cases(vec![], Some(last)));
            texts.push(expr.plain(context));
        }
        Ok(Self { operations, texts, inputs: inputs.len() })
    }

    /// The operations.
    #[must_use]
    pub fn operations(&self) -> &[Operation] {
        &self.operations
    }

    /// What the author wrote for the operation of this index.
    #[must_use]
    pub fn text(&self, index: usize) -> &str {
        self.texts.get(index).map_or("", String::as_str)
    }

    /// How many inputs there are.
    #[must_use]
    pub const fn inputs(&self) -> usize {
        self.inputs
    }

    /// The constants, rounded once for many runs.
    pub fn constants<A: Arithmetic>(&self, arithmetic: &A) -> Vec<Option<A::Value>> {
        let constant = |operation: &Operation| match operation {
            Operation::Number(exact) => Some(arithmetic.number(exact)),
            _ => None,
        };
        self.operations.iter().map(constant).collect()
    }

    /// The value, or `None` where there is none.
    pub fn value<A: Arithmetic>(&self, arithmetic: &A, inputs: &[A::Value]) -> Option<A::Value> {
        self.values(arithmetic, &self.constants(arithmetic), inputs).pop().flatten()
    }

    /// The results of all operations, given the constants.
    pub fn values<A: Arithmetic>(
        &self,
        arithmetic: &A,
        constants: &[Option<A::Value>],
        inputs: &[A::Value],
    ) -> Vec<Option<A::Value>> {
        let mut results: Vec<Option<A::Value>> = Vec::with_capacity(self.operations.len());
        for (index, operation) in self.operations.iter().enumerate() {
            let result = match operation {
                Operation::Number(_) => constants.get(index).cloned().flatten(),
                Operation::Input(input) => inputs.get(*input).cloned(),
                other => apply(arithmetic, other, &results),
            };
            results.push(result);
        }
        results
    }
}

fn apply<A: Arithmetic>(
    arithmetic: &A,
    operation: &Operation,
    results: &[Option<A::Value>],
) -> Option<A::Value> {
    let get = |index: &usize| results.get(*index)?.as_ref();
    let choose = |a: &usize, b: &usize, wanted: Ordering| {
        let (a, b) = (get(a)?, get(b)?);
        let order = arithmetic.compare(a, b);
        // of a NaN and a number, either is taken; a NaN stays one as the first operand
        Some(if order.is_none_or(|order| order == wanted) { a.clone() } else { b.clone() })
    };
    match operation {
        Operation::Number(_) | Operation::Input(_) => None,
        Operation::Neg(a) => Some(arithmetic.neg(get(a)?)),
        Operation::Add(a, b) => Some(arithmetic.add(get(a)?, get(b)?)),
        Operation::Sub(a, b) => Some(arithmetic.sub(get(a)?, get(b)?)),
        Operation::Mul(a, b) => Some(arithmetic.mul(get(a)?, get(b)?)),
        Operation::Div(a, b) => arithmetic.div(get(a)?, get(b)?),
        Operation::Sqrt(a) => arithmetic.sqrt(get(a)?),
        Operation::Abs(a) => {
            let a = get(a)?;
            let zero = arithmetic.sub(a, a);
            match arithmetic.compare(a, &zero) {
                Some(Ordering::Less) => Some(arithmetic.neg(a)),
                _ => Some(a.clone()),
            }
        }
        Operation::Min(a, b) => choose(a, b, Ordering::Less),
        Operation::Max(a, b) => choose(a, b, Ordering::Greater),
        Operation::Cases(branches, otherwise) => {
            for (guards, value) in branches {
                let mut all = true;
                for (rel, a, b) in guards {
                    let order = arithmetic.compare(get(a)?, get(b)?);
                    all = all && order.is_some_and(|order| compares(*rel, order));
                }
                if all {
                    return get(value).cloned();
                }
            }
            get(otherwise.as_ref()?).cloned()
        }
    }
}

struct Builder<'a> {
    context: &'a Context,
    values: &'a BTreeMap<usize, Expr>,
    inputs: &'a [usize],
    operations: Vec<Operation>,
    texts: Vec<String>,
    known: HashMap<Operation, usize>,
}

impl Builder<'_> {
    fn push(&mut self, operation: Operation, written: &Expr) -> usize {
        let next = self.operations.len();
        let index = *self.known.entry(operation.clone()).or_insert(next);
        if index == next {
            self.operations.push(operation);
            self.texts.push(written.plain(self.context));
        }
        index
    }

    fn expr(&mut self, expr: &Expr) -> Result<usize, Unsupported> {
        let operation = match expr {
            Expr::Num(exact) => Operation::Number(exact.clone()),
            Expr::Var(symbol) => return self.symbol(expr, *symbol),
            Expr::Let(index) => {
                let definition = self.context.lets.get(*index);
                let definition = definition.ok_or(Unsupported::Symbol(*index))?;
                return self.expr(&definition.body);
            }
            Expr::Neg(a) => Operation::Neg(self.expr(a)?),
            Expr::Add(a, b) => Operation::Add(self.expr(a)?, self.expr(b)?),
            Expr::Sub(a, b) => Operation::Sub(self.expr(a)?, self.expr(b)?),
            Expr::Mul(a, b) => Operation::Mul(self.expr(a)?, self.expr(b)?),
            Expr::Div(a, b) => Operation::Div(self.expr(a)?, self.expr(b)?),
            Expr::Pow(a, exponent) => return self.power(expr, a, *exponent),
            Expr::Abs(a) => Operation::Abs(self.expr(a)?),
            Expr::Min(a, b) => Operation::Min(self.expr(a)?, self.expr(b)?),
            Expr::Max(a, b) => Operation::Max(self.expr(a)?, self.expr(b)?),
            Expr::Sqrt(a) => Operation::Sqrt(self.expr(a)?),
            Expr::Deriv(..) => return Err(Unsupported::Derivative),
            Expr::Cases(branches, otherwise) => {
                let mut all = Vec::new();
                for (guards, value) in branches {
                    let guards: Result<Vec<_>, _> = guards.iter().map(|g| self.guard(g)).collect();
                    all.push((guards?, self.expr(value)?));
                }
                let otherwise = otherwise.as_ref().map(|e| self.expr(e)).transpose()?;
                Operation::Cases(all, otherwise)
            }
        };
        Ok(self.push(operation, expr))
    }

    fn guard(&mut self, guard: &Relation) -> Result<(Rel, usize, usize), Unsupported> {
        Ok((guard.rel, self.expr(&guard.lhs)?, self.expr(&guard.rhs)?))
    }

    fn symbol(&mut self, written: &Expr, symbol: usize) -> Result<usize, Unsupported> {
        if let Some(value) = self.values.get(&symbol) {
            return self.expr(value);
        }
        let input = self.inputs.iter().position(|input| *input == symbol);
        let input = input.ok_or(Unsupported::Symbol(symbol))?;
        Ok(self.push(Operation::Input(input), written))
    }

    fn power(&mut self, written: &Expr, base: &Expr, exponent: i32) -> Result<usize, Unsupported> {
        let mut square = self.expr(base)?;
        let one = Operation::Number(Rational::from_integer(1.into()));
        let mut rest = exponent.unsigned_abs();
        if rest > MAX_POWER {
            return Err(Unsupported::Power);
        }
        let mut result = None;
        while rest > 0 {
            if rest % 2 == 1 {
                result = Some(match result {
                    None => square,
                    Some(product) => self.push(Operation::Mul(product, square), written),
                });
            }
            rest /= 2;
            if rest > 0 {
                square = self.push(Operation::Mul(square, square), written);
            }
        }
        let result = match result {
            Some(result) => result,
            None => self.push(one.clone(), written),
        };
        if exponent >= 0 {
            return Ok(result);
        }
        let one = self.push(one, written);
        Ok(self.push(Operation::Div(one, result), written))
    }
}
