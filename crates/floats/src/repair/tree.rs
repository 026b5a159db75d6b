//! Formulas as trees, for rewriting.

use std::ops::Range;
use std::rc::Rc;

use kane_algebra::rational_function::RationalFunction;
use kane_kernel::{Context, Expr, Var};
use kane_number::Rational;

use crate::{Core, Operation, Program};

/// A formula without choices. Equal trees are equal formulas.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Tree {
    Number(Rational),
    Input(usize),
    Neg(Box<Tree>),
    Add(Box<Tree>, Box<Tree>),
    Sub(Box<Tree>, Box<Tree>),
    Mul(Box<Tree>, Box<Tree>),
    Div(Box<Tree>, Box<Tree>),
    Sqrt(Box<Tree>),
    Abs(Box<Tree>),
    Fma(Box<Tree>, Box<Tree>, Box<Tree>),
}

/// Trees of more nodes than this are not rewritten.
pub(super) const MOST_NODES: usize = 160;

impl Tree {
    /// The tree of an operation; `None` for choices, and for trees that are too large.
    pub(super) fn of(program: &Program, root: usize) -> Option<Self> {
        let mut trees: Vec<Option<(Self, usize)>> = Vec::new();
        for operation in program.operations().iter().take(root + 1) {
            let tree = Self::one(operation, &trees);
            trees.push(tree.filter(|(_, size)| *size <= MOST_NODES));
        }
        trees.into_iter().nth(root).flatten().map(|(tree, _)| tree)
    }

    fn one(operation: &Operation, trees: &[Option<(Self, usize)>]) -> Option<(Self, usize)> {
        let mut size = 1;
        let mut at = |index: &usize| {
            let (tree, nodes) = trees.get(*index)?.clone()?;
            size += nodes;
            Some(Box::new(tree))
        };
        let tree = match operation {
            Operation::Number(number) => Self::Number(number.clone()),
            Operation::Input(input) => Self::Input(*input),
            Operation::Neg(a) => Self::Neg(at(a)?),
            Operation::Add(a, b) => Self::Add(at(a)?, at(b)?),
            Operation::Sub(a, b) => Self::Sub(at(a)?, at(b)?),
            Operation::Mul(a, b) => Self::Mul(at(a)?, at(b)?),
            Operation::Div(a, b) => Self::Div(at(a)?, at(b)?),
            Operation::Sqrt(a) => Self::Sqrt(at(a)?),
            Operation::Abs(a) => Self::Abs(at(a)?),
            Operation::Fma(a, b, c) => Self::Fma(at(a)?, at(b)?, at(c)?),
            Operation::Min(..) | Operation::Max(..) | Operation::If(..) => return None,
        };
        Some((tree, size))
    }

    /// The parts, in order.
    pub(super) fn parts(&self) -> Vec<&Self> {
        match self {
            Self::Number(_) | Self::Input(_) => vec![],
            Self::Neg(a) | Self::Sqrt(a) | Self::Abs(a) => vec![a],
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => vec![a, b],
            Self::Fma(a, b, c) => vec![a, b, c],
        }
    }

    /// The same with another part at an index.
    pub(super) fn with(&self, index: usize, part: Self) -> Self {
        let mut tree = self.clone();
        let place = match (&mut tree, index) {
            (Self::Neg(a) | Self::Sqrt(a) | Self::Abs(a), 0)
            | (
                Self::Add(a, _)
                | Self::Sub(a, _)
                | Self::Mul(a, _)
                | Self::Div(a, _)
                | Self::Fma(a, ..),
                0,
            ) => a,
            (
                Self::Add(_, b)
                | Self::Sub(_, b)
                | Self::Mul(_, b)
                | Self::Div(_, b)
                | Self::Fma(_, b, _),
                1,
            ) => b,
            (Self::Fma(_, _, c), 2) => c,
            _ => return tree,
        };
        **place = part;
        tree
    }

    pub(super) fn nodes(&self) -> usize {
        1 + self.parts().into_iter().map(Self::nodes).sum::<usize>()
    }

