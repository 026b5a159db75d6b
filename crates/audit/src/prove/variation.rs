//! What varies along a germ, and what is left of it when equations determine it.

use std::ops::Range;

use kane_algebra::rational_function::{signed_sum, term};
use kane_algebra::ring::cancelled;
use kane_kernel::{Expr, Fraction, Fuel, Poly, Rejection, Scope, State};
use num_rational::BigRational;
use num_traits::{One, Signed as _, Zero};

use super::elimination::Elimination;

type Q = BigRational;

/// The variables that stand for roots: those after the symbols and before that of a germ.
pub(super) fn roots(scope: &Scope<'_>) -> Range<usize> {
    scope.context.vars.len()..scope.germ()
}

/// Whether a variable may go along a germ in x: functions of x, x itself, and constants that an
/// equation among constants determines.
pub(crate) fn varies(state: &State<'_, '_>, x: usize) -> impl Fn(usize, &Poly) -> bool + use<> {
    let vars = &state.scope.context.vars;
    let of_x: Vec<bool> = (0..vars.len()).map(|v| v == x || vars[v].of == Some(x)).collect();
    move |v, equation| {
        let constant = |w: &usize| of_x.get(*w) == Some(&false);
        of_x.get(v) == Some(&true) || (constant(&v) && equation.vars().iter().all(constant))
    }
}

/// dⁿ·p(v := −e/d) for n the degree of p in v.
pub(super) fn homogeneous(
    p: &Poly,
    v: usize,
    (d, e): (&Poly, &Poly),
    fuel: &Fuel,
) -> Result<Poly, Rejection> {
    let minus_e = e.neg();
    if d.len() == 1 && e.len() == 1 {
        // each coefficient is multiplied by one term, and no sum by it again and again
        let n = p.degree(v);
        let coefficients = (0..).zip(p.coefficients(v)).filter(|(_, c)| !c.is_empty());
        let moved = coefficients.map(|(k, c)| {
            let by = minus_e.pow(k, fuel)?.mul(&d.pow(n - k, fuel)?, fuel)?;
            c.mul(&by, fuel)
        });
        let moved = moved.collect::<Result<Vec<Poly>, Rejection>>()?;
        let terms = moved.iter().flat_map(Poly::terms);
        return Ok(Poly::sum(terms.map(|(m, c)| (m.to_vec(), c.clone()))));
    }
    let (mut sum, mut power) = (Poly::default(), Poly::one());
    for c in p.coefficients(v).iter().rev() {
        sum = sum.mul(&minus_e, fuel)?.add(&c.mul(&power, fuel)?);
        power = power.mul(d, fuel)?;
    }
    Ok(sum)
}

/// A fraction after the eliminations.
pub(crate) fn substituted(
    state: &State<'_, '_>,
    value: &Fraction,
    trail: &[Elimination],
) -> Result<(Poly, Poly), Rejection> {
    let fuel = &state.scope.fuel;
    let (mut num, mut den) = (value.num.clone(), value.den.clone());
    for e in trail {
        let parts = (&e.d, &e.e);
        let (a, b) = (num.degree(e.var), den.degree(e.var));
        if a == 0 && b == 0 {
            continue;
        }
        num = homogeneous(&num, e.var, parts, fuel)?.mul(&e.d.pow(b, fuel)?, fuel)?;
        den = homogeneous(&den, e.var, parts, fuel)?.mul(&e.d.pow(a, fuel)?, fuel)?;
        (num, den) = cancelled(&num, &den);
    }
    Ok(cancelled(&num, &den))
}

/// A polynomial as an expression.
#[must_use]
pub fn expression(p: &Poly) -> Expr {
    expression_in(p, &Expr::Var)
}

/// A polynomial as an expression in what stands for its variables.
fn expression_in(p: &Poly, symbol: &dyn Fn(usize) -> Expr) -> Expr {
    signed_sum(p.terms().map(|(m, c)| (term(m, c, symbol), c.is_negative())))
}

