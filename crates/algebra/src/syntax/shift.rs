//! Limits at a point that is no number: `f -> L as x -> a` is read as the limit of f at a + δ for δ → 0.
//!
//! The symbol δ, `delta_x`, is one of its own without bounds. What is put in is written out: definitions that speak of
//! x, too. Whatever else varies with x, its functions, exponentials, angles and powers, has no value at a + δ in the
//! symbols that there are, and is refused.

use std::ops::Range;

use kane_kernel::{Approach, Expr, Var};
use num_rational::BigRational;
use num_traits::Zero as _;

use super::error::SyntaxErrorKind;
use super::parser::Parser;
use super::rebuild::rebuild;
use super::scope::{DeclareError, Scope};
use super::value::size;

/// What a limit is taken at.
pub(crate) enum Point {
    /// a number, or an infinity
    Fixed(Approach),
    /// an expression, and the side of it: both where there is none
    At(Expr, Option<bool>, Range<usize>),
}

/// The variable of a limit and how it moves, and what is put in the place of another symbol.
pub(crate) struct Motion {
    pub(crate) var: usize,
    pub(crate) at: Approach,
    /// a symbol, and what it is
    pub(crate) put: Option<(usize, Expr)>,
}

impl Scope {
    /// Declares the distance of a symbol from the point to which it tends.
    ///
    /// # Errors
    /// As [`declare`](Self::declare).
    pub fn declare_shift(&mut self, x: usize) -> Result<(), DeclareError> {
        let name = self.context().vars.get(x).map_or("", |var| &var.name);
        let var = Var { name: format!("delta_{name}"), of: None, lower: None, upper: None };
        let symbol = self.declare(var)?;
        self.shifts.insert(x, symbol);
        Ok(())
    }

    /// The symbols that tend to points that are no numbers, each with the symbol for its distance.
    pub fn shifts(&self) -> impl Iterator<Item = (usize, usize)> {
        self.shifts.iter().map(|(x, shift)| (*x, *shift))
    }

    /// The symbol of which this one is the distance from a point, if it is one.
    #[must_use]
    pub fn shifted_by(&self, shift: usize) -> Option<usize> {
        self.shifts().find(|(_, by)| *by == shift).map(|(x, _)| x)
    }

    /// The expression with another in the place of a symbol, definitions that speak of it written out.
    ///
    /// # Errors
    /// Where something else in it varies with the symbol, or too much would be written.
    pub(crate) fn with_value(
        &self,
        e: &Expr,
        x: usize,
        value: &Expr,
    ) -> Result<Expr, SyntaxErrorKind> {
        let refuse = |part: &Expr| {
            use super::notation::Notation as _;
            SyntaxErrorKind::NotShifted(part.plain(self.context()))
        };
        rebuild(e, &mut |part| match part {
            Expr::Var(v) if *v == x => match self.charge(size(value)) {
                true => Ok(Some(value.clone())),
                false => Err(SyntaxErrorKind::TooMuchWritten),
            },
            Expr::Var(_) if self.is_made_of(part, x) => Err(refuse(part)),
            Expr::Deriv(..) if self.is_made_of(part, x) => Err(refuse(part)),
            Expr::Let(i) if self.is_made_of(part, x) => match self.context().lets.get(*i) {
                Some(definition) if self.charge(size(&definition.body)) => {
                    self.with_value(&definition.body, x, value).map(Some)
                }
                _ => Err(SyntaxErrorKind::TooMuchWritten),
            },
            _ => Ok(None),
        })
    }

    /// Whether an expression speaks of a symbol, of a function of it, or of something that stands for an expression
    /// with it: an exponential, a point of an angle, a power, a term or a sum.
    fn is_made_of(&self, e: &Expr, x: usize) -> bool {
        let direct = self.symbols(e);
        let of = |v: usize| self.context().vars.get(v).and_then(|var| var.of) == Some(x);
        let inside = |v: usize| self.exponential_at(v).is_some_and(|known| known.of.contains(x));
        let point = |v: usize| self.angle_at(v).is_some_and(|(theta, _)| theta == x);
        let made = |v: usize| {
            self.sequences().made_of(v).iter().any(|part| self.symbols(part).contains(&x))
        };
        direct.iter().any(|v| *v == x || of(*v) || inside(*v) || point(*v) || made(*v))
    }
}

impl Parser<'_> {
    /// The motion of a symbol towards a point that is no number.
    pub(super) fn shifted(
        &mut self,
        x: usize,
        (point, side, span): (Expr, Option<bool>, Range<usize>),
    ) -> Option<Motion> {
        let scope = self.scope();
        let name = scope.context().vars.get(x).map_or_else(String::new, |var| var.name.clone());
        let mut has_root = false;
        scope.visit(&point, &mut |part| has_root |= matches!(part, Expr::Sqrt(_)));
        let refused = if scope.symbols(&point).is_empty() && !has_root {
            // a number would have a value
            Some(SyntaxErrorKind::NotConstant)
        } else if scope.is_made_of(&point, x) {
            Some(SyntaxErrorKind::PointNotFree(name))
        } else if !self.surrounds(x, &point) {
            Some(SyntaxErrorKind::PointNotInside(name))
        } else if !scope.shifts.contains_key(&x) {
            Some(SyntaxErrorKind::NoShift(name))
        } else {
            None
        };
        if let Some(kind) = refused {
            self.report(kind, span);
            return None;
        }
        let var = *self.scope().shifts.get(&x)?;
        let zero = BigRational::zero();
        let at = match side {
            None => Approach::To(zero),
            Some(true) => Approach::Above(zero),
            Some(false) => Approach::Below(zero),
        };
        let value = Expr::Add(point.into(), Expr::Var(var).into());
        Some(Motion { var, at, put: Some((x, value)) })
    }

    /// Whether a point lies inside the range of a symbol by what is declared.
    fn surrounds(&self, x: usize, point: &Expr) -> bool {
        let vars = &self.scope().context().vars;
        let Some(var) = vars.get(x) else { return false };
        let at = match point {
            Expr::Var(a) => vars.get(*a),
            _ => None,
        };
        let above = |lower: &BigRational| {
            let bound = at.and_then(|a| a.lower.as_ref());
            bound.is_some_and(|b| b.value > *lower || b.strict && b.value == *lower)
        };
        let below = |upper: &BigRational| {
            let bound = at.and_then(|a| a.upper.as_ref());
            bound.is_some_and(|b| b.value < *upper || b.strict && b.value == *upper)
        };
        var.lower.as_ref().is_none_or(|b| above(&b.value))
            && var.upper.as_ref().is_none_or(|b| below(&b.value))
    }
}
