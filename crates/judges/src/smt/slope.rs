//! Derivatives by the rules of school, and where the language says that there is one.

use std::rc::Rc;

use kane_algebra::syntax::rebuild;
use kane_kernel::{Expr, Rel, Relation};

use super::term::{NotPut, Slopes, Terms, all, any};

/// Definitions inside definitions, followed at most this deep.
const MAX_DEPTH: usize = 64;

impl Terms<'_> {
    /// The derivative of an expression by a symbol.
    pub(super) fn slopes(&self, f: &Expr, x: usize) -> Result<Slopes, NotPut> {
        self.context.vars.get(x).ok_or(NotPut::Symbol)?;
        let f = self.written_out(f, 0)?;
        Ok(Slopes { value: slope(&f, x)?, exists: self.near(&f, &[x], true)? })
    }

    /// An expression with its definitions written out.
    pub(super) fn written_out(&self, e: &Expr, depth: usize) -> Result<Expr, NotPut> {
        rebuild(e, &mut |part| match part {
            Expr::Let(i) if depth < MAX_DEPTH => {
                let body = &self.context.lets.get(*i).ok_or(NotPut::Symbol)?.body;
                self.written_out(body, depth + 1).map(Some)
            }
            Expr::Let(_) => Err(NotPut::TooLarge),
            _ => Ok(None),
        })
    }

    /// Where a relation is true; where it is defined.
    fn holds(&self, lhs: &Expr, rel: Rel, rhs: &Expr) -> Result<String, NotPut> {
        let r = Relation { lhs: lhs.clone(), rel, rhs: rhs.clone() };
        Ok(any(&self.relation(&r)?, |v| *v == Some(true)))
    }

    /// The condition under which an expression is differentiable by some symbols, or at least
    /// continuous in them.
    fn near(&self, e: &Expr, over: &[usize], smooth: bool) -> Result<String, NotPut> {
        let varies = |e: &Expr| over.iter().any(|x| mentions(e, *x));
        let mut conditions = Vec::new();
        match e {
            Expr::Var(v) => {
                let of = self.context.vars.get(*v).ok_or(NotPut::Symbol)?.of;
                if of.is_some_and(|x| over.contains(&x)) {
                    return Err(NotPut::Derivative);
                }
            }
            Expr::Div(a, b) => {
                conditions.push(self.near(a, over, smooth)?);
                conditions.push(self.near(b, over, smooth)?);
                conditions.push(self.holds(b, Rel::Ne, &Expr::int(0))?);
            }
            Expr::Pow(a, n) => {
                conditions.push(self.near(a, over, smooth)?);
                if *n < 0 {
                    conditions.push(self.holds(a, Rel::Ne, &Expr::int(0))?);
                }
            }
            Expr::Sqrt(a) => {
                conditions.push(self.near(a, over, smooth)?);
                let rel = if varies(a) { Rel::Gt } else { Rel::Ge };
                conditions.push(self.holds(a, rel, &Expr::int(0))?);
            }
            Expr::Abs(_) | Expr::Min(..) | Expr::Max(..) if smooth => {
                return self.near(&e.as_cases(), over, smooth);
            }
            Expr::Deriv(f, x) => {
                let mut wider = over.to_vec();
                wider.push(*x);
                return self.near(f, &wider, true);
            }
            Expr::Cases(branches, otherwise) => {
                let mut rest = match otherwise {
                    Some(e) => self.near(e, over, smooth)?,
                    None => "false".to_owned(),
                };
                for (guards, body) in branches.iter().rev() {
                    let mut then = self.near(body, over, smooth)?;
                    for g in guards.iter().rev() {
                        let mut here =
                            vec![self.near(&g.lhs, over, false)?, self.near(&g.rhs, over, false)?];
                        if varies(&g.lhs) || varies(&g.rhs) {
                            here.push(self.holds(&g.lhs, Rel::Ne, &g.rhs)?);
                        }
                        let holds = self.holds(&g.lhs, g.rel, &g.rhs)?;
                        here.push(format!("(ite {holds} {then} {rest})"));
                        then = all(&here);
                    }
                    rest = then;
                }
                return Ok(rest);
            }
            other => {
                for part in other.children() {
                    conditions.push(self.near(part, over, smooth)?);
                }
            }
        }
        conditions.retain(|c| c != "true");
        Ok(all(&conditions))
    }
}

fn mentions(e: &Expr, x: usize) -> bool {
    matches!(e, Expr::Var(v) if *v == x) || e.children().into_iter().any(|part| mentions(part, x))
}

/// Whether a part of a slope is 0, and is no more to be divided by anything: a constant root may be 0 itself.
fn is_zero(e: &Expr) -> bool {
    *e == Expr::int(0)
}

fn add(a: Expr, b: Expr) -> Expr {
    if is_zero(&a) { b } else { Expr::Add(a.into(), b.into()) }
}

fn mul(a: Expr, b: Expr) -> Expr {
    if is_zero(&a) || is_zero(&b) { Expr::int(0) } else { Expr::Mul(a.into(), b.into()) }
}

fn neg(a: Expr) -> Expr {
    if is_zero(&a) { a } else { Expr::Neg(a.into()) }
}

fn over(a: Expr, b: Expr) -> Expr {
    if is_zero(&a) { a } else { Expr::Div(a.into(), b.into()) }
}

/// The derivative of an expression without definitions, on the branch that is taken.
fn slope(e: &Expr, x: usize) -> Result<Expr, NotPut> {
    let go = |e: &Expr| slope(e, x);
    Ok(match e {
        Expr::Num(_) => Expr::int(0),
        Expr::Var(v) => Expr::int(i64::from(*v == x)),
        Expr::Let(_) => return Err(NotPut::Symbol),
        Expr::Neg(a) => neg(go(a)?),
        Expr::Add(a, b) => add(go(a)?, go(b)?),
        Expr::Sub(a, b) => add(go(a)?, neg(go(b)?)),
        Expr::Mul(a, b) => add(mul(go(a)?, (**b).clone()), mul((**a).clone(), go(b)?)),
        Expr::Div(a, b) => {
            let top = add(mul(go(a)?, (**b).clone()), neg(mul((**a).clone(), go(b)?)));
            over(top, Expr::Pow(b.clone(), 2))
        }
        Expr::Pow(a, n) => {
            let below = n.checked_sub(1).ok_or(NotPut::TooLarge)?;
            let power = if *n == 0 { Expr::int(0) } else { Expr::Pow(a.clone(), below) };
            mul(mul(Expr::int((*n).into()), power), go(a)?)
        }
        Expr::Sqrt(a) => over(go(a)?, mul(Expr::int(2), e.clone())),
        Expr::Abs(_) | Expr::Min(..) | Expr::Max(..) => go(&e.as_cases())?,
        Expr::Deriv(f, y) => go(&slope(f, *y)?)?,
        Expr::Cases(branches, otherwise) => {
            let bodies = branches.iter().map(|(guards, body)| Ok((guards.clone(), go(body)?)));
            let bodies: Result<Vec<_>, NotPut> = bodies.collect();
            Expr::Cases(bodies?, otherwise.as_deref().map(go).transpose()?.map(Rc::new))
        }
    })
}
