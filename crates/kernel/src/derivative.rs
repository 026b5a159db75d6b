//! The derivative of an explicit expression, as an expression.

use crate::{Checked, Context, Expr, Fuel, Rejection, Rel, Relation};

/// d f / d x, symbolically; nothing is simplified, so no condition is lost.
///
/// Where two branches of a `cases` meet, or a side of a guard has no derivative, it is undefined.
///
/// # Errors
/// [`Rejection::NotExplicit`] if f contains an undefined function of x; [`Rejection::Budget`].
pub fn derivative(c: &Context, f: &Expr, x: usize, fuel: &Fuel) -> Checked<Expr> {
    diff(c, f, x, fuel, MAX_DEPTH)
}

/// Definitions inside definitions, followed at most this deep.
const MAX_DEPTH: usize = 64;

fn diff(c: &Context, f: &Expr, x: usize, fuel: &Fuel, depth: usize) -> Checked<Expr> {
    fuel.spend(1)?;
    let go = |e: &Expr| Ok(Box::new(diff(c, e, x, fuel, depth)?));
    let times = |a: &Expr, b: &Expr| Box::new(Expr::Mul(a.clone().into(), b.clone().into()));
    Ok(match f {
        Expr::Num(_) => Expr::int(0),
        Expr::Var(v) if *v == x => Expr::int(1),
        Expr::Var(v) => match (c.value(*v), c.vars.get(*v).ok_or(Rejection::UnknownSymbol)?.of) {
            (Some(value), _) => *go(value)?,
            (None, Some(of)) if of == x => return Err(Rejection::NotExplicit),
            (None, _) => Expr::int(0),
        },
        Expr::Let(i) => {
            let body = &c.lets.get(*i).ok_or(Rejection::UnknownSymbol)?.body;
            diff(c, body, x, fuel, depth.checked_sub(1).ok_or(Rejection::Budget)?)?
        }
        Expr::Neg(a) => Expr::Neg(go(a)?),
        Expr::Add(a, b) => Expr::Add(go(a)?, go(b)?),
        Expr::Sub(a, b) => Expr::Sub(go(a)?, go(b)?),
        Expr::Mul(a, b) => Expr::Add(times(&*go(a)?, b), times(a, &*go(b)?)),
        Expr::Div(a, b) => {
            let top = Expr::Sub(times(&*go(a)?, b), times(a, &*go(b)?));
            Expr::Div(top.into(), Expr::Pow(b.clone(), 2).into())
        }
        Expr::Pow(_, 0) => Expr::int(0),
        Expr::Pow(a, n) => {
            let lower = Expr::Pow(a.clone(), n.checked_sub(1).ok_or(Rejection::Budget)?);
            Expr::Mul(times(&Expr::int((*n).into()), &lower), go(a)?)
        }
        Expr::Sqrt(a) => Expr::Div(go(a)?, times(&Expr::int(2), f)),
        Expr::Abs(_) | Expr::Min(..) | Expr::Max(..) => *go(&f.as_cases())?,
        Expr::Deriv(g, y) => *go(&diff(c, g, *y, fuel, depth)?)?,
        Expr::Cases(branches, otherwise) => {
            let pole = Expr::Div(Expr::int(1).into(), Expr::int(0).into());
            let equal = |lhs: &Expr, rhs: &Expr| Relation {
                lhs: lhs.clone(),
                rel: Rel::Eq,
                rhs: rhs.clone(),
            };
            let mut out = Vec::new();
            for (guards, body) in branches {
                for (i, g) in guards.iter().enumerate() {
                    let slope = Expr::Sub(go(&g.lhs)?, go(&g.rhs)?);
                    let edge = [equal(&slope, &slope), equal(&g.lhs, &g.rhs)];
                    out.push(([&guards[..i], &edge].concat(), pole.clone()));
                }
                out.push((guards.clone(), *go(body)?));
            }
            Expr::Cases(out, otherwise.as_deref().map(go).transpose()?)
        }
    })
}
