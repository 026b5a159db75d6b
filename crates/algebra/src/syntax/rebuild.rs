//! Expressions with parts replaced.

use std::rc::Rc;

use kane_kernel::{Expr, Relation};

/// The expression with some parts replaced, from the outside in: `replace` says what stands in place
/// of a part, or nothing to go on inside it. What has no such part is shared, not copied.
///
/// # Errors
/// The first one of `replace`.
pub fn rebuild<E>(
    e: &Expr,
    replace: &mut dyn FnMut(&Expr) -> Result<Option<Expr>, E>,
) -> Result<Expr, E> {
    Ok(replaced(e, replace)?.unwrap_or_else(|| e.clone()))
}

/// The expression with parts replaced, if it has such a part.
fn replaced<E>(
    e: &Expr,
    replace: &mut dyn FnMut(&Expr) -> Result<Option<Expr>, E>,
) -> Result<Option<Expr>, E> {
    if let Some(other) = replace(e)? {
        return Ok(Some(other));
    }
    let mut is_other = false;
    let mut part = |e: &Expr| {
        let other = replaced(e, replace)?;
        is_other |= other.is_some();
        Ok(other)
    };
    let mut go = |e: &Rc<Expr>| Ok(part(e)?.map_or_else(|| e.clone(), Rc::new));
    let other = match e {
        Expr::Num(_) | Expr::Var(_) | Expr::Let(_) => return Ok(None),
        Expr::Neg(a) => Expr::Neg(go(a)?),
        Expr::Add(a, b) => Expr::Add(go(a)?, go(b)?),
        Expr::Sub(a, b) => Expr::Sub(go(a)?, go(b)?),
        Expr::Mul(a, b) => Expr::Mul(go(a)?, go(b)?),
        Expr::Div(a, b) => Expr::Div(go(a)?, go(b)?),
        Expr::Pow(a, n) => Expr::Pow(go(a)?, *n),
        Expr::Abs(a) => Expr::Abs(go(a)?),
        Expr::Min(a, b) => Expr::Min(go(a)?, go(b)?),
        Expr::Max(a, b) => Expr::Max(go(a)?, go(b)?),
        Expr::Sqrt(a) => Expr::Sqrt(go(a)?),
        Expr::Deriv(a, x) => Expr::Deriv(go(a)?, *x),
        Expr::Cases(branches, otherwise) => {
            let mut go = |e: &Expr| Ok(part(e)?.unwrap_or_else(|| e.clone()));
            let mut out = Vec::new();
            for (guards, body) in branches {
                let mut all = Vec::new();
                for g in guards {
                    all.push(Relation { lhs: go(&g.lhs)?, rel: g.rel, rhs: go(&g.rhs)? });
                }
                out.push((all, go(body)?));
            }
            Expr::Cases(out, otherwise.as_deref().map(go).transpose()?.map(Rc::new))
        }
    };
    Ok(is_other.then_some(other))
}
