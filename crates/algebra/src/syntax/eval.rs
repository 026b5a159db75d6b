//! Exact evaluation at a rational point, straight from the definitions.
//!
//! It serves as the second, independent way against which normal forms and certificates are
//! tested, so it shares nothing with them but the abstract syntax.

use std::cmp::Ordering;
use std::collections::HashMap;

use kane_kernel::{Context, Expr, Rel, Relation};
use num_rational::BigRational;
use num_traits::{Signed as _, Zero as _};

use super::jet::Jet;
use super::no_value::{NoValue, both};

/// Derivatives within each other; each doubles the work.
const MAX_DERIVATIVES: usize = 8;

/// The value of the expression where symbol i has the value `point[i]`. Exact.
///
/// Functions are evaluated at the point like constants: `point` holds their values there.
/// Recursion is as deep as the expression is high, definitions expanded.
///
/// # Errors
/// When there is no rational value, or none within the budget. An operand that is surely
/// undefined wins over one that is only out of reach.
pub fn eval(expr: &Expr, context: &Context, point: &[BigRational]) -> Result<BigRational, NoValue> {
    Evaluator::new(context, point).value(expr)
}

/// Whether the relation holds where symbol i has the value `point[i]`. Exact.
///
/// # Errors
/// When a side has no rational value: undefined, or not known, as [`NoValue::is_undefined`] tells.
pub fn holds(
    relation: &Relation,
    context: &Context,
    point: &[BigRational],
) -> Result<bool, NoValue> {
    Evaluator::new(context, point).holds(relation)
}

/// Evaluates at one point, each definition once.
#[derive(Debug)]
pub struct Evaluator<'a> {
    pub(super) context: &'a Context,
    pub(super) point: &'a [BigRational],
    /// values of definitions at the point
    known: HashMap<usize, Result<Jet, NoValue>>,
    /// values of definitions under the present `moved`
    known_moved: HashMap<usize, Result<Jet, NoValue>>,
    /// values at the point of definitions that are continuous there under the present `moved`
    pub(super) known_continuous: HashMap<usize, Result<BigRational, NoValue>>,
    /// symbols under differentiation, outermost first; the level is the position, from 1
    pub(super) moved: Vec<(usize, Jet)>,
}

impl<'a> Evaluator<'a> {
    /// An evaluator at the point where symbol i has the value `point[i]`.
    #[must_use]
    pub fn new(context: &'a Context, point: &'a [BigRational]) -> Self {
        Self {
            context,
            point,
            known: HashMap::new(),
            known_moved: HashMap::new(),
            known_continuous: HashMap::new(),
            moved: Vec::new(),
        }
    }

    /// The value of the expression, as [`eval`].
    ///
    /// # Errors
    /// As [`eval`].
    pub fn value(&mut self, expr: &Expr) -> Result<BigRational, NoValue> {
        self.jet(expr).map(|jet| jet.real().clone())
    }

    /// Whether the relation holds, as [`holds`].
    ///
    /// # Errors
    /// As [`holds`].
    pub fn holds(&mut self, relation: &Relation) -> Result<bool, NoValue> {
        let order = self.compare(&relation.lhs, &relation.rhs)?;
        Ok(compares(relation.rel, order))
    }

