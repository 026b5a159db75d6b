//! Arithmetic of vectors and matrices as they are read, and their functions.

use std::ops::Range;

use kane_kernel::{Expr, Rel, Relation};

use super::error::{SyntaxError, SyntaxErrorKind};
use super::lexer::Token;
use super::links::RelationNode;
use super::logic;
use super::parser::{Node, Parser};
use super::value::{Array, Operator, Shape, Value};

/// Functions of vectors and matrices; a document may use these names for its own.
pub(crate) const FUNCTIONS: [&str; 6] = ["dot", "cross", "norm", "det", "transpose", "inverse"];

/// Operations that the components of a result have on top of those of the operands, at most: the
/// inverse of three rows.
const LEVELS: usize = 8;
/// How often a component stands in a result at most, likewise.
const COPIES: usize = 24;

impl Parser<'_> {
    /// The number that an operand is; a fault and 1 in its place if it is none.
    pub(crate) fn number_of(&mut self, node: Node) -> Expr {
        match *node.value {
            Value::Number(e) => e,
            Value::Array(array) => {
                self.report(SyntaxErrorKind::NotANumber(array.shape.to_string()), node.span);
                Expr::int(1)
            }
        }
    }

    /// Notes that an operation will write out so many parts; the text may not make too many.
    pub(crate) fn charge(&self, parts: usize, span: &Range<usize>) -> Result<(), SyntaxError> {
        match self.scope().charge(parts) {
            true => Ok(()),
            false => Err(SyntaxError { kind: SyntaxErrorKind::TooMuchWritten, span: span.clone() }),
        }
    }

    /// Two operands joined, of which at least one is a vector or a matrix.
    pub(crate) fn operate(
        &mut self,
        operator: Operator,
        left: &Node,
        right: &Node,
    ) -> Result<Node, SyntaxError> {
        let span = left.span.start..right.span.end;
        let height = left.height.max(right.height) + LEVELS;
        self.charge(COPIES * (left.value.size() + right.value.size()), &span)?;
        let scaled = |array: &Array, by: &dyn Fn(Expr) -> Expr| {
            let parts = array.parts.iter().cloned().map(by).collect();
            Some(Array { shape: array.shape, parts })
        };
        let join = |a, b| operator.join(a, b);
        let result = match (operator, &*left.value, &*right.value) {
            (Operator::Plus | Operator::Minus, Value::Array(a), Value::Array(b))
                if a.shape == b.shape =>
            {
                Some(a.with(b, join))
            }
            (Operator::Times, Value::Array(a), Value::Array(b)) => match (a.shape, b.shape) {
                (Shape::Matrix(n), Shape::Vector(m) | Shape::Matrix(m)) if n == m => {
                    Some(a.times(b))
                }
                _ => None,
            },
            (Operator::Times, Value::Number(a), Value::Array(b)) => {
                scaled(b, &|part| join(a.clone(), part))
            }
            (Operator::Times | Operator::Over, Value::Array(a), Value::Number(b)) => {
                scaled(a, &|part| join(part, b.clone()))
            }
            _ => None,
        };
        match result {
            Some(array) => self.build_value(Value::Array(array), span, height),
            None => {
                self.report_operation(operator.sign(), &[left, right], span.clone());
                self.build(Expr::int(1), span, 1)
            }
        }
    }

    fn report_operation(&mut self, what: &'static str, of: &[&Node], span: Range<usize>) {
        let kinds: Vec<String> = of.iter().map(|node| node.value.kind()).collect();
        let of = kinds.join(" and ");
        self.report(SyntaxErrorKind::NoOperation { what, of }, span);
    }

    /// Passes `[a, b]`, `[a, b, c]`, or rows of a matrix, `[[a, b], [c, d]]`.
    pub(crate) fn components(&mut self) -> Result<Node, SyntaxError> {
        let open = self.span();
        self.advance();
        let items = self.nested(|p| {
            let mut items = vec![p.node()?];
            while p.next_item(items.len())? {
                items.push(p.node()?);
            }
            Ok(items)
        })?;
        let end = self.close(Token::CloseBracket, '[', &open)?;
        let span = open.start..end;
        let height = items.iter().map(|item| item.height).max().unwrap_or(0);
        let count = items.len();
        let row = |item: &Node| match &*item.value {
            Value::Array(Array { shape: Shape::Vector(n), parts }) if *n == count => {
                Some(parts.clone())
            }
            _ => None,
        };
        let number = |item: &Node| match &*item.value {
            Value::Number(e) => Some(e.clone()),
            Value::Array(_) => None,
        };
        let fits = (2..=3).contains(&count);
        let array = if let Some(parts) = items.iter().map(number).collect::<Option<Vec<_>>>() {
            Some(Array { shape: Shape::Vector(count), parts })
        } else {
            let rows: Option<Vec<Vec<Expr>>> = items.iter().map(row).collect();
            rows.map(|rows| Array { shape: Shape::Matrix(count), parts: rows.concat() })
        };
        match array.filter(|_| fits) {
            Some(array) => self.build_value(Value::Array(array), span, height),
            None => {
                self.report(SyntaxErrorKind::NoArray, span.clone());
                self.build(Expr::int(1), span, 1)
            }
        }
    }

    /// Passes `dot(a, b)` and its like.
    pub(crate) fn function_of_arrays(&mut self, word: &'static str) -> Result<Node, SyntaxError> {
        let start = self.span().start;
        self.advance();
        let open = self.span();
        self.expect(Token::OpenParen, "`(` after a function's name")?;
        let pair = matches!(word, "dot" | "cross");
        let arguments = self.nested(|p| {
            let mut arguments = vec![p.node()?];
            if pair {
                p.expect(Token::Comma, "`,` and a second argument")?;
                arguments.push(p.node()?);
            }
            Ok(arguments)
        })?;
        let end = self.close(Token::CloseParen, '(', &open)?;
        let span = start..end;
        let height = arguments.iter().map(|a| a.height).max().unwrap_or(0) + LEVELS;
        let parts: usize = arguments.iter().map(|a| a.value.size()).sum();
        self.charge(COPIES * parts, &span)?;
        let values: Vec<&Value> = arguments.iter().map(|a| &*a.value).collect();
        match applied(word, &values) {
            Some(value) => self.build_value(value, span, height),
            None => {
                self.report_operation(word, &arguments.iter().collect::<Vec<_>>(), span.clone());
                self.build(Expr::int(1), span, 1)
            }
        }
    }

    /// The length between bars: that of a vector, or the absolute value of a number.
    pub(crate) fn between_bars(
        &mut self,
        inner: Node,
        span: Range<usize>,
    ) -> Result<Node, SyntaxError> {
        match &*inner.value {
            Value::Number(e) => self.build(Expr::Abs(e.clone().into()), span, inner.height + 1),
            Value::Array(array) => match applied("norm", &[&inner.value]) {
                Some(value) => {
                    self.charge(COPIES * inner.value.size(), &span)?;
                    self.build_value(value, span, inner.height + LEVELS)
                }
                None => {
                    self.report(SyntaxErrorKind::NotANumber(array.shape.to_string()), span.clone());
                    self.build(Expr::int(1), span, 1)
                }
            },
        }
    }

    /// The relations that `left ⋈ right` says: one for numbers; one a component for an equation
    /// between vectors or matrices; for `!=` between them, that one component differs.
    pub(crate) fn compared(
        &mut self,
        left: Node,
        rel: Rel,
        right: Node,
    ) -> Result<Vec<RelationNode>, SyntaxError> {
        let span = left.span.start..right.span.end;
        let height = left.height.max(right.height);
        let node = |relation, height| RelationNode { relation, span: span.clone(), height };
        let each = |a: &Array, b: &Array| -> Vec<Relation> {
            let pairs = a.parts.iter().cloned().zip(b.parts.iter().cloned());
            pairs.map(|(lhs, rhs)| Relation { lhs, rel, rhs }).collect()
        };
        match (*left.value, *right.value) {
            (Value::Number(lhs), Value::Number(rhs)) => {
                Ok(vec![node(Relation { lhs, rel, rhs }, height)])
            }
            (Value::Array(a), Value::Array(b)) if a.shape == b.shape && rel == Rel::Eq => {
                Ok(each(&a, &b).into_iter().map(|relation| node(relation, height)).collect())
            }
            (Value::Array(a), Value::Array(b)) if a.shape == b.shape && rel == Rel::Ne => {
                let differ = each(&a, &b).into_iter().map(|relation| vec![relation]).collect();
                self.within_height(height + 2, &span)?;
                Ok(vec![node(logic::or(differ), height + 2)])
            }
            (a, b) => {
                let of = format!("{} and {}", a.kind(), b.kind());
                let kind = SyntaxErrorKind::NoOperation { what: "a comparison", of };
                self.report(kind, span.clone());
                let one = Relation { lhs: Expr::int(1), rel, rhs: Expr::int(1) };
                Ok(vec![node(one, 1)])
            }
        }
    }
}

