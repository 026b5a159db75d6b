//! A formula as a program: the operations that a machine carries out, each once.

use std::collections::HashMap;
use std::ops::Range;

use kane_kernel::Rel;
use kane_number::Rational;

/// One operation on the results of earlier ones, named by their index.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// a constant, rounded once
    Number(Rational),
    /// the argument of this index
    Input(usize),
    /// −a, exact
    Neg(usize),
    /// a + b
    Add(usize, usize),
    /// a − b
    Sub(usize, usize),
    /// a·b
    Mul(usize, usize),
    /// a/b
    Div(usize, usize),
    /// √a
    Sqrt(usize),
    /// a·b + c, rounded once
    Fma(usize, usize, usize),
    /// |a|, exact
    Abs(usize),
    /// the smaller of two, exact
    Min(usize, usize),
    /// the larger of two, exact
    Max(usize, usize),
    /// the second operand where the test holds, otherwise the third
    If(Test, usize, usize),
}

/// A condition on results.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Test {
    /// a comparison of two results
    Compare(Rel, usize, usize),
    /// all of them hold; true for none
    All(Vec<Test>),
    /// one of them holds; false for none
    Any(Vec<Test>),
    /// the opposite
    Not(Box<Test>),
}

impl Test {
    /// The results that are compared, in order.
    #[must_use]
    pub fn compared(&self) -> Vec<(Rel, usize, usize)> {
        match self {
            Self::Compare(rel, a, b) => vec![(*rel, *a, *b)],
            Self::All(tests) | Self::Any(tests) => tests.iter().flat_map(Self::compared).collect(),
            Self::Not(test) => test.compared(),
        }
    }

    /// The same test on results that stand elsewhere.
    #[must_use]
    pub fn moved(&self, at: &impl Fn(usize) -> usize) -> Self {
        let all = |tests: &[Self]| tests.iter().map(|test| test.moved(at)).collect();
        match self {
            Self::Compare(rel, a, b) => Self::Compare(*rel, at(*a), at(*b)),
            Self::All(tests) => Self::All(all(tests)),
            Self::Any(tests) => Self::Any(all(tests)),
            Self::Not(test) => Self::Not(Box::new(test.moved(at))),
        }
    }

    /// Whether it holds, given what each comparison gives: `None` is "not known". Where the rest
    /// decides, what is not known does not matter.
    pub fn holds(&self, compare: &impl Fn(Rel, usize, usize) -> Option<bool>) -> Option<bool> {
        let decided = |tests: &[Self], by: bool| {
            let known: Vec<Option<bool>> = tests.iter().map(|test| test.holds(compare)).collect();
            if known.contains(&Some(by)) {
                Some(by)
            } else if known.contains(&None) {
                None
            } else {
                Some(!by)
            }
        };
        match self {
            Self::Compare(rel, a, b) => compare(*rel, *a, *b),
            Self::All(tests) => decided(tests, false),
            Self::Any(tests) => decided(tests, true),
            Self::Not(test) => test.holds(compare).map(|holds| !holds),
        }
    }
}

impl Operation {
    /// The same operation on results that stand elsewhere.
    #[must_use]
    pub fn moved(&self, at: &impl Fn(usize) -> usize) -> Self {
        match self {
            Self::Number(number) => Self::Number(number.clone()),
            Self::Input(input) => Self::Input(*input),
            Self::Neg(a) => Self::Neg(at(*a)),
            Self::Add(a, b) => Self::Add(at(*a), at(*b)),
            Self::Sub(a, b) => Self::Sub(at(*a), at(*b)),
            Self::Mul(a, b) => Self::Mul(at(*a), at(*b)),
            Self::Div(a, b) => Self::Div(at(*a), at(*b)),
            Self::Sqrt(a) => Self::Sqrt(at(*a)),
            Self::Fma(a, b, c) => Self::Fma(at(*a), at(*b), at(*c)),
            Self::Abs(a) => Self::Abs(at(*a)),
            Self::Min(a, b) => Self::Min(at(*a), at(*b)),
            Self::Max(a, b) => Self::Max(at(*a), at(*b)),
            Self::If(test, a, b) => Self::If(test.moved(at), at(*a), at(*b)),
        }
    }

