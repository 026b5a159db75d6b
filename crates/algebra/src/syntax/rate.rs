//! The derivative of an expression by the variable of the functions in it: the chain rule.

use kane_kernel::Expr;

use super::angle::{negative, product, sum};
use super::error::SyntaxErrorKind;
use super::exponential::slope_of;
use super::monomial::Monomial;
use super::scope::{Angle, Scope};

/// d f / d t = Σ ∂f/∂u · u′ over the functions u of t in f; 0 if there are none. Exact.
///
/// Where all parts have a value f is one differentiable expression in the u near the point, so the
/// chain rule holds there.
///
/// # Errors
/// When a u′ has no symbol ([`SyntaxErrorKind::NoRate`]), when t stands in f beside functions of it
/// ([`SyntaxErrorKind::Explicit`]), or an angle by itself ([`SyntaxErrorKind::AngleAlone`]).
pub fn rate(f: &Expr, t: usize, scope: &Scope) -> Result<Expr, SyntaxErrorKind> {
    let name = |v: usize| scope.context().vars.get(v).map_or("?", |var| &var.name).to_owned();
    let known = |u: usize| scope.rate(u).ok_or_else(|| SyntaxErrorKind::NoRate(name(u)));
    // a symbol that is differentiated itself, an angle too; cosine and sine go by the chain rule
    if let Expr::Var(u) = f
        && *u != t
        && scope.angle_at(*u).is_none()
        && scope.exponential_at(*u).is_none()
    {
        return Ok(if scope.varies_with(f, t) { Expr::Var(known(*u)?) } else { Expr::int(0) });
    }
    let symbols = scope.symbols(f);
    if let Some(angle) = symbols.iter().find(|v| scope.is_unmeasured(**v)) {
        return Err(SyntaxErrorKind::AngleAlone(name(*angle)));
    }
    // an exponential that is none of a function tells not that it varies with t
    let mut fixed = scope.exponentials().filter(|e| {
        let of = scope.context().vars.get(e.symbol).and_then(|var| var.of);
        symbols.contains(&e.symbol) && of.is_none() && e.of.contains(t)
    });
    if symbols.contains(&t) || fixed.next().is_some() {
        return Err(SyntaxErrorKind::Explicit(name(t)));
    }
    let mut total = Expr::int(0);
    for u in symbols.into_iter().filter(|u| scope.varies_with(&Expr::Var(*u), t)) {
        let slope = match scope.angle_at(u) {
            // (cos φ)′ = −sin φ · φ′ and (sin φ)′ = cos φ · φ′, with φ one of the parts of θ
            Some((theta, Angle { cos, sin, parts })) => {
                let slope = if u == cos { negative(Expr::Var(sin)) } else { Expr::Var(cos) };
                let slope = match theta == t {
                    true => slope,
                    false => product(slope, Expr::Var(known(theta)?)),
                };
                let parts = Expr::int(parts.into());
                if parts == Expr::int(1) { slope } else { Expr::Div(slope.into(), parts.into()) }
            }
            None => match scope.exponential_at(u) {
                Some(e) => slope_of(e, rate_of_product(&e.of, t, scope, known)?),
                None => Expr::Var(known(u)?),
            },
        };
        total = sum(total, product(Expr::Deriv(f.clone().into(), u), slope));
    }
    Ok(total)
}

/// d u / d t of a product u in which t and functions of it may stand. Exact.
fn rate_of_product(
    of: &Monomial,
    t: usize,
    scope: &Scope,
    known: impl Fn(usize) -> Result<usize, SyntaxErrorKind>,
) -> Result<Expr, SyntaxErrorKind> {
    let mut total = Expr::int(0);
    for v in of.symbols().filter(|v| scope.varies_with(&Expr::Var(*v), t)) {
        let slope = of.slope(v);
        let slope = if v == t { slope } else { product(slope, Expr::Var(known(v)?)) };
        total = sum(total, slope);
    }
    Ok(total)
}
