//! The derivative of an explicit expression, as an expression.

use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::{Context, Expr, Fuel, Rejection, Rel, Relation};

/// d f / d x, symbolically; nothing is simplified, so no condition is lost.
///
/// A point where two branches of a `cases` meet is outside the derivative's definedness.
///
/// # Errors
/// [`Rejection::NotExplicit`] if f contains an undefined function of x; [`Rejection::Budget`].
pub fn derivative(c: &Context, f: &Expr, x: usize, fuel: &Fuel) -> Result<Expr, Rejection> {
    diff(c, f, x, fuel, 0)
}

/// Definitions inside definitions, followed at most this deep.
const MAX_DEPTH: usize = 64;

fn diff(c: &Context, f: &Expr, x: usize, fuel: &Fuel, depth: usize) -> Result<Expr, Rejection> {
    fuel.spend(1)?;
    let go = |e: &Expr| diff(c, e, x, fuel, depth);
    let zero = || Expr::Num(BigRational::zero());
    Ok(match f {
        Expr::Num(_) => zero(),
        Expr::Var(v) if *v == x => Expr::Num(BigRational::one()),
        Expr::Var(v) => match c.vars.get(*v).ok_or(Rejection::UnknownSymbol)?.of {
            Some(of) if of == x => return Err(Rejection::NotExplicit),
            _ => zero(),
        },
        Expr::Let(i) => {
            let body = &c.lets.get(*i).ok_or(Rejection::UnknownSymbol)?.body;
            if depth == MAX_DEPTH {
                return Err(Rejection::Budget);
            }
            diff(c, body, x, fuel, depth + 1)?
        }
        Expr::Neg(a) => Expr::Neg(go(a)?.into()),
        Expr::Add(a, b) => Expr::Add(go(a)?.into(), go(b)?.into()),
        Expr::Sub(a, b) => Expr::Sub(go(a)?.into(), go(b)?.into()),
        Expr::Mul(a, b) => Expr::Add(
            Expr::Mul(go(a)?.into(), b.clone()).into(),
            Expr::Mul(a.clone(), go(b)?.into()).into(),
        ),
        Expr::Div(a, b) => Expr::Div(
            Expr::Sub(
                Expr::Mul(go(a)?.into(), b.clone()).into(),
                Expr::Mul(a.clone(), go(b)?.into()).into(),
            )
            .into(),
            Expr::Pow(b.clone(), 2).into(),
        ),
        Expr::Pow(_, 0) => zero(),
        Expr::Pow(a, n) => Expr::Mul(
            Expr::Mul(
                Expr::int(i64::from(*n)).into(),
                Expr::Pow(a.clone(), n.checked_sub(1).ok_or(Rejection::Budget)?).into(),
            )
            .into(),
            go(a)?.into(),
        ),
        Expr::Sqrt(a) => {
            Expr::Div(go(a)?.into(), Expr::Mul(Expr::int(2).into(), f.clone().into()).into())
        }
        Expr::Abs(a) => {
            let negative = vec![compare(a, Rel::Lt, &zero())];
            let positive = Expr::Cases(vec![(negative, Expr::Neg(a.clone()))], Some(a.clone()));
            go(&positive)?
        }
        Expr::Min(a, b) => {
            let less = vec![compare(a, Rel::Le, b)];
            go(&Expr::Cases(vec![(less, (**a).clone())], Some(b.clone())))?
        }
        Expr::Max(a, b) => {
            let more = vec![compare(a, Rel::Ge, b)];
            go(&Expr::Cases(vec![(more, (**a).clone())], Some(b.clone())))?
        }
        Expr::Deriv(g, y) => go(&diff(c, g, *y, fuel, depth)?)?,
        Expr::Cases(branches, otherwise) => {
            let mut out = Vec::new();
            for (guards, body) in branches {
                // Where a guard is on the edge, the branches meet: undefined.
                for (i, g) in guards.iter().enumerate() {
                    let edge = compare(&g.lhs, Rel::Eq, &g.rhs);
                    let mut reached = guards[..i].to_vec();
                    reached.push(edge);
                    let pole = Expr::Div(Expr::int(1).into(), zero().into());
                    out.push((reached, pole));
                }
                out.push((guards.clone(), go(body)?));
            }
            let last = match otherwise {
                Some(body) => Some(Box::new(go(body)?)),
                None => None,
            };
            Expr::Cases(out, last)
        }
    })
}

fn compare(lhs: &Expr, rel: Rel, rhs: &Expr) -> Relation {
    Relation { lhs: lhs.clone(), rel, rhs: rhs.clone() }
}
