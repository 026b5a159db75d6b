//! Where an expression has a value, and of which sign, by what is declared.

use kane_kernel::{Bound, Expr};
use num_traits::{Signed as _, Zero as _};

use super::super::template::parameter;
use super::Scope;

impl Scope {
    /// Whether an expression has a value at all points of the declared domain, for reasons that are
    /// seen at once: it is a polynomial in plain symbols, divided by products of numbers and of symbols
    /// whose bounds exclude 0. Of indices it may speak of this one; of functions and angles of none.
    #[must_use]
    pub fn is_total(&self, e: &Expr, index: Option<usize>) -> bool {
        let mut total = !self.is_exhausted();
        self.visit(e, &mut |node| {
            total &= match node {
                Expr::Var(v) if parameter(*v).is_none() => {
                    let plain = self.context.vars.get(*v).is_some_and(|var| var.of.is_none());
                    let own = self.sequences.index_of(*v).is_none_or(|n| Some(n) == index);
                    let angle = self.angle(*v).is_some() || self.angle_at(*v).is_some();
                    plain && own && !angle
                }
                Expr::Num(_) | Expr::Var(_) | Expr::Let(_) | Expr::Neg(_) => true,
                Expr::Add(..) | Expr::Sub(..) | Expr::Mul(..) => true,
                Expr::Div(_, b) => self.never_vanishes(b),
                Expr::Pow(_, n) => *n >= 0,
                _ => false,
            };
        });
        total && !self.is_exhausted()
    }

    /// Whether an expression has a value whatever its symbols are within their declared bounds, for reasons
    /// that are seen at once: it divides by what never vanishes by what is declared, and has no roots,
    /// cases and derivatives.
    #[must_use]
    pub fn has_value(&self, e: &Expr) -> bool {
        let mut has = !self.is_exhausted();
        self.visit(e, &mut |node| {
            has &= match node {
                Expr::Num(_) | Expr::Var(_) | Expr::Let(_) | Expr::Neg(_) => true,
                Expr::Add(..) | Expr::Sub(..) | Expr::Mul(..) => true,
                Expr::Abs(_) | Expr::Min(..) | Expr::Max(..) => true,
                Expr::Div(_, b) => self.never_vanishes(b),
                Expr::Pow(a, n) => *n >= 0 || self.never_vanishes(a),
                _ => false,
            };
        });
        has && !self.is_exhausted()
    }

    /// Whether it is not 0 by what is declared: a product of numbers and symbols, and of sums of what is
    /// not negative and one of which is positive.
    pub(crate) fn never_vanishes(&self, e: &Expr) -> bool {
        match e {
            Expr::Num(q) => !q.is_zero(),
            Expr::Add(..) | Expr::Sub(..) => self.is_above(e, true),
            Expr::Var(v) => self.context.vars.get(*v).is_some_and(|var| {
                let beyond = |b: &Bound, sign: bool| match b.value.is_zero() {
                    true => b.strict,
                    false => b.value.is_negative() == sign,
                };
                var.lower.as_ref().is_some_and(|bound| beyond(bound, false))
                    || var.upper.as_ref().is_some_and(|bound| beyond(bound, true))
            }),
            Expr::Neg(a) | Expr::Pow(a, _) => self.never_vanishes(a),
            Expr::Mul(a, b) => self.never_vanishes(a) && self.never_vanishes(b),
            _ => false,
        }
    }

    /// Whether it is not negative, or positive, by what is declared.
    #[must_use]
    pub fn is_above(&self, e: &Expr, strictly: bool) -> bool {
        let above = |e: &Expr| self.is_above(e, strictly);
        if let Some(sum) = self.sequences.linear(e) {
            return sum.plus >= i64::from(strictly) && sum.times.values().all(|n| *n >= 0);
        }
        match e {
            Expr::Num(q) => q.is_positive() || !strictly && q.is_zero(),
            Expr::Var(v) => {
                let lower = self.context.vars.get(*v).and_then(|var| var.lower.as_ref());
                lower.is_some_and(|b| match b.value.is_zero() {
                    true => b.strict || !strictly,
                    false => b.value.is_positive(),
                })
            }
            Expr::Add(a, b) => {
                let [a, b] = [a, b].map(|e| (self.is_above(e, false), above(e)));
                a.0 && b.1 || a.1 && b.0
            }
            Expr::Mul(a, b) => above(a) && above(b),
            Expr::Div(a, b) => above(a) && self.is_above(b, true),
            Expr::Pow(a, n) => self.is_above(a, strictly || *n < 0),
            _ => false,
        }
    }
}