/// A function of vectors or matrices; `None` where it is not one of these.
fn applied(word: &str, arguments: &[&Value]) -> Option<Value> {
    let number = |e| Some(Value::Number(e));
    let array = |a| Some(Value::Array(a));
    match (word, arguments) {
        ("dot", [Value::Array(a), Value::Array(b)]) => match (a.shape, b.shape) {
            (Shape::Vector(n), Shape::Vector(m)) if n == m => number(a.dot(b)),
            _ => None,
        },
        ("cross", [Value::Array(a), Value::Array(b)]) => match (a.shape, b.shape) {
            (Shape::Vector(2), Shape::Vector(2)) => number(a.cross_in_the_plane(b)),
            (Shape::Vector(3), Shape::Vector(3)) => array(a.cross(b)),
            _ => None,
        },
        ("cross", [Value::Number(w), Value::Array(a)]) if a.shape == Shape::Vector(2) => {
            array(a.turned(w))
        }
        ("norm", [Value::Array(a)]) if matches!(a.shape, Shape::Vector(_)) => {
            number(Expr::Sqrt(a.dot(a).into()))
        }
        ("det", [Value::Array(a)]) if matches!(a.shape, Shape::Matrix(_)) => number(a.det()),
        ("transpose", [Value::Array(a)]) if matches!(a.shape, Shape::Matrix(_)) => {
            array(a.transpose())
        }
        ("inverse", [Value::Array(a)]) if matches!(a.shape, Shape::Matrix(_)) => array(a.inverse()),
        _ => None,
    }
}