/// num/den as an expression.
pub(crate) fn ratio(num: &Poly, den: &Poly) -> Expr {
    ratio_in((num, den), &Expr::Var)
}

/// num/den as an expression in what stands for its variables.
pub(super) fn ratio_in((num, den): (&Poly, &Poly), symbol: &dyn Fn(usize) -> Expr) -> Expr {
    let written = |p: &Poly| expression_in(p, symbol);
    match (den.as_constant(), num.as_constant()) {
        (Some(c), _) if c.is_one() => written(num),
        (Some(c), Some(n)) => Expr::Num(Q::new(n, c)),
        _ => Expr::Div(written(num).into(), written(den).into()),
    }
}

/// Values for the symbols that the premises determine, from those of the free ones.
pub(crate) fn determined(
    state: &State<'_, '_>,
    (x, constants): (usize, &[usize]),
    mut values: Vec<(usize, Expr)>,
    trail: &[Elimination],
    total: bool,
) -> Option<Vec<(usize, Expr)>> {
    let fuel = &state.scope.fuel;
    // As fractions in x where possible, so that common factors cancel.
    let fraction = |e: &Expr| -> Option<Fraction> {
        match &state.scope.pieces(e).ok()?[..] {
            [one] => one.value.clone(),
            [a, b] => a
                .value
                .clone()
                .or_else(|| b.value.clone())
                .filter(|_| a.value.is_none() || b.value.is_none()),
            _ => None,
        }
    };
    let mut known: Vec<(usize, Option<Fraction>)> =
        values.iter().map(|(v, e)| (*v, fraction(e))).collect();
    let symbols = std::iter::once(&x).chain(constants);
    known.extend(symbols.map(|v| (*v, Some(Fraction::whole(Poly::var(*v))))));
    let value = |p: &Poly, known: &[(usize, Option<Fraction>)]| -> Option<Fraction> {
        let mut sum = Fraction::rational(&Q::zero());
        for (m, c) in p.terms() {
            let mut product = Fraction::rational(&Q::from_integer(c.clone()));
            for (v, n) in m {
                let f = known.iter().find(|k| k.0 == *v)?.1.as_ref()?;
                for _ in 0..*n {
                    product = product.mul(f, fuel).ok()?;
                }
            }
            sum = sum.add(&product, fuel).ok()?;
        }
        Some(sum)
    };
    for e in trail.iter().rev() {
        let exact = value(&e.e, &known).zip(value(&e.d, &known));
        let (expr, f) = match exact {
            Some((n, d)) => {
                if d.num.is_empty() {
                    return None;
                }
                let num = n.num.mul(&d.den, fuel).ok()?.neg();
                let den = n.den.mul(&d.num, fuel).ok()?;
                let (mut num, mut den) = cancelled(&num, &den);
                if den.as_constant().is_some_and(|c| c.is_negative()) {
                    (num, den) = (num.neg(), den.neg());
                }
                let mut value = ratio(&num, &den);
                if total && !den.is_constant() {
                    let pole = kane_kernel::Relation {
                        lhs: expression(&den),
                        rel: kane_kernel::Rel::Eq,
                        rhs: Expr::int(0),
                    };
                    value = Expr::Cases(vec![(vec![pole], Expr::int(0))], Some(value.into()));
                }
                (value, Some(Fraction { num, den }))
            }
            None => {
                let value = |v: usize| values.iter().find(|x| x.0 == v).map(|x| x.1.clone());
                let symbol = |v: usize| value(v).unwrap_or(Expr::Var(v));
                let put = |p: &Poly| expression_in(p, &symbol);
                (Expr::Div(Expr::Neg(put(&e.e).into()).into(), put(&e.d).into()), None)
            }
        };
        values.push((e.var, expr));
        known.push((e.var, f));
    }
    values.sort_by_key(|v| v.0);
    Some(values)
}