    /// The formula with this value instead.
    pub(super) fn core(&self, like: &Core) -> Core {
        let mut core = Core { program: Program::new(), assumed: Vec::new(), ..like.clone() };
        let nowhere: Range<usize> = 0..0;
        for index in 0..core.arguments.len() {
            core.program.push(Operation::Input(index), nowhere.clone());
        }
        // what is assumed is said in operations of the old program
        let mut moved = Vec::new();
        for operation in like.program.operations() {
            let at = |index: usize| moved.get(index).copied().unwrap_or(0);
            let copied = operation.moved(&at);
            moved.push(if like.assumed.is_empty() {
                0
            } else {
                core.program.push(copied, nowhere.clone())
            });
        }
        let at = |index: usize| moved.get(index).copied().unwrap_or(0);
        core.assumed = like.assumed.iter().map(|test| test.moved(&at)).collect();
        core.root = self.push(&mut core.program);
        core
    }

    fn push(&self, program: &mut Program) -> usize {
        let operation = match self {
            Self::Number(number) => Operation::Number(number.clone()),
            Self::Input(input) => Operation::Input(*input),
            Self::Neg(a) => Operation::Neg(a.push(program)),
            Self::Add(a, b) => Operation::Add(a.push(program), b.push(program)),
            Self::Sub(a, b) => Operation::Sub(a.push(program), b.push(program)),
            Self::Mul(a, b) => Operation::Mul(a.push(program), b.push(program)),
            Self::Div(a, b) => Operation::Div(a.push(program), b.push(program)),
            Self::Sqrt(a) => Operation::Sqrt(a.push(program)),
            Self::Abs(a) => Operation::Abs(a.push(program)),
            Self::Fma(a, b, c) => Operation::Fma(a.push(program), b.push(program), c.push(program)),
        };
        program.push(operation, 0..0)
    }

    /// The formula as one fraction in lowest terms, multiplied out, roots and magnitudes being symbols;
    /// `None` where it is too large.
    pub(super) fn normal(&self) -> Option<Self> {
        let mut symbols: Vec<Self> = Vec::new();
        let expr = self.expr(&mut symbols);
        let var =
            |index: usize| Var { name: format!("v{index}"), of: None, lower: None, upper: None };
        let context = Context { vars: (0..symbols.len()).map(var).collect(), ..Context::default() };
        let function = RationalFunction::from_expr(&expr, &context).ok()?;
        let tree = Self::from_expr(&function.to_expr(), &symbols)?;
        (tree.nodes() <= MOST_NODES).then_some(tree)
    }

    fn expr(&self, symbols: &mut Vec<Self>) -> Expr {
        let mut of = |tree: &Self| Rc::new(tree.expr(symbols));
        match self {
            Self::Number(number) => Expr::Num(number.clone()),
            Self::Neg(a) => Expr::Neg(of(a)),
            Self::Add(a, b) => Expr::Add(of(a), of(b)),
            Self::Sub(a, b) => Expr::Sub(of(a), of(b)),
            Self::Mul(a, b) => Expr::Mul(of(a), of(b)),
            Self::Div(a, b) => Expr::Div(of(a), of(b)),
            Self::Fma(a, b, c) => Expr::Add(Expr::Mul(of(a), of(b)).into(), of(c)),
            Self::Input(_) | Self::Sqrt(_) | Self::Abs(_) => {
                let known = symbols.iter().position(|symbol| symbol == self);
                Expr::Var(known.unwrap_or_else(|| {
                    symbols.push(self.clone());
                    symbols.len() - 1
                }))
            }
        }
    }

    fn from_expr(expr: &Expr, symbols: &[Self]) -> Option<Self> {
        let of = |expr: &Expr| Self::from_expr(expr, symbols).map(Box::new);
        Some(match expr {
            Expr::Num(number) => Self::Number(number.clone()),
            Expr::Var(index) => symbols.get(*index)?.clone(),
            Expr::Neg(a) => Self::Neg(of(a)?),
            Expr::Add(a, b) => Self::Add(of(a)?, of(b)?),
            Expr::Sub(a, b) => Self::Sub(of(a)?, of(b)?),
            Expr::Mul(a, b) => Self::Mul(of(a)?, of(b)?),
            Expr::Div(a, b) => Self::Div(of(a)?, of(b)?),
            Expr::Pow(a, exponent) => {
                let base = of(a)?;
                let times = u32::try_from(*exponent).ok().filter(|n| (1..=12).contains(n))?;
                let mut power = base.clone();
                for _ in 1..times {
                    power = Box::new(Self::Mul(power, base.clone()));
                }
                *power
            }
            _ => return None,
        })
    }
}
