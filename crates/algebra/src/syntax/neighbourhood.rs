//! What a guard or a radicand does near a point, for derivatives (the language page, rule 6).
//!
//! Two sides that are continuous and differ keep their order near the point. Where they meet, the
//! order stays only if their difference is free of what is varied; whether it is, is told from the
//! expression as it is written and from its values elsewhere, and is open where these do not agree.

use std::cmp::Ordering;

use kane_kernel::{Context, Expr};
use num_rational::BigRational;
use num_traits::Zero;

use super::eval::Evaluator;
use super::no_value::{NoValue, both};

/// Other values of a symbol that are tried, as distances from the point: numerator, denominator.
const ELSEWHERE: [(i64, i64); 4] = [(1, 4), (-1, 9), (7, 3), (-11, 5)];
/// The same for what has pieces, which may end anywhere. That none ends nearer is a guess.
const NEAR: [(i64, i64); 2] = [(1, 1 << 40), (-1, 1 << 40)];

impl Evaluator<'_> {
    /// How two sides of a guard compare in a neighbourhood of the point.
    pub(super) fn settled(&mut self, a: &Expr, b: &Expr) -> Result<Ordering, NoValue> {
        let (left, right) = both(self.continuous(a), self.continuous(b))?;
        let order = left.cmp(&right);
        if order.is_eq() {
            self.must_agree(a, Some(b))?;
        }
        Ok(order)
    }

    /// Passes if a radicand that is zero at the point is zero near it.
    pub(super) fn must_vanish(&self, a: &Expr) -> Result<(), NoValue> {
        self.must_agree(a, None)
    }

    /// Passes if two expressions that agree at the point are free of what is varied.
    fn must_agree(&self, a: &Expr, b: Option<&Expr>) -> Result<(), NoValue> {
        let varied = self.varied();
        let sides = || [Some(a), b].into_iter().flatten();
        if !sides().any(|side| mentions(self.context, side, &varied)) {
            return Ok(());
        }
        let pieces = sides().any(|side| chooses(self.context, side));
        let steps = if pieces { &NEAR[..] } else { &ELSEWHERE[..] };
        match varied[..] {
            [x] if self.differ(a, b, x, steps) => Err(NoValue::NotDifferentiable),
            _ => Err(NoValue::Unsettled),
        }
    }

    /// Whether two expressions differ somewhere else on the line through the point.
    fn differ(&self, a: &Expr, b: Option<&Expr>, x: usize, steps: &[(i64, i64)]) -> bool {
        let Some(here) = self.point.get(x) else { return false };
        steps.iter().any(|&(n, d)| {
            let mut point = self.point.to_vec();
            point[x] = here + BigRational::new(n.into(), d.into());
            let mut there = Evaluator::new(self.context, &point);
            let right = b.map_or(Ok(BigRational::zero()), |b| there.value(b));
            matches!((there.value(a), right), (Ok(a), Ok(b)) if a != b)
        })
    }

    /// The value at the point of an expression that is continuous there.
    fn continuous(&mut self, e: &Expr) -> Result<BigRational, NoValue> {
        let varied = self.varied();
        if !mentions(self.context, e, &varied) {
            return self.at_rest(e);
        }
        let context = self.context;
        match e {
            Expr::Num(_) | Expr::Var(_) => self.at_rest(e),
            Expr::Let(index) => {
                if let Some(known) = self.known_continuous.get(index) {
                    return known.clone();
                }
                let definition = context.lets.get(*index).ok_or(NoValue::Unassigned)?;
                let value = self.continuous(&definition.body);
                self.known_continuous.insert(*index, value.clone());
                value
            }
            Expr::Sqrt(a) => {
                if self.continuous(a)?.is_zero() {
                    self.must_vanish(a)?;
                }
                self.at_rest(e)
            }
            Expr::Cases(branches, otherwise) => {
                for (guards, value) in branches {
                    if self.all_hold(guards)? {
                        return self.continuous(value);
                    }
                }
                self.continuous(otherwise.as_deref().ok_or(NoValue::NoCase)?)
            }
            Expr::Deriv(_, x) => match varied[..] {
                [moved] if moved == *x => self.at_rest(e),
                _ => self.at_rest(e).and(Err(NoValue::Unsettled)),
            },
            _ => {
                let mut reason = None;
                for part in e.children() {
                    let Err(why) = self.continuous(part) else { continue };
                    if reason.is_none_or(|known: NoValue| !known.is_undefined()) {
                        reason = Some(why);
                    }
                }
                reason.map_or_else(|| self.at_rest(e), Err)
            }
        }
    }

    /// The value with nothing varied.
    fn at_rest(&mut self, e: &Expr) -> Result<BigRational, NoValue> {
        let moved = std::mem::take(&mut self.moved);
        let value = self.value(e);
        self.moved = moved;
        value
    }

    /// The symbols that are varied.
    fn varied(&self) -> Vec<usize> {
        let mut varied: Vec<usize> = self.moved.iter().map(|(x, _)| *x).collect();
        varied.sort_unstable();
        varied.dedup();
        varied
    }
}

fn mentions(context: &Context, e: &Expr, symbols: &[usize]) -> bool {
    any(context, e, &|part| matches!(part, Expr::Var(v) if symbols.contains(v)))
}

/// Whether an expression has pieces.
fn chooses(context: &Context, e: &Expr) -> bool {
    use Expr::{Abs, Cases, Deriv, Max, Min};
    any(context, e, &|part| matches!(part, Abs(_) | Min(..) | Max(..) | Cases(..) | Deriv(..)))
}

fn any(context: &Context, e: &Expr, wanted: &dyn Fn(&Expr) -> bool) -> bool {
    let (mut todo, mut seen) = (vec![e], Vec::new());
    while let Some(e) = todo.pop() {
        if wanted(e) {
            return true;
        }
        if let Expr::Let(index) = e {
            if seen.contains(index) {
                continue;
            }
            seen.push(*index);
            todo.extend(context.lets.get(*index).map(|definition| &definition.body));
        }
        todo.extend(e.children());
    }
    false
}
