//! Derivatives in lemmas: numbers, with what is known of each. Where an expression is
//! differentiable, the number is its derivative.

use std::rc::Rc;

use kane_kernel::{Expr, Relation, Scope};
use num_traits::Zero;

use super::NotEmitted;
use super::prose::{Prose, arrow, conj};
use super::reify::{Symbols, integer_name};

/// Variables from here on stand for derivatives.
pub(super) const FIRST: usize = usize::MAX / 2;

/// A derivative that a goal mentions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Slope {
    /// what is differentiated, its absolute values, minima and maxima written as cases
    pub(super) f: Expr,
    /// by what
    pub(super) x: usize,
    /// how often, less one
    pub(super) again: usize,
}

impl Slope {
    /// The derivative of an expanded expression.
    pub(super) fn of(f: &Expr, x: usize) -> Result<Self, NotEmitted> {
        if let Expr::Deriv(g, y) = f {
            let inner = Self::of(g, *y)?;
            let again = inner.again + 1;
            return match *y == x {
                true => Ok(Self { again, ..inner }),
                false => Err(NotEmitted::Step("a derivative by one symbol of one by another")),
            };
        }
        Ok(Self { f: smooth(f)?, x, again: 0 })
    }
}

/// An expression to be differentiated: its choices as cases, their guards as they are.
fn smooth(e: &Expr) -> Result<Expr, NotEmitted> {
    let go = |e: &Expr| smooth(e).map(Rc::new);
    Ok(match e {
        Expr::Num(_) | Expr::Var(_) => e.clone(),
        Expr::Neg(a) => Expr::Neg(go(a)?),
        Expr::Add(a, b) => Expr::Add(go(a)?, go(b)?),
        Expr::Sub(a, b) => Expr::Sub(go(a)?, go(b)?),
        Expr::Mul(a, b) => Expr::Mul(go(a)?, go(b)?),
        Expr::Div(a, b) => Expr::Div(go(a)?, go(b)?),
        Expr::Pow(a, n) => Expr::Pow(go(a)?, *n),
        Expr::Abs(_) | Expr::Min(..) | Expr::Max(..) => smooth(&e.as_cases())?,
        Expr::Cases(branches, otherwise) => {
            let mut out = Vec::new();
            for (guards, body) in branches {
                guards.iter().try_for_each(|g| plain(&g.lhs).and_then(|()| plain(&g.rhs)))?;
                out.push((guards.clone(), smooth(body)?));
            }
            Expr::Cases(out, otherwise.as_deref().map(go).transpose()?)
        }
        Expr::Sqrt(_) | Expr::Deriv(..) | Expr::Let(_) => {
            plain(e)?;
            e.clone()
        }
    })
}

/// Whether there are neither roots nor derivatives.
fn plain(e: &Expr) -> Result<(), NotEmitted> {
    match e {
        Expr::Sqrt(_) => Err(NotEmitted::Step("the derivative of a square root")),
        Expr::Deriv(..) => Err(NotEmitted::Step("a derivative inside what is differentiated")),
        Expr::Let(_) => Err(NotEmitted::Symbol),
        other => other.children().into_iter().try_for_each(plain),
    }
}

/// Whether both sides of each guard that is read near a point either do not mention the variable, or
/// visibly differ by something that does. A difference in which the variable cancels is not followed.
pub(super) fn settled(scope: &Scope<'_>, slopes: &[Slope]) -> Result<(), NotEmitted> {
    slopes.iter().try_for_each(|s| guards_settled(scope, &s.f, s.x))
}

fn guards_settled(scope: &Scope<'_>, e: &Expr, x: usize) -> Result<(), NotEmitted> {
    if let Expr::Cases(branches, _) = e {
        for g in branches.iter().flat_map(|b| &b.0) {
            let varies = mentions(&g.lhs, x) || mentions(&g.rhs, x);
            let (left, right) = (scope.pieces(&g.lhs)?, scope.pieces(&g.rhs)?);
            for (a, b) in left.iter().flat_map(|a| right.iter().map(move |b| (a, b))) {
                if let (true, Some(a), Some(b)) = (varies, &a.value, &b.value) {
                    let gap = a.add(&b.neg(), &scope.fuel)?;
                    if gap.num.degree(x) == 0 && gap.den.degree(x) == 0 {
                        return Err(NotEmitted::Step("a guard in which the variable cancels"));
                    }
                }
            }
        }
    }
    e.children().into_iter().try_for_each(|part| guards_settled(scope, part, x))
}

/// Whether an expression mentions a symbol.
pub(super) fn mentions(e: &Expr, x: usize) -> bool {
    matches!(e, Expr::Var(v) if *v == x) || e.children().into_iter().any(|part| mentions(part, x))
}

