//! Functions by cases: guards, and a rational function under each.

use std::cmp::Ordering;

use kane_kernel::{Approach, Context, Expr, Rel, Relation};
use kane_number::Rational;
use num_traits::Zero;

use crate::limit::{Extended, limit, sign_beside};
use crate::rational_function::{NotRational, RationalFunction};
use crate::sign::compares;

/// The condition `difference ⋈ 0`; it neither holds nor fails where the difference is undefined.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Guard {
    /// left side minus right side
    pub difference: RationalFunction,
    /// how it compares with 0
    pub rel: Rel,
}

/// A rational function in each case: the first branch whose guards all hold, read from left to
/// right. Undefined where none does, and where a guard met on the way is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piecewise {
    /// guards and value, in order; a final branch without guards is the `else`
    pub branches: Vec<(Vec<Guard>, RationalFunction)>,
}

/// A function at a point and beside it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Breakpoint {
    /// limit from below; `None` if the function is undefined there
    pub below: Option<Extended>,
    /// value at the point; `None` if the function is undefined there
    pub value: Option<Rational>,
    /// limit from above; `None` if the function is undefined there
    pub above: Option<Extended>,
}

impl Breakpoint {
    /// Whether both limits exist, are finite, and equal the value.
    #[must_use]
    pub fn is_continuous(&self) -> bool {
        let value = self.value.clone().map(Extended::Finite);
        value.is_some() && self.below == value && self.above == value
    }
}

impl Piecewise {
    /// What an expression says: `cases`, perhaps behind a definition, or a rational function as
    /// the only branch.
    ///
    /// # Errors
    /// When a branch or a side of a guard is not a rational function; cases do not nest.
    pub fn from_expr(expr: &Expr, context: &Context) -> Result<Self, NotRational> {
        let rational = |e: &Expr| RationalFunction::from_expr(e, context);
        let mut expr = expr;
        let mut below = context.lets.len();
        while let Expr::Let(i) = expr {
            let known = context.lets.get(*i).filter(|_| *i < below);
            (expr, below) = (&known.ok_or(NotRational::Unknown)?.body, *i);
        }
        let Expr::Cases(cases, otherwise) = expr else {
            return Ok(Self { branches: vec![(Vec::new(), rational(expr)?)] });
        };
        let guard = |r: &Relation| {
            Ok(Guard { difference: rational(&r.lhs)? - rational(&r.rhs)?, rel: r.rel })
        };
        let mut branches = Vec::new();
        for (guards, body) in cases {
            let guards = guards.iter().map(guard).collect::<Result<_, NotRational>>()?;
            branches.push((guards, rational(body)?));
        }
        if let Some(body) = otherwise {
            branches.push((Vec::new(), rational(body)?));
        }
        Ok(Self { branches })
    }

    /// The exact value where symbol i has the value `point[i]`; `None` where it is undefined.
    #[must_use]
    pub fn eval(&self, point: &[Rational]) -> Option<Rational> {
        let sign = |f: &RationalFunction| f.eval(point).map(|v| v.cmp(&Rational::zero()));
        self.branch(sign)?.eval(point)
    }

    /// The function, of the symbol x alone, at the rational point a and on both sides of it.
    /// Exact and complete.
    ///
    /// # Errors
    /// [`NotRational::TooLarge`]; [`NotRational::Unknown`] if another symbol occurs.
    pub fn at_breakpoint(&self, x: usize, a: &Rational) -> Result<Breakpoint, NotRational> {
        let functions = self.branches.iter().flat_map(|(guards, body)| {
            guards.iter().map(|g| &g.difference).chain(std::iter::once(body))
        });
        if functions.into_iter().any(|f| f.symbols().iter().any(|v| *v != x)) {
            return Err(NotRational::Unknown);
        }
        let mut point = vec![Rational::zero(); x];
        point.push(a.clone());
        Ok(Breakpoint {
            below: self.beside(x, &Approach::Below(a.clone()))?,
            value: self.eval(&point),
            above: self.beside(x, &Approach::Above(a.clone()))?,
        })
    }

    fn beside(&self, x: usize, place: &Approach) -> Result<Option<Extended>, NotRational> {
        let mut failure = None;
        let branch = self.branch(|f| {
            sign_beside(f, x, place).unwrap_or_else(|reason| {
                failure = Some(reason);
                None
            })
        });
        match (branch, failure) {
            (_, Some(reason)) => Err(reason),
            (None, None) => Ok(None),
            (Some(f), None) => Ok(limit(f, x, place)?.and_then(|l| l.at(&[]))),
        }
    }

    /// The branch that applies where guards have these signs.
    fn branch(
        &self,
        mut sign: impl FnMut(&RationalFunction) -> Option<Ordering>,
    ) -> Option<&RationalFunction> {
        'branches: for (guards, body) in &self.branches {
            for guard in guards {
                if !compares(guard.rel, sign(&guard.difference)?) {
                    continue 'branches;
                }
            }
            return Some(body);
        }
        None
    }
}