    /// The results that it takes, those of a test left out.
    #[must_use]
    pub fn operands(&self) -> Vec<usize> {
        match *self {
            Self::Number(_) | Self::Input(_) => vec![],
            Self::Neg(a) | Self::Sqrt(a) | Self::Abs(a) => vec![a],
            Self::Add(a, b)
            | Self::Sub(a, b)
            | Self::Mul(a, b)
            | Self::Div(a, b)
            | Self::Min(a, b)
            | Self::Max(a, b)
            | Self::If(_, a, b) => vec![a, b],
            Self::Fma(a, b, c) => vec![a, b, c],
        }
    }

    /// The results that it takes, those that a test compares included.
    pub(crate) fn reads(&self) -> Vec<usize> {
        let mut reads = self.operands();
        if let Self::If(test, ..) = self {
            reads.extend(test.compared().into_iter().flat_map(|(_, a, b)| [a, b]));
        }
        reads
    }

    /// Whether a machine rounds its result.
    #[must_use]
    pub const fn rounds(&self) -> bool {
        matches!(
            self,
            Self::Add(..)
                | Self::Sub(..)
                | Self::Mul(..)
                | Self::Div(..)
                | Self::Sqrt(_)
                | Self::Fma(..)
        )
    }
}

/// Operations in an order in which each follows its operands. What is written twice is one operation.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Program {
    operations: Vec<Operation>,
    spans: Vec<Range<usize>>,
    known: HashMap<Operation, usize>,
}

impl Program {
    /// Without operations.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds an operation, unless it is there, and gives its index; `span` is where it is written.
    pub fn push(&mut self, operation: Operation, span: Range<usize>) -> usize {
        let next = self.operations.len();
        let index = *self.known.entry(operation.clone()).or_insert(next);
        if index == next {
            self.operations.push(operation);
            self.spans.push(span);
        }
        index
    }

    /// The operations.
    #[must_use]
    pub fn operations(&self) -> &[Operation] {
        &self.operations
    }

    /// The operation of an index.
    #[must_use]
    pub fn get(&self, index: usize) -> Option<&Operation> {
        self.operations.get(index)
    }

    /// The bytes of the text where an operation is written; empty if it is from no text.
    #[must_use]
    pub fn span(&self, index: usize) -> Range<usize> {
        self.spans.get(index).cloned().unwrap_or_default()
    }

    /// Which operations a result needs, itself and what tests compare included.
    #[must_use]
    pub fn needed(&self, root: usize) -> Vec<bool> {
        self.needed_by(&[root])
    }

    /// Which operations some results need.
    #[must_use]
    pub(crate) fn needed_by(&self, roots: &[usize]) -> Vec<bool> {
        let mut needed = vec![false; self.operations.len()];
        let mut todo = roots.to_vec();
        while let Some(index) = todo.pop() {
            let Some(seen) = needed.get_mut(index) else { continue };
            if !*seen {
                *seen = true;
                let Some(operation) = self.operations.get(index) else { continue };
                todo.extend(operation.reads());
            }
        }
        needed
    }

    /// How often each result is read by those operations that a result needs.
    #[must_use]
    pub(crate) fn uses(&self, root: usize) -> Vec<usize> {
        let mut uses = vec![0; self.operations.len()];
        let needed = self.needed(root);
        for (operation, _) in self.operations.iter().zip(&needed).filter(|(_, needed)| **needed) {
            for index in operation.reads() {
                if let Some(uses) = uses.get_mut(index) {
                    *uses += 1;
                }
            }
        }
        uses
    }

    /// The constant that an operation is, if it is one.
    #[must_use]
    pub fn number(&self, index: usize) -> Option<&Rational> {
        match self.operations.get(index) {
            Some(Operation::Number(number)) => Some(number),
            _ => None,
        }
    }
}