    /// Whether all relations hold, read from left to right: those after the first that fails do
    /// not count.
    ///
    /// # Errors
    /// As [`holds`], for the first relation that cannot be told to hold.
    pub fn all_hold(&mut self, relations: &[Relation]) -> Result<bool, NoValue> {
        for relation in relations {
            if !self.holds(relation)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// How two values compare: at the point, and under a derivative near it.
    fn compare(&mut self, a: &Expr, b: &Expr) -> Result<Ordering, NoValue> {
        if !self.moved.is_empty() {
            return self.settled(a, b);
        }
        let (a, b) = self.both(a, b)?;
        Ok(a.real().cmp(b.real()))
    }

    fn both(&mut self, a: &Expr, b: &Expr) -> Result<(Jet, Jet), NoValue> {
        both(self.jet(a), self.jet(b))
    }

    fn jet(&mut self, expr: &Expr) -> Result<Jet, NoValue> {
        match expr {
            Expr::Num(value) => Ok(Jet::Real(value.clone())),
            Expr::Var(index) => self.symbol(*index),
            Expr::Let(index) => self.definition(*index),
            Expr::Neg(a) => Ok(self.jet(a)?.neg()),
            Expr::Add(a, b) => self.both(a, b).and_then(|(a, b)| a.add(b)),
            Expr::Sub(a, b) => self.both(a, b).and_then(|(a, b)| a.add(b.neg())),
            Expr::Mul(a, b) => self.both(a, b).and_then(|(a, b)| a.mul(b)),
            Expr::Div(a, b) => self.quotient(a, b),
            Expr::Pow(a, exponent) => self.jet(a)?.pow(*exponent),
            Expr::Abs(a) => self.magnitude(a),
            Expr::Min(a, b) => self.choose(a, b, Ordering::Less),
            Expr::Max(a, b) => self.choose(a, b, Ordering::Greater),
            Expr::Sqrt(a) => self.root(a),
            Expr::Deriv(f, x) => self.derivative(f, *x),
            Expr::Cases(branches, otherwise) => self.cases(branches, otherwise.as_deref()),
        }
    }

    fn symbol(&self, index: usize) -> Result<Jet, NoValue> {
        let moved = self.moved.iter().rev().find(|(x, _)| *x == index);
        match (moved, self.point.get(index)) {
            (Some((_, jet)), _) => Ok(jet.clone()),
            (None, Some(value)) => Ok(Jet::Real(value.clone())),
            (None, None) => Err(NoValue::Unassigned),
        }
    }

    fn definition(&mut self, index: usize) -> Result<Jet, NoValue> {
        let moving = !self.moved.is_empty();
        let known = if moving { &self.known_moved } else { &self.known };
        if let Some(known) = known.get(&index) {
            return known.clone();
        }
        let context = self.context;
        let definition = context.lets.get(index).ok_or(NoValue::Unassigned)?;
        let result = self.jet(&definition.body);
        let known = if moving { &mut self.known_moved } else { &mut self.known };
        known.insert(index, result.clone());
        result
    }

    fn quotient(&mut self, a: &Expr, b: &Expr) -> Result<Jet, NoValue> {
        let inverse = self.jet(b).and_then(Jet::reciprocal);
        let (a, inverse) = both(self.jet(a), inverse)?;
        a.mul(inverse)
    }

    fn magnitude(&mut self, a: &Expr) -> Result<Jet, NoValue> {
        if self.moved.is_empty() {
            // looked at once: twice would double the work for each magnitude in another
            let a = self.jet(a)?;
            return Ok(if a.real().is_negative() { a.neg() } else { a });
        }
        let order = self.compare(a, &Expr::int(0))?;
        let a = self.jet(a)?;
        Ok(if order.is_lt() { a.neg() } else { a })
    }

    fn root(&mut self, a: &Expr) -> Result<Jet, NoValue> {
        let radicand = self.jet(a)?;
        if !self.moved.is_empty() && radicand.real().is_zero() {
            self.must_vanish(a)?;
        }
        radicand.sqrt()
    }

    fn choose(&mut self, a: &Expr, b: &Expr, wanted: Ordering) -> Result<Jet, NoValue> {
        if self.moved.is_empty() {
            let (a, b) = self.both(a, b)?;
            let order = a.real().cmp(b.real());
            return Ok(if order == wanted { a } else { b });
        }
        // only the branch taken must have a derivative
        let order = self.compare(a, b)?;
        self.jet(if order == wanted { a } else { b })
    }

    fn cases(
        &mut self,
        branches: &[(Vec<Relation>, Expr)],
        otherwise: Option<&Expr>,
    ) -> Result<Jet, NoValue> {
        for (guards, value) in branches {
            if self.all_hold(guards)? {
                return self.jet(value);
            }
        }
        self.jet(otherwise.ok_or(NoValue::NoCase)?)
    }

    fn derivative(&mut self, f: &Expr, x: usize) -> Result<Jet, NoValue> {
        if self.moved.len() == MAX_DERIVATIVES {
            return Err(NoValue::TooLarge);
        }
        let at = self.symbol(x)?;
        let level = self.moved.len() + 1;
        self.moved.push((x, Jet::dual(level, at, Jet::one())));
        let known = std::mem::take(&mut self.known_moved);
        let continuous = std::mem::take(&mut self.known_continuous);
        let result = self.jet(f);
        self.known_moved = known;
        self.known_continuous = continuous;
        self.moved.pop();
        Ok(result?.split(level).1.unwrap_or_else(Jet::zero))
    }
}

/// Whether two values in this order compare as the relation says.
#[must_use]
pub fn compares(rel: Rel, order: Ordering) -> bool {
    match rel {
        Rel::Eq => order.is_eq(),
        Rel::Ne => order.is_ne(),
        Rel::Lt => order.is_lt(),
        Rel::Le => order.is_le(),
        Rel::Gt => order.is_gt(),
        Rel::Ge => order.is_ge(),
    }
}
