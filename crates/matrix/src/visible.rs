//! Conditions on a quantity in symbols, freed of what visibly has a sign.

use kane_algebra::ring::common_sign;
use kane_kernel::{Context, Expr, Poly, Rel, Relation, exponent};
use num_bigint::BigInt;
use num_traits::Zero;

use crate::setting::Symbolic;

/// A condition after simplification.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// it holds everywhere
    Always,
    /// it holds nowhere
    Never,
    /// it holds where this does
    Where(Relation),
}

/// What can be read off the ranges of symbols.
#[derive(Clone, Debug)]
pub struct Ranges {
    /// symbols > 0
    positive: Vec<usize>,
    /// symbols ≥ 0
    not_negative: Vec<usize>,
    /// polynomials > 0, by what is asked
    asked: Vec<Poly>,
}

impl Ranges {
    /// Reads the ranges of a context.
    #[must_use]
    pub fn of(context: &Context) -> Self {
        let (mut positive, mut not_negative) = (Vec::new(), Vec::new());
        for (index, var) in context.vars.iter().enumerate() {
            match &var.lower {
                Some(bound) if bound.value >= Zero::zero() => {
                    not_negative.push(index);
                    if bound.strict || !bound.value.is_zero() {
                        positive.push(index);
                    }
                }
                _ => {}
            }
        }
        Self { positive, not_negative, asked: Vec::new() }
    }

    /// The same where only points are asked at which a quantity is positive. Its denominator must
    /// visibly be positive.
    #[must_use]
    pub fn asking(mut self, quantity: &Symbolic) -> Self {
        let (num, den) = quantity.fraction();
        if self.sign(&self.stripped(&den)) == Some(true) {
            self.asked.push(self.stripped(&num));
        }
        self
    }

    /// The sign of a polynomial where its coefficients show it: `Some(true)` for > 0 everywhere. A symbol
    /// of either sign may stand there in even powers.
    fn sign(&self, p: &Poly) -> Option<bool> {
        if self.asked.contains(p) {
            return Some(true);
        }
        let strict = |(m, _): (&[kane_kernel::Power], &BigInt)| {
            m.iter().all(|(v, _)| self.positive.contains(v))
        };
        let even = |v: usize| p.terms().all(|(m, _)| exponent(m, v).is_multiple_of(2));
        let known = p.vars().iter().all(|v| self.not_negative.contains(v) || even(*v));
        (known && p.terms().any(strict)).then(|| common_sign(p)).flatten()
    }

    /// The polynomial without the powers of positive symbols that divide it.
    fn stripped(&self, p: &Poly) -> Poly {
        let least = |v: usize| p.terms().map(|(m, _)| exponent(m, v)).min().unwrap_or(0);
        let common: Vec<_> = p
            .vars()
            .into_iter()
            .filter(|v| self.positive.contains(v))
            .map(|v| (v, least(v)))
            .filter(|(_, n)| *n > 0)
            .collect();
        lowered(p, &common).primitive().1
    }

    /// quantity ⋈ 0. Factors and denominators that are visibly positive are left out.
    #[must_use]
    pub fn relation(&self, quantity: &Symbolic, rel: Rel) -> Relation {
        let (num, den) = quantity.fraction();
        let (num, den) = (self.stripped(&num), self.stripped(&den));
        let expr = |p: &Poly| kane_algebra::rational_function::expression(p);
        // 1/den has the sign of den, and no value where that is 0
        if matches!(rel, Rel::Gt | Rel::Lt) && self.sign(&num) == Some(true) {
            return Relation { lhs: expr(&den), rel, rhs: Expr::int(0) };
        }
        let lhs = match self.sign(&den) {
            Some(true) => expr(&num),
            Some(false) => expr(&num.neg()),
            None => Expr::Div(expr(&num).into(), expr(&den).into()),
        };
        Relation { lhs, rel, rhs: Expr::int(0) }
    }

    /// The same, decided if its sign is visible.
    #[must_use]
    pub fn condition(&self, quantity: &Symbolic, rel: Rel) -> Condition {
        let (num, den) = quantity.fraction();
        let (num, den) = (self.stripped(&num), self.stripped(&den));
        let holds = |sign: i8| match rel {
            Rel::Eq => sign == 0,
            Rel::Ne => sign != 0,
            Rel::Lt => sign < 0,
            Rel::Le => sign <= 0,
            Rel::Gt => sign > 0,
            Rel::Ge => sign >= 0,
        };
        let decided = |yes| if yes { Condition::Always } else { Condition::Never };
        let (top, bottom) = (self.sign(&num), self.sign(&den));
        if num.is_empty() && bottom.is_some() {
            return decided(holds(0));
        }
        if let (Some(top), Some(bottom)) = (top, bottom) {
            return decided(holds(if top == bottom { 1 } else { -1 }));
        }
        Condition::Where(self.relation(quantity, rel))
    }

    /// Whether a polynomial visibly does not vanish.
    #[must_use]
    pub fn vanishes_nowhere(&self, p: &Poly) -> bool {
        self.sign(&self.stripped(p)).is_some()
    }
}

/// The relation that holds where another does not.
#[must_use]
pub fn negated(relation: &Relation) -> Relation {
    let rel = match relation.rel {
        Rel::Eq => Rel::Ne,
        Rel::Ne => Rel::Eq,
        Rel::Lt => Rel::Ge,
        Rel::Le => Rel::Gt,
        Rel::Gt => Rel::Le,
        Rel::Ge => Rel::Lt,
    };
    Relation { rel, ..relation.clone() }
}

/// A polynomial divided by a monomial that divides all its terms.
pub(crate) fn lowered(p: &Poly, by: &[(usize, u32)]) -> Poly {
    Poly::sum(p.terms().map(|(m, c)| {
        let rest = m.iter().map(|&(v, n)| (v, n - exponent(by, v)));
        (rest.collect(), c.clone())
    }))
}