impl Symbols<'_> {
    /// The variable that stands for a derivative of an expanded expression.
    pub(super) fn slope(&self, f: &Expr, x: usize) -> Result<usize, NotEmitted> {
        let slope = Slope::of(f, x)?;
        let all = self.slopes.as_ref().ok_or(NotEmitted::Step("a derivative along a limit"))?;
        let mut all = all.borrow_mut();
        if let Some(known) = all.iter().position(|s| *s == slope) {
            return Ok(FIRST + known);
        }
        all.push(slope);
        Ok(FIRST + all.len() - 1)
    }

    /// The derivatives that were met so far.
    pub(super) fn slopes(&self) -> Vec<Slope> {
        self.slopes.as_ref().map(|s| s.borrow().clone()).unwrap_or_default()
    }

    /// The derivative that a variable stands for, as data.
    pub(super) fn slope_data(&self, variable: usize) -> Result<String, NotEmitted> {
        let slope = self.slopes().get(variable - FIRST).cloned().ok_or(NotEmitted::Symbol)?;
        let (place, f) = (self.slope_place(variable), self.expr(&slope.f)?);
        Ok(format!("(Deriv {place} {} {} {f})", self.position(slope.x)?, slope.again))
    }

    fn slope_place(&self, variable: usize) -> usize {
        self.order.len() + self.roots.len() + (variable - FIRST)
    }

    /// The names of the derivatives.
    pub(super) fn slope_names(&self) -> Vec<String> {
        (0..self.slopes().len()).map(|i| self.name(FIRST + i)).collect()
    }

    /// That there is such a derivative where the symbols have some values: `slope_exists …`.
    pub(super) fn slopes_exist(&self, values: &str) -> Result<Vec<String>, NotEmitted> {
        let one = |s: &Slope| {
            let (x, f) = (self.position(s.x)?, self.expr(&s.f)?);
            let bound = format!("(proj1 (Nat.ltb_lt {x} (length {values})) eq_refl)");
            Ok(format!("slope_exists {} {x} {f} {values} {bound}", s.again))
        };
        self.slopes().iter().map(one).collect()
    }
}

impl Prose<'_> {
    /// What is known of the derivatives.
    pub(super) fn slopes_known(&self) -> Result<Vec<String>, NotEmitted> {
        let mut out = Vec::new();
        for (i, s) in self.symbols.slopes().iter().enumerate() {
            let (x, value) = ((self.name)(s.x), self.symbols.name(FIRST + i));
            let f = format!("(fun {x} : R => {})", self.term(&s.f)?);
            let says = self.derives(s.again, &f, &x, &value);
            out.push(arrow(&self.near_conditions(&s.f, s.x)?, &says));
        }
        Ok(out)
    }

    fn derives(&self, again: usize, f: &str, x: &str, value: &str) -> String {
        let Some(again) = again.checked_sub(1) else {
            return format!("derivable_pt_lim {f} {x} {value}");
        };
        let fresh = |name: &str| self.symbols.fresh(&integer_name(name, again));
        let (g, d, y) = (fresh("slope_of"), fresh("delta"), fresh(x));
        format!(
            "exists ({g} : R -> R) ({d} : R), 0 < {d} /\\ (forall {y} : R, Rabs ({y} - {x}) < {d} -> \
             derivable_pt_lim {f} {y} ({g} {y})) /\\ {}",
            self.derives(again, &g, x, value)
        )
    }

    /// The conditions under which an expression is differentiable by a symbol, or only continuous.
    pub(super) fn near_conditions(&self, e: &Expr, x: usize) -> Result<Vec<String>, NotEmitted> {
        let mut out = Vec::new();
        match e {
            Expr::Div(a, b) => {
                out.extend(self.near_conditions(a, x)?);
                out.extend(self.near_conditions(b, x)?);
                if !matches!(&**b, Expr::Num(q) if !q.is_zero()) {
                    out.push(format!("{} <> 0", self.term(b)?));
                }
            }
            Expr::Pow(a, n) if *n < 0 => {
                out.extend(self.near_conditions(a, x)?);
                let below = Expr::Pow(a.clone(), n.saturating_neg());
                out.push(format!("{} <> 0", self.term(&below)?));
            }
            Expr::Cases(branches, otherwise) => {
                let mut rest = match otherwise {
                    Some(e) => self.near_conditions(e, x)?,
                    None => vec!["False".to_owned()],
                };
                for (guards, body) in branches.iter().rev() {
                    let mut then = self.near_conditions(body, x)?;
                    for g in guards.iter().rev() {
                        let mut all = self.near_conditions(&g.lhs, x)?;
                        all.extend(self.near_conditions(&g.rhs, x)?);
                        if mentions(&g.lhs, x) || mentions(&g.rhs, x) {
                            all.push(
                                self.relation(&Relation {
                                    rel: kane_kernel::Rel::Ne,
                                    ..g.clone()
                                })?,
                            );
                        }
                        let guard = self.relation(g)?;
                        if !then.is_empty() {
                            all.push(format!("{guard} -> {}", conj(&then)));
                        }
                        if !rest.is_empty() {
                            all.push(format!("~ ({guard}) -> {}", conj(&rest)));
                        }
                        then = all;
                    }
                    rest = then;
                }
                out = rest;
            }
            other => {
                for part in other.children() {
                    out.extend(self.near_conditions(part, x)?);
                }
            }
        }
        Ok(out)
    }
}
